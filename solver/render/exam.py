"""A paper or a key of an exam as a page, as LaTeX and as typst: its cover, and its questions as those of pages."""

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


def exam_typst(exam: ExamDocument) -> str:
    """Return typst of an exam; `typst/exam.typ.jinja` is its layout."""
    from solver.render.typst_document import rendered_typst  # noqa: PLC0415 - each format imports its own libraries

    return rendered_typst("exam.typ.jinja", exam.presentation.templates, exam.messages, exam.title, exam=exam)


def exam_pdf(exam: ExamDocument) -> bytes:
    """Return the PDF of an exam by the engine that it asks for; raises PdfUnavailable."""
    from solver.render import pdf, typst_document  # noqa: PLC0415 - as above

    if pdf.chosen(exam.presentation.pdf_engine) == pdf.TEX:
        return pdf.pdf_of(exam_latex(exam), files=exam_images(exam))
    beside = [typst_document.files_beside(each.document) for each in exam.questions]
    images = {name: content for files in beside for name, content in files.items()}
    return pdf.pdf_by_typst(exam_typst(exam), files=images)


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
