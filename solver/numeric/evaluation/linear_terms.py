"""A stated formula as a sum of terms L f(s) R with L and R free of s, so that linear operators act on each f alone.

A sum of partial fractions with constant matrices then needs one scalar transform for each pole, on a circle of its own.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from solver.numeric.evaluation.points import free_symbols
from solver.stated import Stated


class Term(NamedTuple):
    """The product of the factors `left` (free of s), `core` and `right` (free of s), in this order."""

    left: tuple[Any, ...]
    core: Any
    right: tuple[Any, ...]


def linear_terms(formula: Any, s: Any) -> list[Term]:
    """Return terms whose sum is the formula; the formula itself as one term where nothing can be split."""
    return [_term(factors, s) for factors in _products(formula, s)]


def _products(formula: Any, s: Any) -> Iterator[tuple[Any, ...]]:
    """Return products (tuples of factors) whose sum is the formula."""
    if not isinstance(formula, Stated):
        yield (formula,)
    elif formula.operation == "total":
        for operand in formula.operands:
            yield from _products(operand, s)
    elif formula.operation == "difference":
        yield from _products(formula.operands[0], s)
        for factors in _products(formula.operands[1], s):
            yield (-1, *factors)
    elif formula.operation == "quotient" and s not in free_symbols(formula.operands[0]):
        numerator, denominator = formula.operands
        yield (Stated("quotient", (1, denominator)), numerator)
    elif formula.operation == "product":
        yield from _expanded(formula.operands, s)
    else:
        yield (formula,)


def _expanded(factors: tuple[Any, ...], s: Any) -> Iterator[tuple[Any, ...]]:
    """Multiply out the sums among the factors."""
    if not factors:
        yield ()
        return
    for first in _products(factors[0], s):
        for rest in _expanded(factors[1:], s):
            yield (*first, *rest)


def _term(factors: tuple[Any, ...], s: Any) -> Term:
    """Split off the constant factors at both ends."""
    moving = [i for i, factor in enumerate(factors) if s in free_symbols(factor)]
    if not moving:
        return Term(factors, 1, ())
    start, end = moving[0], moving[-1] + 1
    core = factors[start] if end - start == 1 else Stated("product", factors[start:end])
    return Term(factors[:start], core, factors[end:])
