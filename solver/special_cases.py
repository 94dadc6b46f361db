"""The special values of parameters for which a general solution does not hold, and the question solved anew there.

Known are the exceptions that steps name (`exceptions`: conditions, or expressions that vanish there), and the factors
that an answer is divided by.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any

from solver.conditions import conditions_of
from solver.derivation import CheckStatus, Claim, PartResult
from solver.engine import Earlier, resolved, solve_part, verdict
from solver.lazy import exact, noted_calls, numeric
from solver.lazy import sympy as sp
from solver.postconditions import check_calls
from solver.problem.model import Part
from solver.stated.calculus import value_at
from solver.symbols import VARIABLES
from solver.systems import StateSpace, TransferFunction
from solver.words import Reason

FOLLOWED = (StateSpace, TransferFunction)
"""Kinds of system into which a special value can be put as into matrices and polynomials."""

BOUND = frozenset({"A", *(each.name for each in VARIABLES)})
"""Names that stand for no parameter in an option: the variable of a function, of a matrix too."""

MOST = 4
"""More special values than these are named and not followed."""


@dataclass(frozen=True, slots=True)
class SpecialCase:
    """A parameter, its special value, and the part with that value and what became of it."""

    parameter: Any
    value: Any
    part: Part
    result: PartResult


def special_cases(
    part: Part, result: PartResult, earlier: Earlier, *, arithmetic: bool
) -> tuple[list[SpecialCase], Reason | None]:
    """Return the special cases of a part, solved by the same method; none where there are too many to follow.

    And the reason why they are not to be told, where what was found of them fails a check.
    """
    asked = resolved(part, earlier) if result.answers else part  # without answers, it need not be known
    if not isinstance(asked.system, FOLLOWED) or all(map(_is_a_condition, result.answers.values())):
        return [], None
    parameters = _parameters(asked)
    with noted_calls(()) as calls:
        found = list(_special_values(result, parameters))
    failed = [check for check in check_calls(calls, ()) if check.status is CheckStatus.FAILED]
    if failed:
        return [], verdict(failed, ())[1]
    zeros = {(x, value): f for f, x, value in found if _is_asked_at(asked, x, value)}
    cases = (
        (_solved(asked, result, f, *each, arithmetic=arithmetic) for each, f in zeros.items())
        if len(zeros) <= MOST
        else ()
    )
    return [case for case in cases if not _is_refused(case) and not _is_the_same(case, result)], None


def _is_a_condition(answer: Any) -> bool:
    """Whether an answer says itself for which values it holds."""
    return isinstance(answer, sp.logic.boolalg.Boolean) and not isinstance(answer, sp.Symbol)


def _parameters(part: Part) -> frozenset[Any]:
    """The parameters of a question, without those that conditions are about: their cases are the file's own."""
    options = part.options.values()
    of_options = {x for value in options for x in getattr(value, "free_symbols", ()) if str(x) not in BOUND}
    found = frozenset({*part.system.parameters, *of_options})
    told = {str(x) for each in conditions_of(found) for x in each.difference.free_symbols}
    return frozenset(x for x in found if str(x) not in told)


def _is_asked_at(part: Part, parameter: Any, value: Any) -> bool:
    """Whether the question means something there: nothing given is divided by zero, no order of a plant is lower."""
    system = part.system
    below = [exact.divisors(given, [parameter]) for given in (*_values_of(system), *part.options.values())]
    if isinstance(system, TransferFunction):
        below.append(sp.LC(p, system.variable) for row in system.denominators for p in row)
    return all(f.xreplace({parameter: value}) != 0 for each in below for f in each)


def _values_of(system: Any) -> Iterator[Any]:
    yield from (getattr(system, each.name) for each in fields(system))


def _special_values(result: PartResult, parameters: frozenset[Any]) -> Iterator[tuple[Any, Any, Any]]:
    """What vanishes, for which parameter, and at which of its values."""
    if not parameters:
        return
    for f in (*_exceptions(result), *exact.divisors(list(result.answers.values()), parameters)):
        if f.free_symbols <= parameters:
            yield from ((f, x, value) for x, value in exact.special_values(f))


def _exceptions(result: PartResult) -> Iterator[Any]:
    """What vanishes where the steps say that another solution is needed."""
    for step in result.steps:
        for each in step.walk():
            for exception in each.values.get("exceptions") or ():
                if isinstance(exception, sp.Eq):
                    yield sp.numer(sp.together(exception.lhs - exception.rhs))
                elif isinstance(exception, sp.Expr):
                    yield exception


def _solved(part: Part, result: PartResult, f: Any, parameter: Any, value: Any, *, arithmetic: bool) -> SpecialCase:
    """The question with the value put in, solved; that f is zero there is one of its checks."""
    there = {parameter: value}
    options = {name: _at(option, there) for name, option in part.options.items()}
    case = replace(part, system=_at(part.system, there), options=options, methods=(result.method,))
    found = solve_part(case, {}, arithmetic=arithmetic)[0]
    special = numeric.check_claim(Claim(value_at(f, parameter, value), sp.S.Zero), "the value is special")
    found = replace(found, checks=(*found.checks, special))
    if special.status is CheckStatus.FAILED:
        status, reason = verdict(found.checks, found.answers)
        found = replace(found, status=status, reason=reason)
    return SpecialCase(parameter, value, case, found)


def _at(value: Any, there: Mapping[Any, Any]) -> Any:
    """Return a value, or an object of values, with a special value put in."""
    if isinstance(value, list | tuple):
        return type(value)(_at(each, there) for each in value)
    if is_dataclass(value) and not isinstance(value, type):
        return replace(value, **{each.name: _at(getattr(value, each.name), there) for each in fields(value)})
    return value.xreplace(there) if there.keys() & getattr(value, "free_symbols", set()) else value


def _is_refused(case: SpecialCase) -> bool:
    """Whether nobody may ask that: a horizon of no length, a weight that is not positive."""
    reason = case.result.reason
    return reason is not None and getattr(reason, "kind", "") == "engine/refused"


def _is_the_same(case: SpecialCase, general: PartResult) -> bool:
    """Whether the general answers with the value put in are those of the case."""
    there, found = {case.parameter: case.value}, case.result.answers
    told = {name: value for name, value in general.answers.items() if name != "exceptions"}
    return found.keys() >= told.keys() and all(_equal(_at(value, there), found[name]) for name, value in told.items())


def _equal(left: Any, right: Any) -> bool:
    if isinstance(left, list | tuple) and isinstance(right, list | tuple):
        return len(left) == len(right) and all(map(_equal, left, right))
    if isinstance(left, sp.MatrixBase) and isinstance(right, sp.MatrixBase):
        return left.shape == right.shape and all(map(_equal, left.flat(), right.flat()))
    if isinstance(left, sp.Expr) and isinstance(right, sp.Expr):
        return left == right or sp.expand(left - right) == 0
    return bool(left == right)
