"""A paper or a key of an exam as a page and as LaTeX: its cover, and its questions as pages of problems have them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.render.latex_document import files_beside, rendered_latex
from solver.render.page import rendered

if TYPE_CHECKING:
    from solver.document.exam import ExamDocument


def exam_page(exam: ExamDocument) -> str:
    """Return the page of an exam, the same bytes for the same document; `html/exam.html.jinja` is its layout."""
    return rendered("exam.html.jinja", exam.presentation.templates, exam.messages, exam=exam)


def exam_latex(exam: ExamDocument) -> str:
    """Return LaTeX of an exam; `latex/exam.tex.jinja` is its layout."""
    return rendered_latex("exam.tex.jinja", exam.presentation.templates, exam.messages, exam.title, exam=exam)


def exam_images(exam: ExamDocument) -> dict[str, bytes]:
    """Return the images that the LaTeX includes, by the names of their files."""
    return {name: content for each in exam.questions for name, content in files_beside(each.document).items()}


def exam_pdf(exam: ExamDocument) -> bytes:
    """Return the PDF of an exam; raises PdfUnavailable."""
    from solver.render.pdf import pdf_of  # noqa: PLC0415 - each format imports its own libraries

    return pdf_of(exam_latex(exam), files=exam_images(exam))


def _nothing(_: ExamDocument) -> Mapping[str, bytes]:
    return {}


@dataclass(frozen=True, slots=True)
class ExamFormat:
    """The ending of a file, what writes it, and the files that must stand beside it."""

    suffix: str
    write: Callable[[ExamDocument], bytes]
    beside: Callable[[ExamDocument], Mapping[str, bytes]] = _nothing


EXAM_FORMATS: Mapping[str, ExamFormat] = {
    "html": ExamFormat(".html", lambda exam: exam_page(exam).encode()),
    "pdf": ExamFormat(".pdf", exam_pdf),
    "latex": ExamFormat(".tex", lambda exam: exam_latex(exam).encode(), exam_images),
}
"""By the names of the option `--format`."""
