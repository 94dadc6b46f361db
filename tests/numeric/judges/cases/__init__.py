"""Cases of judges, a module a topic: `Case(name, accepted, rejected)`; `test_every_judge` takes them all."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import sympy as sp


@dataclass(frozen=True)
class Case:
    """Answers to one question that a judge must accept, whatever their form, and answers that it must reject."""

    judge: str
    ask: Callable[[Any], Any]
    accepted: tuple[Any, ...]
    rejected: tuple[Any, ...]


def corruptions(matrix: Any) -> Iterator[sp.ImmutableMatrix]:
    """Wrong answers near a right matrix: transposed, doubled, reordered; an entry off by a thousandth, or turned."""
    right = sp.ImmutableMatrix(matrix)
    wrong = [right.T, 2 * right, -right, right[::-1, :], right[:, ::-1]]
    for i in range(right.rows):
        for j in range(right.cols):
            entry = right[i, j]
            for change in (-entry, entry * sp.Rational(1001, 1000), entry + 1):
                other = right.as_mutable()
                other[i, j] = change
                wrong.append(other)
    yield from (sp.ImmutableMatrix(each) for each in wrong if sp.ImmutableMatrix(each) != right)


def lists_near(values: Any) -> Iterator[list[Any]]:
    """Wrong lists near a right one: a value off by a thousandth, its sign turned, one missing, one too many."""
    values = list(values)
    for i, value in enumerate(values):
        for change in (-value, value * sp.Rational(1001, 1000), value + 1):
            if change != value:
                yield [*values[:i], change, *values[i + 1 :]]
        yield [*values[:i], *values[i + 1 :]]
    yield [*values, values[0]]
