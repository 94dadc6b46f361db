"""Determinants and adjugates of matrices with many parameters, by elimination; falls of rank on lines through them."""

import pytest
import sympy as sp

from solver import exact
from solver.derivation import Status
from solver.numeric.judges import structure
from tests.helpers.asking import ask, system

m_c, m_p, b, l, J, g = sp.symbols("m_c m_p b l J g", real=True)
q = J * (m_c + m_p) + m_c * m_p * l**2
A = sp.ImmutableMatrix([
    [0, 1, 0, 0],
    [0, -(J + m_p * l**2) * b / q, -(m_p**2) * g * l**2 / q, 0],
    [0, 0, 0, 1],
    [0, b * m_p * l / q, m_p * g * l * (m_c + m_p) / q, 0],
])  # fmt: skip
B = sp.ImmutableMatrix([0, (J + m_p * l**2) / q, 0, -m_p * l / q])
POINT = {m_c: 2, m_p: 3, b: 5, l: 7, J: 11, g: 13}

x, y, z = sp.symbols("x y z", real=True)
GENERAL = sp.ImmutableMatrix([[x, 1, y], [z, x + y, 2], [1 / z, 0, x * y]])
SINGULAR = sp.ImmutableMatrix([[x, y, z], [1, 2, 3], [x + 1, y + 2, z + 3]])


@pytest.mark.parametrize("M", [GENERAL, SINGULAR])
def test_determinant_and_adjugate_are_sympys(M):
    det, adj = exact.determinant_and_adjugate(M)
    assert sp.cancel(det - M.det(method="berkowitz")) == 0
    assert (adj - M.adjugate()).applyfunc(sp.cancel).is_zero_matrix
    assert exact.determinant(M) == det


def test_a_cart_in_letters_is_controllable_but_for_a_pendulum_without_weight():
    matrix = exact.controllability_matrix(A, B)
    det = exact.determinant(matrix)
    assert sp.cancel(det - m_p**4 * g**2 * l**4 / q**4) == 0
    assert det.subs(POINT) == matrix.subs(POINT).det()
    found = ask("controllability", system(A, B=B), method="rank", horizon=None)
    assert found.status is Status.VERIFIED
    assert found.answers["controllable"] is True
    assert set(found.answers["exceptions"]) == {sp.Eq(m_p, 0), sp.Eq(l, 0), sp.Eq(g, 0)}


def test_a_fall_of_rank_that_is_not_named_is_found_on_a_line():
    matrix = exact.controllability_matrix(A, B)
    named = [sp.Eq(m_p, 0), sp.Eq(l, 0), sp.Eq(g, 0)]
    assert structure.every_fall_is_named(matrix, named)
    for i in range(3):
        assert not structure.every_fall_is_named(matrix, named[:i] + named[i + 1 :])
