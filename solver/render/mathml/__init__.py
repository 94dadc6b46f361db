r"""MathML of our formulas: escaped, drawn by any browser, or refused.

`latex2mathml.converter.convert` lets markup through (`\text{<svg …>}`) and is not used. The tree it builds from
checked LaTeX is repaired, held against a list of elements and attributes, and written here, everything escaped.
"""

from __future__ import annotations

from functools import lru_cache
from html import escape
from typing import NamedTuple

from solver.render.mathml.shapes import piece
from solver.render.mathml.source import MathError, check_characters

__all__ = ["Formula", "MathError", "formula", "mathml"]


class Formula(NamedTuple):
    """A drawn formula: its markup, and roughly how wide it will be in em."""

    markup: str
    width: float


def mathml(latex: str, display: bool = False) -> str:
    """Return a `<math>` element; raises MathError if the LaTeX is not of our dialect."""
    return formula(latex, display).markup


@lru_cache(maxsize=8192)
def formula(latex: str, display: bool = False) -> Formula:
    """Return the drawn formula; raises MathError if the LaTeX is not of our dialect."""
    check_characters(latex)
    drawn = piece(latex)
    block = ' display="block"' if display else ""
    alternative = escape(" ".join(latex.split()))
    return Formula(f'<math{block} alttext="{alternative}">{drawn.markup}</math>', drawn.width)
