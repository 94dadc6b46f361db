"""Equations solved for some unknowns: laws of elements, conditions of equilibrium, intersections of curves."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Attempt, Check, Derivation, Given, Options, Step, Task, option
from solver.derivation.registry import Refusal
from solver.options.intervals import Intervals
from solver.options.relations import Relations
from solver.options.unknowns import Unknowns
from solver.tasks.modelling.point_mistakes import (
    ONE_OF_SEVERAL,
    ONE_TURN,
    WHOLE_TURNS,
    meaning_of_points,
    other_steps,
    parts_of,
    single_turns,
)
from solver.tasks.modelling.points import point_checks
from solver.tasks.modelling.solutions import solutions_of
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import StateSpace


@dataclass(frozen=True, kw_only=True)
class SolveEquationsOptions(Options):
    """The equations, what they are solved for, and where roots are searched."""

    equations: tuple[tuple[Expr, Expr], ...] = option(
        Relations(), "the equations, each left = right or an expression that is zero", required=True
    )
    unknowns: tuple[Symbol, ...] = option(Unknowns(), "what they are solved for", required=True)
    between: Mapping[str, Any] | None = option(
        Intervals(), "where roots are searched that no formula gives (default: −100 to 100 for each)"
    )

    def limits(self) -> Mapping[Any, Any]:
        """The limits by the symbols of the unknowns."""
        named = {x.name: x for x in self.unknowns}
        return {named[name]: ends for name, ends in (self.between or {}).items() if name in named}


solve_equations: Task[StateSpace, SolveEquationsOptions] = Task(
    "solve_equations",
    title="Solution of equations",
    doc="All solutions of equations for some unknowns, real ones where nothing else is assumed; no system is needed.",
    needs=(),
    options=SolveEquationsOptions,
    example={"equations": '["x + y = 3", "x - y = 1"]', "unknowns": "[x, y]"},
    answers=[
        AnswerName("solutions", r"\text{solutions}", "the solutions, each with the values of all unknowns; "
                   "$n$, $m$ are any integers, what stands for itself is free", earned=("list",)),
    ],
)  # fmt: skip


@solve_equations.method(source="Strang, Introduction to Linear Algebra, §2.2")
def by_elimination(given: Given[StateSpace, SolveEquationsOptions]) -> Derivation[Answers]:
    """One unknown after the other is found from the equation that gives it most easily, and put into the others."""
    options = given.options
    yield Step("equations", unclaimed="what is given", equations=list(options.equations),
               unknowns=list(options.unknowns))  # fmt: skip
    equations = [left - right for left, right in options.equations]
    found = yield from solutions_of(equations, options.unknowns, options.limits(), (), options.unknowns)
    return Answers(solutions=[dict(point) for point in found.points])


@solve_equations.refusal
def names_in_the_equations(_system: Any, options: SolveEquationsOptions) -> Iterable[Refusal]:
    """An unknown that occurs in no equation; an interval for what is no unknown."""
    inside = {s for pair in options.equations for side in pair for s in side.free_symbols}
    known = sorted(map(str, inside))
    for x in options.unknowns:
        if x not in inside:
            yield "unknowns", Reason("solutions/not_in_the_equations", {"name": x.name, "known": known})
    names = [x.name for x in options.unknowns]
    for name in options.between or {}:
        if name not in names:
            yield "between", Reason("solutions/no_unknown", {"name": name, "known": names})


@solve_equations.verification("solutions")
def satisfied_there_and_nowhere_else(
    given: Given[StateSpace, SolveEquationsOptions], answers: Answers
) -> Iterable[Check]:
    """Each solution in the equations as they are given; Newton's method finds no other."""
    options = given.options
    equations = [left - right for left, right in options.equations]
    told = options.unknowns
    yield from point_checks(equations, told, told, options.limits(), answers["solutions"], "solutions")


@solve_equations.mistake(ONE_OF_SEVERAL, "solutions")
def one_of_several(attempt: Attempt[StateSpace, SolveEquationsOptions]) -> Iterable[Any]:
    """Some of the solutions are not told."""
    yield from parts_of(attempt.ours)


@solve_equations.mistake(ONE_TURN, "solutions")
def one_turn(attempt: Attempt[StateSpace, SolveEquationsOptions]) -> Iterable[Any]:
    """The solutions of a single turn in place of a family."""
    yield from single_turns(attempt.ours)


@solve_equations.mistake(WHOLE_TURNS, "solutions")
def whole_turns(attempt: Attempt[StateSpace, SolveEquationsOptions]) -> Iterable[Any]:
    """2nπ in place of nπ, and nπ in place of 2nπ."""
    yield from other_steps(attempt.ours)


@solve_equations.meaning("solutions")
def told_and_missing(attempt: Attempt[StateSpace, SolveEquationsOptions]) -> Reason | None:
    """What is listed is right, but others are not."""
    return meaning_of_points(
        list(solve_equations.verify(attempt.given, Answers(solutions=attempt.value))), attempt.value
    )
