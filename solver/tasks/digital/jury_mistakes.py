"""What goes wrong where a polynomial in z is asked for its stability, and what a wrong table or condition says."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Given, Slip, Task
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.stability.counterexamples import counterexample
from solver.tasks.stability.criterion import CriterionOptions, companion
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import Polynomial

HALF_PLANE = Slip(
    "half_plane", "this is about the left half plane; in discrete time the roots must lie in the unit circle"
)
NECESSARY = Slip(
    "necessary_only", "these conditions are necessary; the rows of the table below the first are forgotten"
)
SIGN_AT_MINUS_ONE = Slip("sign_at_minus_one", r"the factor $(-1)^{n}$ of $p(-1)$ is forgotten")
INSIDE = Slip("inside_for_outside", "this is the number of roots inside the unit circle")

Wrong = Attempt["Polynomial", CriterionOptions]


def register(task: Task[Polynomial, CriterionOptions]) -> None:
    """Register the usual mistakes of the task, what wrong values mean, and what follows from what."""
    task.mistake(HALF_PLANE, "stable", "unstable_poles", "condition")(in_the_half_plane)
    task.mistake(NECESSARY, "condition")(necessary_conditions_alone)
    task.mistake(SIGN_AT_MINUS_ONE, "condition")(without_the_sign)
    task.mistake(INSIDE, "unstable_poles")(roots_inside)
    task.consequence("stable", of=("unstable_poles",), symbolic=False)(none_outside)
    task.meaning("condition")(where_it_is_wrong)


def _coefficients(wrong: Wrong) -> tuple[Expr, ...]:
    c = wrong.given.system.coefficients
    return c if exact.sign_of(c[0]) == 1 else tuple(sp.cancel(each / c[0]) for each in c)


def _where(positive: Iterable[Expr]) -> Any:
    """The condition that all are positive; None where it has no short form."""
    try:
        return exact.all_positive(list(positive))
    except exact.NotExact:
        return None


def in_the_half_plane(wrong: Wrong) -> Iterable[Any]:
    """What would be right for a polynomial in s."""
    c = _coefficients(wrong)
    array = exact.routh(c)
    if wrong.name == "condition":
        special = any(row.special for row in array.rows)
        condition = _where([sp.Integer(-1)] if special else array.first_column)
        if condition is not None:
            yield condition
        return
    counts = exact.root_counts(c)
    if counts is not None:
        yield sp.Integer(counts.outside) if wrong.name == "unstable_poles" else not counts.outside and not counts.on


def necessary_conditions_alone(wrong: Wrong) -> Iterable[Any]:
    """p(1), (−1)ⁿ p(−1) and aₙ ∓ a₀ positive, or some of these alone."""
    found = exact.jury_conditions(_coefficients(wrong))
    ends = found.ends[0] if found.ends else ()
    at_ends = (found.at_one, found.at_minus_one)
    for chosen in ((*at_ends, *ends), at_ends, ends):
        condition = _where(chosen) if chosen else None
        if condition is not None:
            yield condition


def without_the_sign(wrong: Wrong) -> Iterable[Any]:
    """p(−1) > 0 for a polynomial of odd degree."""
    c = _coefficients(wrong)
    if len(c) % 2 == 0:
        found = exact.jury_conditions(c)
        condition = _where((found.at_one, -found.at_minus_one, *(each for pair in found.ends for each in pair)))
        if condition is not None:
            yield condition


def roots_inside(wrong: Wrong) -> Iterable[Any]:
    """The roots inside for those outside."""
    counts = exact.disc_counts(_coefficients(wrong))
    if counts.outside is not None and counts.on is not None:
        yield sp.Integer(wrong.given.system.degree - counts.outside - counts.on)


def none_outside(_given: Given[Polynomial, CriterionOptions], found: Mapping[str, Any]) -> Any:
    """Not stable where a root is outside; None where none is, as one may be on the circle."""
    return False if found["unstable_poles"] > 0 else None


def where_it_is_wrong(wrong: Wrong) -> Reason | None:
    """Values of the parameters at which the condition is wrong."""
    return counterexample(companion(wrong.given.system), wrong.value, discrete=True)
