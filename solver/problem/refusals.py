"""Questions that are wrong as the file asks them, told at their places.

Reading a file computes nothing. What a task finds wrong with a question (a singular T, weights that are not definite)
is found by the engine, within limits, before anything is solved; here it becomes an error like any other of the file.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from solver.problem.model import Part, Problem
from solver.problem.nodes import Node, Place
from solver.problem.source import InputError, Source

Refusal = tuple[str, str]
"""The option at fault ("" for the question as a whole) and what is wrong with it, in words."""


def refuse(problem: Problem, refusals: Mapping[str, Sequence[Refusal]]) -> None:
    """Raise InputError with what is wrong with the questions of some parts, by the part's id, if there is anything."""
    found = [
        Node(_place(part, option)).diagnostic(message)
        for part in problem.parts
        for option, message in refusals.get(part.id, ())
    ]
    if found:
        raise InputError(problem.file or Source(problem.name, ""), found)


def _place(part: Part, option: str) -> Place:
    """Where the option stands in the file; the part's task where the option is not written there."""
    return part.places.get(option) or part.places.get("task") or Place()
