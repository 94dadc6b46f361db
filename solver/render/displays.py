"""Displayed equations: `$$ a = b = c $$`, over several lines where one is too narrow."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from solver.render.width import LINE, broken, width


def display(tex: str) -> str:
    """Return a formula as a displayed one in Markdown."""
    return f"\n\n$$\n{tex}\n$$\n\n"


def chain(sides: Sequence[str], relation: str = "=", note: str = "") -> str:
    """Return `a = b = c` as LaTeX; aligned at the signs, and long sums broken, where it does not fit on a line.

    `note` stands behind the last side.
    """
    shown = [side for side in sides if side]
    line = f" {relation} ".join(shown) + note
    if len(shown) < 2 or width(line) <= LINE:
        return line
    first, *others = shown
    left = width(first)
    if left > LINE / 2:
        rows = [f"&{first}"] + [f"&\\quad {row}" for side in others for row in _rows(side, relation, LINE)]
    else:
        rows = [f"&{row}" for side in others for row in _rows(side, relation, LINE - left)]
        rows[0] = first + rows[0]
    if len(rows) == 1:
        return line
    return aligned([*rows[:-1], rows[-1] + note])


READABLE = 1.6
"""A matrix may be this many lines wide: it is shrunk, or scrolls. A wider one is listed entry by entry."""

_SIMPLE_NAME = re.compile(r"(\\?[A-Za-z]+)(\([a-z]\))?\Z")


def entry_name(name: str, index: str) -> str:
    r"""Return the name of an entry: \Phi_{11}(t) of \Phi(t), and [name]_{11} of any other."""
    simple = _SIMPLE_NAME.match(name)
    return f"{simple[1]}_{{{index}}}{simple[2] or ''}" if simple else rf"\left[{name}\right]_{{{index}}}"


def entries(name: str, stated: Sequence[str], cells: Sequence[Sequence[str]]) -> str:
    """Return the entries of a matrix one under the other, Φ_{11} = ..., below Φ = `stated`."""
    single = len(cells) == 1 or len(cells[0]) == 1
    rows = [f"{name} &= {side}" for side in stated]
    for i, row in enumerate(cells, 1):
        for j, cell in enumerate(row, 1):
            index = f"{max(i, j)}" if single else f"{i}{j}" if len(cells) < 10 and len(row) < 10 else f"{i},{j}"
            first, *others = broken(cell, LINE - width(name) - 3)
            rows += [f"{entry_name(name, index)} &= {first}", *(rf"&\quad {line}" for line in others)]
    return aligned(rows)


def _rows(side: str, relation: str, room: float) -> list[str]:
    first, *others = broken(side, room)
    return [f"{relation} {first}", *(rf"\quad {line}" for line in others)]


def aligned(rows: Iterable[str]) -> str:
    """Return rows that have their alignment signs as one block."""
    body = " \\\\\n".join(rows)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"
