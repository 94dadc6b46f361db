"""A realization as a block diagram: its rows of integrators, the input led to them and their outputs added."""

from __future__ import annotations

from collections.abc import Sequence

from solver.derivation.figures import Chains
from solver.figures.chains import BUS, GAP, LANE, Row, groups_of, width_of
from solver.figures.layout import RADIUS, Block, Dot, Label, Layout, Point, Sum

ABOVE, BELOW, MORE = 0.75, 0.85, 1.0
"""Room above and below a row without lanes, and how far a second lane is above the first."""


def layout_of(figure: Chains) -> Layout:
    """Return the diagram; rows stand below each other, the direct path above them."""
    layout, rows, y = Layout(), [], 0.0
    for states in figure.rows:
        row = Row(layout, figure, states, y, groups_of(states, figure.A))
        row.y = y - _above(row)
        row.draw()
        y = row.y - max([BELOW, *(group.depth + 0.6 for group in row.groups)])
        rows.append(row)
    right = max(_end(row) for row in rows)
    levels = [_bypass(row) for row in rows]
    top = rows[0].y + _above(rows[0]) + 0.45
    _input(layout, figure, rows, top)
    _output(layout, figure, [level for level in levels if level is not None], (right, top))
    return layout


def _above(row: Row) -> float:
    """Return how much room the lanes above a row need."""
    lanes = bool(_inputs(row)) + bool(_tapped(row))
    return ABOVE if not lanes else LANE + (lanes - 1) * MORE + 0.4


def _inputs(row: Row) -> list[int]:
    return [state for state in row.states[1:] if row.figure.b[state]]


def _tapped(row: Row) -> list[int]:
    return [state for state in row.states[:-1] if row.figure.c[state]]


def _end(row: Row) -> float:
    """Return where the row ends: room for the gain of its output, and for the sum with what bypasses it."""
    gain = row.figure.c[row.states[-1]]
    width = width_of(gain) + GAP if gain not in ("", "1") else 0.0
    return row.x + 0.5 + width + (1.0 if _tapped(row) else 0.0)


def _bypass(row: Row) -> Point | None:
    """Draw the output of a row, with the states that pass above it; return where its wire ends."""
    last = row.figure.c[row.states[-1]]
    x, pen = row.x + 0.5, row.pen
    if last and last != "1" and pen is not None:
        width = width_of(last)
        row.layout.wire((pen, row.y), (x, row.y))
        row.layout.add(Block(x + width / 2, row.y, last, width))
        x, pen = x + width, x + width
    elif not last and pen is not None and row.x > pen:
        row.layout.wire((pen, row.y), (row.x, row.y), arrow=False)
    tapped = [(row.taps[state], row.figure.c[state]) for state in _tapped(row)]
    if tapped:
        lane, at = row.y + LANE, x + 0.6
        if last and pen is not None:
            row.collected(tapped, lane, (at, lane), (at, row.y + RADIUS))
            row.layout.wire((pen, row.y), (at - RADIUS, row.y))
            row.layout.add(Sum(at, row.y))
            return at + RADIUS, row.y
        row.collected(tapped, lane, (at, lane), (at, row.y), (at + 0.3, row.y), arrow=False)
        return at + 0.3, row.y
    return (pen, row.y) if last and pen is not None else None


def _input(layout: Layout, figure: Chains, rows: Sequence[Row], top: float) -> None:
    """Draw the input and the wires that lead it to each row, to the lane above a row, and past all rows."""
    heights = [row.y for row in rows if figure.b[row.states[0]]]
    lanes = [(row, row.y + LANE + (MORE if _tapped(row) else 0.0)) for row in rows if _inputs(row)]
    every = sorted({*heights, *(lane for _, lane in lanes), *([top] if figure.d else [])}, reverse=True)
    entry = (heights or every or [rows[0].y])[0]
    layout.wire((BUS - 1.2, entry), (BUS, entry), arrow=False)
    layout.add(Label(BUS - 0.9, entry, "u", "above"))
    if len(every) > 1:
        layout.add(*(Dot(BUS, y) for y in every if y == entry or min(every) < y < max(every)))
        for side in ([y for y in every if y > entry][::-1], [y for y in every if y < entry]):
            for before, y in zip([entry, *side], side, strict=False):
                layout.wire((BUS, before), (BUS, y), arrow=False)
    for row, lane in lanes:
        row.distributed((BUS, lane), lane, [(row.above[state], figure.b[state]) for state in _inputs(row)])


def _output(layout: Layout, figure: Chains, ends: Sequence[Point], corner: Point) -> None:
    """Add the outputs of the rows, and what passes by them, from above downwards."""
    right, top = corner
    signals = list(ends)
    if figure.d:
        signals.insert(0, _direct(layout, figure.d, top, right))
    at = right + 0.5
    if not signals:
        return
    if len(signals) == 1:
        layout.wire(signals[0], (at + 1.2, signals[0][1]))
        layout.add(Label(at + 0.8, signals[0][1], "y", "above"))
        return
    (x, y), *others = signals
    layout.wire((x, y), (at, y), (at, others[0][1] + RADIUS))
    for i, (x, y) in enumerate(others):
        layout.wire((x, y), (at - RADIUS, y))
        layout.add(Sum(at, y))
        if i < len(others) - 1:
            layout.wire((at, y - RADIUS), (at, others[i + 1][1] + RADIUS))
    layout.wire((at + RADIUS, y), (at + 1.4, y))
    layout.add(Label(at + 1.0, y, "y", "above"))


def _direct(layout: Layout, gain: str, top: float, right: float) -> Point:
    """Draw the path from the input past all rows; return where it ends."""
    if gain == "1":
        layout.wire((BUS, top), (right, top), arrow=False)
        return right, top
    width, middle = width_of(gain), (BUS + right) / 2
    layout.add(Block(middle, top, gain, width))
    layout.wire((BUS, top), (middle - width / 2, top))
    return middle + width / 2, top
