"""Margins of loops: textbook values, samples by numpy, corruptions, marking, what is refused."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.systems import DeadTime, OpenLoop, TransferFunction
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict

s, K = sp.symbols("s K")


def plant(G, delay=0):
    top, bottom = (sp.Poly(each, s).as_expr() for each in sp.fraction(sp.together(G)))
    rational = TransferFunction(sp.ImmutableMatrix([[sp.cancel(G)]]), ((top,),), ((bottom,),), s)
    return DeadTime(rational, sp.sympify(delay)) if delay else rational


def margins(G, delay=0):
    return ask("stability_margins", plant(G, delay))


def loop_of(G, delay=0):
    """The loop as the task gets it."""
    rational = plant(G)
    one = sp.Integer(1)
    return OpenLoop(rational, rational, sp.sympify(delay), one, sp.cancel(G), one)


@pytest.mark.parametrize(
    ("G", "wanted"),
    [
        (8 / (s + 1) ** 3, (sp.sqrt(3), sp.sqrt(3), 1, 0, 0, False)),
        (2 / (s - 1), (sp.sqrt(3), 0, sp.Rational(1, 2), None, 60, True)),
        (sp.sqrt(2) / (s * (s + 1)), (1, sp.oo, sp.oo, sp.oo, 45, True)),
        (1 / (2 * (s + 1)), (sp.oo, sp.oo, sp.oo, sp.oo, sp.oo, True)),
        (2 / s**2, (sp.sqrt(2), sp.sqrt(2), 1, 0, 0, False)),
        (2 * (1 - s) / ((s + 1) * (s + 2)), (sp.oo, sp.sqrt(5), sp.Rational(3, 2), None, sp.oo, True)),
    ],
)
def test_margins_that_are_exact(G, wanted):
    result = margins(G)
    assert result.status is Status.VERIFIED
    names = ("gain_crossover", "phase_crossover", "gain_margin", "gain_margin_db", "phase_margin", "stable")
    for name, value in zip(names, wanted, strict=True):
        assert value is None or result.answers[name] == value, name


def test_the_steps_are_those_of_the_board():
    result = margins(10 / (s * (s + 1) * (s + 5)))
    assert [step.kind for step in result.steps][:5] == [
        "on_axis", "gain_crossovers", "phase", "phase_crossovers", "gain_margin",
    ]  # fmt: skip
    equation = next(step for step in result.steps if step.kind == "gain_crossovers").values
    w = equation["w"]
    assert sp.expand(equation["p"] - (w**3 + 26 * w**2 + 25 * w - 100)) == 0
    assert result.answers["phase_crossover"] == sp.sqrt(5)
    assert result.answers["gain_margin"] == 3
    assert abs(float(result.answers["phase_margin"]) - 25.3898) < 1e-4


def test_dead_times():
    result = margins(1 / s, 1)
    assert result.status is Status.VERIFIED
    assert result.answers["phase_crossover"] == sp.pi / 2
    assert result.answers["gain_margin"] == sp.pi / 2
    assert abs(float(result.answers["phase_margin"]) - (90 - 180 / np.pi)) < 1e-12
    late = margins(3 / (s + 1), 2).answers  # several crossings; the nearest to −1 does not tell of stability
    assert not late["stable"]
    assert abs(float(late["gain_margin"]) - 1.38992271058) < 1e-9


def test_of_several_crossovers_the_nearest_decides():
    result = margins(5 * (s**2 + 4) / (s * (s + 1) * (s**2 + 9)))
    assert abs(float(result.answers["phase_margin"]) - 15.954159909) < 1e-8
    assert result.answers["phase_crossover"] == sp.oo
    conditional = margins(2 * (s + 1) ** 2 / s**3).answers
    assert conditional["stable"]
    assert conditional["gain_margin"] == sp.Rational(1, 4)


def test_hidden_poles_count():
    loop = ask("stability_margins", plant((s + 2) / ((s - 1) * (s + 3))), controller=(s - 1) / (s + 2))
    assert loop.answers["stable"] is False


@settings(max_examples=15, deadline=None)
@given(
    st.lists(st.integers(1, 6), min_size=1, max_size=3),
    st.lists(st.integers(-4, 5).filter(bool), max_size=1),
    st.integers(0, 2),
    st.integers(1, 40),
)
def test_generated_loops_meet_the_definition(poles, zeros, integrators, gain):
    D = s**integrators * sp.prod(s + p for p in poles)
    N = gain * sp.prod(s + z for z in zeros)
    result = margins(N / D)
    if result.status is Status.UNSOLVED:
        return
    assert result.status is Status.VERIFIED
    found = result.answers
    L = sp.lambdify(s, N / D, "numpy")
    omega = np.geomspace(1e-4, 1e4, 200_001)
    sizes = np.abs(L(1j * omega)) - 1
    crossings = omega[:-1][sizes[:-1] * sizes[1:] <= 0]
    if found["gain_crossover"] == sp.oo:
        assert not len(crossings)
    else:
        at = float(found["gain_crossover"])
        assert min(abs(crossings - at)) < 1e-3 * at
        assert abs(np.angle(-L(1j * at), deg=True) - float(found["phase_margin"])) % 360 < 1e-6
    poles_of_loop = np.roots([float(c) for c in sp.Poly(sp.expand(N + D), s).all_coeffs()])
    if abs(poles_of_loop.real).min() > 1e-6:
        assert found["stable"] == bool((poles_of_loop.real < 0).all())


@pytest.mark.parametrize(("G", "delay"), [(10 / (s * (s + 1) * (s + 5)), 0), (1 / s, 1), (3 / (s + 1), 2)])
def test_corrupted_answers_are_rejected(G, delay):
    found, loop = margins(G, delay).answers, loop_of(G, delay)
    assert not rejected("stability_margins", loop, dict(found))
    for name, value in found.items():
        corrupted = [not value] if name == "stable" else [value * sp.Rational(1001, 1000), -value, sp.oo, 1 / value]
        for each in corrupted:
            assert each == value or rejected("stability_margins", loop, {name: each}), (name, each)
    assert not rejected("stability_margins", loop, {"phase_margin": found["phase_margin"] - 360})


def test_what_no_one_frequency_decides_is_refused():
    for G, kind in (
        ((1 - s) / (1 + s), "everywhere"), (plant((s + 1) / (s + 3), 1), "feedthrough"),
        (plant(K / (s + 1), 1), "parameters"),
    ):  # fmt: skip
        result = ask("stability_margins", G if not isinstance(G, sp.Expr) else plant(G))
        assert result.status is Status.UNSOLVED
        assert kind in result.reason.kind


PROBLEM = "system: {transfer_function: 10/(s(s + 1)(s + 5))}\nfind: {a: stability_margins}\n"


@pytest.mark.parametrize(
    ("name", "value", "right", "words"),
    [
        ("gain_margin", "3", True, ""),
        ("gain_margin_db", "9.54", True, ""),
        ("phase_margin", "25.4", True, ""),
        ("phase_margin", "385.39", True, ""),  # a full turn more
        ("phase_crossover", "sqrt(5)", True, ""),
        ("phase_margin", "25.39°", True, ""),
        ("gain_margin_db", "9.54 dB", True, ""),
        ("phase_margin", "0.4431", False, "radians"),
        ("phase_margin", "-154.61", False, "180"),
        ("gain_margin_db", "4.771", False, "20 log"),
        ("gain_margin", "9.54", False, "dB"),
        ("gain_margin_db", "3.00", False, ""),
        ("gain_margin", "0.3333", False, "1/|L|"),
        ("gain_crossover", "0.19529", False, "Hz"),
        ("phase_crossover", "1.227", False, "exchanged"),
        ("stable", "no", False, ""),
    ],
)
def test_marking(name, value, right, words):
    sheet = verdict(PROBLEM, "a", name, value)
    assert (sheet.verdict == "correct") is right
    assert words in sheet.reason
