"""Judges of controllability, observability and what hangs on them."""

import control
import numpy as np
import sympy as sp
from scipy.integrate import quad_vec
from scipy.linalg import expm, solve_continuous_lyapunov, solve_discrete_lyapunov

from tests.classroom.corpus.judges.registry import ImpossibleError, difference, judge, multiset, truth, unique, word
from tests.classroom.corpus.meanings import Meaning
from tests.hunt.asked import Point
from tests.hunt.judges.found import hidden, krylov, rank
from tests.hunt.plants import matrices


@unique("controllability", "controllability_matrix")
def controllability_matrix(point: Point):
    A, B, _, _ = matrices(point)
    return control.ctrb(A, B)


@unique("observability", "observability_matrix")
def observability_matrix(point: Point):
    A, _, C, _ = matrices(point)
    return control.obsv(A, C)


@unique("controllability", "determinant")
def determinant(point: Point):
    return np.linalg.det(controllability_matrix(point))


@unique("observability", "determinant")
def determinant_of_observability(point: Point):
    return np.linalg.det(observability_matrix(point))


@unique("controllability", "rank")
def rank_of_controllability(point: Point):
    return rank(controllability_matrix(point))


@unique("observability", "rank")
def rank_of_observability(point: Point):
    return rank(observability_matrix(point))


@judge("controllability", "controllable")
def controllable(point: Point, meant: Meaning):
    A, B, _, _ = matrices(point)
    return [word(truth(meant) == (rank(krylov(A, B)) == len(A)))]


@judge("observability", "observable")
def observable(point: Point, meant: Meaning):
    A, _, C, _ = matrices(point)
    return [word(truth(meant) == (rank(krylov(A.T, C.T)) == len(A)))]


@judge("controllability", "uncontrollable_modes")
@judge("stabilizability", "hidden_modes")
def unreached(point: Point, meant: Meaning):
    A, B, _, _ = matrices(point)
    return multiset(meant(), hidden(A, B))


@judge("observability", "unobservable_modes")
@judge("detectability", "hidden_modes")
def unseen(point: Point, meant: Meaning):
    A, _, C, _ = matrices(point)
    return multiset(meant(), hidden(A.T, C.T))


@judge("stabilizability", "stabilizable")
def stabilizable(point: Point, meant: Meaning):
    A, B, _, _ = matrices(point)
    return [word(truth(meant) == _decay(hidden(A, B), point.discrete))]


@judge("detectability", "detectable")
def detectable(point: Point, meant: Meaning):
    A, _, C, _ = matrices(point)
    return [word(truth(meant) == _decay(hidden(A.T, C.T), point.discrete))]


def _decay(modes: list[complex], discrete: bool) -> bool:
    return all(abs(mode) < 1 - 1e-9 if discrete else mode.real < -1e-9 for mode in modes)


@unique("controllability", "gramian")
def controllability_gramian(point: Point):
    A, B, _, _ = matrices(point)
    return _gramian(point, A, B)


@unique("observability", "gramian")
def observability_gramian(point: Point):
    A, _, C, _ = matrices(point)
    return _gramian(point, A.T, C.T)


def _gramian(point: Point, A: np.ndarray, B: np.ndarray) -> np.ndarray:
    horizon = point.option("horizon")
    if horizon is None:
        return solve_discrete_lyapunov(A, B @ B.T) if point.discrete else solve_continuous_lyapunov(A, -B @ B.T)
    if point.discrete:
        return sum((M := np.linalg.matrix_power(A, k) @ B) @ M.T for k in range(int(horizon)))
    return quad_vec(lambda t: (M := expm(A * t) @ B) @ M.T, 0, float(point.number(horizon).real), epsabs=1e-12)[0]


@judge("kalman_decomposition", "T")
def transformation(point: Point, meant: Meaning):
    A, B, C, _ = matrices(point)
    T = meant()
    if T.shape != A.shape or rank(T) < len(A):
        raise ImpossibleError("no transformation")
    if point.option("part", "controllable") == "controllable":
        first = rank(krylov(A, B))
        return np.linalg.solve(T, krylov(A, B))[first:]
    first = rank(krylov(A.T, C.T))
    return (krylov(A.T, C.T).T @ T)[:, first:]


@judge("kalman_decomposition", "orders")
def orders(point: Point, meant: Meaning):
    A, B, C, _ = matrices(point)
    r, q = rank(krylov(A, B)), rank(krylov(A.T, C.T))
    part = point.option("part", "controllable")
    if part == "full":
        both = rank(krylov(A.T, C.T).T @ krylov(A, B))
        return difference(meant(), [both, r - both, q - both, len(A) - r - q + both])
    return difference(meant(), [r, len(A) - r] if part == "controllable" else [q, len(A) - q])


@judge("kalman_decomposition", "hidden_modes")
def hidden_modes(point: Point, meant: Meaning):
    A, B, C, _ = matrices(point)
    pair = (A, B) if point.option("part", "controllable") == "controllable" else (A.T, C.T)
    return multiset(meant(), hidden(*pair))


@judge("parameter_condition", "values")
def values(point: Point, meant: Meaning):
    """The roots of det of the Krylov matrix, as a polynomial of the parameter through points."""
    name = point.option("parameter") or point.question.symbols[0]
    grid = np.arange(-6.0, 7.0)
    others = {str(letter): value for letter, value in point.values.items()}

    def det(value: float) -> float:
        A, B, C, _ = matrices(Point(point.question, others | {name: sp.Rational(str(value))}))
        return float(np.linalg.det(krylov(A, B) if _input(point) else krylov(A.T, C.T)).real)

    found = np.polyfit(grid, [det(value) for value in grid], 6)
    found = np.where(np.abs(found) < 1e-7, 0, found)
    roots = [r for r in np.roots(np.trim_zeros(found, "f")) if abs(r.imag) < 1e-4]
    distinct = [r.real for i, r in enumerate(roots) if all(abs(r - other) > 1e-3 for other in roots[:i])]
    return np.where(np.abs(left := multiset(meant(), distinct)) < 1e-5, 0, left)


def _input(point: Point) -> bool:
    return point.option("property", "uncontrollable") == "uncontrollable"
