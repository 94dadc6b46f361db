"""Partial derivatives are those of sympy, in form too; quotients that share a monomial only are cancelled as by it."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from sympy.polys.rings import ring

from solver import exact
from solver.exact.modelling.quotients import _over_a_monomial, _share_a_monomial

x, y, a, b = SYMBOLS = sp.symbols("x y a b", real=True)
R, *VARIABLES = ring("a b c d", sp.QQ)


def grown(inner):
    sums = st.lists(inner, min_size=2, max_size=3)
    return st.one_of(
        sums.map(lambda terms: sp.Add(*terms)),
        sums.map(lambda factors: sp.Mul(*factors)),
        st.builds(lambda base, k: base**k, inner, st.integers(2, 4)),
        inner.map(sp.sin),
        inner.map(sp.cos),
    )


atoms = st.sampled_from([*SYMBOLS, sp.Integer(1), sp.Integer(-2), sp.Rational(1, 2)])
polynomials = st.dictionaries(
    st.tuples(*[st.integers(0, 2)] * 4), st.sampled_from([-3, -1, 1, 2]), min_size=1, max_size=3
)


@given(st.recursive(atoms, grown, max_leaves=8))
def test_they_look_as_sympy_writes_them(expression):
    for symbol in (x, a):
        assert exact.partial(expression, symbol) == sp.diff(expression, symbol)


def test_a_root_stays_in_the_denominator():
    assert exact.partial(sp.sqrt(a * x), x) == a / (2 * sp.sqrt(a * x))


def test_time_goes_through_the_chain_rule():
    position = (x + y) ** 2 * sp.sin(x) + a
    rate = 2 * (x + y) * (a + b) * sp.sin(x) + (x + y) ** 2 * sp.cos(x) * a
    assert sp.expand(exact.time_derivative(position, {x: a, y: b}) - rate) == 0


@given(polynomials, polynomials, polynomials)
def test_cancelled_by_a_monomial_as_by_the_greatest_divisor(first, second, common):
    above, below, factor = ({monomial: sp.QQ(c, 2) for monomial, c in each.items()} for each in (first, second, common))
    p, q = R(above) * R(factor), R(below) * R(factor)
    if not _share_a_monomial(p, q):
        return
    found, (n, d) = _over_a_monomial(p, q), p.cancel(q)
    assert found in ((n, d), (-n, -d))


@pytest.mark.parametrize(
    ("above", "below", "seen"),
    [
        ("a*c + b*c", "a + b", False),
        ("a*c + b*c + a*d", "a + b", True),
        ("a + b", "a + b", False),
        ("a*b + a", "a*b*c + d", True),
    ],
)
def test_a_factor_in_common_is_never_overlooked(above, below, seen):
    p, q = (R.from_expr(sp.sympify(each)) for each in (above, below))
    assert _share_a_monomial(p, q) is seen


def test_the_zero_of_an_identity_is_seen():
    assert exact.is_zero(sp.sin(2 * x) - 2 * sp.sin(x) * sp.cos(x))
    assert exact.is_zero(a * sp.sin(x) ** 2 + a * sp.cos(x) ** 2 - a)
    assert not exact.is_zero(x)
    assert exact.is_zero(sp.S.Zero)
