"""The output from one beginning of the input to the next, without step functions, as a lemma."""

from __future__ import annotations

from typing import Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.tasks.time_response.question import Question


@lemma("response_intervals")
def intervals_of(asked: Question) -> Derivation[None]:
    """y case by case, where something of the input begins later and it is known in which order."""
    found: Any = asked.answer
    if found.y is None or len(found.y) != 1 or found.impulse is not None:
        return
    cases = exact.by_intervals(found.y[0], [delay for delay, _ in found.pieces], asked.time, discrete=asked.discrete)
    if cases is None:
        return
    claims = {"y": Claim(found.y[0], cases, "interval by interval")}
    yield Step("intervals", claims=claims, discrete=asked.discrete, count=len(cases.args))
