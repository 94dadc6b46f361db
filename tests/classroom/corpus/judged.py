"""Whether what is meant is right: some choice of its decimals leaves nothing of what must be zero."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from scipy.optimize import least_squares

from tests.classroom.corpus.judges import judge_of, judge_together
from tests.classroom.corpus.meanings import ImpossibleError, Meaning, box
from tests.hunt.asked import Point, Question, points

EXACT, FITTED = 1e-8, 1e-6
"""What may be left of a residual: without decimals, and after their choice."""


def is_right(question: Question, answer: str, raw: Any) -> bool:
    """Whether a value meets the defining property of the answer, at points of the question's letters."""
    judge = judge_of(question.task, answer)
    return all(_right_at(point, {answer: raw}, lambda of, v: judge(of, v[answer])) for point in points(question, 2))


def right_together(question: Question, raws: Mapping[str, Any]) -> bool:
    """Whether values that belong together meet the property of the task."""
    return all(_right_at(point, raws, judge_together(question.task)) for point in points(question, 2))


def _right_at(point: Point, raws: Mapping[str, Any], judge: Callable[..., Any]) -> bool:
    boxes = [box(raw) for raw in raws.values()]
    written, halves = (np.concatenate(each) for each in zip(*boxes, strict=True))
    ends = np.cumsum([0, *(len(each) for each, _ in boxes)])
    letters = {str(name): complex(value) for name, value in point.values.items()}

    def left(decimals: np.ndarray) -> np.ndarray:
        chosen = {
            name: Meaning(raw, decimals[a:b], letters)
            for (name, raw), a, b in zip(raws.items(), ends, ends[1:], strict=False)
        }
        residual = judge(point, chosen)
        pieces = residual if isinstance(residual, list) else [residual]
        value = np.concatenate([np.ravel(np.asarray(each, dtype=complex)) for each in pieces])
        return np.concatenate([value.real, value.imag])

    try:
        first = left(written)
        if np.max(np.abs(first), initial=0.0) <= EXACT:
            return True
        if not len(written) or not np.all(np.isfinite(first)):
            return False
        margin = halves * (1 + 1e-9)
        found = least_squares(
            lambda x: left(written + x * margin), np.zeros(len(written)), bounds=(-1, 1), xtol=1e-15, ftol=1e-15,
            gtol=1e-15,
        )  # fmt: skip
        return bool(np.max(np.abs(found.fun)) <= FITTED)
    except (ImpossibleError, np.linalg.LinAlgError):
        return False
