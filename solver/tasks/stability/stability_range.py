"""The range of stability: the condition on the parameters under which the system is asymptotically stable."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
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
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import stability as judges
from solver.options.names import Names
from solver.stated.calculus import value_at
from solver.tasks.linear_algebra.characteristic_polynomial import determinant_of
from solver.tasks.linear_algebra.eigenstructure import eigenvalues_of
from solver.tasks.plant_options import LoopOptions
from solver.tasks.stability.boundary import edges_of
from solver.tasks.stability.counterexamples import counterexample
from solver.tasks.stability.hurwitz_conditions import hurwitz_conditions_of
from solver.tasks.stability.parameter_region import parameter_region
from solver.tasks.stability.routh_array import routh_array_of
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import StateSpace, System


@dataclass(frozen=True, kw_only=True)
class StabilityRangeOptions(LoopOptions):
    """What may vary."""

    parameters: tuple[str, ...] | None = option(
        Names(), "the parameters asked for (default: all); the others stay symbols"
    )


stability_range: Task[StateSpace, StabilityRangeOptions] = Task(
    "stability_range",
    title="Range of stability",
    doc="The condition on the parameters under which every free motion dies out.",
    needs=("A",),
    options=StabilityRangeOptions,
    answers=[
        AnswerName(
            "condition",
            r"\text{condition}",
            "where the system is asymptotically stable",
            earned=("array", "first_column", "factor", "determinants", "condition"),
        )
    ],
)


@stability_range.refusal
def has_no_such_parameter(system: System, options: StabilityRangeOptions) -> Iterable[Refusal]:
    """The system must have parameters, those asked for among them."""
    found = options.parameters_with(system)
    for name in options.parameters or ():
        if name not in found and not options.later:
            yield "parameters", Reason("stability/no_parameter", {"name": name})


@stability_range.method("routh", title="Routh's criterion", source="Gantmacher, The Theory of Matrices II, XV §4")
def by_routh(given: Given[StateSpace, StabilityRangeOptions]) -> Derivation[Answers]:
    """The first column of the Routh array must be positive throughout."""
    plant = given.system
    wanted = _wanted(given)
    tabled = yield from routh_array_of(plant.A, discrete=plant.discrete)
    conditions = [row.computed[0] for row in tabled.array.rows]
    impossible = tabled.ones > 0 or any(row.special for row in tabled.array.rows)
    yield Step(
        "first_column",
        unclaimed="conditions, not equalities; the answer has a check of its own",
        conditions=[x for x in conditions if exact.sign_of(x) != 1],
        certain=_certain(conditions),
        never=[x for x in conditions if exact.sign_of(x) in (0, -1)],
        impossible=impossible,
        ones=tabled.ones,
        discrete=plant.discrete,
    )
    if impossible:
        conditions = [sp.Integer(-1)]
    return (yield from _together(plant, conditions, wanted, sp.Symbol("z" if plant.discrete else "s")))


@stability_range.method("eigenvalues", title="Eigenvalues", source="Lecture note, section 1.15")
def by_eigenvalues(given: Given[StateSpace, StabilityRangeOptions]) -> Derivation[Answers]:
    """Re λ < 0 (discrete: |λ| < 1) for the roots of each factor of χ; Hurwitz's conditions where these have no use."""
    A, discrete = given.system.A, given.system.discrete
    wanted = _wanted(given)
    conditions: list[Expr] = []
    lamda = sp.Symbol("lamda")
    factors = exact.characteristic_factors(A)
    if all(factor.roots and not _told_by_coefficients(factor) for factor in factors):
        yield from eigenvalues_of(A)
    else:
        yield from determinant_of(A, lamda)
    for factor in factors:
        if factor.degree > 2 and any(c.free_symbols for c in factor.coefficients):
            conditions += yield from hurwitz_conditions_of(factor, discrete=discrete)
            continue
        found = _of_factor(factor, discrete=discrete)
        conditions += found
        yield Step(
            "factor",
            claims=_values_at_ends(factor, lamda) if discrete and factor.degree == 2 else {},
            unclaimed="conditions, not equalities; the answer has a check of its own",
            p=factor.polynomial(lamda),
            degree=factor.degree,
            roots=[root.value for root in factor.roots],
            conditions=[x for x in found if exact.sign_of(x) != 1],
            certain=_certain(found),
            never=any(exact.sign_of(x) in (0, -1) for x in found),
            b=factor.coefficients[1],
            c=factor.coefficients[-1],
            discrete=discrete,
        )
    return (yield from _together(given.system, conditions, wanted, lamda))


def _told_by_coefficients(factor: exact.Factor) -> bool:
    """Whether sum and product of the two roots tell where they are, so that these need no formula."""
    return factor.degree == 2 and any(c.free_symbols for c in factor.coefficients)


def _of_factor(factor: exact.Factor, *, discrete: bool) -> list[Expr]:
    """What must be positive for the roots of an irreducible factor to be inside."""
    c = factor.coefficients
    if factor.degree > 2:
        return list(exact.polynomial_conditions(c, discrete=discrete))
    if not discrete:
        return list(c[1:])
    if factor.degree == 1:
        return [1 + c[1], 1 - c[1]]
    return [1 + c[1] + c[2], 1 - c[1] + c[2], 1 - c[2]]


def _certain(conditions: Iterable[Expr]) -> list[Expr]:
    """What is positive whatever the values of sines and cosines in it are."""
    return [x for x in conditions if x.has(sp.sin, sp.cos) and exact.sign_of(x) == 1]


def _values_at_ends(factor: exact.Factor, x: Symbol) -> dict[str, Claim]:
    """The values of a quadratic factor at 1 and −1."""
    p, (_, b, c) = factor.polynomial(x), factor.coefficients
    return {
        "at_one": Claim(value_at(p, x, sp.Integer(1)), 1 + b + c, "the value at 1"),
        "at_minus_one": Claim(value_at(p, x, sp.Integer(-1)), 1 - b + c, "the value at −1"),
    }


def _wanted(given: Given[StateSpace, StabilityRangeOptions]) -> list[Symbol]:
    """The parameters asked for, in their order; refuses those that are not real."""
    plant: StateSpace = given.system
    inside = sorted(plant.A.free_symbols, key=str)
    for symbol in inside:
        if symbol.is_real is False or (symbol.is_complex and symbol.is_real is None):
            raise Unsolved("stability/complex_parameter", parameter=symbol)
    names = given.options.parameters or ()
    return [symbol for name in names for symbol in inside if symbol.name == name]


def _together(
    plant: StateSpace, conditions: Sequence[Expr], wanted: Sequence[Symbol], x: Symbol
) -> Derivation[Answers]:
    """All conditions at once: intervals of one parameter, a conjunction for several; and what happens at their ends.

    There χ is a polynomial in x.
    """
    condition = exact.all_positive(conditions, wanted)
    assumed = sorted(set().union(*(x.free_symbols for x in conditions)), key=str)
    parts = condition.args if isinstance(condition, sp.And) else (condition,)
    yield Step(
        "condition",
        unclaimed="the answer, which has a check of its own",
        condition=condition,
        parts=list(parts),
        truth="always" if condition is sp.true else "never" if condition is sp.false else "",
        positive=[symbol for symbol in assumed if symbol.is_positive],
        negative=[symbol for symbol in assumed if symbol.is_negative],
        figures=parameter_region(conditions, wanted, condition, discrete=plant.discrete),
    )
    yield from edges_of(plant, condition, x)
    return Answers(condition=condition)


@stability_range.verification("condition")
def holds_where_the_eigenvalues_say(
    given: Given[StateSpace, StabilityRangeOptions], answers: Answers
) -> Iterable[Check]:
    """At points on both sides of every edge, and at random ones, the condition is true if and only if A is stable."""
    fault = judges.counterexample(given.system.A, answers["condition"], discrete=given.system.discrete)
    says = "the condition holds exactly where all eigenvalues are inside"
    check = Check.that(
        Phrase("{claim} ({fault})", claim=says, fault=fault) if fault else says,
        "numpy.linalg.eigvals, beside the edges mpmath.eig",
        not fault,
    )
    yield replace(check, reason=fault)


@stability_range.meaning("condition")
def where_it_is_wrong(wrong: Attempt[StateSpace, StabilityRangeOptions]) -> Reason | None:
    """Values of the parameters at which the condition is wrong."""
    return counterexample(wrong.given.system.A, wrong.value, discrete=wrong.given.system.discrete)
