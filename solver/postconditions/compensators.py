"""Ultimate gains and the intervals between them, tables of tuning, controllers as fractions, poles of their loops."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Check, Claim
from solver.lazy import numeric
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.calculus import derivative
from solver.stated.transforms import laplace

BOUND = 1e-6
"""Relative distance to an end of an interval of gains at which roots are counted."""


def of_on_the_axis(found: Any, numerator: Any, denominator: Any, s: Any) -> Iterator[Claim]:
    """D and N at jω from their even and odd parts, and what is left without K."""
    omega = sp.Symbol("omega", real=True)
    put = {found.w: omega**2}
    at = {s: sp.I * omega}
    for i, p in enumerate((denominator, numerator)):
        parts = total(found.real[i].xreplace(put), product(sp.I * omega, found.imaginary[i].xreplace(put)))
        yield Claim(parts, p.xreplace(at))
    (De, Ne), (Do, No) = found.real, found.imaginary
    yield Claim(difference(product(De, No), product(Do, Ne)), found.equation)


def of_ultimate_gain(found: Any, numerator: Any, denominator: Any, s: Any) -> Iterator[Claim | Check]:
    """Each crossing is a root on the axis; so many roots within each interval; which crossing is the ultimate one."""
    N, D = (np.array([complex(c) for c in sp.Poly(p, s).all_coeffs()]).real for p in (numerator, denominator))
    for each in found.crossings:
        K, w = float(each.gain), float(each.frequency)
        size = np.polyval(np.abs(D), w or 1.0) + K * np.polyval(np.abs(N), w or 1.0)
        residual = abs(np.polyval(D, 1j * w) + K * np.polyval(N, 1j * w)) / size
        yield Check.within("a root on the axis", "numpy", float(residual), 1e-10)
        yield Claim(each.square, product(each.frequency, each.frequency))
    ends = [each.stop for each in found.intervals]
    whole = found.intervals[0].start == 0 and ends[-1] == sp.oo
    joined = all(a.stop == b.start for a, b in pairwise(found.intervals))
    yield Check.that("the intervals follow each other", "compared", whole and joined)
    for each in found.intervals:
        yield Check.that("roots not in the left half plane", "numpy.roots", all(_counted(N, D, each)))
    known = {float(each.gain) for each in found.crossings}
    between = [float(each) for each in ends[:-1]]
    yield Check.that("a crossing at the ends", "compared", all(any(_near(K, each) for each in between) for K in known))
    lead = [float(K) for K in [-D[0] / N[0]] if len(N) == len(D)]
    told = all(any(_near(each, K) for K in (*known, *lead)) for each in between)
    yield Check.that("a crossing, or a root at infinity, at each end", "compared", told)
    stable = next((each for each in found.intervals if not each.outside), None)
    ultimate = found.ultimate
    right = bool(found.why) if ultimate is None else stable is not None and _near(ultimate.gain, stable.stop)
    yield Check.that("the end of the first stable interval", "compared", right)


def _counted(N: Any, D: Any, each: Any) -> Iterator[bool]:
    """Whether there are so many roots a little above the start, and a little below the stop."""
    start = float(each.start)
    stop = float(each.stop) if each.stop != sp.oo else 2 * start + 1.0
    for share in (0.02, 0.5, 0.98):
        K = start + share * (stop - start)
        roots = np.roots(np.polyadd(D, K * N))
        clear = np.min(np.abs(roots.real)) > 1e-9
        yield not clear or int(np.sum(roots.real > 0)) == each.outside


def _near(a: Any, b: Any) -> bool:
    return bool(abs(float(a) - float(b)) <= BOUND * abs(float(b)))


def of_tuning_rules(found: Any, of: str) -> Iterator[Check]:
    """The table as Ziegler and Nichols give it."""
    wanted = {
        "ultimate": {"P": ("1/2", None, None), "PI": ("9/20", "5/6", None), "PID": ("3/5", "1/2", "1/8")},
        "step": {"P": ("1", None, None), "PI": ("9/10", "10/3", None), "PID": ("6/5", "2", "1/2")},
    }[of]
    own = {
        kind: tuple(None if each is None else str(each) for each in (rule.gain, rule.integral, rule.derivative))
        for kind, rule in found.items()
    }
    yield Check.that("the table of Ziegler and Nichols", "compared", own == wanted)


def of_tuned(found: Any, rule: Any, gain: Any, time: Any) -> Iterator[Claim]:
    """Gain and times by the row of the table."""
    K_p, K_i, K_d = found.gains
    yield Claim(product(rule.gain, gain), K_p)
    yield Claim(product(K_i, found.T_i), K_p) if rule.integral is not None else Claim(K_i, sp.Integer(0))
    yield Claim(quotient(K_d, found.T_d), K_p) if rule.derivative is not None else Claim(K_d, sp.Integer(0))
    for factor, own in ((rule.integral, found.T_i), (rule.derivative, found.T_d)):
        if factor is not None:
            yield Claim(product(factor, time), own)


def of_pid_parts(found: Any, gains: Any, s: Any) -> Iterator[Claim]:
    """K_p + K_i/s + K_d s."""
    K_p, K_i, K_d = gains
    yield Claim(quotient(*found), total(K_p, quotient(K_i, s), product(K_d, s)))


def of_closed_by(found: Any, controller: Any, plant: Any, s: Any) -> Iterator[Claim | Check]:
    """Numerator and denominator of C G/(1 + C G), the poles, and where they lie."""
    yield Claim(product(controller[0], plant[0]), found.numerator)
    stated = total(product(controller[1], plant[1]), product(controller[0], plant[0]))
    yield Claim(stated, found.denominator)
    if found.poles:
        lead = sp.Poly(found.denominator, s).LC()
        yield Claim(product(lead, *(s - pole for pole in found.poles)), found.denominator)
        yield Check.that(
            "where the poles lie", "compared", all(complex(p).real < 0 for p in found.poles) == found.stable
        )


def of_placed_gains(
    found: Any, numerator: Any, denominator: Any, s: Any, kind: str, poles: Sequence[Any]
) -> Iterator[Claim | Check]:
    """The two polynomials, equal with the gains."""
    K_p, K_i, K_d = sp.symbols("K_p K_i K_d")
    letters = {"P": (K_p,), "PI": (K_p, K_i), "PID": (K_p, K_i, K_d)}[kind]
    yield Check.that("the gains of the controller", "compared", letters == found.unknowns)
    top, bottom = (K_p, sp.Integer(1)) if kind == "P" else (K_p * s + K_i + (K_d * s**2 if kind == "PID" else 0), s)
    own = total(*(c * s ** (len(found.own) - 1 - i) for i, c in enumerate(found.own)))
    yield Claim(total(product(bottom, denominator), product(top, numerator)), own)
    wanted = total(*(c * s ** (len(found.wanted) - 1 - i) for i, c in enumerate(found.wanted)))
    yield Claim(product(found.own[0], *(s - pole for pole in poles)), wanted)
    if found.gains is not None:
        values = dict(zip((K_p, K_i, K_d), found.gains, strict=True))
        for a, b in zip(found.own, found.wanted, strict=True):
            yield Claim(a.xreplace(values), b.xreplace(values))
    else:
        yield Check.that("the equations contradict each other", "compared", bool(found.conditions))


def of_reaction_curve(found: Any, numerator: Any, denominator: Any, s: Any, delay: Any) -> Iterator[Claim | Check]:
    """The step response and its slope from their transforms; height and slope of the tangent; no slope is larger."""
    if not hasattr(found, "slope"):
        return
    t = found.t
    yield Claim(laplace(found.g, t, s), quotient(numerator, denominator))
    yield Claim(derivative(found.y, t), found.g)
    yield Claim(found.y.xreplace({t: sp.Integer(0)}), sp.Integer(0))
    yield Claim(total(found.own, delay), found.dead_time)
    at = (found.time, found.height) if found.kind != "ramp" else (sp.Integer(0), found.height)
    own = difference(at[0], quotient(at[1], found.slope))
    yield Claim(own, found.own)
    if found.kind != "ramp":
        yield Claim(found.g.xreplace({t: found.time}), found.slope)
        yield Claim(found.y.xreplace({t: found.time}), found.height)
    values = [abs(complex(numeric.evaluate(found.g, {t: complex(x)}))) for x in np.linspace(0.01, 30, 60)]
    yield Check.that("no slope is larger", "numpy", max(values) <= abs(complex(found.slope)) * (1 + 1e-9))


def of_ultimate_with_dead_time(
    found: Any, numerator: Any, denominator: Any, s: Any, delay: Any
) -> Iterator[Claim | Check]:
    """K G is −1 at the frequency."""
    oscillation, why = found
    if oscillation is None:
        yield Check.that("why there is none", "compared", why in {"unstable", "never_oscillates"})
        return
    at = {s: sp.I * oscillation.frequency}
    there = (numerator / denominator * sp.exp(-delay * s)).xreplace(at)
    yield Claim(product(oscillation.gain, there), sp.Integer(-1))
    yield Claim(product(oscillation.frequency, oscillation.frequency), oscillation.square)
