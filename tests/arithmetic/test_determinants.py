"""Determinants expanded as on paper: what the lines show is what numpy finds, and a look is not worked out."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.arithmetic.determinants import expanded, first_line, worked_out
from solver.numeric import check_steps
from solver.render.wording import Wording
from tests.helpers.asking import ask, system

TUTOR = Wording(detail="tutor")
X, K = sp.symbols("lamda K")


def displayed(steps):
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


def matrix(*rows):
    return sp.ImmutableMatrix(rows)


def numbers(n):
    return st.lists(st.integers(-9, 9), min_size=n * n, max_size=n * n).map(lambda e: sp.ImmutableMatrix(n, n, e))


def numpys(M):
    return round(np.linalg.det(np.array(M.tolist(), dtype=float)))


@given(st.one_of(numbers(2), numbers(3), numbers(4)))
def test_the_last_line_is_numpys_determinant(M):
    value = sp.Integer(numpys(M))
    steps = worked_out("d", M, value)
    assert all(check.status == "passed" for check in check_steps(steps))
    if steps:
        wrong = worked_out("d", M, value + 1)
        assert any(check.status == "failed" for check in check_steps(wrong))


def test_two_rows_are_products_of_diagonals():
    shown = displayed(worked_out(r"\Delta_{2}", matrix([2, 4], [1, 3]), sp.Integer(2)))
    assert r"\Delta_{2} = 2 \cdot 3 - 4 = 6 - 4 = 2" in shown


def test_minors_of_three_rows_are_written_out_and_then_the_terms():
    M = matrix([X, -1, 0], [0, X, -1], [2, 5, X + 3])
    steps = expanded(M, X**3 + 3 * X**2 + 5 * X + 2, X)
    shown = displayed(steps)
    assert [step.kind for step in steps] == ["minors"]
    assert r"\lambda(\lambda(\lambda + 3) - (-1) \cdot 5) - (-1) \cdot 2" in shown
    assert r"\lambda(\lambda^{2} + 3\lambda + 5) + 2" in shown


def test_terms_of_like_powers_are_put_together_in_a_line_of_their_own():
    shown = displayed(expanded(matrix([X - 1, -2], [-3, X - 4]), X**2 - 5 * X - 2, X))
    assert r"= \lambda^{2} - 5\lambda + 4 - 6 = \lambda^{2} - 5\lambda - 2" in shown


def test_minors_of_four_rows_come_one_by_one():
    M = matrix([X, -1, 0, 0], [2, X, -1, 0], [0, 0, X, -1], [-1, 0, 2, X])
    steps = expanded(M, X**4 + 4 * X**2 + 3, X)
    assert [step.kind for step in steps] == ["minor", "minor", "terms"]
    minors = [sp.Poly(step.claims["value"].right, X).all_coeffs() for step in steps[:2]]
    at_two = [np.polyval([float(c) for c in each], 2.0) for each in minors]
    assert np.allclose(
        at_two,
        [np.linalg.det([[2, -1, 0], [0, 2, -1], [0, 2, 2]]), np.linalg.det([[2, -1, 0], [0, 2, -1], [-1, 2, 2]])],
    )


@pytest.mark.parametrize(
    ("M", "value"),
    [
        (matrix([5]), 5),
        (matrix([1, 0], [7, -1]), -1),
        (matrix([K, 0], [1, 2]), 2 * K),
        (matrix([0, 0, 1], [0, 1, 3], [1, 2, 4]), -1),
    ],
)
def test_what_a_look_tells_is_not_worked_out(M, value):
    assert worked_out("d", M, sp.sympify(value)) == ()


def test_a_large_dense_matrix_has_the_values_of_its_minors_only():
    M = sp.ImmutableMatrix(5, 5, lambda i, j: (3 * i * i + 5 * j + i * j * j) % 7 + 1)
    steps = worked_out("d", M, sp.Integer(numpys(M)))
    assert [step.kind for step in steps] == ["expansion", "minors", "terms"]
    assert all(check.status == "passed" for check in check_steps(steps))


def test_a_singular_matrix_is_worked_out_to_zero():
    M = matrix([1, 2], [2, 4])
    assert r"d = 4 - 2 \cdot 2 = 4 - 4 = 0" in displayed(worked_out("d", M, sp.S.Zero))
    assert first_line(matrix([0, 0], [0, 0])).operands == ()


def test_hurwitz_determinants_are_worked_out_at_tutor_alone():
    steps = ask("stability", system([[0, 1, 0], [0, 0, 1], [-1, -2, -3]]), "lyapunov").steps
    (minors,) = (step for step in steps if step.kind == "minors")
    shown = displayed([minors]) + displayed(minors.steps)
    assert r"\Delta_{2} = \frac{23}{10} \cdot \frac{23}{5} - \frac{21}{10} \cdot \frac{21}{10}" in shown
    assert all(step.detail == "tutor" for step in minors.steps)
