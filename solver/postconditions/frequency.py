"""Loops on the imaginary axis: crossovers, margins, turns about −1, judged by other people's algorithms."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.numeric.judges import frequency as judges
from solver.stated.algebra import quotient

NEAR = 1e-12
ORACLE = "numpy.roots, refined; with a dead time samples and bisection"


def _loop(L: Any) -> judges.NumericLoop:
    return judges.numeric_loop(L.N.as_expr(), L.D.as_expr(), L.variable, L.delay, L.sample_time)


def of_on_axis(found: Any, numerator: Any, denominator: Any, s: Any, delay: Any = sp.S.Zero) -> Iterator[Claim | Check]:
    """N/D is the quotient, in lowest terms."""
    yield Claim(quotient(found.N.as_expr(), found.D.as_expr()), numerator / denominator)
    yield Check.that("the variable and the dead time", "compared", found.variable == s and found.delay == delay)
    yield Check.that("lowest terms", "sympy.gcd", sp.gcd(found.N.as_expr(), found.D.as_expr()).is_number)


def of_on_circle(found: Any, numerator: Any, denominator: Any, z: Any, sample_time: Any) -> Iterator[Claim | Check]:
    """The same of a discrete loop."""
    yield from of_on_axis(found, numerator, denominator, z)
    yield Check.that("the sampling period", "compared", found.sample_time == sample_time)


def of_gain_crossovers(found: Any, L: Any, level: Any = sp.S.One) -> Iterator[Claim | Check]:
    """The frequencies are all those with |L| = level, with the phases there."""
    loop = _loop(L)
    yield Check.that("whether |L| is constant", "compared", not (found.everywhere and found.found))
    if found.everywhere:
        yield Check.that("|L| is constant", "mpmath, samples", judges.is_everywhere(loop, level))
        return
    yield _are(loop.gain_crossovers(judges.decimal(level)), [each.omega for each in found.found])
    yield Check.that(
        "the equation",
        "mpmath, samples",
        judges.is_size_equation(loop, found.polynomial.as_expr(), found.polynomial.gen, level),
    )
    for each in found.found:
        yield _is_there(loop, each, sizes=judges.decimal(level))


def of_phase_crossovers(found: Any, L: Any) -> Iterator[Claim | Check]:
    """The frequencies are all those with L real (with a dead time up to the last), with its values."""
    loop = _loop(L)
    yield Check.that("L is real on the whole axis", "mpmath, samples", found.everywhere == judges.is_real(loop))
    if found.everywhere:
        return
    last = found.real_axis[-1][0] if L.late and found.real_axis else None
    wanted = [pair for pair in loop.real_crossings() if last is None or pair[0] <= judges.decimal(last) * (1 + NEAR)]
    yield _are([w for w, _ in wanted], [omega for omega, _ in found.real_axis])
    yield _are([value for _, value in wanted], [value for _, value in found.real_axis])
    negative = [(w, value) for w, value in wanted if value < 0]
    shown = [each for each in found.found if each.omega != 0]
    yield _are([w for w, _ in negative], [each.omega for each in shown])
    yield Check.that("L(0)", "compared", (loop.at_rest < 0) == (len(shown) < len(found.found)))
    for each in found.found:
        yield _is_there(loop, each, sizes=None)
        yield Check.that(
            "the direction of a crossing", "mpmath, samples", judges.direction(loop, each.omega) == each.clockwise
        )
    if not L.late:
        yield Check.that(
            "the equation",
            "mpmath, samples",
            judges.is_slope_equation(loop, found.polynomial.as_expr(), found.polynomial.gen),
        )
    elif found.found:
        yield Check.that("the last crossing", "compared", found.last == found.found[-1].omega)


def _is_there(loop: Any, each: Any, *, sizes: Any) -> Check:
    """|L| and the phase at a crossover, its square."""
    fits = judges.fits(loop, each.omega, each.square, each.magnitude, each.phase, sizes)
    return Check.that("size and phase at a crossover", "mpmath", fits)


def of_margins_of(found: Any, L: Any) -> Iterator[Claim | Check]:
    """The margins are those nearest to −1."""
    wanted = judges.numeric_margins(_loop(L))
    for name, place, known in (
        ("gain_crossover", 0, wanted.gains), ("phase_margin", 1, wanted.gains),
        ("phase_crossover", 0, wanted.phases), ("gain_margin", 1, wanted.phases), ("gain_margin_db", 1, wanted.phases),
    ):  # fmt: skip
        residual = judges.margin_residual(getattr(found, name), [pair[place] for pair in known], name)
        yield Check.within(name, ORACLE, residual, NEAR)
    yield from of_gain_crossovers(found.gains, L)
    if not found.phases.everywhere:
        yield from of_phase_crossovers(found.phases, L)


def of_in_decibels(found: Any, ratio: Any) -> Iterator[Claim | Check]:
    """20 log₁₀ of the ratio."""
    if ratio.is_finite:
        yield Claim(sp.log(ratio) * 20 / sp.log(10), found)
    else:
        yield Check.that("an infinite ratio", "compared", found == ratio)


def of_phase_margin_of(found: Any, phase: Any) -> Iterator[Claim | Check]:
    """180° more, up to a full turn, in (−180, 180]."""
    yield Check.that("a margin in (−180, 180]", "compared", bool(-180 < found <= 180))
    turns = (found - phase - 180) / 360
    yield Check.that("180° more, up to full turns", "compared", bool(abs(sp.N(turns - round(turns), 30)) < 1e-20))


def of_encirclements(
    found: Any, numerator: Any, denominator: Any, s: Any, delay: Any = sp.S.Zero, *, sample_time: Any = None
) -> Iterator[Check]:
    """Poles of L and of the loop by their roots, with a dead time by the argument principle; N is their difference."""
    outside, on = judges.closed_loop_poles(numerator, denominator, s, delay, sample_time)
    P, _ = judges.roots_outside(sp.Poly(denominator, s).all_coeffs(), discrete=sample_time is not None)
    yield Check.that("poles of L outside of the region of stability", "mpmath.polyroots", found.open_loop == P)
    if not found.through:
        yield Check.that(
            "poles of the loop outside of the region of stability",
            "mpmath or the argument",
            found.closed_loop == outside,
        )
    yield Check.that("N = Z − P", "compared", found.clockwise == found.closed_loop - found.open_loop)
    yield Check.that("L is −1 somewhere, or a pole on the axis cancels", "mpmath.polyroots",
                     (found.through or found.on_axis > 0) == bool(on))  # fmt: skip
    if delay == 0:
        yield Check.that("poles of the loop on its boundary", "mpmath.polyroots", found.on_axis == on)
    turns = sum(each.clockwise * (1 if each.end else 2) for each in found.beyond)
    counted = turns + sum(each.passes for each in found.arcs) + found.closing
    yield Check.that("the crossings add up", "counted", found.real or found.through or counted == found.clockwise)
    yield Check.that("half turns at infinity", "numpy.roots", judges.are_half_turns(
        numerator, denominator, s, [(each.omega, each.half_turns) for each in found.arcs], sample_time)
        or found.real)  # fmt: skip


def of_phase_crossings(found: Any, L: Any, degrees: Any) -> Iterator[Check]:
    """The phase there is the one that was asked for, up to full turns."""
    loop = _loop(L)
    for omega in found:
        yield Check.that("the phase at a frequency", "mpmath", judges.has_phase(loop, omega, degrees))


def of_resonance(found: Any, L: Any) -> Iterator[Claim | Check]:
    """The largest magnitude of samples, refined; the slope of |T|² is zero at the roots of the polynomial."""
    loop = _loop(L)
    if found is None:
        yield Check.that("no largest magnitude", "mpmath, samples", judges.has_no_peak(loop))
        return
    peak = judges.peak_of(loop)
    yield Check.that("whether there is a peak", "mpmath, samples", (peak is None) == (found.peak is None))
    if peak is not None and found.peak is not None:
        each = found.peak
        yield Check.within("the place of the peak", "mpmath, samples refined", judges.list_residual(
            [peak], [each.omega]), 1e-8)  # fmt: skip
        yield _is_there(loop, each, sizes=None)
    flat = judges.are_flat(loop, found.stationary, found.polynomial.as_expr(), found.polynomial.gen)
    yield Check.that("where the magnitude has no slope", "mpmath", flat)


def of_bandwidth(found: Any, L: Any) -> Iterator[Claim | Check]:
    """The level is |T(0)|/√2, and the magnitude falls to it there for the first time."""
    loop = _loop(L)
    if found is None:
        yield Check.that("T(0) is zero or infinite", "compared", not loop.at_rest or abs(loop.at_rest) == sp.oo)
        return
    level = abs(loop.at_rest) / judges.decimal(sp.sqrt(2))
    yield Check.within("the level", "mpmath", judges.list_residual([level], [found.level]), NEAR)
    first = loop.gain_crossovers(level)[:1]
    yield _are(first, [] if found.omega is None else [found.omega])
    fits = judges.is_size_equation(loop, found.polynomial.as_expr(), found.polynomial.gen, found.level)
    yield Check.that("the equation", "mpmath, samples", fits)


def of_phase_function(found: Any, L: Any, omega: Any) -> Iterator[Check]:
    """The phase at several frequencies, up to full turns."""
    loop = _loop(L)
    for at in ("0.029", "0.37", "1.9", "23"):
        value = found.subs(omega, sp.Float(at, 40))
        yield Check.that("the phase at a frequency", "mpmath", judges.has_phase(loop, sp.Float(at, 40), value))


def of_bode_form(found: Any, L: Any) -> Iterator[Claim | Check]:
    """The factors make up L, each is 1 at 0; corners and slopes are those of the roots."""
    s = L.variable
    factors = [each.factor**each.power for each in found.corners]
    yield Claim(L.N.as_expr() / L.D.as_expr(), found.gain * s**found.power * sp.Mul(*factors))
    for each in found.corners:
        yield Claim(each.factor.subs(s, 0), sp.S.One)
        if each.damping is not None:
            yield Claim(1 + 2 * each.damping * s / each.omega + s**2 / each.omega**2, each.factor)
        else:
            yield Claim(abs(each.factor.coeff(s)) * each.omega, sp.S.One)
    loop = _loop(L)
    yield Check.within("corners", "mpmath.polyroots", judges.corner_residual(loop, found.frequencies), NEAR)
    yield Check.that("slopes", "numpy.roots", judges.are_slopes(loop, found.slopes))


def of_oscillations(found: Any, u: Any, t: Any) -> Iterator[Claim | Check]:
    """The constant and the amplitudes make up the signal."""
    if found is not None:
        waves = (w.cosine * sp.cos(w.omega * t) + w.sine * sp.sin(w.omega * t) for w in found.sinusoids)
        yield Claim(sp.Add(found.constant, *waves), u)


def of_parametric_factors(found: Any, numerator: Any, denominator: Any, s: Any) -> Iterator[Claim | Check]:
    """The number and the factors make up N/D."""
    yield Claim(_product_of(found), numerator / denominator)
    yield Check.that("the variable", "compared", found.s == s)


def of_parametric_bode_form(found: Any, L: Any) -> Iterator[Claim | Check]:
    """The form is L; each factor has the corner that is said."""
    s = L.s
    factors = sp.Mul(*(each.factor**each.power for each in found.corners))
    yield Claim(found.gain * s**found.power * factors, _product_of(L))
    for each in found.corners:
        if each.damping is not None:
            yield Claim(1 + 2 * each.damping * s / each.omega + s**2 / each.omega**2, each.factor)
        else:
            yield Claim((each.factor - 1) ** 2 * each.omega**2, s**2)


def of_with_corners_in_order(found: Any, form: Any) -> Iterator[Check]:
    """The same corners, rising at some values of the parameters; the slopes change there by what each does."""
    factors, before = ([str(each.factor) for each in one.corners] for one in (found, form))
    same = sorted(factors) == sorted(before)
    yield Check.that("the corners", "compared", same)
    for values in judges.values_of_parameters(found.frequencies, []):
        sizes = [judges.decimal(omega.xreplace(values)) for omega in found.frequencies]
        yield Check.that("rising", "mpmath", sizes == sorted(sizes))
    steps = [b - a for a, b in pairwise(found.slopes)]
    wanted = [sum(each.change for each in found.corners if each.omega == place) for place in found.places]
    yield Check.that("slopes", "compared", steps == wanted and found.slopes[0] == 20 * found.power)


def _product_of(found: Any) -> Any:
    factors = ((sp.Add(*(c * found.s**i for i, c in enumerate(reversed(f)))), m) for f, m in found.factors)
    return sp.Mul(found.number, *(f**m for f, m in factors))


def _are(wanted: Iterable[Any], found: Iterable[Any]) -> Check:
    return Check.within("all crossings", ORACLE, judges.list_residual(list(wanted), list(found)), NEAR)


def of_root_counts(found: Any, coefficients: Any, *, discrete: bool = False) -> Iterator[Check]:
    """The roots outside of the region of stability and on its boundary; those of parameters are judged by answers."""
    if found is None or any(c.free_symbols for c in coefficients):
        return
    outside, on = judges.roots_outside(coefficients, discrete=discrete)
    yield Check.that("roots outside of the region of stability", "mpmath.polyroots", found.outside == outside)
    yield Check.that("roots on its boundary", "mpmath.polyroots", found.on == on)
