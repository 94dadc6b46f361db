"""Judges of stability: eigenvalues by numpy, Lyapunov's equation by scipy, conditions at many points."""

import numpy as np
from scipy.linalg import solve_continuous_lyapunov, solve_discrete_lyapunov

from tests.hunt.asked import Point, points
from tests.hunt.judges.found import Found, hidden, rank
from tests.hunt.plants import fraction, loop, matrices

SLACK = 1e-6
TRIED = 40


def spectrum_of(point: Point) -> np.ndarray:
    """The roots that decide: of the polynomial, of the denominator of the loop, or the eigenvalues."""
    system = point.question.system
    if "polynomial" in system:
        return np.roots(fraction(point, system["polynomial"])[0])
    if "transfer_function" in system:
        return np.roots(loop(point)[1])
    return np.linalg.eigvals(matrices(point)[0])


def margin(point: Point) -> float:
    """The largest real part (discrete: the largest size less one)."""
    roots = spectrum_of(point)
    return float(np.max(np.abs(roots) - 1 if point.discrete else roots.real, initial=-1.0))


def stability(point: Point, found: Found) -> None:
    A, B, C, _ = matrices(point)
    if "eigenvalues" in found:
        found.spectrum("eigenvalues", found.list("eigenvalues"), A)
    found.holds("verdict", found.values["verdict"] == _verdict(point, A))
    if "bibo_stable" in found:
        lost = [*hidden(A, B), *hidden(A.T, C.T)] if B.size and C.size else []
        seen = _without(np.linalg.eigvals(A), lost)
        bounded = all(abs(p) < 1 - SLACK if point.discrete else p.real < -SLACK for p in seen)
        found.holds("BIBO stable", bool(found.values["bibo_stable"]) == bounded)
    if "P" in found:
        Q = point.matrix(point.option("Q")) if point.option("Q") else np.eye(len(A))
        F = A if point.option("dual") else A.T
        theirs = solve_discrete_lyapunov(F, Q) if point.discrete else solve_continuous_lyapunov(F, -Q)
        found.same("P", found.matrix("P"), theirs)
    if "right_half_plane_roots" in found:
        found.holds("right half plane", found.number("right_half_plane_roots") == _unstable(point))


def _without(values: np.ndarray, taken: list[complex]) -> list[complex]:
    left = list(values)
    for each in taken:
        near = min(left, key=lambda value: abs(value - each), default=None)
        if near is not None and abs(near - each) < 1e-5:
            left.remove(near)
    return left


def _unstable(point: Point) -> int:
    roots = spectrum_of(point)
    return int(np.sum((np.abs(roots) - 1 if point.discrete else roots.real) > SLACK))


def _verdict(point: Point, A: np.ndarray) -> str:
    values = np.linalg.eigvals(A)
    sizes = np.abs(values) - 1 if point.discrete else values.real
    if np.all(sizes < -SLACK):
        return "asymptotically stable"
    border = values[np.abs(sizes) <= SLACK]
    simple = all(len(A) - rank(A - value * np.eye(len(A))) == np.sum(np.abs(values - value) < 1e-5) for value in border)
    return "marginally stable" if np.all(sizes <= SLACK) and simple else "unstable"


def stability_range(point: Point, found: Found) -> None:
    _condition(point, found)


def _condition(point: Point, found: Found) -> None:
    """The condition is true exactly where the roots are stable, at points of any size."""
    condition = found.values["condition"]
    for wide in (False, True):
        for other in points(point.question, TRIED // 2, widely=wide):
            gap = margin(other)
            if abs(gap) > SLACK:
                told = condition if isinstance(condition, bool) else bool(condition.subs(other.values))
                found.holds(f"condition at {other.values}", told == (gap < 0))


def routh_hurwitz(point: Point, found: Found) -> None:
    polynomial = fraction(point, point.question.system["polynomial"])[0]
    roots, n = np.roots(polynomial), len(polynomial) - 1
    if "right_half_plane_roots" in found:
        found.holds("right half plane", found.number("right_half_plane_roots") == np.sum(roots.real > 1e-4))
        on_axis = np.sum(np.abs(roots.real) <= 1e-4)
        found.holds("imaginary axis", found.number("imaginary_axis_roots") == on_axis)
        found.holds("stable", bool(found.values["stable"]) == bool(np.all(roots.real < -1e-4)))
    if "condition" in found:
        _condition(point, found)
    if "determinants" in found:
        padded = np.concatenate([np.zeros(2 * n), polynomial, np.zeros(2 * n)])
        H = np.array([[padded[2 * n + 2 * (j + 1) - (i + 1)] for j in range(n)] for i in range(n)])
        theirs = [np.linalg.det(H[: i + 1, : i + 1]) for i in range(n)]
        found.same("determinants", found.list("determinants"), theirs)
    if "array" in found and "epsilon" not in str(found.values["array"]):
        _array(found, polynomial)


def _array(found: Found, polynomial: np.ndarray) -> None:
    """Rows up to a positive factor, as long as no zero stands in the first column."""
    ours = found.matrix("array").real
    width = ours.shape[1]
    rows = [np.resize(np.append(polynomial[i::2], np.zeros(width)), width) for i in (0, 1)]
    for i in range(len(polynomial)):
        if i > 1:
            above, upper = rows[i - 1], rows[i - 2]
            row = np.append(upper[1:], 0) - upper[0] / above[0] * np.append(above[1:], 0)
            rows.append(row)
        row = np.where(np.abs(rows[i]) < 1e-9, 0, rows[i])
        if row[0] == 0:
            return
        found.same(f"row {i}", ours[i] / abs(ours[i, 0]), row / abs(row[0]))


KINDS = {True: "stable", False: "unstable"}


def phase_portrait(point: Point, found: Found) -> None:
    A = matrices(point)[0]
    found.spectrum("eigenvalues", found.list("eigenvalues"), A)
    found.holds("kind", found.values["kind"] == _kind(A))


def _kind(A: np.ndarray) -> str:
    tr, det = np.trace(A), np.linalg.det(A)
    discriminant = tr**2 - 4 * det
    scale = max(1.0, np.linalg.norm(A))
    if rank(A) == 0:
        return "all points are equilibria"
    if abs(det) < 1e-9 * scale**2:
        return "shear" if abs(tr) < 1e-9 * scale else "line of equilibria"
    if det < 0:
        return "saddle"
    word = KINDS[bool(tr < 0)]
    if abs(discriminant) < 1e-9 * scale**2:
        return f"{word} star" if rank(A - tr / 2 * np.eye(2)) == 0 else f"{word} degenerate node"
    if discriminant > 0:
        return f"{word} node"
    return "center" if abs(tr) < 1e-9 * scale else f"{word} focus"
