"""Tables of MathML Core have neither lines nor alignment: both become styles of the cells."""

from __future__ import annotations

from xml.etree.ElementTree import Element

from solver.render.mathml.commands import DISPLAY_STYLE, HORIZONTAL_LINE, VERTICAL_LINE

ALIGNMENTS = {"left": "text-align:left", "right": "text-align:right;text-align:-webkit-right"}
"""In a cell of MathML Chromium moves nothing for `right`, and does for its own word; others skip a word they miss."""


def style_table(table: Element) -> None:
    """Turn alignment and lines into styles of the cells."""
    if table.tag != "mtable":
        return
    aligned = table.get("columnspacing") == "0em"
    marks = {row: _take_marks(row) for row in table}
    all_marks = "".join(marks.values())
    display = table.get("displaystyle") == "true" or DISPLAY_STYLE in all_marks
    table.attrib = {"displaystyle": "true"} if display else {}
    closed = len(table) > 1 and HORIZONTAL_LINE in marks[table[-1]] and not any(len(cell) for cell in table[-1])
    if closed:  # the last row held nothing but the line below the table
        table.remove(table[-1])
    lines = {ord(mark) - ord(VERTICAL_LINE) for mark in all_marks if mark >= VERTICAL_LINE}
    columns = max((len(row) for row in table), default=0)
    for row in table:
        row.extend(Element("mtd") for _ in range(columns - len(row)))  # else its lines end early
        sides = ["top"] if HORIZONTAL_LINE in marks[row] else []
        sides += ["bottom"] if closed and row is table[-1] else []
        for column, cell in enumerate(row):
            _style_cell(cell, column, [*sides, *_vertical_lines(column, lines)], aligned)


def _vertical_lines(column: int, lines: set[int]) -> list[str]:
    """Return the sides of a cell of that column that have a line; line 0 is left of the table."""
    left = ["left"] if column == 0 and 0 in lines else []
    return [*left, "right"] if column + 1 in lines else left


def _take_marks(row: Element) -> str:
    """Remove the marks at the start of a row and return them."""
    marks = ""
    while len(row) and len(row[0]) and (found := _marks(row[0][0])):
        marks += found
        row[0].remove(row[0][0])
    return marks


def _marks(element: Element) -> str:
    """Return the text of an element that holds nothing but marks, else nothing."""
    text = "".join(element.itertext())
    return text if all(HORIZONTAL_LINE <= character <= "\uf8ff" for character in text) else ""


def _style_cell(cell: Element, column: int, sides: list[str], aligned: bool) -> None:
    alignment = ALIGNMENTS.get(cell.get("columnalign", ""))
    styles = [alignment] if alignment else []
    if aligned:  # the two halves of an equation touch, pairs of columns stand apart
        styles.append("padding-left:0" if column % 2 else "padding-right:0")
        if column and column % 2 == 0:
            styles.append("padding-left:2em")
    styles += [f"border-{side}:1px solid" for side in sides]
    cell.attrib = {"style": ";".join(styles)} if styles else {}
