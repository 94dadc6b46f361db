"""Markdown with `$math$` to HTML, to LaTeX and to plain text: one parser, three writers.

CommonMark with tables; no raw HTML, links to the web and to mail only, images of the problem's own. Formulas pass the
white list of `solver.formula`; one that does not is shown as the text it is, never handed on.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from html import escape
from types import MappingProxyType
from typing import Any

from markdown_it import MarkdownIt
from markdown_it.token import Token

from solver.formula import find_problem
from solver.markup import MATH_TOKENS, address_of, parser, tokens
from solver.problem.images import Image
from solver.render.glued import glued
from solver.render.prose_latex import latex_of
from solver.render.prose_text import inline_text, text_of

__all__ = [
    "inline_as_text",
    "inline_html",
    "inline_latex",
    "plain",
    "to_html",
    "to_latex",
    "to_text",
]

Math = Callable[[str, bool], str]
"""Draws a formula (LaTeX, displayed or not) as HTML."""

Address = Callable[[Image], str]
"""Where an image is found."""

_MARKDOWN_SIGNS = re.compile(r"([\\`*_\[\]|$<>~&])")
_AT_LINE_START = re.compile(r"^()([#+\-=])|^(\d+)([.)])(?=\s|$)")


def within(image: Image) -> str:
    """Return the address of an image with its bytes in it."""
    return f"data:{image.media_type};base64,{b64encode(image.content).decode('ascii')}"


def to_html(
    markdown: str, math: Math, images: Mapping[str, Image] = MappingProxyType({}), address: Address = within
) -> str:
    """Return HTML; everything is escaped but the formulas, which `math` draws. Images are those of the mapping only."""
    return _html(tokens(markdown), math, images, address)


def inline_html(markdown: str, math: Math) -> str:
    """Return HTML of one line (a title), without a paragraph around it."""
    return _html(tokens(markdown, inline=True), math)


def to_latex(markdown: str) -> str:
    r"""Return LaTeX for a document that has booktabs, hyperref and the macro `\display` (see `latex_document`)."""
    return latex_of(tokens(markdown))


def inline_latex(markdown: str) -> str:
    """Return LaTeX of one line (a title)."""
    return latex_of(tokens(markdown, inline=True))


def to_text(markdown: str, width: int) -> str:
    """Return plain text for a terminal, its lines at most `width` cells long where formulas allow it."""
    return text_of(tokens(markdown), width)


def inline_as_text(markdown: str) -> str:
    """Return one line of Markdown (a title, a reason) as plain text."""
    return " ".join(inline_text(token.children or []) for token in tokens(markdown, inline=True))


def plain(text: str) -> str:
    """Return text whose signs mean nothing in Markdown."""
    words = _MARKDOWN_SIGNS.sub(r"\\\1", " ".join(text.split()))
    return _AT_LINE_START.sub(r"\1\3\\\2\4", words)


@cache
def _parser() -> MarkdownIt:
    """Return the parser with the rule that draws formulas."""
    found = parser()
    for kind, displayed in MATH_TOKENS.items():
        found.add_render_rule(kind, _drawer(displayed))
    found.add_render_rule("image", _shown_image)
    found.add_render_rule("table_open", lambda *_: '<div class="scroll" tabindex="0"><table>\n')  # wide on a phone
    found.add_render_rule("table_close", lambda *_: "</table></div>\n")
    return found


def _drawer(displayed: bool) -> Callable[..., str]:
    def draw(_renderer: Any, found: Sequence[Token], index: int, _options: Any, env: dict[str, Any]) -> str:
        formula = found[index].content.strip()
        if find_problem(formula) is not None:
            return f"<code>{escape(formula)}</code>"
        drawn: str = env["math"](formula, displayed)
        return drawn

    return draw


def _shown_image(_renderer: Any, found: Sequence[Token], index: int, _options: Any, env: dict[str, Any]) -> str:
    """Return an image, of one that is not known the words."""
    words = inline_text(found[index].children or [])
    image: Image | None = env["images"].get(address_of(found[index]))
    if image is None:
        return escape(words)
    return f'<img class="given" alt="{escape(words)}" src="{escape(env["address"](image))}" />'


def _html(
    found: list[Token], math: Math, images: Mapping[str, Image] = MappingProxyType({}), address: Address = within
) -> str:
    writer, shown = _parser(), {"math": math, "images": images, "address": address}
    rendered: str = writer.renderer.render(glued(found), writer.options, shown)
    return rendered
