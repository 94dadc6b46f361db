"""What is said of exam files and tables of a class that are wrong: at its place, in the file that is at fault."""

import pytest

from solver.papers.exam.reading import read_exam
from solver.problem.files import load
from solver.problem.source import InputError
from tests.papers.exams import EXAM, write_exam

COUNT = "variants: {count: 2}"
FIRST = "{problem: family.yaml, marks: 10}"
TEXT = "instructions: |\n  Answer *all*, with $K > 0$."
INSIDE = "{a: stability, b: controllability"

FAULTS = [
    ("exam: Final <exam>", "exam: [a, b]", "exam.yaml:1:7: error: a number or a text is expected here, not a list"),
    ("exam: Final <exam>", "exam:", "exam.yaml:1:6: error: a number or a text is expected here, not nothing"),
    ("exam: Final <exam>", "exam: ' '", "exam.yaml:1:7: error: the exam has no title"),
    ("course: EE & 451", "course: {a: 1}", "exam.yaml:2:9: error: a number or a text is expected here, not a mapping"),
    ("course: EE", "curse: EE", "exam.yaml:2:1: error: unknown key 'curse'"),
    ("course: EE", "course: X\ncourse: EE", "exam.yaml:3:1: error: key 'course' is given twice"),
    ("date: 2026-06-12", "date: 2026-02-30", "exam.yaml:3:7: error: there is no 2026-02-30"),
    ("date: 2026-06-12", "date: 2026-13-01", "exam.yaml:3:7: error: there is no 2026-13-01"),
    ("date: 2026-06-12", "date: [2026]", "exam.yaml:3:7: error: a number or a text is expected here"),
    ("duration: 120 min", "duration: {min: 120}", "exam.yaml:4:11: error: a number or a text is expected here"),
    (TEXT, "instructions: [a]", "exam.yaml:5:15: error: a number or a text is expected here, not a list"),
    (TEXT, r"instructions: 'so $\frac{1}$'", r"exam.yaml:5:28: error: in a formula: \frac needs two arguments"),
    (TEXT, "instructions: 'a ![x](no.png)'", "exam.yaml:5:15: error: the instructions of an exam have no images"),
    (FIRST, "family.yaml", "exam.yaml:8:5: error: a mapping (key: value) is expected here, not family.yaml"),
    (FIRST, "{marks: 10}", "exam.yaml:8:5: error: 'problem' is missing here"),
    (FIRST, "{problem: , marks: 1}", "exam.yaml:8:15: error: the name of a problem file, or a problem"),
    (FIRST, "{problem: ., marks: 1}", "exam.yaml:8:15: error: '.': it is a folder, not a file"),
    (FIRST, "{problem: exam.yaml}", "exam.yaml:7:1: error: this is an exam, not a problem"),
    (FIRST, "{problem: class.csv}", "class.csv:1:1: error: a problem is a mapping with the keys 'system' and 'find'"),
    ("marks: 10}", "marks: 0}", "exam.yaml:8:35: error: marks are a number greater than zero, and at most 10000"),
    ("marks: 10}", "marks: 1e9}", "exam.yaml:8:35: error: marks are a number greater than zero, and at most 10000"),
    ("marks: 10}", "marks: 10.555}", "exam.yaml:8:35: error: marks are told in hundredths at most"),
    ("marks: 10}", "marks: 20/3}", "exam.yaml:8:35: error: marks are told in hundredths at most"),
    ("marks: 10}", "marks: }", "exam.yaml:8:35: error: a number or a text is expected here, not nothing"),
    ("marks: 10}", "marks: 1/0}", "exam.yaml:8:37: error: division by zero"),
    ("marks: 10}", "marks: sqrt(2)}", "exam.yaml:8:35: error: a number is expected here, not sqrt(2)"),
    ("marks: 10}", "marks: {a: 1}}", "exam.yaml:8:35: error: a number or a text is expected here, not a mapping"),
    ("marks: 10}", "marks: inf}", "exam.yaml:8:35: error: a finite value is expected here"),
    ("page_break: yes", "page_break: maybe", "exam.yaml:9:49: error: 'maybe' is not known here; it is one of yes, no"),
    ("page_break: yes", "pagebreak: yes", "exam.yaml:9:37: error: unknown key 'pagebreak'"),
    (COUNT, "variants: 2", "exam.yaml:14:11: error: a mapping (key: value) is expected here, not 2"),
    (COUNT, "variants: {}", "exam.yaml:14:11: error: either 'count' or 'students' is expected here"),
    (COUNT, "variants: {count: 2.5}", "exam.yaml:14:19: error: count must be a whole number of at least 1"),
    (COUNT, "variants: {count: 100000}", "exam.yaml:14:19: error: count must be a whole number of at least 1"),
    (COUNT, "variants: {students: clas.csv}", "exam.yaml:14:22: error: 'clas.csv': there is no such file"),
    (COUNT, "variants: {students: [Anna]}", "exam.yaml:14:22: error: a number or a text is expected here, not a list"),
    (COUNT, "variants: {students: exam.yaml}", "exam.yaml:14:22: error: a table (CSV) is expected here"),
    (COUNT, "variants: {students: class.xlsx}", "exam.yaml:14:22: error: this is a spreadsheet: save it as CSV"),
    ("seed: 2026", "seed: 1.5", "exam.yaml:15:7: error: seed must be a whole number, not '1.5'"),
    ("seed: 2026", "seed: 12345678901", "exam.yaml:15:7: error: seed has at most 9 digits"),
    ("seed: 2026", "seed:", "exam.yaml:15:6: error: a number or a text is expected here, not nothing"),
    ("questions:\n", "questions: []\nx:\n", "exam.yaml:7:12: error: this is empty"),
    ("B: [0, 1]}", "B: [0, 1, 2]}", "exam.yaml:11:42: error: B must have 2 rows like A, it has 3"),
    (INSIDE, "{a: stabilty, b: controllability", "exam.yaml:12:17: error: there is no task 'stabilty'"),
]

TABLES = [
    (b"", "class.csv: error: there is no student in the first column"),
    (b"name\n\n", "class.csv: error: there is no student in the first column"),
    (b"name;x\nAnna;1\nBen;2\nAnna;3\n", "class.csv:4:1: error: 'Anna' stands in line 2 already"),
    ("Anna\nJörg\n".encode("latin-1"), "class.csv:2:2: error: it is not a text in UTF-8 (byte 0xf6)"),
    ("Anna\nBen\n".encode("utf-16"), "class.csv:1:1: error: it is not a text in UTF-8 (byte 0xff)"),
    (b'name\n"Anna\nBen\n', "class.csv:2:1: error: it cannot be read as CSV: unexpected end of data"),
    (b"A\0nna\nBen\n", "class.csv:1:1: error: the name 'A�nna' has a character that cannot be seen, U+0000"),
    (
        "Anna\n\u200bBen\n".encode(),
        "class.csv:2:1: error: the name '�Ben' has a character that cannot be seen, U+200B ZERO WIDTH",
    ),
    (b"x" * 300 + b"\n", "class.csv:1:1: error: the name of a student is longer than 200 characters"),
]


@pytest.fixture
def said(tmp_path, monkeypatch):
    """Return what is said of an exam and a table."""
    monkeypatch.chdir(tmp_path)

    def of(text, table=b"Anna\nBen\n"):
        (tmp_path / "class.csv").write_bytes(table)
        with pytest.raises(InputError) as error:
            read_exam(load(write_exam(tmp_path, text)))
        return error.value.render()

    return of


@pytest.mark.parametrize(("old", "new", "fault"), FAULTS)
def test_what_is_wrong_with_an_exam_is_said_at_its_place(said, old, new, fault):
    assert EXAM.count(old) >= 1
    assert fault in said(EXAM.replace(old, new, 1))


@pytest.mark.parametrize(("table", "fault"), TABLES)
def test_what_is_wrong_with_a_class_is_said_at_its_line(said, table, fault):
    assert fault in said(EXAM.replace(COUNT, "variants: {students: class.csv}"), table)


def test_a_name_is_suggested(said):
    assert "did you mean 'course'?" in said(EXAM.replace("course: EE", "curse: EE"))
    assert "did you mean 'class.csv'?" in said(EXAM.replace(COUNT, "variants: {students: clas.csv}"))


def test_all_faults_are_told_at_once_each_in_its_file(said, tmp_path):
    text = EXAM.replace(COUNT, "variants: {students: class.csv}").replace("seed: 2026", "seed: x")
    told = said(text.replace("marks: 10}", "marks: -1}"), b"Anna\nAnna\n")
    for fault in ("exam.yaml:8:35: error: marks", "exam.yaml:15:7: error: seed", "class.csv:2:1: error: 'Anna'"):
        assert fault in told


def test_the_texts_of_the_cover_are_lines(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    exam = read_exam(load(write_exam(tmp_path, EXAM.replace("Final <exam>", '"Final\\n  exam"'))))
    assert exam.title == "Final exam"
