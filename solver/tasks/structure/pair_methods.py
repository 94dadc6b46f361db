"""The three tests of a pair, and what the tasks of controllability and observability have in common."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Derivation, Refusal, option
from solver.lazy import sympy as sp
from solver.options.number import Number
from solver.tasks.plant_options import PlantOptions
from solver.tasks.structure.gramian_test import finite_gramian_of, infinite_gramian_of
from solver.tasks.structure.hidden_part import hidden_modes_of
from solver.tasks.structure.pairs import Pair
from solver.tasks.structure.pbh_test import deficient_eigenvalues_of
from solver.tasks.structure.rank_test import Rank, rank_in_short, rank_of
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import System

LONGEST = 1000


@dataclass(frozen=True, kw_only=True)
class PairOptions(PlantOptions):
    """What can be said of a question about controllability or observability."""

    horizon: Expr | None = option(
        Number(),
        "the Gramian up to this time (discrete: over so many steps); without it up to infinity",
        methods=("gramian",),
    )


def horizon_refusals(system: System, options: PairOptions) -> Iterable[Refusal]:
    """The horizon is a positive time; in discrete time a number of steps."""
    horizon = options.horizon
    if horizon is None:
        return
    if system.discrete:
        if not (horizon.is_Integer and 0 < horizon <= LONGEST):
            yield "horizon", Reason("gramian/number_of_steps", {"longest": LONGEST})
    elif horizon.is_positive is False or horizon.is_finite is False or horizon.has(sp.I):
        yield "horizon", Reason("gramian/no_time")


def by_rank(pair: Pair) -> Derivation[Answers]:
    """The rank of the whole matrix, then what it leaves out."""
    found = yield from rank_of(pair)
    return (yield from _answers(pair, found))


def by_pbh(pair: Pair) -> Derivation[Answers]:
    """The rank at every eigenvalue; the whole matrix agrees."""
    yield from deficient_eigenvalues_of(pair)
    found = yield from rank_in_short(pair)
    return (yield from _answers(pair, found))


def by_gramian(pair: Pair, horizon: Any) -> Derivation[Answers]:
    """The Gramian and its rank; the whole matrix agrees."""
    W = yield from infinite_gramian_of(pair) if horizon is None else finite_gramian_of(pair, horizon)
    found = yield from rank_in_short(pair)
    answers = yield from _answers(pair, found)
    return Answers(**answers, gramian=W)


def _answers(pair: Pair, found: Rank) -> Derivation[Answers]:
    hidden = yield from hidden_modes_of(pair, found.matrix)
    matrix, verdict, modes = (
        ("observability_matrix", "observable", "unobservable_modes")
        if pair.dual
        else ("controllability_matrix", "controllable", "uncontrollable_modes")
    )
    answers = {
        matrix: found.matrix,
        "determinant": found.determinant,
        "rank": sp.Integer(found.rank),
        verdict: found.rank == pair.n,
        modes: hidden,
        "exceptions": found.exceptions,
    }
    return Answers(**{name: value for name, value in answers.items() if value is not None})
