"""Loops around a plant: T = C G/(1 + C G H), evaluated at complex points by plain arithmetic."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

import solver
from solver.derivation import CheckStatus, Status, Unsolved
from solver.derivation.conversion import chain_to, composed, conversions, converted, reachable
from solver.engine import solve_problem, yield_into
from solver.lazy import numeric
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import OutputFeedback, StateFeedback, StateSpace, TransferFunction
from solver.tasks import catalogue

s = sp.Symbol("s")
POINT = 0.7 + 1.3j


def plant(p, q):
    return TransferFunction(sp.ImmutableMatrix([[sp.cancel(p / q)]]), ((p,),), ((q,),), s)


def solved(find, system='transfer_function: "1/((s+1)(s+2))"'):
    problem = read_problem(Source("loop.yaml", f"system: {{{system}}}\nfind:\n  a: {find}\n"), catalogue())
    return solve_problem(problem).parts[0]


def value(expression):
    return complex(sp.N(expression.subs(s, POINT)))


polynomials = st.lists(st.integers(-4, 4), min_size=2, max_size=3).filter(lambda c: c[0] != 0)


@settings(max_examples=20)
@given(polynomials, polynomials, st.integers(1, 5), polynomials)
def test_the_loop_is_what_the_formula_gives_at_a_point(q, d, gain, k):
    G, C, H = plant(sp.Integer(gain), sp.Poly(q, s).as_expr()), 3 / sp.Poly(d, s).as_expr(), 1 / sp.Poly(k, s).as_expr()
    steps = []
    T = yield_into(steps, converted(OutputFeedback(G, C, H), ("transfer_function",)))
    g, c, h = value(G.matrix[0, 0]), value(C), value(H)
    assert value(T.numerators[0][0] / T.denominators[0][0]) == pytest.approx(c * g / (1 + c * g * h))
    assert [step.kind for step in steps] == ["forward", "closed"]
    assert all(check.status is CheckStatus.PASSED for check in numeric.check_steps(steps))


def test_what_cancels_in_the_forward_path_stays_a_root_of_the_loop():
    found = solved("{task: stability, controller: (s-1)/(s+5), feedback: unity}", 'transfer_function: "1/((s-1)(s+2))"')
    assert found.answers["verdict"] == "unstable"
    assert 1 in found.answers["eigenvalues"]
    assert found.answers["bibo_stable"]


@pytest.mark.parametrize(
    ("find", "G"),
    [
        ("{task: transfer_function, controller: 2, feedback: unity}", 2 / (s**2 + 3 * s + 4)),
        ("{task: transfer_function, controller: 2, feedback: none}", 2 / (s**2 + 3 * s + 2)),
        ("{task: transfer_function, feedback: 1/(s+3)}", (s + 3) / ((s + 1) * (s + 2) * (s + 3) + 1)),
        ("{task: transfer_function, controller: 1 + s, feedback: 2}", 1 / (s + 4)),
    ],
)
def test_controllers_and_feedback_in_their_spellings(find, G):
    found = solved(find)
    assert found.status is Status.VERIFIED
    assert sp.cancel(found.answers["G"] - G) == 0


def test_a_plant_in_state_space_is_taken_as_its_transfer_function():
    found = solved("{task: transfer_function, feedback: unity}", "A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]")
    assert sp.cancel(found.answers["G"] - 1 / (s**2 + 3 * s + 3)) == 0


def test_several_channels_are_multiplied_in_the_order_of_the_formula():
    found = solved(
        "{task: transfer_function, controller: 2, feedback: unity}", "transfer_matrix: [[1/s, 1/(s+1)], [0, 2/s]]"
    )
    G = np.array([[1 / POINT, 1 / (POINT + 1)], [0, 2 / POINT]])
    expected = 2 * G @ np.linalg.inv(np.eye(2) + 2 * G)
    assert found.status is Status.VERIFIED
    assert np.allclose(np.array(found.answers["G"].subs(s, POINT).evalf().tolist(), dtype=complex), expected)


@pytest.mark.parametrize(
    ("find", "system", "says"),
    [
        ("{task: stability, controller: '-(s+1)(s+2)', feedback: unity}", None, "ill-posed"),
        ("{task: realization, controller: s^3}", None, "improper"),
        ("{task: transfer_function, feedback: -1}", "transfer_matrix: [[1, 0], [0, 1/s]]", "ill-posed"),
    ],
)
def test_a_loop_that_makes_no_sense_is_refused_in_words(find, system, says):
    found = solved(find, *([system] if system else []))
    assert found.status is Status.UNSOLVED
    assert says in str(found.reason)


def test_the_controller_must_be_a_quotient_of_polynomials():
    with pytest.raises(InputError, match="a quotient of polynomials in s is expected here"):
        solved("{task: stability, controller: exp(-s)}")


@pytest.mark.parametrize(
    ("find", "says"),
    [
        ("{task: stability, controller: none}", "'none' cannot stand for the controller"),
        ("{task: stability, controller: unity, feedback: unity}", "'unity' cannot stand for the controller"),
        ("{task: stability, feedback: None}", "'None' cannot stand for the feedback"),
        ("{task: stability, feedback: negative}", "'negative' cannot stand for the feedback"),
        ("{task: stability, gain: none}", "leave the key out where there is nothing"),
    ],
)
def test_words_that_mean_no_parameter_are_refused(find, says):
    with pytest.raises(InputError, match=says):
        solved(find, "A: [[-1]], B: [1], C: [1]")


@pytest.mark.parametrize("system", ['transfer_function: "1/(s+1)"', "transfer_matrix: [[1/(s+1), 2], [1/s, 1]]"])
@pytest.mark.parametrize("loop", ["controller: 2/(s+3)", "feedback: none", "controller: 2, feedback: 1/(s+2)"])
def test_the_page_names_what_the_question_is_about(system, loop):
    document = solver.solve(f"system: {{{system}}}\nfind:\n  a: {{task: transfer_function, {loop}}}\n")
    assert document.parts[0].status is Status.VERIFIED, document.parts[0].rows
    assert not document.parts[0].unchecked


@pytest.mark.parametrize(("B", "K"), [([[0], [1]], [[1]]), ([[0], [1]], [[1], [2]]), (None, [[1, 2]])])
def test_a_gain_that_does_not_fit_closes_no_loop(B, K):
    plant = StateSpace(sp.ImmutableMatrix([[0, 1], [0, 0]]), B and sp.ImmutableMatrix(B))
    with pytest.raises(Unsolved) as refused:
        yield_into([], converted(StateFeedback(plant, sp.ImmutableMatrix(K)), ("A",)))
    assert refused.value.reason.kind == "conversions/gain_does_not_fit"


def test_what_no_way_leads_to_is_named_without_what_can_be_had():
    with pytest.raises(Unsolved) as refused:
        yield_into([], converted(StateSpace(sp.ImmutableMatrix([[1]])), ("A", "transfer_function")))
    assert refused.value.reason.values["missing"] == ["transfer_function"]


def test_the_chain_is_the_shortest_and_a_loop_closes_around_the_inner_one():
    G = plant(sp.Integer(1), s**2)
    assert chain_to(G, ("transfer_function",)) == ()
    assert [each.target for each in chain_to(G, ("A", "B"))] == [StateSpace]
    assert [each.target for each in chain_to(OutputFeedback(G, s, None), ("A",))] == [TransferFunction, StateSpace]
    assert chain_to(StateSpace(sp.ImmutableMatrix([[1]])), ("transfer_function",)) is None
    assert {"A", "transfer_function"} <= reachable(G)
    K = sp.ImmutableMatrix([[1, 2]])
    both = composed(G, {"gain": K, "controller": s, "feedback": None})
    assert both == OutputFeedback(StateFeedback(G, K), s, None)
    assert len(conversions()) == len({(each.source, each.target) for each in conversions()})


def test_what_cannot_be_converted_says_what_is_missing():
    with pytest.raises(Unsolved, match="needs transfer_function; the system has only A"):
        yield_into([], converted(StateSpace(sp.ImmutableMatrix([[1]])), ("transfer_function",)))
