"""The values of a parameter for which the plant is not controllable, or not observable."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.determinants import expanded, worked_out
from solver.derivation import (
    AnswerName,
    Answers,
    Check,
    Claim,
    Derivation,
    Given,
    Refusal,
    Step,
    Task,
    Unsolved,
    option,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import structure as judges
from solver.options.choice import Choice
from solver.options.names import Names
from solver.stated.matrices import determinant, rank
from solver.tasks.linear_algebra.characteristic_polynomial import shape_of
from solver.tasks.plant_options import PlantOptions
from solver.tasks.structure.critical_parameters import angles_of, conditions_of
from solver.tasks.structure.lost_modes import lost_modes_of
from solver.tasks.structure.pair_checks import condition_checks, that
from solver.tasks.structure.pairs import Pair, controllability_pair, observability_pair
from solver.tasks.structure.rank_test import expansion, has_zero_row, matrix_of
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.systems import StateSpace, System


@dataclass(frozen=True, kw_only=True)
class ParameterConditionOptions(PlantOptions):
    """What is lost, and by which parameter."""

    property: str = option(
        Choice(("uncontrollable", "unobservable")),
        "which property the plant is to have",
        titles={"uncontrollable": "Loss of controllability", "unobservable": "Loss of observability"},
    )
    parameter: tuple[str, ...] | None = option(
        Names(), "the parameter asked for, or several at once; may be left out where there is only one"
    )


parameter_condition: Task[StateSpace, ParameterConditionOptions] = Task(
    "parameter_condition",
    title="Parameter that costs controllability or observability",
    doc="The values of a parameter for which the plant loses controllability, or observability.",
    needs=("A",),
    options=ParameterConditionOptions,
    answers=[
        AnswerName(
            "values",
            r"\text{values}",
            r"the values of the parameter ($\mathbb{R}$: any value); of several the conditions on them",
            earned=("determinant", "minors", "conditions", "roots", "always"),
        ),
    ],
    example={"A": "[[2, k - 1], [0, 2]]", "B": "[1, k]"},
)


@parameter_condition.refusal
def matrices_and_one_parameter(system: System, options: ParameterConditionOptions) -> Iterable[Refusal]:
    """The matrix that the property is about, and a parameter that occurs."""
    wanted = options.property
    other = "C" if wanted == "unobservable" else "B"
    if getattr(system, other, True) is None:
        yield "property", Reason("parameter_condition/needs_matrix", {"wanted": wanted, "matrix": other})
    names = options.parameter
    if options.has("gain") or not hasattr(system, "parameters"):
        return
    known = [str(symbol.name) for symbol in system.parameters]
    if not known:
        yield "", Reason("parameter_condition/only_numbers")
    elif unknown := [name for name in names or () if name not in known]:
        yield "parameter", Reason("parameter_condition/unknown", {"name": unknown[0], "known": known})
    elif not names and len(known) > 1:
        yield "", Reason("parameter_condition/say_which", {"known": known})


@parameter_condition.method(source="Lecture note, 2.6 example 6")
def by_minors(given: Given[StateSpace, ParameterConditionOptions]) -> Derivation[Answers]:
    """The rank is below n where all n×n minors vanish: the zeros of the determinant, or common zeros of minors."""
    pair = _pair(given)
    wanted = _parameters(given, pair)
    x = wanted[0]
    matrix = yield from matrix_of(pair)
    if exact.rank(matrix) < pair.n:
        claim = Claim(rank(matrix), sp.Integer(exact.rank(matrix)), "rank for general values")
        yield Step("always", claims={"rank": claim}, x=x, several=len(wanted) > 1, dual=pair.dual, n=pair.n)
        return Answers(values=sp.S.Reals)
    if len(wanted) > 1:
        return (yield from conditions_of(pair, matrix, wanted))
    if exact.is_in_angles(matrix, x):
        return (yield from angles_of(pair, matrix, x))
    found = exact.critical_values(pair.turned(matrix), x)
    yield _determinant(pair, matrix, x) if matrix.rows == matrix.cols else _minors(pair, matrix, x, found)
    yield _roots(pair, matrix, x, found)
    yield from lost_modes_of(pair, x, found.values)
    return Answers(values=list(found.values))


def _determinant(pair: Pair, matrix: ImmutableMatrix, x: Any) -> Step:
    """One input (output): the determinant of the square matrix."""
    det = exact.determinant(matrix)
    claims = {"expanded": Claim(determinant(matrix), sp.expand(det), "determinant")}
    claims["factored"] = Claim(sp.expand(det), exact.vanishing_form(det), "determinant in factors")
    lines = expanded(matrix, sp.expand(det)) if expansion(matrix) else ()
    claims |= expansion(matrix)
    shape = {"zero_row": has_zero_row(matrix), **shape_of(matrix)}
    return Step("determinant", claims=claims, steps=lines, x=x, dual=pair.dual, n=pair.n, **shape)


def _minors(pair: Pair, matrix: ImmutableMatrix, x: Any, found: exact.CriticalValues) -> Step:
    """Several inputs (outputs): minors whose common zeros are those of all."""
    whole = pair.turned(matrix)
    claims, chosen = {}, []
    lines: tuple[Step, ...] = ()
    for i, (columns, value) in enumerate(exact.telling_minors(whole, x), 1):
        square = pair.turned(sp.ImmutableMatrix(whole[:, columns]))
        claims[f"minor{i}"] = Claim(determinant(square), value, Phrase("minor {i}", i=i))
        lines += worked_out("", square, sp.expand(value))
        chosen.append([j + 1 for j in columns])
    return Step(
        "minors",
        claims=claims,
        steps=lines,
        unclaimed="there are too many minors to write out; the values are checked one by one",
        chosen=chosen,
        divisor=found.divisor,
        x=x,
        dual=pair.dual,
        n=pair.n,
    )


def _roots(pair: Pair, matrix: ImmutableMatrix, x: Any, found: exact.CriticalValues) -> Step:
    """The admissible zeros; with each of them the rank is below n."""
    claims = {}
    for i, value in enumerate(found.values, 1):
        there = sp.ImmutableMatrix(matrix.xreplace({x: value}).applyfunc(sp.expand))
        if not there.has(sp.zoo, sp.nan) and not value.has(sp.Float):
            claims[f"rank{i}"] = Claim(rank(there), sp.Integer(exact.rank(there)), "rank at the value found")
    return Step(
        "roots",
        claims=claims,
        unclaimed="the values are checked with the answer" if found.values else "there is no value to try",
        x=x,
        found=list(found.values),
        left_out=list(found.left_out),
        others=list(found.others),
        dual=pair.dual,
        n=pair.n,
    )


def _pair(given: Given[StateSpace, ParameterConditionOptions]) -> Pair:
    return (
        observability_pair(given.system)
        if given.options.property == "unobservable"
        else controllability_pair(given.system)
    )


def _parameters(given: Given[StateSpace, ParameterConditionOptions], pair: Pair) -> list[Any]:
    """The parameters asked for; the only one, if none is named."""
    known = {str(symbol.name): symbol for symbol in pair.parameters}
    names = given.options.parameter
    known = {str(symbol.name): symbol for symbol in given.system.parameters} | known if names else known
    if names and all(name in known for name in names):
        return [known[name] for name in names]
    if not names and len(known) == 1:
        return list(known.values())
    raise Unsolved("parameter_condition/which_parameter" if known else "parameter_condition/no_parameter")


@parameter_condition.verification("values")
def the_rank_falls_there_and_only_there(
    given: Given[StateSpace, ParameterConditionOptions], answers: Answers
) -> Iterable[Check]:
    """The rank at every value named, and at all real values on lines of this parameter."""
    pair, values = _pair(given), answers["values"]
    wanted = _parameters(given, pair)
    x = wanted[0]
    matrix = pair.turned(judges.krylov_matrix(pair.F, pair.G))
    if values == sp.S.Reals:
        yield that("the rank is too low for general values", "values", lambda: numeric.rank(matrix) < pair.n)
        return
    yield that("the rank is $n$ for general values", "values", lambda: numeric.rank(matrix) == pair.n)
    if len(wanted) > 1:
        yield from condition_checks(matrix, values, "values", along=wanted)
        if len(wanted) == 2:
            yield that(
                "the rank is lower at no other pair of values",
                "values",
                lambda: judges.every_isolated_fall_is_named(matrix, list(values), wanted),
            )
    elif judges.is_in_angles(matrix, x):
        yield from _angle_checks(matrix, x, values)
    else:
        yield from condition_checks(matrix, [sp.Eq(x, value) for value in values], "values", along=x)


def _angle_checks(matrix: Any, x: Any, values: Iterable[Any]) -> Iterable[Check]:
    """The rank at each value for several integers in it, and where it falls in some turns."""
    for value in values:
        yield that(
            "the rank is lower at the values, for each integer in them",
            "values",
            lambda value=value: judges.rank_falls_at(matrix, x, value),  # type: ignore[misc]
        )
    yield that(
        "the rank is lower nowhere else in some turns of the angle",
        "values",
        lambda: judges.every_angle_is_named(matrix, x, list(values)),
    )
