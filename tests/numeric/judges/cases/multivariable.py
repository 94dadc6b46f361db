"""Poles and zeros: a zero on the right, a pole twice, hidden modes, a system that is not square."""

import sympy as sp

from tests.numeric.judges.cases import Case, corruptions, lists_near

M = sp.ImmutableMatrix
s = sp.Symbol("s")
PLANT = (
    M([[0, 1, 0], [0, 0, 1], [6, -11, 6]]),
    M([[1, 0], [0, 1], [1, 1]]),
    M([[1, 0, 0], [0, 0, 1]]),
    M([[0, 0], [0, 0]]),
)
HIDDEN = (
    M.diag(-1, -2, -3, -4),
    M([[1, 0], [0, 1], [0, 0], [0, 0]]),
    M([[1, 1, 1, 0], [1, -1, 0, 0]]),
    M([[0, 0], [0, 0]]),
)
TALL = (M.diag(-1, -1), M([1, 1]), M([[4, -2], [1, 1], [2, -1]]), M([0, 0, 0]))
TWICE = (M.diag(-1, -1, -2), M([[1, 0], [0, 1], [1, 1]]), M([[1, 0, 1], [0, 1, 0]]), M([[0, 0], [0, 0]]))


def of_kind(plant, kind):
    return lambda zeros: (plant, zeros, kind)


CASES = [
    Case("zeros_residual", of_kind(PLANT, "transmission"), ([12],), (*lists_near([12]), [1], [5])),
    Case("zeros_residual", of_kind(PLANT, "invariant"), ([12],), tuple(lists_near([12]))),
    Case("zeros_residual", of_kind(PLANT, "input"), ([],), ([12], [1])),
    Case("zeros_residual", of_kind(HIDDEN, "transmission"), ([],), ([-4], [-3, -4])),
    Case("zeros_residual", of_kind(HIDDEN, "invariant"), ([-3, -4],), tuple(lists_near([-3, -4]))),
    Case("zeros_residual", of_kind(HIDDEN, "input"), ([-4, -3],), tuple(lists_near([-4, -3]))),
    Case("zeros_residual", of_kind(HIDDEN, "output"), ([-4],), ([], [-3], [-4, -4], [-4, -3])),
    Case("zero_polynomial_residual", lambda p: (PLANT, p, s), (s - 12,), (2 * s - 24, s - 11, (s - 12) ** 2)),
    Case("zero_polynomial_residual", lambda p: (TALL, p, s), (sp.Integer(1),), (s + 1, s - 1)),
    Case(
        "pole_polynomial_residual",
        lambda p: (TWICE, p, s),
        ((s + 1) ** 2 * (s + 2), sp.expand((s + 1) ** 2 * (s + 2))),
        ((s + 1) * (s + 2), (s + 1) * (s + 2) ** 2, (s + 1) ** 2 * (s + 2) + 1, 2 * (s + 1) ** 2 * (s + 2)),
    ),
    Case("pole_polynomial_residual", lambda p: (TALL, p, s), (s + 1,), ((s + 1) ** 2, s + 2)),
    Case(
        "directions_residual",
        lambda u: (PLANT, u, [12]),
        (M([1, -12]), M([-2, 24])),
        (*(u for u in corruptions(M([1, -12])) if u.shape == (2, 1) and u[1] != -12 * u[0]), M([0, 0])),
    ),
    Case("directions_residual", lambda u: (PLANT, u, None), (M([1, -12]),), (M([1, 1]), M([1, -11]))),
]
