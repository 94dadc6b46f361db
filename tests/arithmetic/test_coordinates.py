"""A system in other coordinates on paper: the products are numpy's, and states that change places need none."""

import numpy as np
import sympy as sp

from solver.arithmetic.coordinates import in_coordinates
from solver.numeric import check_steps

A = sp.ImmutableMatrix([[0, 1], [-2, -3]])
T = sp.ImmutableMatrix([[1, 1], [-1, -2]])
B, C = sp.ImmutableMatrix([0, 1]), sp.ImmutableMatrix([[1, 2]])


def numbers(M):
    return np.array(M.tolist(), dtype=float)


def test_the_products_are_numpys():
    steps = in_coordinates(T, T.inv(), A, B, C)
    assert [check for check in check_steps(steps) if check.status != "passed"] == []
    by_name = {step.values["name"]: step.claims["value"].right for step in steps if step.kind == "product"}
    moved = np.linalg.solve(numbers(T), numbers(A) @ numbers(T))
    assert np.allclose(numbers(by_name["T^{-1}AT"]), moved)
    assert np.allclose(numbers(by_name["CT"]), numbers(C) @ numbers(T))
    assert steps[0].kind == "two_rows"


def test_the_inverse_is_left_out_where_the_page_shows_it():
    assert all(step.kind == "product" for step in in_coordinates(T, T.inv(), A, B, None, inverse_too=False))


def test_states_that_change_places_need_no_arithmetic():
    exchange = sp.ImmutableMatrix([[0, 1], [1, 0]])
    assert in_coordinates(exchange, exchange, A, B, C) == ()
