"""The visitor that draws a tree as text: each node becomes pieces, and pieces side by side a box."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache

from solver.formula import nodes as n
from solver.formula import vocabulary as v
from solver.formula.terminal.boxes import Box, beside, enclosed, stacked, text_box
from solver.formula.terminal.characters import ACCENTS, CHARACTERS, LETTERS, SPACES, SUPERSCRIPTS
from solver.formula.terminal.layout import ONE_NAME, Atom, accented, fraction_of, spaced, tabular, with_scripts


def box(node: n.Node, display: bool) -> Box:
    """Return the box of a tree; one for display may have several lines."""
    return (_DISPLAY if display else _FLAT).box(node)


class Writer(n.Visitor[Sequence[Atom]]):
    """Draws a tree; `display` says whether what is drawn may stand on several lines."""

    keeps = True  # exponents and denominators are those of many terms

    def __init__(self, display: bool) -> None:
        self.display = display

    def box(self, node: n.Node) -> Box:
        """Return what stands in a row, or any other node, as one box."""
        atoms = node.accept(self)
        return atoms[0].box if isinstance(node, n.Row) else beside(spaced(atoms))

    def number(self, node: n.Number) -> Sequence[Atom]:
        return _ordinary(node.digits)

    def symbol(self, node: n.Symbol) -> Sequence[Atom]:
        return _ordinary(node.name)

    def operator(self, node: n.Operator) -> Sequence[Atom]:
        return _sign(node.sign)

    def function(self, node: n.Function) -> Sequence[Atom]:
        return [Atom(text_box(node.name), "operator")]

    def text(self, node: n.Text) -> Sequence[Atom]:
        return [Atom(text_box(node.words), "label" if node.words.endswith(":") else "text")]

    def space(self, node: n.Space) -> Sequence[Atom]:
        return [Atom(text_box(SPACES[node.command]), "space")] if node.command in SPACES else []

    def row(self, node: n.Row) -> Sequence[Atom]:
        return (Atom(beside(spaced([atom for item in node.items for atom in item.accept(self)]))),)

    def fraction(self, node: n.Fraction) -> Sequence[Atom]:
        above, below = self.box(node.above), self.box(node.below)
        if node.command != r"\binom":
            return [Atom(fraction_of(above, below, self.display), "fraction")]
        column = stacked([above, below], above.height) if self.display else beside([above, text_box(" "), below])
        return [Atom(enclosed(column, "(", ")"), "closing")]

    def root(self, node: n.Root) -> Sequence[Atom]:
        index = "" if node.index is None else _FLAT.box(node.index).flat
        sign = text_box("".join(SUPERSCRIPTS.get(letter, letter) for letter in index) + "√")
        content = self.box(node.radicand)
        if content.height > 1 or not re.fullmatch(ONE_NAME, content.flat):
            content = enclosed(content, "(", ")")
        return [Atom(beside([sign, content]))]

    def scripts(self, node: n.Scripts) -> Sequence[Atom]:
        *others, base = node.base.accept(self) or [Atom(text_box(""))]
        base = Atom(beside([base.box, text_box("′" * node.primes)]), base.kind) if node.primes else base
        marks = {"_": node.below, "^": node.above}
        drawn = {mark: _FLAT.box(script) for mark, script in marks.items() if script is not None}
        return [*others, with_scripts(base, drawn, self.display) if drawn else base]

    def fenced(self, node: n.Fenced) -> Sequence[Atom]:
        left, right = (CHARACTERS.get(bracket, bracket) for bracket in (node.left, node.right))
        if node.tall:
            return [Atom(enclosed(self.box(node.body), left, right), "closing")]
        inside = [atom for item in node.body.items for atom in item.accept(self)]
        return [Atom(text_box(left), "opening"), *inside, Atom(text_box(right), "closing")]

    def table(self, node: n.Table) -> Sequence[Atom]:
        count = max(len(row) for row in node.rows)
        rows = [[self.box(cell) for cell in row] + [text_box("")] * (count - len(row)) for row in node.rows]
        return [Atom(tabular(node.environment, node.columns, rows, self.display, node.rules))]

    def accent(self, node: n.Accent) -> Sequence[Atom]:
        return [Atom(accented(self.box(node.body), ACCENTS.get(node.command, "")))]

    def stacked(self, node: n.Stacked) -> Sequence[Atom]:
        base, mark = self.box(node.base), _FLAT.box(node.mark)
        if not self.display:
            return [with_scripts(Atom(base), {"^" if node.command == r"\overset" else "_": mark}, False)]
        above = node.command == r"\overset"
        return [Atom(stacked([mark, base] if above else [base, mark], mark.height if above else 0), "relation")]

    def styled(self, node: n.Styled) -> Sequence[Atom]:
        if node.command == r"\boxed":
            return [Atom(self.box(node.body))]
        text = _FLAT.box(node.body).flat
        alphabet = LETTERS.get(node.command, {})
        word = len(text) > 1 and not alphabet
        return [
            Atom(text_box("".join(alphabet.get(letter, letter) for letter in text)), "word" if word else "ordinary")
        ]


@lru_cache(maxsize=1024)
def _ordinary(name: str) -> Sequence[Atom]:
    """Draw a number or a symbol."""
    return (Atom(text_box(CHARACTERS.get(name, name.lstrip("\\")))),)


@lru_cache(maxsize=256)
def _sign(sign: str) -> Sequence[Atom]:
    """Draw a sign."""
    return (Atom(text_box(CHARACTERS.get(sign, sign.lstrip("\\"))), _kind(sign)),)


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
