"""What must hold of transfers and of finite horizons holds of what is found, and of nothing that is a little wrong."""

from dataclasses import replace

import pytest
import sympy as sp

from solver import exact
from solver.derivation import CheckStatus
from solver.lazy import Call
from solver.postconditions import check_calls

A, B = sp.ImmutableMatrix([[0, 1], [0, -1]]), sp.ImmutableMatrix([0, 1])
ONE, I2, NONE = sp.ImmutableMatrix([[1]]), sp.ImmutableMatrix(sp.eye(2)), sp.ImmutableMatrix(sp.zeros(2))
ENDS = sp.ImmutableMatrix([1, 1]), sp.ImmutableMatrix([0, 0])
t = sp.Symbol("t")


def statuses(kernel, arguments, result):
    return {check.status for check in check_calls([Call(kernel, arguments, {}, result, 1)], [])}


@pytest.mark.parametrize(
    "field", ["transition", "drift", "gap", "gramian", "eta", "u", "x", "adjoint", "start", "spread"]
)
def test_a_transfer_of_which_one_thing_is_wrong_is_seen(field):
    arguments = (A, B, ONE, ENDS, sp.Integer(1))
    found = exact.minimum_energy(*arguments)
    assert statuses("minimum_energy", arguments, found) == {CheckStatus.PASSED}
    wrong = sp.ImmutableMatrix(getattr(found, field) * sp.Rational(1001, 1000))
    if field in ("drift", "gap"):
        wrong = sp.ImmutableMatrix(getattr(found, field) + sp.ones(2, 1) / 1000)
    assert CheckStatus.FAILED in statuses("minimum_energy", arguments, replace(found, **{field: wrong}))


def test_an_energy_and_a_rank_that_are_wrong_are_seen():
    arguments = (A, B, ONE, ENDS, sp.Integer(1))
    found = exact.minimum_energy(*arguments)
    row = sp.ImmutableMatrix([[1, 0]])
    for wrong in (replace(found, energy=2 * found.energy), replace(found, unreached=row)):
        assert CheckStatus.FAILED in statuses("minimum_energy", arguments, wrong)


def test_a_horizon_of_another_question_is_seen():
    arguments = (A, B, I2, ONE, NONE)
    found = exact.finite_horizon(*arguments)
    assert statuses("finite_horizon", arguments, found) == {CheckStatus.PASSED}
    for other in ((A, B, I2, ONE, I2), (A, B, 2 * I2, ONE, NONE), (A.T, B, I2, ONE, NONE), (A, 2 * B, I2, ONE, NONE)):
        wrong = exact.finite_horizon(*map(sp.ImmutableMatrix, other))
        assert CheckStatus.FAILED in statuses("finite_horizon", arguments, wrong)


def test_a_recursion_that_is_one_step_off_is_seen():
    arguments = (A, B, I2, ONE, NONE, 3)
    found = exact.riccati_recursion(*arguments, sp.ImmutableMatrix([1, 1]))
    named = {"x0": sp.ImmutableMatrix([1, 1])}

    def judged(result):
        return {check.status for check in check_calls([Call("riccati_recursion", arguments, named, result, 1)], [])}

    assert judged(found) == {CheckStatus.PASSED}
    wrong = (
        replace(found, K=found.K[1:] + found.K[:1]),
        replace(found, P=found.P[::-1]),
        replace(found, P=found.P[:-1]),
        replace(found, u=tuple(-each for each in found.u)),
        replace(found, x=found.x[::-1]),
    )
    assert all(CheckStatus.FAILED in judged(each) for each in wrong)
