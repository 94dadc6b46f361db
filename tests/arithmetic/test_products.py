"""Products and powers of matrices as on paper: what the lines show is what numpy finds."""

import numpy as np
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.arithmetic.products import multiplied, polynomial_of
from solver.exact import polynomial_of_matrix
from solver.numeric import check_steps
from solver.render.wording import Wording

TUTOR = Wording(detail="tutor")
A = sp.ImmutableMatrix([[0, 1], [-2, -3]])


def matrices(n, m):
    return st.lists(st.integers(-9, 9), min_size=n * m, max_size=n * m).map(lambda e: sp.ImmutableMatrix(n, m, e))


def displayed(steps):
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


def test_an_entry_is_a_row_times_a_column():
    B = sp.ImmutableMatrix([[5], [7]])
    shown = displayed(multiplied(A, B, A * B))
    assert r"\begin{bmatrix}7 \\ -2 \cdot 5 - 3 \cdot 7\end{bmatrix} = \begin{bmatrix}7 \\ -31\end{bmatrix}" in shown
    assert "products with a zero are left out" in shown


def test_products_that_need_only_a_look_are_not_worked_out():
    B = sp.ImmutableMatrix([[0], [1]])
    assert multiplied(A, B, A * B) == ()


@given(matrices(3, 3), matrices(3, 2))
def test_the_entries_worked_out_are_those_of_numpy(left, right):
    value = sp.ImmutableMatrix(np.array(left.tolist(), dtype=int) @ np.array(right.tolist(), dtype=int))
    assert all(check.status == "passed" for check in check_steps(multiplied(left, right, value)))
    wrong = value + sp.ImmutableMatrix(3, 2, [1, 0, 0, 0, 0, 0])
    for step in multiplied(left, right, wrong):
        assert any(check.status == "failed" for check in check_steps([step]))


@given(matrices(2, 2), st.lists(st.integers(-9, 9), min_size=3, max_size=3).map(lambda rest: [sp.S.One, *rest]))
def test_a_polynomial_of_a_matrix_comes_power_by_power(matrix, coefficients):
    M = np.array(matrix.tolist(), dtype=int)
    by_horner = sum((int(c) * np.linalg.matrix_power(M, 3 - i) for i, c in enumerate(coefficients)), np.zeros((2, 2)))
    steps = polynomial_of(matrix, coefficients, polynomial_of_matrix(matrix, coefficients))
    assert [step.kind for step in steps] == ["product", "product", "terms"]
    assert np.array_equal(np.array(steps[-1].claims["sum"].right.tolist(), dtype=float), by_horner)
    assert all(check.status == "passed" for check in check_steps(steps))


def test_what_has_no_exact_form_is_not_worked_out_and_costs_nothing():
    """A root and a parameter together have no field of their own."""
    c = sp.Symbol("c")
    mixed = sp.ImmutableMatrix([[sp.sqrt(-c), sp.I], [c, 1]])
    assert polynomial_of(mixed, [sp.S.One, sp.S.One, sp.S.One], mixed) == ()
