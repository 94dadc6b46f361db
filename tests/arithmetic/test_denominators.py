"""Fractions over a common denominator: the numerator is that of sympy's own sum, and every line holds."""

import pytest
import sympy as sp

from solver.arithmetic.denominators import brought_together
from solver.numeric import check_steps
from solver.render.wording import Wording

TUTOR = Wording(detail="tutor")
z, T = sp.symbols("z T")
PULSES = [sp.S.One * (z - 1) / (z - sp.exp(-1)), sp.S.NegativeOne, 1 / (z - 1)]


def displayed(steps):
    assert [check for check in check_steps(steps) if check.status != "passed"] == []
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


@pytest.mark.parametrize(
    "fractions",
    [PULSES, [sp.S.One, -sp.Rational(1, 3) / (2 * z - 1)], [2 / (z - 1) ** 2, 3 / (z - 1), sp.exp(-T) / (z + T)]],
)
def test_the_numerator_over_the_common_denominator_is_the_sum(fractions):
    (step,) = brought_together(fractions, z)
    assert "Over a common denominator" in displayed([step])
    whole = step.claims["sum" if "sum" in step.claims else "terms"].right
    numerator = whole if isinstance(whole, sp.Expr) else sp.Add(*whole.operands)
    assert sp.cancel(numerator / step.values["common"] - sp.Add(*fractions)) == 0


def test_one_fraction_needs_nothing():
    assert brought_together([1 / (z - 1)], z) == ()
    assert brought_together([sp.S.One, sp.S.One], z) == ()
