"""The oracle of minimal parts, on plants whose poles and zeros are known by construction."""

import sympy as sp

from solver.numeric.judges import representation as judges

M = sp.Matrix
HIDDEN = (sp.diag(-1, -2, -3), M([1, 1, 0]), M([[1, 0, 1]]), M([[0]]))
SQUARE = (sp.diag(-1, -2, -3), M([[1, 0], [0, 1], [1, 1]]), M([[1, 0, 1], [0, 1, 0]]), sp.zeros(2))


def test_the_order_of_the_minimal_part():
    assert judges.order_of_minimal_part(HIDDEN) == 1
    assert judges.order_of_minimal_part(SQUARE) == 3
    assert judges.order_of_minimal_part((sp.diag(-1, -2), sp.zeros(2, 1), M([[1, 1]]), M([[4]]))) == 0


def test_nearly_hidden_modes_are_seen():
    tiny = sp.Rational(1, 10**12)
    assert judges.order_of_minimal_part((sp.diag(-1, -2), M([1, tiny]), M([[1, 1]]), M([[0]]))) == 2


def test_poles_and_cancelled_modes():
    assert judges.pole_residual(HIDDEN, [-1]) < 1e-12
    assert judges.cancelled_residual(HIDDEN, [-2, -3]) < 1e-12
    assert judges.pole_residual(HIDDEN, [sp.Rational(-1001, 1000)]) > 1e-5
    assert judges.cancelled_residual(HIDDEN, [-2]) == float("inf")


def test_multiple_poles_are_no_harder():
    chain = M(4, 4, lambda i, j: -1 if i == j else int(j == i + 1))
    plant = (chain, M([0, 0, 0, 1]), M([[1, 0, 0, 0]]), M([[0]]))
    assert judges.pole_residual(plant, [-1] * 4) < 1e-12
    assert judges.pole_residual(plant, [-1, -1, -1, sp.Rational(-10001, 10000)]) > 1e-9


def test_transmission_zeros():
    assert judges.zero_residual(SQUARE, [-2]) < 1e-12
    for wrong in ([], [-2, -2], [2], [-1]):
        assert judges.zero_residual(SQUARE, wrong) > 1e-9


def test_zeros_at_the_origin_and_close_to_it():
    differentiator = (sp.diag(-4, -4), M([0, -2]), M([[0, 2]]), M([[1]]))  # s/(s + 4)
    assert judges.zero_residual(differentiator, [0]) < 1e-12
    assert judges.zero_residual(differentiator, []) == float("inf")
    assert judges.zero_residual(differentiator, [sp.Rational(1, 10**6)]) > 1e-9
    double = (M([[-3, 1], [-1, -1]]), M([2, 0]), M([[0, -2]]), M([[-1]]))  # −s(s + 4)/(s + 2)²
    assert judges.zero_residual(double, [-4, 0]) < 1e-12
    assert judges.zero_residual(double, [-4, sp.Rational(1, 10**6)]) > 1e-9
    tiny = sp.Rational(1, 10**6)
    slow = (M([[0, 1], [-2000, -1003]]), M([0, 1]), M([[tiny, 1]]), M([[0]]))
    assert judges.zero_residual(slow, [-tiny]) < 1e-12
    assert judges.zero_residual(slow, [-2 * tiny]) > 1e-9


def test_a_realization_of_fractions_with_different_denominators():
    s = sp.Symbol("s")
    plant = judges.realized([[s + 2, 1]], [[s**2 + 5 * s + 6, s + 1]], s)
    assert judges.order_of_minimal_part(plant) == 2
    assert judges.pole_residual(plant, [-3, -1]) < 1e-12
