"""Kernels of polynomial matrices: operations, gcds of minors, common divisors with parameters, shorter ways."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.exact.multivariable.generic import changed_where
from solver.exact.multivariable.polynomial_matrices import (
    common_divisor,
    determinantal_divisors,
    in_factors,
    minors_in_factors,
    polynomial_rows,
)
from solver.exact.multivariable.smith import smith_form
from solver.exact.representation.polynomials import invariant_factors

s, a, b, c = sp.symbols("s a b c")
coefficients = st.lists(st.integers(-3, 3), min_size=1, max_size=3)


@given(st.integers(1, 3), st.integers(1, 3), st.data())
def test_the_form_is_that_of_euclid_without_a_record_and_of_the_minors(rows, columns, data):
    M = sp.ImmutableMatrix(rows, columns, lambda *_: sp.Poly(data.draw(coefficients), s).as_expr())
    form = smith_form(M, s)
    assert list(form.invariants) == invariant_factors([list(row) for row in polynomial_rows(M, s)])
    whole = sp.Poly(1, s, domain=sp.QQ)
    for e, d in zip(form.invariants, determinantal_divisors(M, s), strict=True):
        whole = whole * e
        assert whole == d
    if form.left is not None:
        assert (form.left * M * form.right - form.form).applyfunc(sp.expand).is_zero_matrix
        assert not form.left.det().has(s)
        assert not form.right.det().has(s)


def test_long_ways_are_not_gone_to_their_end():
    rows = [
        [
            s**6 + 9 * s**5 + 21 * s**4 + 9 * s**3 + 20 * s**2,
            s**6 + 5 * s**5 + 4 * s**4 + 20 * s**3 + 3 * s**2 + 15 * s,
        ],
        [s * (s + 1) * (s + 4) * (s + 5), (s**2 + 1) * (s + 1) * (s + 3) * (s + 4)],
    ]
    form = smith_form(sp.ImmutableMatrix(rows).applyfunc(sp.expand), s)
    assert form.is_long
    assert form.stages is None
    assert form.left is None
    easy = smith_form(sp.ImmutableMatrix([[s, 1], [s**2, s + 1]]), s)
    assert [stage.kind for stage in easy.stages] == ["pivot", "columns", "rows", "monic"]


@pytest.mark.parametrize(
    ("p", "q", "expected"),
    [
        ((s + a) * (s + b), (s + a) * (s + c), s + a),
        ((a * s + 1) * s, (s + 1 / a) * (s + 2), s + 1 / a),
        (a * s + b, c * s + b, sp.S.One),
        (sp.S.Zero, (a + b) * (s + a), s + a),
        ((s + a / b) ** 2 * (s - c), (s + a / b) * (b * s + a) * (s + c), (s + a / b) ** 2),
    ],
)
def test_common_divisors_with_parameters(p, q, expected):
    ((one, other, right),) = polynomial_rows(sp.ImmutableMatrix([[p, q, expected]]).applyfunc(sp.expand), s)
    assert common_divisor(one, other).monic() == right.monic()


def test_minors_are_told_in_factors():
    M = sp.ImmutableMatrix([[s * (s + 1), 0], [0, 2 * s * (s + 2)]])
    (minor,) = minors_in_factors(M, s, 2)
    assert minor.value == 2 * s**2 * (s + 1) * (s + 2)
    assert (minor.rows, minor.columns) == ((1, 2), (1, 2))
    assert in_factors(sp.Poly(0, s, domain=sp.QQ)) == 0


def test_a_factor_that_changes_nothing_is_not_named():
    x, y = sp.symbols("x y", real=True)
    one = smith_form(sp.ImmutableMatrix([[x, 1], [s, s]]), s)
    assert [sp.expand(each) for each in changed_where(one)] == [1 - x]
    assert changed_where(smith_form(sp.ImmutableMatrix([[1, y], [0, s + x]]), s)) == ()
