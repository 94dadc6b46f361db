"""Transfer functions with a dead time: responses begin later by it; what has no finite number of states is refused."""

import numpy as np
import pytest
import sympy as sp
from scipy.signal import lsim, lti

import solver
from solver.derivation import Status
from solver.problem.source import InputError
from solver.systems import DeadTime, LateInput
from tests.helpers.asking import ask, rejected, system
from tests.helpers.fractions_of_polynomials import plant, s

t = sp.Symbol("t")
T = sp.Symbol("T", positive=True)
METHODS = ("laplace", "convolution")


def late(top, bottom, delay):
    return DeadTime(plant(sp.sympify(top), sp.sympify(bottom)), sp.sympify(delay))


def response(G, u, method="laplace", **options):
    return ask("response", G, method, kind="zero_state", input=(sp.sympify(u),), **options)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("G", "u", "expected"),
    [
        (late(1, s + 1, 2), 1, (1 - sp.exp(2 - t)) * sp.Heaviside(t - 2)),
        (late(1, s + 1, T), 1, (1 - sp.exp(T - t)) * sp.Heaviside(t - T)),
        (late(2, s, 3), t, (t - 3) ** 2 * sp.Heaviside(t - 3)),
        (late(1, s + 2, 1), sp.DiracDelta(t), sp.exp(2 - 2 * t) * sp.Heaviside(t - 1)),
        (late(1, s + 2, 1), sp.Heaviside(t - 1), (1 - sp.exp(4 - 2 * t)) / 2 * sp.Heaviside(t - 2)),
        (late(3, 1, T), t, 3 * (t - T) * sp.Heaviside(t - T)),
        (late(s, s + 1, 1), 1, sp.exp(1 - t) * sp.Heaviside(t - 1)),
    ],
)
def test_the_response_is_the_delayed_one(G, u, expected, method):
    result = response(G, u, method)
    assert result.status is Status.VERIFIED, result.reason
    difference = sp.expand(sp.expand_power_exp(sp.expand(result.answers["y"] - expected)))
    at = {T: sp.Rational(3, 2)}
    assert all(abs(sp.N(difference.subs(at).subs(t, time))) < 1e-12 for time in (sp.Rational(1, 2), 2.25, 5.5))


def test_scipys_simulation_is_the_same_but_later():
    result = response(late(s + 3, s**2 + 2 * s + 5, sp.Rational(1, 2)), sp.sin(t))
    times = np.linspace(0, 6, 601)
    _, undelayed, _ = lsim(lti([1, 3], [1, 2, 5]), np.sin(times), times)
    y = sp.lambdify(t, result.answers["y"].rewrite(sp.Piecewise), "numpy")
    assert np.allclose(y(times[51:]), undelayed[1:-50], atol=1e-3)
    assert np.allclose(y(times[:50]), 0)


def test_limit_and_peak_come_later_too():
    result = response(late(1, s**2 + 2 * s + 2, 2), 1)
    assert (result.answers["y_final"], result.answers["t_peak"]) == (sp.Rational(1, 2), 2 + sp.pi)
    assert sp.expand(result.answers["y_peak"] - (1 + sp.exp(-sp.pi)) / 2) == 0
    assert [step.kind for step in result.steps[:2]] == ["split", "transformed_output"]


LAG = system([[-1]], B=[[1]], C=[[1]])
PAIR = system([[0, 1], [-2, -2]], B=[[0], [1]], C=[[1, 0]])


@pytest.mark.parametrize("delay", [1, 3])
def test_another_dead_time_is_rejected(delay):
    G, other = LateInput(LAG, sp.Integer(2)), LateInput(LAG, sp.Integer(delay))
    answers = dict(response(G, 1).answers)
    wrong = response(other, 1).answers
    asked = {"kind": "zero_state", "input": (sp.Integer(1),)}
    assert not rejected("response", G, answers, **asked)
    for name in ("x", "y"):
        assert rejected("response", G, {name: wrong[name]}, **asked)
        assert rejected("response", G, {name: response(LAG, 1).answers[name]}, **asked)


def test_a_wrong_time_of_the_peak_is_rejected():
    G, asked = LateInput(PAIR, sp.Integer(2)), {"kind": "zero_state", "input": (sp.Integer(1),)}
    assert not rejected("response", G, {"t_peak": 2 + sp.pi}, **asked)
    assert rejected("response", G, {"t_peak": sp.pi}, **asked)


FILE = "title: t\nsystem: {{transfer_function: '{G}'}}\nfind: {{a: {{task: {task}}}}}\n"
STEP = "response, kind: zero_state, input: 1"


@pytest.mark.parametrize(
    ("G", "y"),
    [
        ("exp(-2s)/(s + 1)", (1 - sp.exp(2 - t)) * sp.Heaviside(t - 2)),
        ("1/((s + 1)exp(2s))", (1 - sp.exp(2 - t)) * sp.Heaviside(t - 2)),
        ("exp(-3s) exp(s)/(s + 1)", (1 - sp.exp(2 - t)) * sp.Heaviside(t - 2)),
        ("e^(-T s)/(s + 1)", (1 - sp.exp(T - t)) * sp.Heaviside(t - T)),
        ("exp(-T s)", sp.Heaviside(t - T)),
    ],
)
def test_ways_of_writing_it(G, y):
    found = solver.solve(FILE.format(G=G, task=STEP))
    assert found.status == "verified"
    given = {symbol: sp.Symbol(symbol.name) for symbol in (y - found.answers["a"]["y"]).free_symbols}
    assert sp.expand((found.answers["a"]["y"] - y).xreplace(given)) == 0


@pytest.mark.parametrize(
    ("G", "task", "words"),
    [
        ("exp(-2s)/(s + 1)", "realization", "no quotient of polynomials"),
        ("exp(-2s)/(s + 1)", "stability", "no finite number of states"),
        ("exp(-2s)/(s + 1)", "minimal_realization", "no quotient of polynomials"),
        ("exp(2s)/(s + 1)", STEP, "later, not earlier"),
        ("(1 - exp(-s))/s", STEP, "part of a sum"),
        ("exp(-s^2)/(s + 1)", STEP, "a number or name times s"),
        ("exp((a - b)s)/(s + 1)", STEP, "is positive"),
    ],
)
def test_what_is_refused_with_its_reason(G, task, words):
    with pytest.raises(InputError) as fault:
        solver.solve(FILE.format(G=G, task=task))
    assert words in fault.value.render()


def test_a_loop_around_a_dead_time_is_unsolved_with_the_reason():
    found = solver.solve(FILE.format(G="exp(-2s)/(s + 1)", task=f"{STEP}, feedback: unity"))
    assert found.status == "unsolved"
    assert "infinitely many poles" in found.parts[0].reason


@pytest.mark.parametrize("key", ["transfer_matrix: [[exp(-s)/(s + 1), 1/s]]", "polynomial: 's + exp(-s)'"])
def test_other_kinds_have_no_dead_time(key):
    with pytest.raises(InputError, match="dead time"):
        solver.solve(f"title: t\nsystem: {{{key}}}\nfind: {{a: {{task: characteristic_polynomial}}}}\n")
