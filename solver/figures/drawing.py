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
    Locus,
    Motion,
    Panels,
    Parts,
    Plane,
    Plot,
    Schematic,
)
from solver.derivation.mechanisms import Mechanism
from solver.figures import alternatives
from solver.figures.laid_out import layout_of
from solver.figures.loci import of_locus, on_locus
from solver.figures.motions import moved
from solver.figures.planes import on_plane
from solver.figures.sampling import sampled
from solver.figures.told_mechanisms import of_mechanism

TOLD: dict[type, Callable[[Any, Callable[[str], str]], str]] = {
    Schematic: alternatives.of_schematic,
    Parts: alternatives.of_parts,
    Mechanism: of_mechanism,
}
"""Who tells what is seen in figures that are drawn from their data as they are."""


def drawing_of(figure: Figure, say: Callable[[str], str] = str) -> Drawing:
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
    if isinstance(figure, Plane):
        return replace(on_plane(figure, say), alt=alternatives.of_plane(figure, say))
    if isinstance(figure, Locus):
        return replace(on_locus(figure), alt=of_locus(figure, say))
    if isinstance(figure, Schematic | Parts | Mechanism):
        return replace(figure, alt=TOLD[type(figure)](figure, say))
    chains = alternatives.of_chains(figure, say) if isinstance(figure, Chains) else ""
    return replace(figure, alt=f"{chains} ".lstrip() + alternatives.of_diagram(layout_of(figure), say))


__all__ = ["drawing_of"]
