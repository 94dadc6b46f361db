"""What was found of functions of states and inputs: their normal form, their derivatives, whether they are linear."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.stated.calculus import time_derivative

ORACLE = "random points (30 digits)"
NEAR = 1e-12
TRIALS = 2
DIGITS = 30


def of_normal(found: Any, expression: Any) -> Iterator[Claim]:
    """The expression, written otherwise."""
    if found != expression:
        yield Claim(expression, found, "an expression in another form")


def of_time_derivative(found: Any, expression: Any, following: Mapping[Any, Any]) -> Iterator[Claim]:
    """The derivative by the chain rule."""
    yield Claim(time_derivative(expression, following.items()), found, "the chain rule")


def of_is_zero(found: bool, expression: Any) -> Iterator[Check]:
    """Its values are zero beside those of its terms exactly where it is."""
    whole = sp.S.Zero + expression
    sizes = [_size(whole, trial) for trial in range(TRIALS)]
    if None not in sizes:
        yield Check.that("zero or not", ORACLE, found == all(size < NEAR for size in sizes if size is not None))


def _size(expression: Any, trial: int) -> float | None:
    """The value at a point beside those of its terms; None where it has none."""
    point = {x: sp.Rational(7 + 3 * i + trial, 11) for i, x in enumerate(sorted(expression.free_symbols, key=str))}
    value, *terms = (sp.N(each.xreplace(point), DIGITS) for each in (expression, *sp.Add.make_args(expression)))
    if not all(each.is_number and each.is_finite for each in (value, *terms)):
        return None
    return float(abs(value) / (1 + sum(map(abs, terms))))


def of_is_linear(found: bool, expressions: Sequence[Any], jets: Sequence[Any]) -> Iterator[Check]:
    """f(a) + f(b) = f(a + b) exactly where all are linear."""
    bends = [_bend(e, jets, affine=False) for e in expressions] if jets else []
    if bends and (found or None not in bends):
        straight = all(bend is None or bend < NEAR for bend in bends)
        yield Check.that("linear in states and inputs", ORACLE, found == straight)


def of_is_nonlinear(found: bool, expressions: Collection[Any], symbols: Collection[Any]) -> Iterator[Check]:
    """Where it is seen that one is not linear, f(a) + f(b) = f(a + b) + f(0) does not hold."""
    bends = [_bend(e, list(symbols), affine=True) for e in expressions] if found else []
    if bends and None not in bends:
        yield Check.that(
            "not linear in states and inputs", ORACLE, any(bend is not None and bend > NEAR for bend in bends)
        )


def _bend(expression: Any, symbols: Sequence[Any], *, affine: bool) -> float | None:
    """How far an expression is from being linear in symbols, of the size of its values; None where it has no value."""
    own = [x for x in symbols if expression.has(x)]
    others = sorted(expression.free_symbols - set(own), key=str)
    found: list[float] = []
    for trial in range(TRIALS):
        point = {x: sp.Rational(7 + 3 * i + trial, 11) for i, x in enumerate(others)}
        first, second = ([sp.Rational(5 + 2 * i + by + trial, 13) for i in range(len(own))] for by in (0, 7))
        together = [a + b for a, b in zip(first, second, strict=True)]
        places = [first, second, together, *([[sp.S.Zero] * len(own)] if affine else [])]
        values = [sp.N(expression.xreplace(point | dict(zip(own, place, strict=True))), DIGITS) for place in places]
        if all(value.is_number and value.is_finite for value in values):
            bend = abs(values[0] + values[1] - values[2] - (values[3] if affine else 0))
            found.append(float(bend / (1 + sum(map(abs, values)))))
    return max(found, default=None)
