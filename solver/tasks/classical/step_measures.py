"""The specifications of a step response from the response itself, as a lemma."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Given, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, quotient
from solver.stated.calculus import derivative, value_at
from solver.tasks.classical.step_figure import specified_figure
from solver.tasks.time_response.by_transfer_function import output_by_transform
from solver.tasks.time_response.question import Question
from solver.tasks.time_response.response import ResponseOptions

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import TransferFunction
    from solver.tasks.classical.paths import Path
    from solver.tasks.classical.step_specifications import StepOptions


def lowest_of(path: Path) -> TransferFunction:
    """The rational factor in lowest terms."""
    G = path.given
    matrix = sp.ImmutableMatrix([[path.top / path.bottom]])
    pair = path.shown
    return replace(G, matrix=matrix, numerators=((pair[0],),), denominators=((pair[1],),))


def question_of(path: Path) -> Question:
    """The response of the rational factor to a unit step, from rest."""
    options = ResponseOptions(kind="zero_state", input=(sp.Integer(1),))
    return replace(Question.of(Given(lowest_of(path), options)), late=path.delay != 0)


def response_of(path: Path) -> exact.ClosedForm:
    """The response in closed form."""
    return question_of(path).answer


def events_of(path: Path, options: StepOptions) -> exact.StepEvents:
    """What the response of a path with poles shows."""
    return exact.step_events(response_of(path), options.band, whole=options.whole)


@lemma("step_measures")
def measured(path: Path, options: StepOptions) -> Derivation[Answers]:
    """The response, its limit, its turning points, and the times at which it reaches the levels."""
    if not path.bottom.has(path.variable):
        return (yield from _static(path))
    asked = question_of(path)
    yield from output_by_transform(asked, lowest_of(path).matrix)
    found: Any = asked.answer
    y, t, late = found.y[0], asked.time, path.delay
    events = exact.step_events(found, options.band, whole=options.whole)
    value = value_at(quotient(*path.shown), path.variable, sp.Integer(0))
    yield Step("final", claims={"final": Claim(value, events.final, "final value")}, x=path.variable, name=path.name,
               final=events.final)  # fmt: skip
    yield _peak(y, t, events, late)
    yield _rise(y, t, events, whole=options.whole)
    yield _settling(y, t, events, options, late)
    peak = {"peak_time": events.peak.time + late} if events.peak is not None else {}
    overshoot = sp.Integer(0) if events.peak is None else _less_one(events.peak.share)
    answers = Answers(rise_time=_tidied(events.rise.time), **peak, overshoot=overshoot,
                      settling_time=events.settling + late, final_value=events.final)  # fmt: skip
    yield Step("marked", detail="full", unclaimed="a figure",
               figures=specified_figure(path, found, answers, options))  # fmt: skip
    return answers


def _less_one(share: Expr) -> Expr:
    """The overshoot, in decimals where an exponential is in it: by hand it is worked out there."""
    found = sp.expand(share - 1, power_exp=False, log=False)
    return sp.N(found, 30) if found.has(sp.exp) else found


def _tidied(time: Expr) -> Expr:
    """A difference of logarithms with one factor as one logarithm."""
    terms = [term.as_coeff_Mul() for term in sp.Add.make_args(time)]
    logs = [(c, rest) for c, rest in terms if isinstance(rest, sp.log)]
    if len(logs) == len(terms) == 2 and logs[0][0] == -logs[1][0]:
        (c, first), (_, second) = logs if logs[0][0] > 0 else logs[::-1]
        return c * sp.log(sp.radsimp(first.args[0] / second.args[0]))
    return time


@lemma("step_measures")
def _static(path: Path) -> Derivation[Answers]:
    """A constant has its final value at once."""
    gain = sp.cancel(path.top / path.bottom)
    yield Step("static", unclaimed="every input is multiplied at once", gain=gain, delay=path.delay)
    zero = sp.Integer(0)
    return Answers(rise_time=zero, overshoot=zero, settling_time=path.delay, final_value=gain)


def _peak(y: Expr, t: Any, events: exact.StepEvents, late: Expr) -> Step:
    """The largest value above the final one, and where the slope is zero."""
    peak, final = events.peak, events.final
    under = events.under
    below = None if under is None else under.share * final
    if peak is None:
        return Step("no_peak", unclaimed="no value of the response is above its limit", final=final, under=under,
                    reached=events.reached, below=below)  # fmt: skip
    slope = sp.diff(y, t)
    height = sp.expand(peak.share * final, power_exp=False, log=False)
    claims = {"height": Claim(value_at(y, t, peak.time), height, "value at the peak")}
    if peak.time != 0:
        claims["slope"] = Claim(derivative(y, t), slope, "slope of the response")
        claims["zero"] = Claim(value_at(slope, t, peak.time), sp.Integer(0), "slope at the peak")
    overshoot = _less_one(peak.share)
    claims["overshoot"] = Claim(quotient(difference(height, final), final), overshoot, "overshoot")
    return Step("peak", claims=claims, peak=peak, height=height, final=final, overshoot=overshoot, late=late,
                under=under, exact=not peak.time.has(sp.Float), below=below)  # fmt: skip


def level_claims(y: Expr, t: Any, events: exact.StepEvents) -> dict[str, Claim]:
    """That y is at the levels of the rise."""
    rise = events.rise
    pairs = [("begins", rise.begins, rise.low), ("ends", rise.ends, rise.high)]
    return {
        name: Claim(value_at(y, t, time), sp.expand(share * events.final), "level of the rise")
        for name, time, share in pairs
        if time != 0
    }


def _rise(y: Expr, t: Any, events: exact.StepEvents, *, whole: bool) -> Step:
    """When the response first reaches the levels."""
    rise = events.rise
    claims = level_claims(y, t, events)
    return Step(
        "rise",
        claims=claims,
        unclaimed="" if claims else "the response begins there",
        rise=rise,
        final=events.final,
        never=whole and not events.reached,
        percent=rise.low != 0,
        time=_tidied(rise.time),
        exact=not rise.ends.has(sp.Float),
        approximate=_rough(rise.time),
    )


def _rough(time: Expr) -> Any:
    """The value in decimals where its exact form is not seen through at once."""
    return None if time.has(sp.Float) or time.is_Rational else sp.N(time, 30)


def _settling(y: Expr, t: Any, events: exact.StepEvents, options: StepOptions, late: Expr) -> Step:
    """When the response enters the band for the last time."""
    edge, final = events.edge, events.final
    claims = {}
    if edge is not None:
        claims["edge"] = Claim(value_at(y, t, events.settling), sp.expand(edge * final), "edge of the band")
    return Step(
        "settling",
        claims=claims,
        unclaimed="" if claims else "it never leaves the band",
        edge=edge,
        final=final,
        falls=bool(final < 0),
        time=events.settling,
        late=late,
        band=options.settling_band,
        upper=None if edge is None else bool(edge > 1),
        exact=not events.settling.has(sp.Float),
        approximate=_rough(events.settling),
    )
