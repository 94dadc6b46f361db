r"""Markdown's tokens as LaTeX: paragraphs, emphasis, lists, tables, headings, links, formulas.

The document defines `\display{..}` (a displayed formula, shrunk when it is wider than the line).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from markdown_it.token import Token

from solver.formula import find_problem, latex, read
from solver.markup import address_of, alignments
from solver.render.displays import on_pages
from solver.render.tex_text import escaped

_FIXED = {
    "paragraph_open": "",
    "em_open": r"\emph{",
    "em_close": "}",
    "strong_open": r"\textbf{",
    "strong_close": "}",
    "bullet_list_open": "\\begin{itemize}\n",
    "bullet_list_close": "\\end{itemize}\n\n",
    "ordered_list_close": "\\end{enumerate}\n\n",
    "list_item_open": "\\item{} ",
    "list_item_close": "",
    "blockquote_open": "\\begin{quote}\n",
    "blockquote_close": "\\end{quote}\n\n",
    "heading_open": "\\par\\medskip\\noindent\\textbf{",
    "heading_close": "}\\par\n\n",
    "softbreak": "\n",
    "hardbreak": "\\newline{}\n",
    "hr": "\\par\\noindent\\rule{\\linewidth}{0.4pt}\n\n",
    "link_close": "}",
    "thead_open": "\\toprule\n",
    "thead_close": "\\midrule\n",
    "tbody_open": "",
    "tbody_close": "",
    "tr_open": "",
    "table_close": "\\bottomrule\n\\end{tabular}\\end{center}\n\n",
}

_WITHIN = re.compile(r"#[\w-]+", re.ASCII)
"""The address of a place in the document."""

DEEPEST = 5
"""TeX nests lists six deep, itemize four; deeper ones lose their layout."""

_TOO_DEEP = {
    **dict.fromkeys(("bullet_list_open", "ordered_list_open", "blockquote_open", "list_item_close"), ""),
    **dict.fromkeys(("bullet_list_close", "ordered_list_close", "blockquote_close"), "\n"),
    "list_item_open": "-- ",
}


def latex_of(tokens: Sequence[Token]) -> str:
    """Return the tokens' LaTeX, without blank lines at either end.

    An image is the macro `givenimage` of the document with its address and its words.
    """
    return "".join(_write(token, tokens, index) for index, token in enumerate(tokens)).strip()


def _write(token: Token, tokens: Sequence[Token], index: int) -> str:
    level = token.level - token.type.startswith("list_item")  # an item is as deep as its list
    if level >= DEEPEST and token.type in _TOO_DEEP:
        return _TOO_DEEP[token.type]
    if token.type in _FIXED:
        return _FIXED[token.type]
    return _WRITERS.get(token.type, _text)(token, tokens, index)


def formula_latex(formula: str, displayed: bool) -> str:
    """Return a formula for the document; one that is not of our dialect as the text it is."""
    formula = formula.strip()
    if find_problem(formula) is not None:
        return rf"\texttt{{{escaped(formula)}}}"
    if not formula.isascii():
        formula = latex(read(formula))  # Greek letters become commands
    return display_latex(formula) if displayed else f"${formula}$"


def display_latex(formula: str, around: str = "") -> str:
    r"""Return a displayed formula, in the command `around` (`\boxed`); a long list of equations as several."""
    return "".join(_display(block, around) for _, block in on_pages(formula))


def _display(formula: str, around: str) -> str:
    return f"\\display{{{around}{{{formula}}}}}\n" if around else f"\\display{{{formula}}}\n"


def _text(token: Token, _tokens: Sequence[Token], _index: int) -> str:
    return escaped(token.content)


def _inline(token: Token, _tokens: Sequence[Token], _index: int) -> str:
    children = token.children or []
    return "".join(_write(child, children, index) for index, child in enumerate(children))


def _math(token: Token, _tokens: Sequence[Token], _index: int) -> str:
    return formula_latex(token.content, token.type != "math_inline")


def _code(token: Token, _tokens: Sequence[Token], _index: int) -> str:
    return rf"\texttt{{{escaped(token.content)}}}"


def _block(token: Token, _tokens: Sequence[Token], _index: int) -> str:
    lines = (escaped(line).replace(" ", "~") for line in token.content.rstrip("\n").split("\n"))
    body = "\\\\\n".join(rf"\texttt{{\null {line}}}" for line in lines)  # without \null a line loses its indent
    return f"\\begin{{quote}}\n{body}\n\\end{{quote}}\n\n"


def _ordered_list(token: Token, _tokens: Sequence[Token], _index: int) -> str:
    start = int(token.attrGet("start") or 1)
    first = f"\\addtocounter{{enumi}}{{{start - 1}}}\n" if 1 < start < 10**6 and token.level == 0 else ""
    return f"\\begin{{enumerate}}\n{first}"


def _link(token: Token, _tokens: Sequence[Token], _index: int) -> str:
    address = str(token.attrGet("href") or "")
    if _WITHIN.fullmatch(address):
        return rf"\hyperlink{{{address[1:]}}}{{"
    return rf"\href{{{_address(address)}}}{{"


def _picture(token: Token, _tokens: Sequence[Token], _index: int) -> str:
    return rf"\givenimage{{{picture_name(address_of(token))}}}{{{_inline(token, [], 0)}}}"


def picture_name(address: str) -> str:
    """Return the address of an image in letters and digits, which mean nothing to TeX."""
    return address.encode().hex()


def _address(address: str) -> str:
    """Return a link's address (the parser has percent-encoded it) with TeX's own signs escaped."""
    return "".join(
        f"\\{sign}" if sign in "%#&_$" else f"\\%{ord(sign):02X}" if sign in "\\{}^~" else sign for sign in address
    )


def _table(_token: Token, tokens: Sequence[Token], index: int) -> str:
    columns = "".join(each[0] for each in alignments(tokens, index))
    return f"\\begin{{center}}\\begin{{tabular}}{{{columns}}}\n"


def _cell(_token: Token, tokens: Sequence[Token], index: int) -> str:
    return " & " if tokens[index - 1].type in {"th_close", "td_close"} else "{}"  # lest [ begin the row


def _nothing(_token: Token, _tokens: Sequence[Token], _index: int) -> str:
    return ""


def _paragraph_end(_token: Token, tokens: Sequence[Token], index: int) -> str:
    """End a paragraph, unless a formula follows, which is displayed in it: TeX keeps both on one page."""
    return "\n" if [each.type for each in tokens[index + 1 : index + 2]] == ["math_block"] else "\n\n"


def _row_end(_token: Token, _tokens: Sequence[Token], _index: int) -> str:
    return " \\\\\n"


_WRITERS: dict[str, Callable[[Token, Sequence[Token], int], str]] = {
    "inline": _inline,
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
    "th_open": _cell,
    "td_open": _cell,
    "th_close": _nothing,
    "td_close": _nothing,
    "tr_close": _row_end,
}
