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


def test_one_input_has_one_chain_of_all_powers():
    A, B = sp.Matrix([[0, 1, 0], [0, 0, 1], [2, 3, 5]]), sp.Matrix([1, 1, 0])
    found = exact.controllable_coordinates(A, B, sp.Matrix([[1, 0, 0]]), sp.zeros(1, 1))
    assert found.indices == (3,)
    assert sp.Matrix.hstack(B, A * B, A**2 * B) == found.P
    assert found.found.A == A
    assert sp.Matrix([0, 0, 1]) == found.found.B


def test_a_numerator_in_factors_keeps_its_leading_coefficient():
    G = exact.transfer_matrix_of_fractions([[-3 * s**2 + 12]], [[s**3]], s)
    assert sp.expand(G.numerator_factored - (12 - 3 * s**2)) == 0
    assert exact.transfer_matrix_of_fractions([[0]], [[s]], s).numerator_factored == 0


def test_fractions_with_parameters_are_cleared_of_fractions():
    """A circuit: 1/(L C s² + R C s + 1), not (1/(L C))/(s² + R s/L + 1/(L C)); a common factor cancels."""
    L, C, R, k = sp.symbols("L C R k", positive=True)
    A = I([[0, 1], [-1 / (L * C), -R / L]])
    G = exact.transfer_matrix(A, I([[0], [1 / (L * C)]]), I([[1, 0]]), None, s)
    assert sp.fraction(G.matrix[0, 0]) == (1, sp.expand(L * C * s**2 + R * C * s + 1))
    squared = exact.transfer_matrix_of_fractions([[k * (s / k + 1)]], [[(R * s + 1) ** 2 * (s + k)]], s)
    assert squared.matrix == I([[1 / (R * s + 1) ** 2]])
    minus = exact.transfer_matrix_of_fractions([[-s / R - 1]], [[s * (s / L + 1 / C)]], s)
    shown = minus.matrix[0, 0]
    assert sp.cancel(shown + (s / R + 1) / (s * (s / L + 1 / C))) == 0
    assert shown.could_extract_minus_sign()
    assert all(c.is_polynomial(L, C, R) for part in sp.fraction(shown) for c in sp.Poly(part, s).all_coeffs())


def test_residues_at_a_pair_that_is_undecided_keep_both_signs_apart():
    """(s + b)/(s² + bs + c) at −b/2 ± δ: ½ ± b/(4δ), 2δ = √(b² − 4c); not multiplied out."""
    b, c = sp.symbols("b c")
    first, second = exact.modes(exact.transfer_matrix_of_fractions([[s + b]], [[s**2 + b * s + c]], s))
    part = b / (2 * sp.sqrt(b**2 - 4 * c))
    assert {first.residues[0][0], second.residues[0][0]} == {sp.S.Half + part, sp.S.Half - part}


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
    assert sp.Matrix([[1, 1, 0], [0, 0, 1], [0, 1, 0]]) == found.P  # b₁, A b₁, b₂
    assert found.found.A[0, :] == sp.Matrix([[0, 1, 0]])
    assert exact.controllable_coordinates(-sp.eye(3), B, C, sp.zeros(1, 2)) is None
