"""Markdown's tokens as plain text for a terminal: wrapped, formulas in Unicode, displayed ones drawn."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from textwrap import wrap

from markdown_it.token import Token

from solver.formula.terminal import drawn, flat
from solver.formula.terminal.boxes import cells, padded

FIRM = "\xa0"
"""A space at which a line is not broken, while it is being wrapped."""

LONGEST_FIRM = 40
"""Formulas up to this length stay on one line."""

INDENT = "    "


@dataclass
class _Writer:
    """The lines so far; `first` is what the next line begins with (a bullet), `margin` what later ones begin with."""

    width: int
    lines: list[str] = field(default_factory=list)
    margins: list[str] = field(default_factory=list)
    bullet: str = ""
    counters: list[int | None] = field(default_factory=list)

    def block(self, lines: Sequence[str]) -> None:
        """Add a paragraph, an empty line before it."""
        if self.lines and lines and not (self.counters and self.bullet):
            self.lines.append("")
        margin = "".join(self.margins)
        for line in lines:
            start = margin[: len(margin) - len(self.bullet)] + self.bullet if self.bullet else margin
            self.lines.append((start + _harmless(line)).rstrip())
            self.bullet = ""

    @property
    def room(self) -> int:
        """Cells left for text on a line."""
        return max(20, self.width - len("".join(self.margins)))


def text_of(tokens: Sequence[Token], width: int) -> str:
    """Return the tokens as text with lines of at most `width` cells where formulas allow it."""
    writer = _Writer(width)
    table: list[list[str]] = []
    for token in tokens:
        if token.type == "inline":
            if table:
                table[-1].append(inline_text(token.children or []))
            else:
                _inline(token.children or [], writer)
        elif token.type == "tr_open":
            table.append([])
        elif token.type == "table_close":
            writer.block(_table(table))
            table = []
        elif token.type == "math_block":
            writer.block(display_lines(token.content, writer.room))
        elif token.type in {"fence", "code_block"}:
            writer.block([INDENT + line for line in token.content.rstrip("\n").split("\n")])
        elif token.type == "hr":
            writer.block(["─" * writer.room])
        else:
            _container(token, writer)
    return "\n".join(writer.lines)


def _container(token: Token, writer: _Writer) -> None:
    """Enter or leave a list, an item or a quotation."""
    match token.type:
        case "bullet_list_open":
            writer.counters.append(None)
        case "ordered_list_open":
            writer.counters.append(int(token.attrGet("start") or 1))
        case "bullet_list_close" | "ordered_list_close":
            writer.counters.pop()
        case "list_item_open":
            number = writer.counters[-1]
            writer.bullet = "• " if number is None else f"{number}. "
            writer.counters[-1] = None if number is None else number + 1
            writer.margins.append(" " * len(writer.bullet))
        case "blockquote_open":
            writer.margins.append("  ")
        case "list_item_close" | "blockquote_close":
            writer.margins.pop()


def _inline(children: Sequence[Token], writer: _Writer) -> None:
    """Write a paragraph; displayed formulas in it stand on lines of their own."""
    text = ""
    for child in children:
        if child.type == "math_inline_double":
            writer.block(wrapped(text, writer.room))
            writer.block(display_lines(child.content, writer.room))
            text = ""
        else:
            text += _piece(child)
    writer.block(wrapped(text, writer.room))


def _harmless(text: str) -> str:
    """Return the text without characters that would act on a terminal."""
    return "".join(letter for letter in text if letter.isprintable())


def inline_text(children: Sequence[Token]) -> str:
    """Return the text of one line."""
    return _harmless("".join(map(_piece, children)).replace(FIRM, " ").replace("\n", " ")).strip()


def _piece(token: Token) -> str:
    if token.type in {"math_inline", "math_inline_double"}:
        formula = flat(token.content)
        return formula.replace(" ", FIRM) if len(formula) <= LONGEST_FIRM else formula
    if token.type in {"softbreak", "hardbreak"}:
        return " " if token.type == "softbreak" else "\n"
    if token.type == "image":
        return f"[{inline_text(token.children or [])}]"
    return token.content


def wrapped(text: str, width: int) -> list[str]:
    """Return the lines of a paragraph."""
    lines = (line for part in text.split("\n") for line in wrap(part.strip(" "), width, break_on_hyphens=False))
    return [line.replace(FIRM, " ") for line in lines]


def fits(latex: str, width: int) -> bool:
    """Whether a displayed formula, drawn in two dimensions and indented, has at most `width` cells."""
    return max(map(cells, drawn(latex.strip())), default=0) + len(INDENT) <= width


def display_lines(latex: str, width: int) -> list[str]:
    """Return a displayed formula, drawn in two dimensions and indented; on wrapped lines if it is too wide for that."""
    lines = drawn(latex.strip())
    if not fits(latex, width):
        lines = wrapped(flat(latex.strip()), max(20, width - len(INDENT)))
    return [INDENT + line for line in lines]


def _table(rows: Sequence[Sequence[str]]) -> list[str]:
    """Return a table with a line under its head."""
    if not rows:
        return []
    count = max(len(row) for row in rows)
    full = [[*row, *[""] * (count - len(row))] for row in rows]
    widths = [max(cells(row[j]) for row in full) for j in range(count)]
    lines = ["  ".join(padded(cell, width) for cell, width in zip(row, widths, strict=True)) for row in full]
    return [lines[0], "  ".join("─" * width for width in widths), *lines[1:]]


def indented(lines: Sequence[str], indent: str = INDENT) -> Iterator[str]:
    """Yield the lines with an indentation; empty ones stay empty."""
    return (indent + line if line else "" for line in lines)
