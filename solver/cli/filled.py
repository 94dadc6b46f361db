"""Files of an exam that a rerun leaves alone: answer files with answers in them, and what belongs to nobody now.

The record of the folder has what each answer file was written for, so that it can be told where that has changed.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from hashlib import sha256
from pathlib import Path
from typing import Any
from unicodedata import normalize

import click

from solver.classroom.reading.files import is_filled
from solver.cli.kept import Record
from solver.papers.exam.drawing import Drawn
from solver.papers.exam.making import ANSWERS, KEYS, PAPERS
from solver.papers.exam.model import Variant
from solver.render.exam import EXAM_FORMATS

SHEET = "asked in "
"""Names of answer files in the record begin so; those of students who left stay there, as their files do."""
SHOWN = 20


def asked_in(variant: Variant, questions: Sequence[Drawn]) -> Mapping[str, Any]:
    """Return what an answer file is written for: the variant, of each question the values and a hash."""
    hashes = {str(each.question.number): sha256(each.text.encode()).hexdigest() for each in questions}
    values = {str(each.question.number): dict(each.values) for each in questions}
    return {"variant": variant.number, "values": values, "texts": hashes}


def keep_asked(record: Record, name: str, asked: Mapping[str, Any]) -> None:
    """Keep in the record what an answer file was written for."""
    if record.told(SHEET + name) != asked:
        record.put(SHEET + name, "", {}, asked)


def changed_since(record: Record, name: str, asked: Mapping[str, Any]) -> str:
    """Return in words what has changed since an answer file was written, "" where nothing has or it is not known."""
    before = record.told(SHEET + name)
    if not before or before == asked:
        return ""
    numbers = _differing(before.get("values"), asked["values"])
    others = [each for each in _differing(before.get("texts"), asked["texts"]) if each not in numbers]
    said = [f"its numbers have changed since (question {', '.join(numbers)})"] if numbers else []
    said += [f"question {', '.join(others)} has changed since"] if others else []
    said += [f"it is variant {asked['variant']} now"] if before.get("variant") != asked["variant"] else []
    return f", but {' and '.join(said)}" if said else ""


def _differing(before: Any, now: Mapping[str, Any]) -> list[str]:
    """Return the questions that are not what they were, those that are new or gone among them."""
    known = before if isinstance(before, dict) else {}
    return [number for number in dict.fromkeys([*now, *known]) if known.get(number) != now.get(number)]


def tell_left_over(folder: Path, labels: Collection[str]) -> None:
    """Name the files of papers that the exam has not now: they are not deleted, and are not to be handed out."""
    known = {normalize("NFC", label) for label in labels}
    endings = {each.suffix for each in EXAM_FORMATS.values()}
    found: list[str] = []
    for below, stem, suffixes in (
        (PAPERS, "paper-", endings),
        (KEYS, "key-", endings),
        (ANSWERS, "answers-", {".yaml"}),
    ):
        inside = sorted(each.name for each in (folder / below).glob(f"{stem}*") if each.is_file())
        for name in inside:
            suffix = next((each for each in suffixes if name.endswith(each)), "")
            if suffix and normalize("NFC", name[len(stem) : -len(suffix)]) not in known:
                found.append(f"{below}/{name}{_with_answers(folder / below / name)}")
    if found:
        more = f" and {len(found) - SHOWN} more" if found[SHOWN:] else ""
        told = ", ".join(found[:SHOWN]) + more
        click.echo(f"left over in {folder}, of nobody who has a paper now: {told}", err=True)


def _with_answers(path: Path) -> str:
    return " (with answers)" if path.parent.name == ANSWERS and is_filled(path) else ""
