"""The choice among the readings of a value: exactly one that is right counts; otherwise the value is not judged."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from solver.classroom.judging.question import Question
from solver.classroom.submitted import Submitted
from solver.classroom.verdicts import AnswerVerdict, Verdict
from solver.words import Reason

Judge = Callable[[Question, Mapping[str, Submitted]], dict[str, AnswerVerdict]]


def judged_by_readings(
    question: Question, submitted: Mapping[str, Submitted], judge: Judge
) -> dict[str, AnswerVerdict]:
    """Return the verdict of every value; of one with several readings that of the only right one.

    A reading is judged beside the values that have one reading. Where all are right, what was meant does not matter.
    A value that none of them makes right is not judged; the reason says so.
    """
    chosen = {name: each for name, each in submitted.items() if not each.others}
    unclear: dict[str, AnswerVerdict] = {}
    for name, each in submitted.items():
        readings = [replace(each, others=()), *each.others] if each.others else []
        verdicts = [judge(question, {**chosen, name: read})[name].verdict for read in readings]
        right = [read for read, verdict in zip(readings, verdicts, strict=True) if verdict is Verdict.CORRECT]
        if len(right) == 1 or (right and len(right) == len(readings)):
            chosen[name] = right[0]
        elif readings and all(verdict is Verdict.WRONG for verdict in verdicts):
            neither = Reason("marking/no_reading_right", {"readings": [_as_told(read.value) for read in readings]})
            unclear[name] = AnswerVerdict(name, Verdict.NOT_JUDGED, reason=neither)
        elif readings:
            reason = Reason("marking/several_readings", {"readings": [_as_told(read.value) for read in readings]})
            unclear[name] = AnswerVerdict(name, Verdict.NOT_JUDGED, reason=reason)
    found = {**unclear, **judge(question, {name: chosen[name] for name in submitted if name in chosen})}
    return {name: found[name] for name in submitted}


def _as_told(value: Any) -> Any:
    """A value as one object of sympy, which a reason can show."""
    if isinstance(value, Mapping):
        return sp.Dict(value)
    return sp.Tuple(*map(_as_told, value)) if isinstance(value, list | tuple) else value
