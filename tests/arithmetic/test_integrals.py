"""Integrals, geometric sums and fractions transformed back, as on paper: the values are those of scipy and numpy."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from solver.arithmetic.integrals import integrated
from solver.arithmetic.sums import added_up
from solver.arithmetic.transformed import term_by_term
from solver.exact import antiderivative, exponential, resolvent_matrix
from solver.exact.functions.antiderivatives import Antiderivative
from solver.numeric import check_steps
from solver.render.wording import Wording

TUTOR = Wording(detail="tutor")
t, tau, i, k, s = sp.symbols("t tau i k s")


def one(entry):
    return sp.ImmutableMatrix([[entry]])


def displayed(steps):
    assert [check for check in check_steps(steps) if check.status != "passed"] == []
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


def test_the_antiderivative_and_the_limits_are_shown():
    value = one((1 - sp.exp(-2 * t)) / 2)
    shown = displayed(integrated(one(sp.exp(-2 * (t - tau))), tau, sp.S.Zero, t, value))
    assert r"F = \frac{1}{2}e^{2\tau - 2t}" in shown
    assert r"\frac{1}{2} - \frac{1}{2}e^{-2t}" in shown


def test_products_of_waves_are_written_as_sums():
    value = one(sp.sin(t) / 2 - t * sp.cos(t) / 2)
    shown = displayed(integrated(one(sp.sin(t - tau) * sp.sin(tau)), tau, sp.S.Zero, t, value))
    assert r"= \frac{1}{2}\cos(t - 2\tau) - \frac{1}{2}\cos(t)" in shown
    wrong = integrated(one(sp.sin(t - tau) * sp.sin(tau)), tau, sp.S.Zero, t, value * 2)
    assert any(check.status == "failed" for check in check_steps(wrong))


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 3), st.integers(-2, 2), st.integers(0, 3), st.booleans(), st.booleans())
def test_antiderivatives_give_the_integrals_of_quad(n, a, b, sine, squared):
    wave = sp.sin(b * t) if sine else sp.cos(b * t)
    f = t**n * sp.exp(a * t) * (wave * sp.cos(t) if squared else wave)
    found = antiderivative(one(f), t)
    assert isinstance(found, Antiderivative)
    F = found.function[0]
    expected, _ = quad(sp.lambdify(t, f), 0, 1.5)
    assert np.isclose(float(F.subs(t, 1.5) - F.subs(t, 0)), expected)


@pytest.mark.parametrize("entry", [sp.exp(-(tau**2)), 1 / tau, sp.Heaviside(tau), sp.sqrt(tau)])
def test_what_is_no_such_term_is_left(entry):
    assert antiderivative(one(entry), tau) is None


def test_a_geometric_sum():
    value = one((2**k - sp.Rational(1, 2) ** k) * sp.Rational(2, 3))
    shown = displayed(added_up(one(sp.Rational(1, 2) ** (k - 1 - i) * 2**i), i, k, value))
    assert r"\left(\frac{1}{2}\right)^{k - 1 - i} \cdot 2^{i} = \frac{2}{3}\left(2^{k} - " in shown


@settings(max_examples=20, deadline=None)
@given(st.integers(-3, 3).filter(bool), st.integers(-3, 3).filter(lambda b: b not in (0, 1)))
def test_geometric_series_are_those_added_up_one_by_one_by_the_oracle(a, b):
    summand = one(sp.Integer(a) ** (k - 1 - i) * sp.Integer(b) ** i)
    steps = added_up(summand, i, k, one(sp.S.Zero))
    series = [check for check in check_steps(steps) if check.claim == "geometric series"]
    assert [check.status for check in series] == ["passed"]


def test_a_numerator_is_split_for_cosine_and_sine_and_the_terms_are_added():
    A = sp.ImmutableMatrix([[0, 1], [-5, -2]])
    Phi = exponential(A, t).matrix
    shown = displayed(term_by_term(resolvent_matrix(A), s, t, Phi, discrete=False))
    assert r"(s + 1)\begin{bmatrix}1 & 0 \\ 0 & 1\end{bmatrix} + 2\begin{bmatrix}\frac{1}{2} & \frac{1}{2}" in shown
    assert r"e^{-t}\cos(2t)\begin{bmatrix}1 & 0 \\ 0 & 1\end{bmatrix} + e^{-t}\sin(2t)" in shown
    wrong = term_by_term(resolvent_matrix(A), s, t, sp.ImmutableMatrix(Phi * 2), discrete=False)
    assert any(check.status == "failed" for check in check_steps(wrong))
