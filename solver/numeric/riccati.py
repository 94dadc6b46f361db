"""The regulator problem judged by its defining properties, with scipy's own Riccati and Lyapunov solvers.

Everything is about (A, B, Q, R) at random admissible values of the parameters: R > 0, Q ≥ 0, a stabilizing solution
exists. An observer's problem is judged as the regulator's of (Aᵀ, Cᵀ).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
import sympy as sp
from numpy.linalg import LinAlgError

from solver.derivation.stated import difference, inverse, product, total, transpose
from solver.numeric.arithmetic import Array
from solver.numeric.compare import Point
from solver.numeric.evaluate import evaluate
from solver.numeric.exponential import equality_residual
from solver.numeric.points import PointSource, free_symbols
from solver.numeric.values import NotEvaluable, ShapeMismatch, Undefined

TRIES = 40
ON_THE_AXIS = 1e-7


class Weights(NamedTuple):
    """The plant and the weights: A n×n, B n×m, Q n×n, R m×m."""

    A: Any
    B: Any
    Q: Any
    R: Any


class Optimum(NamedTuple):
    """Numbers at one point: the plant, the weights, the stabilizing solution P and the gain K."""

    point: Point
    A: Array
    B: Array
    Q: Array
    R: Array
    P: Array
    K: Array

    @property
    def closed_loop(self) -> Array:
        """A − BK."""
        return np.asarray(self.A - self.B @ self.K)


def optima(weights: Weights, others: Iterable[Any] = ()) -> list[Optimum]:
    """Return the optimum at two admissible points (at the only one if there are no symbols).

    `others` are formulas whose symbols take values too. Raises NotEvaluable if no admissible point is found.
    """
    symbols = frozenset().union(*map(free_symbols, weights), *map(free_symbols, others))
    source = PointSource(symbols)
    own = free_symbols(weights.Q) | free_symbols(weights.R)
    found: list[Optimum] = []
    for _ in range(TRIES if symbols else 1):
        drawn = source.draw()
        for point in ({s: abs(v) if s in own else v for s, v in drawn.items()}, {s: abs(v) for s, v in drawn.items()}):
            optimum = _optimum(weights, point)
            if optimum is not None:
                found.append(optimum)
                break
        if len(found) == (2 if symbols else 1):
            break
    if not found:
        raise NotEvaluable("no values of the parameters were found for which the problem has a solution")
    return found


def _optimum(weights: Weights, point: Mapping[Any, Any]) -> Optimum | None:
    """Return scipy's solution at a point; None if the point is not admissible."""
    from scipy.linalg import solve_continuous_are  # noqa: PLC0415

    try:
        A, B, Q, R = (_real(evaluate(M, point)) for M in weights)
        if np.linalg.eigvalsh(R)[0] <= 0 or np.linalg.eigvalsh(Q)[0] < -1e-9 * (1 + np.abs(Q).max()):
            return None
        P = solve_continuous_are(A, B, Q, R)
        K = np.linalg.solve(R, B.T @ P)
    except (LinAlgError, ValueError, Undefined):
        return None
    return Optimum(dict(point), A, B, Q, R, P, K) if hurwitz(A - B @ K) else None


def _real(matrix: Any) -> Array:
    if np.abs(np.imag(matrix)).max(initial=0.0) > 1e-9 * (1 + np.abs(matrix).max(initial=0.0)):
        raise Undefined("the matrix is not real here")
    return np.real(matrix)


def hurwitz(matrix: Array) -> bool:
    """Whether all eigenvalues lie in the open left half plane."""
    eigenvalues = np.linalg.eigvals(matrix)
    return bool(np.all(eigenvalues.real < -1e-12 * (1 + np.abs(eigenvalues).max(initial=0.0))))


def matrix_at(formula: Any, point: Point, shape: tuple[int, int]) -> Array:
    """Return a real matrix at a point; raises ShapeMismatch for another shape, NotEvaluable for unknown symbols."""
    if getattr(formula, "shape", (1, 1)) != shape:
        raise ShapeMismatch(f"it must be {shape[0]}×{shape[1]}")
    unknown = free_symbols(formula) - set(point)
    if unknown:
        raise ShapeMismatch(f"it holds {', '.join(sorted(map(str, unknown)))}, which the question does not")
    value = evaluate(formula, point)
    return np.reshape(_real(value), shape)


def relative(difference_: Array, *scales: Array) -> float:
    """Return the largest entry of a difference over the largest of what was compared."""
    size = max((float(np.abs(scale).max(initial=0.0)) for scale in scales), default=0.0)
    gap = float(np.abs(difference_).max(initial=0.0))
    return gap / size if size > 0 else gap


def worst(weights: Weights, judge: Callable[[Optimum], float], *others: Any) -> float:
    """Return the largest of a residual over the admissible points; infinite where a value is not real or defined."""
    try:
        return max(judge(optimum) for optimum in optima(weights, others))
    except Undefined:
        return float("inf")


def riccati_residual(weights: Weights, P: Any) -> float:
    """Return the largest entrywise relative difference in AᵀP + PA + Q = P B R⁻¹ Bᵀ P, P exact or in decimals."""
    A, B, Q, R = weights
    if getattr(P, "shape", None) != Q.shape:
        raise ShapeMismatch(f"P must be {Q.rows}×{Q.cols}")
    linear = total(product(transpose(A), P), product(P, A), Q)
    quadratic = product(P, B, inverse(R), transpose(B), P)
    return equality_residual(linear, quadratic, [optimum.point for optimum in optima(weights, (P,))])


def symmetry_residual(weights: Weights, P: Any) -> float:
    """Return how far P is from being real and symmetric."""

    def judge(optimum: Optimum) -> float:
        value = matrix_at(P, optimum.point, optimum.A.shape)
        return relative(value - value.T, value)

    return worst(weights, judge, P)


def stabilizes(weights: Weights, P: Any) -> bool:
    """Whether A − B R⁻¹ Bᵀ P is Hurwitz."""

    def holds(optimum: Optimum) -> bool:
        value = matrix_at(P, optimum.point, optimum.A.shape)
        return hurwitz(optimum.A - optimum.B @ np.linalg.solve(optimum.R, optimum.B.T @ value))

    return all(holds(optimum) for optimum in optima(weights, (P,)))


def gain_residual(weights: Weights, K: Any) -> float:
    """Return how far K (m×n) is from R⁻¹BᵀP with the cost matrix P of u = −Kx itself; infinite if it is not stable.

    A stabilizing K with that property is optimal (Kleinman): P then solves the Riccati equation.
    """

    def judge(optimum: Optimum) -> float:
        value = matrix_at(K, optimum.point, (optimum.B.shape[1], optimum.A.shape[0]))
        P = cost_matrix(optimum, value)
        best = np.linalg.solve(optimum.R, optimum.B.T @ P) if P is not None else None
        if best is None:
            return float("inf")
        return relative(value - best, value, best, optimum.K)

    return worst(weights, judge, K)


def cost_matrix(optimum: Optimum, K: Array) -> Array | None:
    """Return X with x₀ᵀXx₀ = ∫ xᵀ(Q + KᵀRK)x dt under u = −Kx, by scipy; None if A − BK is not stable."""
    from scipy.linalg import solve_continuous_lyapunov  # noqa: PLC0415

    loop = optimum.A - optimum.B @ K
    if not hurwitz(loop):
        return None
    return np.asarray(solve_continuous_lyapunov(loop.T, -(optimum.Q + K.T @ optimum.R @ K)))


def loop_residual(weights: Weights, loop: Any) -> float:
    """Return the relative difference of a matrix and A − BK with scipy's K."""

    def judge(optimum: Optimum) -> float:
        value = matrix_at(loop, optimum.point, optimum.A.shape)
        return relative(value - optimum.closed_loop, value, optimum.closed_loop)

    return worst(weights, judge, loop)


def hamiltonian_spectrum_residual(weights: Weights, eigenvalues: Sequence[Any]) -> float:
    """Return the largest relative difference of Π(x − λᵢ)(−x − λᵢ)·(−1)ⁿ and det(xI − H) at some x.

    Infinite unless there are n eigenvalues, all with negative real parts. So they are the stable ones of H.
    """
    n = weights.A.rows
    if len(eigenvalues) != n:
        return float("inf")
    listed = sp.ImmutableMatrix([list(eigenvalues)])

    def judge(optimum: Optimum) -> float:
        unknown = free_symbols(listed) - set(optimum.point)
        if unknown:
            return float("inf")
        values = evaluate(listed, optimum.point)[0]
        if not np.all(values.real < 0):
            return float("inf")
        H = hamiltonian(optimum)
        size = max(1e-3, float(np.abs(values).mean()))
        gaps = []
        for x in size * np.exp(1j * np.array([0.4, 1.3, 2.1])) * np.array([0.7, 1.0, 1.6]):
            stated, found = np.linalg.det(x * np.eye(2 * n) - H), np.prod((x - values) * (x + values))
            gaps.append(abs(stated - found) / max(abs(stated), abs(found)))
        return float(max(gaps))

    return worst(weights, judge, listed)


def hamiltonian(optimum: Optimum) -> Array:
    """H = [[A, −B R⁻¹ Bᵀ], [−Q, −Aᵀ]]."""
    G = optimum.B @ np.linalg.solve(optimum.R, optimum.B.T)
    return np.block([[optimum.A, -G], [-optimum.Q, -optimum.A.T]])


def control_residual(weights: Weights, u: Any, states: Sequence[Any]) -> float:
    """Return the relative difference of u (m×1, or an expression for m = 1) and −Kx at random states, K scipy's."""

    def judge(optimum: Optimum) -> float:
        value = matrix_at(u, optimum.point, (optimum.B.shape[1], 1))
        x = np.array([[optimum.point[state]] for state in states])
        return relative(value + optimum.K @ x, value, optimum.K)

    return worst(weights, judge, u, sp.ImmutableMatrix([list(states)]))


def cost_residual(weights: Weights, cost: Any, x0: Any, factor: Any) -> float:
    """Return the relative difference of a cost and the factor times the optimal ∫ xᵀQx + uᵀRu dt from x(0) = x₀."""

    def judge(optimum: Optimum) -> float:
        value = matrix_at(cost, optimum.point, (1, 1))
        X = cost_matrix(optimum, optimum.K)
        start = matrix_at(x0, optimum.point, (optimum.A.shape[0], 1))
        best = float(np.real(evaluate(factor, optimum.point))) * (start.T @ X @ start)
        return relative(value - best, value, best)

    return worst(weights, judge, cost, x0, factor)


def equations_residual(weights: Weights, equations: Sequence[Any]) -> float:
    """Return how far n(n+1)/2 expressions in p11, p12, … are from the entries of AᵀP + PA − P B R⁻¹ Bᵀ P + Q.

    Each may carry a constant factor, and their order is free. Infinite for another number of them.
    """
    n = weights.A.rows
    P = unknown_matrix(n)
    A, B, Q, R = weights
    left = difference(total(product(transpose(A), P), product(P, A), Q), product(P, B, inverse(R), transpose(B), P))
    pairs = [(i, j) for i in range(n) for j in range(i, n)]
    if len(equations) != len(pairs):
        return float("inf")
    listed = sp.ImmutableMatrix([list(equations)]).subs(
        {sp.Symbol(f"p{j + 1}{i + 1}"): P[i, j] for i, j in pairs if i != j}
    )
    source = PointSource(free_symbols(P) - free_symbols(weights.A))
    samples = []
    for optimum in optima(weights):
        for _ in range(4):
            point = {**optimum.point, **source.draw()}
            if free_symbols(listed) - set(point):
                return float("inf")
            stated = evaluate(left, point)
            samples.append(([stated[i, j] for i, j in pairs], list(evaluate(listed, point)[0])))
    stated = np.array([row for row, _ in samples])
    given = np.array([row for _, row in samples])
    return _matched(stated.T, given.T)


def _matched(stated: Array, given: Array) -> float:
    """Return the worst gap when each row stated is paired with the nearest row given that is left, up to a factor."""
    left = list(range(len(given)))
    worst_gap = 0.0
    for row in stated:
        gaps = {k: _gap_up_to_factor(row, given[k]) for k in left}
        best = min(gaps, key=lambda k: gaps[k])
        worst_gap = max(worst_gap, gaps[best])
        left.remove(best)
    return worst_gap


def _gap_up_to_factor(row: Array, other: Array) -> float:
    size, factor = np.vdot(other, other), np.vdot(other, row)
    if size == 0 or factor == 0:
        return float("inf") if np.abs(row).max() > 0 else 0.0
    return relative(row - factor / size * other, row)


def unknown_matrix(n: int) -> sp.ImmutableMatrix:
    """The symmetric matrix of p11, p12, …: indices from 1, from n = 10 on with an underscore."""
    between = "" if n < 10 else "_"
    return sp.ImmutableMatrix(n, n, lambda i, j: sp.Symbol(f"p{min(i, j) + 1}{between}{max(i, j) + 1}"))


def all_distinct(weights: Weights, matrices: Sequence[Any]) -> bool:
    """Whether no matrix is listed twice."""
    listed = [P for P in matrices if getattr(P, "shape", None) == weights.A.shape]
    for optimum in optima(weights, listed):
        values = [matrix_at(P, optimum.point, optimum.A.shape) for P in listed]
        for i, one in enumerate(values):
            if any(relative(one - other, one, other) < 1e-8 for other in values[:i]):
                return False
    return True


def number_of_solutions(weights: Weights) -> int:
    """Return how many real symmetric solutions there are, counted by invariant subspaces in floats.

    With A₊ = A − BK they correspond to the left-invariant subspaces of A₊ without an uncontrollable left eigenvector:
    Π (m + 1) over its real eigenvalues and conjugate pairs that are controllable, m the multiplicity (Willems 1971).
    Raises NotEvaluable where eigenvalues are too close to each other, or solutions form a continuum.
    """
    optimum = optima(weights)[0]
    loop, n = optimum.closed_loop, len(optimum.A)
    values = np.linalg.eigvals(loop)
    scale = 1 + np.abs(values).max()
    count, left = 1, [value for value in values if value.imag > -ON_THE_AXIS * scale]
    while left:
        first = left[0]
        near = [value for value in left if abs(value - first) < 1e-4 * scale]
        left = [value for value in left if abs(value - first) >= 1e-4 * scale]
        center = sum(near) / len(near)
        pencil = loop - center * np.eye(n)
        tolerance = 1e-6 * scale
        own = int(np.sum(np.linalg.svd(pencil, compute_uv=False) < tolerance))
        reached = own - int(np.sum(np.linalg.svd(np.hstack([pencil, optimum.B]), compute_uv=False) < tolerance))
        if own == 0:
            raise NotEvaluable(
                "eigenvalues of the closed loop lie too close to each other to count solutions in floats"
            )
        if own > 1 and reached:
            raise NotEvaluable("the solutions form a continuum")
        if reached:
            count *= len(near) + 1
    return count


def signature_word(optimum: Optimum, P: Any) -> str:
    """Return the definiteness of a symmetric matrix in words, by numpy.linalg.eigvalsh."""
    value = matrix_at(P, optimum.point, optimum.A.shape)
    eigenvalues = np.linalg.eigvalsh((value + value.T) / 2)
    zero = 1e-9 * max(1e-300, float(np.abs(eigenvalues).max()))
    return definiteness_word(int(np.sum(eigenvalues > zero)), int(np.sum(eigenvalues < -zero)), len(eigenvalues))


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


def solutions_in_floats(weights: Weights) -> list[Array]:
    """Return all real symmetric solutions where the eigenvalues of H are distinct: P = Y X⁻¹ by its eigenvectors.

    Raises NotEvaluable where eigenvalues coincide.
    """
    H = hamiltonian(optima(weights)[0])
    n = len(H) // 2
    values, vectors = np.linalg.eig(H)
    scale = float(np.abs(values).max())
    if min(abs(a - b) for i, a in enumerate(values) for b in values[:i]) < 1e-5 * scale:
        raise NotEvaluable("eigenvalues of the Hamiltonian matrix coincide")
    upper = [i for i in range(2 * n) if values[i].real < 0 and values[i].imag > -ON_THE_AXIS * scale]
    found = []
    for signs in product_of_signs(len(upper)):
        wanted = [sign * values[i] for sign, i in zip(signs, upper, strict=True)]
        wanted += [np.conj(value) for value in wanted if abs(value.imag) > ON_THE_AXIS * scale]
        chosen = [int(np.argmin(np.abs(values - value))) for value in wanted]
        X, Y = vectors[:n, chosen], vectors[n:, chosen]
        if np.linalg.svd(X, compute_uv=False)[-1] > 1e-9:
            found.append(np.real(Y @ np.linalg.inv(X)))
    return found


def product_of_signs(count: int) -> list[tuple[int, ...]]:
    """Return all sequences of ±1."""
    return [tuple(1 if number >> i & 1 else -1 for i in range(count)) for number in range(2**count)]
