"""The points where a system is at rest: x' = f(x, u) = 0, in discrete time x = f(x, u)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Attempt, Check, Derivation, Given, Options, Slip, Step, Task, option
from solver.derivation.registry import Refusal
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.options.input_values import InputValues
from solver.options.intervals import Intervals
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
from solver.tasks.modelling.rest import Rest, at_rest
from solver.tasks.modelling.row_equations import signals_of
from solver.tasks.modelling.solutions import solutions_of
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Symbol

    from solver.systems import Equations


@dataclass(frozen=True, kw_only=True)
class EquilibriumPointsOptions(Options):
    """The inputs that are constant, what is asked for, and where roots are searched."""

    inputs: Mapping[str, Any] | None = option(
        InputValues(), "constant values of inputs; one that is not named keeps its symbol"
    )
    unknowns: tuple[Symbol, ...] | None = option(
        Unknowns(dynamic=True), "what is asked for: the states, or an input in place of one"
    )
    between: Mapping[str, Any] | None = option(
        Intervals(dynamic=True), "where roots are searched that no formula gives (default: −100 to 100 for each)"
    )


equilibrium_points: Task[Equations, EquilibriumPointsOptions] = Task(
    "equilibrium_points",
    title="Equilibrium points",
    doc="All points where nothing changes: the real solutions of f(x, u) = 0 (discrete: f(x, u) = x).",
    needs=("rest",),
    options=EquilibriumPointsOptions,
    example={"equations": '["x\' = -x + y", "y\' = -x - y - x^2"]'},
    answers=[
        AnswerName("points", r"\text{points}", "the equilibria, each with the values of its unknowns; "
                   "$n$, $m$ are any integers, what stands for itself is free", earned=("list",)),
    ],
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Asked:
    """The equations at rest, what points tell, all unknowns, and the limits of a search."""

    rest: Rest
    told: tuple[Any, ...]
    every: tuple[Any, ...]
    between: Mapping[Any, Any]


def asked(given: Given[Equations, EquilibriumPointsOptions]) -> Asked:
    """Return what is asked for."""
    options, model = given.options, given.system
    rest = at_rest(model, options.inputs or {})
    own = {str(model.symbol((name, 0))): model.symbol((name, 0)) for name in model.functions}
    told = [own.get(str(x), x) for x in options.unknowns or rest.states]
    others = [x for x in (*rest.zero, *(a for a, _ in rest.same), *rest.hidden) if x not in told]
    limits = {own.get(name, sp.Symbol(name, real=True)): ends for name, ends in (options.between or {}).items()}
    return Asked(rest, tuple(told), (*told, *others), limits)


@equilibrium_points.method(source="Khalil, Nonlinear Systems, §1.2")
def by_rest(given: Given[Equations, EquilibriumPointsOptions]) -> Derivation[Answers]:
    """All derivatives are zero (all samples equal); what is left is solved for one unknown after the other."""
    question = asked(given)
    rest, model = question.rest, given.system
    yield Step(
        "rest",
        unclaimed="the equations at rest",
        before=list(model.sides),
        equations=[pair for pair in rest.sides if pair[0] != pair[1]],
        zero=list(rest.zero),
        same=list(rest.same),
        held=[(model.symbol((name, 0)), value) for name, value in (given.options.inputs or {}).items()],
        kept=[
            u
            for name, u in zip(model.inputs, rest.inputs, strict=True)
            if name not in (given.options.inputs or {}) and u not in question.told
        ],
        unknowns=list(question.told),
        discrete=model.discrete,
    )
    taken = [symbol.name for symbol in (*model.jets, *model.parameters)]
    known = {**dict.fromkeys(rest.zero, sp.Integer(0)), **dict(rest.same)}
    left = [a - b for a, b in rest.sides if a != b]
    found = yield from solutions_of(left, question.every, question.between, taken, question.told, known)
    regular, singular = _told_apart(found.points, question)
    if singular:
        yield Step(
            "singular",
            unclaimed="what the equations tell of the motion",
            points=[[(x, point[x]) for x in question.told] for point, _ in singular],
            leading=[factors for _, factors in singular],
            highest=sp.ImmutableMatrix(rest.highest),
            left=len(regular),
            discrete=model.discrete,
        )
    return Answers(points=[dict(point) for point in regular])


def _told_apart(
    points: Sequence[Mapping[Any, Any]], question: Asked
) -> tuple[list[Mapping[Any, Any]], list[tuple[Mapping[Any, Any], Any]]]:
    """The points where the equations determine the motion, and those where they do not, with the factors there."""
    leading = question.rest.leading
    if leading is None:
        return list(points), []
    regular, singular = [], []
    for point in points:
        factors = leading.xreplace({x: value for x, value in point.items() if value != x}).applyfunc(exact.normal)
        if exact.is_zero(exact.determinant(factors)):
            singular.append((point, factors))
        else:
            regular.append(point)
    return regular, singular


def _functions(system: Any) -> tuple[Sequence[str], Sequence[str]]:
    """The unknowns and the inputs of a system that has equations, or would have."""
    if isinstance(system, systems.StateSpace):
        return signals_of(system, "state"), signals_of(system, "input")
    return getattr(system, "unknowns", ()), getattr(system, "inputs", ())


@equilibrium_points.refusal
def names_of_limits(system: Any, options: EquilibriumPointsOptions) -> Iterable[Refusal]:
    """An interval for what is no unknown; of a plant in state space also another name that is none of its own."""
    unknowns, inputs = _functions(system)
    if isinstance(system, systems.StateSpace):
        for name in (name for name in options.inputs or {} if name not in inputs):
            yield "inputs", Reason("solutions/no_input", {"name": name, "known": list(inputs)})
        for name in (str(x) for x in options.unknowns or () if str(x).split("(")[0] not in (*unknowns, *inputs)):
            yield "unknowns", Reason("solutions/no_unknown", {"name": name, "known": sorted({*unknowns, *inputs})})
    for name in (options.between or {}) if unknowns else ():
        known = {*unknowns, *inputs}
        if name not in known and name.split("_d")[0] not in known and name.split("(")[0] not in known:
            yield "between", Reason("solutions/no_unknown", {"name": name, "known": sorted(known)})


@equilibrium_points.verification("points")
def rest_there_and_nowhere_else(given: Given[Equations, EquilibriumPointsOptions], answers: Answers) -> Iterable[Check]:
    """Each point in the equations with all derivatives zero; Newton's method finds no other."""
    question = asked(given)
    zero = {x: sp.Integer(0) for x in question.rest.zero if x not in question.told}
    equations = [e for each in question.rest.equations if (e := each.xreplace(zero)) != 0]
    every = [x for x in question.every if x not in zero]
    yield from point_checks(
        equations, question.told, every, question.between, answers["points"], "points", question.rest.leading
    )


@equilibrium_points.mistake(ONE_OF_SEVERAL, "points")
def one_of_several(attempt: Attempt[Equations, EquilibriumPointsOptions]) -> Iterable[Any]:
    """Some of the points, or families, are not told."""
    yield from parts_of(attempt.ours)


@equilibrium_points.mistake(ONE_TURN, "points")
def one_turn(attempt: Attempt[Equations, EquilibriumPointsOptions]) -> Iterable[Any]:
    """The points of a single turn in place of a family."""
    yield from single_turns(attempt.ours)


@equilibrium_points.mistake(WHOLE_TURNS, "points")
def whole_turns(attempt: Attempt[Equations, EquilibriumPointsOptions]) -> Iterable[Any]:
    """2nπ in place of nπ, and nπ in place of 2nπ."""
    yield from other_steps(attempt.ours)


@equilibrium_points.mistake(
    Slip("moving", "In an equilibrium nothing moves: the velocities are zero, they are not free."), "points"
)
def moving(attempt: Attempt[Equations, EquilibriumPointsOptions]) -> Iterable[Any]:
    """Velocities as free as the positions."""
    zero = asked(attempt.given).rest.zero
    yield [{x: x if x in zero else value for x, value in point.items()} for point in attempt.ours]


@equilibrium_points.mistaken_question(Slip("gravity_sign", "Gravity has the wrong sign."))
def gravity_reversed(system: Any, options: EquilibriumPointsOptions) -> tuple[Any, EquilibriumPointsOptions] | None:
    """The equations with −g in place of g."""
    sides = getattr(system, "sides", ())
    g = next((s for pair in sides for side in pair for s in side.free_symbols if s.name == "g"), None)
    if g is None:
        return None
    turned = tuple((left.xreplace({g: -g}), right.xreplace({g: -g})) for left, right in sides)
    return replace(system, sides=turned, written=()), options


@equilibrium_points.mistaken_question(Slip("inputs", "The inputs have other values than those the question gives."))
def without_inputs(system: Any, options: EquilibriumPointsOptions) -> tuple[Any, EquilibriumPointsOptions] | None:
    """All inputs are zero."""
    names = getattr(system, "inputs", ())
    zero = {name: sp.Integer(0) for name in names}
    return (system, replace(options, inputs=zero)) if names and dict(options.inputs or {}) != zero else None


@equilibrium_points.meaning("points")
def told_and_missing(attempt: Attempt[Equations, EquilibriumPointsOptions]) -> Reason | None:
    """What is listed is right, but others are not."""
    return meaning_of_points(
        list(equilibrium_points.verify(attempt.given, Answers(points=attempt.value))), attempt.value
    )
