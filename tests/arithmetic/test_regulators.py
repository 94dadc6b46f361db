"""Regulators and filters at tutor: the lines that a student redoes stand on the page, and hold."""

import pytest
import sympy as sp

from solver.derivation import Status
from solver.render.wording import Wording
from tests.helpers.asking import ask, system

TUTOR = Wording(detail="tutor")
PLANT = system([[0, 1], [0, 1]], B=[[0], [1]], C=[[1, 0]])
ONE = sp.ImmutableMatrix([[1]])
Q = sp.ImmutableMatrix(sp.eye(2))


def page(result):
    assert result.status is Status.VERIFIED, result.reason
    return "\n".join(f"{each.title}\n{each.markdown}" for step in TUTOR.words(result.steps) for each in step.walk())


def test_the_entries_of_the_riccati_equation_are_multiplied_out():
    shown = page(ask("lqr", PLANT, "riccati", Q=Q, R=ONE))
    for line in (
        r"PBR^{-1}B^{T}P = \begin{bmatrix}p_{12} \\ p_{22}\end{bmatrix}\begin{bmatrix}p_{12} & p_{22}\end{bmatrix}",
        r"p_{22} = 1 \pm \sqrt{1 - (-3)} = 1 \pm \sqrt{4}",
        r"Equation (1, 2) with $p_{12} = 1$ and $p_{22} = 3$:",
        r"0 = p_{11} - 3 + 1 = p_{11} - 2",
    ):
        assert line in shown


def test_the_linear_equations_of_the_hamiltonian_matrix_are_listed():
    plant = system([[0, 1], [1, 1]], B=[[1], [1]])
    shown = page(ask("lqr", plant, "hamiltonian", Q=sp.ImmutableMatrix(sp.diag(3, 0)), R=ONE))
    assert "Entry by entry" in shown
    assert "The square" in shown


def test_the_least_cost_is_multiplied_out():
    start = sp.ImmutableMatrix([2, 1])
    shown = page(ask("lqr", PLANT, "riccati", Q=Q, R=ONE, initial_state=start))
    assert r"Px(0) = \begin{bmatrix}2 & 1 \\ 1 & 3\end{bmatrix}\begin{bmatrix}2 \\ 1\end{bmatrix}" in shown
    assert r"\begin{bmatrix}2 \cdot 2 + 1 \\ 2 + 3\end{bmatrix}" in shown


@pytest.mark.parametrize("method", ["riccati", "hamiltonian"])
def test_a_filter_is_worked_out_as_its_regulator_is(method):
    shown = page(ask("kalman_filter", system([[0, 1], [0, 1]], C=[[2, 1]]), method, Q=Q, R=ONE))
    assert r"PC^{T} = " in shown
    assert "Row times column" in shown


def test_roots_of_parameters_are_not_eliminated_with_a_pen():
    q, r = sp.symbols("q r")
    plant = system([[0, 1], [0, 0]], B=[[0], [1]])
    result = ask("lqr", plant, "hamiltonian", Q=sp.ImmutableMatrix(sp.diag(q, 0)), R=sp.ImmutableMatrix([[r]]))
    assert "Elimination" not in page(result)


def test_a_quadratic_equation_is_divided_first_and_one_without_a_constant_is_a_product():
    two, half = sp.ImmutableMatrix([[2]]), sp.ImmutableMatrix([[sp.Rational(1, 2)]])
    hidden = system([[-1, 0], [0, -2]], B=[[0], [1]], C=[[1, 0]])
    first = sp.ImmutableMatrix(sp.diag(1, 0))
    shown = page(ask("lqr", hidden, "riccati", Q=first, R=half))
    assert r"p_{22}(-2p_{22} - 4) = 0" in shown
    assert r"\pm \sqrt" not in shown
    shown = page(ask("lqr", hidden, "riccati", Q=Q, R=two))
    assert r"Divided by $-\frac{1}{2}$:" in shown
    assert r"p_{22}^{2} + 8p_{22} - 2 = 0" in shown


def test_a_linear_equation_is_collected():
    plant = system([[-1, 0], [0, -2]], B=[[0], [1]], C=[[1, 0]])
    shown = page(ask("lqr", plant, "riccati", Q=sp.ImmutableMatrix(sp.diag(1, 100)), R=ONE))
    assert "p_{12} - 3p_{12} = -" in shown
    assert r"(1 + 2\sqrt{26})p_{12}" in shown or r"(-1 - 2\sqrt{26})p_{12}" in shown


def test_the_inverse_of_a_fraction_is_a_power():
    half = sp.ImmutableMatrix([[sp.Rational(1, 2)]])
    shown = page(ask("lqr", PLANT, "riccati", Q=Q, R=half))
    assert r"\left(\frac{1}{2}\right)^{-1}" in shown
    assert r"\frac{1}{\frac" not in shown
