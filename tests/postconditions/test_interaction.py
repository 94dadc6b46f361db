"""What must hold of the kernels of decoupling and of loops holds of right results, and of none a little wrong."""

import pytest
import sympy as sp

from solver import exact
from solver.derivation import CheckStatus
from solver.lazy import Call
from solver.postconditions import check_calls
from tools.corrupted_kernels.changes import changes

M = sp.ImmutableMatrix
g = sp.Symbol("g", real=True)
A, B, C = M([[0, 1, 0], [-2, -1, 1], [1, 0, -1]]), M([[0, 0], [1, 1], [0, 2]]), M([[1, 0, 0], [0, 0, 1]])
PLANT = (A, B, C, M(sp.zeros(2)))
DIRECT = (A, B, C, M([[0, 0], [0, 1]]))
WITH_ZERO = (M(sp.diag(-1, -3, -1)), M([[1, 0], [0, 1], [0, 1]]), M([[1, 2, 0], [1, 0, 1]]), M(sp.zeros(2)))
NEVER = (M([[-1, 1], [0, -2]]), M([[1, 2], [0, 0]]), M(sp.eye(2)), M(sp.zeros(2)))
LATE = (M([[0, 0, 1], [0, -1, 0], [0, 0, -2]]), M([[1, 0], [1, 0], [0, 1]]), C[:, [0, 2, 1]], M(sp.zeros(2)))
GAIN = (M(sp.diag(-1, -2)), M([[g, 1], [0, 1]]), M(sp.eye(2)), M(sp.zeros(2)))

FOUND, ZERO = exact.interaction(*PLANT), exact.interaction(*WITH_ZERO)
POLYNOMIALS = ((sp.Integer(1), sp.Integer(2), sp.Integer(5)), (sp.Integer(1), sp.Integer(3)))
LAW = exact.decoupling_law(ZERO, ((sp.Integer(1), sp.Integer(2)), (sp.Integer(1), sp.Integer(3))))
LOOP = M(WITH_ZERO[0] - WITH_ZERO[1] * LAW.K)
FIRST, SECOND = exact.Realization(*WITH_ZERO), exact.Realization(M([[-4]]), M([[0, 2]]), M([[0], [1]]), M(sp.eye(2)))

CASES = [
    ("interaction", PLANT),
    ("interaction", DIRECT),
    ("interaction", NEVER),
    ("decoupling_law", (FOUND, POLYNOMIALS)),
    ("hidden_motion", (ZERO, LOOP)),
    ("dynamically_decouplable", LATE),
    ("dynamically_decouplable", NEVER),
    ("in_series", (FIRST, SECOND)),
    ("fed_back", (FIRST, SECOND)),
    ("constant_realization", (M([[1, 2]]),)),
]
FREE = (".sizes", ".dual", ".matrix", ".determinant", ".derivatives", ".last")
"""What follows from the rest."""


def statuses(name, arguments, result):
    return {check.status for check in check_calls([Call(name, arguments, {}, result, 1)], [])}


@pytest.mark.parametrize(("name", "arguments"), CASES)
def test_it_holds_of_the_right_result_and_of_none_that_is_a_little_wrong(name, arguments):
    result = getattr(exact, name)(*arguments)
    assert statuses(name, arguments, result) == {CheckStatus.PASSED}
    judged = [each for each in changes(result) if not any(free in each.what for free in FREE)]
    assert judged
    assert not [each.what for each in judged[:40] if not _is_seen(name, arguments, each.made)]


def test_conditions_are_those_under_which_the_matrix_loses_rank():
    of = exact.interaction(*GAIN)
    assert exact.interaction_conditions(of) == (sp.Eq(g, 0),)
    assert statuses("interaction_conditions", (of,), (sp.Eq(g, 0),)) == {CheckStatus.PASSED}
    assert statuses("interaction_conditions", (of,), (sp.Eq(g, 1),)) == {CheckStatus.FAILED}


def _is_seen(name, arguments, made):
    try:
        return CheckStatus.FAILED in statuses(name, arguments, made())
    except (ValueError, IndexError, KeyError, TypeError, AttributeError, sp.ShapeError):
        return True
