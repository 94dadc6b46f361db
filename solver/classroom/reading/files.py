"""Answer files as they lie in a folder, which a stranger has filled."""

from __future__ import annotations

from pathlib import Path

from solver.classroom.reading.answer_file import is_blank, root_of_answers
from solver.problem.files import load
from solver.problem.nodes import MappingNode
from solver.problem.source import Diagnostic, InputError, Source

ENDINGS = (".yaml", ".yml")


def answer_files(folder: Path) -> list[Path]:
    """Return the answer files of a folder, by name; hidden ones are none."""
    inside = [path for path in sorted(folder.iterdir()) if path.suffix.lower() in ENDINGS and path.is_file()]
    return [path for path in inside if not path.name.startswith(".")]


def load_submitted(path: Path) -> Source:
    """Return the text of an answer file; raises InputError. A link that leads out of its folder is not followed.

    What it holds would not be the student's.
    """
    if path.is_symlink() and not path.resolve().is_relative_to(path.parent.resolve()):
        message = "it is a link that leads out of its folder, and is not followed"
        raise InputError(Source(str(path), ""), [Diagnostic(message, note="put the file itself there")])
    return load(path, legacy=True)


def is_filled(path: Path) -> bool:
    """Whether a file holds answers, or what nobody but a person has written: it is not to be overwritten."""
    if not path.exists():
        return False
    try:
        answers = root_of_answers(load(path)).get("answers")
    except InputError:
        return True
    left = [answers] if answers is not None else []
    while left:
        node = left.pop()
        if not isinstance(node, MappingNode):
            if not is_blank(node):
                return True
            continue
        left += [entry.value for entry in node]
    return False
