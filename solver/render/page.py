"""A solution as one HTML page that needs nothing else: style, font and formulas are inside, no script, no request."""

from __future__ import annotations

import base64
import re
from collections.abc import Callable
from functools import lru_cache
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any
from weakref import proxy

from jinja2 import Environment, FileSystemLoader, StrictUndefined, pass_context
from jinja2.runtime import Context
from markupsafe import Markup

from solver import __version__, resources
from solver.compiled import kept
from solver.derivation.figures import Drawing
from solver.formula import MathProblem
from solver.formula.mathml import mathml
from solver.messages import Messages
from solver.render import pictures, pointing
from solver.render.prose import inline_html, to_html
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.document.model import Document

FONT = "fonts/solve-math.woff2"

POLICY = "default-src 'none'; style-src 'unsafe-inline'; font-src data:; img-src data:"
"""Content security policy of a page: even markup that slipped through could not run or load anything."""

NARROW = 14.0
"""Width in em that fits on a phone; a wider formula gets a box that scrolls and can be reached by keyboard."""
SIZE, SHRUNK = re.compile(r'<svg[^>]* width="([\d.]+)pt"'), 480
"""The width of a drawing in points; one that is wider scrolls on a phone, as shrunk to it it could not be read."""

FORMULA = 'aria-label="Formula"'
"""What a screen reader says of a formula in its box, before the page is put into its language."""

STYLE = Markup("<!-- style -->")
"""Stands for the style while a page is made, since it is four fifths of it; no text of a user has a tag in it."""

PAPER = 40.0, 52.0
"""Widths in em beyond which a formula is printed smaller, and smaller still: paper does not scroll."""


def render_page(document: Document) -> str:
    """Return the page of a solution, the same bytes for the same document.

    `html/page.html.jinja` and `html/style.css` of the folder of templates, if it has them, come before the installed
    ones.
    """
    return _style(document.presentation.templates).join(_pieces_of(document))


def encoded_page(document: Document) -> bytes:
    """Return the page of a solution in UTF-8; the style, as it is the same for all, need not be encoded anew."""
    return _encoded_style(document.presentation.templates).join(piece.encode() for piece in _pieces_of(document))


def _pieces_of(document: Document) -> list[str]:
    """Return what stands before the style of a solution's page, and behind it.

    A page's macros refer to each other, and stay until garbage is collected: through a proxy the document need not.
    """
    templates, shown = document.presentation.templates, proxy(document)
    return _pieces("page.html.jinja", templates, document.messages, document=shown)


def rendered(template: str, templates: Path | None = None, messages: Messages | None = None, **values: Any) -> str:
    """Return a page made by one of the templates in `html/`, with the style, the font and the policy of all pages."""
    return _style(templates).join(_pieces(template, templates, messages or Messages(), **values))


def _pieces(template: str, templates: Path | None, words: Messages, **values: Any) -> list[str]:
    """Return what stands before the style of a page, and behind it."""
    fixed = {"version": __version__, "policy": POLICY, "style": STYLE, "language": words.language}
    page = _environment(templates).get_template(template)
    html = page.render(**values, **fixed, say=words.say, phrase=lambda text, **of: words.say(Phrase(text, **of)))
    return html.replace(FORMULA, f'aria-label="{words.say("Formula")}"').split(STYLE)


@lru_cache
def _style(templates: Path | None) -> str:
    """Return the style of all pages, with the font in it; nothing in it can end the element."""
    style = _environment(templates).get_template("style.css").render(font=_font())
    return style.replace("</", "<\\/")


@lru_cache
def _encoded_style(templates: Path | None) -> bytes:
    return _style(templates).encode()


def drawn(latex: str, display: bool) -> str:
    """Return a formula as MathML in its box; LaTeX that cannot be drawn is shown as it stands, and marked."""
    try:
        markup, width = mathml(latex, display)
    except MathProblem as error:
        return f'<code class="not-drawn" title="{escape(error.message)}">{escape(latex)}</code>'
    kinds = ["display" if display else "inline", *_size(width)]
    reach = ' tabindex="0" role="group" ' + FORMULA if width > NARROW else ""
    if not display and not reach:
        return markup
    return f'<span class="formula {" ".join(kinds)}"{reach}>{markup}</span>'


def _size(width: float) -> list[str]:
    wide, wider = PAPER
    return ["wider"] if width > wider else ["wide"] if width > wide else []


@pass_context
def prose(context: Context, markdown: str) -> Markup:
    """Return Markdown with `$math$` as HTML blocks, with the images of the document."""
    document = context.get("document")
    return Markup(to_html(markdown, drawn, document.images if document else {}))  # noqa: S704 - `to_html` escapes all text, `drawn` all formulas


@lru_cache(maxsize=1024)  # titles, claims and names of oracles are those of other parts
def inline(markdown: str) -> Markup:
    """Return one line of Markdown with `$math$` as HTML to stand inside a heading or a cell."""
    return Markup(inline_html(markdown, drawn))  # noqa: S704 - as above


def displayed(latex: str) -> Markup:
    """Return LaTeX as a displayed formula."""
    return Markup(drawn(latex, True))  # noqa: S704 - escaped by `drawn`


def short(latex: str) -> Markup:
    """Return LaTeX as a formula in a line."""
    return Markup(drawn(latex, False))  # noqa: S704 - escaped by `drawn`


def pointed(says: Callable[..., str]) -> Callable[..., Markup]:
    """Return what says where something stands, in HTML with links."""

    def html(what: object, say: Callable[[str], str]) -> Markup:
        return inline(says(what, say, pointing.linked))

    return html


def figure(data: Drawing) -> Markup:
    """Return a figure with its caption; the drawing is an image, so its names can't meet those of the page."""
    drawing = pictures.svg_of(data)
    image = base64.b64encode(drawing.encode("utf-8")).decode("ascii")
    picture = f'<img alt="{escape(pictures.words_of(data))}" src="data:image/svg+xml;base64,{image}">'
    width = SIZE.search(drawing)
    if width and float(width[1]) > SHRUNK:
        picture = f'<div class="scroll wide" tabindex="0">{picture}</div>'
    caption = inline_html(data.caption, drawn)
    return Markup(f"<figure>{picture}<figcaption>{caption}</figcaption></figure>")  # noqa: S704 - escaped above


@lru_cache
def _environment(templates: Path | None) -> Environment:
    own = [templates / "html", templates] if templates else []
    environment = Environment(
        loader=FileSystemLoader([*own, resources.root("templates") / "html"]),
        autoescape=True,
        bytecode_cache=kept(templates),
        undefined=StrictUndefined,
        auto_reload=False,  # templates do not change while a program runs
        trim_blocks=True,
        lstrip_blocks=True,
    )
    filters: dict[str, Any] = {
        "prose": prose,
        "inline": inline,
        "displayed": displayed,
        "short": short,
        "figure": figure,
        "referring": pointed(pointing.referring),
        "picturing": pointed(pointing.picturing),
        "agreeing": pointed(pointing.agreeing),
        "noting": pointed(pointing.noting),
    }
    environment.filters.update(filters)
    return environment


@lru_cache
def _font() -> str:
    """Return the math font as a data URI."""
    content = (resources.root("templates") / "html" / FONT).read_bytes()
    return "data:font/woff2;base64," + base64.b64encode(content).decode("ascii")
