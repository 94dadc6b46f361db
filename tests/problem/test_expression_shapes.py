"""How large an expression may become: never estimated as less than what comes out; each limit in its place."""

import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from solver.problem.expressions import ExpressionError, Names, parse_expression
from solver.problem.expressions.grammar import parse
from solver.problem.expressions.shape import _Shapes

x, y, z = sp.symbols("x y z")
NAMES = Names(symbols={"x": x, "y": y, "z": z}, variables={}, values={"g": sp.Rational(981, 100), "r": sp.sqrt(5)})


def shape(text):
    return _Shapes(NAMES).shape(parse(text, NAMES))


ATOMS = st.sampled_from(["x", "y", "2", "3/4", "(x + y)", "(x - 1)", "g"])
TEXTS = st.recursive(
    ATOMS,
    lambda inner: st.one_of(
        st.builds("({} + {})".format, inner, inner),
        st.builds("({} - {})".format, inner, inner),
        st.builds("({})*({})".format, inner, inner),
        st.builds("({})^{}".format, inner, st.integers(0, 3)),
        st.builds("({})/(x + {})".format, inner, st.integers(1, 3)),
    ),
    max_leaves=5,
)


@settings(max_examples=60)
@given(TEXTS)
def test_what_is_estimated_is_never_less_than_what_comes_out(text):
    found = shape(text)
    try:
        value = parse_expression(text, NAMES)
    except ExpressionError as error:
        assume("0^0" not in error.message)  # (2 - 2)^0 is refused
        raise
    above, below = sp.fraction(sp.cancel(value))
    for side in (above, below):
        poly = sp.Poly(side, x, y)
        if side != 0:
            assert poly.total_degree() <= found.degree
            assert len(poly.terms()) <= found.terms


@pytest.mark.parametrize(
    ("text", "above", "below", "nesting"),
    [
        ("7/3", (0, 1), (0, 1), 0),
        ("g", (0, 1), (0, 1), 0),
        ("r", (1, 1), (0, 1), 0),
        ("x*y", (2, 1), (0, 1), 0),
        ("x + y + 1", (1, 3), (0, 1), 0),
        ("(x + y + 1)^3", (3, 10), (0, 1), 0),
        ("(x + 1)^2 (x + 2)", (3, 4), (0, 1), 0),
        ("1/(x + 1)^2", (0, 1), (2, 3), 0),
        ("x^-3", (0, 1), (3, 1), 0),
        ("x/(y + 1) + y/(x + 1)", (2, 4), (2, 4), 0),
        ("sin(x) + cos(sin(y))", (1, 2), (0, 1), 2),
        ("sqrt(2) x", (2, 1), (0, 1), 0),
        ("sqrt(x) sin(2)", (2, 1), (0, 1), 1),
        ("exp(sin(x))^2", (2, 1), (0, 1), 2),
    ],
)
def test_degrees_terms_and_functions_within_each_other(text, above, below, nesting):
    found = shape(text)
    assert (found.above.degree, found.below.degree, found.nesting) == (above[0], below[0], nesting)
    assert (found.above.terms, found.below.terms) == (above[1], below[1])
    assert (found.degree, found.terms) == (max(above[0], below[0]), max(above[1], below[1]))


@pytest.mark.parametrize(
    ("fits", "beyond", "message"),
    [
        ("x^64", "x^64 x", "the degree is more than 64"),
        ("(x + y + z + 1)^29", "(x + y + z + 1)^30", "multiplied out, this may have more than 5000 terms"),
        ("sin(x^6)", "sin(x^7)", "the argument is too long here: its degree is at most 6"),
        ("cosh(x^2)", "cosh(x^3)", "the argument is too long here: its degree is at most 2"),
        ("2^(x^6)", "2^(x^7)", "the exponent is too long here: its degree is at most 6"),
        ("sqrt(x^6)", "sqrt(x^7)", "the argument is too long here: its degree is at most 6"),
        ("sin(sin(sin(x)))", "sin(sin(sin(sin(x))))", "more than 3 functions stand within each other"),
        ("sqrt(sqrt(sqrt(sqrt(2))))", "sqrt(sqrt(sqrt(sqrt(x))))", "more than 3 functions stand within each other"),
        ("sin(sin(sin(2)))", "sin(sin(sin(sin(2))))", "more than 3 functions stand within each other"),
        (
            " + ".join(f"sin({i} x)" for i in range(1, 41)),
            " + ".join(f"sin({i} x)" for i in range(1, 42)),
            "the expression has more than 40 functions and roots",
        ),
    ],
)
def test_each_limit_is_where_it_is(fits, beyond, message):
    assert parse_expression(fits, NAMES) is not None
    with pytest.raises(ExpressionError, match=message):
        parse_expression(beyond, NAMES)
