"""Discrete plants: steps, scipy's numbers, random plants, stability by rules, corruptions, marking, refusals."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.signal import cont2discrete

from solver.derivation import CheckStatus, Status
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import DeadTime
from solver.tasks import catalogue
from tests.helpers.asking import ask, system
from tests.helpers.fractions_of_polynomials import plant
from tests.helpers.marked import marked, solved, verdict

s, z = sp.symbols("s z")
T = sp.Symbol("T", positive=True)
MOTOR = {"A": [[0, 1], [0, -1]], "B": [[0], [1]], "C": [[1, 0]], "D": [[0]]}
RULES = {"forward_euler": "euler", "backward_euler": "backward_diff", "tustin": "bilinear"}
TENTH = sp.Rational(1, 10)


def states(matrices):
    rest = {name: M for name, M in matrices.items() if name != "A"}
    return system(matrices["A"], **rest)


def numbers(M):
    return np.array(sp.Matrix(M).evalf().tolist(), dtype=float)


def by_scipy(matrices, period, method):
    return cont2discrete([np.array(matrices[name], dtype=float) for name in "ABCD"], period, method=method)[:4]


@pytest.mark.parametrize("method", ["zero_order_hold", *RULES])
def test_the_matrices_are_those_of_scipy(method):
    oscillator = {"A": [[0, 1], [-5, -2]], "B": [[0, 1], [1, 0]], "C": [[1, 0]], "D": [[2, 0]]}
    for matrices in (MOTOR, oscillator):
        result = ask("discretization", states(matrices), method, sample_time=TENTH)
        assert result.status is Status.VERIFIED, result.reason
        theirs = by_scipy(matrices, 0.1, RULES.get(method, "zoh"))
        for name, M in zip("ABCD", theirs, strict=True):
            assert np.allclose(numbers(result.answers[name]), M, atol=1e-12)


@pytest.mark.parametrize(
    ("method", "derived"), [("forward_euler", "AB"), ("backward_euler", "BCD"), ("tustin", "ABCD")]
)
def test_each_matrix_that_a_rule_changes_is_derived(method, derived):
    """Forward C and D stay; backward A is the inverse that a step before shows."""
    result = ask("discretization", states(MOTOR), method, sample_time=TENTH)
    (step,) = (step for step in result.steps if step.kind == "matrices")
    assert "".join(step.claims) == derived


def test_a_motor_for_any_period():
    found = ask("discretization", states(MOTOR), sample_time=T)
    E = sp.exp(-T)
    assert [step.kind for step in found.steps[-5:]] == ["exponential", "transition", "held_input", "augmented", "model"]
    assert found.answers["A"] == sp.Matrix([[1, 1 - E], [0, E]])
    assert (found.answers["B"] - sp.Matrix([T - 1 + E, 1 - E])).expand().is_zero_matrix


def test_a_chain_of_integrators_has_a_series_that_ends():
    A = [[0, 1, 0], [0, 0, 1], [0, 0, 0]]
    found = ask("discretization", system(A, B=[[0], [0], [1]]), sample_time=T)
    assert [step.kind for step in found.steps] == ["series", "transition", "held_input", "augmented", "model"]
    assert found.answers["B"] == sp.Matrix([T**3 / 6, T**2 / 2, T])
    assert "C" not in found.answers


@settings(max_examples=8, deadline=None)
@given(
    st.lists(st.integers(-3, 1), min_size=9, max_size=9),
    st.lists(st.integers(-2, 2), min_size=3, max_size=3).filter(any),
    st.sampled_from(["zero_order_hold", "forward_euler", "backward_euler", "tustin"]),
)
def test_random_plants_are_those_of_scipy(entries, column, method):
    matrices = {"A": np.reshape(entries, (3, 3)).tolist(), "B": [[b] for b in column], "C": [[1, 0, 1]], "D": [[1]]}
    result = ask("discretization", states(matrices), method, sample_time=sp.Rational(1, 8))
    assert result.status is Status.VERIFIED, result.reason
    theirs = by_scipy(matrices, 0.125, RULES.get(method, "zoh"))
    for name, M in zip("ABCD", theirs, strict=True):
        assert np.allclose(numbers(result.answers[name]), M, rtol=1e-8, atol=1e-9)


@pytest.mark.parametrize("G", [1 / (s + 1), (s + 2) / (s**2 + 2 * s + 5), 1 / s**2, (s + 3) / (s + 1) ** 2])
@pytest.mark.parametrize("method", ["zero_order_hold", *RULES])
def test_transfer_functions_are_those_of_scipy(G, method):
    top, bottom = sp.fraction(sp.together(G))
    result = ask("discretization", plant(top, sp.expand(bottom)), method, sample_time=sp.Rational(1, 4))
    assert result.status is Status.VERIFIED, result.reason
    pair = [np.array(sp.Poly(side, s).all_coeffs(), dtype=float) for side in (top, bottom)]
    above, below, _ = cont2discrete(tuple(pair), 0.25, method=RULES.get(method, "zoh"))
    for point in (0.3 + 0.8j, -1.7):
        theirs = np.polyval(np.ravel(above), point) / np.polyval(below, point)
        assert complex(result.answers["G"].subs(z, point)) == pytest.approx(theirs, rel=1e-9)


def test_prewarping_keeps_the_frequency():
    G = 1 / (s**2 + s + 4)
    found = ask("discretization", plant(1, s**2 + s + 4), "tustin", sample_time=TENTH, prewarp=sp.Integer(2))
    assert found.status is Status.VERIFIED
    ours = complex(found.answers["G"].subs(z, sp.exp(sp.I / 5)))
    assert ours == pytest.approx(complex(G.subs(s, 2 * sp.I)), rel=1e-12)


@pytest.mark.parametrize(
    ("top", "bottom", "zeros"),
    [
        (sp.Integer(1), s + 1, []),
        (sp.Integer(5), s * (s + 2) * (s + 3), [-1, -1]),
        (s + 2, s**2 + 2 * s + 5, [np.exp(-0.2)]),
        (s, (s + 1) ** 2, [1]),
    ],
)
def test_matched_poles_and_zeros(top, bottom, zeros):
    found = ask("discretization", plant(top, sp.expand(bottom)), "matched", sample_time=TENTH)
    assert found.status is Status.VERIFIED, found.reason
    above, below = (sp.Poly(side, z) for side in sp.fraction(sp.together(found.answers["G"])))
    poles = [np.exp(0.1 * complex(p)) for p in sp.Poly(bottom, s).nroots()]
    assert np.allclose(np.poly(poles), np.array(below.monic().all_coeffs(), dtype=float))
    assert np.allclose(np.poly(zeros), np.array(above.monic().all_coeffs(), dtype=float))
    at = 1e-7
    near = complex(found.answers["G"].subs(z, sp.exp(sp.Float(at * 0.1, 40))))
    assert near == pytest.approx(complex((top / bottom).subs(s, at)), rel=1e-5)


def test_a_plant_in_state_space_is_matched_and_realized():
    found = ask("discretization", states({**MOTOR, "A": [[0, 1], [-2, -3]]}), "matched", sample_time=T).answers
    G = (found["C"] * (z * sp.eye(2) - found["A"]).inv() * found["B"] + found["D"])[0]
    assert abs(complex((G - found["G"]).subs({T: 0.3, z: 0.4 + 1j}))) < 1e-12


@pytest.mark.parametrize(
    ("A", "limit"),
    [
        ([[0, 1], [-2, -3]], sp.Integer(1)),
        ([[0, 1], [-5, -2]], sp.Rational(2, 5)),
        ([[-4, 0], [0, -1]], sp.Rational(1, 2)),
    ],
)
def test_eulers_forward_method_loses_stability_at_the_period_found(A, limit):
    steps = ask("discretization", system(A), "forward_euler", sample_time=T).steps
    assert steps[-1].values["least"] == limit
    for factor, stable in ((0.99, True), (1.01, False)):
        moved = np.eye(2) + float(limit) * factor * np.array(A, dtype=float)
        assert bool(max(abs(np.linalg.eigvals(moved))) < 1) is stable


def test_a_plant_that_is_not_stable_has_no_such_period():
    last = ask("discretization", states(MOTOR), "forward_euler", sample_time=T).steps[-1]
    assert last.values["unstable"] == [0]


@pytest.mark.parametrize("method", ["zero_order_hold", "forward_euler", "backward_euler", "tustin"])
def test_corrupted_matrices_are_rejected(method):
    found = ask("discretization", states({**MOTOR, "D": [[3]]}), method, sample_time=T).answers
    assert not _rejected(states({**MOTOR, "D": [[3]]}), method, found)
    for name in "ABCD":
        for corrupted in (found[name] + sp.ones(*found[name].shape) / 100, 2 * found[name]):
            assert _rejected(states({**MOTOR, "D": [[3]]}), method, {name: sp.ImmutableMatrix(corrupted)})


@pytest.mark.parametrize("method", ["zero_order_hold", "forward_euler", "backward_euler", "tustin", "matched"])
def test_corrupted_transfer_functions_are_rejected(method):
    G = plant(s + 2, s**2 + 4 * s + 3)
    found = ask("discretization", G, method, sample_time=T).answers["G"]
    assert not _rejected(G, method, {"G": found})
    for corrupted in (found * sp.Rational(101, 100), found.subs(T, 2 * T), found * z, found + 1):
        assert _rejected(G, method, {"G": corrupted})


def _rejected(given_system, method, answers):
    task = catalogue()["discretization"]
    asked = task.given(given_system, {"sample_time": T}, method)
    return any(check.status is CheckStatus.FAILED for check in task.verify(asked, answers))


MARKED = """
system: {transfer_function: 1/(s(s + 2))}
find:
  a: {task: discretization, sample_time: 1/2}
  b: {task: discretization, sample_time: 1/2, method: tustin}
  c: {task: discretization, sample_time: 1/2, method: tustin, system: {A: [[0, 1], [0, -2]], B: [0, 1], C: [1, 0]}}
"""


@cache
def right(part):
    return next(each for each in solved(MARKED).parts if each.id == part).answers


@pytest.mark.parametrize(
    ("part", "value", "slip"),
    [
        ("a", "z (1 - e^-1)/(2 (z - 1)(z - e^-1))", "hold_left_out"),
        ("b", "z^2/(8 (z - 1)(z - 1/2))", "backward_euler"),
        ("b", "1/(4z (z - 1))", "forward_euler"),
        ("b", "(z + 1)^2/(8 (z - 1) z)", "period_left_out"),
    ],
)
def test_mistakes_are_named(part, value, slip):
    found = verdict(MARKED, part, "G", value)
    assert found.verdict == "wrong"
    assert found.mistake == slip


def test_right_answers_in_other_forms_are_right():
    assert verdict(MARKED, "a", "G", '"(0.0919699 z + 0.0660603)/((z - 1)(z - 0.3678794))"').verdict == "correct"
    assert verdict(MARKED, "b", "G", '"(z + 1)^2/(24 z^2 - 32 z + 8)"').verdict == "correct"


def test_other_states_with_the_same_transfer_function_are_right():
    found = right("c")
    values = {name: found[name].tolist() for name in "AD"}
    doubled = {"B": (2 * found["B"]).tolist(), "C": (found["C"] / 2).tolist()}
    text = ", ".join(f"{name}: {value}" for name, value in {**values, **doubled}.items())
    verdicts = marked(MARKED, f"answers: {{c: {{{text}}}}}")["c"].answers
    assert {each.verdict for each in verdicts.values()} == {"correct"}


def fault(text):
    with pytest.raises(InputError) as caught:
        read_problem(Source("p.yaml", text), catalogue())
    return caught.value.diagnostics[0].message


def test_what_cannot_be_is_refused():
    discrete = "system: {A: [[1]], time: discrete, sample_time: 1}\nfind:\n  a: discretization\n"
    assert "cannot be asked of a system in discrete time" in fault(discrete)
    negative = "system: {A: [[1]]}\nfind:\n  a: {task: discretization, sample_time: -1}\n"
    assert "sample_time must be positive" in fault(negative)
    task, G = catalogue()["discretization"], plant(1, s + 1)
    for options, words in (
        ({}, "the sampling period is not given"),
        ({"sample_time": TENTH, "prewarp": sp.Integer(-1)}, "a frequency above zero"),
        ({"sample_time": TENTH, "prewarp": sp.Integer(32)}, "below half the sampling frequency"),
    ):
        ((_, reason),) = task.refused(G, options)
        assert words in str(reason)
    late = DeadTime(G, sp.Integer(1))
    assert "zero_order_hold" in str(ask("discretization", late, "tustin", sample_time=TENTH).reason)


@pytest.mark.parametrize(
    ("G", "method", "words"),
    [
        (plant(1, s - 10), "backward_euler", "sends to infinity"),
        (plant(1, s - 20), "tustin", "sends to infinity"),
    ],
)
def test_a_pole_that_a_rule_sends_to_infinity(G, method, words):
    result = ask("discretization", G, method, sample_time=TENTH)
    assert result.status is Status.UNSOLVED
    assert words in str(result.reason)


def test_a_matrix_of_channels_has_no_matched_zeros():
    pair = system([[0, 1], [-2, -3]], B=[[0], [1]], C=[[1, 0], [0, 1]], D=[[0], [0]])
    assert "one by one" in str(ask("discretization", pair, "matched", sample_time=TENTH).reason)
    assert "needs $B$ and $C$" in str(ask("discretization", system([[1]]), "matched", sample_time=TENTH).reason)
