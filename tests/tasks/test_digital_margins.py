"""Margins of discrete loops: values known in other ways, samples by numpy, corruptions, marking, what is refused."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.systems import OpenLoop, TransferFunction
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict

z = sp.Symbol("z")
R = sp.Rational


def plant(numerator, denominator, sample_time=1):
    N, D = sp.expand(sp.sympify(numerator)), sp.expand(denominator)
    matrix = sp.ImmutableMatrix([[sp.cancel(N / D)]])
    return TransferFunction(matrix, ((N,),), ((D,),), z, discrete=True, sample_time=sp.sympify(sample_time))


def loop_of(*given_):
    """The loop as the task gets it."""
    rational = plant(*given_)
    one = sp.Integer(1)
    return OpenLoop(rational, rational, sp.Integer(0), one, rational.matrix[0, 0], one)


@pytest.mark.parametrize(
    ("loop", "wanted"),
    [
        # 1/(3z²(z − 1)): ∠L = −2ωT − 90° − ωT/2 is −180° at ωT = 36°, where |e^{jωT} − 1| = 2 sin 18°
        ((1, 3 * z**2 * (z - 1)), (sp.acos(R(17, 18)), sp.pi / 5, 6 * sp.sin(sp.pi / 10), True)),
        # 6/5/(z + 1/2) is real at z = −1 only: |L| = 12/5 there
        ((R(6, 5), z + R(1, 2), R(1, 5)), (5 * sp.acos(R(19, 100)), 5 * sp.pi, R(5, 12), False)),
        ((R(1, 4), z - R(1, 2)), (sp.oo, sp.pi, 6, True)),
        # two delays and no dynamics: |L| = 1/2 throughout, L = −1/2 at 90°
        ((R(1, 2), z**2, R(1, 2)), (sp.oo, sp.pi, 2, True)),
        ((z + 1, 8 * (z - 1) * (z - R(1, 2))), (None, sp.pi / 3, 4, True)),  # no crossing at z = −1, a zero
    ],
)
def test_values_known_in_other_ways(loop, wanted):
    result = ask("stability_margins", plant(*loop))
    assert result.status is Status.VERIFIED
    gain_crossover, phase_crossover, gain_margin, stable = wanted
    answers = result.answers
    for name, value in (
        ("gain_crossover", gain_crossover), ("phase_crossover", phase_crossover), ("gain_margin", gain_margin)
    ):  # fmt: skip
        if value is not None:
            assert answers[name] == value or abs(sp.N(answers[name] - value, 20)) < 1e-18
    assert answers["stable"] is stable


def test_the_phase_margin_of_an_integrator_with_a_delay():
    """L = K/(z − 1): |L| = 1 where 2 sin(ωT/2) = K, and ∠L = −90° − ωT/2."""
    answers = ask("stability_margins", plant(1, z - 1, R(1, 10))).answers
    assert answers["gain_crossover"] == 10 * sp.pi / 3
    assert answers["phase_margin"] == 60
    assert answers["gain_margin"] == 2


def test_steps_say_where_the_crossings_are_and_what_the_hold_costs():
    result = ask("stability_margins", plant(R(2, 100) * (z + R(95, 100)), (z - 1) * (z - R(9, 10)), R(1, 10)))
    kinds = [step.kind for step in result.steps]
    assert kinds[:5] == ["on_axis", "gain_crossovers", "phase", "phase_crossovers", "gain_margin"]
    told = {step.kind: step.values for step in result.steps}
    assert [row["end"] for row in told["phase_crossovers"]["roots"]] == [False, True]
    hold = float(told["picture"]["hold"])
    assert abs(hold + np.degrees(float(result.answers["gain_crossover"]) * 0.05)) < 1e-9


factors = st.sampled_from([z - 1, z - R(1, 2), z - R(9, 10), z, z + R(1, 2), z - R(3, 2), z**2 - z + R(1, 2)])
above = st.sampled_from([sp.Integer(1), z - R(1, 3), z + R(9, 10), z + 2, z**2 + R(1, 4)])
loops = st.tuples(
    above, st.lists(factors, min_size=1, max_size=3).map(sp.prod), st.sampled_from([R(1, 10), R(1, 2), 1, 3])
).filter(lambda each: sp.degree(each[0], z) < sp.degree(each[1], z))


@settings(max_examples=12, deadline=None)
@given(loops, st.sampled_from([R(1, 10), 1]))
def test_generated_margins_are_those_of_samples(found, T):
    numerator, denominator, gain = found
    result = ask("stability_margins", plant(gain * numerator, denominator, T))
    assert result.status in (Status.VERIFIED, Status.UNSOLVED)
    if result.status is Status.UNSOLVED:
        return
    N, D = (np.array(sp.Poly(p, z).all_coeffs(), dtype=float) for p in (gain * numerator, denominator))
    theta = np.linspace(1e-4, np.pi, 400_001)
    L = np.polyval(N, np.exp(1j * theta)) / np.polyval(D, np.exp(1j * theta))
    crossings = theta[:-1][np.diff(np.sign(np.abs(L) - 1)) != 0] / float(T)
    ours = result.answers["gain_crossover"]
    if ours != sp.oo:
        assert np.min(np.abs(crossings - float(ours))) < 1e-4 / float(T)
    else:
        assert len(crossings) == 0
    closed = np.polyadd(D, np.pad(N, (len(D) - len(N), 0)))
    assert result.answers["stable"] is bool(np.max(np.abs(np.roots(closed))) < 1 - 1e-9)


LOOP = (1, 3 * z**2 * (z - 1), R(1, 10))


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        ("gain_crossover", sp.acos(R(17, 18))),  # in rad a sample
        ("gain_crossover", sp.oo),
        ("phase_crossover", 10 * sp.pi),  # the other one, at the Nyquist frequency
        ("gain_margin", sp.Integer(6)),
        ("gain_margin_db", sp.Integer(3)),
        ("phase_margin", sp.Integer(42)),
        ("stable", False),
    ],
)
def test_corrupted_answers_are_rejected(name, wrong):
    right = ask("stability_margins", plant(*LOOP)).answers[name]
    assert not rejected("stability_margins", loop_of(*LOOP), {name: right})
    assert rejected("stability_margins", loop_of(*LOOP), {name: wrong})


PROBLEM = """
title: M
system: {time: discrete, sample_time: 1/10, transfer_function: 1/(3z^2(z - 1))}
find:
  a: {task: stability_margins}
"""


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("gain_crossover", "0.334896", "rad per sample"),
        ("phase_margin", "-29.7034", "T is missing"),
        ("gain_margin", "5.363", "dB"),
        ("phase_crossover", "31.416", "several crossovers"),
        ("phase_crossover", "1", None),
    ],
)
def test_mistakes_have_names(name, value, says):
    sheet = verdict(PROBLEM, "a", name, value)
    assert sheet.verdict != "correct"
    assert (says or "") in sheet.reason


@pytest.mark.parametrize("task", ["stability_margins", "frequency_response"])
def test_a_loop_without_its_period_is_refused_with_a_hint(task):
    declared = catalogue()[task]
    system = replace(plant(1, z - R(1, 2)), sample_time=None)
    ((place, reason),) = declared.refused(system, {})
    assert place == ""
    assert "give `sample_time` beside `time: discrete`" in str(reason)
