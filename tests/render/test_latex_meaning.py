"""Whatever is printed means what it was printed from: random expressions, read back by another reader."""

import re

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.formula import latex
from solver.render.latex import formula, tex
from solver.render.numbers import NumberFormat
from tests.helpers.formula_trees import anew
from tests.helpers.reading_latex import value_of
from tests.helpers.tried import tried

s, t, k, lamda, a, b, k_1 = sp.symbols("s t k lamda a b k_1")
POINT = {s: 1.37, t: 0.61, k: 3.0, lamda: 2.21, a: 0.83, b: 1.9, k_1: 0.47}
PRINTED = {r"\lambda": 2.21, **{str(symbol): number for symbol, number in POINT.items()}}

FORMATS = [
    NumberFormat("exact"),
    NumberFormat("decimal", 12),
    NumberFormat("both"),
]

integers = st.integers(-6, 6)
rationals = st.builds(sp.Rational, integers, st.integers(1, 8))
floats = st.builds(sp.Float, st.floats(-50, 50).filter(lambda x: x == 0 or abs(x) > 1e-5))
roots = st.sampled_from(
    [sp.sqrt(2), sp.sqrt(5), (1 + sp.sqrt(5)) / 2, (1 - sp.sqrt(5)) / 2, sp.sqrt(2 + sp.sqrt(3)), sp.pi]
)
numbers = st.one_of(rationals, roots, st.builds(lambda x, y: x * y, rationals, roots), floats)
complexes = st.builds(lambda x, y: x + y * sp.I, numbers, numbers)
symbols = st.sampled_from([s, t, lamda, a, b, k_1])


def polynomial(x):
    return st.lists(rationals, min_size=1, max_size=4).map(lambda c: sum(ci * x**i for i, ci in enumerate(c)))


def factors(rates):
    return st.one_of(
        symbols,
        numbers,
        complexes,
        polynomial(s),
        st.builds(lambda x, n: x**n, symbols, st.integers(-3, 3)),
        st.builds(lambda r: sp.exp(r * t), rates),
        st.builds(lambda r: sp.cos(r * t), numbers),
        st.builds(lambda r: sp.sin(r * t) ** 2, numbers),
        st.builds(lambda r: (s + r) ** -1, numbers),
        st.builds(lambda p: p**-1, polynomial(s).filter(lambda p: p != 0)),
        st.builds(lambda r: r**k, rationals.filter(bool)),
        st.builds(lambda r: sp.sqrt(a**2 + r), st.integers(1, 5)),
    )


terms = st.lists(factors(st.one_of(numbers, st.builds(lambda x: x * a, rationals))), min_size=1, max_size=4).map(
    lambda parts: sp.Mul(*parts)
)
expressions = (
    st.lists(terms, min_size=1, max_size=4)
    .map(lambda parts: sp.Add(*parts))
    .filter(lambda e: e.is_finite is not False and not e.has(sp.nan, sp.zoo, sp.oo))
)


@pytest.mark.parametrize("numbers", FORMATS, ids=lambda numbers: numbers.mode)
@tried(80)
@given(expression=expressions)
def test_what_is_printed_means_what_it_was_printed_from(numbers, expression):
    expected = complex(expression.subs(POINT).evalf(30))
    if not abs(expected) < 1e12:
        return
    scale = max([1.0] + [abs(complex(term.subs(POINT).evalf(30))) for term in sp.Add.make_args(sp.expand(expression))])
    digits = 12 if numbers.mode == "decimal" else 5 if expression.has(sp.Float) else 12
    shown = formula(expression, NumberFormat(numbers.mode, max(digits, 12)))
    printed = latex(shown)
    assert anew(printed) == shown
    assert value_of(printed, PRINTED) == pytest.approx(expected, rel=1e-7, abs=1e-7 * scale), printed


@pytest.mark.parametrize("numbers", FORMATS, ids=lambda numbers: numbers.mode)
@tried(80)
@given(expression=expressions)
def test_nothing_is_printed_that_no_person_would_write(numbers, expression):
    printed = tex(expression, numbers)
    for blemish in ("- -", "+ -", "--", "+ +", "1.0", r"1 \cdot", r" \right", "  "):
        if blemish == "1.0" and re.search(r"1\.0\d", printed):
            continue
        assert not re.search(rf"(?<![\d._]){re.escape(blemish)}", printed), printed
    assert not re.search(r"(?<![\d.}_^])1(?:[a-z]|\\(?:sqrt|pi|cos|sin|lambda|left)|\()", printed), printed
    assert not re.search(r"\.\d*0(?!\d)", printed), printed
