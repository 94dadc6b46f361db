"""Judges of answers, one a task: from the question's numbers, by numpy, scipy and python-control."""

from collections.abc import Callable
from importlib import import_module
from typing import Any

TOPICS = ("linear_algebra", "time_response", "representation", "structure", "stability", "design", "optimal")


def of(task: str) -> Callable[[Any, Any], None]:
    """The judge of a task, which stands under its name."""
    modules = (import_module(f"{__name__}.{topic}") for topic in TOPICS)
    return next(getattr(module, task) for module in modules if hasattr(module, task))
