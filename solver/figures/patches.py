"""Patch diagrams as SVG and as TikZ, from one layout."""

from __future__ import annotations

from solver.derivation.patch_figures import PatchDiagram
from solver.figures import stroke_pictures
from solver.figures.patch_layout import layout_of

LOOK = r"scale=1.15, every node/.append style={font=\small}"


def svg(diagram: PatchDiagram) -> str:
    """Return the diagram as an SVG document, the same bytes for the same program."""
    return stroke_pictures.svg(layout_of(diagram))


def tikz(diagram: PatchDiagram) -> str:
    """Return the diagram as a tikzpicture."""
    return stroke_pictures.tikz(layout_of(diagram), LOOK)
