"""The specifications of a step response by the formulas of second order, as a lemma."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import quotient
from solver.stated.transforms import inverse_laplace
from solver.tasks.classical.step_figure import specified_figure
from solver.tasks.classical.step_measures import events_of, level_claims, response_of

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.classical.paths import Path
    from solver.tasks.classical.step_specifications import StepOptions

BANDS = {"2%": 4, "5%": 3}
"""ζω_n times the settling time."""
DISPLAYED = "the formula is displayed with its value, and evaluated there"


@lemma("step_formulas")
def by_second_order(path: Path, options: StepOptions) -> Derivation[Answers]:
    """Each specification by its formula in ζ and ω_n; raises Unsolved where the formulas do not hold."""
    found = _standard(path)
    s, c = path.variable, BANDS[options.settling_band]
    gain = sp.cancel(path.top / found.square)
    standard = gain * found.square / (s**2 + found.twice * s + found.square)
    claims = {"standard": Claim(quotient(*path.shown), standard, "standard form")}
    yield Step("standard", claims=claims, found=found, gain=gain, turn=exact.damped_frequency(found))
    values = {name: _formula(name, found, c) for name in ("rise_time", "peak_time", "overshoot", "settling_time")}
    if options.whole:
        shown = _named(found, values["rise_time"], sp.Integer(0)) | {"late": path.delay}
        yield Step("rise", unclaimed=DISPLAYED, **shown)
    else:
        values["rise_time"] = yield from _rise_of_shares(path, options)
        if values["overshoot"].has(sp.exp) and not path.parameters:  # beside decimals
            values["overshoot"] = sp.N(values["overshoot"], 30)
    yield Step("peak", unclaimed=DISPLAYED, **_named(found, values["peak_time"], path.delay))
    yield Step("overshoot", unclaimed=DISPLAYED, **_named(found, values["overshoot"], sp.Integer(0)))
    yield Step("settling", unclaimed=DISPLAYED, **_named(found, values["settling_time"], path.delay), band=c)
    values |= {name: values[name] + path.delay for name in ("peak_time", "settling_time")}
    answers = Answers(**values, final_value=gain)
    yield _marked(path, answers, options)
    return answers


def _marked(path: Path, answers: Answers, options: StepOptions) -> Step:
    """The response with its specifications, where all is a number."""
    if path.parameters:
        return Step("marked", detail="full", unclaimed="nothing is drawn", drawn=False)
    found, s, t = response_of(path), path.variable, sp.Symbol("t")
    claim = Claim(inverse_laplace(path.top / path.bottom / s, s, t), found.y[0], "the step response")  # type: ignore[index]
    figure = specified_figure(path, found, answers, options, formulas=True)
    return Step("marked", detail="full", claims={"y": claim}, figures=figure, drawn=True)


def _standard(path: Path) -> exact.Damping:
    """ω_n and ζ of a path without zeros and with a conjugate pair of poles in the left half plane."""
    s = path.variable
    listed = sp.Poly(path.bottom, s).all_coeffs()
    if path.top.has(s) or len(listed) != 3 or path.top == 0:
        zeros = sp.degree(path.top, s) if path.top.has(s) else 0
        raise Unsolved("step_specifications/no_formulas", order=len(listed) - 1, zeros=zeros)
    try:
        found = exact.damping_of(listed)
    except exact.NoFrequency:
        raise Unsolved("step_specifications/not_stable_form") from None
    if found.damping in ("critically damped", "overdamped"):
        raise Unsolved("step_specifications/no_oscillation", zeta=found.zeta)
    if found.damping == "undamped" or found.sign in (0, -1):
        raise Unsolved("step_specifications/not_stable_form")
    if not found.damping:
        raise Unsolved("step_specifications/damping_open", zeta=found.zeta)
    return found


def _formula(name: str, found: exact.Damping, band: int) -> Expr:
    """A specification in its shortest exact form."""
    sigma, turn = found.twice / 2, exact.damped_frequency(found)
    assert turn is not None  # noqa: S101 - the poles are a pair
    match name:
        case "rise_time":
            return (sp.pi - sp.acos(found.zeta)) / turn
        case "peak_time":
            return sp.pi / turn if turn.free_symbols else sp.radsimp(sp.pi / turn)
        case "overshoot":
            ratio = sigma / turn
            return sp.exp(-sp.pi * (ratio if ratio.free_symbols else sp.radsimp(ratio)))
    return sp.cancel(band / sigma)


def _named(found: exact.Damping, value: Expr, late: Expr) -> dict[str, Any]:
    """One formula, the numbers put in, and the result."""
    whole = value + late
    return {
        "found": found,
        "value": value,
        "late": late,
        "whole": whole,
        "turn": exact.damped_frequency(found),
        "approximate": _rough(whole),
    }


def _rough(value: Any) -> Any:
    """The value in decimals where its exact form is not seen through at once."""
    return sp.N(value, 30) if not value.free_symbols and not value.is_Rational else None


def _rise_of_shares(path: Path, options: StepOptions) -> Derivation[Expr]:
    """There is no formula for the rise from 10 to 90 %: both times are found from y itself."""
    if path.parameters:
        raise Unsolved("step_specifications/no_rise_formula")
    events = events_of(path, options)
    y, t = response_of(path).y[0], sp.Symbol("t")  # type: ignore[index]  # it has an output
    yield Step("shares", claims=level_claims(y, t, events), events=events, y=y)
    return events.rise.time
