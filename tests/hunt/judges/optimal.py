"""Judges of linear quadratic problems: scipy's Riccati solver, the equations themselves."""

import numpy as np
import sympy as sp
from scipy.linalg import solve_continuous_are

from tests.hunt.asked import Point
from tests.hunt.judges.found import Found
from tests.hunt.plants import matrices

ARE = 1e-6
"""Riccati solvers of doubles lose half the digits at double eigenvalues."""


def weights(point: Point, n: int, m: int, C: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Q, R, N as the question gives them."""
    Q = np.eye(n) if point.option("Q") is None else point.matrix(point.option("Q"))
    if point.option("output_weight") is not None:
        W = point.matrix(point.option("output_weight"))
        Q = C.T @ (W if W.size > 1 else W[0, 0] * np.eye(len(C))) @ C
    if point.option("tolerances") is not None:
        Q = np.diag(1 / point.matrix(point.option("tolerances")).ravel() ** 2)
    R = np.eye(m) if point.option("R") is None else point.matrix(point.option("R"))
    N = np.zeros((n, m)) if point.option("N") is None else point.matrix(point.option("N"), column=True)
    return Q, R, N


def _residual(P: np.ndarray, A: np.ndarray, B: np.ndarray, Q: np.ndarray, R: np.ndarray, N: np.ndarray) -> np.ndarray:
    S = P @ B + N
    return A.T @ P + P @ A - S @ np.linalg.solve(R, S.T) + Q


def lqr(point: Point, found: Found) -> None:
    A, B, C, _ = matrices(point)
    Q, R, N = weights(point, len(A), B.shape[1], C)
    P, K, F = (found.matrix(name) for name in ("P", "K", "closed_loop_A"))
    found.same("Q", found.matrix("Q"), Q)
    found.same("R", found.matrix("R"), R)
    found.same("Riccati equation", _residual(P, A, B, Q, R, N), np.zeros_like(A), 1e-8 * max(1, np.max(abs(P))))
    found.same("K", K, np.linalg.solve(R, B.T @ P + N.T))
    found.same("A − BK", F, A - B @ K)
    found.spectrum("eigenvalues", found.list("eigenvalues"), F)
    found.holds("the loop is not stable", np.all(found.list("eigenvalues").real < 1e-9))
    if np.all(np.linalg.eigvals(F).real < -1e-4):
        _of_scipy(found, P, (A, B, Q, R, N))
    states = {f"x{i + 1}": sp.Rational(i + 2, 3) for i in range(len(A))}
    x = np.array([[float(value)] for value in states.values()])
    found.same("u", found.matrix("u", **states), -K @ x)
    if "cost" in found:
        x0 = point.matrix(point.option("initial_state"), column=True)
        factor = point.number(point.option("cost_factor", "1/2")).real
        found.same("cost", found.matrix("cost"), factor * x0.T @ P @ x0)
    if "equations" in found:
        _equations(found, (A, B, Q, R, N))


def _of_scipy(found: Found, P: np.ndarray, of: tuple[np.ndarray, ...]) -> None:
    A, B, Q, R, N = of
    try:
        found.same("scipy", P, solve_continuous_are(A, B, Q, R, s=N), ARE)
    except np.linalg.LinAlgError:
        return


def _equations(found: Found, of: tuple[np.ndarray, ...]) -> None:
    """Each expression is an entry of the equation, and each solution listed is one."""
    n = len(of[0])
    P = np.ones((n, n)) + np.eye(n)
    letters = {f"p{min(i, j) + 1}{max(i, j) + 1}": sp.Float(P[i, j], 20) for i in range(n) for j in range(n)}
    theirs = _residual(P, *of)
    ours = [found.numbers(each)[0, 0] for each in found.exactly("equations", **letters)]
    found.same("equations", ours, [theirs[i, j] for i in range(n) for j in range(i, n)])
    for P in map(found.numbers, found.exactly("solutions") if "solutions" in found else []):
        found.same("a solution", _residual(P, *of), np.zeros((n, n)), 1e-8 * max(1, np.max(abs(P))))


def kalman_filter(point: Point, found: Found) -> None:
    A, _, C, _ = matrices(point)
    Q, R, N = weights(point, len(A), len(C), C)
    P, L, F = (found.matrix(name) for name in ("P", "L", "error_A"))
    found.same("Riccati equation", _residual(P, A.T, C.T, Q, R, N), np.zeros_like(A), 1e-8 * max(1, np.max(abs(P))))
    found.same("L", L, np.linalg.solve(R, C @ P).T)
    found.same("A − LC", F, A - L @ C)
    found.spectrum("eigenvalues", found.list("eigenvalues"), F)
    if np.all(np.linalg.eigvals(F).real < -1e-4):
        _of_scipy(found, P, (A.T, C.T, Q, R, N))
    if "equations" in found:
        _equations(found, (A.T, C.T, Q, R, N))


def optimal_tracking(point: Point, found: Found) -> None:
    A, B, C, D = matrices(point)
    K, F, N, K_o = (found.matrix(name) for name in ("K", "F", "N", "K_o"))
    if point.option("gain") is not None:
        found.same("K", K, point.matrix(point.option("gain")))
    else:
        Q, R, cross = weights(point, len(A), B.shape[1], C)
        found.same("K", K, np.linalg.solve(R, B.T @ solve_continuous_are(A, B, Q, R, s=cross)), ARE)
    found.same("A F + B N = 0", A @ F + B @ N, np.zeros((len(A), len(C))))
    found.same("C F + D N = I", C @ F + D @ N, np.eye(len(C)))
    found.same("K_o = N + K F", K_o, N + K @ F)
