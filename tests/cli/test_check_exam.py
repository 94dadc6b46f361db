"""`solve check exam.yaml answers/`: each student against the own variant, grades, and files that cannot be read."""

import csv
import io
import json
import os
import re

import pytest

import solver
from solver.papers.generator import hashed
from tests.papers.conftest import FAMILY
from tests.papers.exams import EXAM, write_exam

CLASS = EXAM.replace("count: 2", "students: class.csv")


@pytest.fixture(scope="module")
def gains():
    """The right gains of the first question in the first two variants."""
    drawn = solver.variants(FAMILY, count=2, seed=hashed(2026, 1))
    return [str(each.solve().answers["f"]["K"].tolist()[0]) for each in drawn]


def answers(head, gain, verdict="asymptotically stable"):
    return f"""\
{head}
answers:
  1: {{f: {{K: {gain}}}}}
  2:
    a: {{verdict: {verdict}}}
    b: {{poles: [-4], zeros: []}}
  3: {{c: {{eigenvalues: [-1, -2]}}}}
"""


@pytest.fixture
def hand_in(tmp_path):
    """Write an exam and answer files in a folder."""

    def of(files, exam=EXAM):
        write_exam(tmp_path, exam)
        (tmp_path / "class.csv").write_text("student\nAnna\n=Ben\nCleo\n", encoding="utf-8")
        (tmp_path / "in").mkdir()
        for name, text in files.items():
            (tmp_path / "in" / name).write_text(text, encoding="utf-8")

    return of


def table(path):
    return list(csv.DictReader(io.StringIO(path.read_text(encoding="utf-8"))))


def test_each_is_marked_against_the_own_variant_with_the_marks_of_the_exam(solve, hand_in, gains, tmp_path):
    hand_in({
        "anna.yaml": answers("student: Anna\nvariant: 1", gains[0]),
        "ben.yaml": answers("student: Ben\nvariant: 2", gains[0], "unstable"),
        "cleo.yaml": answers("student: Cleo\nvariant: 2", gains[1]),
    })  # fmt: skip
    done = solve("check", "exam.yaml", "in", "--csv", "grades.csv", "--jobs", 1)
    assert done.code == 1
    anna, ben, cleo = table(tmp_path / "grades.csv")
    assert list(anna) == [
        "file", "student", "variant", "1.f", "1", "2.a", "2.b", "2", "3.a", "3.b", "3.c", "3",
        "total", "out of", "needs review",
    ]  # fmt: skip
    assert [anna[name] for name in ("1", "2", "3", "total", "out of")] == ["10", "20", "6.66", "36.66", "50"]
    assert cleo["1"] == "10"
    assert float(ben["1"]) < 10
    assert ben["2"] == "13.33"
    assert "in/ben.yaml, variant 2 (Ben):" in done.out
    assert "2.a  Stability: 0 of 6.67" in done.out
    assert "marked 3 of 3 files" in done.err


def test_a_student_of_a_class_needs_no_variant_and_no_file_is_lost(solve, hand_in, gains, tmp_path):
    hand_in(
        {
            "anna.yaml": answers("student: anna", gains[0]),
            "ben.yaml": answers("student: =Ben\nvariant: 1", gains[0]),
            "bad.yaml": "answers: [",
            "who.yaml": answers("student: Zoe", gains[0]),
            "photo.jpg": "no answers",
        },
        CLASS,
    )
    done = solve("check", "exam.yaml", "in", "--csv", "grades.csv", "-f", "json", "--jobs", 1)
    assert done.code == 2
    assert "in/ben.yaml:2:10: error: =Ben has variant 2, not 1" in done.err
    assert "in/who.yaml:1:10: error: 'Zoe' is no student of this class" in done.err
    assert "in/bad.yaml:" in done.err
    assert "not readable: in/bad.yaml\nvariant does not fit: in/ben.yaml\nunknown student: in/who.yaml\n" in done.err
    assert "in/photo.jpg" in done.err
    assert "no file of: Cleo\n" in done.err
    data = json.loads(done.out)
    assert [(each["file"], each["student"], "error" in each) for each in data] == [
        ("in/anna.yaml", "Anna", False),
        ("in/bad.yaml", "", True),
        ("in/ben.yaml", "=Ben", True),
        ("in/who.yaml", "Zoe", True),
    ]
    assert data[0]["parts"][0]["id"] == "1.f"
    rows = table(tmp_path / "grades.csv")
    assert [(row["file"], row["student"], row["total"]) for row in rows] == [
        ("in/anna.yaml", "Anna", "36.66"),
        ("in/bad.yaml", "", "not readable"),
        ("in/ben.yaml", "'=Ben", "variant does not fit"),
        ("in/who.yaml", "Zoe", "unknown student"),
        ("", "Cleo", "no file"),
    ]


def test_the_file_to_fill_in_finds_its_exam_and_variant(solve, hand_in, gains, tmp_path):
    hand_in({}, EXAM)
    assert solve("exam", "exam.yaml", "-o", "build", "--jobs", 1).code == 0
    sheet = tmp_path / "build" / "answers" / "answers-2.yaml"
    text = sheet.read_text(encoding="utf-8")
    assert "      K:  #" in text
    sheet.write_text(text.replace("      K:  #", f"      K: {gains[1]}  #"), encoding="utf-8")
    done = solve("check", "build/answers/answers-2.yaml", "--jobs", 1)
    assert done.code == 0
    assert "variant 2: 10 of 50" in done.out


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            "student: A\nanswers: {1: {f: {K: [1, 2]}}}\n",
            "in/a.yaml:1:1: error: it does not say which of the 2",
        ),
        ("variant: 3\nanswers: {1: {}}\n", "in/a.yaml:1:10: error: variant must be a whole number"),
        ("variant: 1\nanswers: {9: {f: {K: 1}}}\n", "in/a.yaml:2:11: error: the exam has no question '9'"),
        ("variant: 1\nanswers: 5\n", "in/a.yaml:2:10: error: 'answers:' must list the questions"),
    ],
)
def test_what_is_wrong_with_a_file_is_said_at_its_place(solve, hand_in, text, said):
    hand_in({"a.yaml": text})
    done = solve("check", "exam.yaml", "in")
    assert done.code == 2
    assert said in done.err
    assert "marked 0 of 1 files" in done.err


def test_what_is_strange_costs_nothing_but_itself(solve, hand_in, gains):
    text = answers("variant: 1\nmood: good", gains[0]) + "  4: {a: {K: 1}}\n"
    hand_in({"a.yaml": text.replace("  3: {c:", "  3: {z: {K: 1}, c:")})
    done = solve("check", "exam.yaml", "in", "-f", "json", "--jobs", 1)
    (data,) = json.loads(done.out)
    assert data["marks"] == 36.66
    assert data["needs_review"]
    assert len(data["remarks"]) == 3


def test_one_that_is_at_fault_itself_is_told(solve, hand_in):
    hand_in({"a.yaml": "variant: 1\nanswers: {1: {f: {K: 1}}}\n"}, EXAM.replace("seed: 2026", "seed: x"))
    done = solve("check", "exam.yaml", "in")
    assert done.code == 2
    assert "exam.yaml:15:7: error: seed must be a whole number" in done.err


def test_the_report_is_written_beside_the_grades(solve, hand_in, gains, tmp_path):
    files = {f"{n}.yaml": answers(f"student: S{n}\nvariant: {1 + n % 2}", gains[0]) for n in range(4)}
    hand_in({**files, "bad.yaml": "answers: ["})
    done = solve("check", "exam.yaml", "in", "--report", "report.html", "--jobs", 1)
    assert done.code == 2
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "Final &lt;exam&gt;" in page
    assert "Not readable: in/bad.yaml" in page
    foreign = page.split('id="foreign"')[1].split("</table>")[0]
    assert "<td>1.f.K</td><td>1</td><td>2: S1, S3</td>" in foreign


def test_folders_below_are_named_and_read_by_a_pattern_links_apart(solve, tmp_path):
    find = "{a: {task: eigenstructure, answers: [eigenvalues]}}"
    asked = f"{{system: {{matrix: [[1, 2], [0, 3]]}}, find: {find}}}"
    (tmp_path / "exam.yaml").write_text(f"exam: E\nquestions: [{{marks: 2, problem: {asked}}}]\n", encoding="utf-8")
    for folder in ("in", "in/Anna", "in/Ben", "elsewhere"):
        (tmp_path / folder).mkdir()
        text = "answers: {1: {a: {eigenvalues: [1, 3]}}}\n"
        (tmp_path / folder / "answers.yaml").write_text(text, encoding="utf-8")
    (tmp_path / "in" / "link").symlink_to(tmp_path / "elsewhere")
    os.mkfifo(tmp_path / "in" / "pipe.yaml")
    (tmp_path / "in" / "Ben" / "\x1b[2J\n.yaml").write_text(text, encoding="utf-8")
    done = solve("check", "exam.yaml", "in", "--jobs", 1)
    assert "marked 1 of 1 files" in done.err
    assert "For those of its folders: 'in/*/*.yaml'" in done.err
    assert "by their names: in/Anna/, in/Ben/, in/link/, in/pipe.yaml\n" in done.err
    done = solve("check", "exam.yaml", "in/*/*.yaml", "--jobs", 1)
    assert [line.split(",")[0] for line in done.out.splitlines() if ", variant 1" in line] == [
        "in/Anna/answers.yaml",
        "in/Ben/answers.yaml",
    ]
    assert "passed over, links: in/link\n" in done.err
    assert "passed over, give it another name: in/Ben/\\x1b[2J\\n.yaml\n" in done.err


def test_a_report_is_about_an_exam(solve, good, tmp_path):
    (tmp_path / "a.yaml").write_text("answers: {a: {}}\n", encoding="utf-8")
    done = solve("check", good, "a.yaml", "--report", "report.html")
    assert done.code == 2
    assert "--report is about an exam" in done.err


def test_sheets_to_hand_back_are_written_for_all_that_can_be_read(solve, hand_in, gains, tmp_path):
    hand_in({
        "anna.yaml": answers("student: <i>Anna</i>\nvariant: 1", gains[0], "unstable"),
        "bad.yaml": "answers: [",
    })  # fmt: skip
    done = solve("check", "exam.yaml", "in", "-f", "html", "-o", "sheets/", "--answers", "--jobs", 1)
    assert done.code == 2
    assert [path.name for path in (tmp_path / "sheets").glob("*.html")] == ["anna.marked.html"]
    page = (tmp_path / "sheets" / "anna.marked.html").read_text(encoding="utf-8")
    assert "Marked answers of &lt;i&gt;Anna&lt;/i&gt;, Variant 1" in page
    assert page.count('<section class="exam-question"') == 3
    assert "of 50 marks" in page
    assert "The right value:" in page
    names = re.findall(r'\bid="([^"]*)"', page)
    assert len(names) == len(set(names))


def test_how_the_values_are_read_is_told_without_marks(solve, hand_in, gains):
    text = answers("student: Anna\nvariant: 1", "[[1, 2x")
    hand_in({"a.yaml": text.replace("[[1, 2x}}", "'[1, 1/2'}}"), "b.yaml": "answers: ["})
    done = solve("check", "exam.yaml", "in", "--syntax", "--jobs", 1)
    assert done.code == 2
    assert "in/a.yaml, Variant 1 (Anna)" in done.out
    assert "  2.b.poles (a list): [-4]\n    read as −4" in done.out
    assert "1.f.K" in done.out
    assert "marks" not in done.out
    data = json.loads(solve("check", "exam.yaml", "in", "--syntax", "-f", "json", "--jobs", 1).out)
    assert [(each["file"], "error" in each) for each in data] == [("in/a.yaml", False), ("in/b.yaml", True)]
    assert [each["part"] for each in data[0]["values"]] == ["1.f", "2.a", "2.b", "2.b", "3.c"]


CHANGES = """\
changes:
  Anna:
    comment: Come and see me.
    2.a: {verdict: {verdict: correct, marks: 4, comment: As in the lecture.}}
    3.c: {comment: Well done.}
"""


@pytest.mark.parametrize("named", ["Anna", "anna.yaml", "anna"])
def test_an_instructor_changes_the_marks_of_an_exam(solve, hand_in, gains, tmp_path, named):
    hand_in({
        "anna.yaml": answers("student: Anna\nvariant: 1", gains[0], "unstable"),
        "changes.yaml": CHANGES.replace("Anna", named),
    })  # fmt: skip
    told = ("--override", "in/changes.yaml", "--csv", "grades.csv", "--jobs", 1)
    done = solve("check", "exam.yaml", "in", "-f", "html", "-o", "sheets/", "--report", "r.html", *told)
    assert done.code == 0, done.err  # nothing is wrong any more
    (row,) = table(tmp_path / "grades.csv")
    assert [row[name] for name in ("1.f", "2.a", "2.b", "2", "3.c", "total")] == [
        "10", "4", "13.33", "17.33", "6.66", "33.99",
    ]  # fmt: skip
    assert "passed over" not in done.err
    page = (tmp_path / "sheets" / "anna.marked.html").read_text(encoding="utf-8")
    for words in ("Come and see me.", "As in the lecture.", "Well done.", "by the instructor"):
        assert words in page


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("  2.a:", "  2.z:", "ch.yaml:4:5: error: the exam has no part '2.z'"),
        ("  2.a:", "  a:", "ch.yaml:4:5: error: the exam has no part 'a'"),
        ("{verdict: {", "{vredict: {", "ch.yaml:4:11: error: stability has no answer 'vredict'"),
        ("marks: 4", "marks: 9", "ch.yaml:4:46: error: verdict carries 6.67 marks, no more"),
        ("Anna", "Zoe", "ch.yaml:2:3: error: no answer file is of 'Zoe'"),
        ("marks: 4", "marks: -4", "ch.yaml:4:46: error: marks are a number such as 2.5"),
    ],
)
def test_what_is_wrong_with_changes_is_said_at_its_place(solve, hand_in, gains, tmp_path, old, new, said):
    hand_in({"anna.yaml": answers("student: Anna\nvariant: 1", gains[0], "unstable")})
    (tmp_path / "ch.yaml").write_text(CHANGES.replace(old, new, 1), encoding="utf-8")
    done = solve("check", "exam.yaml", "in", "--override", "ch.yaml", "--jobs", 1)
    assert done.code == 2
    assert said in done.err


def test_the_worked_solution_of_the_own_variant_stands_on_the_sheet(solve, hand_in, gains, tmp_path):
    hand_in({
        "anna.yaml": answers("student: Anna\nvariant: 1", gains[1]),
        "ben.yaml": answers("student: Ben\nvariant: 2", gains[0]),
    })  # fmt: skip
    done = solve("check", "exam.yaml", "in", "-f", "html", "-o", "sheets/", "--solution", "--jobs", 1)
    assert done.code == 1, done.err
    pages = [(tmp_path / "sheets" / f"{name}.marked.html").read_text("utf-8") for name in ("anna", "ben")]
    for page, gain in zip(pages, gains, strict=True):
        first, *_ = page.split('id="question-1-solution"')[1].split('<section class="exam-question"')
        entries = re.findall(r"-?\d+", gain)
        assert 'class="step"' in first
        shown = re.sub(r"<[^>]*>| ", "", first.split('class="answer')[1]).replace("−", "-")
        assert all(entry in shown for entry in entries)
        assert page.count("Worked solution") == 3
        names = re.findall(r'\bid="([^"]*)"', page)
        assert len(names) == len(set(names))
        assert set(re.findall(r'href="#([^"]*)"', page)) <= set(names)


def test_the_layouts_of_sheets_and_reports_can_be_replaced(solve, hand_in, gains, tmp_path):
    hand_in({"anna.yaml": answers("student: A<b>\nvariant: 1", gains[0])})
    (tmp_path / "own" / "html").mkdir(parents=True)
    for name, text in (
        ("exam-sheet", "{{ marking.student }}: {{ number(marking.marks) }}"),
        ("report", "{{ marked }}"),
    ):
        (tmp_path / "own" / "html" / f"{name}.html.jinja").write_text(text, "utf-8")
    told = ("-f", "html", "-o", "sheets/", "--report", "r.html", "--templates", "own", "--jobs", 1)
    assert solve("check", "exam.yaml", "in", *told).code == 0
    assert (tmp_path / "sheets" / "anna.marked.html").read_text("utf-8") == "A&lt;b&gt;: 36.66"
    assert (tmp_path / "r.html").read_text("utf-8") == "1"


def test_a_rerun_with_a_mended_file_writes_its_sheet_only(solve, hand_in, gains, tmp_path):
    good = answers("student: Anna\nvariant: 1", gains[0])
    hand_in({"anna.yaml": good, "ben.yaml": "student: Ben\nanswers: {1: {f: {K: [1, 2]}"})
    words = ("check", "exam.yaml", "in", "-f", "html", "-o", "sheets/", "--jobs", 1)
    assert solve(*words).code == 2
    kept = (tmp_path / "sheets" / "anna.marked.html").stat().st_mtime_ns
    (tmp_path / "in" / "ben.yaml").write_text(answers("student: Ben\nvariant: 2", gains[1]), encoding="utf-8")
    assert solve(*words).code == 0
    assert {path.name for path in (tmp_path / "sheets").glob("*.html")} == {"anna.marked.html", "ben.marked.html"}
    assert (tmp_path / "sheets" / "anna.marked.html").stat().st_mtime_ns == kept
    (tmp_path / "in" / "anna.yaml").write_text(good.replace(gains[0], "[1, 1]"), encoding="utf-8")
    assert solve(*words).code == 1
    assert (tmp_path / "sheets" / "anna.marked.html").stat().st_mtime_ns > kept


def test_sheets_and_marks_are_the_same_for_every_number_of_jobs(solve, hand_in, gains, tmp_path):
    files = {f"{n}.yaml": answers(f"variant: {n % 2 + 1}", gains[n // 2]) for n in range(4)}
    hand_in(files)
    found = []
    for jobs in (1, 3):
        done = solve("check", "exam.yaml", "in", "--csv", "grades.csv", "-f", "html", "--solution", "--report",
                     "report.html", "-o", "out/", "--jobs", jobs)  # fmt: skip
        written = [tmp_path / "grades.csv", tmp_path / "report.html", *sorted((tmp_path / "out").glob("*.html"))]
        found.append((done, {path.name: path.read_bytes() for path in written}))
    assert found[0] == found[1]
    assert len(found[0][1]) == 6
