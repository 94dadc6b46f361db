"""Figures as images with their words, for the page and for typst: drawn once for both."""

from __future__ import annotations

import re
from functools import lru_cache

from solver.derivation.figures import Drawing, DrawnPanels, DrawnPlot
from solver.formula.terminal import flat

IN_TEXT = re.compile(r"\$([^$]*)\$")


def svg_of(data: Drawing) -> str:
    """Return a figure as an SVG document. Plots are dear, and a page at another level of detail has the same ones."""
    return _plotted(data) if isinstance(data, DrawnPlot | DrawnPanels) else _svg(data)


def _svg(data: Drawing) -> str:
    from solver import figures  # noqa: PLC0415 - only a page that has a figure needs matplotlib

    return figures.svg(data)


_plotted = lru_cache(maxsize=64)(_svg)


def words_of(data: Drawing) -> str:
    """Return what is read aloud of a figure: its caption, and what is to be seen."""
    caption = IN_TEXT.sub(lambda found: flat(found[1]), data.caption)
    return " ".join(f"{caption.rstrip('.')}. {data.alt}".split())
