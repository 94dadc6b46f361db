"""The sign of an expression under the assumptions of its symbols and the conditions that they carry."""

from __future__ import annotations

from functools import lru_cache

import sympy as sp

from solver.conditions import Condition, Conditions, conditions_of, symbols_of, without_conditions
from solver.exact.linear_algebra.intervals import ALLOWED, intervals
from solver.exact.linear_algebra.regions import region_of
from solver.exact.linear_algebra.sign_sets import ANY, Signs, assumed, signs_by_assumptions


def possible_signs(x: sp.Expr) -> Signs:
    """Return the signs that an expression may have; what is not proved stays possible.

    Without conditions these are the signs that the assumptions leave.
    """
    found = assumed(x)
    conditions = conditions_of(x.free_symbols) if len(found) > 1 else ()
    return found & _under(without_conditions(x), conditions) if conditions else found


@lru_cache(maxsize=4096)
def _under(x: sp.Expr, conditions: Conditions) -> Signs:
    region = region_of(conditions)
    if region is None or not all(symbol.is_real for symbol in x.free_symbols):
        return ANY
    return region.signs(x)


def values_of(x: sp.Symbol) -> tuple[sp.Expr, sp.Expr, bool, bool] | None:
    """Return the ends of the interval that conditions on a symbol alone leave, and whether each belongs to it.

    None where there are no such conditions, or where they leave several intervals.
    """
    y = without_conditions(x)
    alone = [each for each in conditions_of([x]) if each.difference.free_symbols == {y}]
    found = intervals(y, alone) if alone else []
    if len(found) != 1:
        return None
    return found[0].low, found[0].high, found[0].low_closed, found[0].high_closed


def contradict(conditions: Conditions) -> bool:
    """Whether conditions (in plain symbols) are seen to contradict each other."""
    return region_of(conditions) is None


def always_holds(condition: Condition) -> bool:
    """Whether a condition is seen to hold for all real values of its symbols, whatever is assumed of them."""
    real = {x: sp.Dummy(x.name, real=True) for x in symbols_of(condition.difference)}
    return signs_by_assumptions(condition.difference.xreplace(real)) <= ALLOWED[condition.relation]


def is_positive(x: sp.Expr) -> bool:
    """Whether an expression is known to be positive."""
    return possible_signs(x) == {1}


def is_not_zero(x: sp.Expr) -> bool:
    """Whether an expression is known to differ from zero."""
    return 0 not in possible_signs(x)
