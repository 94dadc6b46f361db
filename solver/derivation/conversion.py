"""Conversions between kinds of system: lemmas with steps and claims, one file a pair; the shortest chain is taken.

A file of `solver/conversions` registers a conversion by `@conversion(Source, Target, gives=...)`: a generator of steps
that takes the object of one kind and returns that of another. Nothing lists them by hand. `@composition("gain")`
registers what an option that any task may take makes of the system: a loop, say, which conversions turn into a plant.
The files are importable without sympy, so that it can be told what a system can be asked before anything is solved.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from typing import TYPE_CHECKING, Any, TypeVar, cast

from solver.derivation.lemmas import Derivation
from solver.derivation.steps import Unsolved
from solver.words import Reason

if TYPE_CHECKING:
    from solver.systems import System

ROOM = "solver.conversions"
S = TypeVar("S")
T = TypeVar("T")
Provided = frozenset[str]
"""What a system can be asked: see `System.provides`."""


@dataclass(frozen=True, slots=True)
class Conversion:
    """A way from one kind of object to another; `gives` is what the result provides, nothing where there is no way."""

    source: type
    target: type
    derive: Callable[[Any], Derivation[Any]]
    gives: Callable[[Provided], Iterable[str]]
    refuses: Callable[[Any], Reason | None]


@dataclass(frozen=True, slots=True)
class Composition:
    """What some options make of a system; the one of the least `order` is the innermost loop."""

    order: int
    options: tuple[str, ...]
    compose: Callable[[Any, Mapping[str, Any]], Any]


_CONVERSIONS: list[Conversion] = []
_COMPOSITIONS: list[Composition] = []


def conversion(
    source: type[S],
    target: type[T],
    *,
    gives: Callable[[Provided], Iterable[str]],
    refuses: Callable[[S], Reason | None] = lambda _: None,
) -> Callable[[Callable[[S], Derivation[T]]], Callable[[S], Derivation[T]]]:
    """Register a conversion, a lemma; `gives` tells from what the source provides what the result will.

    `refuses` says why a source as the file gives it cannot be converted (None: it can).
    """

    def register(derive: Callable[[S], Derivation[T]]) -> Callable[[S], Derivation[T]]:
        _CONVERSIONS.append(Conversion(source, target, derive, gives, refuses))
        return derive

    return register


Compose = Callable[[Any, Mapping[str, Any]], Any]


def composition(*options: str, order: int) -> Callable[[Compose], Compose]:
    """Register what some options make of a system; called when one of them at least has a value."""

    def register(compose: Compose) -> Compose:
        _COMPOSITIONS.append(Composition(order, options, compose))
        return compose

    return register


@cache
def conversions() -> Sequence[Conversion]:
    """Return the conversions of `solver/conversions`, in the order of the files. Imports no algebra."""
    for found in iter_modules(import_module(ROOM).__path__, f"{ROOM}."):
        import_module(found.name)
    return tuple(_CONVERSIONS)


def composed(system: System, options: Mapping[str, Any]) -> System:
    """Return the system that the question is about when the given options are taken into account."""
    conversions()
    for each in sorted(_COMPOSITIONS, key=lambda composition: composition.order):
        if any(options.get(name) is not None for name in each.options):
            system = each.compose(system, options)
    return system


def reachable(system: System) -> Provided:
    """Return what a system can be asked, as it stands and after any conversions."""
    return frozenset().union(*(has for _, has, _ in _ways(system)))


def chain_to(system: System, needs: Iterable[str]) -> tuple[Conversion, ...] | None:
    """Return the shortest chain of conversions to a system that provides all that is needed; None if there is none."""
    wanted = frozenset(needs)
    return next((chain for _, has, chain in _ways(system) if wanted <= has), None)


def refused(system: System, needs: Iterable[str]) -> Reason | None:
    """Return why a system as given cannot be converted to what is needed, None if it can."""
    chain = chain_to(system, needs)
    return chain[0].refuses(system) if chain else None


def _ways(system: System) -> Iterable[tuple[type, Provided, tuple[Conversion, ...]]]:
    """Yield every kind of object that a system can be turned into, by the shortest chain, the nearest first."""
    start: type = type(system)
    queue: deque[tuple[type, Provided, tuple[Conversion, ...]]] = deque([(start, system.provides, ())])
    seen = {start}
    while queue:
        kind, has, chain = queue.popleft()
        yield kind, has | _implied(has), chain
        for each in conversions():
            given = frozenset(each.gives(has)) if each.source is kind and each.target not in seen else frozenset()
            if given:
                seen.add(each.target)
                queue.append((each.target, given, (*chain, each)))


def _implied(has: Provided) -> Provided:
    """What goes with it: where there is A, states move; a transfer function has values at frequencies."""
    moves = frozenset({"motion", "states"}) if "A" in has else frozenset()
    return moves | {"gains"} if "transfer_function" in has else moves


def converted_to(system: System, target: type[T]) -> Derivation[T]:
    """Bring a system to one kind of object; raises Unsolved where there is no way."""
    chain = next((chain for kind, _, chain in _ways(system) if kind is target), None)
    if chain is None:
        raise Unsolved("conversions/not_of_this_kind", missing=[target.__name__], described=system.described)
    for each in chain:
        system = yield from each.derive(system)
    return cast("T", system)


def converted(system: System, needs: Iterable[str]) -> Derivation[Any]:
    """Bring a system to one that provides what is needed; raises Unsolved where there is no way."""
    chain = chain_to(system, needs)
    if chain is None:
        missing = sorted(set(needs) - reachable(system))
        raise Unsolved("conversions/not_of_this_kind", missing=missing or sorted(needs), described=system.described)
    for each in chain:
        system = yield from each.derive(system)
    return system
