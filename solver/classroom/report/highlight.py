"""Wrong entries pointed to inside of a value."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from solver.classroom.verdicts import AnswerVerdict, Verdict
from solver.render.framed import Framed


def highlighted(answer: AnswerVerdict) -> Any:
    """Return the value as it was read, its wrong entries framed where others are right."""
    if answer.verdict is not Verdict.WRONG or not 0 < answer.share < 1:
        return answer.value
    return _framed(answer.value, answer.entries)


def _framed(value: Any, entries: Any) -> Any:
    if isinstance(value, sp.MatrixBase) and isinstance(entries, list) and len(entries) == value.rows:
        rows = [[_framed(value[i, j], entry) for j, entry in enumerate(row)] for i, row in enumerate(entries)]
        return sp.ImmutableMatrix(rows)
    if isinstance(value, list) and isinstance(entries, list):
        return [_framed(*pair) for pair in zip(value, entries, strict=False)]  # what is missing in a list is wrong too
    if isinstance(value, Mapping) and isinstance(entries, Mapping):
        return {name: _framed(each, entries.get(str(name))) for name, each in value.items()}
    return Framed(value) if entries == Verdict.WRONG and isinstance(value, sp.Expr) else value
