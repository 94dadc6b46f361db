"""Numerator and denominator of a realization, by definition at points."""

import pytest
import sympy as sp

from solver.numeric.judges.design import fraction_of

s, a = sp.symbols("s a")


@pytest.mark.parametrize(
    ("A", "B", "C", "D"),
    [
        ([[0, 1], [-2, -3]], [0, 1], [[1, 4]], 0),
        ([[a, 1], [sp.sqrt(2), -1 / a]], [a, 1], [[1, sp.sqrt(3)]], 2),
        ([[1, 2, 0], [0, sp.I, 1], [3, 0, -sp.I]], [1, 0, a], [[0, 1, 1]], a),
        ([[sp.Float("0.5"), 1], [0, -3]], [1, 1], [[1, 0]], 1),
    ],
)
def test_the_fraction_is_that_of_the_definition(A, B, C, D):
    matrices = sp.ImmutableMatrix(A), sp.ImmutableMatrix(B), sp.ImmutableMatrix(C), sp.ImmutableMatrix([[D]])
    above, below = fraction_of(matrices, s)
    for at in (sp.Rational(7, 3), 2 + sp.I):
        point = {s: at, a: sp.Rational(5, 7)}
        A_at, B_at, C_at, D_at = (M.subs(point) for M in matrices)
        expected = (C_at * (at * sp.eye(A_at.rows) - A_at).inv() * B_at + D_at)[0, 0]
        assert abs(sp.N((above / below).subs(point) - expected)) < 1e-12
        assert abs(sp.N(below.subs(point) - (at * sp.eye(A_at.rows) - A_at).det())) < 1e-12
