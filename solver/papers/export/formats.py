"""The exports by their names on the command line."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from solver.papers.export.quiz import Quiz


@dataclass(frozen=True, slots=True)
class Export:
    """What the name of a file ends in, behind that of the exam, and what writes it."""

    suffix: str
    write: Callable[[Quiz], bytes]


def _moodle(quiz: Quiz) -> bytes:
    from solver.papers.export.moodle import moodle_xml  # noqa: PLC0415 - who wants one format needs no other

    return moodle_xml(quiz)


def _qti(quiz: Quiz) -> bytes:
    from solver.papers.export.qti import qti_package  # noqa: PLC0415 - as above

    return qti_package(quiz)


def _canvas(quiz: Quiz) -> bytes:
    from solver.papers.export.canvas import canvas_package  # noqa: PLC0415 - as above

    return canvas_package(quiz)


EXPORTS: Mapping[str, Export] = {
    "moodle": Export("-moodle.xml", _moodle),
    "qti": Export("-qti.zip", _qti),
    "canvas": Export("-canvas.zip", _canvas),
}
"""By the names of the option `--export`."""
