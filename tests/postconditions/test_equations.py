"""Riccati equations, variational derivatives and conditions on parameters of which one thing is wrong are seen."""

from dataclasses import replace

import pytest
import sympy as sp

from solver import exact
from solver.derivation import CheckStatus
from solver.lazy import Call
from solver.postconditions import check_calls
from tools.corrupted_kernels.changes import changes

M = sp.ImmutableMatrix
K, b, p = sp.Symbol("K", real=True), sp.Symbol("b", real=True), sp.Symbol("p", positive=True)
s = sp.Symbol("s")
y, y1, y2, y3, y4 = sp.symbols("y y_d y_dd y_ddd y_dddd")
MOVES = {y: y1, y1: y2, y2: y3, y3: y4}
REGULATOR = (M([[0, 1], [0, 0]]), M([0, 1]), M(sp.eye(2)), M([[2]]))
KINDS = {
    "weighted_input": [(M([[1, 0], [2, 1]]), M([[2, 0], [0, 4]])), (M([0, 1]), M([[p]]))],
    "variational_derivative": [(y2**2 + y * y1**2, (y, y1, y2), MOVES)],
    "all_positive": [([K - 1, 5 - K],), ([K, b * (K * b + 1)],), ([1 - K**2, K**2 + 1],), ([sp.sin(K) - K / K / 2],)],
    "special_values": [(K**2 - 2,), (2 * K - 3,), ((p - 1) * (p + 2),), (2 * b - K,)],
    "vanishing_factors": [(K**2 - 2 * b,), ((K - 1) * (b + 2) / K,), ((p + 1) * (p - K),)],
    "changed_where": [
        (exact.smith_form(M([[s + K, 0], [0, s + b]]), s),),
        (exact.smith_form(M([[s, K], [s, K * s]]), s),),
    ],
}
SAME = {
    "all_positive": "[0] × 1001/1000",
    "vanishing_factors": ("× 1001/1000", "[0] sign turned", "[1] sign turned"),
    "changed_where": ("× 1001/1000", "sign turned"),
}
"""Zero and positive in the same places."""
CLAIMED = ".rates[2] [0]"
"""What a step shows and claims."""

CASES = [pytest.param(name, arguments, id=f"{name}-{i}") for name in KINDS for i, arguments in enumerate(KINDS[name])]


def statuses(name, arguments, result):
    return {check.status for check in check_calls([Call(name, arguments, {}, result, 1)], [])}


def is_seen(name, arguments, made):
    try:
        return CheckStatus.FAILED in statuses(name, arguments, made())
    except (ValueError, IndexError, TypeError, AttributeError, sp.ShapeError):
        return True


@pytest.mark.parametrize(("name", "arguments"), CASES)
def test_it_holds_of_the_right_result_and_of_none_that_is_a_little_wrong(name, arguments):
    result = getattr(exact, name)(*arguments)
    assert statuses(name, arguments, result) == {CheckStatus.PASSED}
    judged = [each for each in changes(result) if not each.what.endswith(SAME.get(name, "nothing"))]
    judged = [each for each in judged if CLAIMED not in each.what or "left out" in each.what]
    assert judged
    assert not [each.what for each in judged if not is_seen(name, arguments, each.made)]


def test_the_stabilizing_solution_is_the_one_whose_loop_is_stable():
    found = exact.riccati(*REGULATOR)
    assert statuses("riccati", REGULATOR, found) == {CheckStatus.PASSED}
    for wrong in (replace(found, H=-found.H), replace(found, G=2 * found.G)):
        assert statuses("riccati", REGULATOR, wrong) >= {CheckStatus.FAILED}
    other = next(each for each in found.solutions if each.P != found.stabilizing.P)
    changed = type("Changed", (type(found),), {"stabilizing": property(lambda _: other)})
    wrong = object.__new__(changed)
    vars(wrong).update({k: v for k, v in vars(found).items() if k != "stabilizing"})
    assert CheckStatus.FAILED in statuses("riccati", REGULATOR, wrong)


def test_conditions_on_parameters_are_right_up_to_a_number():
    of = exact.interaction(M(sp.diag(-1, -2)), M([[b, 1], [0, 1]]), M(sp.eye(2)), M(sp.zeros(2)))
    for condition, status in (
        (sp.Eq(2 * b, 0), CheckStatus.PASSED),
        (sp.Eq(2 * b, 1), CheckStatus.FAILED),
        (sp.Eq(b - K, 0), CheckStatus.FAILED),
    ):
        assert statuses("interaction_conditions", (of,), (condition,)) == {status}
