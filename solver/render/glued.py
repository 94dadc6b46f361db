"""Punctuation kept on the line of its formula: no comma behind `$…$` begins a line, no bracket before it ends one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from markdown_it.token import Token

from solver.markup import MATH_TOKENS

_BEFORE = re.compile(r"[(\[“„‘‚«]+\Z")
_BEHIND = re.compile(r"\A[.,;:!?)\]”’»…]+")


def glued(found: Iterable[Token]) -> list[Token]:
    """Return the tokens with each formula in one span with the punctuation at it; those given stay as they are."""
    return list(map(_glued, found))


def _glued(token: Token) -> Token:
    children = token.children or []
    if not any(_is_formula(children, place) for place in range(len(children))):
        return token
    return token.copy(children=list(_children(children)))


def _children(children: Sequence[Token]) -> Iterator[Token]:
    for place, token in enumerate(children):
        if not _is_formula(children, place):
            yield token if token.type != "text" else _text(_between(children, place))
            continue
        before, behind = _at(_BEFORE, children, place - 1), _at(_BEHIND, children, place + 1)
        if not before and not behind:
            yield token
            continue
        yield _raw('<span class="glued">')
        yield from (_text(before), token, _text(behind))
        yield _raw("</span>")


def _between(children: Sequence[Token], place: int) -> str:
    """Return a text without what is glued to the formulas on both sides of it."""
    text = children[place].content
    if _is_formula(children, place - 1):
        text = _BEHIND.sub("", text)
    return _BEFORE.sub("", text) if _is_formula(children, place + 1) else text


def _at(signs: re.Pattern[str], children: Sequence[Token], place: int) -> str:
    """Return the punctuation at an edge of a text, empty where there is none."""
    if not 0 <= place < len(children) or children[place].type != "text":
        return ""
    text = children[place].content
    if signs is _BEFORE and _is_formula(children, place - 1):
        text = _BEHIND.sub("", text)  # it belongs to the formula before
    match = signs.search(text)
    return match[0] if match else ""


def _is_formula(children: Sequence[Token], place: int) -> bool:
    return 0 <= place < len(children) and MATH_TOKENS.get(children[place].type) is False


def _text(content: str) -> Token:
    return Token("text", "", 0, content=content)


def _raw(html: str) -> Token:
    return Token("html_inline", "", 0, content=html)
