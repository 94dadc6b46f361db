"""Formulas of `solver.stated.matrices`: what they are equal to, and how they are printed."""

import sympy as sp
from sympy import eye

from solver.stated.algebra import difference, product, total
from solver.stated.matrices import (
    adjugate,
    cofactor,
    determinant,
    entrywise_product,
    inverse,
    kronecker,
    matrix_of,
    minor,
    partitioned,
    rank,
    trace,
    transpose,
    vectorized,
)
from tests.stated.values import ADJ, CHI, I2, SINGULAR, A, F, M, a, m, s

LARGE = sp.ImmutableMatrix([[2, a, 0, 1], [0, 1, -3, 4], [5, 0, 1, 0], [1, 1, 0, 7]])

RIGHT = [
    (determinant(F), CHI),
    (determinant(SINGULAR), 0),
    (determinant(sp.Matrix([[a]])), a),
    (adjugate(F), ADJ),
    (adjugate(SINGULAR), sp.Matrix([[4 * a, -2 * a, 0], [6 - 2 * a, a - 3, 0], [-4, 2, 0]])),
    (adjugate(sp.Matrix([[a]])), sp.Matrix([[1]])),
    (adjugate(LARGE), LARGE.adjugate()),
    (inverse(LARGE), LARGE.inv()),
    (determinant(LARGE), LARGE.det()),
    (partitioned(sp.Matrix([[a, 5], [7, 2]]), (1,), (1,)), sp.Matrix([[a, 5], [7, 2]])),
    (trace(sp.Matrix([[a, 5], [7, 2]])), a + 2),
    (rank(SINGULAR), 2),
    (inverse(F), ADJ / CHI),
    (inverse(s + 1), 1 / (s + 1)),
    (transpose(sp.Matrix([[a, 1, 2]])), sp.Matrix([a, 1, 2])),
    ([determinant(A), trace(A)], [2, -3]),
    (minor(SINGULAR, 1, 3), -4),
    (minor(sp.Matrix([[a]]), 1, 1), 1),
    (cofactor(SINGULAR, 1, 2), 6 - 2 * a),
    (cofactor(F, 2, 2), s),
    (kronecker(sp.Matrix([[1, a]]), sp.Matrix([[0, 1], [2, 3]])), sp.Matrix([[0, 1, 0, a], [2, 3, 2 * a, 3 * a]])),
    (matrix_of([[total(product(a, 2), 1), 0, s]]), sp.Matrix([[2 * a + 1, 0, s]])),
    (kronecker(F, sp.eye(2)), sp.kronecker_product(F, sp.eye(2))),
    (entrywise_product(sp.Matrix([[1, a], [2, s]]), sp.Matrix([[3, a], [1, 2]])), sp.Matrix([[3, a**2], [2, 2 * s]])),
    (vectorized(sp.Matrix([[1, 2], [a, 4]])), sp.Matrix([1, a, 2, 4])),
]

PRINTED = [
    (
        matrix_of([[product(2, 3), total()], [total(product(2, a), product(-1, 3)), 1]]),
        r"\begin{bmatrix}2 \cdot 3 & 0 \\ 2a - 3 & 1\end{bmatrix}",
    ),
    (determinant(M), rf"\det{m}"),
    (determinant(difference(product(s, eye(2)), M)), rf"\det\left(s{I2} - {m}\right)"),
    (adjugate(M), rf"\operatorname{{adj}}{m}"),
    (partitioned(M, (1,), (1,)), r"\left[\begin{array}{c|c}1 & 2 \\ \hline 3 & 4\end{array}\right]"),
    (partitioned(M, (), (1,)), r"\left[\begin{array}{c|c}1 & 2 \\ 3 & 4\end{array}\right]"),
    (partitioned(M, (0, 2), (2,)), m),
    (rank(M), rf"\operatorname{{rank}}{m}"),
    (trace(product(M, M)), rf"\operatorname{{tr}}\left({m}{m}\right)"),
    (inverse(M), rf"{m}^{{-1}}"),
    (inverse(sp.Matrix([[1]])), "1"),
    (inverse(sp.Matrix([[s + 1]])), r"\frac{1}{s + 1}"),
    (inverse(difference(product(s, eye(2)), M)), rf"\left(s{I2} - {m}\right)^{{-1}}"),
    (transpose(M), rf"{m}^{{T}}"),
    (minor(M, 1, 2), rf"\operatorname{{minor}}_{{12}}{m}"),
    (cofactor(M, 1, 2), rf"\operatorname{{cof}}_{{12}}{m}"),
    (kronecker(M, M), rf"{m} \otimes {m}"),
    (kronecker(total(M, M), M), rf"\left({m} + {m}\right) \otimes {m}"),
    (entrywise_product(M, transpose(M)), rf"{m} \circ {m}^{{T}}"),
    (product(2, kronecker(M, M)), rf"2\left({m} \otimes {m}\right)"),
    (vectorized(M), rf"\operatorname{{vec}}{m}"),
]
