"""Signal-flow graphs: their paths, loops and signals, what is left of them without a node."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, pairwise
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.stated.algebra import product, quotient, total
from solver.stated.matrices import determinant

Edges = Sequence[tuple[str, str, Any]]


def _nodes(edges: Edges) -> list[str]:
    return list(dict.fromkeys(node for source, target, _ in edges for node in (source, target)))


def _matrix(edges: Edges) -> Any:
    """I − A, A[target, source] the gains."""
    names = _nodes(edges)
    M = sp.eye(len(names))
    for source, target, gain in edges:
        M[names.index(target), names.index(source)] -= gain
    return sp.ImmutableMatrix(M)


def of_merged(found: Edges, edges: Edges) -> Iterator[Claim | Check]:
    """The gains between two nodes add up; no two branches are parallel."""
    pairs = [(source, target) for source, target, _ in found]
    yield Check.that("no parallel branches", "counted", len(set(pairs)) == len(pairs))
    for source, target in dict.fromkeys((source, target) for source, target, _ in edges):
        gains = [gain for a, b, gain in edges if (a, b) == (source, target)]
        left = [gain for a, b, gain in found if (a, b) == (source, target)]
        yield Claim(total(*gains), left[0] if left else sp.S.Zero)


def of_mason(found: Any, edges: Edges, start: str, end: str) -> Iterator[Claim | Check]:
    """Δ is the determinant of the equations, G Δ the sum of all Pₖ Δₖ; paths and loops follow branches."""
    gains = {(source, target): gain for source, target, gain in edges}
    for route in found.paths:
        yield Check.that("a path from input to output", "compared", _follows(route.nodes, route.gains, gains))
        yield Check.that("its ends", "compared", (route.nodes[0], route.nodes[-1]) == (start, end))
    for route in found.loops:
        closed = (*route.nodes, route.nodes[0])
        yield Check.that("a loop", "compared", _follows(closed, route.gains, gains))
    yield Claim(determinant(_matrix(edges)), found.determinant)
    for each in found.apart:
        sets = [set(found.loops[i].nodes) for i in each]
        apart = not any(one & other for one, other in combinations(sets, 2))
        yield Check.that("loops that do not touch", "compared", apart)
    for route, sets, cofactor in zip(found.paths, found.left, found.cofactors, strict=True):
        free = [each for each in edges if not {each[0], each[1]} & set(route.nodes)]
        yield Claim(determinant(_matrix(free)) if free else sp.S.One, cofactor)
        met = {node for each in sets for i in each for node in found.loops[i].nodes}
        yield Check.that("loops that do not touch the path", "compared", not met & set(route.nodes))
    if found.transfer is not None:
        terms = [product(*route.gains, cofactor) for route, cofactor in zip(found.paths, found.cofactors, strict=True)]
        yield Claim(product(found.transfer, found.determinant), total(*terms))


def _follows(nodes: Sequence[str], gains: Sequence[Any], branches: dict[tuple[str, str], Any]) -> bool:
    pairs = list(pairwise(nodes))
    met = nodes[:-1] if nodes[0] == nodes[-1] else nodes
    return len(pairs) == len(gains) and len(set(met)) == len(met) and all(
        branches.get(pair) == gain for pair, gain in zip(pairs, gains, strict=True)
    )  # fmt: skip


def of_node_signals(found: Any, edges: Edges, start: str) -> Iterator[Claim | Check]:
    """Each signal is the sum of what its branches bring; the input is one."""
    if found is None:
        return
    yield Check.that("the input is one", "compared", found[start] == 1)
    for name, value in found.items():
        terms = [product(gain, found[source]) for source, target, gain in edges if target == name]
        if name != start:
            yield Claim(total(*terms) if terms else sp.S.Zero, value)


def of_node_removed(found: Any, edges: Edges, node: str) -> Iterator[Claim | Check]:
    """The determinant loses the factor of the loop at the node; no branch has it as an end."""
    if found is None:
        own = [gain for source, target, gain in edges if source == target == node]
        yield Claim(total(*own), sp.S.One)
        return
    yield Check.that("the node is gone", "compared", all(node not in (a, b) for a, b, _ in found.after))
    if found.after:
        yield Claim(product(1 - found.own, determinant(_matrix(found.after))), determinant(_matrix(edges)))
    for _, _, before, first, second, after in found.changed:
        yield Claim(total(before, quotient(product(first, second), 1 - found.own)), after)


def of_next_node(found: Any, edges: Edges, start: str, end: str) -> Iterator[Check]:
    """It is a node between, or none is left that can go."""
    inner = [node for node in _nodes(edges) if node not in (start, end)]
    own = {source: gain for source, target, gain in edges if source == target}
    right = found in inner if found is not None else all(sp.cancel(1 - own.get(node, 0)) == 0 for node in inner)
    yield Check.that("a node that can be eliminated", "compared", right)


def of_longest_row(found: Any, edges: Edges, start: str, end: str) -> Iterator[Check]:
    """Neighbours of the row are joined by a branch."""
    pairs = {(source, target) for source, target, _ in edges}
    joined = all(pair in pairs for pair in pairwise(found)) or tuple(found) == (start, end)
    yield Check.that("a path from input to output", "compared", joined and (found[0], found[-1]) == (start, end))


def of_transfer_form(found: Any, F: Any) -> Iterator[Claim]:
    """It is the same function."""
    yield Claim(F, found)
