"""Claims checked: both sides of every displayed equality evaluated at random points."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from solver.derivation import Check, CheckStatus, Claim, Step
from solver.numeric.evaluation.arithmetic import DOUBLE
from solver.numeric.evaluation.compare import Residual, worst_residual
from solver.numeric.evaluation.environment import Environment, Environments, Point
from solver.numeric.evaluation.points import PointSource, first_points, free_symbols, whole_symbols
from solver.numeric.evaluation.precision import TOLERANCE, precision_of
from solver.numeric.evaluation.sides import Sides
from solver.numeric.evaluation.stated import Oracle, about
from solver.numeric.evaluation.values import NotEvaluable, ShapeMismatch, Undefined
from solver.stated import Stated
from solver.words import Phrase

POINTS = 3
POINTS_OF_WHOLE_NUMBERS = 5
REDRAWS = 10


def check_steps(steps: Iterable[Step], *, integers: frozenset[str] = frozenset()) -> tuple[Check, ...]:
    """Return the checks of all claims of the steps and their substeps, in the order of reading."""
    environments = Environments()
    return tuple(
        check_claim(
            claim, claim.says or f"{step.kind}: {key}", integers=integers, environments=environments, shown=True
        ).displayed_in(number)
        for number, first in enumerate(steps, start=1)
        for step in first.walk()
        for key, claim in step.claims.items()
    )


def check_claim(
    claim: Claim,
    label: str,
    *,
    integers: frozenset[str] = frozenset(),
    answer: str = "",
    environments: Environments | None = None,
    shown: bool = False,
) -> Check:
    """Return the check of one equality at random points; `integers` names symbols that take whole numbers.

    Failed where the shapes differ; skipped, with the reason, where a side can't be evaluated soundly. `answer` is the
    name of the answer that it judges; `environments` are shared with the other claims of a derivation. What a step has
    `shown` may be settled by doubles; an answer that is exact agrees to many digits.
    """
    judges = (answer,) if answer else ()
    oracle = oracle_of(claim)
    try:
        residual, digits = claim_residual(claim.left, claim.right, integers, environments, shown=shown)
    except ShapeMismatch as mismatch:
        return Check(label, oracle, None, None, CheckStatus.FAILED, mismatch.reason, judges)
    except NotEvaluable as refusal:
        return Check.skipped(label, oracle, refusal.reason, answer=answer)
    by = oracle if digits == DOUBLE.digits else Phrase("{oracle} ({digits} digits)", oracle=oracle, digits=digits)
    found = Check.within(label, by, residual, residual.tolerance, answer=answer)
    return replace(found, sides=(claim.left, claim.right)) if found.status is CheckStatus.FAILED else found


def check_residual(
    label: str,
    oracle: str,
    residual: Callable[[], float],
    tolerance: float = TOLERANCE,
    *,
    answer: str = "",
    sides: tuple[Any, Any] | None = None,
) -> Check:
    """Return the check of a residual function's result; skipped, with the reason, where it refuses.

    The residual's own tolerance counts where it has one. Failed where shapes do not fit. `answer` is the name of the
    answer that it judges; `sides` are those of the equality that the residual is of, if it is of one.
    """
    try:
        found = residual()
        tolerance = found.tolerance if isinstance(found, Residual) else tolerance
        check = Check.within(label, oracle, found, tolerance, answer=answer)
        return replace(check, sides=sides) if check.status is CheckStatus.FAILED else check
    except ShapeMismatch as mismatch:
        return replace(Check.that(label, oracle, False, answer=answer), reason=mismatch.reason)
    except (ZeroDivisionError, np.linalg.LinAlgError):
        reason = "a matrix that must have an inverse is singular"
        return replace(Check.that(label, oracle, False, answer=answer), reason=reason)
    except NotEvaluable as refusal:
        return Check.skipped(label, oracle, refusal.reason, answer=answer)


def oracle_of(claim: Claim) -> str:
    """Return the name of what evaluates the claim."""
    stated = [node for side in (claim.left, claim.right) for node in nodes_of_stated(side)]
    oracles = [about(operation, "ORACLE") for operation in {formula.operation for formula in stated}]
    return max((each for each in oracles if each), default=Oracle(0, "random points")).name


def nodes_of_stated(formula: Any) -> Iterable[Stated]:
    """Return the stated formulas within a formula, itself included."""
    if isinstance(formula, Stated):
        yield formula
        for operand in formula.operands:
            yield from nodes_of_stated(operand)


def claim_residual(
    left: Any,
    right: Any,
    integers: frozenset[str] = frozenset(),
    environments: Environments | None = None,
    *,
    shown: bool = True,
) -> tuple[Residual, int]:
    """Return the worst residual of left = right over some points, and the digits that decided it.

    Points at which a side has no value are replaced by others, up to ten. Raises NotEvaluable, ShapeMismatch.
    """
    symbols = free_symbols(left) | free_symbols(right)
    whole = whole_symbols(left, right, names=integers, symbols=symbols) & symbols if symbols else symbols
    wanted = (POINTS_OF_WHOLE_NUMBERS if whole else POINTS) if symbols else 1
    stated = [formula for side in (left, right) for formula in nodes_of_stated(side)]
    limited = [formula for formula in stated if any(about(formula.operation, each) for each in ("reach", "admitted"))]
    sides = Sides(left, right, (environments or Environments()).at)
    precision = precision_of(left, right, shown=shown)
    points = _in_reach(first_points(symbols, whole, wanted), limited)
    try:
        return worst_residual(sides, points, precision)
    except Undefined:
        source = PointSource(symbols, whole)
        source.several(wanted)
        return _point_by_point(lambda some: worst_residual(sides, some, precision), source, limited, points)


def _point_by_point(
    judge: Any, source: PointSource, limited: list[Stated], points: Sequence[Point]
) -> tuple[Residual, int]:
    """Return what worst_residual does, with other points for those at which a side has no value."""
    results: list[tuple[Residual, int]] = []
    candidates = [*points, *(None for _ in range(REDRAWS if source.symbols else 0))]
    for candidate in candidates:
        point = candidate if candidate is not None else _in_reach([source.draw()], limited)[0]
        try:
            results.append(judge([point]))
        except Undefined as undefined:
            reason = undefined
        if len(results) == len(points):
            break
    if not results:
        raise reason
    return max((residual for residual, _ in results), key=lambda each: each / each.tolerance), max(
        digits for _, digits in results
    )


def _in_reach(points: Sequence[Point], limited: list[Stated]) -> Sequence[Point]:
    """Move symbols to where the operations have values: the s of a Laplace integral to where it converges.

    Those that doubles can take only so far, like the t of an inversion integral, are scaled to 7 … 100 % of that.
    """
    if not limited:
        return points
    reach: dict[Any, Any] = {}
    for formula in limited:
        if admitted := about(formula.operation, "admitted"):
            points = admitted(points, *formula.operands)
    environment = Environment.at(points)
    for formula in limited:
        if largest_values := about(formula.operation, "reach"):
            for symbol, largest in largest_values(environment, *formula.operands).items():
                reach[symbol] = np.minimum(reach.get(symbol, np.inf), largest)
    scaled = [{t: point[t] / 1.5 * float(largest[p]) for t, largest in reach.items()} for p, point in enumerate(points)]
    return [{**point, **times} for point, times in zip(points, scaled, strict=True)]
