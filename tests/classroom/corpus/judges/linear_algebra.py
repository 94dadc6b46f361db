"""Judges of linear algebra."""

import numpy as np
import sympy as sp
from scipy.linalg import expm, logm, null_space, sqrtm

from tests.classroom.corpus.judges.registry import (
    POINTS,
    ImpossibleError,
    difference,
    judge,
    letter,
    matrix,
    monic,
    multiset,
    polynomial_of,
    truth,
    unique,
    word,
)
from tests.classroom.corpus.meanings import Meaning
from tests.hunt.asked import Point, parsed
from tests.hunt.judges.found import rank
from tests.hunt.plants import matrices


@judge("characteristic_polynomial", "polynomial")
def characteristic(point: Point, meant: Meaning):
    return polynomial_of(meant, "lamda", monic(matrices(point)[0]))


@judge("resolvent", "polynomial")
def characteristic_in_s(point: Point, meant: Meaning):
    return polynomial_of(meant, letter(point), monic(matrices(point)[0]))


@judge("resolvent", "resolvent")
def resolvent(point: Point, meant: Meaning):
    A = matrices(point)[0]
    return [difference(meant(**{letter(point): s}), np.linalg.inv(s * np.eye(len(A)) - A)) for s in POINTS]


@judge("eigenstructure", "eigenvalues")
@judge("phase_portrait", "eigenvalues")
@judge("stability", "eigenvalues")
def eigenvalues(point: Point, meant: Meaning):
    return multiset(meant(), roots_of(matrices(point)[0]))


def roots_of(M: np.ndarray) -> np.ndarray:
    """Eigenvalues, a multiple one put back where its sum is."""
    roots = sorted(np.linalg.eigvals(M), key=lambda r: (round(r.real, 3), round(r.imag, 3)))
    groups: list[list[complex]] = []
    for root in roots:
        near = next((g for g in groups if abs(g[0] - root) < 1e-4), None)
        near.append(root) if near else groups.append([root])
    return np.array([sum(g) / len(g) for g in groups for _ in g])


@judge("eigenstructure", "right_eigenvectors")
def right_eigenvectors(point: Point, meant: Meaning):
    A = matrices(point)[0]
    return _chains(A, matrix(meant, A.shape))


@judge("eigenstructure", "left_eigenvectors")
def left_eigenvectors(point: Point, meant: Meaning):
    A = matrices(point)[0]
    return _chains(A.T, matrix(meant, A.shape).T, backwards=True)


def _chains(A: np.ndarray, V: np.ndarray, backwards: bool = False) -> np.ndarray:
    """A V = V J for a J of Jordan's form: the ratio of each column, and the ones of the chains."""
    if rank(V) < len(A):
        raise ImpossibleError("dependent")
    J = np.linalg.solve(V, A @ V)
    J = J.T if backwards else J
    off = J - np.diag(np.diag(J))
    ones = np.where(np.abs(np.diag(off, 1) - 1) < 0.3, 1.0, 0.0)
    return np.append(off - np.diag(ones, 1), V @ (J.T if backwards else J) - A @ V)


@judge("eigenstructure", "jordan_form")
def jordan_form(point: Point, meant: Meaning):
    A = matrices(point)[0]
    J = matrix(meant, A.shape)
    values = np.diag(J)
    ones = np.diag(J, 1)
    between = ones * (values[1:] - values[:-1])
    if np.any(J - np.diag(values) - np.diag(ones, 1)) or set(ones) - {0, 1} or np.any(np.abs(between) > 1e-9):
        raise ImpossibleError("no Jordan form")
    for value in values:
        for power in range(1, len(A) + 1):
            theirs = np.linalg.matrix_power(A - value * np.eye(len(A)), power)
            near = np.linalg.matrix_power(J - value * np.eye(len(A)), power)
            if np.linalg.matrix_rank(theirs, 1e-3) != np.linalg.matrix_rank(near, 1e-3):
                return [1.0]
    return multiset(values, roots_of(A))


@judge("eigenstructure", "diagonalizable")
def diagonalizable(point: Point, meant: Meaning):
    A = matrices(point)[0]
    whole = sum(null_space(A - r * np.eye(len(A)), 1e-6).shape[1] for r in set(np.round(roots_of(A), 6)))
    return [word(truth(meant) == (whole == len(A)))]


def _asked(point: Point) -> np.ndarray:
    return point.matrix(point.option("matrix") or point.question.system.get("matrix") or point.question.system["A"])


@judge("fundamental_subspaces", "null_space")
def null(point: Point, meant: Meaning):
    return _basis_of(meant, null_space(_asked(point)))


@judge("fundamental_subspaces", "left_null_space")
def left_null(point: Point, meant: Meaning):
    return _basis_of(meant, null_space(_asked(point).T))


@judge("fundamental_subspaces", "column_space")
def column(point: Point, meant: Meaning):
    return _basis_of(meant, _range(_asked(point)))


@judge("fundamental_subspaces", "row_space")
def row(point: Point, meant: Meaning):
    return _basis_of(meant, _range(_asked(point).T))


def _range(M: np.ndarray) -> np.ndarray:
    return np.linalg.svd(M)[0][:, : rank(M)]


def _basis_of(meant: Meaning, space: np.ndarray) -> np.ndarray:
    """A basis as columns: as many as the space has dimensions, independent, and in it."""
    if not space.shape[1]:
        return [word(meant.raw == [])]
    V = matrix(meant, space.shape)
    if rank(V) < V.shape[1]:
        raise ImpossibleError("dependent")
    return V - space @ (space.conj().T @ V)


@unique("fundamental_subspaces", "rank")
def rank_of(point: Point):
    return rank(_asked(point))


@unique("similarity_transformation", "A")
def transformed_A(point: Point):
    T = point.matrix(point.option("T"))
    return np.linalg.solve(T, matrices(point)[0] @ T)


@unique("similarity_transformation", "B")
def transformed_B(point: Point):
    return np.linalg.solve(point.matrix(point.option("T")), matrices(point)[1])


@unique("similarity_transformation", "C")
def transformed_C(point: Point):
    return matrices(point)[2] @ point.matrix(point.option("T"))


FUNCTIONS = {
    "exp(A)": expm,
    "exp(A t)": lambda A: expm(1.3 * A),
    "sqrt(A)": sqrtm,
    "inv(A)": np.linalg.inv,
    "log(A)": logm,
    "sin(A)": lambda A: (expm(1j * A) - expm(-1j * A)) / 2j,
}


@judge("matrix_function", "F")
def matrix_function(point: Point, meant: Meaning):
    A, text = matrices(point)[0], point.option("function")
    if text in FUNCTIONS:
        return difference(meant(t=1.3), FUNCTIONS[text](A))
    if text == "A^k":
        return [difference(meant(k=k), np.linalg.matrix_power(A, k)) for k in range(1, 8)]
    polynomial = sp.Poly(parsed(text).subs(sp.Symbol("I"), 1), sp.Symbol("A"))
    theirs = sum(int(c) * np.linalg.matrix_power(A, p) for (p,), c in polynomial.terms())
    return difference(meant(), theirs) / max(1.0, np.max(np.abs(theirs)))
