"""Displayed equations: `$$ a = b = c $$`, over several lines where one is too narrow."""

from __future__ import annotations

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


def _rows(side: str, relation: str, room: float) -> list[str]:
    first, *others = broken(side, room)
    return [f"{relation} {first}", *(rf"\quad {line}" if line[0] in "+-" else line for line in others)]


def aligned(rows: Iterable[str]) -> str:
    """Return rows that have their alignment signs as one block."""
    body = " \\\\\n".join(rows)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"
