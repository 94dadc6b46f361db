"""Lowest terms entry by entry, parts by poles, residues as products of few columns and rows."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.exact import (
    companion_orders,
    entries_in_lowest_terms,
    parts_by_poles,
    rank_factors,
    transfer_matrix_of_fractions,
)
from tests.helpers.tried import tried

s, a, b = sp.symbols("s a b")
M = sp.ImmutableMatrix


def matrix(*rows):
    return transfer_matrix_of_fractions([[p for p, _ in row] for row in rows], [[q for _, q in row] for row in rows], s)


G = matrix([(1, (s + 1) ** 2), (s, s + 2)], [(s - 1, s**2 - 1), (2, (s + 1) * (s**2 + 1))])


def test_each_entry_is_cancelled():
    reduced = entries_in_lowest_terms(G)
    assert reduced.denominators[1][0] == s + 1
    assert reduced.matrix == G.matrix
    assert companion_orders(reduced) == (2 + 4, 3 + 3)


def test_the_parts_have_one_pole_each_and_add_up():
    parts = parts_by_poles(entries_in_lowest_terms(G))
    assert sorted((str(part.polynomial), part.pole) for part in parts) == [
        ("(s + 1)**2", None),
        ("s + 2", -2),
        ("s**2 + 1", None),
    ]
    added = sum((part.numerators / part.polynomial for part in parts), sp.zeros(2, 2))
    assert (added + G.direct - G.matrix).applyfunc(sp.cancel).is_zero_matrix


def test_a_power_that_no_entry_needs_is_not_taken():
    uncancelled = matrix([(s + 1, (s + 1) ** 2), (1, s + 1)])
    (part,) = parts_by_poles(uncancelled)
    assert (part.polynomial, part.pole, part.numerators) == (s + 1, -1, M([[1, 1]]))


@pytest.mark.parametrize(
    ("R", "C", "B"),
    [
        (M([[3, 2]]), M([[1]]), M([[3, 2]])),
        (M([[1], [2]]), M([[1], [2]]), M([[1]])),
        (M([[3, 2], [6, 4]]), M([[1], [2]]), M([[3, 2]])),
        (M([[2, 1], [1, 1]]), M([[2, 1], [1, 1]]), M([[1, 0], [0, 1]])),
        (M([[a, a * b], [2, 2 * b]]), M([[a], [2]]), M([[1, b]])),
        (M([[0, 0]]), M(1, 0, []), M(0, 2, [])),
    ],
)
def test_residues_as_products(R, C, B):
    assert rank_factors(R) == (C, B)


@tried(40)
@given(st.integers(1, 3), st.integers(1, 3), st.data())
def test_the_product_is_the_residue_with_as_many_states_as_its_rank(p, m, data):
    entry = st.integers(-4, 4)
    r = data.draw(st.integers(1, min(p, m)))
    R = M(p, r, lambda *_: data.draw(entry)) * M(r, m, lambda *_: data.draw(entry))
    C, B = rank_factors(R)
    assert C * B == R
    assert C.cols == B.rows == R.rank()
