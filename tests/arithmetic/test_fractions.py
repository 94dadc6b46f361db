"""Partial fractions by hand: what the lines show is what scipy and numpy find."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.signal import residue

from solver.arithmetic.fractions import expanded
from solver.arithmetic.values import put_in
from solver.exact import RationalMatrix, resolvent_matrix
from solver.exact.functions.rational import between
from solver.numeric import check_steps
from solver.render.wording import Wording

TUTOR = Wording(detail="tutor")
s = sp.Symbol("s")


def transfer(numerator, denominator):
    """N(s)/D(s) in controller form, coefficients of D monic, highest power first."""
    n = len(denominator) - 1
    padded = [0] * (n - len(numerator)) + list(numerator)
    A = sp.zeros(n)
    for i in range(n - 1):
        A[i, i + 1] = 1
    A[n - 1, :] = sp.Matrix([[-c for c in reversed(denominator[1:])]])
    B = sp.zeros(n, 1)
    B[n - 1] = 1
    C = sp.Matrix([list(reversed(padded))])
    return between(sp.ImmutableMatrix(C), sp.ImmutableMatrix(A), sp.ImmutableMatrix(B))


def shown(image: RationalMatrix):
    steps = expanded(image, s)
    assert [check for check in check_steps(steps) if check.status != "passed"] == []
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


def test_a_simple_pole_is_covered_up():
    text = shown(transfer([1, 9], [1, 9, 20]))
    assert r"\left.\frac{s + 9}{s + 4}\right|_{s = -5} = \frac{-5 + 9}{-5 + 4} = -4" in text
    assert r"\left.\frac{s + 9}{s + 5}\right|_{s = -4} = \frac{-4 + 9}{-4 + 5} = 5" in text


def test_a_repeated_pole_has_derivatives():
    text = shown(transfer([1, 3], [1, 4, 5, 2]))  # (s + 3)/((s + 1)²(s + 2))
    assert r"\left.\frac{s + 3}{s + 2}\right|_{s = -1} = \frac{-1 + 3}{-1 + 2} = 2" in text
    assert r"\frac{d}{ds}\frac{s + 3}{s + 2} = -\frac{1}{(s + 2)^{2}}" in text
    assert r"\right|_{s = -1} = -\frac{1}{(-1 + 2)^{2}} = -1" in text


def test_the_numerator_over_a_quadratic_by_comparison():
    text = shown(transfer([5], [1, 2, 5, 0]))
    assert r"5 = s^{2} + 2s + 5 + (\beta s + \gamma)s" in text
    assert r"0 &= 1 + \beta" in text
    assert r"0 &= 2 + \gamma" in text


def test_two_quadratics_at_their_upper_roots():
    text = shown(transfer([6], [1, 0, 5, 0, 4]))  # 6/((s² + 1)(s² + 4))
    assert r"\left.\frac{6}{s^{2} + 4}\right|_{s = j} = \frac{6}{j^{2} + 4} = 2" in text
    assert r"2j\beta + \gamma = -2" in text


@pytest.mark.parametrize("rows", [[[-1]], [[0, 1], [-5, -2]]])
def test_one_fraction_needs_nothing(rows):
    assert expanded(resolvent_matrix(sp.ImmutableMatrix(rows)), s) == ()


@settings(max_examples=20)
@given(st.lists(st.integers(-4, 4), min_size=2, max_size=4), st.lists(st.integers(-5, 5), min_size=1, max_size=2))
def test_the_coefficients_are_those_of_scipy(poles, numerator):
    assume(max(map(poles.count, poles)) < 3)  # scipy finds a threefold pole to three digits only
    denominator = [int(c) for c in np.poly(poles).round()]
    found = [
        complex(claim.right)
        for step in expanded(transfer(numerator, denominator), s)
        for name, claim in step.claims.items()
        if name.startswith("value") or (name.startswith("at") and name.replace("at", "value") not in step.claims)
    ]
    coefficients = residue(numerator, denominator)[0]
    assert all(np.abs(coefficients - each).min() < 1e-3 for each in found)
    assert all(check.status == "passed" for check in check_steps(expanded(transfer(numerator, denominator), s)))


@pytest.mark.parametrize(
    "rows", [[[0, 1, 0], [0, 0, 1], [-1, -3, -3]], [[1, 2, 0], [0, 1, 1], [2, 0, 3]], [[0, 1], [1, 2]]]
)
def test_matrices_are_expanded_entry_by_entry(rows):
    assert r"\right|_{s = " in shown(resolvent_matrix(sp.ImmutableMatrix(rows)))


@pytest.mark.parametrize(
    ("expression", "value", "text"),
    [
        ((s + 9) / (s + 4), -5, r"\frac{-5 + 9}{-5 + 4}"),
        (1 / (s * (s + 4)), -5, r"\frac{1}{(-5)(-5 + 4)}"),
        (1 / ((s + 4) * (s + 5)), 0, r"\frac{1}{4 \cdot 5}"),
        (-s / (s**2 + 1), -2, r"\frac{2}{(-2)^{2} + 1}"),
        (sp.exp(-s) - sp.exp(-2 * s), 0, "1 - 1"),
        (s * sp.exp(-s) + sp.cos(2 * s), 0, "1"),
    ],
)
def test_numbers_are_put_in_and_not_worked_out(expression, value, text):
    assert TUTOR.tex(put_in(expression, s, sp.Integer(value))) == text


def test_fractions_over_the_square_of_a_quadratic_are_put_together_again():
    text = shown(transfer([1, 0, 6], [1, 0, 8, 0, 16]))  # (s² + 6)/(s² + 4)²
    assert "2 + s^{2} + 4 = s^{2} + 6" in text
