"""Usual mistakes with Mason's rule."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from solver.derivation import Given, Task

PLUS = Slip("loop_sign", "the loops have the wrong sign: $\\Delta = 1 - \\sum L_i + \\ldots$")
WITHOUT_PRODUCTS = Slip("products", "the products of loops that do not touch are missing in $\\Delta$")
TOUCHING = Slip(
    "touching", "products of loops that touch are in $\\Delta$; only those without a common node belong there"
)
WITHOUT_COFACTORS = Slip(
    "cofactors", "the $\\Delta_k$ are missing: a loop that a path does not touch stays in its factor"
)
OPEN = Slip("open", "the loops are left out: it is the sum of the forward paths")


def register(task: Task[Any, Any]) -> None:
    """Register what goes wrong."""

    @task.mistake(PLUS, "determinant", "G")
    def plus(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        found = _found(wrong.given)
        whole = _sum([-loop.gain for loop in found.loops], found.apart)
        yield from _as(wrong.name, found, whole)

    @task.mistake(WITHOUT_PRODUCTS, "determinant", "G")
    def without_products(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        found = _found(wrong.given)
        yield from _as(wrong.name, found, _sum([loop.gain for loop in found.loops], ()))

    @task.mistake(TOUCHING, "determinant", "G")
    def touching(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        found = _found(wrong.given)
        pairs = tuple(combinations(range(len(found.loops)), 2))
        yield from _as(wrong.name, found, _sum([loop.gain for loop in found.loops], pairs))

    @task.mistake(WITHOUT_COFACTORS, "G")
    def without_cofactors(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        found = _found(wrong.given)
        yield sp.cancel(sp.together(sum((path.gain for path in found.paths), sp.S.Zero) / found.determinant))

    @task.mistake(OPEN, "G")
    def without_loops(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        yield sp.Add(*(path.gain for path in _found(wrong.given).paths))


def _found(given: Given[Any, Any]) -> exact.Mason:
    graph = given.system
    edges = exact.merged([(each.source, each.target, each.gain) for each in graph.branches])
    return exact.mason(edges, graph.input, graph.output)


def _sum(gains: list[Any], sets: Iterable[tuple[int, ...]]) -> Any:
    """1 − Σ Lᵢ + Σ Lᵢ Lⱼ − …."""
    terms = [(-1) ** len(each) * sp.Mul(*(gains[i] for i in each)) for each in sets]
    return sp.Add(1, *(-gain for gain in gains), *terms)


def _as(name: str, found: exact.Mason, determinant: Any) -> Iterable[Any]:
    """The determinant, or what Mason's rule makes of it."""
    if name == "determinant":
        yield determinant
    elif sp.cancel(determinant) != 0:
        pairs = zip(found.paths, found.cofactors, strict=True)
        yield sp.cancel(sp.together(sum((path.gain * factor for path, factor in pairs), sp.S.Zero) / determinant))
