"""Where everything in a diagram stands."""

from __future__ import annotations

from solver.derivation.figures import Chains, Diagram, Parts
from solver.derivation.flow_figures import FlowGraph
from solver.figures import decompositions, flow_graphs, realizations
from solver.figures.layout import Layout
from solver.figures.layouts import LAYOUTS
from solver.figures.matrices import grown


def layout_of(diagram: Diagram | Chains | Parts | FlowGraph) -> Layout:
    """Return the layout of a diagram."""
    if isinstance(diagram, Chains):
        return realizations.layout_of(diagram)
    if isinstance(diagram, Parts):
        return decompositions.layout_of(diagram)
    if isinstance(diagram, FlowGraph):
        return flow_graphs.layout_of(diagram)
    return grown(LAYOUTS[diagram.name](diagram.labels))
