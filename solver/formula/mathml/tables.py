"""Tables of MathML Core have neither lines nor alignment: both become styles of the cells."""

from __future__ import annotations

from functools import lru_cache

from solver.formula.nodes import Table

LEFT, RIGHT = "text-align:left", "text-align:right;text-align:-webkit-right"
"""In a cell of MathML Chromium moves nothing for `right`, and does for its own word; others skip a word they miss."""

FENCES = {"pmatrix": "()", "bmatrix": "[]", "Bmatrix": "{}", "vmatrix": "||", "Vmatrix": "‖‖"}
"""What stands left and right of a table."""


def styles(table: Table) -> tuple[tuple[str, ...], ...]:
    """Return the style of each cell, by rows; "" for none."""
    return _styles(table.environment, table.columns, table.rules, len(table.rows), max(map(len, table.rows)))


@lru_cache(maxsize=256)  # most tables are matrices of a few sizes
def _styles(
    environment: str, columns: str, rules: tuple[int, ...], height: int, width: int
) -> tuple[tuple[str, ...], ...]:
    beside = [(_alignment(environment, columns, j), _upright(columns, j)) for j in range(width)]
    across = [_across(rules, height, i) for i in range(height)]
    return tuple(tuple(";".join([*before, *lines, *after]) for before, after in beside) for lines in across)


def _alignment(environment: str, columns: str, column: int) -> list[str]:
    if environment == "aligned":  # the two halves of an equation touch, pairs of columns stand apart
        halves = [LEFT, "padding-left:0"] if column % 2 else [RIGHT, "padding-right:0"]
        return halves + ["padding-left:2em"] * (column > 0 and column % 2 == 0)
    letters = columns.replace("|", "")
    letter = letters[column] if letters else "l" if environment == "cases" else "c"
    return {"l": [LEFT], "r": [RIGHT]}.get(letter, [])


def _across(rules: tuple[int, ...], height: int, row: int) -> list[str]:
    below = row + 1 == height == max(rules, default=0)
    return ["border-top:1px solid"] * (row in rules) + ["border-bottom:1px solid"] * below


def _upright(columns: str, column: int) -> list[str]:
    """Return the lines beside a cell of a column; one left of the table belongs to its first cells."""
    left = columns.startswith("|") and column == 0
    letters = [i for i, letter in enumerate(columns) if letter != "|"]
    right = bool(letters) and columns[letters[column] + 1 : letters[column] + 2] == "|"
    return ["border-left:1px solid"] * left + ["border-right:1px solid"] * right
