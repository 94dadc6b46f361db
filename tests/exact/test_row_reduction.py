"""Row reduction against sympy's, its recorded history, and null spaces."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from sympy import QQ

from solver import exact
from solver.exact.linear_algebra.row_reduction import Add, Scale, Swap
from tests.helpers.tried import tried

entries = st.integers(-3, 3)


def domain_rows(M):
    return tuple(tuple(QQ(int(e.p), int(e.q)) for e in M.row(i)) for i in range(M.rows))


def matrix(rows):
    return sp.Matrix([[sp.Rational(int(e.numerator), int(e.denominator)) for e in row] for row in rows])


@st.composite
def matrices(draw):
    n, width = draw(st.integers(1, 4)), draw(st.integers(1, 5))
    return sp.Matrix(n, width, [draw(entries) for _ in range(n * width)])


CASES = [
    sp.Matrix([[1, 2], [3, 4]]),
    sp.Matrix([[0, 1], [1, 0]]),
    sp.Matrix([[2, 4, 6], [1, 2, 3]]),
    sp.Matrix([[0, 0], [0, 0]]),
    sp.Matrix([[0, 2, 1], [0, 4, 2], [3, 1, 1]]),
    sp.Matrix([[sp.Rational(1, 2), sp.Rational(1, 3)], [sp.Rational(1, 4), 1]]),
    sp.Matrix([[5]]),
]


def check(M):
    found = exact.row_reduce(domain_rows(M))
    reduced, pivots = M.rref()
    assert matrix(found.reduced) == reduced
    assert found.pivots == pivots
    assert matrix(found.stages[0]) == M
    assert found.stages[-1] == found.reduced
    assert len(found.stages) == len(found.operations) + 1
    for before, operation, after in zip(found.stages, found.operations, found.stages[1:], strict=False):
        assert carried_out(matrix(before), operation) == matrix(after)


def carried_out(M, operation):
    """The row operation by sympy's own elementary operations."""
    match operation:
        case Swap(i, j):
            return M.elementary_row_op("n<->m", row1=i, row2=j)
        case Scale(i, factor):
            return M.elementary_row_op("n->kn", row=i, k=sp.Rational(str(factor)))
        case Add(i, j, factor):
            return M.elementary_row_op("n->n+km", row1=i, row2=j, k=sp.Rational(str(factor)))


@pytest.mark.parametrize("M", CASES)
def test_the_reduced_form_and_its_history(M):
    check(M)


@tried(80)
@given(matrices())
def test_random_matrices(M):
    check(M)


@tried(60)
@given(matrices())
def test_null_space_vectors_are_a_basis_of_the_null_space(M):
    basis = exact.null_space(exact.row_reduce(domain_rows(M)), QQ(1))
    assert len(basis) == M.cols - M.rank()
    for vector in basis:
        assert M * matrix([[entry] for entry in vector]) == sp.zeros(M.rows, 1)
    if basis:
        assert matrix(basis).rank() == len(basis)


def test_a_unit_pivot_is_preferred():
    first = exact.row_reduce(domain_rows(sp.Matrix([[3, 1], [1, 2]]))).operations[0]
    assert first == Swap(0, 1)


def test_a_minus_one_is_a_unit_too():
    found = exact.row_reduce(domain_rows(sp.Matrix([[3, 1], [-1, 2]])))
    assert found.operations[0] == Swap(0, 1)
