"""The kernel of transfer matrices: Smith–McMillan form, uncancelled fractions, factors."""

import sympy as sp

from solver import exact
from solver.exact.representation.polynomials import invariant_factors

s = sp.Symbol("s")
I = sp.ImmutableMatrix


def polynomials(*rows):
    return [[sp.Poly(entry, s, domain=sp.QQ) for entry in row] for row in rows]


def test_invariant_factors_divide_each_other():
    diagonal = polynomials([s + 1, 0, 0], [0, s * (s + 1), 0], [0, 0, s])
    assert [p.as_expr() for p in invariant_factors(diagonal)] == [1, s**2 + s, s**2 + s]


def test_invariant_factors_of_a_matrix_that_has_not_full_rank():
    assert [p.as_expr() for p in invariant_factors(polynomials([s, s**2], [1, s]))] == [1]
    assert invariant_factors(polynomials([0, 0])) == []


def test_a_zero_that_only_the_minors_show():
    """By hand: all minors of order two have the factor s² − 4 over (s + 1)²(s + 2)²."""
    top = [[1, -1], [s**2 + s - 4, 2 * s**2 - s - 8], [s**2 - 4, 2 * s**2 - 8]]
    bottom = (s + 1) * (s + 2)
    G = exact.transfer_matrix_of_fractions(top, [[bottom] * 2] * 3, s)
    assert [(e.as_expr(), p.as_expr()) for e, p in G.smith_mcmillan] == [(1, s**2 + 3 * s + 2), (s - 2, s + 1)]
    assert sorted(G.poles) == [-2, -1, -1]
    assert G.zeros == [2]


def test_the_fraction_stays_uncancelled_until_it_is_asked_for():
    G = exact.transfer_matrix(I([[0, 1], [-2, -3]]), I([[0], [1]]), I([[1, 1]]), None, s)
    assert (G.numerators, G.chi) == (((s + 1,),), s**2 + 3 * s + 2)
    assert (G.matrix, G.cancelled) == (I([[1 / (s + 2)]]), [-1])


def test_the_direct_path_is_divided_out():
    G = exact.transfer_matrix_of_fractions([[2 * s**2 + 1]], [[4 * s**2 + 4]], s)
    assert G.direct == I([[sp.Rational(1, 2)]])
    assert G.strictly_proper_numerators == ((-sp.Rational(1, 4),),)


def test_what_one_entry_cancels_is_not_cancelled_where_another_pole_of_the_kind_is_needed():
    """χ = (s + 1)(s + 5)(s + 6) holds not even the poles −1, −1 of two channels: nothing can be said to cancel."""
    hidden = (s + 5) * (s + 6)
    G = exact.transfer_matrix_of_fractions([[1, 0], [0, hidden]], [[s + 1, 1], [1, (s + 1) * hidden]], s)
    assert G.poles == [-1, -1]
    assert G.cancelled == []


def test_luenbergers_indices_and_coordinates():
    A, B, C = sp.Matrix([[1, 2, 0], [0, 1, 1], [1, 0, 3]]), sp.Matrix([[1, 0], [0, 1], [0, 0]]), sp.Matrix([[1, 0, 1]])
    found = exact.controllable_coordinates(A, B, C, sp.zeros(1, 2))
    assert found is not None
    assert found.indices == (2, 1)
    assert found.T * found.T_inverse == sp.eye(3)
    assert A * found.T == found.T * found.found.A
    assert exact.controllable_coordinates(-sp.eye(3), B, C, sp.zeros(1, 2)) is None
