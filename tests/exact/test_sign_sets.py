"""Sets of signs: the rules against numbers that have these signs."""

from itertools import chain, combinations, product

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.conditions import Condition
from solver.exact.linear_algebra.intervals import ALLOWED, intervals
from solver.exact.linear_algebra.sign_sets import ZERO, of_number, of_power, of_product, of_sum, signs_by_assumptions
from tests.helpers.tried import tried

SETS = [frozenset(each) for n in (1, 2, 3) for each in combinations((-1, 0, 1), n)]


def sign(x):
    return (x > 0) - (x < 0)


def numbers(signs):
    """Small numbers and large ones with these signs."""
    return sorted(set(chain.from_iterable((each, 2 * each, 3 * each) for each in signs)))


@pytest.mark.parametrize(("a", "b"), [*product(SETS, repeat=2)])
def test_the_signs_of_sums_and_products_are_those_of_numbers(a, b):
    pairs = list(product(numbers(a), numbers(b)))
    assert of_sum(a, b) == {sign(x + y) for x, y in pairs}
    assert of_product(a, b) == {sign(x * y) for x, y in pairs}


@pytest.mark.parametrize("a", SETS)
@pytest.mark.parametrize("exponent", [0, 1, 2, 3, -1, -2])
def test_the_signs_of_powers_are_those_of_numbers(a, exponent):
    assert of_power(a, exponent) == {sign(x**exponent) for x in numbers(a - ZERO if exponent < 0 else a)}


KNOWN = [{"real": True}, {"positive": True}, {"negative": True}, {"nonnegative": True}, {"nonpositive": True}]
KNOWN += [{"real": True, "nonzero": True}]
GRID = [sp.Rational(n, 4) for n in (-40, -7, -4, -3, -1, 0, 1, 2, 4, 5, 9, 44)]


@st.composite
def expressions(draw):
    """Polynomials in two symbols, some with a function or a square root of one of them, perhaps below a line."""
    x, y = (sp.Symbol(name, **draw(st.sampled_from(KNOWN))) for name in "xy")
    atoms = [x, y, x**2, sp.exp(y), sp.Abs(x), sp.sqrt(y**2 + 1), sp.sin(x)]
    terms = st.lists(
        st.tuples(st.integers(-3, 3), st.sampled_from(atoms), st.sampled_from(atoms)), min_size=1, max_size=3
    )
    found = sp.Add(draw(st.integers(-4, 4)), *(n * left * right for n, left, right in draw(terms)))
    return (x, y), found / (x**2 + 1) if draw(st.booleans()) else found


def allowed(symbol, value):
    """Whether a value is as assumed."""
    return not (
        (symbol.is_positive and value <= 0)
        or (symbol.is_negative and value >= 0)
        or (symbol.is_nonnegative and value < 0)
        or (symbol.is_nonpositive and value > 0)
        or (symbol.is_nonzero and value == 0)
    )


@tried(150)
@given(expressions())
def test_a_sign_that_occurs_is_not_excluded(drawn):
    (x, y), expression = drawn
    found = signs_by_assumptions(expression)
    for u in GRID:
        for v in GRID:
            if allowed(x, u) and allowed(y, v):
                value = expression.xreplace({x: u, y: v})
                assert int(sp.sign(value.evalf(30, chop=True))) in found, (u, v)


real, positive = sp.Symbol("x", real=True), sp.Symbol("p", positive=True)
nonnegative, negative = sp.Symbol("n", nonnegative=True), sp.Symbol("m", negative=True)


@pytest.mark.parametrize(
    ("expression", "signs"),
    [
        (real**4 + real + 1, {1}),
        (real**4 - 3 * real + 1, {-1, 0, 1}),
        (positive**3 + positive, {1}),
        (positive**3 - positive**2 + positive, {1}),
        (nonnegative**3 - nonnegative**2 + nonnegative, {0, 1}),
        (negative**3 - negative**2 + negative, {-1}),
        (positive**2 - 3 * positive + 3, {1}),
        (positive**2 - 3 * positive, {-1, 0, 1}),
        (real**2 - 2 * real + 1, {0, 1}),
        (-(real**2) + real - 1, {-1}),
        (sp.exp(real) + 1, {1}),
        (sp.exp(real) * real**2, {0, 1}),
        (sp.Abs(real) + 2, {1}),
        (sp.sqrt(positive + 1) - sp.sqrt(positive), {1}),
        (positive - sp.sqrt(positive**2 + 1), {-1}),
        (positive + sp.sqrt(positive), {1}),
        (real**2 + real * positive + positive**2, {1}),
        (real**2 + 2 * real * positive + positive**2, {0, 1}),
        (1 / (real**2 + 1), {1}),
        (real / (real**2 + 1), {-1, 0, 1}),
        (sp.sqrt(2) * positive, {1}),
    ],
)
def test_the_signs_of_expressions(expression, signs):
    assert signs_by_assumptions(expression) == signs


@pytest.mark.parametrize(
    "number", [sp.sqrt(2) - sp.Rational(7, 5), sp.sqrt(6) - sp.sqrt(2) * sp.sqrt(3), -sp.pi, sp.Rational(-1, 3)]
)
def test_the_sign_of_a_number(number):
    assert of_number(number) == {int(sp.sign(sp.N(number, 60, chop=True)))}
    assert of_number(number + sp.I) == {-1, 0, 1}


SYMBOLS = [sp.Symbol("x", **known) for known in KNOWN]
FACTORS = st.tuples(st.sampled_from([-2, -1, 0, 1, sp.Rational(3, 2), sp.sqrt(2)]), st.integers(1, 3))


@st.composite
def conditions(draw):
    """A symbol, and conditions on products of powers of its distances from points."""
    x = draw(st.sampled_from(SYMBOLS))
    listed = []
    for _ in range(draw(st.integers(1, 3))):
        above, below = (draw(st.lists(FACTORS, min_size=low, max_size=2)) for low in (1, 0))
        sign = draw(st.sampled_from([1, -1]))
        quotient = sp.Mul(*((x - c) ** n for c, n in above)) / sp.Mul(*((x - c) ** n for c, n in below))
        listed.append(Condition(sign * quotient, draw(st.sampled_from([">", ">=", "!="]))))
    return x, listed


def holds(condition, x, value):
    above, below = (sp.sign(part.xreplace({x: value})) for part in sp.fraction(sp.together(condition.difference)))
    return below != 0 and int(above * below) in ALLOWED[condition.relation]


@tried(60)
@given(conditions())
def test_intervals_hold_the_values_at_which_all_conditions_hold(drawn):
    x, listed = drawn
    found = intervals(x, listed)
    cuts = {root for each in listed for part in sp.fraction(each.difference) for root in sp.roots(part, x)} | {0}
    for value in [*GRID, sp.sqrt(2), sp.Rational(3, 2), sp.Integer(-2), sp.Integer(1)]:
        inside = any(
            (each.low < value or (each.low_closed and each.low == value))
            and (value < each.high or (each.high_closed and each.high == value))
            for each in found
        )
        right = allowed(x, value) and all(holds(each, x, value) for each in listed)
        assert inside >= bool(right), (value, found)
        assert inside == bool(right) or len(cuts) > 3, (value, found)  # many intervals are taken as one
    assert [each.low for each in found] == sorted((each.low for each in found), key=sp.N)
