"""Mistakes in answers of which many are right: undone, the value would be one of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import sympy as sp

from solver.classroom.judging.question import Question
from solver.classroom.submitted import Submitted
from solver.derivation import Slip
from solver.derivation import usual_mistakes as usual


def undone(question: Question, name: str, submitted: Submitted) -> Iterator[tuple[Slip, Submitted]]:
    """Yield the slips that a matrix may hold, each with the value without it; none where one value only is right."""
    declared = question.task.answers[name]
    if not isinstance(submitted.value, sp.MatrixBase) or not declared.is_free(question.given):
        return
    turned = {"columns": usual.WRITTEN_AS_ROWS, "rows": usual.WRITTEN_AS_COLUMNS}.get(declared.vectors)
    yield turned or usual.TRANSPOSED, _of(submitted, lambda M: M.T)
    yield usual.SIGN, _of(submitted, lambda M: -M)
    if 1 in submitted.value.shape:
        yield usual.REVERSED, _of(submitted, _backwards)


def _backwards(M: Any) -> Any:
    return M.extract(list(reversed(range(M.rows))), list(reversed(range(M.cols))))


def _of(submitted: Submitted, change: Callable[[Any], Any]) -> Submitted:
    value, form = (sp.ImmutableMatrix(change(each)) for each in (submitted.value, submitted.form))
    return replace(submitted, value=value, form=form)
