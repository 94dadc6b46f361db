"""Markdown's tokens as typst: function calls and literal strings, no markup, so that no text can mean anything.

The document defines what is called here and is not typst's own: `eq`, `formula`, `leading`, `within`, `given`, `rows`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from markdown_it.token import Token

from solver.formula import find_problem, read
from solver.formula.terminal import flat
from solver.formula.typst import typst
from solver.markup import address_of, alignments, tokens
from solver.render.displays import on_pages
from solver.render.prose_text import inline_text
from solver.render.typst_text import heard, quoted

_FIXED = {
    "em_open": "#emph[",
    "em_close": "]",
    "strong_open": "#strong[",
    "strong_close": "]",
    "bullet_list_open": "#list(tight: false,\n",
    "bullet_list_close": ")\n\n",
    "ordered_list_close": ")\n\n",
    "list_item_open": "[",
    "list_item_close": "],\n",
    "blockquote_open": "#quote(block: true)[",
    "blockquote_close": "]\n\n",
    "heading_open": "#leading[#strong[",
    "heading_close": "]]\n\n",
    "softbreak": " ",
    "hardbreak": "#linebreak()",
    "hr": "#line(length: 100%, stroke: 0.4pt)\n\n",
    "link_close": "]",
    "thead_open": "table.header(",
    "thead_close": "table.hline(stroke: 0.5pt)),\n",
    "tbody_open": "",
    "tbody_close": "",
    "tr_open": "",
    "tr_close": "\n",
    "th_open": "[",
    "td_open": "[",
    "th_close": "], ",
    "td_close": "], ",
    "table_close": ")\n\n",
}
_WITHIN = re.compile(r"#[\w-]+", re.ASCII)
"""The address of a place in the document."""


def typst_of(found: Sequence[Token]) -> str:
    """Return the tokens' typst, without blank lines at either end."""
    return "".join(_write(token, found, index) for index, token in enumerate(found)).strip()


def to_typst(markdown: str) -> str:
    """Return typst for a document made by `templates/typst/page.typ.jinja`."""
    return typst_of(tokens(markdown))


def inline_typst(markdown: str) -> str:
    """Return typst of one line (a title)."""
    return typst_of(tokens(markdown, inline=True))


def display_typst(formula: str, *, framed: bool = False) -> str:
    """Return a displayed formula, shrunk when it is wider than the line; a long list of equations as several."""
    return "".join(
        f"#formula({heard(_words(latex))}, framed: {str(framed).lower()}, ${typst(tree)}$)\n\n"
        for tree, latex in on_pages(formula)
    )


def heard_and_set(formula: str) -> str:
    """Return what is read aloud of a formula, and it as large as on a line of its own: two arguments of a function."""
    return f"{heard(_words(formula))}, ${typst(read(formula))}$"


def inline_formula(formula: str) -> str:
    """Return a formula within a line; one that is not of our dialect as the text it is."""
    if find_problem(formula) is not None:
        return f"#raw({quoted(formula)})"
    return f"#eq({heard(_words(formula))}, ${typst(read(formula), in_line=True)}$)"


def _words(formula: str) -> str:
    """Return what is read aloud of a formula."""
    return " ".join(flat(formula).split()) or "…"


def _write(token: Token, found: Sequence[Token], index: int) -> str:
    if token.type in _FIXED:
        return _FIXED[token.type]
    return _WRITERS.get(token.type, _text)(token, found, index)


def _text(token: Token, found: Sequence[Token], index: int) -> str:
    begins = index and found[index - 1].type == "math_inline_double"  # a line, below the formula
    content = token.content.lstrip() if begins else token.content
    return f"#{quoted(content)}" if content else ""


def _inline(token: Token, _found: Sequence[Token], _index: int) -> str:
    children = token.children or []
    return "".join(_write(child, children, index) for index, child in enumerate(children))


def _math(token: Token, _found: Sequence[Token], _index: int) -> str:
    formula = token.content.strip()
    if token.type == "math_inline" or find_problem(formula) is not None:
        return inline_formula(formula)
    return display_typst(formula)


def _code(token: Token, _found: Sequence[Token], _index: int) -> str:
    return f"#raw({quoted(token.content)})"


def _block(token: Token, _found: Sequence[Token], _index: int) -> str:
    lines = token.content.rstrip("\n").split("\n")
    return f"#raw(block: true, ({', '.join(map(quoted, lines))},).join({_NEW_LINE}))\n\n"


_NEW_LINE = r'"\n"'


def _paragraph(_token: Token, found: Sequence[Token], index: int) -> str:
    """Begin a paragraph; one that leads to a formula stays on its page."""
    return "#leading[" if _leads(found, index) else ""


def _paragraph_end(_token: Token, found: Sequence[Token], index: int) -> str:
    return "]\n\n" if _leads(found, index - 2) else "\n\n"


def _leads(found: Sequence[Token], index: int) -> bool:
    return [each.type for each in found[index + 3 : index + 4]] == ["math_block"]


def _ordered_list(token: Token, _found: Sequence[Token], _index: int) -> str:
    start = int(token.attrGet("start") or 1)
    return f"#enum(tight: false, start: {start if start < 10**6 else 1},\n"


def _link(token: Token, _found: Sequence[Token], _index: int) -> str:
    address = str(token.attrGet("href") or "")
    if _WITHIN.fullmatch(address):
        return f"#within({quoted(address[1:])})["
    return f"#link({quoted(address)})["


def _picture(token: Token, _found: Sequence[Token], _index: int) -> str:
    return f"#given({quoted(address_of(token))}, {heard(inline_text(token.children or []))})"


def _table(_token: Token, found: Sequence[Token], index: int) -> str:
    return f"#rows(({', '.join(alignments(found, index))},),\n"


_WRITERS: dict[str, Callable[[Token, Sequence[Token], int], str]] = {
    "inline": _inline,
    "paragraph_open": _paragraph,
    "paragraph_close": _paragraph_end,
    "text": _text,
    "math_inline": _math,
    "math_inline_double": _math,
    "math_block": _math,
    "code_inline": _code,
    "code_block": _block,
    "fence": _block,
    "ordered_list_open": _ordered_list,
    "link_open": _link,
    "image": _picture,
    "table_open": _table,
}
