"""Tables of MathML Core have neither lines nor alignment: both become styles of the cells."""

from __future__ import annotations

from xml.etree.ElementTree import Element

from solver.render.mathml.commands import DISPLAY_STYLE, HORIZONTAL_LINE, VERTICAL_LINE

ALIGNMENTS = {"left": "text-align:left", "right": "text-align:right"}


def style_table(table: Element) -> None:
    """Turn alignment and lines into styles of the cells."""
    if table.tag != "mtable":
        return
    display = table.get("displaystyle") == "true"
    aligned = table.get("columnspacing") == "0em"
    table.attrib = {"displaystyle": "true"} if display else {}
    styles: dict[Element, list[str]] = {}
    lines: set[int] = set()
    above: Element | None = None
    for row in list(table):
        marks = _take_marks(row)
        lines |= {ord(mark) - ord(VERTICAL_LINE) for mark in marks if mark >= VERTICAL_LINE}
        if DISPLAY_STYLE in marks:
            table.set("displaystyle", "true")
        bare = HORIZONTAL_LINE in marks and len(row) == 1 and len(row[0]) == 0 and above is not None
        if HORIZONTAL_LINE in marks:
            lined, side = (above, "bottom") if bare and above is not None else (row, "top")
            for cell in lined:
                styles.setdefault(cell, []).append(f"border-{side}:1px solid")
        if bare:
            table.remove(row)
        else:
            above = row
    for row in table:
        for column, cell in enumerate(row):
            _style_cell(cell, styles.get(cell, []), column, lines, aligned)


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


def _style_cell(cell: Element, styles: list[str], column: int, lines: set[int], aligned: bool) -> None:
    alignment = ALIGNMENTS.get(cell.get("columnalign", ""))
    styles = [*([alignment] if alignment else []), *styles]
    if aligned:  # the two halves of an equation touch, pairs of columns stand apart
        styles.append("padding-left:0" if column % 2 else "padding-right:0")
        if column and column % 2 == 0:
            styles.append("padding-left:2em")
    if column + 1 in lines:
        styles.append("border-right:1px solid")
    if column == 0 and 0 in lines:
        styles.append("border-left:1px solid")
    cell.attrib = {"style": ";".join(styles)} if styles else {}
