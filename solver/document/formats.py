"""The formats a document can be written in: one table for the command line, the Python interface and the papers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from solver.document.model import Document


@dataclass(frozen=True, slots=True)
class Format:
    """The ending of a file of this format and what writes it; `write` may raise Jinja's `TemplateError`.

    `beside` gives the files that must stand beside it, by name.
    """

    suffix: str
    write: Callable[[Document], bytes]
    beside: Callable[[Document], Mapping[str, bytes]] = lambda _: {}


def _html(document: Document) -> bytes:
    from solver.render.page import encoded_page  # noqa: PLC0415 - each format imports its own libraries

    return encoded_page(document)


def _latex(document: Document) -> bytes:
    from solver.render.latex_document import latex_document  # noqa: PLC0415 - as above

    return latex_document(document).encode()


def _images(document: Document) -> Mapping[str, bytes]:
    from solver.render.latex_document import files_beside  # noqa: PLC0415 - as above

    return files_beside(document)


def _pdf(document: Document) -> bytes:
    from solver.render import pdf  # noqa: PLC0415 - as above

    if pdf.chosen(document.presentation.pdf_engine) == pdf.TEX:
        return pdf.pdf_of(_latex(document).decode(), files=_images(document))
    from solver.render import typst_document  # noqa: PLC0415 - as above

    return pdf.pdf_by_typst(typst_document.typst_document(document), files=typst_document.files_beside(document))


def _markdown(document: Document) -> bytes:
    from solver.render.markdown import markdown_of  # noqa: PLC0415 - as above

    return markdown_of(document).encode()


def _text(document: Document) -> bytes:
    from solver.render.terminal import text_document  # noqa: PLC0415 - as above

    return text_document(document).encode()


def _json(document: Document) -> bytes:
    from solver.render.data import render_json  # noqa: PLC0415 - as above

    return render_json(document).encode()


FORMATS: Mapping[str, Format] = {
    "html": Format(".html", _html),
    "latex": Format(".tex", _latex, _images),
    "pdf": Format(".pdf", _pdf),
    "md": Format(".md", _markdown),
    "json": Format(".json", _json),
    "text": Format(".txt", _text),
}
"""By the names of the option `--format`."""
