"""A solution as a typst document that uses no package and reads no file but the images of the problem.

The layout is `templates/typst/page.typ.jinja`, with what it includes. Texts pass the filters `quoted` (plain), `line`
(one line of Markdown) and `prose` (Markdown); figures stand in the document as SVG, each with its words.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jinja2 import FileSystemLoader, StrictUndefined
from jinja2.sandbox import ImmutableSandboxedEnvironment

from solver import __version__, resources
from solver.compiled import kept
from solver.derivation.figures import Drawing
from solver.formula.typst import PRELUDE
from solver.messages import Messages
from solver.render import pictures, pointing
from solver.render.prose_typst import display_typst, heard_and_set, inline_formula, inline_typst, to_typst
from solver.render.typst_text import heard, quoted
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.document.model import Document

_LANGUAGE = re.compile(r"[a-z]{2,3}")


def typst_document(document: Document) -> str:
    """Return the source of the whole document. The same document gives the same text."""
    title = document.title if document.title.strip() else document.messages.say("Worked solution")
    return rendered_typst(
        "page.typ.jinja", document.presentation.templates, document.messages, title, document=document
    )


def rendered_typst(template: str, templates: Path | None, messages: Messages, title: str, **values: Any) -> str:
    """Return a document made by one of the templates in `typst/`; `title` is what the PDF says of itself."""
    say, language = messages.say, messages.language
    return (
        _environment(templates)
        .get_template(template)
        .render(
            **values,
            say=say,
            phrase=lambda text, **of: say(Phrase(text, **of)),
            version=__version__,
            prelude=PRELUDE,
            title=title,
            language=language if _LANGUAGE.fullmatch(language) else "en",
        )
    )


def files_beside(document: Document) -> dict[str, bytes]:
    """Return the images that the document includes, by the names of their files."""
    return {image.file_name: image.content for image in document.images.values()}


@lru_cache(maxsize=8)
def _environment(templates: Path | None) -> ImmutableSandboxedEnvironment:
    own = [templates / "typst"] if templates else []
    environment = ImmutableSandboxedEnvironment(
        loader=FileSystemLoader([*own, resources.root("templates") / "typst"]),
        bytecode_cache=kept(templates),
        undefined=StrictUndefined,
        autoescape=False,  # this is typst; every text passes a filter that makes it a literal string
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters.update(
        quoted=lambda text: quoted(str(text)),
        line=inline_typst,
        prose=to_typst,
        short=inline_formula,
        boxed=lambda formula: display_typst(formula, framed=True),
        heard_and_set=heard_and_set,
        figure=_figure,
        referring=_pointed(pointing.referring),
        picturing=_pointed(pointing.picturing),
        agreeing=_pointed(pointing.agreeing),
        noting=_pointed(pointing.noting),
    )
    return environment


def _figure(data: Drawing) -> str:
    """Return a figure with its caption, and in words."""
    image = f"({_literal(pictures.svg_of(data))}, {heard(pictures.words_of(data))})"
    return f"#drawing({image}, [{inline_typst(data.caption)}])"


def _literal(content: str) -> str:
    """Return a file's text as a string of typst's code, letter by letter."""
    return '"' + content.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _pointed(says: Callable[..., str]) -> Callable[..., str]:
    """Return what says where something stands, with links."""
    return lambda what, say: inline_typst(says(what, say, pointing.linked))
