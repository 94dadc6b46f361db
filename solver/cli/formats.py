"""A solution in each output format, as bytes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from solver.engine import Solution
from solver.render.view import SolutionView, view_of
from solver.render.wording import Wording


@dataclass(frozen=True)
class Document:
    """A solution with how it is to be worded; every format is made from the same view."""

    solution: Solution
    detail: str = "full"
    templates: Path | None = None
    name: str = ""

    @cached_property
    def wording(self) -> Wording:
        """How the solution is worded."""
        return Wording.of(self.solution.display, self.detail, self.templates)

    @cached_property
    def view(self) -> SolutionView:
        """The solution in words; raises `WordingError` if a template is missing or wrong."""
        return view_of(self.solution, self.wording)

    def load_wording(self) -> None:
        """Compile the wording of all that is asked before it is needed; raises Jinja's `TemplateError`."""
        for part in self.solution.problem.parts:
            for name in ("question", *part.methods):
                self.wording.load(f"{part.task}/{name}")

    def rendered(self, format: str) -> bytes:  # noqa: A002 - the word of the option
        """Return the solution in a format; raises `PdfUnavailable`, `WordingError`, or Jinja's `TemplateError`."""
        return WRITERS[format](self)


def _html(document: Document) -> bytes:
    from solver.render.page import render_page

    page = render_page(
        document.view, name=Path(document.name).name, detail=document.detail, templates=document.templates
    )
    return page.encode()


def _latex(document: Document) -> bytes:
    from solver.render.latex_document import latex_document

    return latex_document(document.view, document.templates).encode()


def _pdf(document: Document) -> bytes:
    from solver.render.pdf import pdf_of

    return pdf_of(_latex(document).decode())


def _markdown(document: Document) -> bytes:
    from solver.render.markdown import markdown_of

    return markdown_of(document.view).encode()


def _text(document: Document) -> bytes:
    from solver.render.terminal import text_document

    return text_document(document.view).encode()


def _json(document: Document) -> bytes:
    from solver.render.data import render_json

    return render_json(document.solution, document.view).encode()


WRITERS: dict[str, Callable[[Document], bytes]] = {
    "html": _html,
    "latex": _latex,
    "pdf": _pdf,
    "md": _markdown,
    "json": _json,
    "text": _text,
}
