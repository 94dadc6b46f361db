"""Evaluation against sympy's own evalf, which shares nothing with the walk."""

import math

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.numeric import NotEvaluable, Undefined, evaluate
from solver.numeric.evaluation.arithmetic import DOUBLE
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from tests.helpers.tried import tried

a, b, t, s = sp.symbols("a b t s")
POINT = {a: 1.375, b: -0.625, t: 0.5, s: complex(-0.75, 1.25)}
EXACT = {symbol: sp.nsimplify(complex(value), rational=True) for symbol, value in POINT.items()}

TABLE = [
    a**3 - 2 * a * b + sp.Rational(7, 3),
    (a + b) ** -2,
    sp.sqrt(a) + sp.sqrt(b) + a ** sp.Rational(2, 3) + b ** sp.Rational(-1, 3) + s ** sp.Rational(3, 2),
    sp.exp(-2 * t) * (sp.cos(3 * t) - 2 * sp.sin(3 * t)),
    sp.tan(a) + sp.cot(a) + sp.sec(b) + sp.csc(b),
    sp.sinh(a) * sp.cosh(b) + sp.tanh(s),
    sp.asin(b) + sp.acos(b) + sp.atan(a) + sp.atan2(b, -a),
    sp.asinh(a) + sp.acosh(a) + sp.atanh(b),
    sp.log(a) + sp.log(b) + sp.log(s),
    sp.Abs(s) + sp.re(s) + sp.im(s) + sp.conjugate(s) + sp.arg(s) + sp.sign(s) + sp.sign(b),
    sp.pi * sp.E + sp.I * a + sp.Float("0.1", 30),
    sp.Piecewise((a, b > 0), (b**2, sp.And(a > 1, b < 0)), (0, True)),
    sp.Heaviside(a) * 3 + sp.Heaviside(b),
    sp.binomial(a, 3, evaluate=False) + sp.ff(a, 2) + sp.rf(b, 3) + sp.factorial(5, evaluate=False),
    a**b + s ** (a + b) + b**a,
    sp.CRootOf(a**5 - a + 1, 0) + sp.CRootOf(a**5 - a + 1, 3),
    sp.sqrt(-(s * sp.conjugate(s))) + sp.log(-s * sp.conjugate(s)),
]


@pytest.mark.parametrize("expression", TABLE, ids=str)
def test_every_kind_of_expression_has_the_value_sympy_gives_it(expression):
    expected = complex(expression.subs(EXACT).evalf(30))
    assert evaluate(expression, POINT) == pytest.approx(expected, rel=1e-13, abs=1e-13)


def _expressions():
    atoms = st.one_of(
        st.sampled_from([a, b, t, s, sp.pi, sp.I]),
        st.integers(-9, 9).map(sp.Integer),
        st.tuples(st.integers(-40, 40), st.integers(1, 9)).map(lambda pair: sp.Rational(*pair)),
    )

    def grow(inner):
        return st.one_of(
            st.tuples(inner, inner).map(lambda pair: pair[0] + pair[1]),
            st.tuples(inner, inner).map(lambda pair: pair[0] * pair[1]),
            st.tuples(inner, st.integers(-2, 3)).map(lambda pair: pair[0] ** pair[1]),
            st.tuples(st.sampled_from([sp.exp, sp.sin, sp.cos, sp.sqrt, sp.sinh, sp.atan]), inner).map(
                lambda pair: pair[0](pair[1])
            ),
        )

    return st.recursive(atoms, grow, max_leaves=10)


@tried(150)
@given(_expressions())
def test_random_expressions_have_the_value_sympy_gives_them(expression):
    exact = expression.subs(EXACT)
    if any(each.has(sp.zoo, sp.nan, sp.oo, -sp.oo, sp.AccumBounds) for each in (exact, expression)):
        return
    reference = exact.evalf(40, maxn=400)
    expected = complex(reference)
    if not np.isfinite(expected) or abs(expected) > 1e100 or abs(expected) < 1e-100:
        return
    try:
        value = evaluate(expression, POINT)
    except Undefined:  # an intermediate value beyond the range of doubles
        return
    assert value == pytest.approx(expected, rel=1e-10, abs=1e-60)


def test_cancellation_is_noticed_and_resolved_with_more_digits():
    x = sp.Symbol("x")
    expression = (
        (x - 1) ** 7 - sum((-1) ** (7 - i) * math.comb(7, i) * x**i for i in range(8)) + x * sp.Rational(1, 10**20)
    )
    assert evaluate(expression, {x: 1.0009765625}) == pytest.approx(1.0009765625e-20, rel=1e-10)
    assert evaluate(sp.cos(x) - 1 + x**2 / 2, {x: 2.0**-20}) == pytest.approx((2.0**-20) ** 4 / 24, rel=1e-10)


def test_a_value_on_a_cut_is_the_principal_one_whatever_rounding_says():
    assert evaluate(sp.sqrt(-(s - 1) * (sp.conjugate(s) - 1)), POINT).imag > 0
    assert evaluate(sp.sqrt(sp.Mul(-1, sp.Integer(4), evaluate=False)), {}) == pytest.approx(2j)
    assert evaluate(sp.log(-a), POINT).imag == pytest.approx(math.pi)


@pytest.mark.parametrize("argument", [2, -2, 2 * sp.I, -2 * sp.I])
@pytest.mark.parametrize("function", [sp.asin, sp.acos, sp.atan, sp.asinh, sp.acosh, sp.atanh, sp.log, sp.sqrt])
def test_values_on_cuts_are_those_of_sympy(function, argument):
    expression = function(argument * a / sp.Rational(11, 8))
    assert evaluate(expression, POINT) == pytest.approx(complex(function(argument).evalf(20)))
    assert evaluate(expression * (a - b - 2), POINT, tolerance=1e-40) == 0


def test_matrices_and_nested_lists_become_arrays_of_their_shape():
    assert evaluate(sp.Matrix([[a, 1], [0, b]]), POINT).tolist() == [[1.375, 1], [0, -0.625]]
    assert evaluate([a, 2], POINT).tolist() == [1.375, 2]
    assert evaluate([[a, 2]], POINT).shape == (1, 2)
    assert evaluate(sp.Matrix(2, 0, []), {}).shape == (2, 0)
    assert evaluate(3, {}) == 3
    assert evaluate(0.25 + 1j, {}) == 0.25 + 1j


@pytest.mark.parametrize(
    ("expression", "point", "value"),
    [(0**a, {a: 0}, 1), (0**a, {a: 2}, 0), ((-2) ** a, {a: 3}, -8), (sp.KroneckerDelta(a, 0), {a: 0}, 1)],
)
def test_powers_and_deltas_at_whole_numbers_are_exact(expression, point, value):
    assert evaluate(expression, point) == value


@pytest.mark.parametrize(
    "expression",
    [sp.DiracDelta(a), sp.Integral(sp.exp(-(a**2)), a), sp.Symbol("unknown"), sp.oo, sp.true],
    ids=str,
)
def test_what_can_not_be_evaluated_is_refused_with_a_reason(expression):
    with pytest.raises(NotEvaluable, match=r"\w"):
        evaluate(expression, POINT)


@pytest.mark.parametrize("expression", [1 / (a - a**2 / sp.Rational(11, 8)), sp.log(b - b * a / sp.Rational(11, 8))])
def test_a_division_by_zero_has_no_value(expression):
    with pytest.raises(Undefined):
        evaluate(expression, POINT)


def test_integers_beyond_doubles_are_exact_with_more_digits():
    big = sp.Integer(10) ** 40
    assert evaluate(sp.Add(big, a, -big, evaluate=False), POINT) == pytest.approx(1.375)


@pytest.mark.parametrize(("y", "x"), [(1, 2), (-1, 2), (1, -2), (-1, -2), (3, -1)])
def test_a_direction_is_that_of_the_point(y, x):
    """The arguments are symbols, or sympy would find the angle itself."""
    assert abs(evaluate(sp.atan2(a, b), {a: y, b: x}) - math.atan2(y, x)) < 1e-15


@pytest.mark.parametrize("spoiled", [sp.atan2((a + 10**8) - b, sp.Integer(1)), sp.atan2(a, (a + 10**8) - b)])
def test_the_rounding_of_either_argument_of_a_direction_counts(spoiled):
    """Of the difference of numbers near 10⁸ eight digits are left; the magnitude of the angle must tell."""
    found = value_of(spoiled, Environment.at([{a: 0.1, b: 10.0**8}]))
    assert DOUBLE.eps * float(np.ravel(found.magnitude)[0]) > 1e-9
