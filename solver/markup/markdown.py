"""Markdown with `$math$`: CommonMark with tables; no raw HTML, no images, links to the web and to mail only."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache, lru_cache

from markdown_it import MarkdownIt
from markdown_it.token import Token
from mdit_py_plugins.dollarmath import dollarmath_plugin

from solver.formula import find_problem

MATH_TOKENS = {"math_inline": False, "math_inline_double": True, "math_block": True}
"""The parser's tokens for formulas, and whether they are displayed."""

_ALLOWED_LINK = re.compile(r"(https?://|mailto:|#)", re.IGNORECASE)
_HIGHEST_HEADING = 3  # the page's title and the parts have the two above


@cache
def parser() -> MarkdownIt:
    """Return the one parser."""
    found = MarkdownIt("commonmark", {"html": False}).enable("table")
    dollarmath_plugin(found, allow_labels=False, allow_digits=False, allow_blank_lines=False, double_inline=True)
    found.disable(["image", "html_block", "html_inline"])
    found.validateLink = lambda url: bool(_ALLOWED_LINK.match(url))  # type: ignore[method-assign]  # its documented use
    return found


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


def _flat(found: Sequence[Token]) -> Iterator[Token]:
    for token in found:
        yield token
        yield from _flat(token.children or ())
