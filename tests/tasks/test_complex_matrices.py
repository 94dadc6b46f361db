"""Matrices with complex entries: numpy's and scipy's values, no conjugate pairs, corruptions, what is refused."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import expm

from solver import solve
from solver.derivation import CheckStatus, Status
from solver.tasks import catalogue
from tests.helpers.asking import ask, at, rejected, system
from tests.helpers.marked import solved, verdict
from tests.helpers.tried import tried

j = sp.I
w = sp.Symbol("w", real=True)
MATRICES = {
    "apart": [[j, 1], [0, -2 * j]],
    "hermitian": [[1, 1 - j], [1 + j, 2]],
    "pair": [[0, j], [j, 0]],
    "defective": [[j, 1], [0, j]],
    "root": [[0, 1], [j, 0]],
    "surd": [[j * sp.sqrt(2), 1], [0, 2]],
    "three": [[1, 0, j], [0, 2 * j, 1], [0, 0, 1 - j]],
}
METHODS = {
    "state_transition_matrix": ("laplace", "cayley_hamilton", "modal"),
    "resolvent": ("adjugate", "faddeev_leverrier"),
    "characteristic_polynomial": ("determinant", "faddeev_leverrier"),
}


def numbers(M):
    return np.array(sp.Matrix(M).evalf(30).tolist(), dtype=complex)


@pytest.mark.parametrize("name", MATRICES)
def test_transition_matrices_are_scipys_by_every_method(name):
    rows = MATRICES[name]
    found = [ask("state_transition_matrix", system(rows), method) for method in METHODS["state_transition_matrix"]]
    assert {each.status for each in found} == {Status.VERIFIED}, [each.reason for each in found]
    assert len({each.answers["Phi"] for each in found}) == 1
    assert np.allclose(at(found[0].answers["Phi"], t=0.7), expm(0.7 * numbers(rows)), atol=1e-12)


@pytest.mark.parametrize("name", ["apart", "defective", "root"])
def test_powers_are_numpys_by_every_method(name):
    rows = MATRICES[name]
    for method in ("z_transform", "cayley_hamilton", "modal"):
        found = ask("state_transition_matrix", system(rows, discrete=True), method)
        assert found.status is Status.VERIFIED, found.reason
        for k in (0, 1, 5):
            assert np.allclose(at(found.answers["Phi"], k=k), np.linalg.matrix_power(numbers(rows), k), atol=1e-12)


@pytest.mark.parametrize("name", MATRICES)
def test_eigenvectors_are_not_conjugated(name):
    rows = MATRICES[name]
    found = ask("eigenstructure", system(rows))
    assert found.status is Status.VERIFIED, found.reason
    theirs = np.linalg.eigvals(numbers(rows))
    ours = numbers(sp.Matrix([found.answers["eigenvalues"]]))[0]
    assert all(np.abs(theirs - each).min() < 1e-6 for each in ours)
    V, J = numbers(found.answers["right_eigenvectors"]), numbers(found.answers["jordan_form"])
    assert np.allclose(numbers(rows) @ V, V @ J)
    assert "conjugate" not in {step.kind for step in found.steps}
    assert found.answers["diagonalizable"] is (name != "defective")


@pytest.mark.parametrize(("task", "method"), [(task, method) for task in METHODS for method in METHODS[task]])
def test_every_display_is_judged(task, method):
    text = f'title: T\nsystem: {{A: [["j", 1], [0, "-2j"]]}}\nfind: {{a: {{task: {task}, method: {method}}}}}\n'
    part = solve(text).parts[0]
    assert part.status is Status.VERIFIED, part.reason
    assert {row.status for row in part.checks} == {CheckStatus.PASSED}


def test_functions_of_a_complex_matrix():
    A = sp.Symbol("A")
    rows = [[2 * j, 1], [0, 4]]
    F = ask("matrix_function", system(rows), function=sp.sqrt(A)).answers["F"]
    assert F[0, 0] == 1 + j
    assert ((F * F).expand() - sp.Matrix(rows)).expand() == sp.zeros(2)
    for method in ("cayley_hamilton", "modal"):
        found = ask("matrix_function", system(MATRICES["apart"]), method, function=A**10)
        assert found.answers["F"] == sp.Matrix([[-1, -341 * j], [0, -1024]])
        assert found.status is Status.VERIFIED


def test_parameters_are_taken_where_the_roots_have_a_form():
    found = ask("state_transition_matrix", system([[0, 1], [-1, j * w]]))
    assert found.status is Status.VERIFIED, found.reason
    assert found.answers["Phi"][0, 1].has(sp.sqrt(w**2 + 4))
    refused = ask("eigenstructure", system([[0, 1, 0], [0, 0, 1], [j, 1, 1]]))
    assert refused.status is Status.UNSOLVED
    assert "factor of degree 3" in str(refused.reason)


@tried(10)
@given(st.lists(st.tuples(st.integers(-2, 2), st.integers(-2, 2)), min_size=6, max_size=6), st.booleans())
def test_random_matrices_are_solved_by_every_method(entries, discrete):
    a, b, c, d, p, q = (x + j * y for x, y in entries)
    T = sp.Matrix([[1, p], [0, 1]]) * sp.Matrix([[1, 0], [q, 1]])
    plant = system((T * sp.Matrix([[a, b], [0, c]]) * T.inv()).expand() + d * sp.eye(2), discrete=discrete)
    methods = ("z_transform" if discrete else "laplace", "cayley_hamilton", "modal")
    found = [ask("state_transition_matrix", plant, method) for method in methods]
    assert {each.status for each in found} == {Status.VERIFIED}, [each.reason for each in found]


def test_conjugated_and_other_corrupted_answers_are_rejected():
    plant = system(MATRICES["apart"])
    Phi = ask("state_transition_matrix", plant).answers["Phi"]
    chi = ask("characteristic_polynomial", plant).answers["polynomial"]
    R = ask("resolvent", plant).answers["resolvent"]
    assert not rejected("state_transition_matrix", plant, {"Phi": Phi})
    t, s, lamda = sp.symbols("t s lamda")
    for wrong in (Phi.subs(j, -j), Phi.T, -Phi, Phi.subs(t, -t), Phi + sp.Matrix([[0, j / 10**9], [0, 0]])):
        assert rejected("state_transition_matrix", plant, {"Phi": sp.ImmutableMatrix(wrong)})
    for wrong in (chi.subs(j, -j), chi.subs(lamda, -lamda), chi + j):
        assert rejected("characteristic_polynomial", plant, {"polynomial": sp.expand(wrong)})
    for wrong in (R.subs(j, -j), R.T, R.subs(s, -s)):
        assert rejected("resolvent", plant, {"resolvent": sp.ImmutableMatrix(wrong)})
    V = ask("eigenstructure", plant).answers["right_eigenvectors"]
    assert rejected("eigenstructure", plant, {"right_eigenvectors": sp.ImmutableMatrix(V.subs(j, -j))})


def test_a_student_may_write_them_with_j():
    text = 'title: T\nsystem: {A: [["j", 1], [0, "-2j"]]}\nfind: {a: characteristic_polynomial, b: eigenstructure}\n'
    problem = solved(text)
    assert verdict(problem, "a", "polynomial", "(lambda - j)(lambda + 2j)").verdict == "correct"
    assert verdict(problem, "a", "polynomial", "(lambda + j)(lambda - 2j)").verdict == "wrong"
    assert verdict(problem, "b", "right_eigenvectors", [["1", "j"], ["0", "3"]]).verdict == "correct"
    assert verdict(problem, "b", "right_eigenvectors", [["1", "-j"], ["0", "3"]]).verdict == "wrong"


TAKEN = {"characteristic_polynomial", "eigenstructure", "matrix_function", "resolvent", "state_transition_matrix"}


def test_whatever_else_is_asked_is_refused_with_the_reason():
    assert {name for name, task in catalogue().items() if task.complex_entries} == TAKEN
    plant = system([[j, 1], [0, -2]], B=[0, 1], C=[[1, 0]])
    for name in ("stability", "controllability", "transfer_function", "minimal_realization", "stabilizability"):
        found = ask(name, plant)
        assert found.status is Status.UNSOLVED
        assert "The entries are not real" in str(found.reason)
        assert not found.steps
    only_B = system([[1, 0], [0, 2]], B=[j, 1], C=[[1, 0]])
    assert ask("controllability", only_B).status is Status.UNSOLVED


def test_a_transformation_may_be_complex():
    plant = system([[0, 1], [-1, 0]], B=[0, 1], C=[[1, 0]])
    found = ask("similarity_transformation", plant, T=sp.ImmutableMatrix([[1, 1], [j, -j]]))
    assert found.status is Status.VERIFIED, found.reason
    assert found.answers["A"] == sp.diag(j, -j)
    assert rejected(
        "similarity_transformation",
        plant,
        {"A": sp.ImmutableMatrix(sp.diag(-j, j))},
        T=sp.ImmutableMatrix([[1, 1], [j, -j]]),
    )
