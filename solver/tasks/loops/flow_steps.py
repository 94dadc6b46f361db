"""Lemmas: Mason's rule with its paths and loops, and a graph reduced node by node."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.systems.signal_flow import node_symbol
from solver.tasks.loops.flow_figures import drawn
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import SignalFlow

Edges = Sequence[tuple[str, str, "Expr"]]
CAPTION = "The signal-flow graph"


@lemma("flow_steps")
def graph_of(graph: SignalFlow) -> Derivation[Edges]:
    """The graph as it is given, drawn, and its parallel branches added."""
    given = [(each.source, each.target, each.gain) for each in graph.branches]
    edges: Edges = exact.merged(given)
    claims, rows = {}, []
    for source, target, gain in edges:
        parts = [each for a, b, each in given if (a, b) == (source, target)]
        if len(parts) > 1:
            claims[f"{source}_{target}"] = Claim(total(*parts), gain, "parallel branches")
            rows.append((node_symbol(source), node_symbol(target), total(*parts), gain))
    figures = drawn(CAPTION, edges, graph.input, graph.output)
    yield Step("graph", claims=claims, unclaimed="" if claims else "it is what is given", rows=rows, figures=figures,
               r=node_symbol(graph.input), y=node_symbol(graph.output), drawn=bool(figures))  # fmt: skip
    return edges


@lemma("flow_steps")
def by_mason_of(graph: SignalFlow, edges: Edges) -> Derivation[exact.Mason]:
    """Paths, loops, sets of loops that do not touch, Δ, the Δₖ, and Σ Pₖ Δₖ/Δ; raises Unsolved where Δ is zero."""
    found = exact.mason(edges, graph.input, graph.output)
    letters = _letters(graph)
    gains = [loop.gain for loop in found.loops]
    yield Step("paths", claims=_products(found.paths, "path"), rows=_routes(found.paths), **letters)
    if not found.loops:
        yield Step("no_loops", unclaimed="searched; the sets have checks of their own")
    else:
        yield Step("loops", claims=_products(found.loops, "loop"), rows=_routes(found.loops, closed=True), **letters)
        products = [(each, product(*(gains[i] for i in each)), sp.Mul(*(gains[i] for i in each)))
                    for each in found.apart]  # fmt: skip
        yield Step("apart", unclaimed="the nodes of the loops are compared", rows=products, gains=gains,
                   one=len(found.loops) == 1, **letters)  # fmt: skip
    sets = [*((i,) for i in range(len(gains))), *found.apart]
    claim = Claim(_stated_determinant(gains, sets), found.determinant, "determinant of the graph")
    yield Step("determinant", claims={"determinant": claim}, groups=_by_size(sets), gains=gains,
               products=len(found.apart), loops=len(gains), **letters)  # fmt: skip
    if found.transfer is None:
        raise Unsolved("loops/ill_posed_graph")
    claims = {
        f"cofactor{k}": Claim(_stated_determinant(gains, left), value, Phrase("cofactor {k}", k=k))
        for k, (left, value) in enumerate(zip(found.left, found.cofactors, strict=True), 1)
    }
    yield Step(
        "cofactors",
        claims=claims,
        groups=[_by_size(each) for each in found.left],
        gains=gains,
        loops=len(gains),
        **letters,
    )
    paths = [path.gain for path in found.paths]
    terms = [p if d == 1 else product(p, d) for p, d in zip(paths, found.cofactors, strict=True)]
    above = total(*terms) if len(terms) > 1 else terms[0]
    claim = Claim(quotient(above, found.determinant), found.transfer, "Mason's rule")
    yield Step("transfer", claims={"G": claim}, paths=paths, cofactors=found.cofactors,
               determinant=found.determinant, r=node_symbol(graph.input), y=node_symbol(graph.output),
               s=graph.variable, **letters)  # fmt: skip
    return found


def _letters(graph: SignalFlow) -> dict[str, Any]:
    """The letters of paths and loops, none of which stands in a gain."""
    names = {symbol.name for symbol in graph.parameters} | set(graph.nodes)
    taken = {name[0] for name in names}
    return {"P": "p" if "P" in taken else "P", "L": r"\ell" if "L" in taken else "L"}


def _products(routes: Sequence[exact.Route], name: str) -> dict[str, Claim]:
    """The gain of each as a product."""
    return {
        f"{name}{k}": Claim(product(*route.gains) if len(route.gains) > 1 else route.gains[0], route.gain,
                            Phrase("gain of {name} {k}", name=name, k=k))
        for k, route in enumerate(routes, 1)
    }  # fmt: skip


def _routes(routes: Sequence[exact.Route], *, closed: bool = False) -> list[tuple[list[Any], Any]]:
    """The nodes and the gain of each; a loop ends where it begins."""
    return [
        ([node_symbol(node) for node in (*route.nodes, *(route.nodes[:1] if closed else ()))], route.gain)
        for route in routes
    ]


def _by_size(sets: Sequence[tuple[int, ...]]) -> list[list[tuple[int, ...]]]:
    """The sets of one loop, of two, and so on."""
    return [[each for each in sets if len(each) == size] for size in sorted({len(each) for each in sets})]


def _stated_determinant(gains: Sequence[Expr], sets: Sequence[tuple[int, ...]]) -> Any:
    """1 − (L₁ + L₂ + …) + (L₁ L₂ + …) − …."""
    stated: Any = sp.S.One
    for size in sorted({len(each) for each in sets}):
        terms = [product(*(gains[i] for i in each)) if size > 1 else gains[each[0]]
                 for each in sets if len(each) == size]  # fmt: skip
        group = total(*terms) if len(terms) > 1 else terms[0]
        stated = difference(stated, group) if size % 2 else total(stated, group)
    return stated


@lemma("flow_steps")
def by_elimination_of(graph: SignalFlow, edges: Edges) -> Derivation[Expr]:
    """One node after the other put into the equations of the nodes that follow it; raises Unsolved where that ends."""
    start, end = graph.input, graph.output
    signals = exact.node_signals(edges, start)
    if signals is None:
        raise Unsolved("loops/ill_posed_graph")
    named = [(node_symbol(name), value) for name, value in signals.items()]
    r, y = node_symbol(start), node_symbol(end)
    yield Step("equations", unclaimed="each is the sum at a node", signals=named, rows=_equations(edges, start), r=r)
    row = exact.longest_row(edges, start, end)
    while (node := exact.next_node(edges, start, end)) is not None:
        removed = exact.node_removed(edges, node)
        if removed is None:
            break
        edges = removed.after
        yield _eliminated(removed, edges, named, (start, end, row))
    if any(name not in (start, end) for source, target, _ in edges for name in (source, target)):
        raise Unsolved("loops/stuck")
    direct = next((gain for source, target, gain in edges if (source, target) == (start, end)), sp.S.Zero)
    own = next((gain for source, target, gain in edges if source == target == end), sp.S.Zero)
    G: Expr = exact.transfer_form(direct / (1 - own))
    stated = quotient(direct, _less(own)) if own != 0 else direct
    yield Step("last", claims={"G": Claim(stated, G, "the last equation")}, own=own, direct=direct, r=r, y=y,
               s=graph.variable, signals=named)  # fmt: skip
    return G


def _equations(edges: Edges, start: str) -> list[tuple[Any, Any]]:
    """The equation of each node but the input."""
    targets = dict.fromkeys(target for _, target, _ in edges)
    sources = dict.fromkeys(source for source, _, _ in edges)
    names = [name for name in dict.fromkeys([*targets, *sources]) if name != start]
    return [(node_symbol(name), _sum_at(edges, name)) for name in names]


def _sum_at(edges: Edges, node: str) -> Any:
    """What the branches bring to a node."""
    terms = [product(gain, node_symbol(source)) if gain != 1 else node_symbol(source)
             for source, target, gain in edges if target == node]  # fmt: skip
    return total(*terms) if len(terms) > 1 else terms[0] if terms else sp.S.Zero


def _less(own: Expr) -> Any:
    """1 − l, as 1 + … where l is negative."""
    return total(1, -own) if own.could_extract_minus_sign() else difference(1, own)


def _eliminated(
    removed: exact.Removed, edges: Edges, named: Sequence[tuple[Any, Any]], ends: tuple[str, str, Sequence[str]]
) -> Step:
    """The equation of the node, solved for it, and put into the others."""
    start, end, row = ends
    claims, rows = {}, []
    for k, (source, target, before, first, second, after) in enumerate(removed.changed, 1):
        way: Any = product(first, second)
        if removed.own != 0:
            way = quotient(way, _less(removed.own))
        stated = total(before, way) if before != 0 else way
        claims[f"gain{k}"] = Claim(stated, after, "the gain of the branch that is left")
        rows.append((node_symbol(source), node_symbol(target), stated, after))
    brought = [(node_symbol(source), gain) for source, gain in removed.into]
    terms = [product(gain, x) if gain != 1 else x for x, gain in brought]
    solved: Any = total(*terms) if len(terms) > 1 else terms[0] if terms else sp.S.Zero
    if removed.own != 0 and terms:
        solved = quotient(solved, _less(removed.own))
    changed = dict.fromkeys(target for _, target, *_ in removed.changed)
    figures = drawn("The graph without the node", edges, start, end, row)
    return Step(
        "eliminate",
        claims=claims,
        unclaimed="" if claims else "nothing passes the node",
        node=node_symbol(removed.node),
        own=removed.own,
        solved=solved,
        rows=rows,
        equations=[(node_symbol(target), _sum_at(edges, target)) for target in changed],
        signals=named,
        steps=(Step("after", unclaimed="drawn", detail="tutor", figures=figures),) if figures else (),
    )
