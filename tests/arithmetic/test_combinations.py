"""Sums of powers of a matrix and products of several matrices as on paper, and tests at the beginning."""

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm

from solver.arithmetic.beginnings import begun_right
from solver.arithmetic.combinations import combined, multiplied_out
from solver.numeric import check_steps
from solver.render.wording import Wording

TUTOR = Wording(detail="tutor")
t, k = sp.symbols("t k")
A = sp.ImmutableMatrix([[0, 1], [-2, -3]])
NAMES = sp.symbols("alpha_:2")
ALPHA = (2 * sp.exp(-t) - sp.exp(-2 * t), sp.exp(-t) - sp.exp(-2 * t))
PHI = sp.ImmutableMatrix(
    [
        [2 * sp.exp(-t) - sp.exp(-2 * t), sp.exp(-t) - sp.exp(-2 * t)],
        [2 * sp.exp(-2 * t) - 2 * sp.exp(-t), 2 * sp.exp(-2 * t) - sp.exp(-t)],
    ]
)


def displayed(steps):
    assert [check for check in check_steps(steps) if check.status != "passed"] == []
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


def test_the_example_is_the_exponential_of_scipy():
    assert np.allclose(np.array(PHI.subs(t, 0.7), dtype=float), expm(0.7 * np.array(A, dtype=float)))


def test_a_sum_of_powers_is_added_entry_by_entry_by_name_and_with_values():
    shown = displayed(combined(A, NAMES, ALPHA, PHI))
    assert (
        r"\alpha_0I + \alpha_1A = \begin{bmatrix}\alpha_0 & \alpha_1 \\ -2\alpha_1 & \alpha_0 - 3\alpha_1\end{bmatrix}"
        in shown
    )
    assert r"-2(e^{-t} - e^{-2t})" in shown
    wrong = PHI + sp.ImmutableMatrix([[0, t], [0, 0]])
    assert any(check.status == "failed" for check in check_steps(combined(A, NAMES, ALPHA, wrong)))


def test_a_diagonal_matrix_between_two_only_multiplies_columns():
    V, middle = sp.ImmutableMatrix([[1, 1], [-1, -2]]), sp.ImmutableMatrix(sp.diag(sp.exp(-t), sp.exp(-2 * t)))
    steps = multiplied_out((V, middle, sp.ImmutableMatrix(V.inv())), PHI)
    assert len(steps) == 1
    assert r"\begin{bmatrix}e^{-t} & e^{-2t} \\ -e^{-t} & -2e^{-2t}\end{bmatrix}" in displayed(steps)


def test_a_transition_matrix_begins_with_the_identity_and_goes_on_with_the_matrix():
    shown = displayed(begun_right(PHI, A, t, discrete=False))
    assert r"\Phi(0) = \begin{bmatrix}2 - 1 & 1 - 1 \\ 2 - 2 & 2 - 1\end{bmatrix} = \begin{bmatrix}1 & 0" in shown
    assert r"= \begin{bmatrix}0 & 1 \\ -2 & -3\end{bmatrix}" in shown


@pytest.mark.parametrize("wrong", [PHI * 2, PHI.T])
def test_what_begins_wrongly_is_seen(wrong):
    steps = begun_right(sp.ImmutableMatrix(wrong), A, t, discrete=False)
    assert any(check.status == "failed" for check in check_steps(steps))


def test_in_discrete_time_the_first_power_is_the_matrix():
    power = sp.ImmutableMatrix([[2**k, k * 2 ** (k - 1)], [0, 2**k]])
    shown = displayed(begun_right(power, sp.ImmutableMatrix([[2, 1], [0, 2]]), k, discrete=True))
    assert r"\Phi(1) = \begin{bmatrix}2 & 1 \\ 0 & 2\end{bmatrix}" in shown
