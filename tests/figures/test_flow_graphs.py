"""Signal-flow graphs drawn: gains stand apart, names keep clear of lines, both formats show the same."""

from __future__ import annotations

from itertools import combinations
from math import atan2, pi

import pytest

from solver.derivation.flow_figures import FlowGraph
from solver.figures import svg, tikz
from solver.figures.drawing import drawing_of
from solver.figures.flow_graphs import ANCHORS, Drawing, _name, layout_of
from solver.figures.layout import Dot, Label


def graph(nodes, branches, row):
    names = nodes.split()
    edges = tuple((names.index(a), names.index(b), gain) for a, b, gain in branches)
    return FlowGraph("A graph", tuple(names), edges, tuple(map(names.index, row.split())))


GRAPHS = {
    "unity": graph("r e y", [("r", "e", "1"), ("e", "y", "G"), ("y", "e", "-1")], "r e y"),
    "nested": graph(
        "r e f x y",
        [
            ("r", "e", "1"),
            ("e", "f", "G_1"),
            ("f", "x", "G_2"),
            ("x", "y", "G_3"),
            ("x", "f", "-H_1"),
            ("y", "e", "-H_2"),
        ],
        "r e f x y",
    ),
    "feedforward": graph(
        "r e x y",
        [("r", "e", "1"), ("e", "x", "G_1"), ("x", "y", "G_2"), ("y", "e", "-H"), ("r", "x", "F"), ("r", "y", "D")],
        "r e x y",
    ),
    "own": graph(
        "r x y", [("r", "x", "a"), ("x", "y", "b"), ("x", "x", "c"), ("y", "y", "d"), ("y", "x", "-e")], "r x y"
    ),
    "parallel": graph(
        "r a b c d y",
        [
            ("r", "a", "G_1"),
            ("a", "b", "G_2"),
            ("b", "y", "G_3"),
            ("r", "c", "G_4"),
            ("c", "d", "G_5"),
            ("d", "y", "G_6"),
            ("b", "a", "-H_1"),
            ("d", "c", "-H_2"),
        ],
        "r a b y",
    ),
    "disturbed": graph(
        "r e u v y d",
        [
            ("r", "e", "1"),
            ("e", "u", "C"),
            ("u", "v", "1"),
            ("v", "y", "G"),
            ("d", "v", "1"),
            ("y", "e", "-H"),
            ("r", "v", "F"),
        ],
        "r e u v y",
    ),
}


@pytest.mark.parametrize("figure", GRAPHS.values(), ids=GRAPHS)
def test_every_node_and_gain_is_there_and_labels_stand_apart(figure):
    items = layout_of(figure).items
    labels = [each for each in items if isinstance(each, Label)]
    assert sum(isinstance(each, Dot) for each in items) == len(figure.nodes)
    assert sorted(each.text for each in labels) == sorted([*figure.nodes, *(gain for *_, gain in figure.branches)])
    for one, other in combinations(labels, 2):
        assert abs(one.x - other.x) > 0.25 or abs(one.y - other.y) > 0.3, (one, other)


@pytest.mark.parametrize("figure", GRAPHS.values(), ids=GRAPHS)
def test_it_is_drawn_in_both_formats_and_told(figure):
    drawn = drawing_of(figure)
    assert svg(drawn).startswith("<?xml") or "<svg" in svg(drawn)
    assert svg(drawn) == svg(drawn)
    assert all(f"${gain}$" in tikz(drawn) for *_, gain in figure.branches)
    assert "r to e: 1" in drawn.alt or "r to" in drawn.alt


@pytest.mark.parametrize("free", range(8))
def test_a_name_stands_where_no_line_leaves_its_node(free):
    node = Drawing(GRAPHS["unity"], at={0: (1.0, 2.0)}, leaving={0: [i * pi / 4 for i in range(8) if i != free]})
    name = _name(node, 0)
    assert atan2(name.y - 2.0, name.x - 1.0) % (2 * pi) == pytest.approx(free * pi / 4)
    assert (name.text, name.anchor) == ("r", ANCHORS[free])
