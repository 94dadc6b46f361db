r"""Trees written as typst: every sign escaped or quoted, so that nothing in a formula is typst's own markup.

Brackets and bars are as high as the tree says, not as typst would make them, and blanks stand only between letters,
since next to words typst would print them. The document that holds a formula begins with `PRELUDE`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from solver.formula import vocabulary as v
from solver.formula.building import walk
from solver.formula.mathml.characters import character
from solver.formula.mathml.rows import LIMIT_NAMES, bars
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
from solver.formula.signs import is_prefix

PRELUDE = """\
#let framed(body) = box(stroke: 0.5pt, inset: (x: 0.4em, y: 0.4em), { set par(leading: 0pt); math.equation(body) })
#let roomy(body) = box(inset: (y: 0.55em), math.equation(body))
#set math.mat(row-gap: 0.55em, column-gap: 0.9em)
"""
"""A frame and room, which typst's formulas do not have, and how far apart the cells of matrices stand."""

ACCENTS = {
    **{r"\dot": "0307", r"\ddot": "0308", r"\dddot": "20db", r"\bar": "0304", r"\hat": "0302", r"\widehat": "0302"},
    **{r"\tilde": "0303", r"\widetilde": "0303", r"\vec": "20d7", r"\check": "030c"},
}
"""The code points of marks; what is missing here is a line."""

ALPHABETS = {
    **{r"\mathrm": "upright", r"\mathit": "italic", r"\mathsf": "sans", r"\mathtt": "mono", r"\mathbb": "bb"},
    **{r"\mathcal": "cal", r"\mathfrak": "frak", r"\boldsymbol": "bold"},
}
SPACES = {
    **{r"\,": 0.1667, r"\thinspace": 0.1667, r"\!": -0.1667, r"\:": 0.2222, r"\;": 0.2778, r"\ ": 0.25},
    **{r"\enspace": 0.5, r"\quad": 1.0, r"\qquad": 2.0},
}
"""Of gaps, in em."""

STYLES = {r"\displaystyle": "display", r"\textstyle": "inline", r"\dfrac": "display", r"\tfrac": "inline"}
FENCES = {"pmatrix": "()", "bmatrix": "[]", "Bmatrix": "{}", "vmatrix": "||", "Vmatrix": "‖‖"}
CLASSES = {"/": "normal", ".": "normal", r"\colon": "punctuation"}
"""Signs that TeX spaces otherwise than Unicode says."""

LONG = {r"\iff": "⟺", r"\implies": "⟹"}
NOTHING = '""'


_MARKUP = re.compile(r"[!-/:-@\[-`{-~⟨⟩⌊⌋⌈⌉]")
"""Signs of ASCII, and brackets, of which typst looks for partners."""

THIN = "#h(0.1667em)"


class TypstWriter(Visitor[str]):
    """Writes a tree as what stands between the dollar signs.

    In a script nothing keeps its distance; what is tall `in_line` gets room, which typst takes from the lines around.
    """

    def __init__(self, *, script: bool = False, in_line: bool = False) -> None:
        self.tight = script
        self.in_line = in_line

    def number(self, node: Number) -> str:
        return node.digits

    def symbol(self, node: Symbol) -> str:
        letter = character(node.name)
        return _sign(letter) if len(letter) == 1 else _call("op", _quoted(letter))

    def operator(self, node: Operator) -> str:
        return self._operator(node)

    def _operator(self, node: Operator, kind: str = "") -> str:
        if node.sign in LONG:  # with more space around them than relations have
            return f"#h(0.2778em){LONG[node.sign]}#h(0.2778em)"
        kind = kind or CLASSES.get(node.sign, "")
        sign = _sign(character(node.sign))
        return _classed(kind, sign) if kind else sign

    def function(self, node: Function) -> str:
        words = _quoted(node.name.replace("-", "‑"))
        return _call("op", words, *["limits: #true"] * (node.name in LIMIT_NAMES and not node.named))

    def text(self, node: Text) -> str:
        words = _quoted(node.words)
        if node.command == r"\textbf":
            return f"#text(weight: 700, {words})"
        return f"#text(style: {_quoted('italic')}, {words})" if node.command == r"\textit" else words

    def space(self, node: Space) -> str:
        return f"#h({SPACES[node.command]:g}em)" if node.command in SPACES else ""

    def row(self, node: Row) -> str:
        """Return what stands in the row; a change of size holds from where it stands to the end."""
        pieces: list[str] = []
        forms = bars(node.items) if any(isinstance(_base(item), Operator) for item in node.items) else {}
        for place, item in enumerate(node.items):
            if isinstance(item, Space) and item.command in STYLES:
                rest = Row(node.items[place + 1 :]).accept(self)
                return _joined((*pieces, _call(STYLES[item.command], rest)))
            if place and not self.tight and _apart(node.items[place - 1], item):
                pieces.append(THIN)
            pieces.append(self._item(node, place, forms.get(place, "")))
        return _joined(pieces) or NOTHING

    def _item(self, row: Row, place: int, form: str) -> str:
        item = row.items[place]
        if self.in_line and any(map(_is_tall, walk(item))):
            return _call("roomy", _WRITER._item(row, place, form))
        if form:
            kind = {"prefix": "opening", "postfix": "closing"}[form]
            return self._scripted(item, kind) if isinstance(item, Scripts) else self._kind(item, kind)
        if place and is_prefix(row.items, place):
            return self._kind(item, "unary")
        if isinstance(item, Row):  # a group in braces is as an operand
            return _classed("normal", item.accept(self))
        return item.accept(self)

    def _kind(self, item: Node, kind: str) -> str:
        return self._operator(item, kind) if isinstance(item, Operator) else item.accept(self)

    def argument(self, node: Node) -> str:
        """Return an argument or a script; a sign alone has no space around it."""
        items = node.items if isinstance(node, Row) else (node,)
        if len(items) == 1 and isinstance(items[0], Operator) and items[0].sign not in v.LARGE:
            return self._operator(items[0], "normal")
        return node.accept(self)

    def fraction(self, node: Fraction) -> str:
        name = "binom" if node.command == r"\binom" else "frac"
        written = _call(name, self.argument(node.above), self.argument(node.below))
        return _call(STYLES[node.command], written) if node.command in STYLES else written

    def root(self, node: Root) -> str:
        radicand = self.argument(node.radicand)
        return _call("sqrt", radicand) if node.index is None else _call("root", self.argument(node.index), radicand)

    def scripts(self, node: Scripts) -> str:
        return self._scripted(node)

    def _scripted(self, node: Scripts, kind: str = "") -> str:
        base = self._kind(node.base, kind) if kind else node.base.accept(self)
        if isinstance(node.base, Operator) and node.base.sign not in v.LARGE:
            base = _call("scripts", base)  # a relation would have them above and below
        below = [] if node.below is None else [f"b: {_IN_SCRIPT.argument(node.below)}"]
        above = [] if node.above is None else [f"t: {_IN_SCRIPT.argument(node.above)}"]
        primes = [f"tr: primes(#{node.primes})"] * bool(node.primes)
        written = _call("attach", base, *above, *below, *primes)
        return _classed(kind, written) if kind else written

    def fenced(self, node: Fenced) -> str:
        body = node.body.accept(self) if node.body.items else ""
        left, right = self._bracket(node.left, "opening"), self._bracket(node.right, "closing")
        if not node.tall:
            return _joined((left, body, right))
        if not left or not right:  # lest what stands at that end grows
            body = _joined(("#h(0pt)" * (not left), body, "#h(0pt)" * (not right)))
        return _call("lr", _joined((left, body, right)))

    def _bracket(self, sign: str, kind: str) -> str:
        return "" if sign == "." else _classed(kind, _sign(character(sign)))

    def table(self, node: Table) -> str:
        if node.environment == "aligned":
            return self._lines_within(node)
        width = max(map(len, node.rows))
        sides = ["l"] * width if node.environment == "cases" else list(node.columns.replace("|", "")) or ["c"] * width
        cells = [[self._cell(cell, side) for cell, side in zip(row, sides, strict=False)] for row in node.rows]
        rows = "; ".join(", ".join(row + [NOTHING] * (width - len(row))) for row in cells)
        delimiters = FENCES.get(node.environment)
        quoted = "#none" if delimiters is None else f"#({_quoted(delimiters[0])}, {_quoted(delimiters[1])})"
        options = [f"delim: {quoted}", *self._lines(node)]
        written = f"mat({', '.join(options)}, {rows})"
        if node.environment == "cases":
            return _call("lr", _joined((_classed("opening", r"\{"), _call("display", written), "#h(0pt)")))
        return _call("inline" if node.environment == "smallmatrix" else "display", written)  # cells are a size smaller

    def equations(self, node: Table) -> str:
        """Return aligned equations as lines of a displayed formula."""
        return r" \ ".join(" & ".join(self._sides(row)) or NOTHING for row in node.rows)

    def _sides(self, row: tuple[Row, ...]) -> Iterator[str]:
        """Yield the sides of equations that stand beside each other, pairs of them apart."""
        for column, cell in enumerate(row):
            written = cell.accept(self) if cell.items else ""
            yield f"#h(2em){written}" if column and column % 2 == 0 else written

    def _lines_within(self, node: Table) -> str:
        """Return aligned equations as part of a line: a matrix without brackets, since typst breaks no part of one."""
        width = max(map(len, node.rows))
        lines = []
        for row in node.rows:
            sides = [*self._sides(row), *[""] * (width - len(row))]
            cells = [_call("display", _operand(side) if column % 2 else side) for column, side in enumerate(sides)]
            lines.append(", ".join(f"& {cell}" if column % 2 else f"{cell} &" for column, cell in enumerate(cells)))
        return _call("display", f"mat(delim: #none, column-gap: #0em, {'; '.join(lines)})")

    def _cell(self, cell: Row, side: str) -> str:
        written = self.argument(cell)
        return {"l": f"& {written}", "r": f"{written} &"}.get(side, written)

    def _lines(self, node: Table) -> list[str]:
        """Return the lines between rows and columns; typst draws none outside of them."""
        letters = [place for place, sign in enumerate(node.columns) if sign != "|"]
        beside = [number for number, place in enumerate(letters) if number and node.columns[place - 1] == "|"]
        above = [place for place in node.rules if 0 < place < len(node.rows)]
        if not beside and not above:
            return []
        drawn = [f"{name}: ({', '.join(map(str, at))},)" for name, at in (("hline", above), ("vline", beside)) if at]
        return [f"augment: #({', '.join([*drawn, 'stroke: 0.5pt'])})", "row-gap: #0.8em"]

    def accent(self, node: Accent) -> str:
        body = self.argument(node.body)
        if node.command in ACCENTS:
            size = [] if node.command.startswith(r"\wide") else ["size: #0%"] * (node.command in {r"\hat", r"\tilde"})
            return _call("accent", body, f'#"\\u{{{ACCENTS[node.command]}}}"', *size)
        return _call(node.command[1:], body)

    def stacked(self, node: Stacked) -> str:
        where = "t" if node.command == r"\overset" else "b"
        return _call("attach", _call("limits", node.base.accept(self)), f"{where}: {self.argument(node.mark)}")

    def styled(self, node: Styled) -> str:
        if node.command == r"\boxed":
            return _call("framed", node.body.accept(self))
        if node.command == r"\mathbf":
            return _call("upright", _call("bold", self.argument(node.body)))
        return self._word(node) or _call(ALPHABETS[node.command], self.argument(node.body))

    def _word(self, node: Styled) -> str:
        """Return letters and digits in an upright alphabet as a word, which is closer set than a product."""
        letters = node.body.items if isinstance(node.body, Row) else (node.body,)
        signs = [letter.name if isinstance(letter, Symbol) else getattr(letter, "digits", "") for letter in letters]
        word = "".join(signs)
        is_word = node.command == r"\mathrm" and word.isalnum() and all(signs) and len(word) > 1
        return _quoted(word) if is_word else ""


def _base(node: Node) -> Node:
    return node.base if isinstance(node, Scripts) else node


def _apart(left: Node, right: Node) -> bool:
    """Whether a matrix or tall brackets keep a thin space from what they multiply, as in TeX; arguments do not."""
    before, after = _base(left), _base(right)
    if isinstance(after, Fenced) and isinstance(before, Symbol | Function):
        return False
    kinds = (Operator, Space, Text)
    return (_is_inner(before) and not isinstance(after, kinds)) or (_is_inner(after) and not isinstance(before, kinds))


def _is_inner(node: Node) -> bool:
    return isinstance(node, Fenced) and node.tall if not isinstance(node, Table) else node.environment in FENCES


def _sign(letter: str) -> str:
    """Return a character as itself: what typst could read as its own markup, or pair, after a backslash."""
    return f"\\{letter}" if _MARKUP.match(letter) else letter


def _quoted(words: str) -> str:
    return '"' + words.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _operand(side: str) -> str:
    """Return the right side of an equation behind an empty operand, which gives its sign the space of a relation."""
    return _classed("normal", NOTHING) + side


def _call(name: str, *arguments: str) -> str:
    return f"{name}({', '.join(argument or NOTHING for argument in arguments)})"


def _classed(kind: str, sign: str) -> str:
    return _call("class", _quoted(kind), sign)


def _joined(pieces: Iterable[str]) -> str:
    """Put pieces side by side, with a blank only where they would become one name or number."""
    written = ""
    for piece in pieces:
        written += f" {piece}" if _in_a_name(written[-1:]) and _in_a_name(piece[:1]) else piece
    return written


def _in_a_name(sign: str) -> bool:
    """Whether a sign may be part of a name, as a letter and the dot of a product are."""
    return bool(sign) and f"x{sign}".isidentifier()


def _is_tall(node: Node) -> bool:
    return isinstance(node, Table) or (isinstance(node, Fraction) and node.command == r"\dfrac")


_WRITER, _IN_SCRIPT, _IN_LINE = TypstWriter(), TypstWriter(script=True), TypstWriter(in_line=True)


def typst(node: Node, *, in_line: bool = False) -> str:
    """Return a tree as typst's formula, without dollar signs; equations alone in it as the lines of a display."""
    match node:
        case Row((Table("aligned") as table,)) if not in_line:
            return _WRITER.equations(table)
    return node.accept(_IN_LINE if in_line else _WRITER)
