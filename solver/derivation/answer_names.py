"""The answers of a task by name, and what marking knows of each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from solver.derivation.registry import Given


@dataclass(frozen=True, slots=True)
class SignalNames:
    """Signals by name, functions `of_time` or their transforms; `held` is what `output` is before t = 0."""

    names: tuple[str, ...]
    of_time: bool = True
    output: str = ""
    held: Any = None


@dataclass(frozen=True, slots=True)
class AnswerName:
    """A named answer of a task: its LaTeX symbol (empty: the name) and meaning; `methods` that give it (empty: all).

    An `optional` one is given when it makes sense. A `free` one is not determined by the question (eigenvectors:
    any scale is right); it may depend on what is given (a gain is free where there are several inputs). In an
    `ordered` list each item has its place; the items of any other may stand in any order. `vectors` says that the
    "columns", or the "rows", of a free matrix are right or wrong each for itself. The `principal` answers of a task
    earn the marks where a problem does not say which; that may depend on the system. A `count` is reached by many
    mistakes, so that none is named for it; `most` tells what a full rank is. `words` are those that an answer in words
    may have, `unit` is that of a number, such as "rad/s", or "ratio" if decibels may tell it. `earned` are the
    kinds of steps that earn its marks beside the one in which its value is found: a key shows them. `told` are the
    kinds of steps that tell it in a form of their own, such as equations under each other, the best first: a page
    points there where the answer is not asked for. The items of a list are expressions that are `zero`, so that an
    equation may be written for one, or they are `intervals` of real numbers. A `discrete` one is of a system in
    discrete time, also where that of the question is not; its sampling period is the option `sample_time`. Of a
    matrix of `any_size` right ones may differ in size. An expression in `signals` (which these are depends on what is
    given) may differentiate and integrate them. Of a `numbered` list the question tells how many items it has; an
    `infinite` number may be infinite. Whether the entries of a `modal` matrix are complex is part of what is asked.
    """

    name: str
    symbol: str
    doc: str
    methods: tuple[str, ...] = ()
    optional: bool = False
    free: bool | Callable[[Given[Any, Any]], bool] = False
    ordered: bool = False
    vectors: str = ""
    principal: bool | Callable[[Any], bool] = False
    count: bool = False
    most: Callable[[Given[Any, Any]], int] | None = None
    words: tuple[str, ...] = ()
    unit: str = ""
    earned: tuple[str, ...] = ()
    told: tuple[str, ...] = ()
    zero: bool = False
    intervals: bool = False
    discrete: bool = False
    any_size: bool = False
    numbered: bool = False
    infinite: bool = False
    modal: bool = False
    signals: Callable[[Given[Any, Any]], SignalNames] | None = None

    def is_free(self, given: Given[Any, Any]) -> bool:
        """Whether several values are right."""
        return self.free(given) if callable(self.free) else self.free
