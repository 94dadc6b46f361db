"""From a figure to its numbers: what crosses from the process that solves to the one that draws."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from solver.derivation.figures import (
    Chains,
    Drawing,
    DrawnPanels,
    Figure,
    Motion,
    Panels,
    Parts,
    Plane,
    Plot,
    Schematic,
)
from solver.derivation.flow_figures import FlowGraph
from solver.derivation.frequency_figures import BodeDiagram, NyquistDiagram
from solver.derivation.mechanisms import Mechanism
from solver.derivation.parameter_figures import Locus, ParameterRegion
from solver.derivation.patch_figures import PatchDiagram
from solver.figures import alternatives
from solver.figures.bode import bode_of
from solver.figures.laid_out import layout_of
from solver.figures.loci import of_locus, on_locus
from solver.figures.motions import moved
from solver.figures.nyquist import nyquist_of
from solver.figures.parameter_regions import of_parameters, on_parameters
from solver.figures.planes import on_plane
from solver.figures.sampling import sampled
from solver.figures.told_frequencies import told_bode, told_nyquist
from solver.figures.told_mechanisms import of_mechanism
from solver.figures.told_patches import of_patches

Say = Callable[[str], str]

DRAWN: dict[type, tuple[Callable[[Any, Say], Any], Callable[[Any, Say], str]]] = {
    Plane: (on_plane, alternatives.of_plane),
    Locus: (lambda figure, _: on_locus(figure), of_locus),
    BodeDiagram: (lambda figure, _: bode_of(figure), told_bode),
    NyquistDiagram: (lambda figure, _: nyquist_of(figure), told_nyquist),
}
"""Who draws figures as plots, and who tells what is seen in them."""

TOLD: dict[type, Callable[[Any, Say], str]] = {
    Schematic: alternatives.of_schematic,
    Parts: alternatives.of_parts,
    Mechanism: of_mechanism,
    FlowGraph: alternatives.of_flow_graph,
    PatchDiagram: of_patches,
}
"""Who tells what is seen in figures that are drawn from their data as they are."""


def drawing_of(figure: Figure, say: Say = str) -> Drawing:
    """Return a figure without expressions, with what is seen in it in words; `say` words a phrase."""
    if isinstance(figure, Plot):
        plot = sampled(figure)
        return replace(plot, alt=alternatives.of_plot(plot, say))
    if isinstance(figure, Panels | Motion):
        panels = (
            moved(figure)
            if isinstance(figure, Motion)
            else DrawnPanels(figure.caption, tuple(map(sampled, figure.plots)))
        )
        return replace(panels, alt=" ".join(alternatives.of_plot(plot, say) for plot in panels.plots))
    if type(figure) in DRAWN:
        drawn, told = DRAWN[type(figure)]
        found: Drawing = replace(drawn(figure, say), alt=told(figure, say))
        return found
    if isinstance(figure, ParameterRegion):
        return replace(on_parameters(figure), alt=of_parameters(figure, say))
    if isinstance(figure, Schematic | Parts | Mechanism | FlowGraph | PatchDiagram):
        return replace(figure, alt=TOLD[type(figure)](figure, say))
    chains = alternatives.of_chains(figure, say) if isinstance(figure, Chains) else ""
    rest: Any = figure
    return replace(rest, alt=f"{chains} ".lstrip() + alternatives.of_diagram(layout_of(rest), say))


__all__ = ["drawing_of"]
