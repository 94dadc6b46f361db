"""Judges of linear quadratic problems: scipy's Riccati solver, the equations themselves."""

import numpy as np
from scipy.linalg import solve_continuous_are, solve_discrete_are

from tests.classroom.corpus.judges.design import _rest
from tests.classroom.corpus.judges.registry import ImpossibleError, judge, matrix, multiset, unique
from tests.classroom.corpus.meanings import Meaning
from tests.hunt.asked import Point
from tests.hunt.judges.optimal import weights
from tests.hunt.plants import matrices


def _regulator(point: Point) -> tuple[np.ndarray, ...]:
    """A, B, Q, R, N of the regulator, or of the dual one whose transposed gain is the filter's."""
    A, B, C, _ = matrices(point)
    A, B = (A.T, C.T) if point.question.task == "kalman_filter" else (A, B)
    return (A, B, *weights(point, len(A), B.shape[1], C))


def solution(point: Point) -> np.ndarray:
    """The stabilizing solution of the Riccati equation."""
    A, B, Q, R, N = _regulator(point)
    if point.option("own_P") is not None:
        return point.matrix(point.option("own_P"))
    return solve_discrete_are(A, B, Q, R, s=N) if point.discrete else solve_continuous_are(A, B, Q, R, s=N)


def gain(point: Point) -> np.ndarray:
    """The gain that goes with it."""
    A, B, _, R, N = _regulator(point)
    if point.option("own_K") is not None:
        return point.matrix(point.option("own_K"))
    P = solution(point)
    if point.discrete:
        return np.linalg.solve(R + B.T @ P @ B, B.T @ P @ A + N.T)
    return np.linalg.solve(R, B.T @ P + N.T)


unique("lqr", "P")(solution)
unique("kalman_filter", "P")(solution)


@judge("lqr", "K")
@judge("optimal_tracking", "K")
def K(point: Point, meant: Meaning):
    return matrix(meant, gain(point).shape) - gain(point)


@judge("kalman_filter", "L")
def L(point: Point, meant: Meaning):
    theirs = gain(point).T
    return matrix(meant, theirs.shape) - theirs


@unique("lqr", "closed_loop_A")
def closed_loop(point: Point):
    A, B, _, _ = matrices(point)
    return A - B @ gain(point)


@unique("kalman_filter", "error_A")
def error(point: Point):
    A, _, C, _ = matrices(point)
    return A - gain(point).T @ C


@judge("lqr", "eigenvalues")
@judge("kalman_filter", "eigenvalues")
def eigenvalues(point: Point, meant: Meaning):
    A, B, *_ = _regulator(point)
    return multiset(meant(), np.linalg.eigvals(A - B @ gain(point)))


@judge("lqr", "u")
def control_law(point: Point, meant: Meaning):
    left = []
    for x in np.random.default_rng(3).uniform(-2, 2, (5, len(matrices(point)[0]))):
        states = {f"x{i + 1}": value for i, value in enumerate(x)}
        left.append(np.ravel(meant(**states)) + gain(point) @ x)
    return left


@unique("lqr", "Q")
def weight(point: Point):
    return _regulator(point)[2]


@judge("lqr", "cost")
def cost(point: Point, meant: Meaning):
    """With the factor that is named; where none is, 1/2 and 1 are both usual."""
    x = point.matrix(point.option("initial_state"), column=True)
    whole = (x.T @ solution(point) @ x)[0, 0]
    factor = point.option("cost_factor")
    factors = [0.5, 1.0] if factor is None else [point.number(factor).real]
    if meant().size != 1:
        raise ImpossibleError("no number")
    return [min((meant().ravel()[0] - each * whole for each in factors), key=abs)]


@judge("optimal_tracking", "K_o")
def K_o(point: Point, meant: Meaning):
    F, N = _rest(point)
    theirs = N + gain(point) @ F
    return matrix(meant, theirs.shape) - theirs
