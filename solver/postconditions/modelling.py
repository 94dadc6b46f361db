"""What was found of equations in states and inputs: whether they are linear, tried with numbers."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import Any

import sympy as sp

from solver.derivation import Check

ORACLE = "random points (30 digits)"
NEAR = 1e-12
TRIALS = 2


def of_is_linear(found: bool, expressions: Sequence[Any], jets: Sequence[Any]) -> Iterator[Check]:
    """f(a) + f(b) = f(a + b) exactly where all are linear."""
    if jets:
        bends = max((_bend(e, jets, affine=False) for e in expressions), default=0.0)
        yield Check.that("linear in states and inputs", ORACLE, found == (bends < NEAR))


def of_is_nonlinear(found: bool, expressions: Collection[Any], symbols: Collection[Any]) -> Iterator[Check]:
    """Where it is seen that one is not linear, f(a) + f(b) = f(a + b) + f(0) does not hold."""
    if found:
        bends = max((_bend(e, list(symbols), affine=True) for e in expressions), default=0.0)
        yield Check.that("not linear in states and inputs", ORACLE, bends > NEAR)


def _bend(expression: Any, symbols: Sequence[Any], *, affine: bool) -> float:
    """How far an expression is from being linear in symbols, of the size of its values; 0 where it has no value."""
    own = [x for x in symbols if expression.has(x)]
    others = sorted(expression.free_symbols - set(own), key=str)
    worst = 0.0
    for trial in range(TRIALS):
        point = {x: sp.Rational(7 + 3 * i + trial, 11) for i, x in enumerate(others)}
        first, second = ([sp.Rational(5 + 2 * i + by + trial, 13) for i in range(len(own))] for by in (0, 7))
        together = [a + b for a, b in zip(first, second, strict=True)]
        places = [first, second, together, *([[sp.S.Zero] * len(own)] if affine else [])]
        values = [sp.N(expression.xreplace(point | dict(zip(own, place, strict=True))), 30) for place in places]
        if all(value.is_number and value.is_finite for value in values):
            bend = abs(values[0] + values[1] - values[2] - (values[3] if affine else 0))
            worst = max(worst, float(bend / (1 + sum(map(abs, values)))))
    return worst
