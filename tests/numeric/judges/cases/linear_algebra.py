"""A = [[0, 1], [−2, −3]] with eigenvalues −1 and −2, and a matrix with one Jordan block of −1."""

import sympy as sp

from tests.numeric.judges.cases import Case, corruptions, lists_near

M = sp.ImmutableMatrix
A, V = M([[0, 1], [-2, -3]]), M([[1, 1], [-1, -2]])
BLOCK, CHAIN = M([[0, 1], [-1, -2]]), M([[1, 0], [-1, 1]])
J = M([[-1, 1], [0, -1]])
x = sp.Symbol("x")
CHI = x**2 + 3 * x + 2

CASES = [
    Case("spectrum_residual", lambda found: (A, found), ([-1, -2], [-2, -1]), tuple(lists_near([-1, -2]))),
    Case(
        "polynomial_residual",
        lambda p: (A, p, x),
        (CHI, (x + 1) * (x + 2)),
        (x**2 - 3 * x + 2, x**2 + 2 * x + 3, -CHI, 2 * CHI, CHI + sp.Rational(1, 1000), CHI * x, x + 1),
    ),
    Case(
        "eigenpair_residual",
        lambda vectors: (A, [-1, -2], vectors),
        (V, M([[-3, sp.Rational(1, 2)], [3, -1]])),
        (V.T, V[::-1, :], V[:, ::-1], M([[1, 0], [-1, 0]]), M([[1, 1], [-1, sp.Rational(-2001, 1000)]])),
    ),
    Case(
        "chain_residual",
        lambda answer: (BLOCK, *answer),
        ((CHAIN, J),),
        tuple((CHAIN, each) for each in corruptions(J)),
    ),
    Case(
        "left_residual",
        lambda answer: (A, *answer),
        ((V.inv(), M(sp.diag(-1, -2))),),
        ((V, M(sp.diag(-1, -2))), (V.inv(), A)),
    ),
    Case(
        "chains_residual",
        lambda vectors: (BLOCK, vectors),
        (CHAIN, 5 * CHAIN, M([[0, 1], [1, -1]])),
        (CHAIN.T, M([[1, 1], [-1, -1]]), sp.eye(2), M([[1, 0], [-1, sp.Rational(1001, 1000)]])),
    ),
    Case(
        "are_in_order",
        lambda answer: (A, *answer),
        ((V, [-1, -2]), (-3 * V, [sp.Float(-1.01), sp.Float(-1.99)]), (V[:, ::-1], [-2, -1])),
        ((V, [-2, -1]), (V[:, ::-1], [-1, -2]), (V, [-1]), (M([[1, 1], [-1, -1]]), [-1, -2])),
    ),
    Case(
        "is_jordan_form",
        lambda answer: answer if isinstance(answer, tuple) else (answer,),
        (J, sp.diag(-1, -2), (J, [-1, -1])),
        (J.T, M([[-1, 2], [0, -1]]), M([[-1, 1], [0, -2]]), M([[-1, -1], [0, -1]]), (sp.diag(-1, -2), [-2, -1])),
    ),
    Case(
        "same_jordan_structure",
        lambda answer: (BLOCK, answer),
        (J, J.T),
        (sp.diag(-1, -1), -J, M([[1, 1], [0, -1]]), M([[-1, 1], [0, sp.Rational(-1001, 1000)]])),
    ),
    Case("diagonalizable", lambda answer: (answer,), (A, sp.eye(2), sp.zeros(2)), (BLOCK, J, J.T)),
]
