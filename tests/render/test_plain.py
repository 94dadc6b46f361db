"""Values in JSON are read back exactly by sympy; values in a terminal are drawn as they are printed."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.render.plain import sympy_text, unicode_text

NAMES = ["a", "k", "s", "t", "z", "lamda", "beta", "gamma", "zeta", "N", "E", "S", "I", "Q", "p11", "omega_n"]
LOCALS = {name: sp.Symbol(name) for name in NAMES}

numbers = st.one_of(
    st.builds(sp.Rational, st.integers(-99, 99), st.integers(1, 60)),
    st.sampled_from(
        [sp.sqrt(2), (1 - sp.sqrt(5)) / 2, sp.I, 2 - 3 * sp.I, sp.pi, sp.E, sp.sqrt(2 + sp.sqrt(3)), sp.oo]
    ),
)
symbols = st.sampled_from(list(LOCALS.values()))
expressions = st.recursive(
    st.one_of(numbers.filter(lambda n: n != sp.oo), symbols),
    lambda inner: st.one_of(
        st.builds(sp.Add, inner, inner),
        st.builds(sp.Mul, inner, inner),
        st.builds(sp.exp, inner),
        st.builds(sp.cos, inner),
        st.builds(lambda x, n: x**n, inner, st.integers(-2, 3)),
    ),
    max_leaves=8,
).filter(lambda e: not e.has(sp.zoo, sp.nan, sp.oo))


def read(text, symbols=LOCALS):
    return sp.sympify(text, locals=symbols)


def same(x, y):
    """Equal, exactly; sympy itself keeps 2(1/2 − √5/2) in two forms, so the difference may need multiplying out."""
    return x == y or sp.expand(x - y) == 0


@given(expressions)
def test_an_expression_is_read_back_exactly(expression):
    free = {symbol.name: symbol for symbol in expression.free_symbols}
    assert same(read(sympy_text(expression, free), free), expression)


@given(
    st.integers(0, 3).flatmap(lambda c: st.lists(st.lists(expressions, min_size=c, max_size=c), min_size=1, max_size=3))
)
def test_a_matrix_is_read_back_exactly(rows):
    matrix = sp.ImmutableMatrix(len(rows), len(rows[0]), [entry for row in rows for entry in row])
    free = {symbol.name: symbol for symbol in matrix.free_symbols}
    back = read(sympy_text(matrix, free), free)
    assert back.shape == matrix.shape
    assert all(same(x, y) for x, y in zip(back.flat(), matrix.flat(), strict=True))


@given(st.lists(numbers, max_size=5))
def test_a_list_is_read_back_exactly(items):
    assert read(sympy_text(items, LOCALS)) == items


a = sp.Symbol("a")


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (sp.Matrix(3, 0, []), "Matrix(3, 0, [])"),
        (sp.ImmutableMatrix([[13, 8]]), "Matrix([[13, 8]])"),
        (True, "True"),
        (sp.false, "False"),
        ("asymptotically stable", "asymptotically stable"),
        ((1, 2), "[1, 2]"),
        (["positive definite", "indefinite"], "['positive definite', 'indefinite']"),
        (sp.Eq(a, 1), "Eq(a, 1)"),
        (sp.Ne(a, 0), "Ne(a, 0)"),
        (a > 2, "a > 2"),
        (sp.Poly(a**2 + a, a), "a + a**2"),
        (0.1, "0.100000000000000"),
        ([0.5], "[0.500000000000000]"),
    ],
    ids=str,
)
def test_values_have_the_documented_text(value, text):
    assert sympy_text(value) == text


@pytest.mark.parametrize("condition", [sp.And(a > 0, a < 2), sp.Or(a < 0, a > 1), a >= 2, sp.Eq(a**2, 2)], ids=str)
def test_conditions_are_read_back(condition):
    assert read(sympy_text(condition)) == condition


@given(st.floats(allow_nan=False, allow_infinity=False, min_value=-1e200, max_value=1e200))
def test_decimals_keep_fifteen_digits(number):
    assert float(read(sympy_text(sp.Float(number)))) == pytest.approx(number, rel=1e-14)


def test_a_matrix_is_drawn_in_the_terminal():
    drawn = unicode_text(sp.Matrix([[1, sp.exp(-a)], [0, sp.Rational(1, 2)]]))
    assert len(drawn.splitlines()) >= 2
    assert "e⁻ᵃ" in drawn
