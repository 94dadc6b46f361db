"""Extremals of functionals by the equation of Euler and Lagrange."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Options, Step, Task, Unsolved
from solver.jets import jet_symbol
from solver.lazy import numeric
from solver.numeric.judges import variations as judges
from solver.tasks.variations import extremal_checks, extremal_mistakes
from solver.tasks.variations.constants import fitted_of
from solver.tasks.variations.end_conditions import end_conditions_of, is_open
from solver.tasks.variations.euler_equations import adjoined_of, constrained, euler_equations_of
from solver.tasks.variations.extremal_value import chosen, value_of
from solver.tasks.variations.first_integrals import general_solution_of
from solver.tasks.variations.found_extremal import Extremal
from solver.tasks.variations.nature import nature_of

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import Functional
    from solver.tasks.variations.constants import Fitted
    from solver.tasks.variations.euler_equations import Stationary
    from solver.tasks.variations.unknowns import Family


@dataclass(frozen=True, kw_only=True)
class ExtremalOptions(Options):
    """There are none."""


def _has_ends(system: Any) -> bool:
    """Whether something is said of the ends, so that there is a single extremal."""
    return not is_open(system)


def _has_free_time(system: Any) -> bool:
    """Whether the end of the time is sought."""
    return bool(system.stop is None)


NEAR = 1e-7
"""What doubles leave of the first variation."""
ORACLE = "the functional along random functions, changed within a short time, by quadrature"
NATURES = ("minimum", "maximum", "neither", "undecided")
extremal: Task[Functional, ExtremalOptions] = Task(
    "extremal",
    title="Extremal of a functional",
    doc="The extremals of a functional, its value there, and whether it is a minimum or a maximum.",
    needs=("functional",),
    options=ExtremalOptions,
    answers=[
        AnswerName("equations", r"\text{equations}", "the equations of Euler and Lagrange, then any constraints",
                   principal=True, earned=("equation",), told=("equations", "equation"), zero=True),
        AnswerName("x", "x", "the extremal, a function of $t$", optional=True, principal=True, earned=("functions",)),
        AnswerName("value", "J", "the value of the functional along the extremal", optional=True,
                   principal=_has_ends),
        AnswerName("t_f", "t_f", "the end of the time, where it is free", optional=True, principal=_has_free_time),
        AnswerName("legendre", "R", "the second derivative of the integrand by the highest derivative, along the "
                   "extremal", optional=True),
        AnswerName("conjugate_point", r"t^*", "the first conjugate point after the beginning", optional=True),
        AnswerName("nature", r"\text{nature}", "what the extremal is, of a weak extremum", optional=True,
                   principal=_has_ends, words=NATURES),
    ],
)  # fmt: skip


@extremal.method(
    "euler_lagrange", title="Euler–Lagrange", source="Gelfand and Fomin, Calculus of Variations; Kirk, chapter 4"
)
def by_euler_lagrange(given: Given[Functional, ExtremalOptions]) -> Derivation[Answers]:
    """The equations, their general solution, what holds at the ends, the constants, the value."""
    system = given.system
    adjoined = yield from adjoined_of(system)
    found = yield from euler_equations_of(adjoined)
    answers = Answers(equations=found.expressions)
    for equation in found.expressions:
        if equation.is_number:
            raise Unsolved("extremal/everything" if equation == 0 else "extremal/nothing")
    if is_open(system):
        answers.update((yield from _without_ends(found)))
        return answers
    conditions = yield from end_conditions_of(found)
    families = yield from general_solution_of(found)
    fitted = yield from fitted_of(found, families, conditions)
    values: dict[int, Expr | None] = {}
    for number, each in enumerate(fitted):
        values[number] = yield from value_of(system, each, number + 1 if len(fitted) > 1 else 0)
    which = chosen(values)
    if len(fitted) > 1:
        yield _several(found, fitted, values, which)
    answers["x"] = _functions(system, fitted[which].functions)
    if (value := values[which]) is not None:
        answers["value"] = value
    if system.stop is None:
        answers["t_f"] = fitted[which].t_f
    if not any(each.left for each in fitted):
        extremal_found = _as_found(found, fitted[which])
        nature = yield from nature_of(system, extremal_found)
        told = {"legendre": nature.legendre, "conjugate_point": nature.conjugate_point, "nature": nature.verdict}
        answers.update({name: value for name, value in told.items() if value is not None})
    return answers


def _as_found(found: Stationary, fitted: Fitted) -> Extremal:
    """The extremal as the lemma on its nature takes it."""
    multipliers = {str(x): v for x, v in fitted.values.items()}
    return Extremal(found.phi, fitted.functions, multipliers, fitted.t_f)


@extremal.verification("equations")
def make_the_functional_stationary(given: Given[Functional, ExtremalOptions], answers: Answers) -> Iterable[Check]:
    """The equations are what the first variation asks along random functions, up to factors and order."""
    near = 1e-6 if numeric.holds_decimals(list(answers["equations"])) else NEAR
    system = given.system
    number = len(system.constraints)
    adjoined = judges.Adjoined(
        extremal_checks.problem_of(system),
        [constrained(sides) for sides in system.constraints],
        system.multipliers[:number],
        [jet_symbol((name, 0)) for name in system.multipliers[number:]],
    )
    residuals, complete = judges.stationary_equations(adjoined, list(answers["equations"]))
    yield Check.that("as many independent equations as the functional gives", ORACLE, complete, answer="equations")
    label = "the equations against the first variation along random functions"
    yield Check.within(label, ORACLE, max(residuals, default=float("inf")), near, answer="equations")


def _without_ends(found: Stationary) -> Derivation[dict[str, Any]]:
    """Nothing is said of the ends: the general solution with its constants, or the equations alone."""
    yield Step("open", unclaimed="no ends are given")
    try:
        families = yield from general_solution_of(found)
    except Unsolved:  # the equations are asked for too
        yield Step("beyond", unclaimed="the equations are the answer")
        return {}
    return {"x": _functions(found.system, _only(families).functions)}


def _only(families: list[Family]) -> Family:
    if len(families) != 1:
        raise Unsolved("extremal/branches", number=len(families))
    return families[0]


def _functions(system: Functional, functions: Mapping[str, Expr]) -> Any:
    """One function, or several by their names."""
    if len(system.functions) == 1:
        return functions[system.functions[0]]
    return {system.symbol((name, 0)): functions[name] for name in system.functions}


def _several(found: Stationary, fitted: list[Fitted], values: Mapping[int, Expr | None], which: int) -> Step:
    """Which of several extremals has the least value."""
    names = [found.system.symbol((name, 0)) for name in found.system.functions]
    shown = [([each.functions[name] for name in found.system.functions], values[i]) for i, each in enumerate(fitted)]
    return Step("several", unclaimed="a comparison", names=names, shown=shown, which=which,
                decided=all(value is not None and value.is_number for value in values.values()))  # fmt: skip


extremal_checks.register(extremal)
extremal_mistakes.register(extremal)
