"""Root loci: the equation in lowest terms, its roots, and what the rules find."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Check, Claim
from solver.numeric.judges import root_locus as judges
from solver.stated.algebra import power, product, total
from solver.stated.complex_numbers import phase

ORACLE = "mpmath: −D/N"
NEAR = 1e-9
K = sp.Symbol("K", real=True)


def _locus(equation: Any) -> judges.Locus:
    p = equation.denominator.as_expr() + K * equation.numerator.as_expr()
    return judges.locus_of(sp.expand(p), equation.denominator.gen, K, discrete=equation.discrete)


def _close(says: str, residual: float) -> Check:
    return Check.within(says, ORACLE, residual, NEAR)


def of_affine_parts(found: Any, coefficients: Sequence[Any], k: Any) -> Iterator[Claim]:
    """Both parts together are the coefficients."""
    if found is not None:
        constant, slopes = found
        whole = [c + k * slope for c, slope in zip(constant, slopes, strict=True)]
        yield Claim(sp.ImmutableMatrix([list(coefficients)]), sp.ImmutableMatrix([whole]))


def of_locus_equation(
    found: Any, numerator: Any, denominator: Any, s: Any, *, discrete: bool = False
) -> Iterator[Claim | Check]:
    """The common factor, monic, times what is left is what was given; what is left has no common root."""
    N, D, common = found.numerator, found.denominator, found.common
    yield Claim(numerator, product(common.as_expr(), N.as_expr()))
    yield Claim(denominator, product(common.as_expr(), D.as_expr()))
    monic = sp.expand(common.LC() - 1) == 0 and all(p.gen == s for p in (N, D, common))
    yield Check.that("a monic common factor", "compared", monic and found.discrete == discrete)
    zeros, poles = (np.roots([complex(c) for c in p.all_coeffs()]) for p in (N, D))
    apart = all(abs(z - p) > NEAR for z in zeros for p in poles)
    yield Check.that("numerator and denominator without common roots", "numpy.roots", apart)


def of_roots_with_factors(found: Sequence[Any], p: Any) -> Iterator[Claim | Check]:
    """The roots, which with their multiplicities make up the polynomial and are zeros of their factors."""
    x = p.gen
    if p.degree() < 1:
        yield Check.that("no roots of a constant", "counted", not found)
        return
    factors = [power(x - each.value, each.multiplicity) for each in found]
    yield Claim(product(p.LC(), *factors), p.as_expr())
    for each in found:
        value = sp.N(each.factor.as_expr().xreplace({x: each.value}), 40)
        size = sum(abs(sp.N(c)) * abs(sp.N(each.value)) ** i for i, c in enumerate(reversed(each.factor.all_coeffs())))
        yield Check.that("a root of its factor", "sympy.N", bool(abs(value) <= NEAR * size))


def of_written(found: Any, p: Any) -> Iterator[Claim]:
    """The polynomial."""
    yield Claim(p.as_expr(), found)


def of_expressions_of(found: Sequence[Any], p: Any) -> Iterator[Claim]:
    """The coefficients."""
    yield Claim(sp.ImmutableMatrix([p.all_coeffs()]), sp.ImmutableMatrix([list(found)]))


def of_real_points(found: Sequence[Any], equation: Any) -> Iterator[Check]:
    """All real poles and zeros from right to left, with what lies to the right of each."""
    locus = _locus(equation)
    corners = [
        (float(root.real), pole, times)
        for listed, pole in ((locus.poles, True), (locus.zeros, False))
        for root, times in listed
        if abs(root.imag) < NEAR
    ]
    corners.sort(key=lambda each: -each[0])
    right, holds = 0, len(corners) == len(found)
    for each, (place, pole, times) in zip(found, corners, strict=False):
        near = abs(float(each.point.value) - place) < NEAR * (1 + abs(place))
        holds = holds and near and (each.pole, each.point.multiplicity, each.right) == (pole, times, right)
        right += times
    yield Check.that("the real poles and zeros", "mpmath.polyroots", holds)


def of_real_axis_segments(found: Sequence[Any], equation: Any) -> Iterator[Check]:
    """K ≥ 0 holds on them only."""
    yield _close("segments of the real axis", judges.segments_residual(_locus(equation), found))


def of_asymptotes(found: Any, equation: Any) -> Iterator[Claim | Check]:
    """Their directions and their centroid, from the sums of poles and zeros."""
    locus = _locus(equation)
    if found is None:
        yield Check.that("no asymptotes", "counted", locus.excess < 1)
        return
    yield _close("the directions of asymptotes", judges.asymptote_angles_residual(locus, found.angles))
    yield Check.that("angles within half a turn", "compared", all(-180 < each <= 180 for each in found.angles))
    yield _close("the centroid", judges.centroid_residual(locus, found.centroid))
    for value, p in ((found.poles, equation.denominator), (found.zeros, equation.numerator)):
        below = p.all_coeffs()
        yield Claim(value, -below[1] / below[0] if len(below) > 1 else sp.Integer(0))


def of_turning_polynomial(found: Any, equation: Any) -> Iterator[Claim]:
    """N D' − N' D."""
    N, D = equation.numerator.as_expr(), equation.denominator.as_expr()
    s = equation.denominator.gen
    yield Claim(N * D.diff(s) - N.diff(s) * D, found.as_expr())


def of_meetings(found: Sequence[Any], equation: Any) -> Iterator[Check]:
    """All roots of N D' − N' D with their multiplicities, the gains there, and which of them belong."""
    locus = _locus(equation)
    left = list(locus.turning)
    for each in found:
        s = judges.number(each.point.value)
        near = [i for i, (root, times) in enumerate(left) if abs(root - s) < NEAR and times + 1 == each.branches]
        yield Check.that("a point where branches can meet", "mpmath.polyroots", bool(near))
        if near:
            del left[near[0]]
        gain = locus.gain(s)
        at_zero = any(abs(zero - s) < NEAR for zero, _ in locus.zeros)
        real = abs(gain.imag) < NEAR * (1 + abs(gain)) if not at_zero else False
        why = (
            "zero" if at_zero else "complex" if not real else "pole" if abs(gain) < NEAR
            else "negative" if gain.real < 0 else ""
        )  # fmt: skip
        yield Check.that("why a point belongs to a locus", ORACLE, each.why == why)
        if not at_zero:
            own = judges.number(each.gain)
            yield _close("a gain where branches meet", float(abs(own - gain) / (1 + abs(gain))))
    yield Check.that("all points where branches can meet", "counted", not left)


def of_on_boundary(found: Any, equation: Any) -> Iterator[Claim]:
    """Real and imaginary parts of D and N in u = ω², on the circle in the cosine, and what is left without K."""
    s, omega = equation.denominator.gen, sp.Symbol("omega", real=True)
    unit, place = (sp.sin(omega), sp.cos(omega)) if equation.discrete else (omega, omega**2)
    point = sp.exp(sp.I * omega) if equation.discrete else sp.I * omega
    (a, c), (b, d) = ([p.as_expr().xreplace({p.gen: place}) for p in pair] for pair in (found.real, found.imaginary))
    for p, even, odd in ((equation.denominator, a, b), (equation.numerator, c, d)):
        yield Claim(p.as_expr().xreplace({s: point}), even + sp.I * unit * odd)
    yield Claim(found.eliminated.as_expr().xreplace({found.eliminated.gen: place}), a * d - b * c)


def of_in_squares(found: Any, p: Any, omega: Any) -> Iterator[Claim]:
    """The polynomial at ω²."""
    yield Claim(p.as_expr().xreplace({p.gen: omega**2}), found)


def of_crossings(found: Sequence[Any], equation: Any) -> Iterator[Claim | Check]:
    """All of them, with their gains; ω² is the place, on the circle the real part."""
    locus = _locus(equation)
    if judges.boundary_points(locus) is not None:
        points = [point for each in found for point in dict.fromkeys((each.point, sp.conjugate(each.point)))]
        yield _close("crossings of the boundary", judges.crossings_residual(locus, points, None))
    for each in found:
        yield Claim(
            each.place,
            sp.re(each.point) if equation.discrete else product(sp.Integer(-1), power(each.point, sp.Integer(2))),
        )
        point = judges.number(each.point)
        yield Check.that("a point not below the real axis", "compared", bool(point.imag >= 0))
        gain = locus.gain(point)
        yield _close("a critical gain", float(abs(judges.number(each.gain) - gain) / (1 + abs(gain))))


def of_stable_gains(found: Sequence[Any], equation: Any) -> Iterator[Check]:
    """Ranges follow each other from zero to infinity; in each so many roots are not in the region of stability."""
    ends = [found[0].low, *(each.high for each in found)] if found else []
    whole = bool(found) and ends[0] == 0 and ends[-1] == sp.oo
    whole = whole and all(each.high == following.low for each, following in pairwise(found))
    yield Check.that("ranges of gains without a gap", "compared", whole)
    locus = _locus(equation)
    common = [complex(c) for c in equation.common.all_coeffs()]
    for each in found:
        low = float(each.low)
        high = float(each.high) if each.high.is_finite else 4 * abs(low) + 4
        for part in (0.13, 0.5, 0.87):
            gain = low + part * (high - low)
            p = np.array([complex(c) for c in locus.denominator])
            p[locus.excess :] += gain * np.array([complex(c) for c in locus.numerator])
            roots = np.concatenate([np.roots(p), np.roots(common)])
            away = np.abs(roots) - 1 if equation.discrete else roots.real
            on = int(np.sum(np.abs(away) < 1e-6 * (1 + np.abs(roots))))
            outside = int(np.sum(away > 1e-6 * (1 + np.abs(roots))))
            yield Check.that("roots that are not stable", "numpy.roots", (outside, on) == (each.outside, each.on))


def of_departures(found: Sequence[Any], equation: Any) -> Iterator[Claim | Check]:
    """The directions near the poles above the real axis, and the arrows that make them up."""
    yield from _directions(found, equation, poles=True)


def of_arrivals(found: Sequence[Any], equation: Any) -> Iterator[Claim | Check]:
    """The same near the zeros."""
    yield from _directions(found, equation, poles=False)


def _directions(found: Sequence[Any], equation: Any, *, poles: bool) -> Iterator[Claim | Check]:
    locus = _locus(equation)
    angles = [angle for each in found for angle in each.angles]
    yield _close("directions", judges.directions_residual(locus, angles, poles=poles))
    yield Check.that("directions within half a turn", "compared", all(-180 < each <= 180 for each in angles))
    corners = [(root, True, m) for root, m in locus.poles] + [(root, False, m) for root, m in locus.zeros]
    for each in found:
        point = judges.number(each.point.value)
        yield Check.that(
            "which it is of", "compared", each.pole is poles and each.point.multiplicity == len(each.angles)
        )
        left = [corner for corner in corners if abs(corner[0] - point) > NEAR]
        for arrow in each.arrows:
            yield Claim(each.point.value - arrow.start, arrow.arrow)
            yield Claim(phase(arrow.arrow), arrow.degrees)
            start = judges.number(arrow.start)
            mine = [c for c in left if abs(c[0] - start) < NEAR and c[1:] == (arrow.pole, arrow.times)]
            yield Check.that("where an arrow starts", "mpmath.polyroots", bool(mine))
            left = [corner for corner in left if corner not in mine]
        yield Check.that("all arrows", "counted", not left)
        signs = [arrow.degrees * arrow.times * (1 if arrow.pole != poles else -1) for arrow in each.arrows]
        yield Claim(total(sp.Integer(180 if equation.lead > 0 else 0), *signs), each.total)


def of_degrees_of(found: Any, x: Any) -> Iterator[Claim]:
    """The angle in degrees."""
    yield Claim(phase(x), found)
