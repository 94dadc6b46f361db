"""The drawing of a signal-flow graph."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.derivation.flow_figures import FlowGraph
from solver.lazy import exact
from solver.systems.signal_flow import node_symbol
from solver.words import formula

if TYPE_CHECKING:
    from sympy import Expr

LONGEST = 90
"""A graph with longer gains (as LaTeX) is not drawn."""
MOST_NODES = 12


def drawn(
    caption: str, edges: Sequence[tuple[str, str, Expr]], start: str, end: str, row: Sequence[str] = ()
) -> tuple[FlowGraph, ...]:
    """Return the drawing; nodes of `row` that are still there keep their order. Nothing where it would be illegible."""
    names = list(dict.fromkeys([start, *(node for source, target, _ in edges for node in (source, target)), end]))
    gains = [formula(gain) for _, _, gain in edges]
    if len(names) > MOST_NODES or any(len(gain) > LONGEST for gain in gains):
        return ()
    kept = tuple(name for name in row if name in names) or exact.longest_row(edges, start, end)
    branches = tuple(
        (names.index(source), names.index(target), gain) for (source, target, _), gain in zip(edges, gains, strict=True)
    )
    nodes = tuple(formula(node_symbol(name)) for name in names)
    return (FlowGraph(caption, nodes, branches, tuple(map(names.index, kept))),)
