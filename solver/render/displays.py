"""Displayed equations: `$$ a = b = c $$`, over several lines where one is too narrow."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from solver.formula import latex, read
from solver.formula.building import row, separated
from solver.formula.nodes import Fenced, Node, Operator, Row, Scripts, Space, Symbol, Table
from solver.formula.width import LINE, broken, width

NOTHING = Row()
QUAD = Space(r"\quad")
EQUALS = Operator("=")


def display(tex: str) -> str:
    """Return LaTeX as a displayed formula in Markdown."""
    return f"\n\n$$\n{tex}\n$$\n\n"


def chain(sides: Sequence[Row], relation: Node = EQUALS, note: Row = NOTHING) -> Row:
    """Return `a = b = c`; aligned at the signs, and long sums broken, where it does not fit on a line.

    `note` stands behind the last side. Of sides that look alike in a row, the first two apart, one is shown.
    """
    shown = [side for side in sides if side.items]
    shown = [side for i, side in enumerate(shown) if i < 2 or side != shown[i - 1]]
    line = row(separated(shown, relation), note)
    if len(shown) < 2 or width(line) <= LINE:
        return line
    first, *others = shown
    left = width(first)
    if left > LINE / 2:
        lines = [first, *(row(QUAD, each) for side in others for each in _lines(side, relation, LINE))]
        cells = [(NOTHING, each) for each in lines]
    else:
        cells = [(NOTHING, each) for side in others for each in _lines(side, relation, LINE - left)]
        cells[0] = (first, cells[0][1])
    if len(cells) == 1:
        return line
    cells[-1] = (cells[-1][0], row(cells[-1][1], note))
    return aligned(cells)


READABLE = 1.6
"""A matrix may be this many lines wide: it is shrunk, or scrolls. A wider one is listed entry by entry."""


def entry_name(name: Row, index: str) -> Row:
    r"""Return the name of an entry: \Phi_{11}(t) of \Phi(t), and [name]_{11} of any other."""
    below = row(index)
    match name.items:
        case (Symbol() as letter,):
            return row(Scripts(letter, below))
        case (Symbol() as letter, Fenced("(", Row((Symbol(),))) as argument):
            return row(Scripts(letter, below), argument)
    return row(Scripts(Fenced("[", name, "]", tall=True), below))


def entries(name: Row, stated: Sequence[Row], cells: Sequence[Sequence[Row]]) -> Row:
    """Return the entries of a matrix one under the other, Φ_{11} = ..., below Φ = `stated`."""
    single = len(cells) == 1 or len(cells[0]) == 1
    lines = [(name, row(EQUALS, side)) for side in stated]
    for i, cells_of_row in enumerate(cells, 1):
        for j, cell in enumerate(cells_of_row, 1):
            index = (
                f"{max(i, j)}" if single else f"{i}{j}" if len(cells) < 10 and len(cells_of_row) < 10 else f"{i},{j}"
            )
            first, *others = broken(cell, LINE - width(name) - 3)
            lines += [(entry_name(name, index), row(EQUALS, first)), *((NOTHING, row(QUAD, line)) for line in others)]
    return aligned(lines)


def _lines(side: Row, relation: Node, room: float) -> list[Row]:
    first, *others = broken(side, room)
    return [row(relation, first), *(row(QUAD, line) for line in others)]


def aligned(lines: Iterable[tuple[Row, ...]]) -> Row:
    """Return lines, each in cells between which it is aligned, as one block."""
    return row(Table("aligned", tuple(lines)))


TALLEST = 28
"""Rows of aligned equations that fit on a page; more are several displays, since no page breaks one of ours."""


def on_pages(formula: str) -> list[tuple[Row, str]]:
    """Return LaTeX of a displayed formula as trees that fit on a page each, with their LaTeX."""
    found = read(formula)
    match found.items:
        case (Table("aligned", rows),) if len(rows) > TALLEST:
            count = -(-len(rows) // TALLEST)
            size = -(-len(rows) // count)
            blocks = [aligned(rows[i : i + size]) for i in range(0, len(rows), size)]
            return [(block, latex(block)) for block in blocks]
    return [(found, formula)]
