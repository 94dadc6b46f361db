"""Realizations as drawn: read back wire by wire, their boxes have the transfer function of the matrices."""

from fractions import Fraction
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sp

from solver.figures.layout import Block, Sum
from solver.figures.realizations import layout_of
from solver.formula.terminal import flat
from solver.tasks.representation.chains import chains_of, integrators_of
from tests.figures.test_diagrams import NEAR, Diagram, lies_on, same

COMPANION = [[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [-5, 0, 1, -3]]
DUAL = [list(row) for row in zip(*COMPANION, strict=True)]
FIRST = [[-4, -6, 1], [1, 0, 0], [0, 1, 0]]
FORMS = {
    "controllable": (COMPANION, [0, 0, 0, 1], [3, 2, 0, 1], 0),
    "controllable, wires only": ([[0, 1], [1, 1]], [0, 1], [1, 1], 1),
    "observable": (DUAL, [3, 2, 0, 1], [0, 0, 0, 1], 2),
    "first row": (FIRST, [1, 0, 0], [0, -1, 7], 0),
    "first column": ([list(row) for row in zip(*FIRST, strict=True)], [0, -1, 7], [1, 0, 0], -1),
    "no last output": (COMPANION, [0, 0, 0, 1], [0, 2, 0, 4], 0),
    "diagonal": ([[-1, 0, 0], [0, -2, 0], [0, 0, 1]], [1, 2, 1], [1, 1, -3], Fraction(1, 2)),
    "Jordan": ([[-1, 1, 0, 0], [0, -1, 1, 0], [0, 0, -1, 0], [0, 0, 0, -4]], [0, 0, 1, 1], [2, 1, 5, -1], 0),
    "Jordan, ones below": ([[-1, 0, 0], [1, -1, 0], [0, 1, -1]], [1, 0, 0], [0, 1, 5], 3),
    "modal": ([[-1, 2, 0], [-2, -1, 0], [0, 0, -3]], [1, 1, 0], [1, 4, 1], 0),
    "a hidden state": ([[-1, 0], [0, -2]], [1, 0], [1, 0], 0),
    "a double integrator": ([[0, 1], [0, 0]], [0, 1], [1, 0], 0),
    "one state": ([[-2]], [3], [1], 0),
}


class Read(Diagram):
    """A diagram whose sums are not named like gains."""

    SUM = "sum {}"


def drawn(form, *, discrete=False):
    A, b, c, d = (sp.ImmutableMatrix(part) for part in (form[0], form[1], [form[2]], [[sp.Rational(form[3])]]))
    (figure,) = integrators_of(SimpleNamespace(A=A, B=b, C=c, D=d), discrete=discrete)
    return layout_of(figure)


def gain(text, s):
    return 1 / s if text in ("1/s", "z^{-1}") else float(Fraction(flat(text).replace("\u2212", "-")))


def output(layout, s):
    """The output for the input 1, from the boxes and wires as drawn."""
    diagram = Read(layout)
    order = [item for item in layout.items if isinstance(item, Block | Sum)]
    names = dict(zip(map(id, order), ordered_names(layout), strict=True))
    gains = {names[id(item)]: gain(item.text, s) if isinstance(item, Block) else 1.0 for item in order}
    places = {name: i for i, name in enumerate(gains)}
    M, right, found = np.eye(len(places), dtype=complex), np.zeros(len(places), dtype=complex), 0
    ends = [(diagram.source(wire), diagram.target(wire)) for wire in diagram.wires if wire.arrow]
    for source, target in ends:
        if source == "in" and target != "out":
            right[places[target]] += gains[target]
        elif target != "out":
            M[places[target], places[source]] -= gains[target]
    signals = np.linalg.solve(M, right)
    for source, target in ends:
        if target == "out":
            found += 1 if source == "in" else signals[places[source]]
    return found


def ordered_names(layout):
    """The names that the reader of diagrams gives to boxes, in the order of the items."""
    seen, sums = {}, 0
    for item in layout.items:
        if isinstance(item, Block):
            seen[item.text] = seen.get(item.text, -1) + 1
            yield item.text + "'" * seen[item.text]
        elif isinstance(item, Sum):
            sums += 1
            yield Read.SUM.format(sums)


@pytest.mark.parametrize("name", FORMS)
@pytest.mark.parametrize("discrete", [False, True])
def test_what_is_drawn_has_the_transfer_function_of_the_matrices(name, discrete):
    A, b, c, d = (np.array(part, dtype=float) for part in FORMS[name])
    for s in (0.7 + 1.3j, -2.2 + 0.4j, 3.1):
        G = c @ np.linalg.solve(s * np.eye(len(A)) - A, b) + d
        assert output(drawn(FORMS[name], discrete=discrete), s) == pytest.approx(G)


@pytest.mark.parametrize("name", FORMS)
def test_no_wire_runs_through_a_box_and_no_box_lies_on_another(name):
    layout = drawn(FORMS[name])
    diagram = Read(layout)
    for wire in diagram.wires:
        for (x, y), (u, v) in pairwise(wire.points):
            assert (abs(x - u) < NEAR) != (abs(y - v) < NEAR), wire
            for box, (bx, by, width, height) in diagram.boxes.items():
                left, right, low, high = min(x, u) - bx, max(x, u) - bx, min(y, v) - by, max(y, v) - by
                beside = left >= width - NEAR or right <= NEAR - width or low >= height - NEAR or high <= NEAR - height
                assert beside, (box, wire)
    boxes = list(diagram.boxes.values())
    for i, (x, y, width, height) in enumerate(boxes):
        for u, v, other, tall in boxes[i + 1 :]:
            assert abs(x - u) > width + other - NEAR or abs(y - v) > height + tall - NEAR


@pytest.mark.parametrize("name", FORMS)
def test_a_dot_stands_where_a_wire_branches(name):
    diagram = Read(drawn(FORMS[name]))
    branches = {
        wire.points[0]
        for wire in diagram.wires
        for other in diagram.wires
        if other is not wire and not diagram.box_at(*wire.points[:2])
        for stretch in pairwise(other.points)
        if lies_on(wire.points[0], stretch) and not same(wire.points[0], other.points[-1])
    }
    assert all(any(same(branch, dot) for dot in diagram.dots) for branch in branches)


def test_chains_that_act_on_each_other_are_not_drawn():
    assert chains_of(sp.ImmutableMatrix([[0, 1, 0], [0, 0, 1], [1, 1, 1]])) == ((2, 1, 0),)
    assert chains_of(sp.ImmutableMatrix([[1, 0, 0], [1, 1, 0], [1, 0, 1]])) is None
    several = SimpleNamespace(A=sp.eye(2), B=sp.eye(2), C=sp.ones(1, 2), D=sp.zeros(1, 2))
    assert integrators_of(several, discrete=False) == ()
