"""Exams in Python: `solver.exam("exam.yaml")` makes papers and keys, `solver.exam_bank` the bank of a learning system.

>>> import solver
>>> papers = solver.exam("exam.yaml", detail="full", jobs=2)
>>> papers.variants[0].label, papers.values["1"]["1.a"]
>>> papers.write("build")
>>> Path("exam-moodle.xml").write_bytes(solver.exam_bank("exam.yaml").content("moodle"))
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any

from solver.api import source_of
from solver.classroom.reading.files import is_filled
from solver.document.model import Presentation, in_a_frame
from solver.executors import Processes
from solver.limits import Limits
from solver.papers.exam.drawing import Drawn, Means, drawn, to_be_made
from solver.papers.exam.making import ANSWERS, PAPERS, answer_file, files_of, variants_table
from solver.papers.exam.model import Exam, Variant
from solver.papers.exam.reading import read_exam
from solver.papers.export.formats import EXPORTS
from solver.papers.export.making import for_bank, quiz_of
from solver.papers.export.quiz import Quiz
from solver.papers.export.summary import counted, told
from solver.papers.search import MOST_DRAWS
from solver.problem.source import Diagnostic, InputError
from solver.progress import Tell, Watch, shown

Given = str | Path | Mapping[str, Any]
"""A file by its path, its text, or a mapping with its keys."""


@dataclass(frozen=True)
class Papers:
    """The papers and keys of an exam, all verified: `made`, by their paths. In a notebook it shows the first paper."""

    exam: Exam
    made: Mapping[str, bytes]
    questions: Sequence[Sequence[Drawn]] = field(repr=False)
    """For each variant what was drawn for its questions."""

    @property
    def variants(self) -> list[Variant]:
        """Who has a paper: number, label and student."""
        return self.exam.variants

    @property
    def values(self) -> dict[str, dict[str, str]]:
        """The values drawn by the label of the variant, then by question and name: `values["1"]["2.a"]`."""
        found = dict[str, dict[str, str]]()
        for variant, of_variant in zip(self.variants, self.questions, strict=True):
            named = ((each.question.number, *value) for each in of_variant for value in each.values.items())
            found[variant.label] = {f"{number}.{name}": text for number, name, text in named}
        return found

    def files(self, folder: str | Path | None = None) -> dict[str, bytes]:
        """Return all files by their paths: papers, keys, answer files to fill in and `variants.csv`.

        Answer files name the exam as it is found from below the `folder`; without one they name the variant alone.
        """
        named, file = "", Path(self.exam.source.name)
        if folder is not None and not self.exam.source.name.startswith("<"):
            named = Path(os.path.relpath(file.resolve(), (Path(folder) / ANSWERS).resolve())).as_posix()
        sheets = {
            f"{ANSWERS}/answers-{variant.label}.yaml": answer_file(self.exam, named, variant, of_variant).encode()
            for variant, of_variant in zip(self.variants, self.questions, strict=True)
        }
        return {**self.made, **sheets, "variants.csv": variants_table(self.exam, self.questions).encode()}

    def write(self, folder: str | Path) -> list[Path]:
        """Write the files into a folder and return them, but no answer file that holds answers: it stays."""
        written = []
        for name, content in self.files(folder).items():
            path = Path(folder) / name
            if name.startswith(f"{ANSWERS}/") and is_filled(path):
                continue
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
            written.append(path)
        return written

    def _repr_html_(self) -> str | None:
        """The first paper in a frame of its own."""
        page = self.made.get(f"{PAPERS}/paper-{self.variants[0].label}.html")
        return None if page is None else in_a_frame(page.decode(), self.exam.title)

    def __repr__(self) -> str:
        return f"<exam {self.exam.title!r}: {len(self.variants)} paper{'s' * (len(self.variants) > 1)}, all verified>"


def exam(  # noqa: PLR0913 - all but the first have names
    exam: Given,
    *,
    formats: Sequence[str] = ("html",),
    detail: str = "key",
    space: float | None = None,
    draws: int = MOST_DRAWS,
    jobs: int = 1,
    templates: str | Path | None = None,
    language: str | None = None,
    notation: str | None = None,
    pdf_engine: str | None = None,
    progress: Watch = None,
    **limits: Any,
) -> Papers:
    """Return the papers of an exam and their keys: the same bytes that `solve exam` writes.

    `formats` are "html", "pdf" and "latex"; `detail` is that of the keys; `space` leaves so many millimetres for each
    mark. At most so many `draws` are made for a family; `jobs` processes work, within the limits `seconds` and
    `megabytes` for each part. Raises `solver.problem.source.InputError`, with the places, where the exam or a file that
    it names is at fault, a question is not verified, or a family has too few members; `PaperError` where a page cannot
    be made, `solver.render.pdf.PdfUnavailable` where nothing is installed that makes a PDF.
    """
    from solver.render import pdf  # noqa: PLC0415 - nor is it for most

    if unknown := [each for each in formats if each not in FORMATS]:
        raise ValueError(f"no format {unknown[0]!r}; there are {', '.join(FORMATS)}")
    if "pdf" in formats:
        pdf.chosen(pdf_engine)
    read = read_exam(source_of(exam))
    told = _presentation(detail, templates, language=language, notation=notation, pdf_engine=pdf_engine)
    with Processes(jobs) as executor, shown(progress) as tell:
        blank = None if space is None else Fraction(str(space))
        means = Means(told, Limits(**limits), executor, draws, blank)
        questions = drawn(read, means, partial(_solving, tell, to_be_made(read)))
        made = dict[str, bytes]()
        for number, files in enumerate(files_of(read, questions, formats, means)):
            tell(number, len(questions), "writing")
            if files.fault:
                raise PaperError(f"{files.variant.label}: cannot make the paper: {files.fault}")
            made |= files.contents
    return Papers(read, made, questions)


FORMATS = ("html", "pdf", "latex")


class PaperError(Exception):
    """A paper cannot be made of what was solved: a template is wrong, or TeX is."""


@dataclass(frozen=True)
class ExamBank:
    """The questions of all variants of an exam, for learning systems."""

    quiz: Quiz
    left_out: tuple[str, ...] = ()
    """Parts that have no solution."""

    @property
    def essays(self) -> list[str]:
        """The parts that a system cannot mark, and why."""
        return [line.removeprefix("essay: ") for line in told(self.quiz)]

    def content(self, system: str) -> bytes:
        """Return the file that a system imports: "moodle" (XML), "qti" (2.1, a zip) or "canvas" (QTI 1.2, a zip)."""
        if system not in EXPORTS:
            raise ValueError(f"no system {system!r}; there are {', '.join(EXPORTS)}")
        return EXPORTS[system].write(self.quiz)

    def __repr__(self) -> str:
        return f"<bank of {self.quiz.title!r}: {counted(self.quiz)}, all verified>"


def exam_bank(
    exam: Given,
    *,
    detail: str = "full",
    draws: int = MOST_DRAWS,
    jobs: int = 1,
    templates: str | Path | None = None,
    language: str | None = None,
    notation: str | None = None,
    progress: Watch = None,
    **limits: Any,
) -> ExamBank:
    """Return the questions of an exam as `solve exam --export` writes them; `detail` is that of the feedback.

    The arguments and errors are those of `exam`.
    """
    read = read_exam(source_of(exam))
    told = _presentation(detail, templates, language=language, notation=notation)
    with Processes(jobs) as executor, shown(progress) as tell:
        means = for_bank(Means(told, Limits(**limits), executor, draws))
        questions = drawn(read, means, partial(_solving, tell, to_be_made(read)))
        tell(len(questions), len(questions), "writing")
        bank = quiz_of(read, questions, means)
    if bank.faults:
        raise InputError(read.source, [Diagnostic(each) for each in bank.faults])
    return ExamBank(bank.quiz, bank.left_out)


def _presentation(detail: str, templates: str | Path | None, **told: Any) -> Presentation:
    return Presentation(detail, Path(templates).resolve() if templates else None, **told)


def _solving(tell: Tell, total: int, draws: int, done: int) -> None:
    tell(done, total, f"{draws} draws" if draws else "solving")


__all__ = ["ExamBank", "Given", "PaperError", "Papers", "exam", "exam_bank"]
