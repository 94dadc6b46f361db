r"""Trees written as LaTeX: one spelling for each tree, with the blanks that a person would type."""

from __future__ import annotations

from collections.abc import Callable
from operator import attrgetter
from string import ascii_letters
from typing import Any

from solver.formula import vocabulary as v
from solver.formula.nodes import (
    Accent,
    Fenced,
    Fraction,
    Function,
    Node,
    Number,
    Operator,
    Root,
    Row,
    Scripts,
    Space,
    Stacked,
    Styled,
    Symbol,
    Table,
    Text,
    Visitor,
)
from solver.formula.reading import note_written
from solver.formula.signs import is_prefix


class LatexWriter(Visitor[str]):
    """Writes a tree; in an index, outside of brackets, no blank stands after a comma."""

    keeps = True  # values stand in several formulas of a page

    def __init__(self, index: bool = False) -> None:
        self.after_comma = "" if index else " "

    def number(self, node: Number) -> str:
        return node.digits

    def symbol(self, node: Symbol) -> str:
        return node.name

    def operator(self, node: Operator) -> str:
        return node.sign

    def function(self, node: Function) -> str:
        return rf"\operatorname{{{node.name}}}" if node.named else f"\\{node.name}"

    def text(self, node: Text) -> str:
        return f"{node.command}{{{node.words}}}"

    def space(self, node: Space) -> str:
        return node.command

    def row(self, node: Row) -> str:
        """Return what stands in the row, without braces."""
        written = before = ""
        for place, item in enumerate(node.items):
            leaf = _LEAVES.get(type(item))
            piece, kind = leaf(item) if leaf else self.argument(item), _kind(item)
            if kind == _INFIX and is_prefix(node.items, place):
                kind = _PREFIX
            if before == _COMMA and kind not in _SPACES:
                written += self.after_comma
            elif before + kind in _APART or (piece[:1].isalpha() and _runs_into(written, piece)):
                written += " "
            written += piece
            before = kind
        return written

    def argument(self, node: Node) -> str:
        """Return an argument or a script: a row in braces."""
        return f"{{{node.accept(self)}}}" if isinstance(node, Row) else node.accept(self)

    def fraction(self, node: Fraction) -> str:
        return self._command(node.command, node.above, node.below)

    def root(self, node: Root) -> str:
        index = "" if node.index is None else f"[{node.index.accept(self)}]"
        return self._command(rf"\sqrt{index}", node.radicand)

    def scripts(self, node: Scripts) -> str:
        below = "" if node.below is None else f"_{_IN_INDEX.argument(node.below)}"
        above = "" if node.above is None else f"^{self.argument(node.above)}"
        return self.argument(node.base) + "'" * node.primes + below + above

    def fenced(self, node: Fenced) -> str:
        body = node.body.accept(_WRITER)
        left, right = (rf"\left{node.left}", rf"\right{node.right}") if node.tall else (node.left, node.right)
        return _joined(_joined(left, body), right)

    def table(self, node: Table) -> str:
        aligned = node.environment == "aligned"
        between = " &" if aligned else " & "
        lines = [between.join(cell.accept(self) for cell in row) for row in node.rows]
        lines = [line.lstrip() if row[-1].items else line.strip() for line, row in zip(lines, node.rows, strict=True)]
        for index in node.rules:
            lines[index : index + 1] = [_joined(r"\hline ", *lines[index : index + 1])]
        columns = f"{{{node.columns}}}" if node.columns else ""
        body = (" \\\\\n" if aligned else r" \\ ").join(lines)
        body = f"\n{body}\n" if aligned else body
        return rf"\begin{{{node.environment}}}{columns}{body}\end{{{node.environment}}}"

    def accent(self, node: Accent) -> str:
        return self._command(node.command, node.body)

    def stacked(self, node: Stacked) -> str:
        return self._command(node.command, node.mark, node.base)

    def styled(self, node: Styled) -> str:
        return self._command(node.command, node.body)

    def _command(self, command: str, *arguments: Node) -> str:
        written = command
        for argument in arguments:
            written = _joined(written, self.argument(argument))
        return written


_OPERAND, _BRACKETED, _FUNCTION, _TEXT, _INFIX, _PREFIX, _COMMA, _COLON, _OTHER = "xbft=-,:o"
_SPACES = _WIDE, _NARROW = "sn"
_LEAVES: dict[type[Node], Callable[[Any], str]] = {
    Number: attrgetter("digits"),
    Symbol: attrgetter("name"),
    Operator: attrgetter("sign"),
    Space: attrgetter("command"),
}
"""What most items are, written without asking the visitor."""

_KINDS: dict[type[Node], str] = {Fenced: _BRACKETED, Table: _BRACKETED, Function: _FUNCTION, Text: _TEXT}
_KINDS_OF_SIGNS = {**dict.fromkeys(v.RELATIONS | v.BINARY, _INFIX), ":": _COLON, ",": _COMMA}


def _kind(item: Node) -> str:
    """Return what decides the blanks around an item, as a letter."""
    if type(item) is Operator:
        return _KINDS_OF_SIGNS.get(item.sign, _OTHER)
    if type(item) is Space:
        return _NARROW if item.command in {r"\,", r"\!"} else _WIDE
    return _KINDS.get(type(item), _OPERAND)


def _is_apart(before: str, kind: str) -> bool:
    """Whether a blank stands between items of two kinds."""
    if before in (_PREFIX, _NARROW) or kind in _SPACES:
        return False
    if before == _WIDE:
        return True
    if kind in {_COLON, _COMMA}:
        return False
    if {before, kind} & {_INFIX, _TEXT} or before == _COLON:
        return True
    return before == _FUNCTION and kind in {_OPERAND, _FUNCTION, _PREFIX}


_ALL = "xbft=-,:osn"
_APART = frozenset(before + kind for before in _ALL for kind in _ALL if _is_apart(before, kind))


def _joined(*pieces: str) -> str:
    written = pieces[0]
    for piece in pieces[1:]:
        written += f" {piece}" if _runs_into(written, piece) else piece
    return written


def _runs_into(written: str, piece: str) -> bool:
    """Whether a letter would become part of the command before it."""
    return piece[:1].isalpha() and written[-1:].isalpha() and written.rstrip(ascii_letters).endswith("\\")


_WRITER, _IN_INDEX = LatexWriter(), LatexWriter(index=True)


def latex(node: Node) -> str:
    """Return a tree as LaTeX, without dollar signs."""
    written = node.accept(_WRITER)
    if isinstance(node, Row):
        note_written(written, node)
    return written
