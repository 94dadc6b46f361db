"""Poles of sampled plants given in s: z = e^{sT} in every task that places poles, refusals, mistakes by name."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from solver.exact.linear_algebra.fields import domain_matrix
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

R = sp.Rational
PAIR = (-2 + 3 * sp.I, -2 - 3 * sp.I)
T = R(1, 10)
PLANT = system([[1, T], [0, 1]], discrete=True, B=[T**2 / 2, T], C=[[1, 0]])


def ordered(values):
    return sorted(values, key=lambda z: (round(z.real, 6), z.imag))


def poles_of(matrix):
    return ordered(np.linalg.eigvals(np.array(matrix.evalf(30).tolist(), dtype=complex)))


def mapped(poles, period):
    return ordered(np.exp([complex(pole) * float(period) for pole in poles]))


@pytest.mark.parametrize("method", ["coefficient_matching", "bass_gura", "canonical_form", "ackermann"])
def test_a_feedback_by_every_method(method):
    result = ask("pole_placement", PLANT, method, s_poles=PAIR, sample_time=T)
    assert result.status is Status.VERIFIED
    assert np.allclose(poles_of(PLANT.A - PLANT.B * result.answers["K"]), mapped(PAIR, T))
    step = next(step for step in result.steps if step.kind == "mapped")
    assert sp.simplify(step.values["found"][0] - sp.exp(PAIR[0] * T)).equals(0)
    assert len(step.claims) == 2


def test_an_observer_and_a_servo():
    result = ask("observer", PLANT, s_poles=PAIR, sample_time=T)
    assert result.status is Status.VERIFIED
    assert np.allclose(poles_of(result.answers["error_A"]), mapped(PAIR, T))
    three = (*PAIR, sp.Integer(-5))
    result = ask("servo", PLANT, s_poles=three, sample_time=T)
    assert result.status is Status.VERIFIED
    assert np.allclose(poles_of(result.answers["closed_loop_A"]), mapped(three, T))
    assert not rejected("servo", PLANT, dict(result.answers), s_poles=three, sample_time=T)
    assert rejected("servo", PLANT, dict(result.answers), s_poles=three, sample_time=2 * T)


def test_specifications_of_a_step_response_are_mapped_too():
    asked = {"damping_ratio": R(1, 2), "settling_time": sp.Integer(2), "sample_time": T}
    result = ask("pole_placement", PLANT, **asked)
    omega = 4.0
    wanted = [-2 + 1j * omega * np.sqrt(0.75), -2 - 1j * omega * np.sqrt(0.75)]
    assert result.status is Status.VERIFIED
    assert np.allclose(poles_of(result.answers["closed_loop_A"]), mapped(wanted, T))


def test_a_symbolic_period_keeps_the_exponentials():
    period, alpha = sp.Symbol("T", positive=True), sp.Symbol("alpha")
    plant = system([[0, 1], [0, 0]], discrete=True, B=[0, 1])
    K = ask("pole_placement", plant, s_poles=(-alpha, -2 * alpha), sample_time=period).answers["K"]
    assert sp.simplify(K[0] - sp.exp(-3 * alpha * period)) == 0
    assert sp.simplify(K[1] + sp.exp(-alpha * period) + sp.exp(-2 * alpha * period)) == 0


@tried(8)
@given(
    st.integers(-5, 0), st.integers(1, 6), st.integers(-4, 1), st.integers(1, 8),
    st.lists(st.lists(st.integers(-2, 2), min_size=3, max_size=3), min_size=3, max_size=3),
)  # fmt: skip
def test_random_poles_are_where_numpy_puts_them(sigma, omega, real, tenths, A):
    poles, period = (sigma + omega * sp.I, sigma - omega * sp.I, sp.Integer(real)), R(tenths, 10)
    result = ask("pole_placement", system(A, discrete=True, B=[1, 0, 2]), s_poles=poles, sample_time=period)
    if result.status is Status.UNSOLVED:
        return
    assert result.status is Status.VERIFIED
    assert np.allclose(poles_of(result.answers["closed_loop_A"]), mapped(poles, period), atol=1e-6)


def test_a_response_that_would_fill_pages_is_not_written_out():
    """With powers of e in three states: nobody could read it, and it took a minute to find."""
    three = system([[0, 0, 1], [1, 0, 0], [0, 1, 0]], discrete=True, B=[1, 0, 2])
    for plant, poles in ((PLANT, PAIR), (three, (*PAIR, sp.Integer(0)))):
        result = ask("pole_placement", plant, s_poles=poles, sample_time=T)
        assert result.status is Status.VERIFIED
        assert ("response" in [step.kind for step in result.steps]) == (plant is PLANT)


FILE = "system: {{A: [[1, 1], [0, 1]], B: [[1/2], [1]], C: [[1, 0]]{more}}}\nfind:\n  a: {{task: {task}, {options}}}\n"


@pytest.mark.parametrize(
    ("more", "task", "options", "said"),
    [
        ("", "pole_placement", "s_poles: [-1, -2]", "continuous time"),
        (", time: discrete", "observer", "s_poles: [-1, -2]", "sampling period is not given"),
        (", time: discrete", "observer", "s_poles: [-1, -2], poles: [0, 0], sample_time: 1", "given twice"),
        (", time: discrete", "observer", "sample_time: 1", "say where the poles"),
        (", time: discrete", "current_observer", "s_poles: [-1], sample_time: 1", "1 pole is given"),
        (", time: discrete", "pole_placement", "s_poles: [-1], sample_time: 1", "2 poles"),
        (", time: discrete", "pole_placement", "overshoot: 10%, peak_time: 1", "sampling period is not given"),
        ("", "servo", "poles: [-1, -2, -3], sample_time: 1", "not sampled"),
        (", time: discrete, sample_time: 2", "servo", "s_poles: [-1, -2, -3], sample_time: 1", "leave one of them out"),
    ],
)
def test_what_cannot_be_mapped_is_refused_with_a_hint(more, task, options, said):
    problem = read_problem(Source("p.yaml", FILE.format(more=more, task=task, options=options)), catalogue())
    part = problem.parts[0]
    faults = [str(reason) for _, reason in catalogue()[task].refused(part.system, part.options)]
    assert any(said in fault for fault in faults), faults


SAMPLED = FILE.format(more=", time: discrete", task="pole_placement", options="s_poles: [-1, -2], sample_time: 1/2")


def gain(*poles):
    """K of the double integrator with T = 1, by comparing coefficients."""
    a, b = -sum(poles), poles[0] * poles[1]
    k1 = 1 + a + b
    return f"[{k1:.6f}, {2 + a - k1 / 2:.6f}]"


@pytest.mark.parametrize(
    ("value", "said"),
    [
        (gain(np.exp(-0.5), np.exp(-1)), ""),
        (gain(np.exp(-1), np.exp(-2)), "sampling period"),
        (gain(-1, -2), "taken for poles in"),
    ],
)
def test_a_missing_period_and_poles_that_are_not_mapped_are_named(value, said):
    found = verdict(SAMPLED, "a", "K", value)
    assert found.verdict == ("wrong" if said else "correct")
    assert said in str(found.reason or "")


def test_observers_of_both_orders_and_their_feedback():
    result = ask("reduced_observer", PLANT, s_poles=(sp.Integer(-5),), sample_time=T)
    assert result.status is Status.VERIFIED
    assert np.isclose(float(result.answers["J"][0]), np.exp(-0.5))
    assert rejected(
        "reduced_observer", PLANT, {"J": sp.ImmutableMatrix([[-5]])}, s_poles=(sp.Integer(-5),), sample_time=T
    )
    for more, count in (({"observer_s_poles": (sp.Integer(-6), sp.Integer(-7))}, 2), ({"reduced": True}, 1)):
        asked = {"s_poles": PAIR, "sample_time": T, "observer_s_poles": (sp.Integer(-6),), **more}
        result = ask("observer_feedback", PLANT, **asked)
        assert result.status is Status.VERIFIED, result.reason
        wanted = mapped([*PAIR, -6, -7][: 2 + count], T)
        assert np.allclose(poles_of(result.answers["closed_loop_A"]), wanted)


def test_powers_of_e_in_one_matrix_depend_on_each_other():
    """sympy takes e and e² for independent; the rank of this matrix is one."""
    M = sp.Matrix([[sp.exp(-1), sp.exp(-2)], [1, sp.exp(-1)]])
    assert domain_matrix(M).rank() == 1
    assert domain_matrix(sp.Matrix([[sp.E, sp.exp(R(1, 3))], [sp.sqrt(2), sp.exp(sp.sqrt(2))]])).rank() == 2
    plant = system([[sp.exp(-1), 0], [0, sp.exp(-2)]], discrete=True, B=[1, sp.exp(-1)], C=[[1, 1]])
    result = ask("pole_placement", plant, poles=(R(0), R(1, 2)))
    assert result.status is Status.VERIFIED
    assert np.allclose(poles_of(result.answers["closed_loop_A"]), [0, 0.5])
