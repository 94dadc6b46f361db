r"""The visitor that writes a tree as typst: signs are escaped or quoted, so that nothing in it is typst's own markup.

Brackets and bars are as high as the tree says, not as typst would make them, and blanks stand only between letters,
since next to words typst would print them.
"""

from __future__ import annotations

from collections.abc import Iterator

from solver.formula import vocabulary as v
from solver.formula.building import walk
from solver.formula.mathml.characters import character
from solver.formula.mathml.drawing import WIDTHS
from solver.formula.mathml.rows import LIMIT_NAMES, bars
from solver.formula.mathml.tables import FENCES
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
from solver.formula.typst.leaves import (
    ACCENTS,
    ALPHABETS,
    CLASSES,
    LONG,
    NOTHING,
    STYLES,
    THIN,
    call,
    classed,
    escaped,
    joined,
    operand,
    quoted,
)


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
        return escaped(letter) if len(letter) == 1 else call("op", quoted(letter))

    def operator(self, node: Operator) -> str:
        return self._operator(node)

    def _operator(self, node: Operator, kind: str = "") -> str:
        if node.sign in LONG:  # with more space around them than relations have
            return f"#h(0.278em){LONG[node.sign]}#h(0.278em)"
        kind = kind or CLASSES.get(node.sign, "")
        written = escaped(character(node.sign))
        return classed(kind, written) if kind else written

    def function(self, node: Function) -> str:
        words = quoted(node.name.replace("-", "‑"))
        return call("op", words, *["limits: #true"] * (node.name in LIMIT_NAMES and not node.named))

    def text(self, node: Text) -> str:
        words = quoted(node.words)
        if node.command == r"\textbf":
            return f"#text(weight: 700, {words})"
        return f"#text(style: {quoted('italic')}, {words})" if node.command == r"\textit" else words

    def space(self, node: Space) -> str:
        return f"#h({WIDTHS[node.command]:g}em)" if node.command in WIDTHS else ""

    def row(self, node: Row) -> str:
        """Return what stands in the row; a change of size holds from where it stands to the end."""
        pieces: list[str] = []
        forms = bars(node.items) if any(isinstance(_base(item), Operator) for item in node.items) else {}
        for place, item in enumerate(node.items):
            if isinstance(item, Space) and item.command in STYLES:
                rest = Row(node.items[place + 1 :]).accept(self)
                return joined((*pieces, call(STYLES[item.command], rest)))
            if place and not self.tight and _apart(node.items[place - 1], item):
                pieces.append(THIN)
            pieces.append(self._item(node, place, forms.get(place, "")))
        return joined(pieces) or NOTHING

    def _item(self, row: Row, place: int, form: str) -> str:
        item = row.items[place]
        if self.in_line and any(map(_is_tall, walk(item))):
            return call("roomy", WRITER._item(row, place, form))
        if form:
            kind = {"prefix": "opening", "postfix": "closing"}[form]
            return self._scripted(item, kind) if isinstance(item, Scripts) else self._kind(item, kind)
        if place and is_prefix(row.items, place):
            return self._kind(item, "unary")
        if isinstance(item, Row):  # a group in braces is as an operand
            return classed("normal", item.accept(self))
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
        written = call(name, self.argument(node.above), self.argument(node.below))
        return call(STYLES[node.command], written) if node.command in STYLES else written

    def root(self, node: Root) -> str:
        radicand = self.argument(node.radicand)
        return call("sqrt", radicand) if node.index is None else call("root", self.argument(node.index), radicand)

    def scripts(self, node: Scripts) -> str:
        return self._scripted(node)

    def _scripted(self, node: Scripts, kind: str = "") -> str:
        base = self._kind(node.base, kind) if kind else node.base.accept(self)
        if isinstance(node.base, Operator) and node.base.sign not in v.LARGE:
            base = call("scripts", base)  # a relation would have them above and below
        below = [] if node.below is None else [f"b: {_IN_SCRIPT.argument(node.below)}"]
        above = [] if node.above is None else [f"t: {_IN_SCRIPT.argument(node.above)}"]
        primes = [f"tr: primes(#{node.primes})"] * bool(node.primes)
        written = call("attach", base, *above, *below, *primes)
        return classed(kind, written) if kind else written

    def fenced(self, node: Fenced) -> str:
        body = node.body.accept(self) if node.body.items else ""
        left, right = self._bracket(node.left, "opening"), self._bracket(node.right, "closing")
        if not node.tall:
            return joined((left, body, right))
        if not left or not right:  # lest what stands at that end grows
            body = joined(("#h(0pt)" * (not left), body, "#h(0pt)" * (not right)))
        return call("lr", joined((left, body, right)))

    def _bracket(self, sign: str, kind: str) -> str:
        return "" if sign == "." else classed(kind, escaped(character(sign)))

    def table(self, node: Table) -> str:
        if node.environment == "aligned":
            return self._lines_within(node)
        width = max(map(len, node.rows))
        sides = ["l"] * width if node.environment == "cases" else list(node.columns.replace("|", "")) or ["c"] * width
        cells = [[self._cell(cell, side) for cell, side in zip(row, sides, strict=False)] for row in node.rows]
        rows = "; ".join(", ".join(row + [NOTHING] * (width - len(row))) for row in cells)
        delimiters = FENCES.get(node.environment)
        around = "#none" if delimiters is None else f"#({quoted(delimiters[0])}, {quoted(delimiters[1])})"
        lines = self._lines(node)
        roomy = lines or any(_is_tall(part) for row in node.rows for cell in row for part in walk(cell))
        options = [f"delim: {around}", *lines, *["row-gap: #0.8em"] * bool(roomy)]
        written = f"mat({', '.join(options)}, {rows})"
        if node.environment == "cases":
            return call("lr", joined((classed("opening", r"\{"), call("display", written), "#h(0pt)")))
        return call("inline" if node.environment == "smallmatrix" else "display", written)  # cells are a size smaller

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
            cells = [call("display", operand(side) if column % 2 else side) for column, side in enumerate(sides)]
            lines.append(", ".join(f"& {cell}" if column % 2 else f"{cell} &" for column, cell in enumerate(cells)))
        return call("display", f"mat(delim: #none, column-gap: #0em, {'; '.join(lines)})")

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
        return [f"augment: #({', '.join([*drawn, 'stroke: 0.5pt'])})"]

    def accent(self, node: Accent) -> str:
        body = self.argument(node.body)
        if node.command in ACCENTS:
            size = [] if node.command.startswith(r"\wide") else ["size: #0%"] * (node.command in {r"\hat", r"\tilde"})
            return call("accent", body, f'#"\\u{{{ACCENTS[node.command]}}}"', *size)
        return call(node.command[1:], body)

    def stacked(self, node: Stacked) -> str:
        where = "t" if node.command == r"\overset" else "b"
        return call("attach", call("limits", node.base.accept(self)), f"{where}: {self.argument(node.mark)}")

    def styled(self, node: Styled) -> str:
        if node.command == r"\boxed":
            return call("framed", node.body.accept(self))
        if node.command == r"\mathbf":
            return call("upright", call("bold", self.argument(node.body)))
        return self._word(node) or call(ALPHABETS[node.command], self.argument(node.body))

    def _word(self, node: Styled) -> str:
        """Return letters and digits in an upright alphabet as a word, which is closer set than a product."""
        letters = node.body.items if isinstance(node.body, Row) else (node.body,)
        signs = [letter.name if isinstance(letter, Symbol) else getattr(letter, "digits", "") for letter in letters]
        word = "".join(signs)
        is_word = node.command == r"\mathrm" and word.isalnum() and all(signs) and len(word) > 1
        return quoted(word) if is_word else ""


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


def _is_tall(node: Node) -> bool:
    return isinstance(node, Table) or (isinstance(node, Fraction) and node.command == r"\dfrac")


WRITER, IN_LINE, _IN_SCRIPT = TypstWriter(), TypstWriter(in_line=True), TypstWriter(script=True)
