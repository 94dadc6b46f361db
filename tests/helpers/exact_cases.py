"""Matrices for the tests of the kernels, by the structure they have, and the independent oracles."""

import mpmath
import numpy as np
import sympy as sp

x, t, k = sp.symbols("x t k")
a, b, theta = sp.symbols("a b theta", real=True)


def companion(polynomial):
    """Ones above the diagonal, the negative coefficients of a monic polynomial in x in the last row."""
    _, *low = sp.Poly(polynomial, x).all_coeffs()
    n = len(low)
    return sp.ImmutableMatrix(n, n, lambda i, j: -low[n - 1 - j] if i == n - 1 else int(j == i + 1))


def jordan(*blocks):
    """Upper Jordan blocks (eigenvalue, size) along the diagonal."""
    return sp.diag(*(sp.Matrix(m, m, lambda i, j, v=v: v if i == j else int(j == i + 1)) for v, m in blocks))


def hidden(J):
    """A matrix similar to J by an integer matrix of determinant one, with few zeros."""
    n = J.rows
    lower = sp.Matrix(n, n, lambda i, j: 1 if i == j else ((2 * i + j) % 3 - 1 if i > j else 0))
    upper = sp.Matrix(n, n, lambda i, j: 1 if i == j else ((i + 2 * j) % 3 - 1 if i < j else 0))
    T = lower * upper
    return sp.ImmutableMatrix(T * J * T.inv())


half = sp.Rational(1, 2)
RATIONAL = {
    "companion of simple roots": companion((x + 1) * (x + 2) * (x + 3)),
    "companion of a triple root": companion((x + 1) ** 3 * (x + 2)),
    "dense with simple roots": hidden(sp.diag(-3, -2, -1, 1)),
    "dense with fractions": hidden(sp.diag(-half, half, -sp.Rational(3, 4))),
    "one block of three": hidden(jordan((-2, 3))),
    "blocks of two and one of the same root": hidden(jordan((-1, 2), (-1, 1))),
    "blocks of three, two and one of the same root": hidden(jordan((2, 3), (2, 2), (2, 1))),
    "two blocks of two of the same root": hidden(jordan((-1, 2), (-1, 2))),
    "two roots with blocks of two": hidden(jordan((1, 2), (-1, 2))),
    "a nilpotent block": hidden(jordan((0, 3))),
    "nilpotent blocks of different sizes": hidden(jordan((0, 3), (0, 1))),
    "a nilpotent block beside another root": hidden(jordan((0, 2), (-1, 1))),
    "a multiple of the identity": sp.ImmutableMatrix(5 * sp.eye(3)),
    "one by one": sp.ImmutableMatrix([[-half]]),
    "zero, one by one": sp.ImmutableMatrix([[0]]),
    "zero": sp.ImmutableMatrix(sp.zeros(3)),
    "diagonal with equal entries": sp.ImmutableMatrix(sp.diag(1, 2, 1)),
    "triangular and defective": sp.ImmutableMatrix([[1, 2, 3], [0, 1, 4], [0, 0, 1]]),
}
COMPLEX = {
    "an oscillator": sp.ImmutableMatrix([[0, 1], [-1, 0]]),
    "a damped pair": companion(x**2 + 2 * x + 5),
    "a pair with a surd": companion(x**2 + x + 1),
    "two pairs": companion((x**2 + 2 * x + 5) * (x**2 + 2 * x + 2)),
    "a pair and a real root": hidden(sp.diag(sp.Matrix([[-1, 2], [-2, -1]]), -3)),
    "a double pair": companion((x**2 + 2 * x + 2) ** 2),
    "a double pair on the axis": companion((x**2 + 4) ** 2),
    "a triple pair": companion((x**2 + 1) ** 3),
    "a pair twice without chains": hidden(sp.diag(*[sp.Matrix([[1, 1], [-1, 1]])] * 2)),
    "a pair in the left half with fractions": sp.ImmutableMatrix([[-half, half], [-half, -half]]),
}
SURD = {
    "real surds": companion(x**2 - 4 * x + 1),
    "two pairs of surds": companion((x**2 + 3 * x + 1) * (x**2 + 4 * x + 2)),
    "a double pair of surds": companion((x**2 - 2) ** 2),
    "a pair of surds twice without chains": hidden(sp.diag(*[companion(x**2 - x - 1)] * 2)),
    "surds among the entries": sp.ImmutableMatrix([[0, sp.sqrt(2)], [sp.sqrt(2), 1]]),
}
DECIMAL = {
    "a cubic": companion(x**3 + x + 1),
    "a quartic": companion(x**4 + x + 1),
    "a cubic with real roots": companion(x**3 - 3 * x + 1),
    "a cubic and a rational root": companion((x**3 + 2 * x**2 + 3) * (x + 1)),
    "a quartic, dense": hidden(companion(x**4 + 3 * x**3 + 7 * x**2 + 5 * x + 3)),
    "a double cubic": companion((x**3 + x + 1) ** 2),
}
EXACT = RATIONAL | COMPLEX | SURD
NUMERIC = EXACT | DECIMAL


def floats(matrix, **values):
    """A matrix of expressions as complex floats: 30 digits by sympy's evaluation, rounded at the end."""
    point = {sp.Symbol(name): sp.sympify(value) for name, value in values.items()}
    return np.array(sp.Matrix(matrix).subs(point).evalf(30).tolist(), dtype=complex)


def exponential_of(matrix, time):
    """e^{At} by mpmath, at 40 digits, as floats."""
    with mpmath.workdps(40):
        entries = mpmath.matrix([[mpmath.mpmathify(sp.N(e, 40)) for e in row] for row in sp.Matrix(matrix).tolist()])
        return np.array(mpmath.expm(entries * time).tolist(), dtype=complex)


def is_zero(matrix):
    """Whether every entry multiplies out to zero."""
    return all(sp.expand(entry) == 0 or sp.radsimp(sp.expand(entry)) == 0 for entry in sp.Matrix(matrix).flat())


def each(cases):
    """Arguments of pytest.mark.parametrize with the names of the cases."""
    return {"argvalues": list(cases.values()), "ids": list(cases)}
