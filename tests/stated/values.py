"""Symbols and matrices of the cases."""

import sympy as sp

s, t, z, k, x, tau, w = sp.symbols("s t z k x tau omega", positive=None)
a = sp.Symbol("a", real=True)
A = sp.Matrix([[0, 1], [-2, -3]])
F = s * sp.eye(2) - A
PHI = sp.Matrix(
    [
        [2 * sp.exp(-t) - sp.exp(-2 * t), sp.exp(-t) - sp.exp(-2 * t)],
        [-2 * sp.exp(-t) + 2 * sp.exp(-2 * t), -sp.exp(-t) + 2 * sp.exp(-2 * t)],
    ]
)
CHI = s**2 + 3 * s + 2
ADJ = sp.Matrix([[s + 3, 1], [-2, s]])
POWER = sp.Matrix(
    [[2 * (-1) ** k - (-2) ** k, (-1) ** k - (-2) ** k], [-2 * (-1) ** k + 2 * (-2) ** k, -((-1) ** k) + 2 * (-2) ** k]]
)
SINGULAR = sp.Matrix([[1, 2, 3], [2, 4, 6], [1, 0, a]])
alpha_0, alpha_1 = sp.symbols("alpha_0 alpha_1")
CAPITAL = sp.Symbol("A")
M = sp.ImmutableMatrix([[1, 2], [3, 4]])
m = r"\begin{bmatrix}1 & 2 \\ 3 & 4\end{bmatrix}"
I2 = r"\begin{bmatrix}1 & 0 \\ 0 & 1\end{bmatrix}"
