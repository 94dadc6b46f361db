"""Signal-flow graphs: paths and loops, Mason's rule, and nodes eliminated one by one.

A graph is its branches (source, target, gain), nodes by name. Source: S. J. Mason, Proc. IRE 44 (1956), 920–926.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.affine import minus_taken_in
from solver.exact.linear_algebra.fields import NotExact, expressions, side_by_side
from solver.symbols import POLYNOMIAL

Edge = tuple[str, str, sp.Expr]
MOST_LOOPS = 60
MOST_PRODUCTS = 400
"""More paths or loops, and more products of loops, are not listed."""


@dataclass(frozen=True)
class Route:
    """A way along branches, of a path from the input to the output, of a loop back to its first node; its gain."""

    nodes: tuple[str, ...]
    gains: tuple[sp.Expr, ...]

    @property
    def gain(self) -> sp.Expr:
        """The product of the gains."""
        return in_lowest(sp.Mul(*self.gains))

    def touches(self, other: Route) -> bool:
        """Whether the two have a node in common."""
        return bool(set(self.nodes) & set(other.nodes))


@dataclass(frozen=True)
class Mason:
    """Forward paths and loops; `apart` are the sets of two, three, … loops (by number from 0) that do not touch.

    `determinant` is Δ; of each path `cofactors` has the Δₖ, `left` the sets of loops that do not touch it; `transfer`
    is Σ Pₖ Δₖ/Δ, None where Δ is zero.
    """

    paths: tuple[Route, ...]
    loops: tuple[Route, ...]
    apart: tuple[tuple[int, ...], ...]
    determinant: sp.Expr
    cofactors: tuple[sp.Expr, ...]
    left: tuple[tuple[tuple[int, ...], ...], ...]
    transfer: sp.Expr | None


@dataclass(frozen=True)
class Removed:
    """A node that is eliminated: its branches in, its own loop, its branches out, the branches before and after.

    Of each pair of a branch in and one out `changed` has source, target, the gain before (0 without a branch), the two
    gains that meet at the node, and the gain afterwards.
    """

    node: str
    into: tuple[tuple[str, sp.Expr], ...]
    own: sp.Expr
    out: tuple[tuple[str, sp.Expr], ...]
    changed: tuple[tuple[str, str, sp.Expr, sp.Expr, sp.Expr, sp.Expr], ...]
    after: tuple[Edge, ...]


def in_lowest(F: sp.Expr) -> sp.Expr:
    """A rational function in lowest terms; what is a product stays one."""
    factors: tuple[Any, ...] = F.args
    if F.is_Mul and not any((each.is_Pow and each.exp.is_negative) or each.is_Add for each in factors):
        return F
    above, below = sp.fraction(sp.cancel(sp.together(F)))
    return _multiplied_in(sp.factor(above)) / _multiplied_in(sp.factor(below))


def _multiplied_in(product: sp.Expr) -> sp.Expr:
    """A product with its number in the factor that it makes monic: s² + 12s + 20.002 for 0.002 (500s² + …)."""
    number, rest = product.as_coeff_Mul()
    factors = list(sp.Mul.make_args(rest))
    for i, each in enumerate(factors):
        alone = number != 1 and each.is_Add and len(each.free_symbols) == 1 and each.is_polynomial()
        if alone and sp.LC(each, *each.free_symbols) * number == 1:
            return sp.Mul(*factors[:i], sp.expand(number * each), *factors[i + 1 :])
    return product


def merged(edges: Sequence[Edge]) -> tuple[Edge, ...]:
    """The branches with parallel ones added; one that becomes zero is left out."""
    sums: dict[tuple[str, str], sp.Expr] = {}
    for source, target, gain in edges:
        sums[source, target] = sums.get((source, target), sp.S.Zero) + gain
    found = [(source, target, in_lowest(gain)) for (source, target), gain in sums.items()]
    return tuple(each for each in found if each[2] != 0)


def mason(edges: Sequence[Edge], start: str, end: str) -> Mason:
    """Mason's rule for a graph without parallel branches; raises NotExact where there is too much to be listed."""
    paths, loops = tuple(_paths(edges, start, end)), tuple(_loops(edges))
    if len(loops) > MOST_LOOPS or len(paths) > MOST_LOOPS:
        raise NotExact("loops/too_many", paths=len(paths), loops=len(loops))
    apart = tuple(_apart(loops))
    whole = _determinant(loops, ((i,) for i in range(len(loops))), apart)
    left, cofactors = [], []
    for path in paths:
        free = [i for i, loop in enumerate(loops) if not loop.touches(path)]
        sets = tuple(each for each in (*((i,) for i in free), *apart) if set(each) <= set(free))
        left.append(sets)
        cofactors.append(_determinant(loops, (each for each in sets if len(each) == 1), sets))
    total = sum((path.gain * factor for path, factor in zip(paths, cofactors, strict=True)), sp.S.Zero)
    transfer = None if whole == 0 else transfer_form(total / whole)
    return Mason(paths, loops, apart, whole, tuple(cofactors), tuple(left), transfer)


def transfer_form(F: sp.Expr) -> sp.Expr:
    """A rational function in lowest terms, above in factors, below multiplied out, monic where that is shorter.

    A number in the denominator is positive, as the one of Δ = 1 − L₁ − … is.
    """
    above, below = sp.fraction(sp.cancel(sp.together(F)))
    below = sp.expand(below)
    if len(below.free_symbols) == 1:
        p = sp.Poly(below, *below.free_symbols)
        monic = [c / p.LC() for c in p.all_coeffs()]
        if len("".join(map(str, monic[1:]))) < len("".join(map(str, p.all_coeffs()))):
            above, below = above / p.LC(), sp.expand(below / p.LC())
    if below.as_coeff_Add()[0].is_negative and not any(each.name in POLYNOMIAL for each in below.free_symbols):
        above, below = -above, sp.expand(-below)
    found: sp.Expr = minus_taken_in(sp.factor(above)) / below
    return found


def _determinant(loops: Sequence[Route], single: Iterator[tuple[int, ...]], sets: Sequence[tuple[int, ...]]) -> sp.Expr:
    """1 − Σ Lᵢ + Σ Lᵢ Lⱼ − …."""
    chosen = [*single, *(each for each in sets if len(each) > 1)]
    terms = [(-1) ** len(each) * sp.Mul(*(loops[i].gain for i in each)) for each in chosen]
    whole = sp.Add(1, *terms)
    return in_lowest(whole) if any(term.as_numer_denom()[1] != 1 for term in terms) else sp.expand(whole)


def _paths(edges: Sequence[Edge], start: str, end: str) -> Iterator[Route]:
    """Every way from one node to another that meets no node twice."""
    out = _by_source(edges)

    def onward(nodes: tuple[str, ...], gains: tuple[sp.Expr, ...]) -> Iterator[Route]:
        for target, gain in out.get(nodes[-1], []):
            if target == end:
                yield Route((*nodes, target), (*gains, gain))
            elif target not in nodes:
                yield from onward((*nodes, target), (*gains, gain))

    found = []
    for route in onward((start,), ()):
        found.append(route)
        if len(found) > MOST_LOOPS:
            break
    yield from sorted(found, key=lambda route: -len(route.nodes))


def _loops(edges: Sequence[Edge]) -> Iterator[Route]:
    """Every way back to where it began that meets no other node twice, each once, from its first node on."""
    out = _by_source(edges)
    order = list(dict.fromkeys(end for source, target, _ in edges for end in (source, target)))
    count = 0
    for first in order:
        later = set(order[order.index(first) :])
        waiting: list[tuple[tuple[str, ...], tuple[sp.Expr, ...]]] = [((first,), ())]
        while waiting:
            nodes, gains = waiting.pop()
            for target, gain in reversed(out.get(nodes[-1], [])):
                if target == first:
                    count += 1
                    yield Route(nodes, (*gains, gain))
                elif target in later and target not in nodes:
                    waiting.append(((*nodes, target), (*gains, gain)))
            if count > MOST_LOOPS:
                return


def _by_source(edges: Sequence[Edge]) -> dict[str, list[tuple[str, sp.Expr]]]:
    found: dict[str, list[tuple[str, sp.Expr]]] = {}
    for source, target, gain in edges:
        found.setdefault(source, []).append((target, gain))
    return found


def _apart(loops: Sequence[Route]) -> Iterator[tuple[int, ...]]:
    """The sets of two, three, … loops of which no two touch."""
    free = {(i, j) for i, j in combinations(range(len(loops)), 2) if not loops[i].touches(loops[j])}
    sets: list[tuple[int, ...]] = sorted(free)
    count = 0
    while sets:
        count += len(sets)
        if count > MOST_PRODUCTS:
            raise NotExact("loops/too_many_products")
        yield from sets
        sets = [
            (*each, k) for each in sets for k in range(each[-1] + 1, len(loops)) if all((i, k) in free for i in each)
        ]


def node_removed(edges: Sequence[Edge], node: str) -> Removed | None:
    """A graph without parallel branches, without one of its nodes; None where the gain of its own loop is one."""
    own = next((gain for source, target, gain in edges if source == target == node), sp.S.Zero)
    if in_lowest(1 - own) == 0:
        return None
    into = tuple((source, gain) for source, target, gain in edges if target == node != source)
    out = tuple((target, gain) for source, target, gain in edges if source == node != target)
    kept = {(source, target): gain for source, target, gain in edges if node not in (source, target)}
    changed = []
    for source, first in into:
        for target, second in out:
            before = kept.get((source, target), sp.S.Zero)
            after = in_lowest(before + first * second / (1 - own))
            changed.append((source, target, before, first, second, after))
            kept[source, target] = after
    left = tuple((source, target, gain) for (source, target), gain in kept.items() if gain != 0)
    return Removed(node, into, own, out, tuple(changed), left)


def next_node(edges: Sequence[Edge], start: str, end: str) -> str | None:
    """The node whose elimination makes the fewest branches, of those that can go; None where none can or is left."""
    nodes = dict.fromkeys(node for source, target, _ in edges for node in (source, target) if node not in (start, end))
    found = [(each, node) for node in nodes if (each := node_removed(edges, node)) is not None]
    if not found:
        return None
    return min(found, key=lambda pair: (len(pair[0].changed), pair[0].own != 0))[1]


def node_signals(edges: Sequence[Edge], start: str) -> dict[str, sp.Expr] | None:
    """The signals of all nodes for the input 1, by their equations; None where these have no unique solution."""
    names = list(dict.fromkeys(node for source, target, _ in edges for node in (source, target) if node != start))
    M = sp.Matrix(len(names), len(names), lambda i, j: int(i == j))
    b = sp.zeros(len(names), 1)
    for source, target, gain in edges:
        i = names.index(target)
        if source == start:
            b[i] += gain
        else:
            M[i, names.index(source)] -= gain
    matrix, column = side_by_side(M, b)
    if matrix.rank() < len(names):
        return None
    found = expressions(matrix.lu_solve(column))
    return {start: sp.S.One, **{name: in_lowest(value) for name, value in zip(names, found, strict=True)}}


def longest_row(edges: Sequence[Edge], start: str, end: str) -> tuple[str, ...]:
    """The nodes of the longest path, which a drawing puts on a row; of a graph without a path both ends."""
    first = next(iter(_paths(edges, start, end)), None)
    return first.nodes if first is not None else (start, end)
