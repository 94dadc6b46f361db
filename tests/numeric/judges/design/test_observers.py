"""The oracles of observers accept what is right and measure what is wrong."""

import sympy as sp

from solver.numeric.judges import design as judges

M, R, s = sp.ImmutableMatrix, sp.Rational, sp.Symbol("s")
A, B, C, D = M([[0, 1], [-2, -3]]), M([0, 1]), M([[1, 0]]), M([[0]])
K, L = M([[2, 1]]), M([3, 1])
LOOP, ERROR = M(A - B * K), M(A - L * C)
G = (-K * (s * sp.eye(2) - A + B * K + L * C).inv() * L)[0]


def test_rows_in_a_row_space():
    assert judges.row_space_residual(M([[2, 4], [-1, -2]]), M([[1, 2]])) < 1e-12
    assert judges.row_space_residual(M([[2, 4], [-1, 2]]), M([[1, 2]])) > 1e-3


def test_an_error_that_the_plant_does_not_drive():
    E = M([[0, 1]])
    J, right = M([[-5]]), -2 - 5 * 2  # A22 − L, A21 − L A11 + J L of the plant above, with L = 2
    assert judges.driven_error_residual(A, C, E, J, M([[right, 0]])) < 1e-12
    assert judges.driven_error_residual(A, C, E, J, M([[right + 1, 0]])) > 1e-3
    assert judges.driven_error_residual(A, C, E, M([[-4]]), M([[right, 0]])) > 1e-3


def test_the_eigenvalues_of_two_loops_together():
    found = [*LOOP.eigenvals(multiple=True), *ERROR.eigenvals(multiple=True)]
    assert judges.joined_spectrum_residual(found, [LOOP, ERROR]) < 1e-9
    assert judges.joined_spectrum_residual([found[0] + R(1, 1000), *found[1:]], [LOOP, ERROR]) > 1e-9
    assert judges.joined_spectrum_residual(found[:-1], [LOOP, ERROR]) > 1e-9


def test_modes_that_nothing_moves_are_added_to_fewer_poles():
    plant, inputs = M([[-3, 0], [0, 1]]), M([0, 1])
    groups = [(plant, inputs, [R(-7)])]
    assert judges.joined_spectrum_residual([R(-3), R(-7)], groups) < 1e-9
    assert judges.joined_spectrum_residual([R(-2), R(-7)], groups) > 1e-6


def test_a_compensator_closes_the_loop_or_does_not():
    right, plant = M([[G]]), (A, B, C, D)
    assert judges.closing_residual(plant, right, s, [LOOP, ERROR], 2) < 1e-9
    for wrong in (-G, G * R(101, 100), G.subs(s, s + R(1, 100)), G + R(1, 100), sp.Integer(0)):
        assert judges.closing_residual(plant, M([[wrong]]), s, [LOOP, ERROR], 2) > 1e-6
    assert judges.closing_residual(plant, M([[G, G]]), s, [LOOP, ERROR], 2) == float("inf")


def test_a_direct_term_leads_the_polynomial():
    through = M([[R(1, 2)]])
    F = A - B * K - L * C + L * through * K
    compensator = M(-K * (s * sp.eye(2) - F).inv() * L)
    assert judges.closing_residual((A, B, C, through), compensator, s, [LOOP, ERROR], 2) < 1e-9
    assert judges.closing_residual((A, B, C, D), compensator, s, [LOOP, ERROR], 2) > 1e-6
