"""Signal-flow graphs as data for drawing."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class FlowGraph:
    """A signal-flow graph: nodes as LaTeX, branches (from, to, gain) by number of node with gains as LaTeX.

    `row` are the nodes that stand on the main row, from left to right, the input first.
    """

    caption: str
    nodes: tuple[str, ...]
    branches: tuple[tuple[int, int, str], ...]
    row: tuple[int, ...]
    alt: str = ""


__all__ = ["FlowGraph"]
