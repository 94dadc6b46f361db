"""Judges of single answers, one each: what must be zero if the answer is right, from the question's numbers."""

from collections.abc import Callable
from importlib import import_module
from typing import Any

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
    """The judge of an answer of a task."""
    return JUDGES[task, answer]


def judge_together(task: str) -> Callable[..., Any]:
    """The judge of all answers of a task that belong together."""
    return import_module(f"{__name__}.representation").TOGETHER[task]
