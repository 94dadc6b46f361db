"""Marks in hundredths add up, and none is farther than a hundredth from what was earned."""

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from solver.classroom.report.hundredths import dealt, marks_that_add_up
from solver.classroom.verdicts import AnswerVerdict, Marking, PartVerdict, Verdict

MARKS = st.fractions(min_value=0, max_value=20, max_denominator=12)


def test_a_third_of_ten_is_dealt_to_the_first():
    assert dealt(Fraction(10), [Fraction(10, 3)] * 3) == [Fraction(334, 100), Fraction(333, 100), Fraction(333, 100)]


@given(st.lists(st.lists(MARKS, max_size=4), max_size=5))
def test_answers_add_up_to_parts_and_parts_to_the_total(shares):
    marking = Marking("", tuple(part(f"p{i}", each) for i, each in enumerate(shares)))
    total, parts, answers = marks_that_add_up(marking)
    assert abs(total - marking.marks) <= Fraction(1, 200)
    assert sum(parts.values()) == total
    for each in marking.parts:
        dealt_out = [answers[each.id, name] for name in each.answers]
        assert sum(dealt_out) == parts[each.id]
        for exact, shown in zip((answer.marks for answer in each.answers.values()), dealt_out, strict=True):
            assert abs(exact - shown) < Fraction(1, 100)


def part(name, shares):
    verdicts = {f"a{i}": AnswerVerdict(f"a{i}", Verdict.WRONG, marks=marks) for i, marks in enumerate(shares)}
    return PartVerdict(name, "lqr", verdicts, sum(shares, Fraction(0)))
