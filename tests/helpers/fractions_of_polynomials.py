"""Transfer functions from fractions, as tests give them, and their values by plain arithmetic."""

from typing import Any

import numpy as np
import sympy as sp

from solver.systems import TransferFunction

s = sp.Symbol("s")
z = sp.Symbol("z")


def plant(*rows: Any, discrete: bool = False) -> TransferFunction:
    """A transfer function from rows of (numerator, denominator), or from one such pair."""
    table = [[rows]] if not isinstance(rows[0], list) else list(rows)
    variable = z if discrete else s
    numerators = tuple(tuple(sp.expand(sp.sympify(p)) for p, _ in row) for row in table)
    denominators = tuple(tuple(sp.expand(sp.sympify(q)) for _, q in row) for row in table)
    matrix = sp.ImmutableMatrix([[sp.cancel(p / q) for p, q in row] for row in table])
    return TransferFunction(matrix, numerators, denominators, variable, discrete)


def values(answers: Any, point: complex, **parameters: float) -> np.ndarray:
    """C (xI − A)⁻¹ B + D at a point, by numpy."""
    A, B, C, D = (numbers(answers[name], **parameters) for name in "ABCD")
    return C @ np.linalg.solve(point * np.eye(len(A)) - A, B) + D


def fraction(system: TransferFunction, point: complex, **parameters: float) -> np.ndarray:
    """The fractions at a point, numerator and denominator apart."""
    at = {system.variable: point, **{sp.Symbol(name): value for name, value in parameters.items()}}
    rows = zip(system.numerators, system.denominators, strict=True)
    return np.array([[complex(p.subs(at)) / complex(q.subs(at)) for p, q in zip(*row, strict=True)] for row in rows])


def numbers(M: sp.MatrixBase, **parameters: float) -> np.ndarray:
    """A matrix of expressions as complex numbers."""
    at = {symbol: parameters[symbol.name] for symbol in M.free_symbols}
    return np.array(M.subs(at).evalf(20).tolist(), dtype=complex).reshape(M.shape)
