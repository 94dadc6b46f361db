"""What is told of a figure to whoever cannot see it: paths in a plane, chains of integrators, symbols as they are."""

from math import cos, pi, sin

import sympy as sp

from solver.derivation.figures import Chains, DrawnCurve, DrawnPlot, Plane, Region, Roots
from solver.figures.alternatives import of_chains, of_plot
from solver.figures.decompositions import _modes
from solver.figures.planes import on_plane
from solver.words import Phrase


def say(text):
    return str(text) if isinstance(text, Phrase) else text


def path(label, points):
    xs, ys = zip(*points, strict=True)
    return DrawnCurve(label, "solid", tuple(xs), tuple(ys))


def spiral(shrinking):
    return [(shrinking**i * cos(i / 3), shrinking**i * sin(i / 3)) for i in range(40)]


def plot(*curves):
    return DrawnPlot("", "x_1", "x_2", curves, (), False, None)


def test_a_closed_path_is_told_by_what_it_encloses():
    circle = [(cos(2 * pi * i / 60), sin(2 * pi * i / 60)) for i in range(61)]
    assert of_plot(plot(path("s", circle)), say) == "s is closed, from −1 to 1 across and from −1 to 1 up."


def test_a_path_that_turns_back_is_told_by_its_ends():
    assert "s leads from (1, 0) to (" in of_plot(plot(path("s", spiral(0.95))), say)


def test_many_paths_are_told_together():
    inward = of_plot(plot(*(path("", spiral(0.9)) for _ in range(4))), say)
    assert inward.startswith("4 paths, from (1, 0), (1, 0)")
    assert inward.endswith("all of them come nearer to the origin.")
    assert "go away from it" in of_plot(plot(*(path("", spiral(1.1)) for _ in range(4))), say)


def test_a_function_of_time_is_told_by_its_ends_and_keeps_its_letter():
    curve = DrawnCurve("y_{r}", "solid", (0.0, 1.0, 2.0), (0.0, 2.0, 1.0))
    assert of_plot(DrawnPlot("", "t", "y", (curve,), (), False, None), say).startswith(
        "yᵣ from 0 at t = 0 to 1 at t = 2, largest 2"
    )


def test_chains_are_told_by_what_enters_each_integrator():
    figure = Chains("", ((1, 0),), (("", "1"), ("-6", "-5")), ("", "1"), ("3", "1"))
    told = of_chains(figure, say)
    assert "What enters the integrator of x₁: x₂." in told
    assert "What enters the integrator of x₂: −6x₁ − 5x₂ + u." in told
    assert told.endswith("Output: 3x₁ + x₂.")


def test_a_minus_after_a_comma_is_a_sign():
    part = type("P", (), {"modes": ("-2", "-1")})
    assert _modes(part) == r"\lambda = {-2},\ {-1}"


def test_the_name_of_a_ray_of_damping_stands_half_way_along_it():
    poles = Roots("poles", (sp.sympify(-2) + 2 * sp.I, sp.sympify(-2) - 2 * sp.I))
    drawn = on_plane(Plane("", (poles,), region=Region(damping=sp.Rational(7, 10), decay=sp.Integer(2))))
    rays = [each for each in drawn.curves if each.style == "guide" and len(each.x) == 2 and each.x[0] == 0.0]
    (name,) = [each for each in drawn.curves if each.style == "guide" and len(each.x) == 1]
    assert (name.x[0], name.y[0]) == (rays[0].x[1] / 2, rays[0].y[1] / 2)
    assert not any(each.label for each in rays)
