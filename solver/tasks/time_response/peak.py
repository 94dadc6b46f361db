"""The peak of an output, as a lemma: the slope, where it is zero, and the value there."""

from __future__ import annotations

from typing import Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import sympy as sp
from solver.stated.calculus import derivative, value_at
from solver.tasks.time_response.question import Question


@lemma("response_peak")
def peak_of(asked: Question) -> Derivation[None]:
    """The peak of y, where it has one: exact where the equation allows it."""
    found: Any = asked.answer
    if found.y_peak is None:
        return
    y = asked.function(found.pieces[0][1].y)[0]
    yield _sample(asked, y) if asked.discrete else _where_the_slope_is_zero(asked, y)


def _where_the_slope_is_zero(asked: Question, y: Any) -> Step:
    """In continuous time the slope is zero at the peak; y and its slope are functions of the time since the delay."""
    t, peak = asked.time, asked.answer.y_peak
    assert peak is not None  # noqa: S101 - asked where there is one
    flat: Any = peak.stationary
    since = sp.expand(peak.time - peak.delay)
    claims = {
        "slope": Claim(derivative(y, t), flat.slope, "slope"),
        "zero": Claim(value_at(flat.slope, t, since), sp.Integer(0), "slope at the peak"),
        "peak": Claim(value_at(y, t, since), peak.value, "value at the peak"),
    }
    if flat.equation is not None:
        left, right = flat.equation
        claims["equation"] = Claim(value_at(left, t, since), right, "equation at the peak")
    return Step(
        "peak",
        claims=claims,
        flat=flat,
        since=since,
        fading=y.has(sp.exp),
        peak=peak,
        y=y,
    )


def _sample(asked: Question, y: Any) -> Step:
    """In discrete time the samples around the peak are smaller."""
    k, peak = asked.time, asked.answer.y_peak
    assert peak is not None  # noqa: S101 - asked where there is one
    at = int(peak.time - peak.delay)
    around = [at - 1, at, at + 1]
    values = [peak.value if i == at else sp.expand(y.subs(k, i)) for i in around]
    claims = {f"y{i}": Claim(value_at(y, k, sp.Integer(i)), value) for i, value in zip(around, values, strict=True)}
    samples = [(sp.Integer(i) + peak.delay, value) for i, value in zip(around, values, strict=True)]
    return Step("peak_sample", claims=claims, samples=samples, peak=peak)
