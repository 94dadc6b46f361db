"""Markdown with `$math$` to HTML, to LaTeX and to plain text: one parser, three writers.

CommonMark with tables; no raw HTML, no images, links to the web and to mail only. Formulas pass the white list of
`math_check`; one that does not is shown as the text it is, never handed on.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from functools import cache, lru_cache
from html import escape
from typing import Any

from markdown_it import MarkdownIt
from markdown_it.token import Token
from mdit_py_plugins.dollarmath import dollarmath_plugin

from solver.render.math_check import MathProblem, check_math, find_problem
from solver.render.prose_latex import latex_of
from solver.render.prose_text import inline_text, text_of

__all__ = [
    "MathProblem",
    "check_math",
    "inline_as_text",
    "inline_html",
    "inline_latex",
    "math_problems",
    "plain",
    "to_html",
    "to_latex",
    "to_text",
]

Math = Callable[[str, bool], str]
"""Draws a formula (LaTeX, displayed or not) as HTML."""

MATH_TOKENS = {"math_inline": False, "math_inline_double": True, "math_block": True}
"""The parser's tokens for formulas, and whether they are displayed."""

_ALLOWED_LINK = re.compile(r"(https?://|mailto:|#)", re.IGNORECASE)
_MARKDOWN_SIGNS = re.compile(r"([\\`*_\[\]|$<>~&])")
_AT_LINE_START = re.compile(r"^()([#+\-=])|^(\d+)([.)])(?=\s|$)")
_HIGHEST_HEADING = 3  # the page's title and the parts have the two above


def to_html(markdown: str, math: Math) -> str:
    """Return HTML; everything is escaped but the formulas, which `math` draws."""
    return _html(_tokens(markdown), math)


def inline_html(markdown: str, math: Math) -> str:
    """Return HTML of one line (a title), without a paragraph around it."""
    return _html(_tokens(markdown, inline=True), math)


def to_latex(markdown: str) -> str:
    r"""Return LaTeX for a document that has booktabs, hyperref and the macro `\display` (see `latex_document`)."""
    return latex_of(_tokens(markdown))


def inline_latex(markdown: str) -> str:
    """Return LaTeX of one line (a title)."""
    return latex_of(_tokens(markdown, inline=True))


def to_text(markdown: str, width: int) -> str:
    """Return plain text for a terminal, its lines at most `width` cells long where formulas allow it."""
    return text_of(_tokens(markdown), width)


def inline_as_text(markdown: str) -> str:
    """Return one line of Markdown (a title, a reason) as plain text."""
    return " ".join(inline_text(token.children or []) for token in _tokens(markdown, inline=True))


def math_problems(markdown: str) -> list[tuple[int, str]]:
    """Return what is wrong with the formulas of a text: (offset in the text, message) for each bad one."""
    problems = []
    position = 0
    for token in _flat(_tokens(markdown)):
        if token.type in MATH_TOKENS:
            formula = token.content
            start = markdown.find(formula.strip(), position)
            start = position if start < 0 else start
            problem = find_problem(formula.strip())
            if problem is not None:
                problems.append((start + problem[0], problem[1]))
            position = start + len(formula.strip())
    return problems


def plain(text: str) -> str:
    """Return text whose signs mean nothing in Markdown."""
    words = _MARKDOWN_SIGNS.sub(r"\\\1", " ".join(text.split()))
    return _AT_LINE_START.sub(r"\1\3\\\2\4", words)


@lru_cache(maxsize=1024)
def _tokens(markdown: str, *, inline: bool = False) -> list[Token]:
    """Return the parser's tokens; a text is parsed once for its check and its formats. They must not be changed."""
    tokens = _parser().parseInline(markdown) if inline else _parser().parse(markdown)
    for token in tokens:
        if token.type in {"heading_open", "heading_close"}:
            token.tag = f"h{min(6, int(token.tag[1]) + _HIGHEST_HEADING - 1)}"
    return tokens


@cache
def _parser() -> MarkdownIt:
    parser = MarkdownIt("commonmark", {"html": False}).enable("table")
    dollarmath_plugin(parser, allow_labels=False, allow_digits=False, allow_blank_lines=False, double_inline=True)
    parser.disable(["image", "html_block", "html_inline"])
    parser.validateLink = lambda url: bool(_ALLOWED_LINK.match(url))  # type: ignore[method-assign]  # its documented use
    for kind, displayed in MATH_TOKENS.items():
        parser.add_render_rule(kind, _drawer(displayed))
    return parser


def _drawer(displayed: bool) -> Callable[..., str]:
    def draw(_renderer: Any, tokens: Sequence[Token], index: int, _options: Any, env: dict[str, Any]) -> str:
        formula = tokens[index].content.strip()
        if find_problem(formula) is not None:
            return f"<code>{escape(formula)}</code>"
        drawn: str = env["math"](formula, displayed)
        return drawn

    return draw


def _html(tokens: list[Token], math: Math) -> str:
    parser = _parser()
    rendered: str = parser.renderer.render(tokens, parser.options, {"math": math})
    return rendered


def _flat(tokens: Sequence[Token]) -> Iterator[Token]:
    for token in tokens:
        yield token
        yield from _flat(token.children or ())
