"""Both signs of a pair; values at the start; laws with a name that stands for no value are counted."""

import pytest
import sympy as sp

from solver.derivation import CheckStatus
from solver.derivation.displayed import STANDS, Displayed, Written
from tests.displayed.test_planted_errors import MARK, checks_of, eq, text

ROOTS = [-1 + sp.sqrt(2), -1 - sp.sqrt(2)]
FORMULA = r"-1 \pm \sqrt{2}"


def states(*displayed):
    """How the checks of these displays end."""
    return [check.status for check in checks_of(*displayed)]


@pytest.mark.parametrize("roots", [ROOTS, ROOTS[::-1]])
def test_a_pair_has_no_order(roots):
    assert set(states(eq("r_{1,2}", FORMULA, roots), text(FORMULA + " = " + MARK, roots))) == {CheckStatus.PASSED}


@pytest.mark.parametrize(
    "displayed",
    [
        eq("r_{1,2}", r"-1 \pm \sqrt{3}", ROOTS),
        eq("r_{1,2}", r"1 \pm \sqrt{2}", ROOTS),
        eq("r_{1,2}", FORMULA, [ROOTS[0], ROOTS[0]]),
        text(r"-1 \mp \sqrt{3} = " + MARK, ROOTS),
        eq(r"\pm 2", r"\pm 3"),
        eq(r"s^{2}", FORMULA, r"-1 \pm \sqrt{3}"),
    ],
)
def test_a_wrong_pair_is_seen(displayed):
    assert CheckStatus.FAILED in states(displayed)


def test_a_power_of_a_name_is_either_value_of_a_pair():
    assert set(states(eq(r"s^{2}", FORMULA, ROOTS))) == {CheckStatus.PASSED}


def test_a_name_of_a_pair_is_free_afterwards():
    assert CheckStatus.FAILED not in states(eq("r_{1,2}", FORMULA, ROOTS), eq("r_{1,2}", r"\pm 3", [3, -3]))


def test_the_transpose_of_a_value_at_the_start_is_read():
    start = Displayed((Written("x(0)"), sp.ImmutableMatrix([1, 2])), STANDS)
    assert states(start, eq("x(0)^{T}x(0)", sp.Integer(5))) == [CheckStatus.PASSED]
    assert states(start, eq("x(0)^{T}x(0)", sp.Integer(4))) == [CheckStatus.FAILED]


def test_a_law_is_judged_with_what_its_name_stands_for_later():
    assert states(eq("AW", sp.ImmutableMatrix([2, 3])), eq("W", sp.ImmutableMatrix([1, 2])))[-1] is CheckStatus.FAILED
    assert states(eq("AW", sp.ImmutableMatrix([2, -8])), eq("W", sp.ImmutableMatrix([1, 2])))[-1] is CheckStatus.PASSED


def test_a_law_whose_name_stands_for_nothing_is_counted():
    (check,) = checks_of(eq("AW", sp.ImmutableMatrix([2, 3])))
    assert check.status is CheckStatus.SKIPPED
    assert "stands for no value" in str(check.reason)


def test_the_left_side_of_a_differential_equation_stands_for_no_value_and_needs_none():
    assert states(eq(r"\dot{x}", sp.ImmutableMatrix([1, 2]))) == []


def test_the_same_value_is_no_change_of_a_name():
    law, name = eq("AW", sp.ImmutableMatrix([2, 3])), Written("W")
    same = [eq("W", sp.ImmutableMatrix([1, 2])), Displayed((name, sp.ImmutableMatrix([1, 2])), STANDS)]
    assert CheckStatus.FAILED in states(law, *same)
    assert states(law, *same, Displayed((name, sp.ImmutableMatrix([1, 3])), STANDS))[-1] is CheckStatus.SKIPPED
