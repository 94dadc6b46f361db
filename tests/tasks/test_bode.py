"""Bode's form and corners: textbook loops, slopes of the curve far from corners, corruptions, marking."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict
from tests.tasks.test_stability_margins import loop_of, plant

s = sp.Symbol("s")


def asked(G, delay=0):
    return ask("bode", plant(G, delay))


@pytest.mark.parametrize(
    ("G", "gain", "corners", "slopes"),
    [
        (100 * (s + 1) / (s * (s + 10) ** 2), 1, [1, 10, 10], [-20, 0, -40]),
        (50 / ((s + 5) * (s**2 + s + 100)), sp.Rational(1, 10), [5, 10], [0, -20, -60]),
        (4 * (1 - s) / ((s + 2) * (s + 4)), sp.Rational(1, 2), [1, 2, 4], [0, 20, 0, -20]),
        (10 / s**2, 10, [], [-40]),
        ((s**2 + 4) / (s + 1) ** 2, 4, [1, 1, 2], [0, -40, 0]),
        (-3 / (s - 1), 3, [1], [0, -20]),
    ],
)
def test_corners_of_the_textbooks(G, gain, corners, slopes):
    result = asked(G)
    assert result.status is Status.VERIFIED
    assert result.answers["bode_gain"] == gain
    assert result.answers["corner_frequencies"] == corners
    assert result.answers["slopes"] == slopes
    assert [step.kind for step in result.steps][-4:] == ["form", "corners", "heights", "picture"]


@settings(max_examples=12, deadline=None)
@given(
    st.lists(st.integers(1, 9), min_size=1, max_size=4),
    st.lists(st.integers(1, 9), max_size=2),
    st.integers(0, 2),
)
def test_slopes_are_those_of_the_curve_far_away(poles, zeros, integrators):
    zeros = zeros[: len(poles)]
    G = sp.prod(s + z for z in zeros) / (s**integrators * sp.prod(s + p for p in poles))
    result = asked(G)
    assert result.status is Status.VERIFIED
    L = sp.lambdify(s, sp.cancel(G), "numpy")
    for slope, at in ((result.answers["slopes"][0], 1e-6), (result.answers["slopes"][-1], 1e6)):
        measured = 20 * np.log10(abs(L(1j * at * 10)) / abs(L(1j * at)))
        assert abs(measured - float(slope)) < 1e-3


def test_corrupted_answers_are_rejected():
    G = 50 * (s + 3) / ((s + 5) * (s**2 + s + 100))
    found, loop = asked(G).answers, loop_of(G)
    assert not rejected("bode", loop, dict(found))
    assert not rejected("bode", loop, {"corner_frequencies": [3, 5, 10, 10]})  # a pair may be listed twice
    for name, each in (
        ("bode_gain", found["bode_gain"] * 2), ("bode_gain", -found["bode_gain"]),
        ("corner_frequencies", [3, 5]), ("corner_frequencies", [3, 5, 11]),
        ("slopes", [0, -20, 0, -40]), ("slopes", [0, 20, 0]),
    ):  # fmt: skip
        corrupted = [sp.Integer(x) for x in each] if isinstance(each, list) else each
        assert rejected("bode", loop, {name: corrupted}), (name, each)


PROBLEM = "system: {transfer_function: 100(s + 1)/(s(s + 20)^2)}\nfind: {a: bode}\n"


@pytest.mark.parametrize(
    ("name", "value", "right", "words"),
    [
        ("bode_gain", "0.25", True, ""),
        ("bode_gain", "100", False, ""),
        ("corner_frequencies", "[1, 20, 20]", True, ""),
        ("slopes", "[-20, 0, -40]", True, ""),
        ("slopes", "[20, 0, 40]", False, "exchanged"),
        ("slopes", "[-10, 0, -20]", False, "20 log"),
    ],
)
def test_marking(name, value, right, words):
    sheet = verdict(PROBLEM, "a", name, value)
    assert (sheet.verdict == "correct") is right
    assert words in sheet.reason
