"""Pulse transfer functions: textbooks, simulated loops, delays, corruptions, marking, refusals."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.signal import tf2ss

from solver.derivation import Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import DeadTime
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.fractions_of_polynomials import plant
from tests.helpers.marked import verdict

s, z = sp.symbols("s z")
T, a = sp.symbols("T a", positive=True)
K = sp.Symbol("K", real=True)
ONE, HALF = sp.Integer(1), sp.Rational(1, 2)
MOTOR = plant(1, s**2 + s)


def values(G, points=(0.3 + 0.8j, -1.7, 2.2)):
    return [complex(G.subs(z, point)) for point in points]


def same(G, H):
    at = dict.fromkeys((G.free_symbols | H.free_symbols) - {z}, 0.7)
    return np.allclose(values(G.subs(at)), values(H.subs(at)), rtol=1e-9)


E, E2, E1 = sp.exp(-T), sp.exp(-2 * T), sp.exp(-1)


@pytest.mark.parametrize(
    ("G", "options", "wanted"),
    [  # Ogata, Discrete-Time Control Systems, examples 3–4 to 3–7, 4–2; Kuo, Digital Control Systems, chapter 3
        (MOTOR, {"sample_time": ONE}, (E1 * z + 1 - 2 * E1) / ((z - 1) * (z - E1))),
        (MOTOR, {"sample_time": ONE, "feedback": ONE}, (E1 * z + 1 - 2 * E1) / (z**2 - z + 1 - E1)),
        (plant(1, s + a), {"sample_time": T}, (1 - sp.exp(-a * T)) / (a * (z - sp.exp(-a * T)))),
        (plant(1, s**2), {"sample_time": T}, T**2 * (z + 1) / (2 * (z - 1) ** 2)),
        (plant(1, s**2), {"sample_time": T, "hold": "none"}, T * z / (z - 1) ** 2),
        (plant(1, (s + 1) * (s + 2)), {"sample_time": T, "hold": "none"}, z * (E - E2) / ((z - E) * (z - E2))),
        (plant(1, s + 1), {"sample_time": T, "delay": 2 * T}, (1 - E) / (z**2 * (z - E))),
        (plant(1, s**2 + 1), {"sample_time": sp.pi}, 2 / (z + 1)),
        (plant(1, s + 1), {"sample_time": T, "controller": K, "feedback": ONE}, K * (1 - E) / (z - E + K * (1 - E))),
    ],
)
def test_results_of_the_textbooks(G, options, wanted):
    result = ask("pulse_transfer_function", G, **{"hold": "zero_order", **options})
    assert result.status is Status.VERIFIED, result.reason
    assert same(result.answers["G"], wanted)


def test_the_steps():
    found = ask("pulse_transfer_function", MOTOR, sample_time=T, hold="zero_order", controller=K, feedback=1 / (s + 2))
    told = ("hold", "sampled", "result", "in_series", "between_samplers", "closed")
    assert [step.kind for step in found.steps if step.kind in told] == [
        "hold", "sampled", "result", "in_series", "between_samplers", "hold", "sampled", "result", "closed",
    ]  # fmt: skip
    alone = ask("pulse_transfer_function", MOTOR, sample_time=T, hold="zero_order").steps
    assert [step.kind for step in alone[-3:]] == ["sampled", "result", "sampled_apart"]


def simulated(top, bottom, period, delay, controller, count):
    """The outputs at the samples of the loop with unity feedback after a unit step, by solve_ivp between the events."""
    A, B, C, _ = tf2ss(*[np.array(sp.Poly(side, s).all_coeffs(), dtype=float) for side in (top, bottom)])
    c, d = controller
    x, outputs, inputs, errors = np.zeros(len(A)), [], [], []
    for k in range(count):
        outputs.append(float((C @ x)[0]))
        errors.append(1.0 - outputs[-1])
        inputs.append(c[0] * errors[k] + (c[1] * errors[k - 1] - d * inputs[k - 1] if k else 0.0))
        now, times = k * period, sorted({0.0, period, *(_inside(delay, period))})
        for begin, end in pairwise(times):
            at = (now + (begin + end) / 2 - delay) / period
            u = inputs[int(np.floor(at))] if at >= 0 else 0.0
            x = solve_ivp(lambda _, y, u=u: A @ y + B[:, 0] * u, (begin, end), x, rtol=1e-10, atol=1e-12).y[:, -1]
    return outputs


def _inside(delay, period):
    rest = delay - period * np.floor(delay / period)
    return [rest] if 1e-9 < rest < period - 1e-9 else []


@settings(max_examples=4, deadline=None)
@given(st.integers(1, 4), st.integers(0, 4), st.integers(0, 3), st.sampled_from([1, 2, 3, 5]), st.booleans())
def test_the_loop_does_what_a_simulation_does(gain, b, c, quarters, repeated):
    bottom = (s + 1) ** 2 if repeated else s**2 + b * s + c
    G, period, delay = plant(gain, bottom), sp.Rational(1, 4), sp.Rational(quarters, 8)
    C = (z - HALF) / (z + sp.Rational(1, 5))
    options = {"sample_time": period, "delay": delay, "controller": C, "feedback": ONE, "hold": "zero_order"}
    result = ask("pulse_transfer_function", G, **options)
    assert result.status is Status.VERIFIED, result.reason
    theirs = simulated(sp.sympify(gain), sp.expand(bottom), 0.25, quarters / 8, ((1.0, -0.5), 0.2), 9)
    above, below = (sp.Poly(side, z).all_coeffs() for side in sp.fraction(sp.together(result.answers["G"])))
    above = [0.0] * (len(below) - len(above)) + [float(sp.N(x)) for x in above]
    below = [float(sp.N(x)) for x in below]
    ours, step = [], []
    for k in range(9):
        fresh = sum(above[: k + 1])
        ours.append((fresh - sum(below[i] * ours[k - i] for i in range(1, min(k, len(below) - 1) + 1))) / below[0])
        step.append(fresh)
    assert np.allclose(ours, theirs, rtol=1e-6, atol=1e-8)


def test_a_dead_time_below_a_period_that_is_a_symbol():
    text = (
        "system: {transfer_function: 1/(s + 1)}\nconditions: [0 < L < T]\n"
        "find: {a: {task: pulse_transfer_function, sample_time: T, delay: L}}\n"
    )
    (part,) = solve_problem(read_problem(Source("p.yaml", text), catalogue())).parts
    assert part.status is Status.VERIFIED
    G = part.answers["G"].subs({x: value for x in part.answers["G"].free_symbols
                                for name, value in (("L", 0.3), ("T", 1)) if x.name == name})  # fmt: skip
    wanted = (1 - np.exp(-0.7) + (np.exp(-0.7) - np.exp(-1)) / z) / (z - np.exp(-1))
    assert np.allclose(values(G), values(wanted))


def test_a_dead_time_of_the_plant_and_one_beside_it_add_up():
    late = DeadTime(plant(1, s + 1), sp.Rational(1, 10))
    both = ask("pulse_transfer_function", late, sample_time=HALF, delay=sp.Rational(2, 5), hold="zero_order")
    one = ask("pulse_transfer_function", plant(1, s + 1), sample_time=HALF, delay=HALF, hold="zero_order")
    assert same(both.answers["G"], one.answers["G"])


def test_several_channels():
    found = ask("pulse_transfer_function", plant([(1, s + 1), (1, s)]), sample_time=ONE, hold="zero_order")
    assert found.status is Status.VERIFIED
    assert same(found.answers["G"][0, 1], 1 / (z - 1))


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"hold": "none"},
        {"delay": sp.Rational(1, 3)},
        {"controller": 2 * z / (z - HALF), "feedback": ONE},
        {"feedback": 1 / (s + 2)},
    ],
)
def test_corrupted_answers_are_rejected(options):
    asked = {"sample_time": HALF, "hold": "zero_order", **options}
    G = ask("pulse_transfer_function", MOTOR, **asked).answers["G"]
    assert not rejected("pulse_transfer_function", MOTOR, {"G": G}, **asked)
    for corrupted in (G * sp.Rational(1001, 1000), G / z, G + sp.Rational(1, 100)):
        assert rejected("pulse_transfer_function", MOTOR, {"G": corrupted}, **asked)


MARKED = """
system: {transfer_function: 1/(s(s + 1))}
find:
  a: {task: pulse_transfer_function, sample_time: 1/2}
  b: {task: pulse_transfer_function, sample_time: 1/2, hold: none}
  c: {task: pulse_transfer_function, sample_time: 1, system: {transfer_function: 1/(s + 1)}, feedback: 1/s}
"""


@pytest.mark.parametrize(
    ("part", "value", "slip"),
    [
        ("a", "z (1 - e^(-1/2))/((z - 1)(z - e^(-1/2)))", "hold_left_out"),
        ("a", "z ((e^(-1/2) - 1/2) z + 1 - 3/2*e^(-1/2))/((z - 1)^2 (z - e^(-1/2)))", "difference_left_out"),
        ("a", "1/2*(1 - e^(-1/2))/((z - 1)(z - e^(-1/2)))", "product_of_transforms"),
        ("a", "(e^(-1)*z + 1 - 2e^(-1))/((z - 1)(z - e^-1))", "period_left_out"),
        ("b", "z^2/((z - 1)(z - e^(-1/2)))", "product_of_transforms"),
        ("b", "((e^(-1/2) - 1/2) z + 1 - 3/2*e^(-1/2))/((z - 1) (z - e^(-1/2)))", "hold_added"),
        ("c", "(1 - e^-1) (z - 1)/((z - e^-1)(z - 1) + (1 - e^-1) z)", "product_of_transforms"),
    ],
)
def test_mistakes_are_named(part, value, slip):
    found = verdict(MARKED, part, "G", f'"{value}"')
    assert (found.verdict, found.mistake) == ("wrong", slip)


def test_forms_in_z_and_in_its_inverse_are_right():
    for value in ("(0.106531 z + 0.0902040)/(z^2 - 1.606531z + 0.606531)",
                  "(0.106531 z^-1 + 0.0902040 z^-2)/(1 - 1.606531 z^-1 + 0.606531 z^-2)"):  # fmt: skip
        assert verdict(MARKED, "a", "G", f'"{value}"').verdict == "correct"


def fault(options):
    text = "system: {transfer_function: 1/(s + 1)}\nfind:\n  a: {task: pulse_transfer_function, " + options + "}\n"
    with pytest.raises(InputError) as caught:
        read_problem(Source("p.yaml", text), catalogue())
    return caught.value.diagnostics[0]


def test_what_cannot_be_is_refused_at_its_place():
    found = fault("sample_time: 1, controller: 1/s")
    assert (found.line, "written in z" in found.message) == (3, True)
    assert "hold" in fault("sample_time: 1, hold: zoh").message
    task = catalogue()["pulse_transfer_function"]
    for options, words in (
        ({}, "the sampling period is not given"),
        ({"sample_time": ONE, "delay": -ONE}, "not negative"),
        ({"sample_time": ONE, "feedback": sp.ImmutableMatrix([[1]])}, "one input and one output"),
    ):
        ((_, reason),) = task.refused(MOTOR, {"hold": "zero_order", **options})
        assert words in str(reason)


@pytest.mark.parametrize(
    ("G", "options", "words"),
    [
        (plant(s + 2, s + 1), {"hold": "none"}, "strictly proper"),
        (plant(0, s + 1), {}, "nothing to be sampled"),
        (plant(1, s + 1), {"delay": sp.Symbol("L", positive=True)}, "left open"),
        (plant(1, s + 1), {"controller": z**2}, "before they are asked"),
    ],
)
def test_what_has_no_answer_says_why(G, options, words):
    result = ask("pulse_transfer_function", G, **{"sample_time": ONE, "hold": "zero_order", **options})
    assert result.status is Status.UNSOLVED
    assert words in str(result.reason)
