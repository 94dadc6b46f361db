"""Usual mistakes with variations: a factor lost, terms left out."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import sympy as sp
from solver.tasks.variations.jets import variations

if TYPE_CHECKING:
    from solver.derivation import Task
    from solver.systems import Functional
    from solver.tasks.variations.functional_variation import FunctionalVariationOptions

    Tried = Attempt[Functional, FunctionalVariationOptions]

HALF = Slip("half", "the factor $\\frac{1}{2}$ of the second variation is lost")
MIXED = Slip("mixed", "the mixed term is counted once: it stands twice in the square")
FIRST = Slip("first_kept", "only the part of second degree is asked for: the increment holds the first variation too")
WHOLE = Slip("whole", "this is the whole increment: only its part of first degree is linear in the variation")
DERIVATIVE = Slip("derivative", "the variation of the derivative is forgotten: $\\dot{x}$ varies with $x$")
SIGN = Slip("sign", "the sign is reversed")


def register(task: Task[Functional, FunctionalVariationOptions]) -> None:
    """Register what goes wrong with variations."""
    task.mistake(HALF, "second_variation")(without_half)
    task.mistake(MIXED, "second_variation")(mixed_once)
    task.mistake(FIRST, "second_variation")(first_kept)
    task.mistake(WHOLE, "first_variation")(whole_increment)
    task.mistake(DERIVATIVE, "first_variation", "second_variation")(derivative_forgotten)
    task.mistake(SIGN, "increment", "first_variation", "second_variation")(reversed_sign)


def without_half(attempt: Tried) -> Iterable[Any]:
    """Twice the second variation."""
    yield 2 * attempt.ours


def mixed_once(attempt: Tried) -> Iterable[Any]:
    """The terms with two different variations halved."""
    changes = list(variations(attempt.given.system).values())
    terms = sp.Add.make_args(sp.expand(attempt.ours))
    yield sp.Add(*(term / 2 if sum(term.has(d) for d in changes) > 1 else term for term in terms))


def first_kept(attempt: Tried) -> Iterable[Any]:
    """First and second variation added."""
    yield attempt.answers["first_variation"] + attempt.ours


def whole_increment(attempt: Tried) -> Iterable[Any]:
    """The increment, where it has more than its first part."""
    yield attempt.answers["increment"]


def derivative_forgotten(attempt: Tried) -> Iterable[Any]:
    """Only x varied."""
    system = attempt.given.system
    lost = {d: sp.S.Zero for (q, d) in variations(system).items() if q not in system.symbols()}
    if attempt.ours.has(*lost):
        yield attempt.ours.xreplace(lost)


def reversed_sign(attempt: Tried) -> Iterable[Any]:
    """The other sign."""
    yield -attempt.ours
