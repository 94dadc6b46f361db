"""The figure of a response: the output with what is asked of it, the states, the input, below each other."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation.figures import Curve, Mark, Panels, Plot
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.figures import numbered
from solver.words import Phrase

if TYPE_CHECKING:
    from collections.abc import Iterable

    from solver.tasks.time_response.question import Question

LARGEST = 6
"""Panels with more curves are not read."""


def figure_of(asked: Question) -> Panels | None:
    """Outputs, states and inputs over time; None where symbols other than time are left."""
    found, t = asked.answer, asked.time
    y: Any = found.y
    smooth = y - found.impulse if found.impulse is not None else y
    shown = smooth if asked.transfer is not None else found.x.col_join(smooth)
    if shown.free_symbols - {t}:
        return None
    stop = exact.horizon([each.x for _, each in found.pieces], discrete=asked.discrete)
    if stop is None:
        return None
    stop += max((delay for delay, _ in found.pieces), default=0)
    panels = [_output(asked, smooth, stop)]
    states = found.x.flat() if asked.transfer is None else []
    if states and list(states) != list(smooth):
        panels.append(_plain(asked, "x", states, stop))
    drawable = not any(u.has(sp.DiracDelta) or u.free_symbols - {t} for u in asked.inputs)
    if any(asked.inputs) and drawable:
        panels.append(_plain(asked, "u", asked.inputs, stop))
    kept = tuple(each for each in panels if len(each.curves) <= LARGEST + 3)
    return Panels(CAPTIONS["".join(each.y_label for each in kept)], kept) if kept else None


CAPTIONS = {
    "y": "The output",
    "x": "The states",
    "u": "The input",
    "yx": "The output and the states",
    "yu": "The output and the input",
    "xu": "The states and the input",
    "yxu": "The output, the states and the input",
}


def _plain(asked: Question, letter: str, functions: Iterable[Any], stop: Any) -> Plot:
    """One panel: functions of time under a letter with numbers."""
    every = list(functions)
    style = "samples" if asked.discrete else "line"
    curves = tuple(Curve(f, name, style=style) for f, name in zip(every, numbered(letter, len(every)), strict=True))
    return Plot("", str(asked.time), letter, asked.time, sp.Integer(0), stop, curves)


def _output(asked: Question, y: Any, stop: Any) -> Plot:
    """The output with its final value, its peak and the band in which it settles."""
    found, plot = asked.answer, _plain(asked, "y", y.flat(), stop)
    final = found.y_final[0] if len(y) == 1 and found.y_final is not None else None
    peak = found.y_peak
    guides: list[Curve] = []
    marks: tuple[Mark, ...] = ()
    if final is not None and final != 0:
        guides.append(_level(final, r"y_{\infty}", asked.time))
    if peak is not None:
        begin = peak.value * (1 - asked.time / stop)
        guides += [Curve(begin, r"t_{\text{peak}}", peak.time + 0 * asked.time, "guide")] if not asked.discrete else []
        marks = (Mark(peak.time, peak.value, _name_of_the_peak(asked, peak.value, final)),)
    settles = final if final is not None and not asked.discrete else None
    return Plot(
        "", plot.x_label, plot.y_label, asked.time, plot.start, stop, (*plot.curves, *guides), marks, settles=settles
    )


def _name_of_the_peak(asked: Question, peak: Any, final: Any) -> str:
    """The name of the peak; after a step also by how much it goes over the final value."""
    stepped = asked.x0 is None and len(asked.inputs) == 1 and not asked.inputs[0].free_symbols
    if not stepped or not final or not peak / final > 1:
        return r"y_{\text{peak}}"
    percent = f"{float(100 * (peak / final - 1)):.3g}"
    return Phrase(r"y_{{\text{{peak}}}},\ \sym{{overshoot}} = {percent}\,\%", percent=percent)


def _level(value: Any, label: str, t: Any) -> Curve:
    """A line at the height of a value."""
    return Curve(value + 0 * t, label, style="guide")
