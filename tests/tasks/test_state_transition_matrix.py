"""Φ by every method: closed forms of the course, scipy on random systems, agreement, refusals, corruptions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import expm

from solver import exact, solve
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


a, c = sp.Symbol("a", real=True), sp.Symbol("c", positive=True)
TWICE = {
    "three equal": [[3, 1, 0], [-1, 1, 0], [1, 2, 2]],
    "two chains": [[2, 1, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 0]],
    "double integrator": [[0, 1], [0, 0]],
    "pair": [[1, 1, 0, 0], [-1, 1, 0, 0], [1, 0, 1, 1], [0, 1, -1, 1]],
    "surd": [[0, 1, 1, 0], [2, 0, 0, 1], [0, 0, 0, 1], [0, 0, 2, 0]],
    "parameter": [[a, 1], [0, a]],
    "parameter in a pair": [[0, 1, 1, 0], [-c, 0, 0, 1], [0, 0, 0, 1], [0, 0, -c, 0]],
}


def displayed(step, name):
    return sp.Matrix(step.values[name])


@pytest.mark.parametrize("discrete", [False, True])
@pytest.mark.parametrize("convention", ["right", "left"])
@pytest.mark.parametrize("name", TWICE)
def test_a_defective_matrix_goes_by_chains_and_the_function_of_its_jordan_form(name, convention, discrete):
    plant = system(TWICE[name], discrete=discrete)
    result = ask("state_transition_matrix", plant, "modal", convention=convention)
    assert result.status is Status.VERIFIED, result.reason
    other = ask("state_transition_matrix", plant, "z_transform" if discrete else "laplace")
    assert result.answers["Phi"] == other.answers["Phi"]
    steps = {each.kind: each for each in result.steps}
    A, modal, J = sp.Matrix(plant.A), displayed(steps["inverse"], "modal"), displayed(steps["modes"], "J")
    difference = modal * A - J * modal if convention == "left" else A * modal - modal * J
    assert difference.expand() == sp.zeros(*A.shape)
    chains = [space.chains for space in exact.eigenstructure(plant.A).eigenspaces]
    assert sum(J[i, i + 1] for i in range(A.rows - 1)) == sum(len(chain) - 1 for each in chains for chain in each)
    modes = displayed(steps["modes"], "modes")
    at_rest = modes.subs(k, 0) if discrete else modes.subs(t, 0)
    assert at_rest.expand() == sp.eye(A.rows)
    following = modes.subs(k, 1) - J if discrete else modes.diff(t).subs(t, 0) - J
    assert following.expand() == sp.zeros(*A.shape)


def test_the_function_of_a_block_has_powers_of_time_beside_its_diagonal():
    three, zero = TWICE["three equal"], [[0, 1, 0], [0, 0, 1], [0, 0, 0]]
    found = [
        next(step for step in ask("state_transition_matrix", plant, "modal").steps if step.kind == "modes")
        for plant in (system(three), system(three, discrete=True), system(zero, discrete=True))
    ]
    delta = [sp.KroneckerDelta(k, i) for i in range(3)]
    rows = [
        [e(2 * t), t * e(2 * t), t**2 / 2 * e(2 * t)],
        [2**k, k * 2 ** (k - 1), k * (k - 1) / 2 * 2 ** (k - 2)],
        delta,
    ]
    for step, row in zip(found, rows, strict=True):
        expected = sp.Matrix(3, 3, lambda i, j, row=row: row[j - i] if j >= i else 0)
        assert (displayed(step, "modes") - expected).expand() == sp.zeros(3)


@pytest.mark.parametrize("discrete", [False, True])
def test_every_display_of_the_modal_method_is_judged(discrete):
    time = "time: discrete, " if discrete else ""
    for convention in ("right", "left"):
        text = (
            f"title: T\nsystem: {{{time}A: [[0, 1, 1, 0], [-1, 0, 0, 1], [0, 0, 0, 1], [0, 0, -1, 0]]}}\n"
            f"find: {{a: {{task: state_transition_matrix, method: modal, convention: {convention}}}}}\n"
        )
        part = solve(text).parts[0]
        assert part.status is Status.VERIFIED, part.reason
        assert {row.status for row in part.checks} == {CheckStatus.PASSED}


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
    assert len(solved) == len(results), [r.reason for r in results]
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
    assert len(solved) == len(results), [r.reason for r in results]
    for result in solved:
        assert result.answers["Phi"] == solved[0].answers["Phi"]
    for step in range(6):
        difference = at(solved[0].answers["Phi"], k=step) - np.array((sp.Matrix(A) ** step).tolist(), dtype=float)
        assert np.abs(difference).max() <= 1e-9 * max(1.0, np.abs(np.array(A**step, dtype=float)).max())


@tried(20)
@given(systems(5), st.sampled_from(["right", "left"]), st.booleans())
def test_the_modal_method_solves_every_system(A, convention, discrete):
    result = ask("state_transition_matrix", system(A, discrete=discrete), "modal", convention=convention)
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
