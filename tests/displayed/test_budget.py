"""How much of what a part displays is evaluated: counted, not timed; what was seen costs nothing again."""

import sympy as sp

from solver.displayed.budget import Budget
from solver.stated.calculus import integral
from solver.stated.matrices import determinant

s, a = sp.symbols("s a")


def test_a_formula_is_counted_once():
    budget = Budget(20)
    assert budget.allows((s**2 + a * s, a))  # the sum, s², 2, s, a·s, a
    assert budget.left == 14
    assert budget.allows((s**2 + a * s, a))
    assert budget.left == 14


def test_an_operation_that_evaluates_at_many_points_costs_as_many():
    budget = Budget(100)
    assert budget.allows((integral(s, s, 0, 1),))
    assert budget.left < 50
    assert not budget.allows((integral(s**2, s, 0, 1),))


def test_what_exceeds_it_is_not_allowed_nor_anything_after_it():
    budget = Budget(5)
    assert not budget.allows((determinant(sp.ImmutableMatrix(3, 3, range(9))),))
    assert not budget.allows((s,))
