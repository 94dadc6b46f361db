"""Reading the text of a file that a stranger named: whatever is wrong with it is said in words."""

from __future__ import annotations

import codecs
import re
import stat
from pathlib import Path

from solver.problem.source import Diagnostic, InputError, Source, did_you_mean
from solver.problem.yaml_tree import MAX_BYTES

_CONTROL = re.compile(rb"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f\x81\x8d\x8f\x90\x9d]")
"""Bytes that stand in no text of Windows-1252."""


def load(path: str | Path, *, legacy: bool = False) -> Source:
    """Return the text of a regular file of at most 256 KB in UTF-8; raises InputError for anything else.

    With `legacy` it may be in UTF-16 with its mark, or in Windows-1252, as editors of Windows save it.
    """
    name = str(path)
    try:
        return Source(name, _decoded(name, _content(Path(path), name), legacy=legacy))
    except FileNotFoundError:
        similar = _similar(Path(path))
        raise _refused(name, "there is no such file", similar) from None
    except PermissionError:
        raise _refused(name, "no permission to read it") from None
    except (OSError, ValueError) as error:  # ValueError: a NUL in the path
        reason = getattr(error, "strerror", None) or "its name is not valid"
        raise _refused(name, f"it cannot be read: {reason}") from None


def _content(path: Path, name: str) -> bytes:
    """Read the bytes of a regular file; a pipe or device is never opened, since that may block."""
    status = path.stat()
    if stat.S_ISDIR(status.st_mode):
        raise _refused(name, "it is a folder, not a file")
    if not stat.S_ISREG(status.st_mode):
        raise _refused(name, "it is not a regular file")
    if status.st_size > MAX_BYTES:
        raise _too_large(name)
    with path.open("rb") as file:
        content = file.read(MAX_BYTES + 1)
    if len(content) > MAX_BYTES:  # it grew, or its size is not told, as in /proc
        raise _too_large(name)
    return content


def _decoded(name: str, content: bytes, *, legacy: bool) -> str:
    marked = legacy and content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    try:
        return content.decode("utf-16" if marked else "utf-8-sig")
    except UnicodeDecodeError as error:
        if legacy and not marked and not _CONTROL.search(content):
            return content.decode("cp1252")
        before = content[: error.start].decode("utf-8", "replace").removeprefix("\ufeff")
        line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
        message = f"it is not a text in UTF-8 (byte {content[error.start]:#04x})"
        source = Source(name, content.decode("utf-8", "replace").removeprefix("\ufeff"))
        raise InputError(source, [Diagnostic(message, line, column, note="save the file as UTF-8")]) from None


def _similar(path: Path) -> str:
    """Return a file of the same folder with a similar name, or ""."""
    try:
        names = [each.name for each, _ in zip(path.parent.iterdir(), range(2000), strict=False)]
    except OSError:
        return ""
    found = did_you_mean(path.name, names)
    return str(path.parent / found) if found else ""


def _too_large(name: str) -> InputError:
    return _refused(name, f"the file is larger than {MAX_BYTES // 1024} KB")


def _refused(name: str, message: str, suggestion: str = "") -> InputError:
    return InputError(Source(name, ""), [Diagnostic(message, suggestion=suggestion)])
