"""The schematic of a mechanical system: rods are found, boxes and discs told apart, and both pictures hold the same."""

import re
from itertools import combinations
from math import atan2, cos, degrees, hypot, radians, sin

import pytest

from solver import figures
from solver.engine import solve_problem
from solver.figures.drawing import drawing_of
from solver.figures.layout import Label
from solver.figures.mechanism_layout import bounds_of, frame_of, layout_of
from solver.figures.palette import dark_style
from solver.figures.strokes import Line, Ring, Shape
from solver.messages import Messages
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from solver.tasks.modelling.mechanism_figures import mechanism_of


def given(coordinates, bodies, more="", inputs=""):
    inside = f"coordinates: [{coordinates}], bodies: [{bodies}]" + (f", {more}" if more else "")
    return f"lagrangian: {{{inside}}}" + (f", inputs: [{inputs}]" if inputs else "")


def at(mass, x, y, more=""):
    return f'{{mass: {mass}, position: ["{x}", "{y}"]{more}}}'


CART = at("m_c", "x", "0")
DRAWN = {
    "cart": given("x, theta", f"{CART}, " + at("m_p", "x + l sin(theta)", "l cos(theta)", ", inertia: J, angle: theta"),
                  "gravity: g, dissipation: b x'^2/2, forces: {x: u - d x'}", "u"),
    "listed last": given("x, theta", at("m_p", "x + l sin(theta)", "l cos(theta)") + f", {CART}"),
    "other side": given("x, theta", f"{CART}, " + at("m_p", "x - l sin(theta)", "l cos(theta)")),
    "crane": given("x, theta", f"{CART}, " + at("m_p", "x + l sin(theta)", "-l cos(theta)"), "gravity: g"),
    "double": given("a, b", at("m1", "l1 sin(a)", "-l1 cos(a)") + ", "
                    + at("m2", "l1 sin(a) + l2 sin(b)", "-l1 cos(a) - l2 cos(b)"), "gravity: g"),
    "relative": given("a, b", at("m1", "l1 sin(a)", "-l1 cos(a)") + ", "
                      + at("m2", "l1 sin(a) + l2 sin(a + b)", "-l1 cos(a) - l2 cos(a + b)"), "gravity: g"),
    "spring pendulum": given("r, phi", at("m", "r sin(phi)", "-r cos(phi)"),
                             "gravity: g, springs: [{stiffness: k, length: r, rest: l}]"),
    "beam": given("x, theta", at("m", "x cos(theta)", "x sin(theta)") + ", {inertia: I, angle: theta}", "gravity: g"),
    "bead": given("x, theta", at("m", "x cos(theta)", "x sin(theta)"), "gravity: g"),
    "two masses": given("x1, x2", at("m_1", "x1", "0") + ", " + at("m_2", "x2", "0"),
                        "springs: [{stiffness: k_1, length: x1}, {stiffness: k_2, length: x2 - x1}], forces: {x1: u}",
                        "u"),
    "both walls": given("x", at("m", "x", "0"),
                        "springs: [{stiffness: k_1, length: x}, {stiffness: k_2, length: L - x}], forces: {x: u}", "u"),
    "hanging": given("y", at("m", "0", "-y"),
                     "gravity: g, springs: [{stiffness: k, length: y, rest: l}], forces: {y: F}",
                     "F"),
    "free": given("x, y", at("m", "x", "y"), "gravity: g, forces: {x: u}", "u"),
    "moved": given("theta", at("m", "w + l sin(theta)", "-l cos(theta)"), "gravity: g", "w"),
    "incline": given("x", at("m", "x cos(alpha)", "x sin(alpha)"), "gravity: g, forces: {x: u}", "u"),
    "wheel": given("x", at("m", "x", "0", ", inertia: J, angle: x/R"), "springs: [{stiffness: k, length: x}]"),
    "numbers": given("x, theta", at("1/2", "x", "0") + ", " + at("0.2", "x + 0.3 sin(theta)", "0.3 cos(theta)"),
                     "gravity: 9.81"),
}  # fmt: skip
SHAPES = {
    "cart": "box disc", "listed last": "box disc", "other side": "box disc", "crane": "box disc",
    "double": "disc disc support", "relative": "disc disc support", "spring pendulum": "disc support",
    "beam": "disc support", "bead": "disc support", "two masses": "box box wall", "both walls": "box wall wall",
    "hanging": "box wall", "free": "disc", "moved": "disc pivot", "incline": "box", "wheel": "disc wall",
    "numbers": "box disc",
}  # fmt: skip
LINKS = {
    "cart": "rod:l", "listed last": "rod:l", "other side": "rod:l", "crane": "rod:l", "double": "rod:l_{1} rod:l_{2}",
    "relative": "rod:l_{1} rod:l_{2}", "spring pendulum": "spring:k", "beam": "beam:I", "bead": "guide:",
    "two masses": "spring:k_{1} spring:k_{2}", "both walls": "spring:k_{1} spring:k_{2}", "hanging": "spring:k",
    "free": "", "moved": "rod:l", "incline": "", "wheel": "spring:k", "numbers": r"rod:\frac{3}{10}",
}  # fmt: skip
MEASURED = {
    "cart": 90, "listed last": 90, "other side": 90, "crane": -90, "double": -90, "relative": -90,
    "spring pendulum": -90, "beam": 0, "bead": 0, "moved": -90, "numbers": 90,
}  # fmt: skip
"""The direction that the first angle is measured from, in degrees from the right."""
NOT_DRAWN = {
    "constraint": given("x, y", at("m", "x", "y"), "gravity: g, constraints: [x^2 + y^2 = l^2]"),
    "energy": "lagrangian: {coordinates: [theta], kinetic: \"m l^2 theta'^2/2\", potential: -m g l cos(theta)}",
    "rope over a pulley": given("x", at("m", "0", "-x") + ", " + at("M", "a", "x - l"), "gravity: g"),
    "gears": given("theta", at("m", "l sin(theta)", "-l cos(theta)") + ", "
                   + at("M", "2 + l sin(theta)", "-l cos(theta)")),
    "hoop": given("phi", at("m", "a sin(phi)", "-b cos(phi)"), "gravity: g"),
    "spring with no place": given("x, y", at("m", "x", "y"), "springs: [{stiffness: k, length: x + y}]"),
    "torsion": given("theta", at("m", "l sin(theta)", "-l cos(theta)"), "springs: [{stiffness: k, length: theta}]"),
    "wheel alone": given("x, theta", at("m", "x", "0") + ", {inertia: J, angle: theta}"),
    "short rod": given("a, b", at("m", "sin(a)", "-cos(a)") + ", "
                       + at("M", "sin(a) + sin(b)/9", "-cos(a) - cos(b)/9")),
    "scaled": given("x", at("m", "2 x", "0")),
}  # fmt: skip


def problem(text, find="equations_of_motion"):
    return read_problem(Source("file.yaml", f"system: {{{text}}}\nfind: {{a: {find}}}\n"), catalogue())


def drawing(name):
    (found,) = mechanism_of(problem(DRAWN[name]).parts[0].system)
    return found


def told(name):
    return drawing_of(drawing(name), Messages().say).alt


def labels(name):
    return [each for each in layout_of(drawing(name)) if isinstance(each, Label) and each.text]


@pytest.mark.parametrize("name", DRAWN)
def test_bodies_and_what_joins_them_are_found(name):
    found = drawing(name)
    assert " ".join(sorted(each.shape for each in found.joints)) == SHAPES[name]
    assert " ".join(sorted(f"{each.kind}:{each.label}" for each in found.links)) == LINKS[name]


@pytest.mark.parametrize("name", NOT_DRAWN)
def test_what_the_rules_do_not_tell_is_not_drawn(name):
    assert mechanism_of(problem(NOT_DRAWN[name]).parts[0].system) == ()


@pytest.mark.parametrize("name", MEASURED)
def test_an_angle_begins_where_it_is_measured_from_and_ends_at_its_link(name):
    found = drawing(name)
    turn = found.turns[0]
    assert turn.start == pytest.approx(MEASURED[name], abs=0.01)
    assert abs(turn.stop - turn.start) == pytest.approx(30, abs=0.01)
    first, second = (found.joints[end].place for end in found.links[turn.link].ends)
    size = hypot(second[0] - first[0], second[1] - first[1])
    end = first[0] + size * cos(radians(turn.stop)), first[1] + size * sin(radians(turn.stop))
    assert end == pytest.approx(second, abs=1e-4)


def test_angles_between_links_are_measured_from_the_link_before():
    first, second = drawing("relative").turns
    assert second.start == pytest.approx(first.stop, abs=0.01)
    absolute = drawing("double").turns[1]
    assert absolute.start == pytest.approx(-90)
    assert "the direction of the link before" in told("relative")
    assert "the direction of the link before" not in told("double")


@pytest.mark.parametrize("name", DRAWN)
def test_positions_are_measured_to_their_bodies(name):
    found = drawing(name)
    for each in found.distances:
        place = found.joints[each.joint].place
        assert hypot(place[0] - each.start[0], place[1] - each.start[1]) > 0.5
        if each.link is not None:
            assert each.start == pytest.approx(found.joints[found.links[each.link].ends[0]].place, abs=1e-4)


@pytest.mark.parametrize("name", DRAWN)
def test_every_coordinate_mass_and_force_is_named_and_no_name_stands_on_another(name):
    found, there = drawing(name), labels(name)
    wanted = [
        *(each.label for each in (*found.joints, *found.links, *found.distances, *found.turns, *found.pushes)),
        found.gravity,
    ]
    assert sorted(each.text for each in there) == sorted(filter(None, wanted))
    for a, b in combinations(map(frame_of, there), 2):
        assert a[1] <= b[0] or b[1] <= a[0] or a[3] <= b[2] or b[3] <= a[2]


def test_names_stand_inside_the_picture():
    for name in DRAWN:
        x_min, x_max, y_min, y_max = bounds_of(layout_of(drawing(name)))
        for left, right, low, high in map(frame_of, labels(name)):
            assert x_min < left < right < x_max
            assert y_min < low < high < y_max


def test_a_mass_on_a_line_is_a_box_on_the_ground_and_a_free_one_a_disc():
    def kinds(name):
        strokes = layout_of(drawing(name))
        return sum(isinstance(s, Shape) for s in strokes), sum(isinstance(s, Ring) and not s.joint for s in strokes)

    assert kinds("cart") == (1, 1)
    assert kinds("two masses") == (2, 0)
    assert kinds("free") == (0, 1)
    assert kinds("double") == (1, 2)  # the support is a shape
    (box,) = [each for each in layout_of(drawing("two masses")) if isinstance(each, Shape)][:1]
    foot = min(y for _, y in box.points)
    ground = [s for s in layout_of(drawing("two masses")) if isinstance(s, Line) and s.style == "ink" and not s.arrow]
    assert any(all(y == pytest.approx(foot) for _, y in each.points) for each in ground)


def test_what_hangs_from_a_cart_leaves_no_ground_below_it():
    thin = [
        len([s for s in layout_of(drawing(n)) if isinstance(s, Line) and s.style == "thin"]) for n in ("crane", "cart")
    ]
    assert thin[0] <= 4 < 10 < thin[1]


def test_forces_are_those_on_positions_without_friction():
    assert [each.label for each in drawing("cart").pushes] == ["u"]
    (push,) = drawing("hanging").pushes
    assert push.direction == (0, -1)
    (slope,) = drawing("incline").pushes
    assert degrees(atan2(*slope.direction[::-1])) == pytest.approx(20, abs=0.01)


def test_the_alternative_tells_what_is_seen():
    assert told("cart") == (
        "A box of mass m_c moves along the horizontal. A rod l joins the box m_c to a disc of mass mₚ and inertia J. "
        "The position of the box m_c is x. The angle of the disc mₚ from the upward vertical is θ. "
        "The force u acts on the box m_c. Gravity g points downward."
    )
    assert told("free").startswith("A disc of mass m moves freely in the plane. The position of the disc m is x.")
    assert "On a beam I that turns about the fixed support slides a disc of mass m." in told("beam")
    assert "A spring k₁ lies between the wall and the box" in told("two masses")
    assert "moves along an incline" in told("incline")
    assert "A pivot without mass moves along the horizontal" in told("moved")


@pytest.mark.parametrize("name", DRAWN)
def test_both_pictures_hold_the_same_and_are_the_same_each_time(name):
    found = drawing_of(drawing(name))
    picture, paper = figures.svg(found), figures.tikz(found)
    assert picture == figures.svg(drawing_of(drawing(name)))
    assert dark_style() in picture
    strokes = layout_of(found)
    assert paper.count(r"\node") == len(labels(name))
    assert paper.count(" circle (") == sum(isinstance(each, Ring) for each in strokes)
    assert paper.count("-- cycle") == sum(isinstance(each, Shape) for each in strokes)
    assert paper.count(r"\draw") == sum(not isinstance(each, Label) for each in strokes)
    heads = sum(bool(each.arrow) for each in strokes if isinstance(each, Line))
    assert len(re.findall(r"\\draw\[->", paper)) == heads


@pytest.mark.parametrize("find", ["equations_of_motion", "state_space_model"])
def test_a_page_shows_the_system_at_its_first_step_and_stays_verified(find):
    part = solve_problem(problem(DRAWN["cart"], find)).parts[0]
    assert part.status.value == "verified"
    drawn = [step.kind for step in part.steps if any(type(each).__name__ == "Mechanism" for each in step.figures)]
    assert drawn == ["body"]
