"""Root loci and regions of two parameters as figures: curves through roots, marks, windows, what is told."""

import numpy as np
import pytest
import sympy as sp

from solver.derivation.parameter_figures import Locus, ParameterRegion
from solver.figures import svg, tikz
from solver.figures.drawing import drawing_of
from solver.figures.parameter_regions import corners_of

a, b = sp.symbols("a b", real=True)
THREE = Locus(
    "",
    (sp.Integer(1),),
    tuple(map(sp.Integer, (1, 3, 2, 0))),
    "K",
    sp.Integer(-1),
    tuple(map(sp.Integer, (60, 180, -60))),
    ((-1 + 1 / sp.sqrt(3), 2 * sp.sqrt(3) / 9),),
    ((sp.sqrt(2) * sp.I, sp.Integer(6)),),
)


def branches(plot):
    return [np.array(c.x) + 1j * np.array(c.y) for c in plot.curves if "branches" in c.label]


def test_branches_hold_the_roots_and_begin_and_end_where_they_should():
    plot = drawing_of(THREE)
    dense = np.concatenate(
        [np.interp(np.linspace(0, len(p) - 1, 50 * len(p)), range(len(p)), p) for p in branches(plot)]
    )
    for gain in (0.1, 0.3849, 1, 3, 6):
        for root in np.roots([1, 3, 2, gain]):
            assert np.min(np.abs(dense - root)) < 0.01 or root.real < plot.window[0]
    starts = [piece[0] for piece in branches(plot)]
    assert all(min(abs(start - pole) for start in starts) < 1e-6 for pole in (0, -1, -2))
    meeting = -1 + 1 / np.sqrt(3)
    assert sum(abs(piece[-1] - meeting) < 1e-6 for piece in branches(plot)) == 2
    assert sum(abs(piece[0] - meeting) < 1e-6 for piece in branches(plot)) == 2


def test_marks_name_the_gains_and_the_text_tells_them():
    plot = drawing_of(THREE)
    assert [mark.label for mark in plot.marks if mark.label] == ["K = 0.385", "K = 6"]
    assert "Branches meet at −0.4226 for K = 0.3849" in plot.alt
    assert "Branches cross the imaginary axis at ±1.414j for K = 6" in plot.alt
    assert svg(plot).startswith("<svg")
    assert r"\begin{axis}" in tikz(plot)


def test_a_far_pole_is_told_at_the_edge():
    plot = drawing_of(Locus("", (sp.Integer(1),), tuple(map(sp.Integer, (1, 203, 402, 200)))))
    assert any(r"\leftarrow" in mark.label for mark in plot.marks)


def test_a_branch_comes_back_from_infinity():
    plot = drawing_of(Locus("", (sp.Integer(-1), sp.Integer(1)), (sp.Integer(1), sp.Integer(1))))
    assert {round(float(piece[-1].real), 6) for piece in branches(plot)} & {1.0}


def test_the_region_of_two_parameters_has_its_corners_and_its_area():
    region = ParameterRegion("", a, b, (b - a, 3 - a, 3 - b), ("b = a", "a = 3", "b = 3"), ("a", "b"))
    assert corners_of(region) == [pytest.approx((3.0, 3.0))]
    plot = drawing_of(region)
    (area,) = (curve for curve in plot.curves if curve.style == "area")
    x, y = np.array(area.x), np.array(area.y)
    size = 0.5 * abs(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1)))
    left, low = plot.window[0], plot.window[2]
    expected = (3 - left) * 3 - (9 - left**2) / 2 if low <= left else None
    assert expected is None or abs(size - expected) < 1e-3 * expected
    assert "Corners of the region: (3, 3)" in plot.alt


def test_an_edge_of_a_factor_of_two_conditions_is_in_the_window():
    """a b > 0 and (4 − b) a > 0 have a in common: 0 < b < 4, a > 0."""
    region = ParameterRegion("", a, b, (a * b, 4 * a - a * b), ("ab = 0", "4a = ab"), ("a", "b"))
    assert corners_of(region) == [pytest.approx((0.0, 0.0)), pytest.approx((0.0, 4.0))]
    plot = drawing_of(region)
    (area,) = (curve for curve in plot.curves if curve.style == "area")
    assert (min(area.y), max(area.y)) == pytest.approx((0, 4), abs=1e-3)
    assert plot.window[3] > 4


def test_curved_edges_are_followed_through_the_window():
    region = ParameterRegion("", a, b, (4 - a**2 - b**2,), ("circle",), ("a", "b"))
    plot = drawing_of(region)
    areas = [curve for curve in plot.curves if curve.style == "area"]
    size = 0.0
    for area in areas:
        x, y = np.array(area.x), np.array(area.y)
        size += 0.5 * abs(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1)))
    assert abs(size - 4 * np.pi) < 0.05
