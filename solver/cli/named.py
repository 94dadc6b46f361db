"""The file that an answer file names by `problem` or `exam`, followed only where a stranger may lead.

A student writes the answer file, and an instructor's computer reads what it names. So that must be a problem file by
its name and lie, all links followed, below the folder of the answer file or, where this is below the folder in which
the command was started, below that one. Nothing is read before that is known.
"""

from __future__ import annotations

from pathlib import Path, PurePosixPath, PureWindowsPath

from solver.classroom.reading.answer_file import node_naming
from solver.problem.nodes import ScalarNode
from solver.problem.source import Fault, InputError, Source

ENDINGS = (".yaml", ".yml")
NAMED_ON_THE_COMMAND_LINE = "to follow it all the same, name it on the command line: solve check {what} ANSWERS"


def named_in(source: Source, key: str, file: str) -> str:
    """Return the path that the answer file `file` names by a key, links followed; "" where it names none.

    Raises InputError, at the place of the name, where it is not to be followed.
    """
    node = node_naming(source, key)
    if node is None:
        return ""
    try:
        return _followed(node, key, Path(file).parent)
    except Fault as fault:
        raise InputError(source, fault.diagnostics) from None


def _followed(node: ScalarNode, key: str, folder: Path) -> str:
    """Return where a name leads from a folder; raises Fault where that is not to be looked at."""
    name = node.text.strip()
    shown = repr(name[:100])
    note = NAMED_ON_THE_COMMAND_LINE.format(what=key.upper())
    if not name.lower().endswith(ENDINGS):
        raise node.fault(f"{shown} is not followed: the file of {_a(key)} ends in .yaml", note=note)
    if _is_absolute(name):
        raise node.fault(f"{shown} is not followed: it does not begin at the folder of this file", note=note)
    own, current = folder.resolve(), Path.cwd().resolve()
    try:
        path = (folder / name).resolve()
    except (OSError, RuntimeError):  # links in a circle
        raise node.fault(f"{shown} is not followed: it cannot be found", note=note) from None
    if not any(path.is_relative_to(root) for root in (own, current if own.is_relative_to(current) else own)):
        message = f"{shown} is not followed: it leads out of the folder of the answers and out of the current one"
        raise node.fault(message, note=note)
    return str(path.relative_to(current) if path.is_relative_to(current) else path)


def _is_absolute(name: str) -> bool:
    """Whether a name is a whole path on any system, one of another computer among them."""
    windows = PureWindowsPath(name)
    return PurePosixPath(name).is_absolute() or bool(windows.drive or windows.root)


def _a(key: str) -> str:
    return f"an {key}" if key == "exam" else f"a {key}"
