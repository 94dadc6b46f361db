"""Comparing answers with other programs and with exact certificates: for the cross-checks.

The answers come from the derivation alone, without our own checks. What floating point cannot decide (a rank, a
multiple eigenvalue) is decided by an identity of rational matrices, or by a rank modulo a prime.
"""

import os
from typing import Any

import numpy as np
import sympy as sp
from hypothesis import Phase, settings
from sympy.polys.matrices import DomainMatrix

from solver.derivation import Answers
from solver.engine import given_of, yield_into
from solver.numeric.evaluation.compare import tolerance_of
from solver.problem.model import Part
from solver.systems import StateSpace
from solver.tasks import catalogue
from tests.helpers.tried import tried

PRIME = 2**61 - 1
TIMES = int(os.environ.get("CROSSCHECK_TIMES", "1"))
"""So many times the usual number of systems: for a search."""


def systems_tried(number: int) -> settings:
    """How many systems a cross-check tries; a failing one is not shrunk, which would take minutes."""
    return settings(tried(number * TIMES), phases=(Phase.explicit, Phase.reuse, Phase.generate))


def answers_of(task: str, plant: Any, method: str = "", **options: Any) -> Answers:
    """The answers of one method, not checked by us; raises Unsolved."""
    declared = catalogue()[task]
    method = method or declared.methods_for(plant.discrete)[0]
    defaults = {
        name: option.default for name, option in declared.options_for(method).items() if option.default is not None
    }
    given = given_of(Part("a", task, (method,), plant, {**defaults, **options}), method, {})
    answers: Answers = yield_into([], declared.methods[method].derive(given))
    return answers


def floats(M: Any) -> np.ndarray:
    """A matrix of numbers, rounded once from 30 digits."""
    M = sp.Matrix(M)
    return np.array(M.evalf(30).tolist(), dtype=complex).real.astype(float).reshape(M.shape)


def numbers(values: Any) -> np.ndarray:
    """Exact numbers as complex ones, in a fixed order."""
    return np.sort_complex(np.array([complex(sp.sympify(value).evalf(30)) for value in values]))


def arrays(plant: StateSpace) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """A, B, C, D as floats."""
    return floats(plant.A), floats(plant.B), floats(plant.C), floats(plant.D)


def as_matrix(value: Any) -> sp.Matrix:
    """A transfer function of one channel, which is given as an expression, as a matrix too."""
    return sp.Matrix(value) if isinstance(value, sp.MatrixBase) else sp.Matrix([[value]])


def close(ours: Any, theirs: Any, tolerance: float = 1e-7) -> bool:
    """Whether two arrays agree, relative to the largest entry."""
    ours, theirs = np.asarray(ours), np.asarray(theirs)
    if ours.shape != theirs.shape:
        return False
    scale = max(1.0, float(np.max(np.abs(theirs), initial=0.0)))
    return bool(np.max(np.abs(ours - theirs), initial=0.0) <= tolerance * scale)


def same(left: sp.MatrixBase, right: sp.MatrixBase) -> bool:
    """Whether two rational matrices are equal, exactly."""
    return left.shape == right.shape and all(sp.expand(a - b) == 0 for a, b in zip(left, right, strict=True))


def product(*factors: sp.MatrixBase) -> sp.Matrix:
    """A product of rational matrices."""
    result = _rational(factors[0])
    for factor in factors[1:]:
        result = result * _rational(factor)
    return result.to_Matrix()


def characteristic(A: sp.MatrixBase) -> list[sp.Rational]:
    """The coefficients of det(λI − A), exact, leading one first."""
    domain = _rational(A).domain
    return [domain.to_sympy(c) for c in _rational(A).charpoly()]


def coefficients(roots: Any) -> list[sp.Expr]:
    """The coefficients of the monic polynomial with these roots."""
    x = sp.Symbol("x")
    return sp.Poly(sp.expand(sp.prod([x - root for root in roots])), x).all_coeffs() if len(roots) else [sp.S.One]


def krylov(A: sp.MatrixBase, B: sp.MatrixBase) -> sp.Matrix:
    """[B, AB, …, Aⁿ⁻¹B]."""
    columns = [sp.Matrix(B)]
    for _ in range(A.rows - 1):
        columns.append(product(A, columns[-1]))
    return sp.Matrix.hstack(*columns)


def rank_modulo_a_prime(M: sp.MatrixBase) -> int:
    """The rank of a rational matrix by elimination modulo 2⁶¹ − 1: never more than the rank, all but never less."""
    rows = [[int(entry.p) * pow(int(entry.q), -1, PRIME) % PRIME for entry in row] for row in sp.Matrix(M).tolist()]
    rank = 0
    for column in range(M.cols):
        pivot = next((i for i in range(rank, len(rows)) if rows[i][column]), None)
        if pivot is None:
            continue
        rows[rank], rows[pivot] = rows[pivot], rows[rank]
        inverse = pow(rows[rank][column], -1, PRIME)
        for i in range(rank + 1, len(rows)):
            factor = rows[i][column] * inverse % PRIME
            if factor:
                rows[i] = [(a - factor * b) % PRIME for a, b in zip(rows[i], rows[rank], strict=True)]
        rank += 1
    return rank


def _rational(M: sp.MatrixBase) -> DomainMatrix:
    return DomainMatrix.from_Matrix(sp.Matrix(M)).convert_to(sp.QQ)


def is_error(residual):
    """Whether a residual is above what it allows: little where values are exact."""
    return not residual <= tolerance_of(residual)
