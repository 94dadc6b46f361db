"""Boxes of a diagram grow with the matrices in them, and what stands beside them moves along."""

from __future__ import annotations

import pytest

from solver.figures.layout import Block, Dot, Layout, Wire
from solver.figures.matrices import LINE, MARGIN, grown, widths_of

ROWS = [["1", "0"], ["-2", "3"], ["a", "b"], ["0", "7"]]
MATRIX = r"\begin{bmatrix}" + r" \\ ".join(" & ".join(row) for row in ROWS) + r"\end{bmatrix}"


def test_a_box_is_as_large_as_its_matrix_and_wires_still_end_at_it():
    box, below = Block(0.0, 0.0, MATRIX, 1.6, 0.9), Block(0.0, -2.0, "B", 1.6, 0.9)
    wires = [Wire(((-2.0, 0.0), (-0.8, 0.0))), Wire(((0.0, -0.45), (0.0, -1.55)))]
    found, lower, in_front, down, dot = grown(Layout([box, below, *wires, Dot(-2.0, 0.0)])).items
    assert found.height == pytest.approx(LINE * len(ROWS) + MARGIN)
    assert found.width == pytest.approx(max(1.6, sum(widths_of(ROWS)) + MARGIN))
    assert (lower.height, lower.width) == pytest.approx((0.9, found.width))
    assert in_front.points[-1] == pytest.approx((found.x - found.width / 2, found.y))
    assert in_front.points[0] == (dot.x, dot.y) == (-2.0, found.y)
    assert down.points[0] == pytest.approx((found.x, found.y - found.height / 2))
    assert down.points[-1] == pytest.approx((lower.x, lower.y + lower.height / 2))
    assert down.points[0][1] - down.points[-1][1] == pytest.approx(1.1)


def test_without_a_matrix_all_stays():
    layout = Layout([Block(0.0, 0.0, "G"), Wire(((0.8, 0.0), (2.0, 0.0)))])
    assert grown(layout) is layout
