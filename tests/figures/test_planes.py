"""Poles and zeros in their plane: where they are, what is shaded, what is told of them, in light and in the dark."""

import cmath
import re

import numpy as np
import pytest
import sympy as sp
from matplotlib.path import Path

from solver import figures
from solver.derivation.figures import Plane, Region, Roots
from solver.figures.drawing import drawing_of
from solver.figures.palette import COLOURS, DARK
from solver.figures.planes import on_plane
from solver.tasks import figures as drawn_by_tasks

A = sp.ImmutableMatrix([[0, 1, 0], [0, 0, 1], [-26, -23, -7]])
"""Its eigenvalues are \u22122 and (\u22125 \u00b1 j\u221a27)/2."""


def plane(*values, **further):
    return Plane("Poles", (Roots("poles", values),), **further)


def curves(figure, style):
    return [each for each in on_plane(figure).curves if each.style == style]


def test_the_crosses_stand_where_numpy_finds_the_eigenvalues():
    (figure,) = drawn_by_tasks.plane("", drawn_by_tasks.eigenvalues_of("poles", A))
    (crosses,) = curves(figure, "cross")
    found = np.sort_complex(np.array(crosses.x) + 1j * np.array(crosses.y))
    assert np.allclose(found, np.sort_complex(np.linalg.eigvals(np.array(A, dtype=float))))


def test_roots_on_each_other_are_one_sign_with_their_number():
    figure = plane(-2, -2, -2, sp.Integer(1))
    (crosses,) = curves(figure, "cross")
    assert (crosses.x, crosses.y) == ((-2.0, 1.0), (0.0, 0.0))
    (mark,) = on_plane(figure).marks
    assert (mark.x, mark.label, mark.sign) == (-2.0, r"3\times", "none")


@pytest.mark.parametrize("values", [(-1,), (0, 0), (5 * sp.I, -5 * sp.I), (-100, -1), (2 + sp.I, 2 - sp.I)])
@pytest.mark.parametrize("discrete", [False, True])
def test_the_window_holds_the_roots_the_origin_and_the_unit_circle(values, discrete):
    plot = on_plane(plane(*values, discrete=discrete))
    left, right, low, high = plot.window
    points = [*map(complex, values), 0, *((1, -1, 1j, -1j) if discrete else ())]
    assert all(left < complex(p).real < right and low < complex(p).imag < high for p in points)
    assert low == -high


REGIONS = {
    "damping": Region(damping=sp.Rational(1, 2)),
    "decay": Region(decay=2),
    "both": Region(sp.Rational(7, 10), 1),
    "frequency": Region(decay=1, frequency=3),
    "all": Region(sp.Rational(1, 2), 1, 5, 2),
}


@pytest.mark.parametrize("name", REGIONS)
def test_shaded_is_where_a_pole_meets_the_specifications(name):
    region = REGIONS[name]
    figure = plane(-4 + 4 * sp.I, -4 - 4 * sp.I, region=region)
    left, right, low, high = on_plane(figure).window
    areas = [Path(list(zip(each.x, each.y, strict=True))) for each in curves(figure, "area")]
    random = np.random.default_rng(1)
    for x, y in zip(random.uniform(left, right, 300), random.uniform(low, high, 300), strict=True):
        damping = -x / abs(complex(x, y))
        meets = damping >= (region.damping or -1) and -x >= (region.decay or -1e9) and abs(y) >= (region.frequency or 0)
        assert any(area.contains_point((x, y)) for area in areas) == meets, (x, y)


@pytest.mark.parametrize("discrete", [False, True])
def test_shaded_is_where_modes_die_out(discrete):
    (area,) = curves(plane(-1, 1, discrete=discrete, stable=True), "area")
    shape = Path(list(zip(area.x, area.y, strict=True)))
    for z in (0.5 + 0.5j, -0.9, -1.2 + 0.1j, -0.01 + 0.99j, 1.1, 0.2 - 0.5j):
        assert shape.contains_point((z.real, z.imag)) == (abs(z) < 1 if discrete else z.real < 0)


def test_lines_are_drawn_at_the_bounds():
    names = {each.label: each for each in curves(plane(-4, region=REGIONS["all"]), "guide")}
    zeta, sigma, omega = names[r"\sym{damping_ratio} = 0.5"], names[r"\sigma = 1"], names[r"\omega_d = 2"]
    assert -cmath.exp(1j * cmath.phase(complex(zeta.x[-1], zeta.y[-1]))).real == pytest.approx(0.5)
    assert set(sigma.x) == {-1.0}
    assert set(omega.y) == {2.0}
    circle = names[r"\omega_n = 5"]
    assert np.allclose(np.hypot(circle.x, circle.y), 5)


@pytest.mark.parametrize(
    ("figure", "says"),
    [
        (plane(-1, -2 + 3 * sp.I, -2 - 3 * sp.I), "Poles (3): \u22122 \u00b1 3j, \u22121; all in the left half plane."),
        (plane(2), "Poles (1): 2; in the right half plane."),
        (plane(-1, -1, 0), "Poles (3): \u22121 (2\u00d7), 0; 2 in the left half plane, 1 on the imaginary axis."),
        (plane(sp.I, -sp.I), "Poles (2): \u00b1j; all on the imaginary axis."),
        (plane(1 + sp.I, discrete=True), "Poles (1): 1 + j; outside the unit circle."),
        (
            plane(sp.Rational(-1, 2), -1, discrete=True),
            "\u22121, \u22120.5; 1 inside the unit circle, 1 on the unit circle.",
        ),
        (Plane("", (Roots("zeros", (), "ring"), Roots("poles", (-1,)))), "Zeros: none. Poles (1): \u22121;"),
        (plane(-2, region=Region(sp.Rational(1, 2), 1)), "\u2265 0.5, \u03c3 \u2265 1."),
    ],
)
def test_what_is_seen_is_told(figure, says):
    assert says in drawing_of(figure).alt


def test_roots_with_parameters_are_not_drawn():
    a = sp.Symbol("a")
    assert drawn_by_tasks.plane("", drawn_by_tasks.roots("poles", [a, -1])) == ()
    assert drawn_by_tasks.eigenvalues_of("poles", sp.ImmutableMatrix([[a]])) is None


def test_each_set_has_a_sign_and_a_colour_of_its_own_on_the_screen_and_on_paper():
    sets = tuple(Roots(sign, (-i,), sign) for i, sign in enumerate(("cross", "ring", "square", "diamond"), 1))
    paper = figures.tikz(drawing_of(Plane("", sets)))
    assert re.findall(r"(curve\d), only marks, mark=(\w+)", paper) == [
        ("curve0", "x"), ("curve1", "o"), ("curve2", "square"), ("curve3", "diamond")
    ]  # fmt: skip
    assert re.findall(r"\\addlegendentry\{\$\\text\{(\w+)\}\$\}", paper) == ["cross", "ring", "square", "diamond"]
    assert "at={(xticklabel cs:0.5," in paper  # below the label of the abscissa, wherever that is
    assert "legend cell align=left" in paper
    screen = figures.svg(drawing_of(Plane("", sets)))
    assert all(f"stroke: {colour}" in screen for colour in COLOURS[:4])


def test_every_colour_of_a_drawing_has_one_for_the_dark():
    drawing = figures.svg(drawing_of(plane(-1, 2, stable=True)))
    rules, rest = re.search(r"<style>@media screen(.*?)</style>(.*)", drawing, re.DOTALL).groups()
    used = set(re.findall(r"(?:fill|stroke): (#[0-9a-f]{6})", rest))
    assert used <= set(DARK)
    assert all(f"{colour}" in rules for colour in used)


def luminance(colour):
    parts = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return float(np.dot(linear, [0.2126, 0.7152, 0.0722]))


@pytest.mark.parametrize("colour", COLOURS)
def test_curves_are_seen_on_white_and_in_the_dark(colour):
    """A contrast of three to one, as WCAG 2.1 (1.4.11) asks of graphics."""
    dark, paper = luminance(DARK[colour]), luminance(DARK["#ffffff"])
    assert 1.05 / (luminance(colour) + 0.05) > 3
    assert (dark + 0.05) / (paper + 0.05) > 3
