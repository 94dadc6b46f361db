"""Judges of extremals accept what is right and reject what is a little wrong, whatever found it."""

import pytest
import sympy as sp

from solver.jets import jet_symbol
from solver.numeric.judges import variations as judges
from solver.numeric.judges.variations import End, Problem

t, a = sp.Symbol("t"), sp.Symbol("a", positive=True)
x, rate, second = (jet_symbol(("x", k)) for k in range(3))
y, y_rate = (jet_symbol(("y", k)) for k in range(2))
x1, x1_rate, x2, x2_rate, u = (jet_symbol(jet) for jet in (("x1", 0), ("x1", 1), ("x2", 0), ("x2", 1), ("u", 0)))
S = sp.S


def value(v):
    return End(value=sp.sympify(v))


def problem(integrand, start, stop, ends, functions=("x",), **others):
    jets = {jet_symbol((name, k)): (name, k) for name in functions for k in range(3)}
    end = None if stop is None else sp.sympify(stop)
    return Problem(integrand, t, functions, jets, sp.sympify(start), end, ends, others.pop("cost", S.Zero), **others)


FREE = End()
WAVES = problem(x**2 - rate**2, 0, sp.pi / 2, {("x", 0): (value(0), value(1))})
NATURAL = problem(rate**2 + 12 * t * x, 0, 1, {("x", 0): (value(0), FREE)})
LINE = problem(sp.sqrt(1 + rate**2), 0, None, {("x", 0): (value(0), End(curve=2 - t))})
BOUND = problem(rate**2, 0, 1, {("x", 0): (value(0), value(0))}, integrals=[(x, S.One)])
BEAM = problem(second**2, 0, 1, {("x", 0): (value(0), value(1)), ("x", 1): (value(0), value(0))})
WITH_COST = problem(rate**2 / 2 + x**2 / 2, 0, 1, {("x", 0): (value(1), FREE)}, cost=x**2 / 2)
DRIVEN = problem(
    u**2 / 2, 0, 1, {("x1", 0): (value(1), value(0)), ("x2", 0): (value(1), value(0))}, ("x1", "x2", "u"),
    constraints=[x1_rate - x2, x2_rate - u],
)  # fmt: skip
SCALED = problem(rate**2 + a**2 * x**2, 0, 1, {("x", 0): (value(0), value(1))})

RIGHT = [
    (WAVES, {"x": sp.sin(t)}, None, 0, t * (sp.pi / 2 - t)),
    (NATURAL, {"x": t**3 - 3 * t}, None, -sp.Rational(24, 5), t**2),
    (LINE, {"x": t}, S.One, sp.sqrt(2), t * (1 - t)),
    (BOUND, {"x": 6 * t * (1 - t)}, None, 12, t * (1 - t) * (1 - 2 * t)),
    (BEAM, {"x": 3 * t**2 - 2 * t**3}, None, 12, t**2 * (1 - t) ** 2),
    (WITH_COST, {"x": sp.exp(-t)}, None, sp.Rational(1, 2), t * (1 - t)),
    (DRIVEN, {"x1": 3 * t**3 - 5 * t**2 + t + 1, "x2": 9 * t**2 - 10 * t + 1, "u": 18 * t - 10}, None, 14, None),
    (SCALED, {"x": sp.sinh(a * t) / sp.sinh(a)}, None, a * sp.cosh(a) / sp.sinh(a), t * (1 - t)),
]
IDS = ["waves", "natural", "line", "bound", "beam", "with_cost", "driven", "scaled"]


@pytest.mark.parametrize(("asked", "found", "t_f", "least", "_"), RIGHT, ids=IDS)
def test_an_extremal_is_accepted(asked, found, t_f, least, _):
    for residual in (judges.stationary_residual, judges.ends_residual, judges.first_variation_residual):
        assert residual(asked, found, t_f) < 1e-7
    assert judges.constraints_residual(asked, found, t_f) < 1e-7
    assert judges.value_residual(asked, found, sp.sympify(least), t_f) < 1e-7
    assert judges.value_residual(asked, found, sp.sympify(least) + sp.Rational(1, 1000), t_f) > 1e-5


@pytest.mark.parametrize(("asked", "found", "t_f", "_", "change"), RIGHT, ids=IDS)
def test_a_change_that_keeps_the_ends_is_rejected_twice(asked, found, t_f, _, change):
    """By the equations, and by what the change does to the functional."""
    if change is None:  # keeps the constraints as well
        h = t**3 * (1 - t) ** 2
        wrong = {"x1": found["x1"] + h, "x2": found["x2"] + sp.diff(h, t), "u": found["u"] + sp.diff(h, t, 2)}
    else:
        wrong = {"x": found["x"] + change / 50}
    assert judges.stationary_residual(asked, wrong, t_f) > 1e-4
    assert judges.first_variation_residual(asked, wrong, t_f) > 1e-4


def test_ends_and_constraints_that_are_missed_are_seen():
    assert judges.ends_residual(WAVES, {"x": sp.cos(t)}) > 0.5
    assert judges.ends_residual(BEAM, {"x": t}) > 0.5
    assert judges.ends_residual(LINE, {"x": t}, sp.Rational(9, 10)) > 0.1
    assert judges.constraints_residual(BOUND, {"x": 5 * t * (1 - t)}) > 0.1
    assert judges.constraints_residual(DRIVEN, {"x1": t, "x2": t, "u": S.One}) > 0.1


def test_another_end_time_is_no_transversal_one():
    """The straight line to another point of the curve solves the equation and meets the curve."""
    wrong, end = {"x": t / 2}, sp.Rational(4, 3)
    assert judges.ends_residual(LINE, wrong, end) < 1e-9
    assert judges.stationary_residual(LINE, wrong, end) > 0.1
    assert judges.first_variation_residual(LINE, wrong, end) > 0.1
    assert judges.end_residual(LINE, S.One) < 1e-8
    assert judges.end_residual(LINE, end) > 0.1


def test_a_fixed_end_is_not_free():
    assert judges.stationary_residual(NATURAL, {"x": t**3}) > 0.1


@pytest.mark.parametrize(("asked", "found", "t_f", "least", "_"), RIGHT, ids=IDS)
def test_a_value_alone_is_judged_by_an_extremal_found_directly(asked, found, t_f, least, _):
    assert judges.value_residual(asked, None, sp.sympify(least)) < 1e-7
    assert judges.value_residual(asked, None, sp.sympify(least) * sp.Rational(101, 100) + sp.Rational(1, 100)) > 1e-4


def test_functions_that_are_missing_or_hold_other_names_are_wrong():
    assert judges.stationary_residual(WAVES, {}) == float("inf")
    assert judges.legendre_residual(WAVES, {"x": sp.sin(t)}, x) == float("inf")


def test_second_derivatives_along_an_extremal():
    assert judges.legendre_residual(WAVES, {"x": sp.sin(t)}, S(-2)) < 1e-9
    assert judges.legendre_residual(WAVES, None, S(2)) > 1
    curved = problem(x * sp.sqrt(1 + rate**2), 0, 1, {("x", 0): (value(1), value(sp.cosh(1)))})
    assert judges.legendre_residual(curved, {"x": sp.cosh(t)}, 1 / sp.cosh(t) ** 2) < 1e-9
    assert judges.legendre_residual(curved, {"x": sp.cosh(t)}, 1 / sp.cosh(t) ** 3) > 1e-2
    two = problem(rate**2 + y_rate**2 + rate * y_rate, 0, 1, {}, ("x", "y"))
    assert judges.legendre_residual(two, {"x": t, "y": t}, sp.ImmutableMatrix([[2, 1], [1, 2]])) < 1e-9
    assert judges.legendre_residual(two, {"x": t, "y": t}, S(2)) == float("inf")


def test_conjugate_points():
    found = {"x": sp.sin(t)}
    assert judges.conjugate_residual(WAVES, found, sp.pi) < 1e-8
    for wrong in (sp.pi / 2, 2 * sp.pi, S(-1), None):
        assert judges.conjugate_residual(WAVES, found, wrong) > 0.1
    assert judges.conjugate_residual(SCALED, {"x": sp.sinh(a * t) / sp.sinh(a)}, None) == 0
    catenary = problem(x * sp.sqrt(1 + rate**2), -1, 1, {("x", 0): (value(sp.cosh(1)), value(sp.cosh(1)))})
    assert judges.conjugate_residual(catenary, {"x": sp.cosh(t)}, sp.Float("1.433605197053977")) < 1e-8


NATURES = [
    (WAVES, {"x": sp.sin(t)}, None, "maximum"),
    (NATURAL, {"x": t**3 - 3 * t}, None, "minimum"),
    (LINE, {"x": t}, S.One, "minimum"),
    (BOUND, {"x": 6 * t * (1 - t)}, None, "minimum"),
    (BEAM, {"x": 3 * t**2 - 2 * t**3}, None, "minimum"),
    (problem(rate**2 - x**2, 0, 4, {("x", 0): (value(0), value(1))}), {"x": sp.sin(t) / sp.sin(4)}, None, "neither"),
    (problem(rate**2 - x**2, 0, sp.pi, {("x", 0): (value(0), value(0))}), {"x": sp.sin(t)}, None, "undecided"),
    (problem(rate**2 - x**2, 0, 3, {("x", 0): (value(0), value(0))}), {"x": S.Zero * t}, None, "minimum"),
    (problem(rate**2 - x**2, 0, 2, {("x", 0): (value(0), FREE)}), {"x": S.Zero * t}, None, "neither"),
    (
        problem((t - sp.Rational(1, 2)) * rate**2, 0, 1, {("x", 0): (value(0), value(0))}),
        {"x": S.Zero},
        None,
        "neither",
    ),
]


@pytest.mark.parametrize(("asked", "found", "t_f", "nature"), NATURES)
def test_only_the_right_nature_fits(asked, found, t_f, nature):
    wrong = {"minimum", "maximum", "neither", "undecided"} - {nature}
    if asked in (LINE, BOUND):  # where other conditions than those of fixed ends count, it may be left undecided
        wrong -= {"undecided"}
    assert judges.nature_holds(asked, found, nature, t_f)
    assert not any(judges.nature_holds(asked, found, other, t_f) for other in wrong)
