"""Functions of a matrix in displays: sines by exponentials, roots and logarithms by what undoes them."""

import pytest
import sympy as sp

from solver import solve
from solver.derivation import CheckStatus, Claim, Status
from solver.displayed.matrix_functions import is_left, undone, with_matrices
from solver.numeric import check_claim
from solver.stated.algebra import product
from tests.helpers.asking import ask, system

A, B, k, t = sp.symbols("A B k t")
M = sp.ImmutableMatrix([[3, 1, 0], [-1, 1, 0], [1, 2, 2]])
FUNCTIONS = [
    sp.sin(A),
    sp.cos(A * t),
    sp.tan(A),
    sp.sinh(A / 2),
    sp.cosh(A),
    sp.exp(A * t),
    sp.sqrt(A),
    A ** sp.Rational(3, 2),
    sp.log(A),
    A**3 - 2 * A + 1,
    A**k,
    sp.exp(A) * sp.sin(A) + A**2,
]


def status(f, F):
    """How the check of the display f(A) = F ends."""
    left, right = undone(with_matrices(f, {"A": M}), F)
    assert not is_left(left)
    return check_claim(Claim(left, right), "display").status


@pytest.mark.parametrize("f", FUNCTIONS, ids=str)
def test_the_right_value_passes_and_no_other(f):
    F = ask("matrix_function", system(M), function=f).answers["F"]
    assert status(f, F) is CheckStatus.PASSED
    entry = sp.diag(0, 0, sp.Rational(1, 10**6))
    for wrong in (2 * F, sp.ImmutableMatrix(F.T), sp.ImmutableMatrix(F + entry)):
        assert status(f, wrong) is CheckStatus.FAILED


def test_what_is_not_known_is_left_as_it_is():
    assert with_matrices(sp.asin(A), {"A": M}) == sp.asin(A)
    assert with_matrices(A * B, {"A": M, "B": M}) == A * B, "the order of the factors is lost"
    assert is_left(with_matrices(sp.log(A) + A, {"A": M}))
    assert with_matrices(product(2, A), {"A": M}) == product(2, M)


@pytest.mark.parametrize("method", ["cayley_hamilton", "modal"])
@pytest.mark.parametrize("f", ["sin(A t)", "sqrt(A)", "log(A)", "A^k", "inv(A)", "cosh(A)", "A^3 - 2A + I"])
@pytest.mark.parametrize("rows", ["[[3, 1], [-1, 1]]", "[[2, 1], [1, 2]]"])
def test_every_display_of_a_function_of_a_matrix_is_judged(method, f, rows):
    asked = f'{{task: matrix_function, method: {method}, function: "{f}"}}'
    text = f"title: T\nsystem: {{matrix: {rows}}}\nfind: {{a: {asked}}}\n"
    part = solve(text).parts[0]
    assert part.status is Status.VERIFIED, part.reason
    assert {row.status for row in part.checks} == {CheckStatus.PASSED}
