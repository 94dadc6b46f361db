"""Patch diagrams: every input is connected, wires meet no symbol and no other wire, labels stand apart."""

from __future__ import annotations

from functools import cache
from itertools import combinations
from random import Random

import pytest

from solver import figures
from solver.derivation.patch_figures import PatchDiagram, PatchElement
from solver.figures.drawing import drawing_of
from solver.figures.layout import Dot, Label
from solver.figures.palette import dark_style
from solver.figures.patch_cells import RADIUS, Cells
from solver.figures.patch_layout import PatchDrawing, layout_of
from solver.figures.patch_tracks import ordered, tracks
from solver.figures.strokes import Line, Ring, Shape, frame_of
from solver.render import page

VOLT = r"\,\mathrm{V}"


def diagram(listed, outputs=None):
    """A diagram of (id, kind, [(id, gain), …], value); P1 is written P_{1}."""
    ids = [each[0] for each in listed]
    elements = []
    for name, kind, inputs, *value in listed:
        fed = tuple((ids.index(other), str(gain)) for other, gain in inputs)
        latex = f"{name[0]}_{{{name[1:]}}}" if name[0] in "AP" else name
        elements.append(PatchElement(kind, latex, fed, *value or [""], (outputs or {}).get(name, "")))
    return PatchDiagram("A program", tuple(elements))


def chain(order, zeros=0):
    """x⁽ⁿ⁾ from its lower derivatives, each second one inverted, and a sum of them as output."""
    pots, inverters = [("u", "source", [], "u"), ("P0", "pot", [("u", 1)], "0.4")], []
    for i in range(order):
        name = f"A{i + 1}" if i % 2 == 0 else f"A{order + 1 + i // 2}"
        pots.append((f"P{i + 1}", "pot", [(name, 1)], f"0.{i + 2}5"))
        if i % 2:
            inverters.append((name, "inverter", [(f"A{i + 1}", 1)]))
    first = ("A1", "integrator", [(name, 10) for name, *_ in pots[1:]], "-2" + VOLT)
    others = [(f"A{i + 1}", "integrator", [(f"A{i}", 1)], "3" + VOLT if i % 2 else "") for i in range(1, order)]
    outputs = {f"A{order}": "x/5"}
    if zeros:
        more = [(f"Q{i}", "pot", [(f"A{order - i}", 1)], f"0.{i + 1}") for i in range(zeros)]
        pots += more
        inverters.append(("Ay", "summer", [(name, 1) for name, *_ in more]))
        outputs = {"Ay": "-y"}
    return diagram([*pots, first, *others, *inverters], outputs)


def dense(order, inputs):
    """A state-space model without zeros in A and B: half of the entries need an inverted state."""
    listed = [(f"u_{j}", "source", [], f"u_{j}") for j in range(inputs)]
    integrators = []
    for i in range(order):
        rows = []
        for j in range(order + inputs):
            state = f"A{j + 1}" if (i + j) % 2 else f"A{order + j + 1}"
            pot = f"P{1 + i * (order + inputs) + j}"
            listed.append((pot, "pot", [(state if j < order else f"u_{j - order}", 1)], "0.5234"))
            rows.append((pot, 10 if j % 2 else 1))
        integrators.append((f"A{i + 1}", "integrator", rows, "1" + VOLT))
    inverters = [(f"A{order + i + 1}", "inverter", [(f"A{i + 1}", 1)]) for i in range(order)]
    return diagram([*listed, *integrators, *inverters], {f"A{i + 1}": f"x_{i + 1}/2" for i in range(order)})


def drawn_at_random(seed):
    """Anything that can be patched: potentiometers that feed several inputs or each other, outputs of sources, …"""
    random, listed = Random(seed), []  # noqa: S311 - a program, no secret
    amplifiers = [f"A{i}" for i in range(1, random.randint(2, 8))]
    sources = [("+10" + VOLT, "source", [], "+10" + VOLT), ("u_1", "source", [], "u_1")]
    pots = [f"P{i}" for i in range(random.randint(0, 8))]
    feeding = [*amplifiers, *(name for name, *_ in sources)]
    for i, name in enumerate(pots):
        listed.append((name, "pot", [(random.choice([*feeding, *pots[:i]]), 1)], f"0.{random.randint(1, 9999)}"))
    for name in amplifiers:
        kind = random.choice(["integrator", "integrator", "summer", "inverter"])
        count = 1 if kind == "inverter" else random.randint(1, 4)
        inputs = [(random.choice([*feeding, *pots, *pots]), random.choice([1, 10])) for _ in range(count)]
        value = [random.choice(["", "-2.5" + VOLT])] if kind == "integrator" else []
        listed.append((name, kind, inputs, *value))
    outputs = {name: random.choice(["x", r"-\dot{x}/25", ""]) for name in [*amplifiers, "u_1"]}
    return diagram([*sources, *listed], outputs)


STATIC = diagram(
    [(f"v_{i}", "source", [], f"v_{i}") for i in range(1, 5)]
    + [("A1", "summer", [("v_3", 1), ("v_4", 10)]), ("A2", "summer", [("A1", 1), ("v_1", 1), ("v_2", 10)])],
    {"A2": "v_o"},
)
PROGRAMS = {
    "first": diagram([("A1", "integrator", [("A2", 1)], "1" + VOLT), ("A2", "inverter", [("A1", 1)])], {"A1": "x"}),
    "itself": diagram([("A1", "integrator", [("A1", 1)], "1" + VOLT)], {"A1": "x"}),
    "static": STATIC,
    "no inputs": diagram([("A1", "integrator", [], "5" + VOLT)], {"A1": "x"}),
    **{f"order {n}": chain(n) for n in (2, 3, 5)},
    **{f"zeros {n}": chain(n, n) for n in (2, 3)},
    "two states": dense(2, 1),
    "three states": dense(3, 2),
    **{f"random {seed}": drawn_at_random(seed) for seed in (1, 2, 4, 5, 7, 8, 9)},
}


DRAWN = cache(PatchDrawing)


@pytest.fixture(params=PROGRAMS.values(), ids=PROGRAMS, scope="module")
def figure(request):
    return request.param


def frames_of(strokes):
    """The rooms of the symbols: triangles, backs, potentiometers."""
    found = []
    for each in strokes:
        if isinstance(each, Shape):
            xs, ys = zip(*each.points, strict=True)
            found.append((min(xs), max(xs), min(ys), max(ys)))
        elif isinstance(each, Ring) and each.radius == RADIUS:
            found.append(
                (each.place[0] - RADIUS, each.place[0] + RADIUS, each.place[1] - RADIUS, each.place[1] + RADIUS)
            )
    return found


def lies_in(line, frame, margin=0.02):
    (x0, y0), (x1, y1) = line
    left, right, low, high = (frame[0] + margin, frame[1] - margin, frame[2] + margin, frame[3] - margin)
    return max(x0, x1) > left and min(x0, x1) < right and max(y0, y1) > low and min(y0, y1) < high


def test_wires_are_straight_and_run_through_no_symbol(figure):
    strokes = layout_of(figure)
    frames = frames_of(strokes)
    drawing = DRAWN(figure)
    for number in range(len(drawing.wiring.nets)):
        for line in drawing.wiring.segments(number, drawing.x, drawing.ends):
            assert line[0][0] == line[1][0] or line[0][1] == line[1][1]
            inside = [frame for frame in frames if lies_in(line, frame)]
            ends = {drawing.ends(end)[0] for end, _ in drawing.wiring.nets[number].ends}
            # only the potentiometer in the row of an input is passed by the wire to it, which lies under it
            assert all(frame[1] - frame[0] == pytest.approx(2 * RADIUS) and line[1][0] in ends for frame in inside)


def test_wires_of_different_outputs_never_lie_upon_each_other(figure):
    drawing = DRAWN(figure)
    wires = [drawing.wiring.segments(n, drawing.x, drawing.ends) for n in range(len(drawing.wiring.nets))]
    for one, other in combinations(wires, 2):
        for a, b in one:
            for c, d in other:
                for k in (0, 1):  # along x, along y
                    if a[k] == b[k] and c[k] == d[k] and abs(a[k] - c[k]) < 0.08:
                        j = 1 - k
                        assert max(min(a[j], b[j]), min(c[j], d[j])) > min(max(a[j], b[j]), max(c[j], d[j])) - 1e-9


def test_no_label_stands_on_another_or_on_a_wire_that_is_upright(figure):
    strokes = layout_of(figure)
    frames = [frame_of(each) for each in strokes if isinstance(each, Label) and each.text]
    for a, b in combinations(frames, 2):
        assert not (a[0] < b[1] - 0.09 and b[0] < a[1] - 0.09 and a[2] < b[3] - 0.09 and b[2] < a[3] - 0.09), (a, b)
    drawing = DRAWN(figure)
    for number in range(len(drawing.wiring.nets)):
        for line in drawing.wiring.segments(number, drawing.x, drawing.ends):
            if line[0][0] == line[1][0]:
                assert not any(lies_in(line, frame, 0.05) for frame in frames)


def test_every_input_is_connected_to_what_feeds_it(figure):
    """Follow each wire from its output; it reaches the inputs that the program names, and no others."""
    cells, drawing = Cells(figure), DRAWN(figure)
    wiring, reached = drawing.wiring, set()
    for number, net in enumerate(wiring.nets):
        pieces = wiring.segments(number, drawing.x, drawing.ends)
        touched, waiting = set(), [(drawing.ends(net.start)[1], wiring.middle(net.start))]
        while waiting:
            point = waiting.pop()
            for k, (a, b) in enumerate(pieces):
                if k not in touched and on_line(point, a, b):
                    touched.add(k)
                    waiting += [a, b, *(p for c, d in pieces for p in (c, d) if on_line(p, a, b))]
        assert touched == set(range(len(pieces)))
        for end, port in net.ends:
            place = (drawing.ends(end)[0], wiring.port(end, port))
            assert any(on_line(place, a, b) for a, b in pieces)
            reached.add((end, port))
    wanted = {(i, k) for i, cell in enumerate(cells.cells) for k, port in enumerate(cell.ports) if port.source is None}
    assert reached == wanted
    rows = [port for cell in cells.cells for port in cell.ports]
    inside = {i for port in rows for i in (port.pot, port.source) if i is not None}
    assert inside | set(cells.numbers) == set(range(len(figure.elements)))


def on_line(point, a, b):
    return all(min(s, t) - 1e-6 <= p <= max(s, t) + 1e-6 for p, s, t in zip(point, a, b, strict=True))


def test_it_is_drawn_in_both_formats_and_told(figure):
    drawn = drawing_of(figure)
    picture, text = figures.svg(drawn), figures.tikz(drawn)
    assert picture.startswith("<svg")
    assert picture == figures.svg(drawn)
    assert dark_style() in picture
    for each in figure.elements:
        if each.kind != "source" or each.output:
            assert f"${each.name if each.kind != 'source' else each.value}$" in text
            assert f"{each.kind.replace('pot', 'potentiometer')} ".capitalize() in drawn.alt
        assert (
            each.value == "" or f"${each.value}$" in text or not Cells(figure).destinations[figure.elements.index(each)]
        )
    assert drawn.alt.startswith("Patch diagram.")


def test_textbook_programs_have_no_crossing():
    for name in ("first", "static", "order 2", "order 3", "order 5", "zeros 2", "zeros 3", "two states"):
        assert DRAWN(PROGRAMS[name]).wiring.quality[0] == 0, name
    assert DRAWN(PROGRAMS["three states"]).wiring.quality[0] <= 2


def test_a_second_order_equation_is_read_from_left_to_right_with_a_dot_where_it_branches():
    figure = chain(2)
    drawing = DRAWN(figure)
    places = {figure.elements[cell.element].name: drawing.ends(n)[0] for n, cell in enumerate(drawing.cells)}
    assert places["A_{1}"] < places["A_{2}"]
    dots = [each for each in layout_of(figure) if isinstance(each, Dot)]
    assert dots
    lines = [each.points for each in layout_of(figure) if isinstance(each, Line)]
    for dot in dots:
        assert sum(on_line((dot.x, dot.y), *points) for points in lines) >= 2


def test_the_told_program_can_be_patched_from_the_words():
    told = drawing_of(STATIC).alt
    assert "Summer A₂, fed by A₁ (gain 1), v₁ (gain 1), v₂ (gain 10), its output is vₒ" in told


def test_wires_beside_each_other_are_ordered_by_what_it_costs():
    costs = {(i, j): float(i < j) for i in range(5) for j in range(5) if i != j}
    assert ordered(range(5), costs) == [4, 3, 2, 1, 0]
    assert tracks([4, 3, 2], lambda i, j: {i, j} == {4, 2}) == {4: 0, 3: 1, 2: 2}
    assert tracks([4, 2], lambda _i, _j: True) == {4: 0, 2: 0}


def test_a_picture_too_wide_for_a_phone_scrolls_there():
    assert '<div class="scroll wide" tabindex="0"><img' in page.figure(drawing_of(dense(4, 1)))
    assert "scroll" not in page.figure(drawing_of(STATIC))
