"""The figure of a step response at samples with its specifications marked."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation.figures import Curve, Mark, Plot
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from solver.lazy import exact
    from solver.tasks.classical.step_specifications import StepOptions

MOST = 120
"""More samples are not drawn."""


def sampled_figure(found: Any, events: exact.SampledEvents, options: StepOptions) -> tuple[Plot, ...]:
    """Return y at its samples with its final value and the band about it, peak and settling named."""
    k, y, final, band = found.time, found.y[0], events.final, options.band
    last = max(int(events.settling), int(events.rise.ends), 0 if events.peak is None else int(events.peak.time))
    stop = sp.Integer(last + max(4, last // 3))
    if stop > MOST:
        return ()
    level = [(final, r"y_{\infty}"), (final * (1 + band), ""), (final * (1 - band), "")]
    curves = [Curve(y, "y", style="samples"), *(Curve(height + 0 * k, name, style="guide") for height, name in level)]
    marks = []
    if events.peak is not None:
        marks.append(Mark(events.peak.time, sp.N(events.peak.share * final, 15), r"\sym{peak_time}"))
    if events.settling > 0:
        at = sp.N(y.subs(k, events.settling), 15)
        marks.append(Mark(events.settling, sp.re(at), r"\sym{settling_time}"))
    caption = "The samples of the step response with its final value and the band about it"
    return (Plot(caption, "k", "y", k, sp.Integer(0), stop, tuple(curves), tuple(marks)),)
