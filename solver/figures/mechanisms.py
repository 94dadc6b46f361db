"""Mechanical systems as SVG and as TikZ, from one layout."""

from __future__ import annotations

from solver.derivation.mechanisms import Mechanism
from solver.figures import stroke_pictures
from solver.figures.mechanism_layout import layout_of


def svg(mechanism: Mechanism) -> str:
    """Return the system as an SVG document, the same bytes for the same system."""
    return stroke_pictures.svg(layout_of(mechanism))


def tikz(mechanism: Mechanism) -> str:
    """Return the system as a tikzpicture."""
    return stroke_pictures.tikz(layout_of(mechanism))
