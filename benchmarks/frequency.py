"""Margins of loops, exact, beside python-control's in doubles; four diagrams drawn."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

import sympy as sp

from benchmarks.timing import Failure, Row, side_by_side
from solver import exact, figures
from solver.figures.drawing import drawing_of
from solver.tasks.frequency.figures import bode_figure, nyquist_figures

s = sp.Symbol("s")
N, D = 60 * (s + 3), sp.expand(s * (s + 1) * (s + 5) * (s + 20))


def ours() -> Any:
    """Crossovers, which of them decide, and the margins: order 4, roots of degree 4 in ω² certified to 30 digits."""
    return exact.margins_of(exact.on_axis(sp.expand(N), D, s))


def by_control() -> Callable[[], Any]:
    """The margins in doubles."""
    control: Any = import_module("control")  # not a library of ours
    plant = control.tf(*([float(c) for c in sp.Poly(p, s).all_coeffs()] for p in (N, D)))
    return lambda: control.stability_margins(plant)


def four_diagrams() -> Callable[[], Any]:
    """Two Bode diagrams and two of Nyquist, sampled and drawn as SVG."""
    L, M = exact.on_axis(sp.expand(N), D, s), exact.on_axis(sp.Integer(10), sp.expand(s * (s**2 + s + 4)), s)
    made: list[Any] = [
        figure
        for each in (L, M)
        for figure in (*bode_figure("", ("L", each), asymptotes=True), *nyquist_figures("", "", each, []))
    ]
    return lambda: [figures.svg(drawing_of(figure)) for figure in made[:4]]


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table."""
    mine, theirs = side_by_side(ours, by_control())
    yield Row("margins, exact, order 4", mine, "python-control margins, doubles", theirs, None, 20)
    mine, _ = side_by_side(four_diagrams(), lambda: None)
    yield Row("four diagrams of Bode and Nyquist, drawn warm", mine, at_most=250)
