"""Relations other than equality: the order of two numbers, values that differ, values that nearly agree."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from solver.derivation import Check, CheckStatus, Claim
from solver.numeric.evaluation.arithmetic import DOUBLE, multiple
from solver.numeric.evaluation.claims import claim_residual, oracle_of
from solver.numeric.evaluation.compare import QUIET
from solver.numeric.evaluation.environment import Environments
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.precision import TOLERANCE
from solver.numeric.evaluation.values import SAFETY, NotEvaluable, ShapeMismatch, Undefined, Value, shape_of

ORDERS: Mapping[str, frozenset[int]] = MappingProxyType(
    {"<": frozenset({-1}), ">": frozenset({1}), "≤": frozenset({-1, 0}), "≥": frozenset({0, 1})}
)
"""The signs of left − right with which a relation holds."""


def check_relation(
    left: Any, relation: str, right: Any, label: str, *, near: float = TOLERANCE, environments: Environments
) -> Check:
    """Return the check of left < right (or >, ≤, ≥) for numbers, of left ≠ right or of left ≈ right.

    `near` is the relative difference that ≈ allows. Values with symbols differ (≠) if they do at some point. Failed
    where an order is stated of matrices or of numbers that are not real.
    """
    oracle = oracle_of(Claim(left, right))
    try:
        if relation in ORDERS:
            return Check.that(label, oracle, order_of(left, right, environments) in ORDERS[relation])
        residual, _ = claim_residual(left, right, environments=environments)
    except ShapeMismatch as mismatch:
        return Check(label, oracle, None, None, CheckStatus.FAILED, mismatch.reason)
    except NotEvaluable as refusal:
        return Check.skipped(label, oracle, refusal.reason)
    return (
        Check.that(label, oracle, residual > TOLERANCE)
        if relation == "≠"
        else Check.within(label, oracle, residual, near)
    )


def order_of(left: Any, right: Any, environments: Environments) -> int | None:
    """Return the sign of left − right, 0 where 100 digits show no difference; None for numbers that are not real.

    Raises ShapeMismatch for matrices, NotEvaluable where decimals have too few digits to decide.
    """
    for arithmetic in (DOUBLE, multiple(50), multiple(100)):
        environment = environments.at([{}], arithmetic)
        try:
            l, r = value_of(left, environment), value_of(right, environment)
        except Undefined:
            if arithmetic is DOUBLE:  # infinite, perhaps
                continue
            raise
        if shape_of(l) or shape_of(r):
            raise ShapeMismatch("an order of matrices")
        noise = SAFETY * arithmetic.eps * (_size(l) + _size(r))
        first, second = _number(l), _number(r)
        if first == second and not np.isfinite(noise):
            return 0
        difference = first - second
        if max(abs(first.imag), abs(second.imag)) > noise:
            return None
        if not abs(difference.real) <= noise:  # also of infinite numbers, whose noise is no number
            return 1 if first.real > second.real else -1
    if not noise < QUIET * max(1.0, float(abs(first.real))):  # also of numbers beyond doubles
        raise NotEvaluable("the decimals in the formula carry too few digits to judge the relation")
    return 0


def _number(value: Value) -> Any:
    return np.ravel(np.asarray(value.value, dtype=object))[0]


def _size(value: Value) -> float:
    return float(np.ravel(np.asarray(value.magnitude))[0])
