"""Usual mistakes with Smith's form and the Smith–McMillan form."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.representation.plants import matrices_of, variable_of
from solver.words import Reason

if TYPE_CHECKING:
    from solver.derivation import Task
    from solver.systems import PolynomialMatrix
    from solver.tasks.needed import InputOutput
    from solver.tasks.plant_options import LoopOptions

REVERSED = Slip("divisibility", "the order is reversed: each factor must divide the next one")
NOT_DIVIDING = Slip("divisibility", "these entries of a diagonal form do not divide each other")
DIVISORS = Slip(
    "not_divided", "the greatest common divisors of the minors stand here; each is to be divided by the one before it"
)
ENTRIES_ONLY = Slip(
    "entries_only", "only the greatest common divisor of the entries is used; the next factors come from larger minors"
)
NUMERATORS = Slip("denominator", "the common denominator is forgotten: these are the invariant factors of $N = d\\,G$")
ACROSS = Slip("across", "a zero and a pole of different entries are cancelled; they do not cancel in $G$")


def register_for_polynomials(task: Task[PolynomialMatrix, Any]) -> None:
    """Register what goes wrong with polynomial matrices."""
    task.mistake(NOT_DIVIDING, "invariant_factors")(a_diagonal_as_it_stands)
    task.mistake(REVERSED, "invariant_factors")(in_reverse)
    task.mistake(DIVISORS, "invariant_factors")(products_of_factors)
    task.mistake(ENTRIES_ONLY, "invariant_factors")(the_first_everywhere)
    task.meaning("invariant_factors")(read_as_factors)


def register_for_fractions(task: Task[InputOutput, LoopOptions]) -> None:
    """Register what goes wrong with transfer matrices."""
    task.mistake(REVERSED, "diagonal")(in_reverse)
    task.mistake(NUMERATORS, "diagonal")(without_the_denominator)
    task.mistake(DIVISORS, "diagonal")(gcds_over_the_denominator)
    task.mistake(ACROSS, "diagonal")(cancelled_across)
    task.meaning("diagonal")(read_as_factors)


def a_diagonal_as_it_stands(attempt: Attempt[PolynomialMatrix, Any]) -> Iterable[Any]:
    """The diagonal of a matrix that is diagonal already."""
    M, x = attempt.given.system.matrix, attempt.given.system.variable
    if M.is_diagonal():
        yield [sp.Poly(each, x).monic().as_expr() if each != 0 else each for each in M.diagonal()]


def in_reverse(attempt: Attempt[Any, Any]) -> Iterable[Any]:
    """The last entry first; of those that are not zero."""
    entries = [each for each in attempt.ours if each != 0]
    yield [*entries[::-1], *attempt.ours[len(entries) :]]


def products_of_factors(attempt: Attempt[PolynomialMatrix, Any]) -> Iterable[Any]:
    """The gcds of the minors for their quotients."""
    yield _products(attempt.ours)


def _products(factors: Sequence[Any]) -> list[Any]:
    found, whole = [], sp.S.One
    for each in factors:
        whole = whole * each
        found.append(whole)
    return found


def the_first_everywhere(attempt: Attempt[PolynomialMatrix, Any]) -> Iterable[Any]:
    """e₁ for all of them."""
    yield [attempt.ours[0] if each != 0 else each for each in attempt.ours]


def without_the_denominator(attempt: Attempt[InputOutput, LoopOptions]) -> Iterable[Any]:
    """The eᵢ for eᵢ/d."""
    yield list(_form(attempt).smith.invariant_factors)


def gcds_over_the_denominator(attempt: Attempt[InputOutput, LoopOptions]) -> Iterable[Any]:
    """The gcds of the minors over d."""
    found = _form(attempt)
    d = found.denominator.as_expr()
    yield [each / d for each in _products(found.smith.invariant_factors)]


def cancelled_across(attempt: Attempt[InputOutput, LoopOptions]) -> Iterable[Any]:
    """Zeros of one entry cancelled against poles of another."""
    pairs = [list(each) for each in _form(attempt).fractions]
    for upper in pairs:
        for lower in pairs:
            shared = upper[0].gcd(lower[1])
            upper[0], lower[1] = upper[0].quo(shared), lower[1].quo(shared)
    entries = [above.as_expr() / below.as_expr() for above, below in pairs]
    yield [*entries, *attempt.ours[len(entries) :]]


def read_as_factors(wrong: Attempt[Any, Any]) -> Reason | None:
    """An item that is not monic while made so all are right, or one that does not divide the next."""
    x, value = variable_of(wrong.given.system), wrong.value
    if not isinstance(value, list) or len(value) != len(wrong.ours):
        return None
    pairs = list(zip(value, wrong.ours, strict=True))
    ratios = [sp.cancel(theirs / ours) if ours != 0 else theirs + 1 for theirs, ours in pairs]
    if not any(ratio.has(x) or ratio == 0 for ratio in ratios):
        i = next((i for i, ratio in enumerate(ratios, 1) if ratio != 1), 0)
        return Reason("smith/not_monic", {"i": i}) if i else None
    entries = [each for each in value if each != 0]
    for i, (one, following) in enumerate(pairwise(entries), 1):
        (e, psi), (f, chi) = (sp.fraction(sp.cancel(each)) for each in (one, following))
        if sp.rem(f, e, x) != 0 or sp.rem(psi, chi, x) != 0:
            return Reason("smith/not_dividing", {"i": i})
    return None


def _form(attempt: Attempt[InputOutput, LoopOptions]) -> exact.SmithMcMillan:
    """The Smith–McMillan form of the question."""
    plant: Any = attempt.given.system
    if hasattr(plant, "numerators"):
        G = exact.transfer_matrix_of_fractions(plant.numerators, plant.denominators, plant.variable)
    else:
        G = exact.transfer_matrix(*matrices_of(plant), variable_of(plant))
    return exact.smith_mcmillan(G)
