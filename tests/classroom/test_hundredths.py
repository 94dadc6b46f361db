"""Marks in hundredths add up, and none is farther than a hundredth from what was earned."""

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from solver.classroom.report.hundredths import in_hundredths
from solver.classroom.report.words import number
from solver.classroom.verdicts import AnswerVerdict, Marking, PartVerdict, Verdict
from solver.problem.hundredths import dealt

MARKS = st.fractions(min_value=0, max_value=20, max_denominator=12)


def test_a_third_of_ten_is_dealt_to_the_first():
    assert dealt(Fraction(10), [Fraction(10, 3)] * 3) == [Fraction(334, 100), Fraction(333, 100), Fraction(333, 100)]


@given(st.lists(st.lists(MARKS, max_size=4), max_size=5))
def test_answers_add_up_to_parts_and_parts_to_the_total(shares):
    marking = Marking("", tuple(part(f"p{i}", each) for i, each in enumerate(shares)))
    told = in_hundredths(marking)
    assert abs(told.marks - marking.marks) <= Fraction(1, 200)
    for each, exact in zip(told.parts, marking.parts, strict=True):
        assert sum(answer.marks for answer in each.answers.values()) == each.marks
        for name, answer in each.answers.items():
            assert (answer.marks * 100).denominator == 1
            assert abs(answer.marks - exact.answers[name].marks) < Fraction(1, 100)
    assert in_hundredths(told) == told


def test_a_half_of_a_hundredth_is_told_upwards_everywhere():
    told = in_hundredths(Marking("", (part("a", [Fraction(4285, 1000)]),)))
    assert (number(told.marks), number(Fraction(4285, 1000))) == (4.29, 4.29)


def part(name, shares):
    verdicts = {f"a{i}": AnswerVerdict(f"a{i}", Verdict.WRONG, marks=marks) for i, marks in enumerate(shares)}
    return PartVerdict(name, "lqr", verdicts, sum(shares, Fraction(0)))
