"""All real symmetric solutions of a Riccati equation judged: how many there are, that none is missing, what each is."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import free_symbols
from solver.numeric.evaluation.values import NotEvaluable, Undefined
from solver.numeric.judges.optimal.regulator import Optimum, Weights, matrix_at, optima, relative
from solver.numeric.judges.optimal.riccati import hamiltonian

ON_THE_AXIS = 1e-7
MANY = multiple(50)
POINTS = 8
"""Points at which solutions are counted where there are parameters."""
WELL_KNOWN = 80
"""Bits from which on an entry is known to more than rounding in doubles."""


def all_distinct(weights: Weights, matrices: Sequence[Any]) -> bool:
    """Whether no matrix is listed twice."""
    listed = [P for P in matrices if getattr(P, "shape", None) == weights.A.shape]
    for optimum in optima(weights, listed):
        values = [matrix_at(P, optimum.point, optimum.A.shape) for P in listed]
        for i, one in enumerate(values):
            if any(relative(one - other, one, other) < 1e-8 for other in values[:i]):
                return False
    return True


def none_missing(weights: Weights, matrices: Sequence[Any]) -> bool:
    """Whether at admissible values of the parameters as many matrices are real as there are solutions.

    With parameters further solutions may be real for some values only: that none is left out at one of several points
    is enough. Where some are at each, a single one is too few beside the stabilizing and the antistabilizing one; of
    more it is not decided from two states on. Raises NotEvaluable then, and as `number_of_solutions`.
    """
    found = optima(weights, matrices, POINTS)
    counts = [_number_at(each) for each in found]
    if any(count == sum(_is_real(P, each) for P in matrices) for count, each in zip(counts, found, strict=True)):
        return True
    if len(matrices) > 1 and weights.A.rows > 1 and any(M.free_symbols for M in weights):
        raise NotEvaluable("other solutions may be real for some values of the parameters only")
    return False


def _is_real(P: Any, optimum: Optimum) -> bool:
    try:
        matrix_at(P, optimum.point, optimum.A.shape)
    except Undefined:
        return False
    return True


def number_of_solutions(weights: Weights) -> int:
    """Return how many real symmetric solutions there are, counted by invariant subspaces in floats.

    With A₊ = A − BK they correspond to the left-invariant subspaces of A₊ without an uncontrollable left eigenvector:
    Π (m + 1) over its real eigenvalues and conjugate pairs that are controllable, m the multiplicity (Willems 1971).
    In discrete time an eigenvalue zero can't be flipped, as its mirror image is at infinity.
    Raises NotEvaluable where eigenvalues are too close to each other, or solutions form a continuum.
    """
    return _number_at(optima(weights)[0])


def _number_at(optimum: Optimum) -> int:
    values, vectors = np.linalg.eig(optimum.closed_loop.T)
    scale = float(1 + np.abs(values).max())
    count = 1
    kept = [value for value in values if value.imag > -ON_THE_AXIS * scale]
    for cluster in _clusters(kept, 1e-4 * scale):
        if optimum.discrete and _is_at_zero(cluster, scale):
            continue
        if len(cluster) == 1:
            count *= 2 if _is_reached(optimum, vectors[:, list(values).index(cluster[0])]) else 1
            continue
        own, reached = _left_eigenvectors(optimum, sum(cluster) / len(cluster), 1e-6 * scale)
        if own == 0:
            raise NotEvaluable(
                "eigenvalues of the closed loop lie too close to each other to count solutions in floats"
            )
        if own > 1 and reached:
            raise NotEvaluable("the solutions form a continuum")
        if reached:
            count *= len(cluster) + 1
    return count


def _is_at_zero(cluster: list[Any], scale: float) -> bool:
    """Whether eigenvalues near to each other are what rounding leaves of zero: the product of several of them is."""
    return bool(abs(np.prod(cluster)) < 1e-9 * scale)


def _clusters(values: list[Any], distance: float) -> list[list[Any]]:
    """The values, those near to each other together."""
    if not values:
        return []
    near = [value for value in values if abs(value - values[0]) < distance]
    return [near, *_clusters([value for value in values if abs(value - values[0]) >= distance], distance)]


def _left_eigenvectors(optimum: Optimum, eigenvalue: complex, tolerance: float) -> tuple[int, int]:
    """How many independent left eigenvectors of the closed loop an eigenvalue has, and how many of these B reaches."""
    pencil = optimum.closed_loop - eigenvalue * np.eye(len(optimum.A))
    own, hidden = (
        int(np.sum(np.linalg.svd(M, compute_uv=False) < tolerance)) for M in (pencil, np.hstack([pencil, optimum.B]))
    )
    return own, own - hidden


def _is_reached(optimum: Optimum, w: Array) -> bool:
    """Whether B reaches the mode of a left eigenvector w, as far as its products with B are more than rounding."""
    products = np.abs(w)[:, None] * np.abs(optimum.B)
    counted = products.sum(axis=0) > 1e-12 * float(np.abs(optimum.B).max(initial=0.0))
    return bool(np.any(counted & (np.abs(w @ optimum.B) > 1e-6 * products.sum(axis=0))))


def is_minimal(weights: Weights, P: Any) -> bool:
    """Whether a solution P is the smallest positive semidefinite one: it is zero on what the weight does not see.

    What is left of P is positive semidefinite for an observable problem, and there is one such solution only.
    """

    def holds(optimum: Optimum) -> bool:
        A, Q = optimum.without_products()
        A = A / max(1.0, float(np.abs(A).max()))
        rows = np.vstack([Q @ np.linalg.matrix_power(A, i) for i in range(len(A))])
        _, sizes, directions = np.linalg.svd(rows)
        unseen = directions[int(np.sum(sizes > 1e-9 * max(1e-300, float(sizes[0])))) :]
        value = matrix_at(P, optimum.point, optimum.A.shape)
        size = 1e-8 * float(np.abs(value).max())
        return bool(np.linalg.eigvalsh((value + value.T) / 2)[0] >= -size) and bool(
            np.abs(value @ unseen.T).max(initial=0.0) <= size
        )

    return all(holds(optimum) for optimum in optima(weights, (P,)))


def signature_word(optimum: Optimum, P: Any) -> str:
    """Return the definiteness of a symmetric matrix in words, by mpmath.eigsy; in floats, by numpy.linalg.eigvalsh.

    Raises NotEvaluable where an eigenvalue is so small beside others that it may be what rounding left of zero.
    """
    value = matrix_at(P, optimum.point, optimum.A.shape)
    digits = min((number._prec for number in sp.ImmutableMatrix(P).atoms(sp.Float)), default=WELL_KNOWN)
    if digits < WELL_KNOWN:
        eigenvalues, zero = list(np.linalg.eigvalsh((value + value.T) / 2)), 1e-9
    else:
        entries = value_of(P, Environment.at([dict(optimum.point)], MANY)).value[0]
        eigenvalues = list(MANY.context.eigsy(MANY.context.matrix(entries + entries.T), eigvals_only=True))
        zero = 1e-28
    sizes = [float(abs(each)) for each in eigenvalues]
    zero *= max(1e-300, *sizes)
    if digits >= WELL_KNOWN and any(zero < size < 100 * zero for size in sizes):
        raise NotEvaluable("an eigenvalue is too small beside the others to tell its sign")
    positive, negative = (sum(1 for each in eigenvalues if sign * each > zero) for sign in (1, -1))
    return definiteness_word(positive, negative, len(eigenvalues))


def definiteness_word(positive: int, negative: int, n: int) -> str:
    """Return the word for these numbers of eigenvalues of a sign; the zero matrix is positive semidefinite."""
    if positive and negative:
        return "indefinite"
    if negative:
        return "negative definite" if negative == n else "negative semidefinite"
    return "positive definite" if positive == n else "positive semidefinite"


def judged_definite(weights: Weights, words: Sequence[Any], matrices: Sequence[Any]) -> bool:
    """Whether each word says of what definiteness the matrix at its place is, at every admissible point tried."""
    return all(
        _plain(word) == signature_word(optimum, P)
        for optimum in optima(weights, matrices)
        for word, P in zip(words, matrices, strict=True)
    )


def _plain(word: Any) -> str:
    return str(word).strip().lower().replace("-", " ").replace("_", " ").replace("semi definite", "semidefinite")


def definiteness_holds(weights: Weights, words: Sequence[Any], solutions: Sequence[Any] | None) -> bool:
    """Whether the words fit the solutions in their order; without solutions, those found in floats in any order.

    Raises NotEvaluable where there are no solutions to compare with.
    """
    if solutions is not None:
        return len(words) == len(solutions) and judged_definite(weights, words, solutions)
    if any(free_symbols(M) for M in weights):
        raise NotEvaluable("definiteness alone, without the solutions, is not judged where there are parameters")
    optimum = optima(weights)[0]
    found = [signature_word(optimum, sp.ImmutableMatrix(P)) for P in solutions_in_floats(weights)]
    return sorted(found) == sorted(map(_plain, words))


def _pencil_eigenvectors(optimum: Optimum) -> tuple[Array, Array]:
    """The finite eigenvalues of the symplectic pencil and its eigenvectors; raises NotEvaluable for a singular R."""
    from scipy.linalg import eig  # noqa: PLC0415

    n = len(optimum.A)
    if np.linalg.matrix_rank(optimum.R) < len(optimum.R):
        raise NotEvaluable("a singular weight of the input has no symplectic pencil")
    A, Q = optimum.without_products()
    G = optimum.B @ np.linalg.solve(optimum.R, optimum.B.T)
    left = np.block([[A, np.zeros((n, n))], [-Q, np.eye(n)]])
    values, vectors = eig(left, np.block([[np.eye(n), G], [np.zeros((n, n)), A.T]]))
    finite = np.isfinite(values) & (np.abs(values) < 1e9)
    return values[finite], vectors[:, finite]


def _taken(value: complex, sign: int, optimum: Optimum) -> complex:
    """An eigenvalue, or its mirror image."""
    return value if sign > 0 else 1 / value if optimum.discrete else -value


def solutions_in_floats(weights: Weights) -> list[Array]:
    """Return all real symmetric solutions where the eigenvalues of H are distinct: P = Y X⁻¹ by its eigenvectors.

    In discrete time those of the pencil. Raises NotEvaluable where eigenvalues coincide.
    """
    optimum = optima(weights)[0]
    n = len(optimum.A)
    values, vectors = _pencil_eigenvectors(optimum) if optimum.discrete else np.linalg.eig(hamiltonian(optimum))
    scale = float(np.abs(values).max())
    if min(abs(a - b) for i, a in enumerate(values) for b in values[:i]) < 1e-5 * (
        min(scale, 1.0) if optimum.discrete else scale
    ):
        raise NotEvaluable("eigenvalues of the Hamiltonian matrix coincide")
    stable = np.abs(values) < 1 if optimum.discrete else values.real < 0
    upper = [i for i, value in enumerate(values) if stable[i] and value.imag > -ON_THE_AXIS * scale]
    found = []
    for signs in product((1, -1), repeat=len(upper)):
        if optimum.discrete and any(s < 0 and abs(values[i]) < 1e-9 for s, i in zip(signs, upper, strict=True)):
            continue
        wanted = [_taken(values[i], sign, optimum) for sign, i in zip(signs, upper, strict=True)]
        wanted += [np.conj(value) for value in wanted if abs(value.imag) > ON_THE_AXIS * scale]
        chosen = [int(np.argmin(np.abs(values - value))) for value in wanted]
        X, Y = vectors[:n, chosen], vectors[n:, chosen]
        if np.linalg.svd(X, compute_uv=False)[-1] > 1e-9:
            found.append(np.real(Y @ np.linalg.inv(X)))
    return found
