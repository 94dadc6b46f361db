"""Figures drawn from their data, and imported only by a page that has one."""

from __future__ import annotations

from solver.derivation.figures import Diagram, Figure, Plot
from solver.figures import diagrams, plot_svg, plot_tikz


def svg(figure: Figure) -> str:
    """Return a figure as an SVG document, the same bytes for the same data."""
    return plot_svg.drawn(figure) if isinstance(figure, Plot) else diagrams.svg(figure)


def tikz(figure: Figure) -> str:
    r"""Return a figure as a tikzpicture (packages tikz and pgfplots)."""
    return plot_tikz.drawn(figure) if isinstance(figure, Plot) else diagrams.tikz(figure)


__all__ = ["Diagram", "Figure", "Plot", "svg", "tikz"]
