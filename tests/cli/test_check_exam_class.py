"""A class marked: names that are alike, students of several files, files of whom it is known why they have no marks."""

import csv
import io
import json
import re

import pytest

EXAM = """\
exam: Test
questions:
  - marks: 10
    problem: {system: {matrix: [[1, 2], [0, 4]]}, find: {a: {task: eigenstructure, answers: [eigenvalues]}}}
variants: {students: class.csv}
"""
RIGHT, WRONG = "[1, 4]", "[1, 5]"


def answers(head, values=RIGHT):
    return f"{head}\nanswers: {{1: {{a: {{eigenvalues: {values}}}}}}}\n"


@pytest.fixture
def check(solve, tmp_path):
    """Mark files of a class; return the outcome, the table and the report."""

    def of(files, *words, students=("Anna", "anna", "Ben Ito"), exam=EXAM):
        (tmp_path / "exam.yaml").write_text(exam, encoding="utf-8")
        (tmp_path / "class.csv").write_text("\n".join(["student", *students, ""]), encoding="utf-8")
        (tmp_path / "in").mkdir()
        for name, text in files.items():
            (tmp_path / "in" / name).write_text(text, encoding="utf-8")
        told = ("--csv", "grades.csv", "--report", "report.html", "--jobs", 1)
        done = solve("check", "exam.yaml", "in", *told, *words)
        rows = list(csv.DictReader(io.StringIO((tmp_path / "grades.csv").read_text("utf-8"))))
        return done, rows, (tmp_path / "report.html").read_text("utf-8")

    return of


def lines(rows):
    return [(row["file"].removeprefix("in/"), row["student"], row["total"], row["needs review"]) for row in rows]


def test_names_that_differ_in_capitals_only_are_two_students(check):
    done, rows, _ = check({
        "1.yaml": answers("student: Anna"),
        "2.yaml": answers("student: anna", WRONG),
        "3.yaml": answers("student: ANNA"),
    })  # fmt: skip
    assert "in/3.yaml:1:10: error: 'ANNA' may be Anna or anna" in done.err
    assert lines(rows) == [
        ("1.yaml", "Anna", "10", "no"),
        ("2.yaml", "anna", "5", "no"),
        ("3.yaml", "ANNA", "unclear student", "yes"),
        ("", "Ben Ito", "no file", "yes"),
    ]


def changes(name):
    return f"changes:\n  {name}: {{comment: x, 1.a: {{eigenvalues: {{marks: 7}}}}}}\n"


@pytest.mark.parametrize(
    ("name", "marks"),
    [("Anna", ["7", "5", "5"]), ("anna", ["5", "7", "5"]), ("BEN ITO", ["5", "5", "7"]), ("b.yaml", ["5", "7", "5"])],
)
def test_changes_are_of_the_student_whom_an_answer_file_of_that_name_would_be_of(check, tmp_path, name, marks):
    (tmp_path / "changes.yaml").write_text(changes(name), encoding="utf-8")
    files = {"Anna.yaml": "Anna", "b.yaml": "anna", "c.yaml": "Ben Ito"}
    handed = {name: answers(f"student: {student}", WRONG) for name, student in files.items()}
    done, rows, _ = check(handed, "--override", "changes.yaml")
    assert [row["total"] for row in rows] == marks, done.err


def test_the_name_of_a_student_is_that_of_no_other_ones_file(check, tmp_path):
    (tmp_path / "changes.yaml").write_text(changes("anna"), encoding="utf-8")
    handed = {"anna.yaml": answers("student: Anna", WRONG), "b.yaml": answers("student: anna", WRONG)}
    _, rows, _ = check(handed, "--override", "changes.yaml")
    assert [row["total"] for row in rows[:2]] == ["5", "7"]


def test_changes_of_a_name_that_may_be_several_are_refused(solve, check, tmp_path):
    check({"a.yaml": answers("student: Anna")})
    (tmp_path / "changes.yaml").write_text(changes("ANNA"), encoding="utf-8")
    done = solve("check", "exam.yaml", "in", "--override", "changes.yaml", "--jobs", 1)
    assert done.code == 2
    assert "changes.yaml:2:3: error: 'ANNA' may be Anna or anna" in done.err
    (tmp_path / "changes.yaml").write_text(changes("Ben Ito") + "  ben ito: {comment: y}\n", encoding="utf-8")
    done = solve("check", "exam.yaml", "in", "--override", "changes.yaml", "--jobs", 1)
    assert "changes.yaml:3:3: error: 'ben ito' is changed under another name too" in done.err


def test_students_of_several_files_are_named_and_left_out_of_the_mean(check):
    done, rows, page = check({
        "1.yaml": answers("student: Anna"),
        "2.yaml": answers("student: Anna", WRONG),
        "3.yaml": answers("student: anna", WRONG),
        "4.yaml": answers("student: Ben Ito"),
    })  # fmt: skip
    assert "several files of Anna were marked: in/1.yaml, in/2.yaml" in done.err
    assert [row["needs review"] for row in rows] == ["yes", "yes", "no", "no"]
    first = page.split("To be looked at first")[1].split("</section>")[0]
    assert "Anna (in/1.yaml, in/2.yaml)" in first
    assert "<dt>Papers</dt><dd>2</dd>" in page
    assert "<dt>Mean</dt><dd>7.5 of 10</dd>" in page
    assert page.count("several files</td>") == 2
    equal = page.split('id="equal"')[1].split("</section>")[0]
    assert "2: Anna, anna" in equal
    assert "2 of 3" in equal


def test_the_data_say_who_needs_review_as_the_table_does(check):
    done, rows, _ = check(
        {
            "1.yaml": answers("student: Anna"),
            "2.yaml": answers("student: Anna", WRONG),
            "3.yaml": answers("student: anna", WRONG),
            "4.yaml": "answers: [",
            "5.yaml": "student: Ben Ito\nanswers: {1: {a: {eigenvalues: }}}\n",
            "6.yaml": answers("student: Cleo", "bananas"),
        },
        "-f",
        "json",
        students=("Anna", "anna", "Ben Ito", "Cleo"),
    )
    data = json.loads(done.out)
    assert [each["needs_review"] for each in data] == [True, True, False, True, True, True]
    assert [row["needs review"] == "yes" for row in rows[:6]] == [each["needs_review"] for each in data]
    assert [each.get("status") for each in data] == [None, None, None, "not readable", None, None]


def test_who_handed_in_twice_only_leaves_nothing_to_count(check):
    _, rows, page = check({f"{n}.yaml": answers("student: Anna") for n in range(2)})
    assert len(rows) == 4
    assert "<dt>Mean</dt>" not in page


def test_a_file_without_marks_keeps_its_student_who_has_no_second_line(check):
    done, rows, page = check(
        {
            "1.yaml": answers("student: anna\nvariant: 1"),
            "2.yaml": answers("student: Zoe"),
            "3.yaml": "student: ben ito\nanswers: 5\n",
            "answers-Dora.yaml": "student: Dora\nanswers: [",
            "other.yaml": "student: Dora\nanswers: [",
        },
        "-f",
        "json",
        students=("Anna", "anna", "Ben Ito", "Dora"),
    )
    assert done.code == 2
    assert lines(rows) == [
        ("1.yaml", "anna", "variant does not fit", "yes"),
        ("2.yaml", "Zoe", "unknown student", "yes"),
        ("3.yaml", "Ben Ito", "not readable", "yes"),
        ("answers-Dora.yaml", "Dora", "not readable", "yes"),
        ("other.yaml", "", "not readable", "yes"),
        ("", "Anna", "no file", "yes"),
    ]
    assert [each["student"] for each in json.loads(done.out)] == ["anna", "Zoe", "Ben Ito", "Dora", ""]
    first = re.sub(r"\s+", " ", page.split("To be looked at first")[1].split("</section>")[0])
    assert "<p>Variant does not fit: in/1.yaml</p> <p>Unknown student: in/2.yaml</p>" in first
    assert "<p>Not readable: in/3.yaml, in/answers-Dora.yaml, in/other.yaml</p> <p>No file of: Anna</p>" in first


def test_files_in_which_nothing_is_answered_are_named(check):
    done, rows, page = check({"1.yaml": answers("student: Anna"), "2.yaml": answers("student: anna", "")})
    assert "nothing is answered in: in/2.yaml" in done.err
    assert lines(rows)[1] == ("2.yaml", "anna", "0", "yes")
    assert "Nothing is answered in these, which count with no marks: in/2.yaml" in page
    assert "<dt>Mean</dt><dd>5.0 of 10</dd>" in page


def test_three_faults_of_a_file_are_told(check):
    text = "student: Anna\nanswers: {" + ", ".join(f"{n}: 1" for n in range(3, 10)) + "}\n"
    question = EXAM.split("questions:\n")[1].split("variants:", maxsplit=1)[0]
    done, _, _ = check({"1.yaml": text}, exam=EXAM.replace(question, question * 2))
    assert done.err.count("error:") == 3
    assert "and 4 more" in done.err
