"""The controllable canonical form of transfer matrices."""

import pytest
import sympy as sp

from solver.exact import controllable_realization, transfer_matrix_of_fractions

s, a = sp.symbols("s a")


def controllable_form(numerators, denominators):
    form = controllable_realization(transfer_matrix_of_fractions(numerators, denominators, s))
    return form.A, form.B, form.C, form.D


@pytest.mark.parametrize(
    ("numerators", "denominators", "order"),
    [
        (((sp.Integer(1),),), ((s**2 + 3 * s + 2,),), 2),
        (((s + 1,),), (((s + 1) * (s + 2),),), 2),
        (((2 * s**3 + 5 * s**2 + 3 * s + 1,),), ((4 * s**3 + 2 * s**2 + 3 * s + 6,),), 3),
        (((s + a,),), ((2 * s**2 + a * s + 1,),), 2),
        (((sp.Integer(1), s), (s + 2, sp.Integer(3))), ((s + 1, s**2), (s + 1, s)), 3),
        (((sp.Integer(3),),), ((sp.Integer(2),),), 0),
    ],
)
def test_it_has_the_transfer_function_and_the_degree_of_the_denominators(numerators, denominators, order):
    A, B, C, D = controllable_form(numerators, denominators)
    assert A.shape == (order, order)
    G = C * (s * sp.eye(order) - A).inv() * B + D if order else D
    for i, row in enumerate(numerators):
        for j, numerator in enumerate(row):
            assert sp.cancel(G[i, j] - numerator / denominators[i][j]) == 0


def test_the_last_row_holds_the_monic_denominator():
    A, B, C, D = controllable_form(((2 * s + 4,),), ((2 * s**2 + 6 * s + 10,),))
    assert sp.Matrix([[0, 1], [-5, -3]]) == A
    assert sp.Matrix([0, 1]) == B
    assert sp.Matrix([[2, 1]]) == C
    assert sp.Matrix([[0]]) == D
