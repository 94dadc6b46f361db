"""`solve exam`: papers without answers, keys with marks, files to fill in, the table of variants, and what is wrong."""

import csv
import io
import re

import pytest

import solver
from solver.papers.generator import hashed
from solver.problem.source import Source
from solver.problem.yaml_tree import parse_yaml
from solver.render import pdf
from tests.papers.conftest import FAMILY
from tests.papers.exams import EXAM, PROBLEM, write_exam


def written(folder):
    found = {str(path.relative_to(folder)): path for path in sorted(folder.rglob("*")) if path.is_file()}
    return {name: path.read_bytes() for name, path in found.items() if not name.startswith(".solve")}


def rows_of(folder):
    return list(csv.reader(io.StringIO((folder / "variants.csv").read_text(encoding="utf-8"))))


@pytest.fixture
def exam(tmp_path):
    """An exam in a folder."""
    return write_exam(tmp_path)


def test_papers_keys_and_answer_files_are_written(solve, exam, tmp_path):
    done = solve("exam", exam, "-o", "build", "-f", "html,latex", "--jobs", 1)
    assert done.code == 0, done.err
    assert "3 questions, 2 variants, all verified" in done.out
    files = written(tmp_path / "build")
    told = [f"{kind}-{n}.{end}" for kind in ("key", "paper") for n in (1, 2) for end in ("html", "tex")]
    assert sorted(name.split("/")[-1] for name in files) == sorted(
        [*told, "answers-1.yaml", "answers-2.yaml", "variants.csv"]
    )
    paper, key = (files[f"{kind}s/{kind}-1.html"].decode() for kind in ("paper", "key"))
    for text in (paper, key):
        assert "Final &lt;exam&gt;" in text
        assert "EE &amp; 451" in text
        assert "50 marks" in text
        names = re.findall(r'\bid="([^"]*)"', text)
        assert len(names) == len(set(names))
        assert set(re.findall(r'href="#([^"]*)"', text)) <= set(names)
    assert "6.67 marks" in paper
    assert "Answer <em>all</em>" in paper
    assert 'class="answer' not in paper
    assert 'class="badge' not in paper
    assert key.count('class="answer') == 6
    assert "Answer key" in key
    assert re.search(r'<section class="exam-question new-page" aria-labelledby="question-2-title">', paper)
    tex = files["papers/paper-2.tex"].decode()
    assert r"EE \& 451" in tex
    assert r"\clearpage" in tex
    assert r"\boxed" not in tex
    assert r"\answerbox{" in files["keys/key-2.tex"].decode()


def test_members_are_those_of_the_documented_generator(solve, exam, tmp_path):
    assert solve("exam", exam, "-o", "build", "--jobs", 2).code == 0
    head, *rows = rows_of(tmp_path / "build")
    assert head == ["student", "variant", "1.a", "1.b", "1.p"]
    drawn = solver.variants(FAMILY, count=2, seed=hashed(2026, 1))
    assert rows == [["", str(each.number), *each.values.values()] for each in drawn]


def test_the_same_exam_is_written_in_the_same_bytes(solve, exam, tmp_path):
    for jobs, folder in ((1, "one"), (2, "two")):
        assert solve("exam", exam, "-o", folder, "-f", "html,latex", "--jobs", jobs).code == 0
    assert written(tmp_path / "one") == written(tmp_path / "two")


def test_each_student_has_a_paper(solve, tmp_path):
    text = EXAM.replace("count: 2", "students: class.csv").replace("problem: family", "problem: step")
    write_exam(tmp_path, text)
    (tmp_path / "class.csv").write_text('student,id\n"Doe, <Jo>",1\n=cmd|x,2\n../up,3\nJO DOE,4\ndoe jo,5\n', "utf-8")
    assert solve("exam", "exam.yaml", "-o", "build", "--jobs", 1).code == 0
    files = written(tmp_path / "build")
    labels = ["Doe-Jo", "cmd-x", "up", "JO-DOE", "doe-jo-2"]
    assert {name for name in files if name.startswith("papers/")} == {f"papers/paper-{each}.html" for each in labels}
    assert "Doe, &lt;Jo&gt;" in files["papers/paper-Doe-Jo.html"].decode()
    assert [row[0] for row in rows_of(tmp_path / "build")] == [
        "student", "Doe, <Jo>", "'=cmd|x", "../up", "JO DOE", "doe jo",
    ]  # fmt: skip
    sheet = parse_yaml(Source("a", files["answers/answers-Doe-Jo.yaml"].decode())).plain()
    assert sheet["student"] == "Doe, <Jo>"
    assert (sheet["exam"], sheet["variant"]) == ("../../exam.yaml", "1")
    assert list(sheet["answers"]) == ["1", "2", "3"]
    assert list(sheet["answers"]["2"]["b"]) == ["poles", "zeros"]


def test_the_worked_steps_are_told_with_marks_where_they_are_asked_for(solve, tmp_path):
    write_exam(tmp_path, EXAM.replace("problem: family", "problem: step").replace("count: 2", "count: 1"))
    assert solve("exam", "exam.yaml", "--detail", "full", "--jobs", 1).code == 0
    key = (tmp_path / "exam-papers" / "keys" / "key-1.html").read_text("utf-8")
    assert 'class="checks"' in key
    assert '<p class="marks">6.67 marks</p>' in key
    names = re.findall(r'\bid="([^"]*)"', key)
    assert len(names) == len(set(names))


@pytest.mark.parametrize(
    ("problem", "said"),
    [
        (PROBLEM.replace("stability", "stablity"), "step.yaml:4:13: error: there is no task 'stablity'"),
        (PROBLEM.replace("a: {", "a: {x: 1, "), "step.yaml:4:"),
    ],
)
def test_errors_in_a_question_stand_at_their_place_in_its_file(solve, tmp_path, problem, said):
    write_exam(tmp_path, step=problem)
    done = solve("exam", "exam.yaml", "-o", "build")
    assert done.code == 2
    assert said in done.err
    assert not written(tmp_path / "build")


def test_nothing_is_written_where_a_question_is_not_verified(solve, tmp_path):
    unsolved = "system: {A: [[1, 0], [0, 2]], B: [1, 0]}\nfind: {a: {task: pole_placement, poles: [-1, -2]}}\n"
    write_exam(tmp_path, EXAM.replace("problem: family", "problem: step"), step=unsolved)
    done = solve("exam", "exam.yaml", "-o", "build")
    assert done.code == 1
    assert "exam.yaml:8:15: error: question 1 is unsolved: part a: The mode 2 is uncontrollable" in done.err
    assert "exam.yaml:9:15: error: question 2 is unsolved: part a:" in done.err
    assert not written(tmp_path / "build")


def test_what_a_task_finds_wrong_is_told_where_it_is_asked(solve, tmp_path):
    indefinite = "{system: {A: [[0, 1], [-2, -3]], B: [0, 1]}, find: {a: {task: lqr, Q: [[-1, 0], [0, 1]], R: 1}}}\n"
    (tmp_path / "other.yaml").write_text(indefinite, "utf-8")
    (tmp_path / "exam.yaml").write_text(
        "exam: Asked\nquestions:\n  - problem: other.yaml\n  - problem: other.yaml\n"
        "  - problem:\n      system: {transfer_function: 1/(s+1)}\n      find: {b: {task: response}}\n"
        f"  - problem: {indefinite}",
        "utf-8",
    )
    done = solve("exam", "exam.yaml", "-o", "build", "--jobs", 1)
    assert done.code == 1
    places = re.findall(r"^(\S+): error: (.{15})", done.err, re.MULTILINE)
    response, lqr = "the complete re", "Q must be posit"
    assert places == [("exam.yaml:7:24", response), ("exam.yaml:8:84", lqr), ("other.yaml:1:71", lqr)]
    assert "internal error" not in done.err
    assert not written(tmp_path / "build")


def test_the_limit_that_was_given_is_told_of_all_questions_that_met_it(solve, tmp_path):
    """And not that of a call, which has several parts."""
    write_exam(tmp_path, EXAM.replace("problem: family", "problem: step"))
    done = solve("exam", "exam.yaml", "-o", "build", "--time-limit", "0.0001")
    assert done.code == 1
    for number in (1, 2, 3):
        assert f"question {number} cannot be solved: time limit of 0.0001 s\n" in done.err
    assert not (tmp_path / "build").exists()


@pytest.mark.parametrize("has_other", [False, True])
def test_what_is_kept_of_a_failure_is_told_and_where_nothing_is_kept_no_folder_is_made(solve, tmp_path, has_other):
    other = "  - {problem: step.yaml}\n" if has_other else ""
    exam = f"exam: E\nquestions:\n  - {{problem: family.yaml}}\n{other}"
    write_exam(tmp_path, exam, family=FAMILY.replace("a != 2", "a > 9"))
    done = solve("exam", "exam.yaml", "-o", "build")
    assert done.code == 1
    assert ("; what was solved is kept in build/.solve for the next time" in done.err) == has_other
    assert (tmp_path / "build").exists() == has_other


def test_too_few_members_are_an_error_of_the_family(solve, tmp_path):
    write_exam(tmp_path, EXAM.replace("count: 2", "count: 3"), family=FAMILY.replace("a != 2", "a > 3"))
    few = FAMILY.replace('["a != 2", controllable]', '["a > 3", "b > 1", "p < -3"]')
    write_exam(tmp_path, family=few)
    done = solve("exam", "exam.yaml", "-o", "build")
    assert done.code == 1
    assert "family.yaml:8:8: error: found 1 of 2 members" in done.err
    assert not written(tmp_path / "build")


PAIR = """\
title: Two members
parameters: {p: -2}
vary: {p: {choose: [-2, -3]}}
system: {A: [[0, 1], [-4, 2]], B: [0, 1]}
find: {f: {task: pole_placement, poles: [p, -1]}}
"""
SHARED = "exam: E\nquestions: [{problem: family.yaml}]\nvariants: {students: class.csv}\nseed: 3\n"


def test_students_share_the_members_of_a_small_family_in_turn(solve, tmp_path):
    """Two members for five students: neighbours have different ones, and marking finds the same."""
    write_exam(tmp_path, SHARED, family=PAIR)
    (tmp_path / "class.csv").write_text("Ann\nBen\nCem\nDan\nEva\n", "utf-8")
    done = solve("exam", "exam.yaml", "-o", "build", "--jobs", 1)
    assert done.code == 0, done.err
    assert "question 1: students have its 2 members in turn, as variants.csv tells" in done.err
    drawn = [row[-1] for row in rows_of(tmp_path / "build")[1:]]
    assert drawn == [drawn[0], drawn[1], drawn[0], drawn[1], drawn[0]]
    assert sorted(set(drawn)) == ["-2", "-3"]
    own = PAIR.replace("{p: -2}", f"{{p: {drawn[0]}}}").replace("vary: {p: {choose: [-2, -3]}}\n", "")
    key = solver.solve(own).answers["f"]["K"].tolist()[0]
    for name, expected in (("Eva", 0), ("Dan", 1), ("Ann", 0)):
        (tmp_path / "in.yaml").write_text(f"student: {name}\nanswers: {{1: {{f: {{K: {key}}}}}}}\n", "utf-8")
        assert solve("check", "exam.yaml", "in.yaml", "--jobs", 1).code == expected


@pytest.mark.parametrize("class_", [None, "Ann\nBen\nCem\n"])
def test_members_are_shared_only_in_a_class_and_where_all_were_looked_through(solve, tmp_path, class_):
    text = SHARED if class_ else SHARED.replace("students: class.csv", "count: 3")
    write_exam(tmp_path, text, family=PAIR)
    (tmp_path / "class.csv").write_text(class_ or "", "utf-8")
    done = solve("exam", "exam.yaml", "-o", "build", "--jobs", 1, *(("--draws", 1) if class_ else ()))
    assert done.code == 1
    assert f"found {1 if class_ else 2} of 3 members" in done.err


def test_templates_can_be_replaced(solve, exam, tmp_path):
    (tmp_path / "own" / "html").mkdir(parents=True)
    (tmp_path / "own" / "html" / "exam.html.jinja").write_text("<p>{{ exam.title }}, {{ exam.total }}</p>", "utf-8")
    write_exam(tmp_path, EXAM.replace("problem: family", "problem: step"))
    assert solve("exam", exam, "-o", "build", "--templates", "own", "--jobs", 1).code == 0
    assert (tmp_path / "build/papers/paper-1.html").read_text("utf-8") == "<p>Final &lt;exam&gt;, 50</p>"


def test_a_rerun_keeps_what_students_wrote(solve, tmp_path):
    write_exam(tmp_path, EXAM.replace("problem: family", "problem: step"))
    assert solve("exam", "exam.yaml", "-o", "build", "--jobs", 1).code == 0
    first, second = (tmp_path / "build" / "answers" / f"answers-{n}.yaml" for n in (1, 2))
    filled = first.read_text("utf-8").replace("verdict:", "verdict: unstable", 1)
    first.write_text(filled, "utf-8")
    second.write_text(second.read_text("utf-8").replace("exam:", "# old\nexam:"), "utf-8")
    done = solve("exam", "exam.yaml", "-o", "build", "--jobs", 1, "--language", "de", "-f", "html,latex")
    assert done.code == 0
    assert "kept build/answers/answers-1.yaml: there are answers in it" in done.err
    assert first.read_text("utf-8") == filled
    assert "# old" not in second.read_text("utf-8")
    paper = (tmp_path / "build" / "papers" / "paper-1.html").read_text("utf-8")
    assert '<html lang="de">' in paper
    assert "Variante" in paper


ONE = """\
exam: One question
questions:
  - marks: {marks}
    problem: {{system: {{A: [[0, 1], [-2, -3]], B: [0, 1]}}, find: {{a: stability, b: controllability}}}}
"""


@pytest.mark.parametrize(
    ("marks", "shown"), [("0.5", ["0.5", "0.25", "0.25"]), ("0.01", ["0.01", "0.01", "0"]), ("7", ["7", "3.5", "3.5"])]
)
def test_halves_and_hundredths_are_told_as_they_are(solve, tmp_path, marks, shown):
    (tmp_path / "exam.yaml").write_text(ONE.format(marks=marks), "utf-8")
    done = solve("exam", "exam.yaml", "-o", "build", "--space", "10", "--jobs", 1)
    assert done.code == 0, done.err
    assert "1 question, one paper, all verified" in done.out
    paper = (tmp_path / "build" / "papers" / "paper-1.html").read_text("utf-8")
    told = re.findall(r'<span class="marks">([\d.]+) marks?</span>', paper)
    assert told == shown
    space = [max(20, 10 * float(each)) for each in shown[1:]]
    assert re.findall(r'class="room" style="height: (\d+)mm"', paper) == [f"{each:.0f}" for each in space]


def test_standard_input_is_an_exam_of_the_current_folder(process, tmp_path):
    write_exam(tmp_path, "")
    text = EXAM.replace("problem: family", "problem: step").replace("count: 2", "count: 1")
    done = process("exam", "-", "--jobs", "1", stdin=text.encode())
    assert done.code == 0, done.err
    assert (tmp_path / "solution-papers" / "papers" / "paper-1.html").exists()
    sheet = (tmp_path / "solution-papers" / "answers" / "answers-1.yaml").read_text("utf-8")
    assert "\nexam:" not in sheet
    wrong = process("exam", "-", stdin=text.replace("step.yaml", "stp.yaml").encode())
    assert wrong.code == 2
    assert "<standard input>:8:15: error: 'stp.yaml': there is no such file" in wrong.err


def test_thirty_questions_have_thirty_headings(solve, tmp_path):
    one = "  - problem: {system: {A: [[0, 1], [-2, -3]]}, find: {a: stability}}\n"
    (tmp_path / "exam.yaml").write_text("exam: Many\nquestions:\n" + one * 30, "utf-8")
    assert solve("exam", "exam.yaml", "-o", "build", "-f", "html,latex", "--jobs", 1).code == 0
    key = (tmp_path / "build" / "keys" / "key-1.html").read_text("utf-8")
    assert key.count('<section class="exam-question') == 30
    assert "30 marks" in key


def test_without_an_engine_the_message_says_how_to_print(solve, exam, monkeypatch, tmp_path):
    monkeypatch.setattr(pdf, "_tex", list)
    monkeypatch.setattr(pdf, "_has_typst", lambda: False)
    done = solve("exam", exam, "-o", "build", "-f", "pdf")
    assert done.code == 2
    assert "write HTML (-f html) and print it from a browser" in done.err
    assert not written(tmp_path / "build")


@pytest.mark.parametrize(("formats", "said"), [("latex,html", True), ("html", False)])
def test_a_picture_that_tex_cannot_draw_is_told(solve, tmp_path, formats, said):
    (tmp_path / "cart.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>', "utf-8")
    (tmp_path / "cart.yaml").write_text(
        'statement: "![a cart](cart.svg)"\nsystem: {A: [[0, 1], [-2, -3]]}\nfind: {a: stability}\n', "utf-8"
    )
    (tmp_path / "exam.yaml").write_text("exam: Cart\nquestions:\n  - problem: cart.yaml\n", "utf-8")
    done = solve("exam", "exam.yaml", "-o", "build", "-f", formats, "--jobs", 1)
    assert done.code == 0, done.err
    told = "TeX draws no SVG: it has words in the place of cart.svg (question 1); HTML and typst show it"
    assert (told in done.err) is said


@pytest.mark.usefixtures("typst")
def test_pdfs_are_written_by_the_engine_that_is_named(solve, tmp_path):
    text = EXAM.replace("problem: family", "problem: step").replace("count: 2", "students: class.csv")
    write_exam(tmp_path, text)
    (tmp_path / "class.csv").write_text('"Doe, #Jo $"\n李明\n', "utf-8")
    done = solve("exam", "exam.yaml", "-o", "build", "-f", "pdf", "--pdf-engine", "typst", "--jobs", 1)
    assert done.code == 0, done.err
    assert "the fonts of the PDFs lack letters of 李明; they are named there, and HTML has them" in done.err
    for kind in ("paper", "key"):
        assert b"pdfuaid:part" in (tmp_path / "build" / f"{kind}s" / f"{kind}-Doe-Jo.pdf").read_bytes()
