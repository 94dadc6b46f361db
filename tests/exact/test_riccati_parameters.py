"""Riccati equations with parameters: at every value the solutions are solutions, the stabilizing one stabilizes."""

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import solve_continuous_are

from solver.exact import riccati
from solver.exact.optimal.root_choices import spelled_pair

b, c, q = sp.symbols("b c q", positive=True)
M = sp.ImmutableMatrix
R = sp.Rational
x = sp.Symbol("x")

PLANTS = {
    "damped": ([[0, 1], [-c, -b]], sp.zeros(2), 4),
    "growing": ([[0, 1], [-c, b]], sp.zeros(2), 4),
    "saddle": ([[0, 1], [c, -b]], sp.zeros(2), 4),
    "two real modes": ([[-b, 1], [0, -c]], sp.zeros(2), 4),
    "weighted": ([[0, 1], [0, -b]], sp.diag(q, 0), None),
    "one state": ([[b]], M([[q]]), 2),
}
POINTS = [{b: R(5), c: R(2), q: R(1, 3)}, {b: R(1, 2), c: R(3), q: R(7)}]
"""Real roots at the first, complex ones at the second."""


def floats(matrix, point):
    return np.array(sp.Matrix(matrix).subs(point).evalf(30).tolist(), dtype=float)


@pytest.mark.parametrize("plant", PLANTS)
def test_with_parameters_solutions_are_those_at_every_value(plant):
    A, Q, most = PLANTS[plant]
    A, Q, B = M(A), M(Q), M([0] * (len(A) - 1) + [1])
    found = riccati(A, B, Q, M([[1]]))
    assert found.count == most or most is None
    for point in POINTS:
        F, G, W = floats(A, point), floats(B, point), floats(Q, point)
        P = floats(found.stabilizing.P, point)
        assert np.linalg.eigvals(F - G @ G.T @ P).real.max() < 0
        if Q.is_zero_matrix:  # scipy finds P = 0 of a stable plant, and refuses nothing here
            assert np.abs(F.T @ P + P @ F - P @ G @ G.T @ P).max() < 1e-9
        else:
            assert np.abs(P - solve_continuous_are(F, G, W, np.eye(1))).max() < 1e-8
        for each in found.solutions:
            if each.radicand is None or each.radicand.subs(point) > 0:
                P = floats(each.P, point)
                assert np.abs(P - P.T).max() < 1e-9
                assert np.abs(F.T @ P + P @ F - P @ G @ G.T @ P + W).max() < 1e-8 * (1 + np.abs(P).max() ** 2)
                loop = np.poly(F - G @ G.T @ P)
                assert np.abs(loop - floats([each.polynomial], point)).max() < 1e-8 * (1 + np.abs(loop).max())
                assert sum(np.roots(loop).real > 0) == each.flips


@pytest.mark.parametrize("p", [x**2 + b * x + b**2, x**2 + 3 * b * x + b**2, x**2 - b, x**2 + x - 1, x**2 + 2 * x + 5])
def test_the_roots_of_a_quadratic_are_spelled_out(p):
    found = spelled_pair(sp.Poly(p, x).to_field())
    assert sp.expand((x - found[0]) * (x - found[1]) - p) == 0
