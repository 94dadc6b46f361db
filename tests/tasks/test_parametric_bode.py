"""Bode's form with parameters: textbook forms, numbers put in, corruptions, what must be assumed."""

from __future__ import annotations

import pytest
import sympy as sp

from solver.derivation import Status
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict
from tests.tasks.test_stability_margins import loop_of, plant

s = sp.Symbol("s")
R, C, K, tau, natural = sp.symbols("R C K tau omega_n", positive=True)
u = sp.Symbol("u")


def asked(G):
    return ask("bode", plant(G))


@pytest.mark.parametrize(
    ("G", "gain", "corners", "slopes"),
    [
        (1 / (R * C * s + 1), 1, [1 / (R * C)], [0, -20]),
        (K / (s * (tau * s + 1)), K, [1 / tau], [-20, -40]),
        (K * (s + 3 * tau) / (s + tau) ** 2, 3 * K / tau, [tau, tau, 3 * tau], [0, -40, -20]),
        (K * (1 - tau * s) / (1 + tau * s), K, [1 / tau, 1 / tau], [0, 0]),
        (K / (s**2 + natural**2), K / natural**2, [natural], [0, -40]),
        (natural**2 / (s**2 + natural * s + natural**2), 1, [natural], [0, -40]),
        (K / s**2, K, [], [-40]),
        (u / (s + 1), u, [1], [0, -20]),
    ],
)
def test_forms_of_a_first_course(G, gain, corners, slopes):
    result = asked(G)
    if G.has(u):  # the phase begins elsewhere
        assert "sign" in result.reason.kind
        return
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["bode_gain"] - gain) == 0
    assert result.answers["corner_frequencies"] == corners
    assert result.answers["slopes"] == slopes


@pytest.mark.parametrize(
    ("G", "says"),
    [
        (K / ((s + 1) * (tau * s + 1)), "comes first"),
        (1 / (s + u), "the sign of $u$"),
        (1 / (s**2 + K * s + 1), "the sign of"),
        (1 / (s**3 + K * s + 1), "no closed form"),
    ],
)
def test_what_is_open_says_what_must_be_known(G, says):
    result = asked(G)
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)


def test_the_form_stays_where_the_order_of_corners_is_open():
    assert [step.kind for step in asked(K / ((s + 1) * (tau * s + 1))).steps][-1] == "form"


def test_corrupted_answers_with_parameters_are_rejected():
    G = K * (s + 3 * tau) / (s + tau) ** 2
    found, loop = asked(G).answers, loop_of(G)
    assert not rejected("bode", loop, dict(found))
    for name, each in (
        ("bode_gain", 3 * K), ("bode_gain", -found["bode_gain"]), ("corner_frequencies", [tau, 3 * tau]),
        ("corner_frequencies", [1 / tau, 1 / tau, 3 * tau]), ("slopes", [0, -20, -40]), ("slopes", [0, 20, 0]),
    ):  # fmt: skip
        corrupted = [sp.S.Zero + x for x in each] if isinstance(each, list) else each
        assert rejected("bode", loop, {name: corrupted}), (name, each)


PROBLEM = """
assume: {K: positive, a: positive, b: positive}
conditions: [a < b]
system: {transfer_function: K(s + a)/(s + b)}
find: {a: bode}
"""


@pytest.mark.parametrize(
    ("name", "value", "right"),
    [
        ("bode_gain", "K a/b", True),
        ("bode_gain", "K", False),
        ("corner_frequencies", "[a, b]", True),
        ("corner_frequencies", "[a, 2b]", False),
        ("slopes", "[0, 20, 0]", True),
        ("slopes", "[0, -20, 0]", False),
    ],
)
def test_marking_where_a_condition_orders_the_corners(name, value, right):
    judged = verdict(PROBLEM, "a", name, value)
    assert (judged.verdict == "correct") is right, judged.reason
