"""Controllability and observability: three tests that agree, steps, independent sources, corruptions, refusals."""

import control
import numpy as np
import pytest
import scipy.linalg
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

import solver
from solver.derivation import Status
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import eigenvalues, jordan_block, unimodular
from tests.helpers.tried import tried

NOTE = system([[-2, -2, -2], [1, 0, 0], [1, 1, -1]], B=[1, 0, 0], C=[[1, 1, 0]])  # lecture note, 2.6 example 2
TWO_INPUTS = system([[0, 1, 0], [0, 0, 1], [-1, -2, -1]], B=[[1, 0], [0, 1], [0, 0]], C=[[1, 0, 0], [0, 1, 0]])
METHODS = ("rank", "pbh", "gramian")


def floats(M):
    return np.array(M, dtype=float)


@st.composite
def plants(draw):
    """A plant with a chosen hidden part, in other coordinates: repeated and defective eigenvalues, several inputs."""
    seen, hidden, m = draw(st.integers(1, 3)), draw(st.integers(0, 3)), draw(st.integers(1, 2))
    n = seen + hidden
    small = st.integers(-2, 2)
    A = sp.zeros(n)
    A[:seen, :] = sp.Matrix(seen, n, lambda i, j: draw(small))
    position = seen
    while position < n:
        size = draw(st.integers(1, n - position))
        A[position : position + size, position : position + size] = jordan_block(draw(eigenvalues), size)
        position += size
    B = sp.zeros(n, m)
    B[:seen, :] = sp.Matrix(seen, m, lambda i, j: draw(small))
    T = draw(unimodular(n))
    return system(T * A * T.inv(), B=T * B, C=sp.eye(n)[:1, :])


@given(plants())
@tried(20)
def test_rank_and_hautus_agree_with_each_other_and_with_numpy(plant):
    by_rank, by_pbh = ask("controllability", plant, "rank"), ask("controllability", plant, "pbh")
    assert by_rank.status is by_pbh.status is Status.VERIFIED, (by_rank.reason, by_pbh.reason)
    assert by_rank.answers == by_pbh.answers
    expected = control.ctrb(floats(plant.A), floats(plant.B))
    assert np.allclose(floats(by_rank.answers["controllability_matrix"]), expected)
    assert by_rank.answers["rank"] == np.linalg.matrix_rank(expected, tol=1e-7)
    assert len(by_rank.answers["uncontrollable_modes"]) == plant.order - by_rank.answers["rank"]


@given(plants())
@tried(15)
def test_observability_is_controllability_of_the_transposed_plant(plant):
    dual = system(plant.A.T, B=plant.B[:, :1], C=plant.B.T)
    direct, turned = ask("controllability", plant), ask("observability", dual)
    assert turned.status is Status.VERIFIED, turned.reason
    assert turned.answers["observability_matrix"] == direct.answers["controllability_matrix"].T
    assert turned.answers["unobservable_modes"] == direct.answers["uncontrollable_modes"]


def test_steps_of_the_rank_test_with_a_hidden_mode():
    result = ask("controllability", NOTE, "rank")
    assert [step.kind for step in result.steps] == [
        *["matrix", "determinant", "reduction", "verdict", "annihilator", "motion"],
    ]
    assert result.answers["controllability_matrix"] == sp.Matrix([[1, -2, 0], [0, 1, -2], [0, 1, -2]])
    assert (result.answers["determinant"], result.answers["rank"], result.answers["controllable"]) == (0, 2, False)
    assert result.answers["uncontrollable_modes"] == [-1]
    assert result.steps[-2].values["N"] == sp.Matrix([[0, -1, 1]])


def test_hautus_treats_a_conjugate_pair_once():
    result = ask("observability", NOTE, "pbh")
    at = [step for step in result.steps if step.kind == "eigenvalue"]
    assert [step.values["value"] for step in at] == [-1, -1 + sp.sqrt(3) * sp.I]
    assert [step.values["rank"] for step in at] == [2, 3]
    assert at[0].values["unreached"].cols == 1


def test_hautus_takes_the_whole_eigenspace_of_a_repeated_eigenvalue():
    plant = system(sp.diag(-1, -1, -1), B=[[1, 0], [0, 1], [1, 1]], C=[[1, 0, 0]])
    result = ask("controllability", plant, "pbh")
    (at,) = [step for step in result.steps if step.kind == "eigenvalue"]
    assert (at.values["rank"], at.values["count"]) == (2, 1)
    assert result.answers["uncontrollable_modes"] == [-1]


def test_a_hidden_chain_counts_with_its_multiplicity():
    plant = system([[-1, 1, 0], [0, -1, 0], [0, 0, -1]], B=[0, 0, 1], C=[[0, 1, 1]])
    for method in METHODS:
        assert ask("controllability", plant, method).answers["uncontrollable_modes"] == [-1, -1]
        assert ask("observability", plant, method).answers["unobservable_modes"] == [-1, -1]


def test_hautus_where_the_input_widens_the_field():
    plant = system([[0, 1], [2, 0]], B=[1, sp.sqrt(2)], C=[[1, 0]])
    for method in ("rank", "pbh"):
        assert ask("controllability", plant, method).answers["uncontrollable_modes"] == [-sp.sqrt(2)]


def test_eigenvalues_in_decimals():
    A = sp.diag(sp.Matrix([[0, 1, 0], [0, 0, 1], [-1, -1, 0]]), 1)
    result = ask("controllability", system(A, B=[0, 0, 0, 1], C=[[1, 0, 0, 0]]), "pbh")
    assert result.status is Status.VERIFIED
    assert len(result.answers["uncontrollable_modes"]) == 3


def test_several_inputs_have_no_determinant():
    for method in METHODS:
        result = ask("controllability", TWO_INPUTS, method)
        assert result.status is Status.VERIFIED
        assert "determinant" not in result.answers
        assert result.answers["controllable"] is True
        assert result.answers["uncontrollable_modes"] == []


@pytest.mark.parametrize(("task", "sign"), [("controllability", "c"), ("observability", "o")])
def test_infinite_gramians_are_python_controls(task, sign):
    for plant in (NOTE, TWO_INPUTS):
        result = ask(task, plant, "gramian")
        state_space = control.ss(floats(plant.A), floats(plant.B), floats(plant.C), 0)
        solve = scipy.linalg.solve_continuous_lyapunov
        A, B, C = (np.array(M) for M in (state_space.A, state_space.B, state_space.C))
        expected = solve(A, -B @ B.T) if sign == "c" else solve(A.T, -C.T @ C)
        assert np.allclose(floats(result.answers["gramian"]), expected)


def test_discrete_gramians():
    plant = system([[0, 1], [-sp.Rational(1, 4), sp.Rational(1, 2)]], B=[0, 1], C=[[1, 1]], discrete=True)
    W = ask("controllability", plant, "gramian").answers["gramian"]
    A, B = floats(plant.A), floats(plant.B)
    assert np.allclose(floats(W), scipy.linalg.solve_discrete_lyapunov(A, B @ B.T))
    W = ask("controllability", plant, "gramian", horizon=sp.Integer(9)).answers["gramian"]
    powers = [np.linalg.matrix_power(A, k) @ B for k in range(9)]
    assert np.allclose(floats(W), sum(v @ v.T for v in powers))


def test_fewer_steps_than_states_do_not_decide():
    plant = system([[0, 1], [0, 0]], B=[0, 1], C=[[1, 0]], discrete=True)
    result = ask("controllability", plant, "gramian", horizon=sp.Integer(1))
    assert result.status is Status.VERIFIED
    assert result.answers["gramian"] == sp.Matrix([[0, 0], [0, 1]])
    assert result.answers["controllable"] is True


def test_a_finite_gramian_of_a_plant_that_is_not_stable():
    T = sp.Symbol("T", positive=True)
    plant = system([[0, 1], [0, 0]], B=[0, 1], C=[[1, 0]])
    assert ask("controllability", plant, "gramian", horizon=T).answers["gramian"] == sp.Matrix(
        [[T**3 / 3, T**2 / 2], [T**2 / 2, T]]
    )
    W = ask("observability", plant, "gramian", horizon=T).answers["gramian"]
    assert sp.expand(W - sp.Matrix([[T, T**2 / 2], [T**2 / 2, T**3 / 3]])) == sp.zeros(2)


@pytest.mark.parametrize("rows", [[[0, 1], [-5, -2]], [[1, 1], [0, 1]], [[0, 1], [-4, 0]], [[0, 1], [1, 1]]])
def test_finite_gramians_agree_with_van_loans_exponential(rows):
    plant = system(rows, B=[[1, 0], [1, 2]], C=[[1, 0]])
    W = ask("controllability", plant, "gramian", horizon=sp.Rational(3, 2)).answers["gramian"]
    A, B = floats(plant.A), floats(plant.B)
    E = scipy.linalg.expm(1.5 * np.block([[-A, B @ B.T], [np.zeros((2, 2)), A.T]]))
    assert np.allclose(floats(W.evalf()), E[2:, 2:].T @ E[:2, 2:])


@pytest.mark.parametrize("task", ["controllability", "observability"])
def test_the_gramian_over_all_time_needs_a_stable_plant(task):
    for plant in (system([[1]], B=[1], C=[[1]]), system([[0, 1], [-4, 0]], B=[0, 1], C=[[1, 0]])):
        result = ask(task, plant, "gramian")
        assert result.status is Status.UNSOLVED
        assert "left half plane" in str(result.reason)
    result = ask(task, system([[1]], B=[1], C=[[1]], discrete=True), "gramian")
    assert "unit circle" in str(result.reason)


@pytest.mark.parametrize("horizon", [0, -1, sp.oo])
def test_a_horizon_that_is_no_time_is_refused(horizon):
    plant = system([[1]], B=[1], C=[[1]])
    assert list(catalogue()["controllability"].refused(plant, {"horizon": sp.S(horizon)}))
    assert list(catalogue()["controllability"].refused(plant, {"horizon": sp.S(2)})) == []


def test_a_discrete_horizon_is_a_number_of_steps():
    plant = system([[1]], B=[1], C=[[1]], discrete=True)
    assert list(catalogue()["observability"].refused(plant, {"horizon": sp.Rational(1, 2)}))


def test_parameters_give_the_generic_verdict_and_its_exceptions():
    a, b = sp.symbols("a b", real=True)
    result = ask("controllability", system([[-a, 1], [0, -2]], B=[[a, b], [1, 0]], C=[[1, b]]), "rank")
    assert result.status is Status.VERIFIED
    assert result.answers["controllable"] is True
    assert result.answers["exceptions"] == [sp.And(sp.Eq(b, 0), sp.Eq(a**2 - 2 * a - 1, 0))]
    result = ask("observability", system([[-a, 1], [0, -2]], B=[1, 1], C=[[1, b]]), "rank")
    assert result.answers["exceptions"] == [sp.Eq(a * b - 2 * b + 1, 0)]


def test_assumptions_exclude_exceptions():
    m = sp.Symbol("m", positive=True)
    assert ask("controllability", system([[0, 1], [0, 0]], B=[0, 1 / m], C=[[1, 0]])).answers["exceptions"] == []


def test_corrupted_answers_are_rejected_one_by_one():
    for task, verdict in (("controllability", "controllable"), ("observability", "observable")):
        answers = ask(task, NOTE, "gramian").answers
        matrix, modes = f"{task}_matrix", f"un{verdict}_modes"
        for name, value in answers.items():
            assert not rejected(task, NOTE, {name: value})
        for name, corrupted in {
            matrix: [-answers[matrix], answers[matrix].T, answers[matrix] * 2, answers[matrix][:, [1, 0, 2]]],
            "determinant": [sp.Integer(1)],
            "rank": [sp.Integer(3), sp.Integer(1)],
            verdict: [True],
            modes: [[], [sp.Integer(1)], [sp.Integer(-1)] * 2, [sp.Rational(-1001, 1000)]],
            "gramian": [-answers["gramian"], answers["gramian"] * 2, answers["gramian"] + sp.eye(3)],
        }.items():
            for wrong in corrupted:
                value = sp.ImmutableMatrix(wrong) if isinstance(wrong, sp.MatrixBase) else wrong
                assert rejected(task, NOTE, {name: value}), (name, wrong)


def test_corrupted_exceptions_are_rejected():
    a, b = sp.symbols("a b", real=True)
    plant = system([[2, a - 1], [0, 2]], B=[1, a], C=[[1, b]])
    right = [sp.Eq(a, 1), sp.Eq(a, 0)]
    assert not rejected("controllability", plant, {"exceptions": right})
    for wrong in ([], right[:1], [*right, sp.Eq(a, 2)], [sp.Eq(a, 1), sp.Eq(a, -1)]):
        assert rejected("controllability", plant, {"exceptions": wrong})


def test_a_finite_gramian_is_judged_by_its_integral():
    plant, horizon = system([[0, 1], [-5, -2]], B=[0, 1], C=[[1, 0]]), sp.Integer(1)
    W = ask("controllability", plant, "gramian", horizon=horizon).answers["gramian"]
    assert not rejected("controllability", plant, {"gramian": W}, horizon=horizon)
    assert rejected("controllability", plant, {"gramian": W * 2}, horizon=horizon)
    assert rejected("controllability", plant, {"gramian": W}, horizon=sp.Integer(2))


PLANTS_3 = {
    ("stated", "minors", "terms"): system([[1, 0, -1], [1, 2, 1], [2, 2, 3]], B=[1, 0, 1]),
    ("stated", "minors"): system([[-2, -2, -2], [1, 0, 0], [1, 1, -1]], B=[1, 0, 0]),  # every minor is zero
    (): system([[1, 0, 0], [1, -1, 1], [0, 0, -2]], B=[1, 1, 0]),  # so is a row
}
"""Plants with a controllability matrix of order three, by the lines of its determinant."""


@pytest.mark.parametrize("lines", PLANTS_3, ids=len)
def test_a_small_determinant_is_written_out_where_there_is_something_to_write(lines):
    result = ask("controllability", PLANTS_3[lines])
    assert result.status is Status.VERIFIED
    (step,) = (step for step in result.steps if step.kind == "determinant")
    shown = [name for name in step.claims if name == "stated"] + [each.kind for each in step.steps]
    assert tuple(shown) == lines


def test_a_determinant_is_shown_once_and_says_why_it_is_zero():
    text = "title: t\nsystem: {{A: {A}, B: {B}, C: [1, 0, 0]}}\nfind: {{a: {{task: {task}, method: rank}}}}\n"
    A = [[1, 0, 0], [1, -1, 1], [0, 0, -2]]
    page = solver.solve(text.format(A=A, B=[1, 1, 0], task="controllability")).markdown(detail="tutor")
    assert page.count(r"\det \mathcal{C}_o =") == 1
    assert "a row of zeros" in page
    page = solver.solve(text.format(A=A, B=[1, 1, 0], task="observability")).markdown(detail="tutor")
    assert page.count(r"\det \mathcal{O}_v =") == 1
