"""Trees drawn as MathML: by browsers that know MathML Core, without script; everything is escaped or of our making."""

from __future__ import annotations

from functools import lru_cache
from html import escape

from solver.formula.mathml.drawing import drawn
from solver.formula.mathml.leaves import Drawing
from solver.formula.reading import MOST, read

__all__ = ["Drawing", "mathml"]


@lru_cache(maxsize=MOST)
def mathml(formula: str, display: bool = False) -> Drawing:
    """Return a `<math>` element and its width in em; raises MathProblem if the LaTeX is not of our dialect."""
    inside = drawn(read(formula))
    block = ' display="block"' if display else ""
    alternative = escape(" ".join(formula.split()))
    return Drawing(f'<math{block} alttext="{alternative}">{inside.markup}</math>', inside.width)
