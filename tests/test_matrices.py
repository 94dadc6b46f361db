"""The entries of matrices of every kind."""

import pytest
import sympy as sp

from solver.matrices import entries

a = sp.Symbol("a")


@pytest.mark.parametrize("kind", [sp.ImmutableMatrix, sp.Matrix, sp.ImmutableSparseMatrix, sp.SparseMatrix])
@pytest.mark.parametrize("rows", [[[1, a, 0], [sp.Rational(1, 2), 0, a**2]], [[3]], [[1, 2], [0, 4]]])
def test_entries_stand_row_by_row(kind, rows):
    assert list(entries(kind(rows))) == [sp.sympify(entry) for row in rows for entry in row]


def test_a_changed_matrix_gives_its_changed_entries():
    M = sp.Matrix([[1, 2], [3, 4]])
    assert list(entries(M)) == [1, 2, 3, 4]
    M[0, 1] = a
    assert list(entries(M)) == [1, a, 3, 4]


def test_an_empty_matrix_has_no_entries():
    assert list(entries(sp.zeros(0, 3).as_immutable())) == []
