"""Ranges of a in s² + 2s + a, a Routh array by hand, and what passes from input to output."""

import sympy as sp

from tests.numeric.judges.cases import Case, corruptions

M = sp.ImmutableMatrix
a = sp.Symbol("a", real=True)
A = M([[0, 1], [-a, -2]])
CUBIC = M([[0, 1, 0], [0, 0, 1], [-10, -6, -4]])
ARRAY = M([[1, 6], [4, 10], [sp.Rational(7, 2), 0], [10, 0]])
HIDDEN = M([[1, 0], [0, -1]])


def keeps_no_ratio(array):
    """Whether no row is that of the array up to a positive factor: a row may be multiplied by one."""
    return array.shape != ARRAY.shape or any(
        row[0] * right[1] != row[1] * right[0] or row[0] * right[0] <= 0
        for row, right in zip(array.tolist(), ARRAY.tolist(), strict=True)
    )


CASES = [
    Case(
        "counterexample",
        lambda condition: (A, condition, {"discrete": False}),
        (a > 0, sp.Lt(0, a), sp.And(a > 0, a > -3)),
        (a >= 0, a < 0, a > 1, a > -1, a > sp.Rational(1, 1000), sp.And(a > 0, a < 100), sp.true, sp.false),
    ),
    Case(
        "routh_fault",
        lambda array: (CUBIC, array, {"discrete": False}),
        (ARRAY, M([[1, 6], [2, 5], [sp.Rational(7, 2), 0], [5, 0]])),
        (*corruptions(ARRAY[:3, :]), *(each for each in corruptions(ARRAY) if keeps_no_ratio(each))),
    ),
    Case(
        "externally_stable",
        lambda pair: (HIDDEN, *pair, {}, {"discrete": False}),
        ((M([0, 1]), M([[1, 1]])), (M([1, 1]), M([[0, 1]])), (M([0, 10**6]), M([[1, 1]]))),
        ((M([1, 1]), M([[1, 1]])), (M([1, 0]), M([[1, 0]])), (M([sp.Rational(1, 10**14), 0]), M([[1, 0]]))),
    ),
]
