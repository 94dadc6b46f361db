"""Figures drawn from their data. What draws is imported only by a page that has one."""

from __future__ import annotations

from solver.derivation.figures import Chains, Diagram, Drawing, DrawnPanels, Parts, Schematic
from solver.derivation.flow_figures import FlowGraph
from solver.derivation.mechanisms import Mechanism
from solver.derivation.patch_figures import PatchDiagram


def svg(drawing: Drawing) -> str:
    """Return a figure as an SVG document, the same bytes for the same data."""
    from solver.figures import diagrams, plot_svg  # noqa: PLC0415 - with them comes matplotlib

    if isinstance(drawing, Diagram | Chains | Parts | FlowGraph):
        return diagrams.svg(drawing)
    if isinstance(drawing, Schematic):
        from solver.figures import schematics  # noqa: PLC0415 - with it comes schemdraw

        return schematics.svg(drawing)
    if isinstance(drawing, Mechanism):
        from solver.figures import mechanisms  # noqa: PLC0415 - only where one is drawn

        return mechanisms.svg(drawing)
    if isinstance(drawing, PatchDiagram):
        from solver.figures import patches  # noqa: PLC0415 - only where one is drawn

        return patches.svg(drawing)
    return plot_svg.drawn_panels(drawing) if isinstance(drawing, DrawnPanels) else plot_svg.drawn(drawing)


def tikz(drawing: Drawing) -> str:
    r"""Return a figure as a tikzpicture (packages tikz, pgfplots and circuitikz)."""
    from solver.figures import diagrams, plot_tikz  # noqa: PLC0415 - as above

    if isinstance(drawing, Diagram | Chains | Parts | FlowGraph):
        return diagrams.tikz(drawing)
    if isinstance(drawing, Schematic):
        from solver.figures import schematics  # noqa: PLC0415 - as above

        return schematics.tikz(drawing)
    if isinstance(drawing, Mechanism):
        from solver.figures import mechanisms  # noqa: PLC0415 - only where one is drawn

        return mechanisms.tikz(drawing)
    if isinstance(drawing, PatchDiagram):
        from solver.figures import patches  # noqa: PLC0415 - as above

        return patches.tikz(drawing)
    return plot_tikz.drawn_panels(drawing) if isinstance(drawing, DrawnPanels) else plot_tikz.drawn(drawing)


__all__ = ["svg", "tikz"]
