"""Φ by every method: closed forms of the course, scipy on random systems, agreement, refusals, corruptions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import expm

from solver.derivation import CheckStatus, Status
from tests.helpers.asking import ask, at, rejected, system
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

t, k = sp.symbols("t k")
e = sp.exp
CONTINUOUS = ("laplace", "cayley_hamilton", "modal")
DISCRETE = ("z_transform", "cayley_hamilton", "modal")

COURSE = sp.Matrix([[2 * e(-t) - e(-2 * t), e(-t) - e(-2 * t)], [2 * e(-2 * t) - 2 * e(-t), 2 * e(-2 * t) - e(-t)]])

CLOSED_FORMS = [
    ([[0, 1], [-2, -3]], COURSE),
    ([[0, 1], [0, 0]], sp.Matrix([[1, t], [0, 1]])),
    ([[-1, 0, 0], [0, -1, 0], [1, 0, -1]], e(-t) * sp.Matrix([[1, 0, 0], [0, 1, 0], [t, 0, 1]])),
    ([[0, 1], [-1, 0]], sp.Matrix([[sp.cos(t), sp.sin(t)], [-sp.sin(t), sp.cos(t)]])),
    ([[0, 1], [1, 0]], sp.Matrix([[e(t) + e(-t), e(t) - e(-t)], [e(t) - e(-t), e(t) + e(-t)]]) / 2),
    ([[-2]], sp.Matrix([[e(-2 * t)]])),
]


@pytest.mark.parametrize(("rows", "expected"), CLOSED_FORMS)
@pytest.mark.parametrize("method", ["laplace", "power_series", "cayley_hamilton"])
def test_textbook_closed_forms(rows, expected, method):
    result = ask("state_transition_matrix", system(rows), method)
    assert result.status is Status.VERIFIED, result.reason
    assert (result.answers["Phi"] - expected).expand() == sp.zeros(*expected.shape)


def test_the_truncated_series_of_the_course_example():
    result = ask("state_transition_matrix", system([[0, 1], [-2, -3]]), "power_series", terms=3)
    expected = sp.Matrix([[1 - t**2, t - 3 * t**2 / 2], [-2 * t + 3 * t**2, 1 - 3 * t + 7 * t**2 / 2]])
    assert (result.answers["Phi_truncated"] - expected).expand() == sp.zeros(2)


@pytest.mark.parametrize("terms", [1, 2, 5])
def test_terms_counts_the_identity_as_the_first(terms):
    result = ask("state_transition_matrix", system([[0, 1], [-2, -3]]), "power_series", terms=terms)
    degree = max(sp.degree(entry, t) if entry != 0 else 0 for entry in result.answers["Phi_truncated"])
    assert degree == terms - 1


def test_the_coefficients_of_cayley_hamilton_are_those_of_the_course():
    result = ask("state_transition_matrix", system([[0, 1], [-2, -3]]), "cayley_hamilton")
    alpha = next(step for step in result.steps if step.kind == "coefficients").values["alpha"]
    assert [sp.expand(a - b) for a, b in zip(alpha, (2 * e(-t) - e(-2 * t), e(-t) - e(-2 * t)), strict=True)] == [0, 0]


def test_the_modal_method_names_the_condition_that_fails():
    result = ask("state_transition_matrix", system([[-1, 1], [0, -1]]), "modal")
    assert result.status is Status.UNSOLVED
    assert "multiplicity 2 but only 1 independent eigenvector" in str(result.reason)
    assert result.steps, "the steps up to the refusal stay on the page"


@pytest.mark.parametrize("convention", ["right", "left"])
def test_both_conventions_of_the_modal_matrix(convention):
    result = ask("state_transition_matrix", system([[0, 1], [-2, -3]]), "modal", convention=convention)
    assert (result.answers["Phi"] - COURSE).expand() == sp.zeros(2)
    modal = next(step for step in result.steps if step.kind == "inverse").values["modal"]
    A, Lambda = sp.Matrix([[0, 1], [-2, -3]]), sp.diag(-2, -1)
    if convention == "left":
        assert sp.Matrix(modal) * A == Lambda * sp.Matrix(modal)
    else:
        assert A * sp.Matrix(modal) == sp.Matrix(modal) * Lambda


@tried(30)
@given(systems(6))
def test_all_methods_agree_exactly_and_with_scipy(A):
    plant = system(A)
    results = [ask("state_transition_matrix", plant, method) for method in (*CONTINUOUS, "power_series")]
    solved = [result for result in results if result.status is Status.VERIFIED]
    assert {result.method for result in solved} >= {"laplace", "cayley_hamilton", "power_series"}, [
        r.reason for r in results
    ]
    for result in solved:
        assert result.answers["Phi"] == solved[0].answers["Phi"]
    for time in (0.0, 0.3, 0.9):
        expected = expm(np.array(A, dtype=float) * time)
        scale = max(1.0, np.abs(expected).max())
        assert np.abs(at(solved[0].answers["Phi"], t=time) - expected).max() <= 1e-9 * scale


@tried(15)
@given(systems(5))
def test_discrete_methods_agree_exactly_and_with_matrix_powers(A):
    plant = system(A, discrete=True)
    results = [ask("state_transition_matrix", plant, method) for method in DISCRETE]
    solved = [result for result in results if result.status is Status.VERIFIED]
    assert {result.method for result in solved} >= {"z_transform", "cayley_hamilton"}, [r.reason for r in results]
    for result in solved:
        assert result.answers["Phi"] == solved[0].answers["Phi"]
    for step in range(6):
        difference = at(solved[0].answers["Phi"], k=step) - np.array((sp.Matrix(A) ** step).tolist(), dtype=float)
        assert np.abs(difference).max() <= 1e-9 * max(1.0, np.abs(np.array(A**step, dtype=float)).max())


@tried(20)
@given(systems(4, defective=False), st.sampled_from(["right", "left"]))
def test_the_modal_method_solves_every_diagonalizable_system(A, convention):
    result = ask("state_transition_matrix", system(A), "modal", convention=convention)
    assert result.status is Status.VERIFIED, result.reason


@pytest.mark.parametrize("method", CONTINUOUS)
@pytest.mark.parametrize(
    "rows", [[[0, 1, 0], [0, 0, 1], [-1, -1, 0]], [[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [-3, -1, 2, -1]]]
)
def test_irreducible_factors_are_solved_in_decimals(rows, method):
    result = ask("state_transition_matrix", system(rows), method)
    assert result.status is Status.VERIFIED, result.reason
    assert np.allclose(at(result.answers["Phi"], t=0.7), expm(0.7 * np.array(rows, dtype=float)), rtol=1e-10)


def test_symbolic_parameters_stay_symbols():
    w = sp.Symbol("omega", positive=True)
    result = ask("state_transition_matrix", system([[0, 1], [-w, 0]]), "laplace")
    assert result.status is Status.VERIFIED, result.reason
    r = sp.sqrt(w)
    expected = sp.Matrix([[sp.cos(r * t), sp.sin(r * t) / r], [-r * sp.sin(r * t), sp.cos(r * t)]])
    assert (result.answers["Phi"] - expected).expand() == sp.zeros(2)


def test_an_undecided_discriminant_holds_on_both_sides():
    d, c = sp.symbols("d c", positive=True)
    result = ask("state_transition_matrix", system([[0, 1], [-c, -d]]), "laplace")
    assert result.status is Status.VERIFIED, result.reason
    for values in ({d: 3, c: 1}, {d: 1, c: 4}):
        A = np.array([[0, 1], [-float(values[c]), -float(values[d])]])
        Phi = result.answers["Phi"].subs(values)
        assert np.allclose(at(Phi, t=0.8), expm(0.8 * A), atol=1e-12)


CORRUPTIONS = [
    ("one sign", lambda P: P.applyfunc(lambda entry: entry) * sp.diag(1, -1)),
    ("transposed", lambda P: P.T),
    ("scaled", lambda P: P * sp.Rational(1001, 1000)),
    ("columns swapped", lambda P: P[:, ::-1]),
    ("time reversed", lambda P: P.subs(t, -t)),
    ("one entry", lambda P: P + sp.Matrix([[0, 0], [t**5 * e(-9 * t) / 1000, 0]])),
    ("forgotten factor t", lambda P: P.subs(t * e(-t), e(-t))),
    ("identity", lambda P: sp.eye(2)),
]


@pytest.mark.parametrize(("name", "corrupt"), CORRUPTIONS)
@pytest.mark.parametrize("rows", [[[0, 1], [-2, -3]], [[-1, 0], [1, -1]]])
def test_corrupted_answers_are_rejected(rows, name, corrupt):
    plant = system(rows)
    Phi = sp.Matrix(ask("state_transition_matrix", plant, "laplace").answers["Phi"])
    corrupted = sp.ImmutableMatrix(corrupt(Phi))
    if (corrupted - Phi).expand() == sp.zeros(2):
        pytest.skip(f"{name} changes nothing here")
    assert rejected("state_transition_matrix", plant, {"Phi": corrupted})


def test_corrupted_discrete_answers_are_rejected():
    plant = system([[0, 1], [-6, -5]], discrete=True)
    Phi = sp.Matrix(ask("state_transition_matrix", plant).answers["Phi"])
    for corrupted in (Phi.T, -Phi, Phi.subs(k, k + 1), Phi * sp.diag(1, 2), Phi[:, ::-1]):
        assert rejected("state_transition_matrix", plant, {"Phi": sp.ImmutableMatrix(corrupted)})


def test_a_corrupted_truncated_series_is_rejected():
    plant = system([[0, 1], [-2, -3]])
    answers = dict(ask("state_transition_matrix", plant, "power_series", terms=3).answers)
    answers["Phi_truncated"] = answers["Phi_truncated"] + sp.ImmutableMatrix([[0, 0], [t**2, 0]])
    assert rejected("state_transition_matrix", plant, answers, terms=3)


@pytest.mark.parametrize("method", [*CONTINUOUS, "power_series"])
def test_every_claim_and_check_of_the_course_example_passes(method):
    result = ask("state_transition_matrix", system([[0, 1], [-2, -3]]), method)
    assert len(result.checks) > 3
    assert {check.status for check in result.checks} == {CheckStatus.PASSED}


@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        ([[0, 1], [-2, -3]], (True, False, False, False)),
        ([[-1, 1], [0, -1]], (True, True, False, False)),
        ([[0, 1], [-100, -10]], (False, False, True, True)),
        ([[-1, 0, 0], [0, 0, 1], [0, -4, 0]], (True, False, True, False)),
        ([[0, 1, 0], [0, 0, 1], [-6, -5, -2]], (True, False, True, False)),
    ],
)
def test_the_partial_fractions_are_explained_by_the_poles_there_are(rows, expected):
    steps = {each.kind: each for each in ask("state_transition_matrix", system(rows), "laplace").steps}
    values = steps["partial_fractions"].values
    assert tuple(values[name] for name in ("simple", "repeated", "quadratic", "alone")) == expected
    assert ("completed_squares" in steps) == (expected[2] and rows[2:] != [[0, -4, 0]]), "s² + 4 is a square already"
