r"""A solution as a LaTeX document that compiles with the small TeX collections (base, recommended, lmodern).

The layout is `templates/latex/document.tex.jinja`, with `\VAR{..}` and `\BLOCK{..}` for Jinja's braces. Texts pass
the filters `text` (plain), `line` (one line of Markdown) and `prose` (Markdown); formulas come from our printer.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jinja2 import FileSystemLoader, StrictUndefined
from jinja2.sandbox import ImmutableSandboxedEnvironment

from solver import __version__, resources
from solver.compiled import kept
from solver.derivation.figures import Drawing
from solver.messages import Messages
from solver.problem.images import Image
from solver.render import pointing
from solver.render.prose import inline_latex, to_latex
from solver.render.prose_latex import display_latex, picture_name
from solver.render.tex_text import escaped
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.document.model import Document


def latex_document(document: Document) -> str:
    """Return the source of the whole document. The same document gives the same text: it holds no date."""
    return rendered_latex(
        "document.tex.jinja", document.presentation.templates, document.messages, document.title, document=document
    )


def rendered_latex(template: str, templates: Path | None, messages: Messages, title: str, **values: Any) -> str:
    """Return a document made by one of the templates in `latex/`; `title` is what the PDF says of itself."""
    pdf_title = escaped("".join(letter for letter in title if letter.isascii()))
    page = _environment(templates).get_template(template)
    fixed = {"version": __version__, "pdf_title": pdf_title}
    say = messages.say
    return page.render(**values, **fixed, say=say, phrase=lambda text, **of: say(Phrase(text, **of))) + "\n"


@lru_cache(maxsize=8)
def _environment(templates: Path | None) -> ImmutableSandboxedEnvironment:
    own = [templates / "latex"] if templates else []
    environment = ImmutableSandboxedEnvironment(
        block_start_string=r"\BLOCK{",
        block_end_string="}",
        variable_start_string=r"\VAR{",
        variable_end_string="}",
        comment_start_string=r"\#{",
        comment_end_string="}",
        loader=FileSystemLoader([*own, resources.root("templates") / "latex"]),
        bytecode_cache=kept(templates),
        undefined=StrictUndefined,
        autoescape=False,  # this is TeX; every text passes a filter that escapes for TeX
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters.update(
        bitmaps=_bitmaps,
        figure=_figure,
        text=_line_of_text,
        line=inline_latex,
        prose=to_latex,
        breakable=_breakable,
        boxed=_boxed,
        referring=_pointed(pointing.referring),
        picturing=_pointed(pointing.picturing),
        agreeing=_pointed(pointing.agreeing),
        noting=_pointed(pointing.noting),
    )
    return environment


def files_beside(document: Document) -> dict[str, bytes]:
    """Return the images that the document includes, by the names of their files. TeX draws no SVG."""
    return {image.file_name: image.content for _, image in _bitmaps(document.images)}


def _bitmaps(images: Mapping[str, Image]) -> list[tuple[str, Image]]:
    """Return the images that TeX can include, by their addresses as the macro `givenimage` has them."""
    found = ((address, image) for address, image in images.items() if not image.is_drawing)
    return [(picture_name(address), image) for address, image in found]


def _line_of_text(text: str) -> str:
    return escaped(" ".join(str(text).split()))


def _figure(data: Drawing) -> str:
    """Return a figure, shrunk to the line if it is wider, with its caption."""
    from solver import figures  # noqa: PLC0415 - only a document that has a figure needs them

    return f"\\drawing{{%\n{figures.tikz(data)}}}{{{inline_latex(data.caption)}}}"


def _pointed(says: Callable[..., str]) -> Callable[..., str]:
    """Return what says where something stands, in LaTeX with links."""
    return lambda what, say: inline_latex(says(what, say, pointing.linked))


def _boxed(equation: str) -> str:
    return display_latex(equation, r"\boxed")


def _breakable(latex: str) -> str:
    """Allow a line break after the dots and underscores of a function's name."""
    return latex.replace(r"\_", r"\_\allowbreak{}").replace(".", r".\allowbreak{}")
