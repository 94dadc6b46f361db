"""What must hold of root loci holds of what is found, and of nothing that is a little wrong."""

from dataclasses import replace

import pytest
import sympy as sp

from solver import exact
from solver.derivation import CheckStatus
from solver.lazy import Call
from solver.postconditions import check_calls

s = sp.Symbol("s")
EQUATION = exact.locus_equation(sp.expand((s + 1) * (s + 7)), sp.expand(s * (s - 1) * (s**2 + 4 * s + 16) * (s + 7)), s)
ANGLED = exact.locus_equation(s**2 + 2 * s + 5, sp.expand((s + 1) * (s + 2) * (s**2 + 1)), s)


def statuses(kernel, result, *arguments):
    return {check.status for check in check_calls([Call(kernel, arguments, {}, result, 1)], [])}


@pytest.mark.parametrize(
    "kernel",
    ["real_points", "real_axis_segments", "asymptotes", "turning_polynomial", "meetings", "on_boundary",
     "crossings", "stable_gains", "departures", "arrivals"],
)  # fmt: skip
@pytest.mark.parametrize("equation", [EQUATION, ANGLED])
def test_what_is_found_holds(kernel, equation):
    assert statuses(kernel, getattr(exact, kernel)(equation), equation) <= {CheckStatus.PASSED}


def wrong():
    """Kernels with results that are a little wrong."""
    found = exact.asymptotes(EQUATION)
    yield "asymptotes", replace(found, centroid=found.centroid + sp.Rational(1, 1000)), EQUATION
    yield "asymptotes", replace(found, angles=found.angles[::-1][1:]), EQUATION
    yield "asymptotes", None, EQUATION
    meetings = exact.meetings(EQUATION)
    yield "meetings", meetings[1:], EQUATION
    yield "meetings", (replace(meetings[0], gain=meetings[0].gain * 2), *meetings[1:]), EQUATION
    yield "meetings", (replace(meetings[0], why="negative"), *meetings[1:]), EQUATION
    yield "meetings", (replace(meetings[0], branches=3), *meetings[1:]), EQUATION
    crossings = exact.crossings(EQUATION)
    yield "crossings", crossings[1:], EQUATION
    yield "crossings", (replace(crossings[0], gain=crossings[1].gain), crossings[1]), EQUATION
    yield "crossings", (replace(crossings[0], place=-crossings[0].place), crossings[1]), EQUATION
    ranges = exact.stable_gains(EQUATION)
    yield "stable_gains", ranges[1:], EQUATION
    yield "stable_gains", (replace(ranges[0], outside=1), *ranges[1:]), EQUATION
    (leaving, *others) = exact.departures(ANGLED)
    yield "departures", (replace(leaving, angles=(leaving.angles[0] + 1,)), *others), ANGLED
    yield "departures", (replace(leaving, arrows=leaving.arrows[1:]), *others), ANGLED
    yield "departures", (replace(leaving, total=leaving.total + 360), *others), ANGLED
    yield "arrivals", (), ANGLED
    yield "real_axis_segments", [sp.Interval(0, 1)], EQUATION
    yield "real_points", exact.real_points(EQUATION)[1:], EQUATION
    yield "turning_polynomial", exact.turning_polynomial(EQUATION) + 1, EQUATION
    axis = exact.on_boundary(EQUATION)
    yield "on_boundary", replace(axis, eliminated=axis.eliminated + 1), EQUATION


@pytest.mark.parametrize(("kernel", "result", "equation"), list(wrong()))
def test_what_is_a_little_wrong_does_not(kernel, result, equation):
    assert CheckStatus.FAILED in statuses(kernel, result, equation)


def test_common_factors_and_roots():
    given = (sp.expand((s + 1) * (s + 7)), sp.expand(s * (s - 1) * (s**2 + 4 * s + 16) * (s + 7)), s)
    assert statuses("locus_equation", EQUATION, *given) == {CheckStatus.PASSED}
    other = replace(EQUATION, common=EQUATION.common * 2)
    assert CheckStatus.FAILED in statuses("locus_equation", other, *given)
    p = EQUATION.denominator
    roots = exact.roots_with_factors(p)
    assert statuses("roots_with_factors", roots, p) == {CheckStatus.PASSED}
    assert CheckStatus.FAILED in statuses("roots_with_factors", roots[1:], p)
