"""The visitor that draws a tree as MathML: one element for each node, and roughly how wide it will be.

MathML Core dropped lines and alignment of tables, boxes, and all letter shapes but upright; here they are CSS of our
own and the characters of those shapes. Spacing follows TeX: a sign is prefix or binary, a function's name keeps a thin
space, an ordinary symbol is no operator, and signs in scripts are tight.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from html import escape
from itertools import zip_longest

from solver.formula.mathml.characters import character
from solver.formula.mathml.leaves import (
    TIGHT,
    UPRIGHT_LETTERS,
    Drawing,
    number_drawing,
    operator_drawing,
    symbol_drawing,
)
from solver.formula.mathml.rows import LIMIT_NAMES, bars, has_function, is_relation_between_words, thin_space_between
from solver.formula.mathml.tables import FENCES, styles
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

MARKS = {
    **{r"\dot": "˙", r"\ddot": "¨", r"\dddot": "\u20db", r"\bar": "¯"},
    **{r"\hat": "ˆ", r"\widehat": "ˆ", r"\tilde": "˜", r"\widetilde": "˜"},
    **{r"\vec": "→", r"\check": "ˇ", r"\overline": "‾", r"\underline": "‾"},
}
WIDE = {"ˆ": "\u0302", "˜": "\u0303"}
"""Accents of any width: math fonts have long shapes of these characters only."""

STRETCHED = "→‾\u0302\u0303"
DOTLESS = {"i": "𝚤", "j": "𝚥"}
WIDTHS = {
    **{r"\,": 0.167, r"\thinspace": 0.167, r"\!": -0.167, r"\:": 0.222, r"\;": 0.278, r"\ ": 0.25},
    **{r"\enspace": 0.5, r"\quad": 1.0, r"\qquad": 2.0},
}
"""Of spaces, in em."""

STYLES = {r"\displaystyle": "true", r"\textstyle": "false", r"\dfrac": "true", r"\tfrac": "false"}
WORDS = {r"\textbf": ' style="font-weight:bold"', r"\textit": ' style="font-style:italic"'}
BOX = "border:1px solid;padding:0.25em 0.4em"
THIN = '<mspace width="0.167em"></mspace>'


class Drawer(Visitor[Drawing]):
    """Draws a tree; in scripts signs have no space around them, and letters may have a shape."""

    keeps = True  # matrices, exponents and denominators are those of several formulas

    def __init__(self, script: bool = False, shape: str = "") -> None:
        self.tight = script
        self.shape = shape

    def number(self, node: Number) -> Drawing:
        return number_drawing(node.digits, self.shape)

    def symbol(self, node: Symbol) -> Drawing:
        return symbol_drawing(node.name, self.shape)

    def operator(self, node: Operator) -> Drawing:
        return operator_drawing(node.sign, "", self.tight)

    def function(self, node: Function) -> Drawing:
        start = UPRIGHT_LETTERS if len(node.name) == 1 else "<mi>"
        return Drawing(f"{start}{escape(node.name)}</mi>", 0.5 * len(node.name))

    def text(self, node: Text) -> Drawing:
        words = escape(node.words).replace(" ", "\xa0")  # which an element keeps at its ends
        return Drawing(f"<mtext{WORDS.get(node.command, '')}>{words}</mtext>", 0.5 * len(node.words))

    def space(self, node: Space) -> Drawing:
        width = WIDTHS.get(node.command, 0.0)
        return Drawing(f'<mspace width="{width:g}em"></mspace>' if width else "<mrow></mrow>", width)

    def row(self, node: Row) -> Drawing:
        """Return the row as one element."""
        if len(node.items) == 1:
            only = node.items[0]
            if isinstance(only, Operator):
                return operator_drawing(only.sign, "", True)
            if not isinstance(only, Fenced | Space):
                return only.accept(self)
        inside = self.inside(node)
        return Drawing(f"<mrow>{inside.markup}</mrow>", inside.width)

    def inside(self, row: Row, begun: bool = False) -> Drawing:
        """Return what stands in a row, without an element around it; one that has `begun` goes on from before."""
        kinds = set(map(type, row.items))
        upright = Text in kinds and is_relation_between_words(row.items)
        forms = self._forms(row.items, begun) if Operator in kinds else {}
        names = Function in kinds or (Scripts in kinds and has_function(row.items))
        markup, width, end = "", 0.0, ""
        before: Node | None = None
        for place, item in enumerate(row.items):
            if names and thin_space_between(before, item):
                markup, width = markup + THIN, width + 0.167
            if type(item) is Space and item.command in STYLES:
                markup += f'<mstyle displaystyle="{STYLES[item.command]}" scriptlevel="0">'
                end += "</mstyle>"
                continue
            drawn_as, wide = self._formed(item, forms[place]) if place in forms else item.accept(self)
            if upright and drawn_as.startswith("<mtext>"):
                drawn_as = drawn_as.replace("<mtext>", UPRIGHT_LETTERS).replace("mtext>", "mi>")
            markup, width = markup + drawn_as, width + wide
            before = item
        return Drawing(markup + end, width)

    @staticmethod
    def _forms(items: Sequence[Node], begun: bool) -> dict[int, str]:
        """Return the places of signs and bars whose form their neighbours decide, and the form."""
        signs = [i for i, item in enumerate(items) if type(item) is Operator and is_prefix(items, i, begun)]
        return bars(items) | dict.fromkeys(signs, "prefix")

    def _formed(self, item: Node, form: str) -> Drawing:
        """Draw a sign or a bar, perhaps with scripts, in a form that its neighbours decide."""
        if isinstance(item, Operator):
            return operator_drawing(item.sign, form, self.tight)
        if isinstance(item, Scripts) and isinstance(item.base, Operator):
            return self._scripted(item, operator_drawing(item.base.sign, form, self.tight))
        return item.accept(self)

    def fraction(self, node: Fraction) -> Drawing:
        above, below = node.above.accept(self), node.below.accept(self)
        width = max(above.width, below.width) + 0.25
        line = ' linethickness="0"' if node.command == r"\binom" else ""
        markup = f"<mfrac{line}>{above.markup}{below.markup}</mfrac>"
        if line:
            return _fenced("(", Drawing(markup, width), ")", True)
        if node.command in STYLES:
            markup = f'<mstyle displaystyle="{STYLES[node.command]}" scriptlevel="0">{markup}</mstyle>'
        return Drawing(markup, width)

    def root(self, node: Root) -> Drawing:
        if node.index is None:
            under = self.inside(node.radicand) if isinstance(node.radicand, Row) else node.radicand.accept(self)
            return Drawing(f"<msqrt>{under.markup}</msqrt>", under.width + 0.9)
        under, index = node.radicand.accept(self), node.index.accept(_IN_SCRIPT)
        return Drawing(f"<mroot>{under.markup}{index.markup}</mroot>", under.width + 0.7 * index.width)

    def scripts(self, node: Scripts) -> Drawing:
        return self._scripted(node, self._base(node))

    def _base(self, node: Scripts) -> Drawing:
        if isinstance(node.base, Fenced) and not node.base.tall:
            inside = node.base.accept(self)
            return Drawing(f"<mrow>{inside.markup}</mrow>", inside.width)
        if isinstance(node.base, Function) and node.base.name in LIMIT_NAMES and not node.primes:
            return Drawing(f'<mo movablelimits="true"{TIGHT}>{node.base.name}</mo>', 0.5 * len(node.base.name))
        return node.base.accept(self)

    def _scripted(self, node: Scripts, base: Drawing) -> Drawing:
        above = None if node.above is None else node.above.accept(_IN_SCRIPT)
        below = None if node.below is None else node.below.accept(_IN_SCRIPT)
        widest = 0.7 * max(script.width for script in (above, below, Drawing("", 0.0)) if script is not None)
        markup, width = base.markup, base.width + widest
        if above or below:
            limits = "movablelimits" in markup
            tag = "m" + ("under" if limits else "sub") * bool(below) + ("over" if limits else "sup") * bool(above)
            markup += (below.markup if below else "") + (above.markup if above else "")
            markup = f"<{tag}>{markup}</{tag}>"
        if node.primes:  # after the letter: fonts draw them raised already, and too small in a superscript
            primes = {2: "″", 3: "‴"}.get(node.primes, "′" * node.primes)
            markup = f'<mrow>{markup}<mo form="postfix"{TIGHT}>{primes}</mo></mrow>'
            width += 0.9
        return Drawing(markup, width)

    def fenced(self, node: Fenced) -> Drawing:
        left = "" if node.left == "." else character(node.left)
        right = "" if node.right == "." else character(node.right)
        return _fenced(left, self.inside(node.body), right, node.tall, node.left in {r"\lvert", r"\lVert"})

    def table(self, node: Table) -> Drawing:
        aligned = node.environment == "aligned"
        lines, widths = "", []
        for row, row_styles in zip(node.rows, styles(node), strict=True):
            cells = [self.inside(cell, aligned and j % 2 == 1) for j, cell in enumerate(row)]
            cells += [Drawing("", 0.0)] * (len(row_styles) - len(row))
            widths.append([cell.width for cell in cells])
            lines += f"<mtr>{''.join(_cells(node, cells, row_styles))}</mtr>"
        width = sum(0.8 + max(column) for column in zip_longest(*widths, fillvalue=0.0))
        style = ' displaystyle="true"' if aligned else ""
        drawing = Drawing(f"<mtable{style}>{lines}</mtable>", width)
        if node.environment == "smallmatrix":
            return Drawing(f'<mstyle scriptlevel="1">{drawing.markup}</mstyle>', width)
        if node.environment == "cases":
            return _fenced("{", drawing, "", True)
        fences = FENCES.get(node.environment)
        return _fenced(fences[0], drawing, fences[1], True) if fences else drawing

    def accent(self, node: Accent) -> Drawing:
        body = node.body.accept(self)
        mark = MARKS[node.command]
        wide = body.markup.startswith("<mrow")
        mark = WIDE.get(mark, mark) if wide else mark
        attributes = f' stretchy="{"true" if mark in STRETCHED else "false"}"'
        if mark in "˙¨":
            attributes += ' style="padding-bottom:0.08em"'  # else they touch the letter
        tag, kind = ("munder", "accentunder") if node.command == r"\underline" else ("mover", "accent")
        under = body.markup
        for letter, dotless in DOTLESS.items():
            under = under.replace(f"<mi>{letter}</mi>", f"<mi>{dotless}</mi>") if tag == "mover" and not wide else under
        return Drawing(f'<{tag} {kind}="true">{under}<mo{attributes}>{mark}</mo></{tag}>', body.width + 0.25)

    def stacked(self, node: Stacked) -> Drawing:
        base, mark = node.base.accept(self), node.mark.accept(_IN_SCRIPT)
        tag = "mover" if node.command == r"\overset" else "munder"
        return Drawing(f"<{tag}>{base.markup}{mark.markup}</{tag}>", max(base.width, mark.width) + 0.25)

    def styled(self, node: Styled) -> Drawing:
        if node.command == r"\boxed":
            body = node.body.accept(self)
            return Drawing(f'<mrow style="{BOX}">{body.markup}</mrow>', body.width)
        letters = node.body.items if isinstance(node.body, Row) else (node.body,)
        signs = [letter.name if isinstance(letter, Symbol) else getattr(letter, "digits", "") for letter in letters]
        word = "".join(signs)
        if node.command == r"\mathrm" and word.isalnum() and all(signs):  # a word, not a product
            return Drawing(f"{UPRIGHT_LETTERS}{word}</mi>", 0.5 * len(word))
        return node.body.accept(_drawer(self.tight, node.command))


def _cells(table: Table, cells: list[Drawing], row_styles: Sequence[str]) -> Iterator[str]:
    """Yield the cells of a row; an empty operand before a relation at its left gives it the space of one."""
    for column, (cell, style) in enumerate(zip(cells, row_styles, strict=True)):
        operand = "<mi></mi>" if table.environment == "aligned" and column % 2 and cell.markup else ""
        yield f'<mtd style="{style}">' if style else "<mtd>"
        yield f"{operand}{cell.markup}</mtd>"


def _fenced(left: str, body: Drawing, right: str, tall: bool, bars: bool = False) -> Drawing:
    """Put brackets around; tall ones stretch with their row, so they have one of their own."""
    if tall or bars:
        kind = f'<mo stretchy="{"true" if tall else "false"}" fence="true" form='
        before = f'{kind}"prefix">{escape(left)}</mo>' if left else ""
        after = f'{kind}"postfix">{escape(right)}</mo>' if right else ""
    else:
        before, after = f'<mo stretchy="false">{left}</mo>', f'<mo stretchy="false">{right}</mo>'
    markup = f"{before}{body.markup}{after}"
    return Drawing(f"<mrow>{markup}</mrow>" if tall else markup, body.width + 0.4 * (bool(left) + bool(right)))


@lru_cache(maxsize=32)
def _drawer(script: bool, shape: str) -> Drawer:
    """Return one of the few drawers."""
    return Drawer(script, shape)


_DRAWER, _IN_SCRIPT = _drawer(False, ""), _drawer(True, "")


def drawn(node: Node) -> Drawing:
    """Return a tree as MathML, without the element `math` around it."""
    return node.accept(_DRAWER)
