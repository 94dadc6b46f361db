"""Nyquist's criterion: textbook loops, poles by numpy, corruptions, marking, what is refused."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict
from tests.helpers.said import page_of
from tests.tasks.test_stability_margins import loop_of, plant

s = sp.Symbol("s")


def asked(G, delay=0):
    return ask("nyquist", plant(G, delay))


@pytest.mark.parametrize(
    ("G", "delay", "counts", "crossings"),
    [
        (10 / (s * (s + 1) * (s + 5)), 0, (0, 0, 0), [sp.Rational(-1, 3)]),
        (60 / (s * (s + 1) * (s + 5)), 0, (2, 0, 2), [-2]),
        (2 / (s - 1), 0, (-1, 1, 0), []),
        (1 / (2 * (s - 1)), 0, (0, 1, 1), []),
        (2 * (s + 1) ** 2 / s**3, 0, (0, 0, 0), [-4]),
        (10 * (s + 2) / (s**2 * (s + 1) * (s + 20)), 0, (2, 0, 2), []),
        (5 / ((s**2 + 4) * (s + 1)), 0, (2, 0, 2), []),
        (1 / s, 1, (0, 0, 0), None),
        (3 / (s + 1), 2, (2, 0, 2), None),
    ],
)
def test_turns_of_the_textbooks(G, delay, counts, crossings):
    result = asked(G, delay)
    assert result.status is Status.VERIFIED
    names = ("encirclements", "open_loop_unstable_poles", "closed_loop_unstable_poles")
    assert tuple(result.answers[name] for name in names) == counts
    assert result.answers["stable"] is (counts[2] == 0)
    assert crossings is None or result.answers["real_axis_crossings"] == crossings


@settings(max_examples=8, deadline=None)
@given(
    st.lists(st.integers(-3, 5).filter(bool), min_size=1, max_size=3),
    st.lists(st.integers(-3, 5).filter(bool), max_size=1),
    st.integers(0, 2),
    st.integers(1, 30),
)
def test_generated_loops_have_the_poles_of_numpy(poles, zeros, integrators, gain):
    D = sp.expand(s**integrators * sp.prod(s + p for p in poles))
    N = sp.expand(gain * sp.prod(s + z for z in zeros))
    result = asked(N / D)
    if result.status is Status.UNSOLVED:
        assert result.reason.kind in ("frequency/through_minus_one", "conversions/ill_posed_direct_path")
        return
    assert result.status is Status.VERIFIED
    reduced = [sp.Poly(p, s) for p in sp.fraction(sp.cancel(N / D))]
    roots = np.roots([float(c) for c in (reduced[0] + reduced[1]).all_coeffs()])
    outside = int((roots.real > 1e-9).sum())
    P = int((np.roots([float(c) for c in reduced[1].all_coeffs()]).real > 1e-9).sum())
    assert result.answers["encirclements"] == outside - P


def test_through_minus_one_is_refused():
    result = asked(8 / (s + 1) ** 3)
    assert result.status is Status.UNSOLVED
    assert "through_minus_one" in result.reason.kind
    assert result.steps[-1].kind == "through"


@pytest.mark.parametrize(("G", "delay"), [(60 / (s * (s + 1) * (s + 5)), 0), (2 / (s - 1), 0), (3 / (s + 1), 2)])
def test_corrupted_answers_are_rejected(G, delay):
    found, loop = asked(G, delay).answers, loop_of(G, delay)
    assert not rejected("nyquist", loop, dict(found))
    for name, value in found.items():
        if name == "real_axis_crossings":
            corrupted = [[each * sp.Rational(1001, 1000) for each in value], [*value, sp.Integer(-7)], value[1:]]
        else:
            corrupted = [not value] if name == "stable" else [value + 1, value - 1, -value - 1]
        for each in corrupted:
            assert each == value or rejected("nyquist", loop, {name: each}), (name, each)


PROBLEM = "system: {transfer_function: 60/(s(s + 1)(s + 5))}\nfind: {a: nyquist}\n"


@pytest.mark.parametrize(
    ("name", "value", "right"),
    [
        ("encirclements", "2", True),
        ("encirclements", "-2", False),
        ("closed_loop_unstable_poles", "2", True),
        ("real_axis_crossings", "[-2]", True),
        ("real_axis_crossings", "-2", True),
        ("stable", "no", True),
        ("stable", "yes", False),
    ],
)
def test_marking(name, value, right):
    assert (verdict(PROBLEM, "a", name, value).verdict == "correct") is right


def test_a_number_of_turns_has_the_sign_of_a_formula():
    page = page_of("nyquist", "nyquist", plant(2 * (s + 3) / (s * (s - 1))))
    assert "downward, $-2$ with its mirror image" in page
