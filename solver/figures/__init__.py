"""Figures drawn from their data. What draws is imported only by a page that has one."""

from __future__ import annotations

from solver.derivation.figures import Drawing, DrawnPlot


def svg(drawing: Drawing) -> str:
    """Return a figure as an SVG document, the same bytes for the same data."""
    from solver.figures import diagrams, plot_svg  # noqa: PLC0415 - with them comes matplotlib

    return plot_svg.drawn(drawing) if isinstance(drawing, DrawnPlot) else diagrams.svg(drawing)


def tikz(drawing: Drawing) -> str:
    r"""Return a figure as a tikzpicture (packages tikz and pgfplots)."""
    from solver.figures import diagrams, plot_tikz  # noqa: PLC0415 - as above

    return plot_tikz.drawn(drawing) if isinstance(drawing, DrawnPlot) else diagrams.tikz(drawing)


__all__ = ["svg", "tikz"]
