"""Equations side by side: those that a display has under each other, as many on a line as fit."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from solver.formula.building import row
from solver.formula.nodes import Fenced, Node, Operator, Row, Space, Table, Text
from solver.formula.width import LINE, width
from solver.render.displaying import GAP
from solver.render.displays import QUAD, aligned


def equations_in(formula: Row) -> tuple[Row, tuple[Row, ...]]:
    """Return the word that a display begins with, maybe none, and its equations, each without signs of alignment.

    What is one equation over several lines is returned as it stands.
    """
    match formula.items:
        case (Table("aligned", rows),):
            headed = rows[0][1:] and not rows[0][0].items and _is_word(rows[0][1])
            head, lines = (rows[0][1], rows[1:]) if headed else (Row(), rows)
        case (Text() as word, Space(), Table("aligned", lines)):
            head = row(word)
        case (Text() as word, Space(), Fenced(r"\{", body, r"\}")) if all(map(_is_equation, items := _items(body))):
            return row(word), tuple(items)
        case _:
            return Row(), (formula,)
    if not lines or not all(line[0].items for line in lines):
        return Row(), (formula,)
    return head, tuple(_equation(line) for line in lines)


def _items(body: Row) -> list[Row]:
    """Return what stands between commas."""
    items: list[list[Node]] = [[]]
    for node in body.items:
        if node == Operator(","):
            items.append([])
        elif items[-1] or not isinstance(node, Space):
            items[-1].append(node)
    return [Row(tuple(item)) for item in items]


def _is_equation(formula: Row) -> bool:
    return Operator("=") in formula.items


def _is_word(cell: Row) -> bool:
    return len(cell.items) == 1 and isinstance(cell.items[0], Text)


def _equation(cells: Sequence[Row]) -> Row:
    """Return the cells of a line side by side; what does not go on with a sign is another equation."""
    found = cells[0]
    for i, cell in enumerate(cells[1:], 1):
        goes_on = i == 1 or not cell.items or isinstance(cell.items[0], Operator | Space | Text)
        found = row(found, cell) if goes_on else row(found, GAP, cell)
    return found


def side_by_side(head: Row, equations: Iterable[Row], room: float = LINE) -> Iterator[Row]:
    """Yield displays with as many of the equations on each line as fit; one over several lines stands alone."""
    lines: list[Row] = [row(head, QUAD)] if head.items else []
    begun = bool(lines)
    for each in equations:
        if is_broken(each):
            yield from _together(lines)
            yield each
            lines, begun = [], False
            continue
        longer = row(lines[-1], each) if begun else row(lines[-1], GAP, each) if lines else each
        if lines and (width(longer) <= room or begun):
            lines[-1] = longer
        else:
            lines.append(each)
        begun = False
    yield from _together(lines)


def is_broken(equation: Row) -> bool:
    """Whether an equation goes over several lines."""
    return any(isinstance(each, Table) and each.environment == "aligned" for each in equation.items)


def _together(lines: Sequence[Row]) -> Iterator[Row]:
    """Yield one display of the lines."""
    if lines:
        yield lines[0] if len(lines) == 1 else aligned([(Row(), line) for line in lines])


def sides_of(equation: Row) -> list[Row]:
    """Return what stands between the signs of equality."""
    sides: list[list[Node]] = [[]]
    for item in equation.items:
        if item == Operator("="):
            sides.append([])
        else:
            sides[-1].append(item)
    return [Row(tuple(side)) for side in sides]
