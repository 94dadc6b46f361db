"""How wide a formula will be, roughly, and where a long one can be broken."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import zip_longest

from solver.formula import nodes as n
from solver.formula.building import TIMES
from solver.formula.signs import is_prefix

LINE = 76.0
"""Width, in letters, of what fits on a line of a page."""

FULL_SIZE = 1.4
"""Letters of a fraction in a matrix that is not made small, against one that is."""

_WIDTHS = {
    **dict.fromkeys(("=", "+", "-", r"\approx", r"\le", r"\ge"), 2.0),
    **{r"\quad": 2.0, r"\qquad": 4.0, r"\,": 0.3, r"\;": 0.6, r"\ ": 0.5, r"\!": 0.0, r"\displaystyle": 0.0},
}
"""Of signs and spaces, in letters; of what is not listed, 1."""


class _Widths(n.Visitor[float]):
    """Adds up widths in letters; the tallest part decides nothing."""

    keeps = True  # line breaking asks for a side, for the line, for its terms

    def number(self, node: n.Number) -> float:
        return float(len(node.digits))

    def symbol(self, node: n.Symbol) -> float:  # noqa: ARG002 - all are as wide
        return 1.0

    def operator(self, node: n.Operator) -> float:
        return _WIDTHS.get(node.sign, 1.0)

    def function(self, node: n.Function) -> float:
        return float(len(node.name))

    def text(self, node: n.Text) -> float:
        return float(len(node.words.replace(" ", "")))

    def space(self, node: n.Space) -> float:
        return _WIDTHS.get(node.command, 1.0)

    def row(self, node: n.Row) -> float:
        total = 0.0
        for item in node.items:  # a sum over a generator takes half as long again
            total += item.accept(self)
        return total

    def fraction(self, node: n.Fraction) -> float:
        size = FULL_SIZE if node.command == r"\dfrac" else 1.0
        return size * max(node.above.accept(self), node.below.accept(self)) + 0.4

    def root(self, node: n.Root) -> float:
        return 1.0 + node.radicand.accept(self) + (node.index.accept(self) if node.index else 0.0)

    def scripts(self, node: n.Scripts) -> float:
        scripts = sum(0.7 * script.accept(self) for script in (node.below, node.above) if script is not None)
        return node.base.accept(self) + scripts + node.primes

    def fenced(self, node: n.Fenced) -> float:
        return node.body.accept(self) + 2.0

    def table(self, node: n.Table) -> float:
        cells = [[cell.accept(self) for cell in row] for row in node.rows]
        columns = [max(column) for column in zip_longest(*cells, fillvalue=0.0)]
        return sum(columns) + 1.6 * len(columns)

    def accent(self, node: n.Accent) -> float:
        return 1.0 + node.body.accept(self)

    def stacked(self, node: n.Stacked) -> float:
        return max(node.base.accept(self), node.mark.accept(self))

    def styled(self, node: n.Styled) -> float:
        return node.body.accept(self)


_WIDTHS_OF_NODES = _Widths()


def width(node: n.Node) -> float:
    """Return the width of a formula in letters."""
    return node.accept(_WIDTHS_OF_NODES)


def broken(formula: n.Row, room: float = LINE) -> list[n.Row]:
    """Break a long list behind its commas, a long sum before its signs, a long product of matrices before a matrix.

    The lines fit into `room` where they can. Each line but the first begins with the sign it was broken at.
    """
    if width(formula) <= room:
        return [formula]
    lines = [line for item in _filled(list(_items(formula)), room) for line in _filled(list(_terms(item)), room)]
    return [piece for line in lines for piece in _filled(list(_factors(line)), room, TIMES)]


def _filled(pieces: Sequence[n.Row], room: float, *seam: n.Node) -> list[n.Row]:
    """Put as many pieces on each line as fit; further lines begin with the seam. Widths in a row add up."""
    begun = sum(map(width, seam))
    lines = [[*pieces[0].items]]
    filled = width(pieces[0])
    for piece in pieces[1:]:
        more = width(piece)
        if filled + more > room:
            lines.append([*seam, *piece.items])
            filled = begun + more
        else:
            lines[-1] += piece.items
            filled += more
    return [n.Row(tuple(line)) for line in lines]


def _items(formula: n.Row) -> Iterator[n.Row]:
    """Cut a list behind its commas."""
    start = 0
    for place, item in enumerate(formula.items):
        if isinstance(item, n.Operator) and item.sign == ",":
            yield n.Row(formula.items[start : place + 1])
            start = place + 1
    yield n.Row(formula.items[start:])


def _terms(formula: n.Row) -> Iterator[n.Row]:
    """Cut a formula before each sign between two terms."""
    start = 0
    for place, item in enumerate(formula.items):
        if place and isinstance(item, n.Operator) and item.sign in {"+", "-"} and not is_prefix(formula.items, place):
            yield n.Row(formula.items[start:place])
            start = place
    yield n.Row(formula.items[start:])


def _factors(formula: n.Row) -> Iterator[n.Row]:
    """Cut a formula between matrices that stand side by side."""
    start = 0
    for place in range(1, len(formula.items)):
        if all(isinstance(item, n.Table) for item in formula.items[place - 1 : place + 1]):
            yield n.Row(formula.items[start:place])
            start = place
    yield n.Row(formula.items[start:])
