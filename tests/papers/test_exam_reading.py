"""Exam files: what is read, and what is said of those that are wrong."""

import pytest
import sympy as sp

from solver.papers.exam.names import Names, safe_name
from solver.papers.exam.reading import read_exam
from solver.papers.exam.scaling import scaled
from solver.papers.exam.students import read_students
from solver.papers.generator import hashed
from solver.problem.files import load
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.papers.exams import EXAM, PROBLEM, write_exam


@pytest.fixture
def read(tmp_path, monkeypatch):
    """Read an exam of a folder."""
    monkeypatch.chdir(tmp_path)

    def of(text=EXAM, **files):
        return read_exam(load(write_exam(tmp_path, text, **files)))

    return of


def faults(read, text, **files):
    with pytest.raises(InputError) as error:
        read(text, **files)
    return error.value.render()


def test_an_exam_is_read(read):
    exam = read()
    assert (exam.title, exam.course, exam.date, exam.duration) == (
        "Final <exam>",
        "EE & 451",
        "2026-06-12",
        "120 min",
    )
    assert exam.instructions == "Answer *all*, with $K > 0$."
    assert [each.title for each in exam.questions] == ["A family", "Step response", ""]
    assert [each.page_break for each in exam.questions] == [False, True, False]
    assert [each.label for each in exam.variants] == ["1", "2"]
    assert exam.seed_of(exam.questions[1]) == hashed(2026, 2)
    alone = exam.questions[2].source
    assert [part.task for part in read_problem(alone, catalogue()).parts] == [
        "stability",
        "controllability",
        "eigenstructure",
    ]


def test_there_is_one_paper_where_nothing_is_said(read):
    exam = read(EXAM.replace("variants: {count: 2}\nseed: 2026\n", ""))
    assert [(each.number, each.student) for each in exam.variants] == [(1, "")]
    assert exam.seed == 1


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("exam: Final", "exma: Final", "exam.yaml:1:1: error: unknown key 'exma'"),
        ("exam: Final <exam>\n", "", "'exam' is missing\n       = an exam needs the key 'exam:'"),
        ("marks: 10}", "mark: 10}", "exam.yaml:8:28: error: unknown key 'mark'"),
        ("count: 2", "cuont: 2", "did you mean 'count'?"),
        ("count: 2", "count: 0", "exam.yaml:14:19: error: count must be a whole number of at least 1"),
        ("count: 2", "count: 2, students: a.csv", "exam.yaml:14:11: error: either 'count' or 'students'"),
        ("marks: 10}", "marks: -1}", "exam.yaml:8:35: error: marks are a number greater than zero"),
        ("marks: 10}", "marks: many}", "exam.yaml:8:35: error: a number is expected here"),
        ("seed: 2026", "seed: new", "exam.yaml:15:7: error: seed must be a whole number"),
        ("family.yaml", "famly.yaml", "exam.yaml:8:15: error: 'famly.yaml': there is no such file"),
        ("[0, 1], [-2, -3]", "[0, 1], [-2]", "exam.yaml:11:"),
        ("b: controllability", "b: controlability", "did you mean 'controllability'?"),
    ],
)
def test_what_is_wrong_is_said_at_its_place(read, old, new, said):
    assert EXAM.count(old) >= 1
    assert said in faults(read, EXAM.replace(old, new))


def test_what_is_wrong_in_the_file_of_a_question_is_said_there_with_all_else(read):
    text = EXAM.replace("seed: 2026", "seed: x")
    said = faults(read, text, step=PROBLEM.replace("stability", "stablity"), family="title: [1")
    assert "step.yaml:4:13: error: there is no task 'stablity'" in said
    assert "did you mean 'stability'?" in said
    assert "family.yaml:" in said
    assert "exam.yaml:15:7: error: seed" in said


def test_marks_of_a_question_scale_those_of_its_parts(read):
    problem = read_problem(Source("step.yaml", PROBLEM), catalogue())
    a, b = scaled(problem, sp.Integer(20)).parts
    assert (a.marks, b.marks) == (sp.Rational(667, 100), sp.Rational(1333, 100))
    assert sum(b.answer_marks.values()) == b.marks
    three = read().questions[2]
    assert [part.marks for part in scaled(three.problem, three.marks).parts] == [
        sp.Rational(667, 100),
        sp.Rational(667, 100),
        sp.Rational(666, 100),
    ]
    assert [part.marks for part in scaled(three.problem, None).parts] == [1, 1, 1]
    assert [part.marks for part in scaled(problem, None).parts] == [1, 2]


def test_what_a_mistake_costs_scales_too():
    text = PROBLEM.replace("a: {task: stability, marks: 1}", "a: {task: stability, marks: 2, partial: {order: 1}}")
    problem = read_problem(Source("step.yaml", text), catalogue())
    part = scaled(problem, sp.Integer(40)).parts[0]
    assert part.marks == 20
    assert {cost for each in part.partial.values() for cost in (each.costs or {}).values()} <= {10}


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("student,mail\nAnna,a@b\n\nÖzge Ü,c\n", ("Anna", "Özge Ü")),
        ("Anna;1\r\nBen;2\r\n", ("Anna", "Ben")),
        ('Name\tid\n"Doe, J."\t1\n"=cmd|x"\t2\n', ("Doe, J.", "=cmd|x")),
        ('"Doe, ""Jo"""\n', ('Doe, "Jo"',)),
        ("\u0041\u030angstro\u0308m\n", ("Ångström",)),
    ],
)
def test_the_first_column_of_a_class_has_the_students(text, found):
    assert read_students(Source("class.csv", text)) == found


def test_what_is_wrong_with_a_class_is_said_at_its_line(read, tmp_path):
    with pytest.raises(InputError, match=r"class.csv:3:1: error: 'Anna' stands in line 1 already"):
        read_students(Source("class.csv", "Anna\nBen\nAnna \n"))
    with pytest.raises(InputError, match="there is no student"):
        read_students(Source("class.csv", "student\n\n"))
    (tmp_path / "class.csv").write_bytes("Anna\nJ\u00f6rg\n".encode("latin-1"))
    said = faults(read, EXAM.replace("count: 2", "students: class.csv"))
    assert "class.csv:2:2: error: it is not a text in UTF-8" in said


@pytest.mark.parametrize(
    ("student", "name"),
    [
        ("Anna Müller", "Anna-Müller"),
        ("../../etc/passwd", "etc-passwd"),
        ("a/b\\c:d*e?f|g<h>", "a-b-c-d-e-f-g-h"),
        ("=cmd()", "cmd"),
        ("...", "student"),
        ("李明", "李明"),
        ("x" * 300, "x" * 80),
    ],
)
def test_names_of_files_are_safe(student, name):
    assert safe_name(student) == name


def test_names_of_files_differ_in_more_than_capitals():
    names = Names()
    assert [names.of(each) for each in ("Jo", "JO", "jo!", "jo-2")] == ["Jo", "JO-2", "jo-3", "jo-2-2"]
