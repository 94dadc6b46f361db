"""The visitor that draws a tree as text: each node becomes pieces, and pieces side by side a box."""

from __future__ import annotations

import re

from solver.formula import nodes as n
from solver.formula import vocabulary as v
from solver.formula.terminal.boxes import Box, beside, enclosed, stacked, text_box
from solver.formula.terminal.characters import ACCENTS, CHARACTERS, LETTERS, SPACES, SUPERSCRIPTS
from solver.formula.terminal.layout import ONE_NAME, Atom, accented, fraction_of, spaced, tabular, with_scripts


def box(node: n.Node, display: bool) -> Box:
    """Return the box of a tree; one for display may have several lines."""
    return (_DISPLAY if display else _FLAT).box(node)


class Writer(n.Visitor[list[Atom]]):
    """Draws a tree; `display` says whether what is drawn may stand on several lines."""

    def __init__(self, display: bool) -> None:
        self.display = display

    def box(self, node: n.Node) -> Box:
        """Return what stands in a row, or any other node, as one box."""
        items = node.items if isinstance(node, n.Row) else (node,)
        return beside(spaced([atom for item in items for atom in item.accept(self)]))

    def number(self, node: n.Number) -> list[Atom]:
        return [Atom(text_box(node.digits))]

    def symbol(self, node: n.Symbol) -> list[Atom]:
        return [Atom(text_box(CHARACTERS.get(node.name, node.name.lstrip("\\"))))]

    def operator(self, node: n.Operator) -> list[Atom]:
        return [Atom(text_box(CHARACTERS.get(node.sign, node.sign.lstrip("\\"))), _kind(node.sign))]

    def function(self, node: n.Function) -> list[Atom]:
        return [Atom(text_box(node.name), "operator")]

    def text(self, node: n.Text) -> list[Atom]:
        return [Atom(text_box(node.words), "label" if node.words.endswith(":") else "text")]

    def space(self, node: n.Space) -> list[Atom]:
        return [Atom(text_box(SPACES[node.command]), "space")] if node.command in SPACES else []

    def row(self, node: n.Row) -> list[Atom]:
        return [Atom(self.box(node))]

    def fraction(self, node: n.Fraction) -> list[Atom]:
        above, below = self.box(node.above), self.box(node.below)
        if node.command != r"\binom":
            return [Atom(fraction_of(above, below, self.display), "fraction")]
        column = stacked([above, below], above.height) if self.display else beside([above, text_box(" "), below])
        return [Atom(enclosed(column, "(", ")"), "closing")]

    def root(self, node: n.Root) -> list[Atom]:
        index = "" if node.index is None else _FLAT.box(node.index).flat
        sign = text_box("".join(SUPERSCRIPTS.get(letter, letter) for letter in index) + "√")
        content = self.box(node.radicand)
        if content.height > 1 or not re.fullmatch(ONE_NAME, content.flat):
            content = enclosed(content, "(", ")")
        return [Atom(beside([sign, content]))]

    def scripts(self, node: n.Scripts) -> list[Atom]:
        *others, base = node.base.accept(self) or [Atom(text_box(""))]
        base = Atom(beside([base.box, text_box("′" * node.primes)]), base.kind) if node.primes else base
        marks = {"_": node.below, "^": node.above}
        drawn = {mark: _FLAT.box(script) for mark, script in marks.items() if script is not None}
        return [*others, with_scripts(base, drawn, self.display) if drawn else base]

    def fenced(self, node: n.Fenced) -> list[Atom]:
        left, right = (CHARACTERS.get(bracket, bracket) for bracket in (node.left, node.right))
        if node.tall:
            return [Atom(enclosed(self.box(node.body), left, right), "closing")]
        inside = [atom for item in node.body.items for atom in item.accept(self)]
        return [Atom(text_box(left), "opening"), *inside, Atom(text_box(right), "closing")]

    def table(self, node: n.Table) -> list[Atom]:
        count = max(len(row) for row in node.rows)
        rows = [[self.box(cell) for cell in row] + [text_box("")] * (count - len(row)) for row in node.rows]
        return [Atom(tabular(node.environment, node.columns, rows, self.display, node.rules))]

    def accent(self, node: n.Accent) -> list[Atom]:
        return [Atom(accented(self.box(node.body), ACCENTS.get(node.command, "")))]

    def stacked(self, node: n.Stacked) -> list[Atom]:
        base, mark = self.box(node.base), _FLAT.box(node.mark)
        if not self.display:
            return [with_scripts(Atom(base), {"^" if node.command == r"\overset" else "_": mark}, False)]
        above = node.command == r"\overset"
        return [Atom(stacked([mark, base] if above else [base, mark], mark.height if above else 0), "relation")]

    def styled(self, node: n.Styled) -> list[Atom]:
        if node.command == r"\boxed":
            return [Atom(self.box(node.body))]
        text = _FLAT.box(node.body).flat
        alphabet = LETTERS.get(node.command, {})
        word = len(text) > 1 and not alphabet
        return [
            Atom(text_box("".join(alphabet.get(letter, letter) for letter in text)), "word" if word else "ordinary")
        ]


def _kind(sign: str) -> str:
    """Return how a sign is spaced."""
    if sign in v.BINARY:
        return "binary"
    if sign in v.RELATIONS:
        return "relation"
    if sign in v.BRACKETS:
        return "opening" if sign in v.PAIRS else "closing"
    return "comma" if sign in ",;" else "ordinary"


_DISPLAY, _FLAT = Writer(display=True), Writer(display=False)
