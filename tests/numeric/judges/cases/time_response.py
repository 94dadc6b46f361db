"""Functions of A = [[0, 1], [−2, −3]]."""

import sympy as sp

from tests.numeric.judges.cases import Case, corruptions
from tests.stated.values import PHI, POWER, A, k, t, x

M = sp.ImmutableMatrix
INVERSE = M([[sp.Rational(-3, 2), sp.Rational(-1, 2)], [1, 0]])

CASES = [
    Case(
        "exponential_residual",
        lambda Phi: (M(A), Phi, t),
        (M(PHI), M(PHI.applyfunc(sp.expand))),
        tuple(corruptions(PHI)),
    ),
    Case("power_residual", lambda Phi: (M(A), Phi, k), (M(POWER),), tuple(corruptions(POWER))),
    Case(
        "matrix_function_residual",
        lambda F: (M(A), 1 / x, x, F),
        (INVERSE, INVERSE.evalf(15)),
        tuple(corruptions(INVERSE)),
    ),
    Case(
        "residual_of_pairs",
        lambda pairs: (pairs,),
        ([(sp.sin(x) ** 2 + sp.cos(x) ** 2, sp.Integer(1))], [(x + x, 2 * x), (A, A)]),
        ([(x, -x)], [(x, x), (A, A.T)], [(x, x * sp.Rational(1001, 1000))]),
    ),
]
