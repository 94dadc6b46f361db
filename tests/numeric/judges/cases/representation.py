"""Canonical forms by inspection, and what of G = (s + 2)/((s + 1)(s + 2)) its transfer function shows."""

import sympy as sp

from tests.numeric.judges.cases import Case, lists_near

M = sp.ImmutableMatrix
a, b = sp.symbols("a b")
LAST_ROW = M([[0, 1, 0], [0, 0, 1], [-6, a, b]])
FIRST_ROW = M([[a, b, -6], [1, 0, 0], [0, 1, 0]])
CHAIN = M([[-1, 1, 0], [0, -1, 0], [0, 0, -2]])
REAL = M([[-1, 2, 0], [-2, -1, 0], [0, 0, -3]])
HIDDEN = (M([[0, 1], [-2, -3]]), M([0, 1]), M([[2, 1]]), M([[0]]))


def companion(transposed, first):
    return lambda A: (A, {"transposed": transposed, "first": first})


CASES = [
    Case(
        "is_companion", companion(False, False), (LAST_ROW, M([[a]])), (LAST_ROW.T, FIRST_ROW, 2 * LAST_ROW, -LAST_ROW)
    ),
    Case("is_companion", companion(False, True), (FIRST_ROW,), (FIRST_ROW.T, LAST_ROW, M([[a, 1], [1, 1]]))),
    Case("is_companion", companion(True, False), (LAST_ROW.T,), (LAST_ROW, FIRST_ROW.T)),
    Case("is_companion", companion(True, True), (FIRST_ROW.T,), (FIRST_ROW, LAST_ROW.T)),
    Case("is_diagonal", lambda A: (A,), (sp.diag(1, a), M([[0]])), (M([[1, 1], [0, 2]]), M([[1, 0], [a, 2]]))),
    Case(
        "is_unit_vector",
        lambda v: (v, 1),
        (M([0, 1, 0]), M([[0, 1]])),
        (M([1, 0, 0]), M([0, 2, 0]), M([0, -1, 0]), M([0, 1, 1]), M([0, 0, 0])),
    ),
    Case(
        "is_chain_form",
        lambda A: (A, {"above": True, "real": False}),
        (CHAIN, sp.diag(-1, -2)),
        (CHAIN.T, M([[-1, 1], [0, -2]]), M([[-1, 2], [0, -1]]), M([[-1, 1, 1], [0, -1, 0], [0, 0, -1]])),
    ),
    Case(
        "is_chain_form",
        lambda A: (A, {"above": True, "real": True}),
        (REAL, REAL.T, sp.diag(-1, -2)),
        (M([[-1, 2], [2, -1]]), M([[-1, 2], [-2, -3]]), sp.diag(-1 + sp.I, -1 - sp.I), M([[-1, 2], [-3, -1]])),
    ),
    Case(
        "has_companion_blocks",
        lambda pair: (*pair, 1),
        ((LAST_ROW, M([0, 0, 1])), (LAST_ROW, None)),
        ((LAST_ROW, M([1, 0, 1])), (M([[0, 2, 0], [0, 0, 1], [1, 1, 1]]), None), (M([[1, 1], [1, 1]]), None)),
    ),
    Case("pole_residual", lambda answer: (HIDDEN, answer), ([-1], [sp.Float(-1)]), ([1], [-2], [-1, -2], [], [-1, -1])),
    Case("cancelled_residual", lambda answer: (HIDDEN, answer), ([-2],), ([2], [-1], [], [-2, -2], [-1, -2])),
    Case("zero_residual", lambda answer: (HIDDEN, answer), ([],), ([-2], [0])),
    Case(
        "zero_residual",
        lambda answer: ((HIDDEN[0], HIDDEN[1], M([[5, 1]]), HIDDEN[3]), answer),
        ([-5],),
        tuple(lists_near([-5])),
    ),
    Case("characteristic_residual", lambda A: (HIDDEN, A), (M([[-1]]),), (M([[1]]), M([[-2]]), HIDDEN[0])),
]
