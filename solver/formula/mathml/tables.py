"""Tables of MathML Core have neither lines nor alignment: both become styles of the cells."""

from __future__ import annotations

from solver.formula.nodes import Table

LEFT, RIGHT = "text-align:left", "text-align:right;text-align:-webkit-right"
"""In a cell of MathML Chromium moves nothing for `right`, and does for its own word; others skip a word they miss."""

FENCES = {"pmatrix": "()", "bmatrix": "[]", "Bmatrix": "{}", "vmatrix": "||", "Vmatrix": "‖‖"}
"""What stands left and right of a table."""


def styles(table: Table) -> list[list[str]]:
    """Return the style of each cell, by rows; "" for none."""
    columns = max(len(row) for row in table.rows)
    sides = [_across(table, i) for i in range(len(table.rows))]
    return [[";".join([*_alignment(table, j), *sides[i], *_upright(table, j)]) for j in range(columns)]
            for i in range(len(table.rows))]  # fmt: skip


def _alignment(table: Table, column: int) -> list[str]:
    if table.environment == "aligned":  # the two halves of an equation touch, pairs of columns stand apart
        halves = [LEFT, "padding-left:0"] if column % 2 else [RIGHT, "padding-right:0"]
        return halves + ["padding-left:2em"] * (column > 0 and column % 2 == 0)
    letters = table.columns.replace("|", "")
    letter = letters[column] if letters else "l" if table.environment == "cases" else "c"
    return {"l": [LEFT], "r": [RIGHT]}.get(letter, [])


def _across(table: Table, row: int) -> list[str]:
    below = row + 1 == len(table.rows) == max(table.rules, default=0)
    return ["border-top:1px solid"] * (row in table.rules) + ["border-bottom:1px solid"] * below


def _upright(table: Table, column: int) -> list[str]:
    """Return the lines beside a cell of a column; one left of the table belongs to its first cells."""
    left = table.columns.startswith("|") and column == 0
    letters = [i for i, letter in enumerate(table.columns) if letter != "|"]
    right = bool(letters) and table.columns[letters[column] + 1 : letters[column] + 2] == "|"
    return ["border-left:1px solid"] * left + ["border-right:1px solid"] * right
