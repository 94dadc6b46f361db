"""Coordinates with the measured quantities first, and error matrices by choice."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from solver import exact
from tests.helpers.tried import tried

I, M = sp.I, sp.ImmutableMatrix
A = M(3, 3, range(1, 10))
B = M([1, 2, 3])


@tried(25)
@given(st.data())
def test_the_first_coordinates_are_the_outputs(data):
    n = data.draw(st.integers(2, 5))
    p = data.draw(st.integers(1, n - 1))
    small = st.integers(-2, 2)
    C = M(p, n, [data.draw(small) for _ in range(p * n)])
    assume(C.rank() == p)
    plant, inputs = M(n, n, [data.draw(small) for _ in range(n * n)]), M(n, 1, [data.draw(small) for _ in range(n)])
    parts = exact.measured_first(plant, inputs, C)
    assert sp.Matrix.hstack(sp.eye(p), sp.zeros(p, n - p)) == C * parts.T
    assert sp.eye(n) == parts.T * parts.Q
    assert plant * parts.T == parts.T * parts.A
    assert inputs == parts.T * parts.B
    blocks = parts.blocks
    assert sp.Matrix([[blocks["A11"], blocks["A12"]], [blocks["A21"], blocks["A22"]]]) == parts.A
    for k, j in enumerate(parts.unmeasured):
        assert parts.Q[p + k, :] == sp.eye(n)[j, :]
    assert list(parts.unmeasured) == sorted(parts.unmeasured)


def test_measured_states_only_change_the_order():
    parts = exact.measured_first(A, B, M([[0, 0, 1], [1, 0, 0]]))
    assert parts.permutation
    assert parts.unmeasured == (1,)
    assert parts.T * sp.Matrix([3, 1, 2]) == sp.Matrix([1, 2, 3])


def test_a_parameter_is_not_divided_by_where_a_number_will_do():
    a = sp.Symbol("a")
    parts = exact.measured_first(A, B, M([[a, 1, 0]]))
    assert parts.unmeasured == (0, 2)
    assert all(sp.denom(entry) == 1 for entry in parts.T)


def test_dependent_outputs_are_refused():
    with pytest.raises(ValueError, match="independent"):
        exact.measured_first(A, B, M([[1, 0, 0], [2, 0, 0]]))


@pytest.mark.parametrize(
    "poles", [[-1], [-1 + 2 * I, -3, -1 - 2 * I], [-2, -2], [I, -I, 1 + I / 2, 1 - I / 2], [sp.sqrt(2), -sp.sqrt(2)]]
)
def test_the_chosen_matrix_is_real_and_has_the_poles(poles):
    poles = [sp.sympify(pole) for pole in poles]
    J = exact.chosen_error_matrix(poles)
    s = sp.Symbol("s")
    assert not J.has(I)
    assert sp.expand(J.charpoly(s).as_expr() - sp.prod(s - pole for pole in poles)) == 0


def test_a_left_inverse_undoes_independent_columns():
    C = M([[1, 2], [0, 1], [3, 1]])
    assert exact.left_inverse(C) * C == sp.eye(2)
    with pytest.raises(ZeroDivisionError):
        exact.left_inverse(M([[1, 2], [2, 4]]))


@pytest.mark.parametrize(
    "poles",
    [
        [-1, -2],
        [-1 + sp.I, -2 + 3 * sp.I, -1 - sp.I, -2 - 3 * sp.I],
        [-3, -1 - 2 * sp.I, -1 + 2 * sp.I],
        [-1 + sp.I, -1 + sp.I, -1 - sp.I, -1 - sp.I],
        [sp.N(-1 + sp.sqrt(2) * sp.I), sp.N(-2 + 3 * sp.I), sp.N(-2 - 3 * sp.I), -1 - sp.Float("1.4142136") * sp.I],
    ],
)
def test_the_matrix_chosen_for_the_error_is_real_and_has_the_poles(poles):
    G = exact.chosen_error_matrix(list(map(sp.sympify, poles)))
    assert all(entry.is_real for entry in G)
    found = np.linalg.eigvals(np.array(G.evalf().tolist(), dtype=float))
    wanted = np.array([complex(pole) for pole in poles])
    assert np.allclose(np.sort_complex(np.round(found, 5)), np.sort_complex(np.round(wanted, 5)), atol=1e-4)


def test_a_pair_of_poles_in_symbols_has_a_real_block():
    a, b, s = sp.Symbol("a", positive=True), sp.Symbol("b", positive=True), sp.Symbol("s")
    G = exact.chosen_error_matrix([-a + b * sp.I, sp.Integer(-3), -a - b * sp.I])
    assert sp.expand(G.charpoly(s).as_expr() - (s + 3) * ((s + a) ** 2 + b**2)) == 0
