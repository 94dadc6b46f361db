"""Judges of single answers, one each: what must be zero if the answer is right, from the question's numbers."""

from collections.abc import Callable
from importlib import import_module
from typing import Any

from tests.classroom.corpus.judges.by_hand import by_hand
from tests.classroom.corpus.judges.registry import JUDGES

for _topic in (
    "linear_algebra",
    "motion",
    "stability",
    "structure",
    "representation",
    "design",
    "optimal",
    "modelling",
):
    import_module(f"{__name__}.{_topic}")


def judge_of(task: str, answer: str) -> Callable[..., Any]:
    """The judge of an answer of a task; without one of its own, by the value that the corpus states."""
    return JUDGES.get((task, answer)) or by_hand(answer)


def judge_together(task: str) -> Callable[..., Any]:
    """The judge of all answers of a task that belong together."""
    return import_module(f"{__name__}.representation").TOGETHER[task]
