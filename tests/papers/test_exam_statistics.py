"""What is told of the marks of a class: facility, separation, mistakes, equal answers."""

from fractions import Fraction

import pytest

from solver.classroom import Marking
from solver.classroom.verdicts import AnswerVerdict, PartVerdict, Verdict
from solver.papers.exam.grades import Graded
from solver.papers.exam.reading import read_exam
from solver.papers.exam.report import report_page
from solver.papers.exam.statistics import statistics_of
from solver.problem.source import Source

EXAM = """\
exam: Test
questions:
  - {marks: 10, problem: {system: {matrix: [[1, 2], [3, 4]]}, find: {a: {task: eigenstructure, marks: 1}}}}
  - {marks: 10, problem: {system: {matrix: [[1, 2], [3, 4]]}, find: {a: {task: eigenstructure, marks: 1}}}}
"""


@pytest.fixture(scope="module")
def exam():
    return read_exam(Source("exam.yaml", EXAM))


def graded(student, marks, value=None, mistake="", words="a sign", variant=1):
    wrong = {} if value is None else {
        "eigenvalues": AnswerVerdict("eigenvalues", Verdict.WRONG, value, words, mistake=mistake, typed=str(value))
    }  # fmt: skip
    parts = [PartVerdict(f"{n}.a", "eigenstructure", wrong if n == 1 else {}, Fraction(each), Fraction(10))
             for n, each in enumerate(marks, 1)]  # fmt: skip
    return Graded(f"{student}.yaml", student, variant, Marking(student, tuple(parts)))


def test_items_tell_facility_and_separation(exam):
    marks = [(10, 9), (8, 8), (6, 4), (4, 5), (2, 0)]
    told = statistics_of(exam, [graded(f"s{i}", each) for i, each in enumerate(marks)], {})
    first, second = told.items
    assert (first.mean, first.facility, first.full, first.none) == (6, 0.6, 1, 0)
    assert (second.mean, second.none) == (5.2, 1)
    assert first.separation == second.separation == 0.93  # numpy.corrcoef gives 0.9317
    assert (told.mean, told.median, told.least, told.most, told.out_of) == (11.2, 10, 2, 19, 20)
    assert [count for *_, count in told.bars] == [0, 1, 0, 0, 1, 1, 0, 0, 1, 1]


def test_nothing_is_said_of_few_papers_or_where_all_are_alike(exam):
    assert statistics_of(exam, [graded("a", (1, 2)), graded("b", (3, 4))], {}).items[0].separation is None
    assert statistics_of(exam, [graded(f"{i}", (5, i)) for i in range(6)], {}).items[0].separation is None
    assert statistics_of(exam, [Graded("x.yaml", fault="bad")], {}) is None


def test_mistakes_come_by_their_number_and_equal_values_by_variant(exam):
    files = [
        graded("Anna", (0, 0), 7, "sign"),
        graded("Ben", (0, 0), 8, "sign"),
        graded("Cleo", (0, 0), 5),
        graded("Dora", (0, 0), 5),
        graded("Emil", (0, 0), 5, variant=2),
        graded("Fay", (0, 0), 9, "factor", "a factor"),
    ]
    told = statistics_of(exam, files, {})
    assert [(each.answer, each.words, each.students) for each in told.mistakes] == [
        ("1.a.eigenvalues", "a sign", ("Anna", "Ben")),
        ("1.a.eigenvalues", "a factor", ("Fay",)),
    ]
    assert [(each.words, each.students) for each in told.equal] == [("5", ("Cleo", "Dora"))]


def test_the_page_tells_all_and_escapes_names(exam):
    page = report_page(exam, [graded("<b>Jo</b>", (10, 0)), Graded("bad.yaml", fault="x")], {})
    assert "&lt;b&gt;Jo&lt;/b&gt;" in page
    assert "<b>Jo" not in page
    assert "Not readable: bad.yaml" in page
