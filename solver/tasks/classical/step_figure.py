"""The figure of a step response with its specifications marked."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation.figures import Curve, Mark, Plot
from solver.lazy import sympy as sp
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.derivation import Answers
    from solver.lazy import exact
    from solver.tasks.classical.paths import Path
    from solver.tasks.classical.step_specifications import StepOptions

MOST_TIMES = 3
"""The settling time is shown where it is not so many times later than all else."""


def specified_figure(
    path: Path, found: exact.ClosedForm, answers: Answers, options: StepOptions, *, formulas: bool = False
) -> tuple[Plot, ...]:
    """Return y with its final value, the band about it, and the times of rise, peak and settling."""
    t, late = sp.Symbol("t"), path.delay
    y: Any = found.y[0] if found.y is not None else sp.Integer(0)
    final, band = answers["final_value"], options.band
    settled = sp.N(answers["settling_time"], 15)
    stop = sp.Rational(str(round(float(settled) * 1.35 or 1.0, 3 - len(str(int(float(settled)))))))
    shown = y if late == 0 else y.xreplace({t: t - late}) * sp.Heaviside(t - late)
    level = [(final, r"y_{\infty}"), (final * (1 + band), ""), (final * (1 - band), "")]
    curves = [Curve(shown, "y"), *(Curve(height + 0 * t, name, style="guide") for height, name in level)]
    marks = []
    if "peak_time" in answers and answers["peak_time"] != 0:
        top = final * (1 + answers["overshoot"])
        curves.append(_upright(answers["peak_time"], top, r"\sym{peak_time}", t, stop))
        marks.append(Mark(answers["peak_time"], top, _overshoot(answers["overshoot"])))
    if options.rise == "0-100" and answers["overshoot"] != 0 and answers["rise_time"] != 0:
        curves.append(_upright(answers["rise_time"] + late, final, r"\sym{rise_time}", t, stop))
    if settled > 0:
        at = shown.subs(t, answers["settling_time"]) if not formulas else final
        height = final if formulas else sp.N(at, 15)
        curves.append(_upright(answers["settling_time"], height, r"\sym{settling_time}", t, stop))
        marks.append(Mark(answers["settling_time"], sp.N(y.subs(t, answers["settling_time"] - late), 15), ""))
    caption = "The step response with its final value, the band about it and what is asked of it"
    return (Plot(caption, "t", "y", t, sp.Integer(0), stop, tuple(curves), tuple(marks)),)


def _upright(time: Any, height: Any, label: str, t: Any, stop: Any) -> Curve:
    """A line from the axis to the response."""
    return Curve(height * (1 - t / stop), label, time + 0 * t, "guide")


def _overshoot(share: Any) -> Any:
    """The overshoot as the name of the peak."""
    return Phrase(r"\sym{{overshoot}} = {percent}\,\%", percent=f"{float(100 * share):.3g}")
