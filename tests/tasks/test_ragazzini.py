"""Direct design: the loop against scipy, a continuous plant between samples, what is refused, corruptions, mistakes."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.signal import dlti, dstep

from solver.derivation import Status
from solver.engine import solve_problem
from solver.exact import admissible_target, direct_design
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import StateSpace, TransferFunction
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict

s, z, a, p = sp.symbols("s z a p")
R = sp.Rational
HALF = R(1, 2) / (z - R(1, 2))


def plant(above, below, x=z):
    above, below = sp.expand(above), sp.expand(below)
    G = sp.ImmutableMatrix([[above / below]])
    return TransferFunction(G, ((above,),), ((below,),), x, discrete=x == z)


def numbers(F):
    return [np.array(sp.Poly(side, z).all_coeffs(), dtype=float) for side in sp.fraction(sp.cancel(F))]


FIRST = plant(R(1, 5), z - R(4, 5))
roots = st.sampled_from([R(-1, 2), R(1, 3), R(4, 5), R(0), R(-9, 10), R(1)])
zeros = st.lists(st.sampled_from([R(-1, 2), R(1, 4), R(-4, 5)]), max_size=1)


@settings(max_examples=10)
@given(
    st.lists(roots, min_size=1, max_size=3, unique=True),
    zeros,
    st.sampled_from([(R(1, 2),), (R(0),), (R(2, 5), R(1, 5))]),
)
def test_the_loop_follows_the_target(of_plant, above, poles):
    top, bottom = sp.prod(z - each for each in above), sp.prod(z - each for each in of_plant)
    system = plant(2 * top, bottom * z ** max(0, len(above) - len(of_plant) + 1))
    result = ask("ragazzini", system, poles=poles)
    assert result.status is Status.VERIFIED
    T, D = result.answers["T"], result.answers["controller"]
    assert T.subs(z, 1) == 1
    closed = sp.cancel(D * system.matrix[0] / (1 + D * system.matrix[0]))
    _, (y,) = dstep(dlti(*numbers(closed), dt=1), n=25)
    _, (wanted,) = dstep(dlti(*numbers(T), dt=1), n=25)
    assert np.allclose(y, wanted)
    assert abs(y[-1, 0] - 1) < 1e-3


def test_the_course_s_question_by_hand():
    """G = 0.2/(z − 0.8), T = 0.5/(z − 0.5): D = 2.5 (z − 0.8)/(z − 1)."""
    result = ask("ragazzini", FIRST, poles=(R(1, 2),))
    assert [step.kind for step in result.steps] == ["plant", "placed", "controller", "cancellations", "loop"]
    assert sp.cancel(result.answers["controller"] - R(5, 2) * (z - R(4, 5)) / (z - 1)) == 0
    (step,) = (step for step in result.steps if step.kind == "cancellations")
    assert step.values["slow"] == [R(4, 5)]
    assert ask("ragazzini", FIRST, target=HALF).answers["controller"] == result.answers["controller"]


def test_missing_poles_are_delays():
    late = plant(1, z**2 * (z - R(1, 2)))
    assert sp.cancel(ask("ragazzini", late, poles=(R(2, 5),)).answers["T"] - R(3, 5) / (z**2 * (z - R(2, 5)))) == 0
    found = ask("ragazzini", late, poles=(), zeros=(R(-1, 2),)).answers["T"]
    assert sp.cancel(found - R(2, 3) * (z + R(1, 2)) / z**4) == 0


def test_ringing_is_warned_about():
    ringing = ask("ragazzini", plant(z + R(9, 10), (z - 1) * (z - R(1, 2))), poles=(R(1, 5),))
    (step,) = (step for step in ringing.steps if step.kind == "cancellations")
    assert step.values["ringing"] == [R(-9, 10)]
    calm = ask("ragazzini", plant(z + R(9, 10), (z - 1) * (z - R(1, 2))), poles=(R(1, 5),), zeros=(R(-9, 10),))
    (step,) = (step for step in calm.steps if step.kind == "cancellations")
    assert step.values["ringing"] == []


def test_a_continuous_plant_is_held_and_sampled():
    """1/(s + 1), T = 0.1 s: the loop followed between its samples by solve_ivp."""
    result = ask("ragazzini", plant(1, s + 1, s), poles=(R(1, 2),), sample_time=R(1, 10))
    assert result.status is Status.VERIFIED
    top, bottom = (np.array([float(c) for c in sp.Poly(side, z).all_coeffs()]) for side in sp.fraction(
        sp.together(result.answers["controller"])))  # fmt: skip
    x, e, u, seen = 0.0, [0.0, 0.0], 0.0, []
    for _ in range(12):
        seen.append(x)
        e = [1 - x, e[0]]
        u = (top[0] * e[0] + top[1] * e[1] - bottom[1] * u) / bottom[0]
        x = solve_ivp(lambda _, y, u=u: -y + u, (0, 0.1), [x], rtol=1e-10, atol=1e-12).y[0, -1]
    assert np.allclose(seen, 1 - 0.5 ** np.arange(12), atol=1e-7)


def test_states_and_symbols():
    system = StateSpace(sp.ImmutableMatrix([[R(4, 5)]]), sp.ImmutableMatrix([[1]]), sp.ImmutableMatrix([[R(1, 5)]]),
                        discrete=True)  # fmt: skip
    assert ask("ragazzini", system, poles=(R(1, 2),)).status is Status.VERIFIED
    a, p = sp.symbols("a p", real=True)
    result = ask("ragazzini", plant(1, z - a), poles=(p,))
    assert result.status is Status.VERIFIED
    (step,) = (step for step in result.steps if step.kind == "cancellations")
    condition = step.values["condition"]
    assert bool(condition.subs({a: 0.5, p: -0.5}))
    assert not bool(condition.subs({a: 1.5, p: 0}))


@pytest.mark.parametrize(
    ("system", "options", "words"),
    [
        (plant(1, z * (z - R(1, 2))), {"target": HALF}, "not causal"),
        (FIRST, {"target": z / (2 * z - 1)}, "not causal"),
        (plant(z - R(3, 2), (z - R(1, 2)) * z), {"poles": (R(1, 2),)}, "numerator"),
        (plant(z + 1, (z - R(1, 2)) * z), {"poles": (R(1, 2),)}, "numerator"),
        (plant(1, z - 2), {"poles": (R(1, 2),)}, "denominator"),
        (plant(1, (z - 1) ** 2), {"poles": (R(1, 2),)}, "denominator"),
        (FIRST, {"target": R(1, 2) / (z - R(3, 2))}, "would not be stable"),
        (FIRST, {"poles": (R(1),)}, "z = 1"),
        (FIRST, {"poles": (R(1, 2),), "zeros": (R(1),)}, "z = 1"),
        (FIRST, {"target": sp.Integer(1)}, "1 - T = 0"),
        (plant((z - 3), (z - 3) * (z - R(1, 2))), {"poles": (R(1, 2),)}, "in common"),
        (plant(0, z - R(1, 2)), {"poles": (R(1, 2),)}, "is zero"),
    ],
)
def test_what_is_refused(system, options, words):
    result = ask("ragazzini", system, **options)
    assert result.status is Status.UNSOLVED
    assert words in str(result.reason)


@pytest.mark.parametrize(
    ("above", "below"),
    [
        (z - R(3, 2), (z - 2) * (z - R(2, 5))),
        (sp.Integer(1), (z - 1) ** 2 * (z - 3)),
        ((z + 1) * (z - R(1, 3)), z**2 * (z**2 + 4)),
        (z - 2, z**3),
    ],
)
def test_the_target_that_is_proposed_works(above, below):
    T = admissible_target((above, sp.expand(below)), (sp.Integer(1), -R(1, 2)), z)
    assert sp.cancel(T).subs(z, 1) == 1
    result = ask("ragazzini", plant(above, below), target=sp.cancel(T))
    assert result.status is Status.VERIFIED
    found = direct_design((above, sp.expand(below)), T, z)
    assert all(abs(root) < 1 for p in (found.cancelled_zeros, found.cancelled_poles) if len(p) > 1
               for root in np.roots([float(c) for c in p]))  # fmt: skip
    assert "T(z) =" in str(ask("ragazzini", plant(above, below), poles=(R(1, 2),)).reason)


def test_corrupted_answers_are_rejected():
    options = {"poles": (R(1, 2),)}
    D, T = (ask("ragazzini", FIRST, **options).answers[name] for name in ("controller", "T"))
    assert not rejected("ragazzini", FIRST, {"controller": sp.expand(D), "T": T}, **options)
    for wrong in (-D, 2 * D, D / z, D * z, T / FIRST.matrix[0], T / (1 - T), D + 1, D.subs(z, 1 / z)):
        assert rejected("ragazzini", FIRST, {"controller": wrong}, **options), wrong
    for wrong in (T / z, 2 * T, 1 / (z - R(1, 2)), T * z):
        assert rejected("ragazzini", FIRST, {"T": wrong}, **options), wrong


def test_a_controller_that_hides_a_growing_mode_is_rejected():
    """T/(G (1 − T)) solves the loop's equation, but it cancels a pole at 2."""
    system = plant(1, z - 2)
    D = sp.cancel(HALF / (1 - HALF) * (z - 2))
    assert rejected("ragazzini", system, {"controller": D}, target=HALF)


MARKED = """
system: {time: discrete, transfer_function: 0.2/(z - 0.8)}
find:
  a: {task: ragazzini, poles: [0.5]}
"""


@pytest.mark.parametrize(
    ("name", "value", "found"),
    [
        ("controller", "(2.5z - 2)/(z - 1)", ("correct", None)),
        ("controller", "(2.5 - 2z^-1)/(1 - z^-1)", ("correct", None)),
        ("controller", "2.5(z - 0.8)/(z - 0.5)", ("wrong", "without_rest")),
        ("controller", "2.5(z - 0.8)/z", ("wrong", "plus_for_minus")),
        ("controller", "0.5/(z - 1)", ("wrong", "without_plant")),
        ("T", "0.5/(z - 0.5)", ("correct", None)),
        ("T", "1/(z - 0.5)", ("wrong", "gain_of_target")),
        ("T", "0.5/(z (z - 0.5))", ("wrong", "delays_of_target")),
    ],
)
def test_marking(name, value, found):
    told = verdict(MARKED, "a", name, value)
    assert (told.verdict, told.mistake or None) == found


HELD = "system: {transfer_function: 1/(s + 1)}"
PLANT = "system: {time: discrete, transfer_function: 1/(z - 0.8)}"


def refused(text):
    with pytest.raises(InputError) as found:
        solve_problem(read_problem(Source("problem.yaml", text), catalogue()))
    return str(found.value)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (PLANT + "\nfind: {a: {task: ragazzini}}", "the closed loop is not described"),
        (PLANT + "\nfind: {a: {task: ragazzini, poles: [0.5], target: 0.5/(z - 0.5)}}", "say the same"),
        (PLANT + "\nfind: {a: {task: ragazzini, poles: [j]}}", "conjugate"),
        (HELD + "\nfind: {a: {task: ragazzini, poles: [0.5]}}", "sampling period"),
        (
            "system: {transfer_function: 1/(s + 1)}\nfind: {a: {task: ragazzini, sample_time: 1, target: 1/(s + 1)}}",
            "z",
        ),
    ],
)
def test_bad_questions_are_told(text, words):
    assert words in refused(text)
