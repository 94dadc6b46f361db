"""What is known of the rounding of a value: never less than its error, and not much more."""

import mpmath
import numpy as np
import pytest
import sympy as sp

from solver.numeric import NotEvaluable
from solver.numeric.evaluation.arithmetic import DOUBLE, multiple
from solver.numeric.evaluation.compare import residuals
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import PointSource, free_symbols, whole_symbols
from solver.numeric.evaluation.precision import is_sampled
from solver.numeric.evaluation.values import SAFETY, Undefined, Value
from solver.stated import Stated
from solver.stated.algebra import product, total
from tests.stated.test_every_operation import RIGHT, name_of

a, b = sp.symbols("a b")
LARGE = 2**27
SPOILED = a + LARGE - b
"""At b = 2²⁷ it is a, of which eight digits are lost."""

FUNCTIONS = {
    "exp": sp.exp,
    "sin": sp.sin,
    "cos": sp.cos,
    "tan": sp.tan,
    "cot": sp.cot,
    "sec": sp.sec,
    "csc": sp.csc,
    "sinh": sp.sinh,
    "cosh": sp.cosh,
    "tanh": sp.tanh,
    "log": sp.log,
    "asin": sp.asin,
    "acos": sp.acos,
    "atan": sp.atan,
    "asinh": sp.asinh,
    "acosh": lambda x: sp.acosh(x + 2),
    "atanh": sp.atanh,
    "Abs": sp.Abs,
    "re": sp.re,
    "conjugate": sp.conjugate,
    "square root": sp.sqrt,
    "root below a line": lambda x: x ** sp.Rational(-1, 2),
    "cube": lambda x: x**3,
    "reciprocal": lambda x: 1 / x,
    "reciprocal square": lambda x: x**-2,
    "third root": lambda x: x ** sp.Rational(1, 3),
    "exponent": lambda x: sp.Integer(3) ** x,
    "both": lambda x: x ** (x + 1),
    "product": lambda x: 7 * x * (x + 1),
    "sum": lambda x: 5 + x + x**2,
    "binomial": lambda x: sp.binomial(x, 3, evaluate=False),
    "falling": lambda x: sp.ff(x, 3, evaluate=False),
    "rising": lambda x: sp.rf(x, 3, evaluate=False),
    "direction, ordinate": lambda x: sp.atan2(x, 2),
    "direction, abscissa": lambda x: sp.atan2(2, x),
    "piece": lambda x: sp.Piecewise((x**2, a < 1), (0, True)),
}


CARRIED_OUT = [pair for pair in RIGHT if isinstance(pair[0], Stated) and not is_sampled(pair[0])]


def at(expression, arithmetic=DOUBLE):
    found = value_of(expression, Environment.at([{a: 0.375, b: LARGE}], arithmetic))
    return complex(np.ravel(found.value)[0]), float(np.ravel(found.magnitude)[0])


@pytest.mark.parametrize("arithmetic", [DOUBLE, multiple(30)], ids=["double", "multiple"])
@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_rounding_of_an_argument_counts_as_much_as_the_slope(name, arithmetic):
    f = FUNCTIONS[name]
    with mpmath.workdps(40):
        value = sp.lambdify(a, f(a), "mpmath")
        slope = abs(complex(mpmath.diff(lambda x: mpmath.re(value(x)), mpmath.mpf(0.375))))
        size = abs(complex(value(mpmath.mpf(0.375))))
    for argument, spread in ((a, 0.375), (SPOILED, 2.0 * LARGE)):
        found, magnitude = at(f(argument), arithmetic)
        assert abs(found - complex(value(0.375))) <= SAFETY * arithmetic.eps * magnitude + 1e-15
        expected = size + slope * spread
        assert expected / 5 < magnitude < 20 * expected + 4, (argument, magnitude, expected)


def _entries(value):
    return np.array([complex(each) for each in np.ravel(np.asarray(value, dtype=object))])


@pytest.mark.parametrize(("left", "right"), CARRIED_OUT, ids=name_of)
def test_the_rounding_of_operations_is_known(left, right):
    whole = whole_symbols(left, right)
    for point in PointSource(free_symbols(left) | free_symbols(right), whole).several(2):
        try:
            found = value_of(left, Environment.at([point]))
            exact = value_of(left, Environment.at([point], multiple(50)))
        except (NotEvaluable, Undefined):
            continue
        rounding = DOUBLE.eps * np.ravel(np.broadcast_to(found.magnitude, np.shape(found.value)))
        value, more = _entries(found.value), _entries(exact.value)
        assert np.all(abs(value - more) <= SAFETY * rounding + 1e-300)
        assert np.all(rounding <= 1e-9 * (1 + abs(more).max()))


@pytest.mark.parametrize("order", [0, 1, 3, 12])
def test_the_rounding_of_derivatives_of_an_unknown_function_grows_with_them(order):
    q = sp.Function("q")(a)
    found, magnitude = at(sp.Derivative(q, (a, order)) if order else q)
    exact, _ = at(sp.Derivative(q, (a, order)) if order else q, multiple(40))
    next_one, _ = at(sp.Derivative(q, (a, order + 1)))
    assert abs(found - exact) <= SAFETY * DOUBLE.eps * magnitude
    assert abs(found) < magnitude < 200 * (abs(found) + abs(next_one))


def test_the_rounding_of_the_argument_of_an_unknown_function_counts():
    _, magnitude = at(sp.Function("q")(SPOILED))
    assert magnitude > LARGE / 4


@pytest.mark.parametrize("arithmetic", [DOUBLE, multiple(50)])
def test_equal_values_agree_whatever_is_known_of_their_rounding(arithmetic):
    """What e^(-8750/T) times its large factor is made of can be too large to tell how much rounding it explains."""
    left, right = (Value(arithmetic.number(2), size) for size in (np.nan, 2.0))
    residual, settled = residuals(left, right, 1, arithmetic)
    assert residual[0, 0] == 0
    assert settled.all()
    unequal, _ = residuals(left, Value(arithmetic.number(3), 3.0), 1, arithmetic)
    assert not unequal[0, 0] <= 1e-10


@pytest.mark.parametrize("arithmetic", [DOUBLE, multiple(30)])
def test_what_rounding_explains_is_asked_for_where_values_do_not_clearly_agree(arithmetic):
    asked = []

    def value(number):
        return Value(arithmetic.number(number), lambda: asked.append(number) or 1.0)

    residuals(value(2.0), value(2.0), 1, arithmetic, 1e-10)
    assert not asked
    near, settled = residuals(value(2.0), value(2.0 + 1e-10), 1, arithmetic, 1e-10)
    assert asked
    assert settled.all()
    assert 1e-11 < near[0, 0] < 1e-10
    _, settled = residuals(value(2.0), value(2.0 + 1e-9), 1, arithmetic, 1e-10)
    assert not settled.any()


@pytest.mark.parametrize(("left", "right"), [(np.inf, 2.0), (-np.inf, np.inf), (2.0, np.inf), (np.nan, 2.0)])
def test_infinity_is_near_to_no_other_number(left, right):
    many = multiple(30)
    with np.errstate(all="ignore"):
        residual, _ = residuals(*(Value(many.number(each), 1.0) for each in (left, right)), 1, many, 1e-20)
        same, settled = residuals(*(Value(many.number(np.inf), 1.0) for _ in range(2)), 1, many, 1e-20)
    assert not residual[0, 0] <= 1e-20
    assert same[0, 0] == 0
    assert settled.all()


def test_the_rounding_of_very_many_terms_is_known():
    """Of as many as would wait for each other's magnitudes beyond what Python can call within itself."""
    terms = [sp.Symbol("a") + i for i in range(600)]
    environment = Environment.at([{sp.Symbol("a"): 0.5}])
    found = value_of(total(*terms), environment)
    assert np.ravel(found.magnitude)[0] == pytest.approx(sum(0.5 + i for i in range(600)))
    factors = value_of(product(*(1 + term / 10**6 for term in terms)), environment)
    assert np.isfinite(factors.magnitude).all()
