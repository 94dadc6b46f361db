"""The real zeros of exponential polynomials."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.numeric.evaluation.exponential_zeros import exponential_zeros
from solver.numeric.evaluation.values import NotEvaluable

x = sp.Symbol("x")


@pytest.mark.parametrize(
    ("f", "zeros"),
    [
        (sp.exp(x) - 1, [0]),
        (sp.exp(x) + 1, []),
        (sp.exp(x) - 1 - x, [0]),
        (sp.exp(-x) * (x - 2), [2]),
        (sp.expand((sp.exp(x) - 2) * (sp.exp(x) - 3)), [sp.log(2), sp.log(3)]),
        (sp.expand((x - 1) ** 2 * (sp.exp(2 * x) - 5)), [sp.log(5) / 2, 1]),
        (x * sp.exp(x) - 1, [sp.LambertW(1)]),
        (sp.exp(x / 2) - sp.exp(x / 3) * 4, [6 * sp.log(4)]),
        (sp.exp(x - 1) - sp.E, [2]),
        (x**3 - x, [-1, 0, 1]),
        (sp.Integer(3), []),
    ],
)
def test_the_zeros_are_those_known(f, zeros):
    found = exponential_zeros(f, x, 40)
    assert len(found) == len(zeros)
    assert all(abs(one - sp.N(other, 50)) < 1e-18 for one, other in zip(found, zeros, strict=True))


@given(st.lists(st.integers(-4, 4), min_size=1, max_size=3, unique=True), st.integers(-3, 3))
def test_factors_give_their_zeros(powers, shift):
    """∏ (eˣ − e^k) (x − s − 1/3) has the zeros k and s + 1/3."""
    f = sp.expand((x - shift - sp.Rational(1, 3)) * sp.prod([sp.exp(x) - sp.exp(k) for k in powers]))
    wanted = sorted([*map(sp.Integer, powers), shift + sp.Rational(1, 3)])
    found = exponential_zeros(f, x, 60)
    assert len(found) == len(wanted)
    assert all(abs(one - other) < 1e-15 for one, other in zip(found, wanted, strict=True))


@pytest.mark.parametrize("f", [sp.sin(x), sp.exp(x**2) - 2, 1 / x + sp.exp(x), sp.Symbol("y") * sp.exp(x)])
def test_what_is_no_such_sum_is_not_judged(f):
    with pytest.raises(NotEvaluable):
        exponential_zeros(f, x, 30)
