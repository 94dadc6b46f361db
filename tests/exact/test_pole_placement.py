"""Ackermann's formula against the textbook formula on sympy matrices, and by what it is to achieve."""

import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from solver import exact
from tests.helpers.exact_cases import x
from tests.helpers.tried import tried

numbers = st.sampled_from([sp.Rational(p, q) for p in range(-4, 5) for q in (1, 2, 3)])
c, m = sp.symbols("c m", positive=True)


@st.composite
def plants(draw):
    n = draw(st.integers(1, 5))
    A = sp.ImmutableMatrix(n, n, [draw(numbers) for _ in range(n * n)])
    b = sp.ImmutableMatrix(n, 1, [draw(numbers) for _ in range(n)])
    return A, b, [sp.Integer(1), *(draw(numbers) for _ in range(n))]


def controllability(A, B):
    return sp.Matrix.hstack(*(A**i * B for i in range(A.rows)))


def textbook(A, b, coefficients):
    phi = sum((value * A ** (A.rows - i) for i, value in enumerate(coefficients)), sp.zeros(A.rows))
    last = sp.Matrix(1, A.rows, lambda _, j: int(j == A.rows - 1))
    return last * controllability(A, b).inv() * phi


@tried(25)
@given(plants())
def test_random_plants(plant):
    A, b, coefficients = plant
    assume(controllability(A, b).det() != 0)
    K = exact.ackermann(A, b, coefficients)
    assert textbook(A, b, coefficients) == K
    closed_loop = (x * sp.eye(A.rows) - (A - b * K)).det(method="berkowitz")
    assert sp.Poly(closed_loop, x).all_coeffs() == coefficients


@tried(30)
@given(plants())
def test_the_controllability_matrix_of_random_plants(plant):
    A, b, _ = plant
    assert exact.controllability_matrix(A, b) == controllability(A, b)


def test_the_textbook_plant():
    A, b = sp.ImmutableMatrix([[1, 2], [3, 1]]), sp.ImmutableMatrix([0, 1])
    assert exact.ackermann(A, b, [1, 6, 13]) == sp.Matrix([[13, 8]])  # poles −3 ± 2j


def test_several_inputs_have_a_wide_controllability_matrix():
    A, B = sp.ImmutableMatrix([[0, 1], [2, 3]]), sp.ImmutableMatrix([[1, 0], [0, sp.Rational(1, 2)]])
    assert exact.controllability_matrix(A, B) == controllability(A, B)


@pytest.mark.parametrize("entry", [c / m, sp.sqrt(2)])
def test_parameters_and_surds(entry):
    A, b = sp.ImmutableMatrix([[0, 1], [-entry, 1]]), sp.ImmutableMatrix([0, entry])
    K = exact.ackermann(A, b, [1, 3, entry])
    residual = (x * sp.eye(2) - (A - b * K)).det() - (x**2 + 3 * x + entry)
    assert sp.radsimp(sp.expand(sp.cancel(residual))) == 0
    assert (exact.controllability_matrix(A, b) - controllability(A, b)).expand() == sp.zeros(2)


@pytest.mark.parametrize("diagonal", [sp.Integer(1), c])
def test_an_uncontrollable_pair_is_refused(diagonal):
    with pytest.raises(ZeroDivisionError, match="not controllable"):
        exact.ackermann(diagonal * sp.eye(2), sp.ImmutableMatrix([1, 1]), [1, 2, 3])
