"""What is told of the marks of a class: facility, separation, mistakes, equal answers."""

import re
from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.classroom import Marking
from solver.classroom.verdicts import AnswerVerdict, PartVerdict, Verdict
from solver.messages import Messages
from solver.papers.exam.grades import Graded
from solver.papers.exam.reading import read_exam
from solver.papers.exam.report import report_page
from solver.papers.exam.statistics import statistics_of
from solver.papers.exam.wrong import equal_values
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


def test_whole_classes_agree_with_numpy(exam):
    """The corrected item-total correlation, point-biserial where all have all marks or none, by another way."""

    @given(st.lists(st.tuples(st.sampled_from([0, 10]), st.integers(0, 40)), min_size=5, max_size=40))
    def of(class_):
        marks = [(first, Fraction(second, 4)) for first, second in class_]
        told = statistics_of(exam, [graded(f"s{i}", each) for i, each in enumerate(marks)], {})
        matrix = np.array(marks, dtype=float)
        assert told.mean == pytest.approx(matrix.sum(axis=1).mean())
        assert told.deviation == pytest.approx(matrix.sum(axis=1).std())
        assert told.median == pytest.approx(np.median(matrix.sum(axis=1)))
        for place, item in enumerate(told.items):
            own, rest = matrix[:, place], matrix.sum(axis=1) - matrix[:, place]
            assert item.facility == pytest.approx(own.mean() / 10)
            if own.std() == 0 or rest.std() == 0:
                assert item.separation is None
                continue
            assert item.separation == pytest.approx(np.corrcoef(own, rest)[0, 1], abs=0.00501)
        right, rest = matrix[:, 0] == 10, matrix[:, 1]
        if told.items[0].separation is not None:
            apart = (rest[right].mean() - rest[~right].mean()) / rest.std() * np.sqrt(right.mean() * (~right).mean())
            assert told.items[0].separation == pytest.approx(apart, abs=0.00501)

    of()


def answered(student, variant=1, **values):
    """Return a paper with wrong values by the parts `q1`, `q2`, and what goes with them."""
    parts = []
    for n in (1, 2):
        value, facts = values.get(f"q{n}"), values.get(f"with{n}", {})
        answer = AnswerVerdict("eigenvalues", Verdict.WRONG, value, "", typed=str(value), **facts)
        told = {} if value is None else {"eigenvalues": answer}
        parts.append(PartVerdict(f"{n}.a", "eigenstructure", told, Fraction(0), Fraction(10)))
    return Graded(f"{student}.yaml", student, variant, Marking(student, tuple(parts)))


def test_students_of_different_variants_may_have_been_asked_the_same(exam):
    one, two, other = object(), object(), object()
    files = [answered("Anna", 1, q1=5, q2=7), answered("Ben", 2, q1=5, q2=7), answered("Cleo", 3, q1=6, q2=None)]
    solutions = {1: [one, two], 2: [one, other], 3: [one, two]}
    told = equal_values(exam, [(each, each.marking) for each in files], solutions)
    assert [(each.answer, each.students, each.wrong, each.asked) for each in told] == [
        ("1.a.eigenvalues", ("Anna", "Ben"), 3, 3)
    ]


def test_what_is_explained_is_not_suspicious(exam):
    usual, followed = {"mistake": "sign"}, {"follows": True}
    files = [answered(name, q1=5, with1=usual, q2=7, with2=followed) for name in ("Anna", "Ben")]
    told = statistics_of(exam, files, {})
    assert (told.equal, told.pairs) == ((), ())
    assert [each.students for each in told.mistakes] == [("Anna", "Ben")]


def test_what_is_explained_is_not_said_to_come_from_another_variant(exam):
    def asked(value):
        return [SimpleNamespace(parts=[SimpleNamespace(id="a", answers={"eigenvalues": value})])] * 2

    files = [answered("Anna", q1=5, with1={"mistake": "sign"}, q2=7), answered("Ben", q1=5, q2=7)]
    told = statistics_of(exam, files, {1: asked(4), 2: asked(5)})
    assert [(each.answer, each.words, each.students) for each in told.foreign] == [("1.a.eigenvalues", "2", ("Ben",))]


def test_pairs_share_two_values_or_more(exam):
    files = [
        answered("Anna", q1=5, q2=7),
        answered("Ben", q1=5, q2=7),
        answered("Cleo", q1=5, q2=8),
        answered("Dan", 2, q1=5, q2=7),
        replace(answered("Anna", q1=5, q2=7), file="again.yaml"),
    ]
    told = statistics_of(exam, files, {})
    assert [(each.students, each.answers, each.both_wrong) for each in told.pairs] == [
        (("Anna", "Ben"), ("1.a.eigenvalues", "2.a.eigenvalues"), 2)
    ]


def test_a_german_report_has_no_english_word(exam):
    files = [answered(name, 1, q1=5, q2=7) for name in ("Xaver", "Yvonne")]
    files += [graded("Zoe", (0, 0), 7, "sign", words="Vorzeichen"), Graded("bad.yaml", fault="x")]
    page = report_page(replace(exam, count=2), files, {}, None, Messages(None, "de"))
    body = re.sub(r"<[^>]*>", " ", page.split("<header", 1)[1])
    words = set(re.findall(r"[A-Za-zäöüÄÖÜß]+", body))
    english = {"of", "the", "Students", "Marks", "Grades", "None", "yes", "no", "file", "Question", "report", "Papers"}
    assert not words & english
    assert {"Trennschärfe", "Gemeinsame", "Lösungsquote"} <= words
    assert '<html lang="de">' in page


def test_the_layouts_of_the_report_and_the_sheet_can_be_replaced(exam, tmp_path):
    (tmp_path / "html").mkdir()
    (tmp_path / "html" / "report.html.jinja").write_text("<p>{{ exam.title }}, {{ statistics.mean }}</p>", "utf-8")
    assert report_page(exam, [graded("a", (1, 2))], {}, tmp_path) == "<p>Test, 3.0</p>"
