"""Hidden modes and ranks of A = diag(−1, −2, 3), of which B reaches the first; and of [[a, 1], [1, a]].

Of six mixed states an input does not reach the modes −4, 0, 0, the last two in a chain.
"""

import sympy as sp

from tests.numeric.judges.cases import Case, lists_near

M = sp.ImmutableMatrix
A, B = M(sp.diag(-1, -2, 3)), M([1, 0, 0])
CHAINED = M(
    [[7, -2, 6, -2, -4, 0], [-16, 3, -13, -1, 3, -6], [-18, 4, -15, 2, 6, -4], [0, 0, 0, -4, 0, 0],
     [-10, 2, -8, 0, 2, -3], [11, -2, 9, 0, -2, 4]]
)  # fmt: skip
CHAINED_INPUT = M([-2, 1, 2, 0, 0, 0])
a = sp.Symbol("a", real=True)
SYMMETRIC = M([[a, 1], [1, a]])
PLANT = (M(sp.diag(-1, -2)), M([1, 0]), M([[1, 1]]))

CASES = [
    Case(
        "hidden_modes_residual",
        lambda modes: (A, B, [sp.S(mode) for mode in modes]),
        ([-2, 3], [3, -2]),
        tuple(lists_near([-2, 3])),
    ),
    Case(
        "hidden_modes_residual",
        lambda modes: (CHAINED, CHAINED_INPUT, [sp.S(mode) for mode in modes]),
        ([-4, 0, 0], [0, -4, 0]),
        ([-4, 0, sp.Rational(1, 10**6)], [-4, 0, -4], [4, 0, 0], [-4, sp.I / 10**8, -sp.I / 10**8]),
    ),
    Case(
        "hidden_modes_decay",
        lambda pair: (pair[0], B[: pair[0].rows, :], {"discrete": pair[1]}),
        ((M(sp.diag(5, -2)), False), (M(sp.diag(5, sp.Rational(-1, 2))), True)),
        ((A, False), (M(sp.diag(-1, 0)), False), (M(sp.diag(-1, -2)), True)),
    ),
    Case(
        "rank_falls_where",
        lambda condition: (SYMMETRIC, condition),
        (sp.Eq(a, 1), sp.Eq(a, -1), sp.Eq(-1, a)),
        (sp.Eq(a, 0), sp.Eq(a, 2), sp.Eq(a, sp.Rational(1001, 1000))),
    ),
    Case(
        "every_fall_is_named",
        lambda conditions: (SYMMETRIC, conditions),
        ([sp.Eq(a, 1), sp.Eq(a, -1)], [sp.Eq(a, -1), sp.Eq(a, 1), sp.Eq(a, 7)], [sp.Eq(a**2, 1)]),
        ([sp.Eq(a, 1)], [sp.Eq(a, -1)], [], [sp.Eq(a, 1), sp.Eq(a, 2)]),
    ),
    Case(
        "every_fall_is_named",
        lambda conditions: (M([[a, 1], [sp.exp(a) - 2, sp.exp(-a)]]), conditions),
        ([sp.Eq(a * sp.exp(-a) + 2 - sp.exp(a), 0)],),
        ([sp.Eq(a * sp.exp(-a) + 2 + sp.exp(a), 0)], [], [sp.Eq(a, 1)]),
    ),
    Case(
        "hidden_polynomial_residual",
        lambda modes: ("controllable", PLANT, modes),
        ([-2], [sp.Float(-2)]),
        ([2], [-1], [], [-2, -2], [sp.Rational(-2001, 1000)]),
    ),
    Case(
        "separation_residual",
        lambda T: ("controllable", T, *PLANT),
        (sp.eye(2), M([[-3, 0], [0, 1]]), M([[2, 5], [0, -1]])),
        (M([[0, 1], [1, 0]]), M([[1, 0], [1, 1]]), M([[1, 1], [0, 0]]), M([[1, 0], [sp.Rational(1, 1000), 1]])),
    ),
    Case(
        "coordinates_residual",
        lambda answers: ("controllable", PLANT, answers),
        ({"A": PLANT[0]}, {"A": PLANT[0], "B": M([-7, 0])}, {"A": PLANT[0], "B": M([1, 0]), "C": M([[1, 5]])}),
        (
            {"A": M(sp.diag(-2, -1))},
            {"A": -PLANT[0]},
            {"B": M([1, 1])},
            {"A": PLANT[0], "B": M([1, 0]), "C": M([[2, 1]])},
        ),
    ),
    Case(
        "visible_part_residual",
        lambda answers: ("controllable", PLANT, answers),
        ({"A": M([[-1]])}, {"A": M([[-1]]), "B": M([[3]]), "C": M([[sp.Rational(1, 3)]])}),
        ({"A": M([[1]])}, {"A": M([[-2]])}, {"A": M([[-1]]), "B": M([[3]]), "C": M([[3]])}, {"B": M([[0]])}),
    ),
]
