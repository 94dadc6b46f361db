"""Files of another kind than is read: an exam where a problem is expected, and so on, told once and with a way on."""

from __future__ import annotations

from pathlib import PurePath

from solver.problem.nodes import MappingNode
from solver.problem.source import Diagnostic, Source

PROBLEM, EXAM, ANSWERS, CHANGES = "a problem", "an exam", "an answer file", "a file of changes"
MARKS = {PROBLEM: "find", EXAM: "questions", ANSWERS: "answers", CHANGES: "changes"}
"""The key that each file of a kind has."""
ALSO = {PROBLEM: "system"}
"""Another key that a file of a kind is known by where that one is missing."""


def mistaken(source: Source, root: MappingNode, wanted: str) -> Diagnostic | None:
    """Return what to say of a file of another kind than the one wanted; None where it may be of that kind."""
    if MARKS[wanted] in root or ALSO.get(wanted, "") in root:
        return None
    is_called = next((kind for kind, key in MARKS.items() if key in root), None)
    if is_called is None:
        return None
    key = root.entries[MARKS[is_called]].key
    return key.diagnostic(f"this is {is_called}, not {wanted}", note=_way_on(is_called, PurePath(source.name).name))


def _way_on(kind: str, file: str) -> str:
    """What is done with a file of a kind."""
    return {
        PROBLEM: f"`solve {file}` solves it, `solve check {file} ANSWERS` marks answers; an exam has it in `questions`",
        EXAM: f"`solve exam {file} -o build/` writes its papers; `solve check {file} answers/` marks what comes back",
        ANSWERS: f"`solve check PROBLEM {file}` or `solve check EXAM {file}` marks it",
        CHANGES: f"`solve check PROBLEM ANSWERS --override {file}` applies it",
    }[kind]
