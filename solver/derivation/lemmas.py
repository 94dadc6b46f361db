"""Derivations that several tasks share: generators of steps, composed by `yield from`, each with its wording."""

from __future__ import annotations

from collections.abc import Callable, Generator
from functools import wraps
from types import TracebackType
from typing import Any, Generic, ParamSpec, TypeVar

from solver.derivation.steps import Step

P = ParamSpec("P")
R = TypeVar("R")
Derivation = Generator[Step, None, R]

lost_lemmas: list[str] = []
"""Names of lemmas that were called, and dropped before their first step: a `yield from` is missing."""


class MistakenDerivation(Exception):  # noqa: N818 - it says what is wrong with a method, in the terms of its author
    """A method of a task is not written as it must be; the message says what to write."""


class Worded(Generator[Step, None, R], Generic[R]):
    """A derivation whose steps are worded by a file of templates; steps of lemmas that it runs keep their own."""

    def __init__(self, derivation: Derivation[R], wording: str, name: str) -> None:
        self._derivation = derivation
        self._wording = wording
        self._name = name
        self._begun = False

    def send(self, value: None) -> Step:
        """Return the next step."""
        self._begun = True
        return self._named(self._derivation.send(value))

    def throw(self, typ: Any, val: BaseException | object = None, tb: TracebackType | None = None, /) -> Step:
        """Raise an exception where the derivation stands; return the step that it goes on with."""
        self._begun = True
        return self._named(self._derivation.throw(typ, val, tb) if val is not None else self._derivation.throw(typ))

    def _named(self, step: Step) -> Step:
        for each in step.walk():
            each.wording = each.wording or self._wording
        return step

    def __del__(self) -> None:
        if not self._begun:
            lost_lemmas.append(self._name)


def worded_by(wording: str) -> Callable[[Callable[P, Derivation[R]]], Callable[P, Derivation[R]]]:
    """Name the wording file of a generator of steps; steps of lemmas it calls keep their own."""

    def decorate(derive: Callable[P, Derivation[R]]) -> Callable[P, Derivation[R]]:
        @wraps(derive)
        def worded(*args: P.args, **kwargs: P.kwargs) -> Derivation[R]:
            return Worded(derive(*args, **kwargs), wording, derive.__name__)

        worded.wording = wording  # type: ignore[attr-defined]  # read by the test that enumerates step kinds
        return worded

    return decorate


def lemma(wording: str) -> Callable[[Callable[P, Derivation[R]]], Callable[P, Derivation[R]]]:
    """Mark a derivation used by several tasks: `yield from` it. Worded by `templates/wording/lemmas/<wording>`."""
    return worded_by(f"lemmas/{wording}")
