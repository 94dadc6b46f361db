"""A marked answer file with the problem it answers: what `solver.check` returns."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any

from solver.classroom.report.data import as_data, as_json
from solver.classroom.report.sheet import render_sheet
from solver.classroom.report.words import number
from solver.classroom.verdicts import Marking, PartVerdict
from solver.document.model import Document, in_a_frame
from solver.engine import Solution


@dataclass(frozen=True)
class Marked:
    """A marking, and the solution it was made by, which `worked` words. In a notebook it shows itself as the sheet."""

    marking: Marking
    solution: Solution
    worked: Callable[[], Document] = field(compare=False)
    templates: Path | None = None

    @property
    def parts(self) -> dict[str, PartVerdict]:
        """The verdicts by the part's id."""
        return {part.id: part for part in self.marking.parts}

    @property
    def marks(self) -> Fraction:
        """All marks earned."""
        return self.marking.marks

    @property
    def out_of(self) -> Fraction:
        """All marks there are."""
        return self.marking.out_of

    def data(self) -> dict[str, Any]:
        """Return the marking as dictionaries, lists, texts and numbers: what `solve check -f json` prints."""
        return as_data(self.marking)

    def json(self) -> str:
        """Return the marking as JSON."""
        return as_json(self.marking)

    def html(self, *, answers: bool = False, solution: bool = False) -> str:
        """Return the sheet to hand back, with the right `answers`, with the worked `solution` below."""
        return render_sheet(
            self.solution, self.marking, self.worked() if solution else None, self.templates, key=answers
        )

    def _repr_html_(self) -> str:
        """The sheet in a frame of its own."""
        return in_a_frame(self.html(), self.solution.problem.title)

    def __repr__(self) -> str:
        student = f" {self.marking.student!r}" if self.marking.student else ""
        return f"<marked answers{student}: {number(self.marks)} of {number(self.out_of)}>"
