"""What must hold of errors that remain and of graphs: of the right result, and of none that is a little wrong."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from solver.derivation import CheckStatus
from solver.lazy import Call, exact
from solver.postconditions import check_calls

s, t = sp.symbols("s t")
G1, G2, H = sp.symbols("G1 G2 H", real=True)
EDGES = (("r", "a", sp.S.One), ("a", "b", G1), ("b", "y", G2), ("b", "a", -H), ("y", "y", sp.Rational(1, 2)))
E = (s + 1) / (s * (s + 6))
LATE = sp.exp(-2 * s)


def statuses(name, arguments, result):
    return {check.status for check in check_calls([Call(name, arguments, {}, result, 1)], [])}


RIGHT = [
    ("transform_of", (2 * t + 3, t, s)),
    ("lasting", (t - (t - 1) * sp.Heaviside(t - 1), t)),
    ("usual_parts", (3 + 2 * t, t)),
    ("usual_parts", (sp.exp(-t), t)),
    ("error_constants", (8 * (s + 1), s**2 * (s + 4), s)),
    ("long_run", (E, s, s + 6)),
    ("long_run", ((s + 1) / (s**2 * (s + 6)), s, s + 6)),
    ("late_transform", (1 / (1 + LATE / (s + 1)), 1 / s, s, sp.Integer(2))),
    ("late_quotient", (1 / (1 + LATE / (s + 1)), s, sp.Integer(2))),
    ("late_long_run", (E / (1 + LATE), s, sp.Integer(2))),
    ("late_long_run", ((1 - LATE) / s**2, s, sp.Integer(2))),
    ("late_long_run", (E / ((1 + LATE) * (s**2 + 4)), s, sp.Integer(2))),
    ("held_where", ([G1, 2 - G1],)),
    ("held_where", ([sp.Integer(2), sp.Integer(3)],)),
    ("merged", ((*EDGES, ("r", "a", G1)),)),
    ("mason", (EDGES, "r", "y")),
    ("node_signals", (EDGES, "r")),
    ("node_removed", (EDGES, "a")),
    ("next_node", (EDGES, "r", "y")),
    ("longest_row", (EDGES, "r", "y")),
    ("transfer_form", ((G1 + G2) / (1 + G1),)),
]


@pytest.mark.parametrize(("name", "arguments"), RIGHT)
def test_it_holds_of_the_right_result(name, arguments):
    assert statuses(name, arguments, getattr(exact, name)(*arguments)) <= {CheckStatus.PASSED}


CONSTANTS = exact.error_constants(8 * (s + 1), s**2 * (s + 4), s)
RUN = exact.long_run(E, s, s + 6)
LATE_RUN = exact.late_long_run((1 - LATE) / s**2, s, sp.Integer(2))
FOUND = exact.mason(EDGES, "r", "y")
GONE = exact.node_removed(EDGES, "a")
WRONG = [
    ("transform_of", (2 * t + 3, t, s), (3 * s - 2) / s**2),
    ("lasting", (t - (t - 1) * sp.Heaviside(t - 1), t), t),
    ("usual_parts", (3 + 2 * t, t), (sp.Integer(3), sp.Integer(-2), sp.S.Zero)),
    ("usual_parts", (3 + 2 * t, t), None),
    ("error_constants", (8 * (s + 1), s**2 * (s + 4), s), replace(CONSTANTS, integrators=1)),
    ("error_constants", (8 * (s + 1), s**2 * (s + 4), s), replace(CONSTANTS, lead=sp.Integer(8))),
    ("long_run", (E, s, s + 6), replace(RUN, lead=sp.S.One)),
    ("long_run", (E, s, s + 6), replace(RUN, value=sp.S.Zero)),
    ("long_run", (E, s, s + 6), replace(RUN, order=2)),
    ("late_transform", (1 / (1 + LATE), 1 / s, s, sp.Integer(2)), 1 / (s * (1 - LATE))),
    ("late_quotient", (1 / (1 + LATE), s, sp.Integer(2)), 1 / (1 - LATE)),
    ("late_long_run", ((1 - LATE) / s**2, s, sp.Integer(2)), replace(LATE_RUN, lead=sp.S.One)),
    ("late_long_run", ((1 - LATE) / s**2, s, sp.Integer(2)), replace(LATE_RUN, value=sp.S.Zero)),
    ("late_long_run", ((1 - LATE) / s**2, s, sp.Integer(2)), replace(LATE_RUN, order=0)),
    ("late_long_run", ((1 - LATE) / s**2, s, sp.Integer(2)), replace(LATE_RUN, others=s**2 + 4)),
    ("held_where", ([G1, 2 - G1],), G1 > 0),
    ("held_where", ([sp.Integer(2)],), sp.false),
    ("merged", (EDGES,), EDGES[:-1]),
    ("mason", (EDGES, "r", "y"), replace(FOUND, determinant=-FOUND.determinant)),
    ("mason", (EDGES, "r", "y"), replace(FOUND, cofactors=(sp.Integer(2),))),
    ("mason", (EDGES, "r", "y"), replace(FOUND, transfer=2 * FOUND.transfer)),
    ("node_removed", (EDGES, "a"), replace(GONE, after=GONE.after[:-1])),
    ("next_node", (EDGES, "r", "y"), "y"),
    ("longest_row", (EDGES, "r", "y"), ("r", "b", "y")),
]


@pytest.mark.parametrize(("name", "arguments", "result"), WRONG)
def test_it_holds_of_none_that_is_wrong(name, arguments, result):
    assert CheckStatus.FAILED in statuses(name, arguments, result)
