"""Inverses by cofactors: what the lines show is what numpy finds."""

import numpy as np
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from solver.arithmetic.inverses import cofactors, inverted
from solver.exact import determinant_and_adjugate
from solver.numeric import check_steps
from solver.render.wording import Wording

TUTOR = Wording(detail="tutor")


def displayed(steps):
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


def matrix(*rows):
    return sp.ImmutableMatrix(rows)


def numbers(n):
    return st.lists(st.integers(-9, 9), min_size=n * n, max_size=n * n).map(lambda e: sp.ImmutableMatrix(n, n, e))


@given(st.one_of(numbers(2), numbers(3), numbers(4)))
def test_every_line_holds_of_sympys_inverse_and_of_no_other(M):
    assume(round(np.linalg.det(np.array(M.tolist(), dtype=float))) != 0)
    value = sp.ImmutableMatrix(sp.Matrix(M).inv("LU"))
    steps = inverted("T", M, value)
    assert all(check.status == "passed" for check in check_steps(steps))
    wrong = inverted("T", M, value + sp.ImmutableMatrix(sp.eye(M.rows)))
    assert not wrong or any(check.status == "failed" for check in check_steps(wrong))


@given(numbers(3))
def test_the_cofactors_make_the_adjugate(M):
    steps = cofactors(M, determinant_and_adjugate(M)[1])
    assert all(check.status == "passed" for check in check_steps(steps))
    A = np.array(M.tolist(), dtype=float)
    for step in steps:
        adj = np.array(step.claims["value"].right.tolist(), dtype=float)
        assert np.allclose(A @ adj, np.linalg.det(A) * np.eye(3))


def test_of_two_rows_the_diagonal_is_exchanged():
    shown = displayed(inverted("T", matrix([1, 1], [-1, -2]), matrix([2, 1], [-1, -1])))
    assert r"T^{-1} = \frac{1}{-2 - (-1)}\begin{bmatrix}-2 & -1 \\ 1 & 1\end{bmatrix} = -\begin{bmatrix}" in shown


def test_cofactors_have_their_signs_and_are_transposed():
    M = matrix([1, 1, 1], [-1, -2, -3], [1, 4, 9])
    steps = inverted("T", M, sp.ImmutableMatrix(M.inv()))
    assert [step.kind for step in steps] == ["expansion", "minors", "terms", "cofactors", "divided"]
    shown = displayed(steps)
    assert r"-(9 - 4) & 9 - 1 & -(4 - 1)" in shown
    assert r"T^{-1} = \frac{1}{\det T}\operatorname{adj} T = -\frac{1}{2}\begin{bmatrix}" in shown


def test_a_large_inverse_is_multiplied_back():
    M = matrix([1, 2, 0, 0], [0, 1, 3, 0], [0, 0, 1, 4], [1, 0, 0, 1])
    (step,) = inverted("T", M, sp.ImmutableMatrix(M.inv()))
    assert step.claims["value"].right == sp.eye(4)


def test_a_diagonal_matrix_is_inverted_by_a_look():
    assert inverted("T", matrix([2, 0], [0, 3]), matrix([sp.Rational(1, 2), 0], [0, sp.Rational(1, 3)])) == ()
