"""Formulas as text: two-dimensional for display (`drawn`), on one line within a sentence (`flat`)."""

from __future__ import annotations

from functools import lru_cache

from solver.formula.reader import MathProblem
from solver.formula.reading import read
from solver.formula.terminal.boxes import Box, text_box
from solver.formula.terminal.drawing import box


def drawn(latex: str) -> list[str]:
    """Return the lines of a formula drawn in two dimensions; the source where it is not of our dialect."""
    return list(_drawn(latex))


@lru_cache(maxsize=64)  # before they are printed it is asked whether they fit
def _drawn(latex: str) -> tuple[str, ...]:
    return tuple(line.rstrip() for line in _box(latex, display=True).lines)


def flat(latex: str) -> str:
    """Return a formula on one line: `a/b`, `[1, 2; 3, 4]`; the source where it is not of our dialect."""
    return _box(latex, display=False).flat.strip()


def _box(latex: str, *, display: bool) -> Box:
    try:
        return box(read(latex), display)
    except MathProblem:
        return text_box(" ".join(latex.split()))
