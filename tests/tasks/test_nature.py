"""What an extremal is: the verdict of the lemma, its steps and claims, beside the sign of the second variation."""

import pytest
import sympy as sp

from solver import exact
from solver.derivation import CheckStatus
from solver.jets import jet_symbol
from solver.numeric import check_steps
from solver.numeric.judges import variations as judges
from solver.render.wording import Wording
from solver.systems.ends import End
from solver.systems.functional import Functional
from solver.tasks.variations.extremal_checks import problem_of
from solver.tasks.variations.found_extremal import Extremal
from solver.tasks.variations.nature import nature_of

t, a, b = sp.Symbol("t"), sp.Symbol("a", positive=True), sp.Symbol("b", real=True)
x, rate, second = (jet_symbol(("x", k)) for k in range(3))
y, y_rate = (jet_symbol(("y", k)) for k in range(2))
HALF, CONVEX = sp.Rational(1, 2), ["legendre", "convexity", "verdict"]
JACOBI = ["characteristic", "homogeneous", "from_start", "zero"]


def judged(phi, stop, ends, functions, *, start=0, cost=0):
    """The nature that is found, the kinds of the steps, and whether the numbers agree."""
    names = tuple(functions)
    jets = {jet_symbol((name, k)): (name, k) for name in names for k in range(3)}
    pairs = {(name, 0): tuple(End(each if each is None else sp.sympify(each)) for each in pair)
             for name, pair in ends.items()}  # fmt: skip
    system = Functional(phi, names, sp.sympify(start), sp.sympify(stop), pairs, sp.sympify(cost), (), (), jets)
    found = Extremal(phi, {name: sp.sympify(f) for name, f in functions.items()}, {}, sp.sympify(stop))
    derivation, steps = nature_of(system, found), []
    while True:
        try:
            steps.append(next(derivation))
        except StopIteration as last:
            nature = last.value
            break
    assert all(check.status is CheckStatus.PASSED for check in check_steps(steps))
    for detail in ("brief", "full", "tutor"):
        assert len(Wording(detail=detail).words(steps)) == len(steps)
    problem = problem_of(system)
    assert judges.legendre_residual(problem, found.x, nature.legendre) < 1e-7
    if nature.conjugate_point is not None:
        assert judges.conjugate_residual(problem, found.x, nature.conjugate_point) < 1e-7
    agrees = nature.verdict is None or judges.nature_holds(problem, found.x, nature.verdict)
    return nature, [step.kind for step in steps], agrees


FIXED = {"x": (0, 1)}
CASES = [
    (x**2 - rate**2, sp.pi / 2, FIXED, {"x": sp.sin(t)}, "maximum", sp.pi),
    (rate**2 - x**2, 4, FIXED, {"x": sp.sin(t) / sp.sin(4)}, "neither", sp.pi),
    (rate**2 - x**2, sp.pi, {"x": (0, 0)}, {"x": 3 * sp.sin(t)}, "undecided", sp.pi),
    (rate**2 + 12 * t * x, 1, FIXED, {"x": t**3}, "minimum", None),
    (rate**2 + 12 * t * x, 1, {"x": (0, None)}, {"x": t**3 - 3 * t}, "minimum", None),
    (sp.sqrt(1 + rate**2), 1, FIXED, {"x": t}, "minimum", None),
    (rate**3, 1, FIXED, {"x": t}, "minimum", None),
    (-(rate**2) - x**4, 1, {"x": (0, 0)}, {"x": 0}, "maximum", None),
    (a * rate**2 - x**2, 1, {"x": (0, 0)}, {"x": 0}, "undecided", sp.pi * sp.sqrt(a)),
    (b * rate**2, 1, FIXED, {"x": t}, "undecided", None),
    (x**2 * rate**2, 1, {"x": (1, 2)}, {"x": sp.sqrt(1 + 3 * t)}, "minimum", None),
    ((2 * t - 1) * rate**2, 1, {"x": (0, 0)}, {"x": 0}, "neither", None),
    (rate**2 - x**2, 1, {"x": (None, 1)}, {"x": sp.cos(t) / sp.cos(1)}, "minimum", None),
    (rate**2 - x**2, 1, {"x": (None, None)}, {"x": 0}, "neither", None),
    (rate**2 - x**2, 2, {"x": (None, 0)}, {"x": 0}, "neither", None),
    (rate**2 - x**2, 1, {"x": (0, None)}, {"x": 0}, "minimum", sp.pi),
    (rate**2 - x**2, 2, {"x": (0, None)}, {"x": 0}, "neither", sp.pi),
    (rate**2 + y_rate**2 - y**2, 1, FIXED | {"y": (0, 1)}, {"x": t, "y": sp.sin(t) / sp.sin(1)}, "minimum", sp.pi),
    (rate**2 + y_rate**2 + 2 * x * y, sp.pi / 2, FIXED | {"y": (0, -1)}, {"x": sp.sin(t), "y": -sp.sin(t)}, "minimum",
     sp.pi),
    (rate**2 + y_rate**2 - (x + y) ** 2, 4, {"x": (0, 0), "y": (0, 0)}, {"x": 0, "y": 0}, "neither",
     sp.sqrt(2) * sp.pi / 2),
    (rate**2 - y_rate**2, 1, FIXED | {"y": (0, 1)}, {"x": t, "y": t}, "neither", None),
    (rate**2 + y_rate**2 + rate * y - x * y_rate, 1, {"x": (0, 0), "y": (0, 0)}, {"x": 0, "y": 0}, None, None),
]  # fmt: skip


@pytest.mark.parametrize(
    ("phi", "stop", "ends", "functions", "verdict", "point"), CASES, ids=[str(c[0]) for c in CASES]
)
def test_the_verdict_and_the_conjugate_point(phi, stop, ends, functions, verdict, point):
    nature, _, agrees = judged(phi, stop, ends, functions)
    assert nature.verdict == verdict
    assert agrees
    assert (nature.conjugate_point is None) == (point is None)
    assert point is None or sp.expand(nature.conjugate_point - point) == 0


def test_the_steps():
    _, kinds, _ = judged(x**2 - rate**2, sp.pi / 2, FIXED, {"x": sp.sin(t)})
    assert kinds == ["legendre", "jacobi", "standard_form", *JACOBI, "verdict"]
    _, kinds, _ = judged(rate**2 + x**2, 1, FIXED, {"x": sp.sinh(t) / sp.sinh(1)})
    assert kinds == CONVEX


@pytest.mark.parametrize(("weight", "verdict"), [(1, "minimum"), (-1, "minimum"), (-2, "neither")])
def test_a_terminal_cost_counts_at_a_free_end(weight, verdict):
    """With the variations c sin t it adds `weight` sin²(1) to cos(1) sin(1)."""
    nature, kinds, agrees = judged(rate**2 - x**2, 1, {"x": (0, None)}, {"x": 0}, cost=weight * x**2 * HALF)
    assert (nature.verdict, agrees) == (verdict, True)
    assert "free_end" in kinds


def test_a_higher_order_is_decided_by_convexity_only():
    ends = {"x": (0, 1)}
    nature, kinds, _ = judged(second**2, 1, ends, {"x": (3 * t**2 - t**3) / 2})
    assert nature.verdict == "minimum"
    assert kinds == CONVEX
    nature, _, _ = judged(second**2 - x**2, 1, ends, {"x": t})
    assert nature.verdict is None


def test_euler_cauchy_for_jacobi():
    nature, kinds, agrees = judged(t**2 * rate**2 - x**2, 2, {"x": (0, 0)}, {"x": 0}, start=1)
    assert (nature.verdict, agrees) == ("minimum", True)
    assert nature.conjugate_point == sp.exp(2 * sp.sqrt(3) * sp.pi / 3)
    assert "indicial" in kinds


@pytest.mark.parametrize(
    ("u", "point"),
    [
        (sp.exp(-t) * sp.sin(2 * t) / 2, sp.pi / 2),
        (sp.sinh(a * t) / a, None),
        (t * sp.exp(-t), None),
        (t - t**2 / 3, 3),
        (t * sp.cos(t), sp.pi / 2),
        (3 * sp.sin(t) / 2 - sp.sin(2 * t) / 4, sp.pi),
    ],
)
def test_first_zeros(u, point):
    found = exact.conjugate(u, t, sp.S.Zero, sp.S(2))
    assert (found.point is None) == (point is None)
    assert point is None or abs(sp.N(found.point - point)) < 1e-12
