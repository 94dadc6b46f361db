"""Eigenvalues, eigenvectors, chains, Jordan forms: against numpy, by definition, corrupted."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given

from solver.derivation import Status
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

I = sp.I


def test_the_course_example():
    answers = ask("eigenstructure", system([[1, 2], [3, 0]])).answers
    assert answers["eigenvalues"] == [-2, 3]
    assert sp.Matrix(answers["right_eigenvectors"]) == sp.Matrix([[2, 1], [-3, 1]])
    assert answers["diagonalizable"] is True


@pytest.mark.parametrize(
    ("rows", "spectrum", "diagonalizable"),
    [
        ([[2, 0], [0, 2]], [2, 2], True),
        ([[2, 1], [0, 2]], [2, 2], False),
        ([[0, 1], [-5, -2]], [-1 + 2 * I, -1 - 2 * I], True),
        ([[0, 1], [2, 0]], [-sp.sqrt(2), sp.sqrt(2)], True),
        ([[0, 0], [0, 0]], [0, 0], True),
        ([[7]], [7], True),
        ([[0, 1, 0, 0], [-1, 0, 1, 0], [0, 0, 0, 1], [0, 0, -1, 0]], [I, I, -I, -I], False),
    ],
)
def test_spectra(rows, spectrum, diagonalizable):
    result = ask("eigenstructure", system(rows))
    assert result.status is Status.VERIFIED, result.reason
    assert sorted(map(str, result.answers["eigenvalues"])) == sorted(map(str, spectrum))
    assert result.answers["diagonalizable"] is diagonalizable


def test_the_rotation_matrix_has_trigonometric_eigenvalues():
    theta = sp.Symbol("theta", real=True)
    rows = [[sp.cos(theta), sp.sin(theta)], [-sp.sin(theta), sp.cos(theta)]]
    result = ask("eigenstructure", system(rows))
    assert result.status is Status.VERIFIED, result.reason
    values = {complex(value.subs(theta, sp.Rational(2, 3))) for value in result.answers["eigenvalues"]}
    assert np.allclose(sorted(value.imag for value in values), [-np.sin(2 / 3), np.sin(2 / 3)])


def test_a_matrix_with_parameters_keeps_them():
    a, b = sp.symbols("a b", real=True)
    result = ask("eigenstructure", system([[0, -1], [a * b, a + b]]))
    assert result.status is Status.VERIFIED, result.reason
    assert set(result.answers["eigenvalues"]) == {a, b}


@tried(30)
@given(systems(6))
def test_random_jordan_structures(A):
    result = ask("eigenstructure", system(A))
    assert result.status is Status.VERIFIED, result.reason
    V, J, M = (sp.Matrix(result.answers[name]) for name in ("right_eigenvectors", "jordan_form", "left_eigenvectors"))
    assert (A * V - V * J).expand() == sp.zeros(A.rows)
    assert (M * A - J * M).expand() == sp.zeros(A.rows)
    assert np.linalg.matrix_rank(np.array(V, dtype=complex)) == A.rows
    assert result.answers["diagonalizable"] == J.is_diagonal()


def corruptions(answers):
    V, M, J = (sp.Matrix(answers[name]) for name in ("right_eigenvectors", "left_eigenvectors", "jordan_form"))
    spectrum = answers["eigenvalues"]
    yield {"right_eigenvectors": V[:, ::-1]}
    yield {"right_eigenvectors": V * 0}
    yield {"right_eigenvectors": sp.Matrix.hstack(V[:, 0], *[V[:, 0]] * (V.cols - 1))}
    yield {"left_eigenvectors": M.T}
    yield {"left_eigenvectors": M[::-1, :]}
    yield {"eigenvalues": [-value for value in spectrum]}
    yield {"eigenvalues": [spectrum[0]] * len(spectrum)}
    yield {"eigenvalues": spectrum[:-1]}
    yield {"jordan_form": J.T + sp.eye(J.rows)}
    yield {"diagonalizable": not answers["diagonalizable"]}


@pytest.mark.parametrize("rows", [[[1, 2], [3, 0]], [[0, 1], [-5, -2]], [[2, 1, 0], [0, 2, 0], [1, 0, 5]]])
def test_corrupted_answers_are_rejected(rows):
    plant = system(rows)
    answers = dict(ask("eigenstructure", plant).answers)
    assert not rejected("eigenstructure", plant, answers)
    for corrupted in corruptions(answers):
        frozen = {
            name: sp.ImmutableMatrix(value) if isinstance(value, sp.MatrixBase) else value
            for name, value in corrupted.items()
        }
        assert rejected("eigenstructure", plant, {**answers, **frozen}), corrupted


def test_any_scale_and_order_of_eigenvectors_is_right():
    plant = system([[1, 2], [3, 0]])
    answers = dict(ask("eigenstructure", plant).answers)
    swap = sp.Matrix([[0, 1], [1, 0]])
    answers["eigenvalues"] = answers["eigenvalues"][::-1]
    answers["right_eigenvectors"] = sp.ImmutableMatrix(answers["right_eigenvectors"] * swap * sp.diag(3, -7))
    answers["left_eigenvectors"] = sp.ImmutableMatrix(
        sp.diag(2, sp.Rational(1, 3)) * swap * answers["left_eigenvectors"]
    )
    answers["jordan_form"] = sp.ImmutableMatrix(swap * answers["jordan_form"] * swap)
    assert not rejected("eigenstructure", plant, answers)


def test_decimals_for_an_irreducible_cubic():
    result = ask("eigenstructure", system([[0, 1, 0], [0, 0, 1], [-1, -1, 0]]))
    assert result.status is Status.VERIFIED, result.reason
    ours = sorted((complex(value) for value in result.answers["eigenvalues"]), key=lambda z: (z.real, z.imag))
    numpys = sorted(np.roots([1, 0, 1, 1]), key=lambda z: (z.real, z.imag))
    assert np.allclose(ours, numpys, atol=1e-12)


def kinds_of_steps(rows):
    return [step.kind for step in ask("eigenstructure", system(rows)).steps]


COMPANION = [[0, 1, 0], [0, 0, 1], [-6, -11, -6]]
REVERSED = [row[::-1] for row in COMPANION[::-1]]


@pytest.mark.parametrize(
    ("rows", "place"),
    [
        (COMPANION, "last row"),
        (REVERSED, "first row"),
        (np.transpose(COMPANION).tolist(), "last column"),
        (np.transpose(REVERSED).tolist(), "first column"),
    ],
)
def test_the_polynomial_of_a_companion_matrix_is_read_off(rows, place):
    result = ask("eigenstructure", system(rows))
    step = next(step for step in result.steps if step.kind == "companion")
    assert step.values["coefficients"] == place
    coefficients = sp.Poly(step.claims["value"].right, sp.Symbol("lamda")).all_coeffs()
    assert np.allclose([float(each) for each in coefficients], np.poly(np.array(rows, dtype=float)))
    assert sorted(result.answers["eigenvalues"]) == [-3, -2, -1]


@pytest.mark.parametrize(
    "rows", [[[0, 1], [-2, -3]], [[0, 1, 0], [0, 0, 2], [-6, -11, -6]], [[0, 1, 0], [0, 0, 1], [0, 0, 4]]]
)
def test_of_other_matrices_it_is_expanded(rows):
    assert "companion" not in kinds_of_steps(rows)
    assert "expansion" in kinds_of_steps(rows)


def test_the_factors_of_a_triangular_matrix_are_seen_and_not_sought():
    assert "factors" not in kinds_of_steps([[1, 5, 0], [0, 2, 7], [0, 0, 1]])
    assert "factors" in kinds_of_steps([[0, 1], [-2, -3]])
