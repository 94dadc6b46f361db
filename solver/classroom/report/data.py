"""A marking as data."""

from __future__ import annotations

import json
from typing import Any

from solver.classroom.report.hundredths import in_hundredths
from solver.classroom.report.words import number
from solver.classroom.verdicts import AnswerVerdict, Marking, PartVerdict
from solver.render.plain import sympy_text


def as_json(marking: Marking) -> str:
    """Return the marking as JSON text."""
    return json.dumps(as_data(marking), ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def as_data(marking: Marking) -> dict[str, Any]:
    """Return the marking as dictionaries, lists, texts and numbers."""
    marking = in_hundredths(marking)
    head = {"student": marking.student} if marking.student else {}
    totals = {"marks": number(marking.marks), "out_of": number(marking.out_of)}
    parts = [_part_data(part) for part in marking.parts]
    data: dict[str, Any] = {"version": 1, **head, **totals, "parts": parts}
    data |= {"remarks": list(marking.remarks)} if marking.remarks else {}
    return data | {"needs_review": marking.needs_review} | _comment(marking)


def _part_data(part: PartVerdict) -> dict[str, Any]:
    data: dict[str, Any] = {
        "id": part.id,
        "task": part.task,
        "answers": {name: _answer_data(verdict) for name, verdict in part.answers.items()},
        "marks": number(part.marks),
        "out_of": number(part.out_of),
    }
    data |= {"note": part.note} if part.note else {}
    return data | ({"not_submitted": list(part.missing)} if part.missing else {}) | _comment(part)


def _comment(of: Marking | PartVerdict | AnswerVerdict) -> dict[str, str]:
    """What the instructor says of it."""
    return {"comment": of.comment} if of.comment else {}


def _answer_data(answer: AnswerVerdict) -> dict[str, Any]:
    data: dict[str, Any] = {"verdict": str(answer.verdict)}
    for key, text in (("reason", answer.reason), ("note", answer.note)):
        data |= {key: str(text)} if text else {}
    data |= {"mistake": answer.mistake} if answer.mistake else {}
    data |= {"follows": True} if answer.follows else {}
    data |= {"marks": number(answer.marks), "out_of": number(answer.out_of)} if answer.out_of else {}
    data |= {"by": "instructor"} if answer.by_instructor else {}
    data |= {"typed": answer.typed} if answer.typed else {}
    data |= {"read": _shown(answer.value)} if answer.value is not None else {}
    return data | ({"entries": answer.entries} if isinstance(answer.entries, list) else {}) | _comment(answer)


def _shown(value: Any) -> str:
    return str(value) if isinstance(value, bool | str) else sympy_text(value)
