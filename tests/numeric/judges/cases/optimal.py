"""The double integrator with Q = diag(1, 0), R = 1: P = [[√2, 1], [1, √2]], K = [1, √2], by hand."""

import sympy as sp

from solver.numeric.judges.optimal import Weights
from tests.numeric.judges.cases import Case, corruptions, lists_near

M = sp.ImmutableMatrix
ROOT = sp.sqrt(2)
WEIGHTS = Weights(M([[0, 1], [0, 0]]), M([0, 1]), M([[1, 0], [0, 0]]), M([[1]]))
P, K = M([[ROOT, 1], [1, ROOT]]), M([[1, ROOT]])
UNSEEN = Weights(M([[1, 0], [0, 1]]), M(sp.eye(2)), M([[0, 0], [0, 1]]), M(sp.eye(2)))
"""The weight does not see the first state: P = diag(0, 1 + √2) is the smallest solution."""
OTHER = M([[-ROOT, 1], [1, -ROOT]])
"""The solution of the Riccati equation that makes all eigenvalues unstable."""

IN_DECIMALS = P.evalf(15)
UNKNOWNS = sp.symbols("p11 p12 p22")
p11, p12, p22 = UNKNOWNS
EQUATIONS = [1 - p12**2, p11 - p12 * p22, 2 * p12 - p22**2]
x1, x2 = sp.symbols("x1 x2")
WORDS = ["positive definite", "negative definite"]


CASES = [
    Case(
        "gain_residual", lambda answer: (WEIGHTS, answer), (K, K.evalf(15), M([[1, 2 / ROOT]])), tuple(corruptions(K))
    ),
    Case(
        "control_residual",
        lambda u: (WEIGHTS, u, (x1, x2)),
        (-x1 - ROOT * x2, M([-x1 - ROOT * x2])),
        (x1 + ROOT * x2, -x1 + ROOT * x2, -ROOT * x1 - x2, -x1 - sp.Rational(1415, 1000) * x2, -x1 - ROOT * x2 + 1),
    ),
    Case(
        "cost_residual",
        lambda answer: (WEIGHTS, answer[0], M(answer[1]), answer[2]),
        ((ROOT, [1, 0], 1), (ROOT / 2, [1, 0], sp.Rational(1, 2)), (2 * ROOT + 2, [1, 1], 1)),
        (
            (-ROOT, [1, 0], 1),
            (ROOT, [1, 0], sp.Rational(1, 2)),
            (2 * ROOT, [1, 1], 1),
            (sp.Rational(1415, 1000), [1, 0], 1),
        ),
    ),
    Case(
        "loop_residual",
        lambda answer: (WEIGHTS, answer),
        (M([[0, 1], [-1, -ROOT]]), M([[0, 1], [-1, -ROOT]]).evalf(15)),
        tuple(corruptions([[0, 1], [-1, -ROOT]])),
    ),
    Case("riccati_residual", lambda answer: (WEIGHTS, answer), (P, IN_DECIMALS, OTHER), tuple(corruptions(P))[1:]),
    Case("stabilizes", lambda answer: (WEIGHTS, answer), (P, IN_DECIMALS, 2 * P), (OTHER, -P, sp.zeros(2))),
    Case(
        "symmetry_residual",
        lambda answer: (WEIGHTS, answer),
        (P, OTHER, IN_DECIMALS),
        (M([[ROOT, 1], [-1, ROOT]]), M([[ROOT, 1], [sp.Rational(1001, 1000), ROOT]]), M([[ROOT, sp.I], [sp.I, ROOT]])),
    ),
    Case(
        "hamiltonian_spectrum_residual",
        lambda answer: (WEIGHTS, answer),
        ([(-1 + sp.I) / ROOT, (-1 - sp.I) / ROOT], [(-1 - sp.I) / ROOT, (-1 + sp.I) / ROOT]),
        tuple(lists_near([(-1 + sp.I) / ROOT, (-1 - sp.I) / ROOT])),
    ),
    Case(
        "equations_residual",
        lambda answer: (WEIGHTS, answer),
        (EQUATIONS, EQUATIONS[::-1], [-EQUATIONS[0], 2 * EQUATIONS[1], EQUATIONS[2] / 3]),
        (
            EQUATIONS[:2],
            [1 + p12**2, *EQUATIONS[1:]],
            [EQUATIONS[0], p11 + p12 * p22, EQUATIONS[2]],
            [EQUATIONS[0], EQUATIONS[0], EQUATIONS[2]],
            [*EQUATIONS[:2], p12 - p22**2],
        ),
    ),
    Case("all_distinct", lambda answer: (WEIGHTS, answer), ([P, OTHER], [P]), ([P, P], [P, OTHER, IN_DECIMALS])),
    Case(
        "definiteness_holds",
        lambda answer: (WEIGHTS, *answer),
        ((WORDS, [P, OTHER]), (WORDS[::-1], [OTHER, P]), (["Positive-definite"], [P]), (WORDS[::-1], None)),
        (
            (WORDS, [OTHER, P]),
            (["positive semidefinite", "negative definite"], [P, OTHER]),
            (["indefinite"], [P]),
            (WORDS[:1], [P, OTHER]),
            (WORDS[:1], None),
        ),
    ),
    Case(
        "is_minimal",
        lambda answer: (UNSEEN, answer),
        (M([[0, 0], [0, 1 + ROOT]]), M([[0, 0], [0, 1 + ROOT]]).evalf(15)),
        (M([[2, 0], [0, 1 + ROOT]]), M([[0, 0], [0, 1 - ROOT]]), M([[0, 1], [1, 3]])),
    ),
]
