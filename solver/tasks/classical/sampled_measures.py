"""The specifications of a step response at samples, of a discrete system, as a lemma."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient
from solver.stated.calculus import value_at
from solver.tasks.classical.sampled_figure import sampled_figure
from solver.tasks.classical.step_measures import lowest_of, question_of
from solver.tasks.time_response.by_transfer_function import output_by_transform

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.classical.paths import Path
    from solver.tasks.classical.step_specifications import StepOptions

SHORT = 4
"""A number with more digits below is shown as a decimal."""


@lemma("sampled_measures")
def sampled(path: Path, options: StepOptions) -> Derivation[Answers]:
    """The response, its limit, its samples, and those at which it reaches the levels; times are samples times T."""
    T = path.given.sample_time
    period = sp.Integer(1) if T is None else T
    if not path.bottom.has(path.variable):
        gain = sp.cancel(path.top / path.bottom)
        zero = sp.Integer(0)
        yield Step("static", unclaimed="every input is multiplied at once", gain=gain)
        return Answers(rise_time=zero, overshoot=zero, settling_time=zero, final_value=gain)
    asked = question_of(path)
    yield from output_by_transform(asked, lowest_of(path).matrix)
    found: Any = asked.answer
    events = exact.sampled_events(found, options.band, whole=options.whole)
    y, k = found.y[0], asked.time
    value = value_at(quotient(*path.shown), path.variable, sp.Integer(1))
    yield Step("final", claims={"final": Claim(value, events.final, "final value")}, final=events.final)
    yield Step("samples", unclaimed="a table, each sample displayed with its value",
               samples=[(i, _shown(each)) for i, each in enumerate(events.samples)], T=T)  # fmt: skip
    yield _peak(y, k, events, T)
    yield _rise(events, T, whole=options.whole)
    yield _settling(y, k, events, T, options)
    peak = {"peak_time": events.peak.time * period} if events.peak is not None else {}
    overshoot = sp.Integer(0) if events.peak is None else events.peak.share - 1
    answers = Answers(rise_time=events.rise.time * period, **peak, overshoot=overshoot,
                      settling_time=events.settling * period, final_value=events.final)  # fmt: skip
    yield Step("marked", detail="full", unclaimed="a figure", figures=sampled_figure(found, events, options))
    return answers


def _shown(value: Expr) -> Expr:
    """A number as it is shown: a long fraction as a decimal."""
    return sp.N(value, 30) if value.is_Rational and len(str(value.q)) > SHORT else value  # type: ignore[attr-defined]


def _time(k: Expr, T: Expr | None) -> dict[str, Claim]:
    """So many samples in units of time, where the sampling period is known."""
    return {} if T is None else {"time": Claim(product(k, T), k * T, "samples in time")}


def _peak(y: Expr, k: Any, events: exact.SampledEvents, T: Expr | None) -> Step:
    """The largest sample above the final value, and the lowest below zero before the rise."""
    peak, final, under = events.peak, events.final, events.under
    below = None if under is None else (under.time, _shown(under.share * final))
    if peak is None:
        return Step("no_peak", unclaimed="no sample is above the limit", final=final, reached=events.reached,
                    below=below)  # fmt: skip
    height, overshoot = sp.expand(peak.share * final), peak.share - 1
    claims = {
        "height": Claim(value_at(y, k, peak.time), height, "value at the peak"),
        "overshoot": Claim(quotient(difference(height, final), final), overshoot, "overshoot"),
        **_time(peak.time, T),
    }
    return Step("peak", claims=claims, k=peak.time, T=T, height=_shown(height), final=final, below=below,
                overshoot=_shown(overshoot))  # fmt: skip


def _rise(events: exact.SampledEvents, T: Expr | None, *, whole: bool) -> Step:
    """The first samples at the levels, or beyond."""
    rise, final = events.rise, events.final
    levels = [(name, at, sp.expand(share * final))
              for name, at, share in (("10", rise.begins, rise.low), ("90", rise.ends, rise.high))]  # fmt: skip
    return Step(
        "rise",
        claims=_time(rise.time, T),
        unclaimed="" if T is not None else "read off the samples",
        rise=rise,
        levels=levels,
        T=T,
        never=whole and not events.reached,
        percent=rise.low != 0,
        samples={int(i): _shown(y_i) for i, y_i in enumerate(events.samples)},
    )


def _settling(y: Expr, k: Any, events: exact.SampledEvents, T: Expr | None, options: StepOptions) -> Step:
    """The last sample outside the band: from some sample on a bound of the deviation is less than the band."""
    final, outside = events.final, events.outside
    terms = [(c, size, j) for c, size, j in events.bound if size != 0]
    bound = sp.Add(*(c * sp.binomial(k, j - 1).expand(func=True) * size ** (k - j + 1) for c, size, j in terms))
    claims = _time(events.settling, T)
    value: Any = None
    if outside is not None:
        value = sp.expand(outside.share * final)
        claims["outside"] = Claim(value_at(y, k, outside.time), value, "the last sample outside the band")
    return Step(
        "settling",
        claims=claims,
        unclaimed="" if claims else "it never leaves the band",
        T=T,
        k=events.settling,
        final=final,
        outside=None if outside is None else (outside.time, _shown(value)),
        upper=outside is not None and bool(outside.share > 1),
        edges=[_shown(final * (1 - options.band)), _shown(final * (1 + options.band))],
        band=options.settling_band,
        percent=options.band,
        within=events.within,
        bound=bound,
        at_within=sp.N(bound.subs(k, events.within), 30) if terms else sp.Integer(0),
        delayed=len(terms) < len(events.bound),
        multiple=any(j > 1 for *_, j in terms),
    )
