"""What the block diagrams say: who drives whom and with which sign, which signal is named where; and tidy wires."""

from collections import Counter
from itertools import pairwise

import pytest

from solver.figures.layout import RADIUS, Block, Dot, Label, Sum, Wire
from solver.figures.layouts import LAYOUTS

NEAR = 1e-6
SHORT = {r"\dot{x}=Ax+Bu": "P", r"\dot{x}=Ax+Bu+w": "P", r"\dot{x}=Ax+w": "P", r"K_f\,[S_1\;\;S_2]": "K"}


def same(p, q):
    return abs(p[0] - q[0]) < NEAR and abs(p[1] - q[1]) < NEAR


def lies_on(point, stretch):
    """Whether a point lies on a stretch that runs along an axis."""
    return all(min(u, v) - NEAR <= w <= max(u, v) + NEAR for w, u, v in zip(point, *stretch, strict=True))


class Diagram:
    """A layout read as a person reads it: boxes, and wires that run from one to another."""

    SUM = "{}"

    def __init__(self, layout):
        items = layout.items
        self.wires = [item for item in items if isinstance(item, Wire)]
        self.labels = [item for item in items if isinstance(item, Label) and item.text]
        self.dots = [(item.x, item.y) for item in items if isinstance(item, Dot)]
        self.boxes, seen, sums = {}, Counter(), 0
        for item in items:
            if isinstance(item, Block):
                text = SHORT.get(item.text, item.text)
                seen[text] += 1
                name = text + "'" * (seen[text] - 1)
                self.boxes[name] = (item.x, item.y, item.width / 2, item.height / 2)
            elif isinstance(item, Sum):
                sums += 1
                self.boxes[self.SUM.format(sums)] = (item.x, item.y, RADIUS, RADIUS)

    def box_at(self, point, beside):
        """The box that a wire touches in the middle of a side, coming from or going to a point outside it."""
        for name, (x, y, width, height) in self.boxes.items():
            right, up = point[0] - x, point[1] - y
            level = abs(abs(right) - width) < NEAR and abs(up) < height and (beside[0] - point[0]) * right > 0
            upright = abs(abs(up) - height) < NEAR and abs(right) < NEAR and (beside[1] - point[1]) * up > 0
            if (level and abs(beside[1] - point[1]) < NEAR) or (upright and abs(beside[0] - point[0]) < NEAR):
                return name
        return None

    def source(self, wire):
        """What drives a wire: a box, or what drives the wire that it branches from; else it is an input."""
        box = self.box_at(*wire.points[:2])
        others = [each for each in self.wires if each is not wire]
        from_ = next((o for o in others if any(lies_on(wire.points[0], s) for s in pairwise(o.points))), None)
        return box or (self.source(from_) if from_ else "in")

    def target(self, wire):
        """What a wire ends at, with the sign that stands there."""
        end, before = wire.points[-1], wire.points[-2]
        box = self.box_at(end, before) or "out"
        signs = [e.text for e in self.labels if e.text in "+-" and abs(e.x - end[0]) + abs(e.y - end[1]) < 0.2]
        return "".join(signs) + box

    @property
    def edges(self):
        return {f"{self.source(wire)}>{self.target(wire)}" for wire in self.wires if wire.arrow}

    @property
    def named(self):
        """Each signal's name with what drives the wire that it stands at."""
        found = {}
        for label in self.labels:
            if label.text not in "+-":
                at = [w for w in self.wires if any(lies_on((label.x, label.y), s) for s in pairwise(w.points))]
                found[label.text] = {self.source(wire) for wire in at}
        return found


INTEGRATED = r"B>{0} {0}>\int \int>A A>{0}"
"""The integrator behind a sum, with B and A before it."""
MODEL = INTEGRATED.format(1) + r" \int>C' C>+2 C'>-2 2>L_c L_c>1 in>P P>C C>out"
REDUCED = r"M>1 N>1 J>1 1>\int \int>J \int>2 L_c>2 C>L_c C>N 2>out in>P P>C C>out"
FILTER = r"P>C C>1 in>1 1>out 2>\int \int>A A>2 \int>C' 1>+3 C'>-3 3>L_c L_c>2"
LOOP = r"in>+3 3>P"
SAYS = {
    "state_feedback": r"in>+1 K_f>-1 1>B \int>K_f \int>C C>out " + INTEGRATED.format(2),
    "state_feedback_reference": r"in>K_o K_o>+1 K_f>-1 1>B \int>K_f \int>C C>out " + INTEGRATED.format(2),
    "servo": r"in>+1 C>-1 1>\int \int>k_I k_I>+2 K_f>-2 2>B \int'>K_f \int'>C C>out B>3 3>\int' \int'>A A>3",
    "observer": MODEL + " in>B",
    "observer_feedback": MODEL.replace("in>P", LOOP) + r" 3>B \int>K_f K_f>-3",
    "kalman_filter": FILTER + " in>P",
    "driven_kalman_filter": FILTER + r" in>P in>B B>2",
    "reduced_observer": REDUCED + " in>M",
    "reduced_observer_feedback": REDUCED.replace("in>P", LOOP) + " 3>M 2>K C>K K>-3",
    "model_matching": "in>H(s) H(s)>G(s) G(s)>out",
}
"""Who drives whom, with the sign at the sum; sums are numbered, the second block of a name has a dash."""
STATE = {"v": "in", "u": "1", r"\dot{x}": "2", "x": r"\int", "y": "C"}
ESTIMATE = {"x": "P", "y": "C", "u": "in", r"\hat{x}": r"\int", r"\hat{y}": "C'"}
NOISY = {"w": "in", "v": "in", "x": "P", "y": "1", r"\hat{x}": r"\int", r"\hat{y}": "C'"}
PARTIAL = {"x": "P", "y": "C", "u": "in", r"\omega": r"\int", r"\hat{\eta}_2": "2"}
NAMED = {
    "state_feedback": STATE,
    "state_feedback_reference": {**{name: STATE[name] for name in STATE if name != "v"}, "r": "in"},
    "servo": {
        "r": "in", r"\dot{\xi}": "1", r"\xi": r"\int", "u": "2", r"\dot{x}": "3", "x": r"\int'", "y": "C"
    },
    "observer": ESTIMATE,
    "observer_feedback": {**ESTIMATE, "u": "3", "v": "in"},
    "kalman_filter": NOISY,
    "driven_kalman_filter": {**NOISY, "u": "in"},
    "reduced_observer": PARTIAL,
    "reduced_observer_feedback": {**PARTIAL, "u": "3", "v": "in"},
    "model_matching": {"r": "in", "u": "H(s)", "y": "G(s)"},
}  # fmt: skip
"""Who drives the wire that bears a name."""


@pytest.fixture(params=LAYOUTS)
def diagram(request):
    return Diagram(LAYOUTS[request.param]({}))


@pytest.mark.parametrize("name", LAYOUTS)
def test_a_diagram_says_its_equations(name):
    diagram = Diagram(LAYOUTS[name]({}))
    assert diagram.edges == set(SAYS[name].split())
    assert diagram.named == {label: {source} for label, source in NAMED[name].items()}


def test_wires_run_along_the_axes_and_through_no_box(diagram):
    for wire in diagram.wires:
        for (x, y), (u, v) in pairwise(wire.points):
            assert (x == u) != (y == v)
            for name, (bx, by, width, height) in diagram.boxes.items():
                left, right, low, high = min(x, u) - bx, max(x, u) - bx, min(y, v) - by, max(y, v) - by
                beside = left >= width - NEAR or right <= NEAR - width or low >= height - NEAR or high <= NEAR - height
                assert beside, (name, wire)


def test_a_dot_stands_wherever_a_wire_branches_from_the_midst_of_another(diagram):
    branches = {
        wire.points[0]
        for wire in diagram.wires
        for other in diagram.wires
        if other is not wire and not diagram.box_at(*wire.points[:2])
        for p, q in pairwise(other.points)
        if lies_on(wire.points[0], (p, q)) and not same(wire.points[0], other.points[-1])
    }
    assert all(any(same(branch, dot) for dot in diagram.dots) for branch in branches)
    assert all(any(same(branch, dot) for branch in branches) for dot in diagram.dots)


def test_names_stand_clear_of_boxes_and_of_each_other(diagram):
    for i, label in enumerate(diagram.labels):
        for x, y, width, height in diagram.boxes.values():
            assert abs(label.x - x) > width - 0.3 or abs(label.y - y) > height - 0.15, label
        for other in diagram.labels[i + 1 :]:
            assert abs(label.x - other.x) > 0.3 or abs(label.y - other.y) > 0.3, (label, other)
