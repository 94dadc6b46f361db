"""Markdown with `$math$`: CommonMark with tables; no raw HTML, links to the web and to mail only, images of files."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache, lru_cache
from urllib.parse import unquote

from markdown_it import MarkdownIt
from markdown_it.rules_inline import StateInline, image
from markdown_it.token import Token
from mdit_py_plugins.dollarmath import dollarmath_plugin

from solver.formula import find_problem

MATH_TOKENS = {"math_inline": False, "math_inline_double": True, "math_block": True}
"""The parser's tokens for formulas, and whether they are displayed."""

_ALLOWED_LINK = re.compile(r"(https?://|mailto:|#)", re.IGNORECASE)
_ALLOWED_IMAGE = re.compile(r"[^:?#\\]+")
_HIGHEST_HEADING = 3  # the page's title and the parts have the two above


@cache
def parser() -> MarkdownIt:
    """Return the one parser."""
    found = MarkdownIt("commonmark", {"html": False}).enable("table")
    dollarmath_plugin(found, allow_labels=False, allow_digits=False, allow_blank_lines=False, double_inline=True)
    found.validateLink = lambda url: bool(_ALLOWED_LINK.match(url))  # type: ignore[method-assign]  # its documented use
    found.inline.ruler.at("image", _image)
    return found


def _image(state: StateInline, silent: bool) -> bool:
    """Read an image by the parser's own rule, if its address is that of a file below the folder of the text."""
    links = state.md.validateLink
    state.md.validateLink = lambda url: bool(_ALLOWED_IMAGE.fullmatch(url))  # type: ignore[method-assign]
    try:
        return image(state, silent)
    finally:
        state.md.validateLink = links  # type: ignore[method-assign]


@lru_cache(maxsize=1024)
def tokens(markdown: str, *, inline: bool = False) -> list[Token]:
    """Return the parser's tokens; a text is parsed once for its check and its formats. They must not be changed."""
    found = parser().parseInline(markdown) if inline else parser().parse(markdown)
    for token in found:
        if token.type in {"heading_open", "heading_close"}:
            token.tag = f"h{min(6, int(token.tag[1]) + _HIGHEST_HEADING - 1)}"
    return found


def math_problems(markdown: str) -> list[tuple[int, str]]:
    """Return what is wrong with the formulas of a text: (offset in the text, message) for each bad one."""
    problems = []
    position = 0
    for token in _flat(tokens(markdown)):
        if token.type in MATH_TOKENS:
            formula = token.content
            start = markdown.find(formula.strip(), position)
            start = position if start < 0 else start
            problem = find_problem(formula.strip())
            if problem is not None:
                problems.append((start + problem[0], problem[1]))
            position = start + len(formula.strip())
    return problems


def images_in(markdown: str) -> list[str]:
    """Return the addresses of the images of a text, as their files are named, in the order of the text."""
    return [address_of(token) for token in _flat(tokens(markdown)) if token.type == "image"]


def address_of(token: Token) -> str:
    """Return the name of the file of an image's token."""
    return unquote(str(token.attrGet("src")))


def alignments(found: Sequence[Token], index: int) -> list[str]:
    """Return "left", "center" or "right" for each column of the table whose token is at an index."""
    aligns = []
    for token in found[index:]:
        if token.type == "th_open":
            style = str(token.attrGet("style") or "")
            aligns.append("right" if "right" in style else "center" if "center" in style else "left")
        elif token.type == "thead_close":
            break
    return aligns


def _flat(found: Sequence[Token]) -> Iterator[Token]:
    for token in found:
        yield token
        yield from _flat(token.children or ())
