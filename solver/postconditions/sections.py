"""Compensators in a loop: least gains, sections by Bode's diagram and by the root locus, the loops they make."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Check, Claim
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.complex_numbers import absolute, phase
from solver.stated.limits import limit
from solver.stated.matrices import inverse

NEAR = 1e-9
"""What doubles leave of a magnitude, relatively."""

DEGREES = 1e-7
POWERS = {"error": 0, "position_constant": 0, "velocity_constant": 1, "acceleration_constant": 2}


def of_descending_form(found: Any, numerator: Any, denominator: Any, x: Any) -> Iterator[Claim]:
    """C (xI − A)⁻¹ B + D is the quotient."""
    A, B, C, D = found
    resolvent = inverse(difference(product(x, sp.ImmutableMatrix(sp.eye(A.rows))), A))
    yield Claim(total(product(C, resolvent, B), D), sp.ImmutableMatrix([[numerator / denominator]]))


def of_least_gain(found: Any, G: Any, name: str, value: Any) -> Iterator[Claim | Check]:
    """The limit, and K times it is what is wanted."""
    power = POWERS[name]
    yield Check.that("the power of s", "compared", found.power == power)
    yield Claim(limit(G.s**power * G.numerator / G.denominator, G.s, 0, "+"), found.limit)
    yield Claim(quotient(difference(sp.Integer(1), value), value) if name == "error" else total(value), found.wanted)
    if found.limit.is_finite and found.K is not None:
        yield Claim(product(found.K, found.limit), found.wanted)
    else:
        yield Check.that("any gain, or none", "compared", found.K == 1 if found.limit != 0 else found.K is None)


def of_compensator_parts(found: Any, K: Any, sections: Sequence[Any], s: Any) -> Iterator[Claim]:
    """K Π (T s + 1)/(α T s + 1)."""
    factors = [quotient(each.T * s + 1, each.alpha * each.T * s + 1) for each in sections]
    yield Claim(product(K, *factors), quotient(*found))


def of_alpha_of(found: Any, angle: Any) -> Iterator[Claim]:
    """(1 − sin φ)/(1 + sin φ)."""
    sine = sp.sin(angle * sp.pi / 180)
    yield Claim(quotient(difference(sp.Integer(1), sine), total(sp.Integer(1), sine)), found)


def of_gains_of(found: Any, values: Sequence[Any]) -> Iterator[Check]:
    """The gains, and zeros for those that are not there."""
    yield Check.that("three gains", "compared", [*values, *[sp.Integer(0)] * 3][:3] == [*found])


def of_compensated(found: Any, G: Any, K: Any, sections: Sequence[Any] = ()) -> Iterator[Claim | Check]:
    """The loop of K and the sections, its crossovers and margins."""
    yield Claim(K, found.K)
    yield Check.that("the sections", "compared", tuple(sections) == tuple(found.sections))
    yield from _right(found, G)


def _right(found: Any, G: Any) -> Iterator[Claim | Check]:
    """A loop is that of its gain and sections; where it crosses one, and what is left to −180° there; its stability."""
    s = G.s
    factors = [quotient(each.T * s + 1, each.alpha * each.T * s + 1) for each in found.sections]
    yield Claim(product(found.K, *factors, G.numerator / G.denominator), found.numerator / found.denominator)
    own = found.axis.N.as_expr() / found.axis.D.as_expr()
    yield Claim(own, found.numerator / found.denominator)
    N, D = (np.array([float(c) for c in sp.Poly(p, s).all_coeffs()]) for p in (found.numerator, found.denominator))
    T = float(G.delay)
    if not T:
        stable = bool(np.max(np.roots(np.polyadd(D, N)).real) < 0)
        yield Check.that("whether the closed loop is stable", "numpy.roots", stable == found.stable)
    yield from _crossings(found.margins, lambda w: np.polyval(N, 1j * w) / np.polyval(D, 1j * w) * np.exp(-1j * w * T))


def _crossings(margins: Any, L: Any) -> Iterator[Check]:
    for each in (*margins.gains.found, *margins.phases.found):
        w = float(each.omega)
        right = abs(abs(L(w)) / float(each.magnitude) - 1) <= NEAR and abs(float(each.square) - w**2) <= NEAR * (
            1 + w**2
        )
        turned = abs((np.degrees(np.angle(L(w))) - float(each.phase) + 180) % 360 - 180) <= DEGREES
        yield Check.that("magnitude and phase at a crossover", "numpy", right and bool(turned))
    for each, listed in ((margins.at_gain, margins.gains.found), (margins.at_phase, margins.phases.found)):
        yield Check.that("the crossover that decides is one", "compared", each is None or each in listed)
    if margins.at_gain is not None:
        own = np.degrees(np.angle(-L(float(margins.at_gain.omega))))
        yield Check.within("the phase margin", "numpy", abs(float(margins.phase_margin) - float(own)), DEGREES)
    if margins.at_phase is not None:
        own = 1 / abs(L(float(margins.at_phase.omega)))
        yield Check.within("the gain margin", "numpy", abs(float(margins.gain_margin) / own - 1), NEAR)


def _value(G: Any, omega: Any) -> Any:
    """G(jω) as an expression to be evaluated."""
    at = sp.I * omega
    return (G.numerator / G.denominator * sp.exp(-G.delay * G.s)).xreplace({G.s: at})


def of_lead_by_bode(found: Any, G: Any, K: Any, wanted: Any, extra: Any) -> Iterator[Claim | Check]:
    """Each attempt: the phase with what is added, |K G| = √α at its frequency, the loop; whether the last is met."""
    yield from of_compensated(found.before, G, K)
    for i, each in enumerate(found.rounds):
        if i == 0:
            yield Claim(extra, each.extra)
        yield Claim(total(difference(wanted, found.before.margins.phase_margin), each.extra), each.phase)
        if each.omega is not None:
            yield Claim(product(K, absolute(_value(G, each.omega))), sp.sqrt(each.alpha))
        if each.loop is not None:
            yield Check.that("the section of the attempt", "compared", (each.section,) == each.loop.sections
                             and each.section.alpha == each.alpha)  # fmt: skip
            yield from _right(each.loop, G)
    loops = [each.loop for each in found.rounds if each.loop is not None]
    if found.chosen is None:
        met = bool(loops and _meets(loops[-1], wanted))
        yield Check.that("whether what is asked is met", "compared", met == found.met)
    else:
        yield from _lead_at(found.chosen, G, K)
        yield Check.that("whether what is asked is met", "compared", _meets(found.chosen.loop, wanted) and found.met)


def _meets(loop: Any, wanted: Any) -> bool:
    return bool(loop.stable and loop.margins.phase_margin >= wanted)


def of_lead_at(found: Any, G: Any, K: Any, wanted: Any, omega: Any, extra: Any, *, spare: bool = False) -> Any:
    """The magnitude and phase at the crossover, and the loop."""
    yield Claim(omega, found.omega)
    if hasattr(found, "why"):
        yield Claim(product(K, absolute(_value(G, omega))), found.size)
        return
    if not spare:
        yield Claim(total(difference(difference(wanted, sp.Integer(180)), found.angle), extra), found.needed)
    yield from _lead_at(found, G, K)


def _lead_at(found: Any, G: Any, K: Any) -> Iterator[Claim | Check]:
    yield Claim(quotient(sp.Integer(1), product(K, absolute(_value(G, found.omega)))), found.M)
    yield Claim(phase(_value(G, found.omega)), _principal(found.angle))
    largest = sp.Float(np.degrees(np.arccos(1 / float(found.M))), 15)
    yield Check.within("the largest phase", "numpy", abs(float(largest - found.largest)), DEGREES)
    turned, M = np.radians(float(found.phase)), float(found.M)
    zero, pole = (M - np.cos(turned)) / np.sin(turned), (M * np.cos(turned) - 1) / (M * np.sin(turned))
    yield Check.within("ωT", "numpy", abs(float(found.zero) / zero - 1), NEAR)
    yield Check.within("ωαT", "numpy", abs(float(found.pole) / pole - 1), NEAR)
    yield Check.that("the section of the loop", "compared", (found.section,) == found.loop.sections)
    yield from _right(found.loop, G)


def _principal(angle: Any) -> Any:
    return angle - 360 * sp.ceiling((angle - 180) / 360)


def of_lead_with_free_gain(found: Any, G: Any, wanted: Any, omega: Any, extra: Any) -> Iterator[Claim | Check]:
    """The same where the gain is free."""
    yield Claim(omega, found.omega)
    yield Claim(absolute(_value(G, omega)), found.size)
    if hasattr(found, "why"):
        return
    yield Claim(phase(_value(G, omega)), _principal(found.angle))
    yield Claim(total(difference(difference(wanted, sp.Integer(180)), found.angle), extra), found.phase)
    same = (found.section,) == found.loop.sections and found.section.alpha == found.alpha
    yield Check.that("the section of the loop", "compared", same)
    yield from _right(found.loop, G)


def of_lag_by_bode(found: Any, G: Any, K: Any, wanted: Any, extra: Any) -> Iterator[Claim | Check]:
    """Each attempt: the phase looked for is that of G at its frequency, |K G| there, the loop."""
    yield from of_compensated(found.before, G, K)
    for i, each in enumerate(found.rounds):
        if i == 0:
            yield Claim(extra, each.extra)
        yield Claim(total(difference(wanted, sp.Integer(180)), each.extra), each.phase)
        if each.omega is None:
            continue
        yield Claim(phase(_value(G, each.omega)), sp.N(_principal(each.phase), 30))
        yield Claim(product(K, absolute(_value(G, each.omega))), each.size)
        yield Check.that("the section of the attempt", "compared", (each.section,) == each.loop.sections)
        yield from _right(each.loop, G)
    last = found.rounds[-1].loop
    met = last is not None and _meets(last, wanted)
    yield Check.that("whether what is asked is met", "compared", bool(met) == found.met)


def of_lag_at(found: Any, G: Any, K: Any, wanted: Any, omega: Any) -> Iterator[Claim | Check]:
    """The magnitude and phase at the crossover, and the loop."""
    yield Claim(omega, found.omega)
    yield Claim(product(K, absolute(_value(G, omega))), found.size)
    if hasattr(found, "why"):
        yield Claim(phase(_value(G, omega)), _principal(found.margin - 180))
        yield Check.that("the margin is too small", "compared", found.why != "phase" or bool(found.margin < wanted + 6))
        return
    yield Claim(phase(_value(G, omega)), _principal(found.angle))
    yield Check.that("the section of the loop", "compared", (found.section,) == found.loop.sections)
    near = abs(float(found.section.T * omega) / found.below - 1) < 0.01
    yield Check.that("how far below the crossover the zero is", "compared", near)
    yield from _right(found.loop, G)


def of_lead_lag_by_bode(found: Any, G: Any, K: Any, wanted: Any, crossover: Any, extra: Any) -> Iterator[Claim | Check]:
    """The crossover with magnitude and phase, each attempt, and its loop."""
    if found.why == "no_crossover":
        return
    yield from of_compensated(found.before, G, K)
    if crossover is not None:
        yield Claim(crossover, found.omega)
    yield Claim(product(K, absolute(_value(G, found.omega))), found.size)
    yield Claim(phase(_value(G, found.omega)), _principal(found.angle))
    at = sp.I * found.omega
    for i, each in enumerate(found.rounds):
        if i == 0:
            yield Claim(extra, each.extra)
        yield Claim(total(difference(difference(wanted, sp.Integer(180)), found.angle), each.extra), each.phase)
        lead = (each.lead.T * at + 1) / (each.lead.alpha * each.lead.T * at + 1)
        yield Claim(product(K, absolute(lead * _value(G, found.omega))), each.size)
        yield Check.that("the sections", "compared", (each.lead, each.lag) == each.loop.sections)
        yield from _right(each.loop, G)
    if not found.why:
        yield Check.that("whether what is asked is met", "compared", _meets(found.rounds[-1].loop, wanted))


def of_lead_on_locus(found: Any, G: Any, point: Any) -> Iterator[Claim | Check]:
    """The plant at the point, the angles of the bisector, zero and pole, the gain, and the loop."""
    yield from _plant_at(found.at, G, point)
    if hasattr(found, "why"):
        phi, theta = float(found.at.missing), float(found.at.theta)
        wanted = "not_needed" if abs(phi) < 0.05 else "backwards" if phi < 0 else "too_much" if phi > theta - 1 else ""
        yield Check.that("why there is no section", "compared", found.why == wanted)
        return
    less, more = (sp.sin(sp.pi * each / 180) for each in (found.half_less, found.half_more))
    yield Claim(quotient(product(found.at.radius, less), more), found.zero)
    yield Claim(quotient(product(found.at.radius, more), less), found.pole)
    yield Claim(difference(found.half_more, found.half_less), found.at.missing)
    yield Claim(total(found.half_more, found.half_less), found.at.theta)
    section = found.section
    z = sp.N(point, 30)
    turned = (section.T * z + 1) / (section.alpha * section.T * z + 1)
    yield Claim(product(found.gain, absolute(turned * found.at.value)), sp.Integer(1))
    yield Check.that("the section of the loop", "compared", (section,) == found.loop.sections)
    yield from _right(found.loop, G)


def _plant_at(at: Any, G: Any, point: Any) -> Iterator[Claim]:
    value = (G.numerator / G.denominator).xreplace({G.s: point})
    yield Claim(point, at.point)
    yield Claim(value, at.value)
    yield Claim(absolute(value), at.size)
    yield Claim(phase(value), at.angle)
    yield Claim(_principal(180 - at.angle), at.missing)
    yield Claim(phase(point), at.theta)
    yield Claim(absolute(point), at.radius)


def of_lag_on_locus(
    found: Any, G: Any, point: Any, name: str, value: Any, before: Sequence[Any] = ()
) -> Iterator[Claim | Check]:
    """The plant behind the sections at the point, the gain, the constant with it, and the loop."""
    if found is None or isinstance(found, str):
        return
    sections = [(each.T * point + 1) / (each.alpha * each.T * point + 1) for each in before]
    there = sp.Mul(*sections, (G.numerator / G.denominator).xreplace({G.s: point}))
    yield Claim(there, found.at.value)
    yield Claim(phase(there), found.at.angle)
    yield Claim(_principal(180 - found.at.angle), found.at.missing)
    yield Claim(absolute(point), found.at.radius)
    if hasattr(found, "why"):
        return
    yield Claim(product(found.gain, absolute(there)), sp.Integer(1))
    constant = limit(found.gain * G.s ** POWERS[name] * G.numerator / G.denominator, G.s, 0, "+")
    yield Claim(constant, found.reached)
    yield Claim(quotient(difference(sp.Integer(1), value), value) if name == "error" else total(value), found.wanted)
    yield Claim(product(found.ratio, found.reached), found.wanted)
    yield Claim(product(found.K, found.reached), product(found.wanted, found.gain))
    z = sp.N(point, 30)
    turned = (found.section.T * z + 1) / (found.section.alpha * found.section.T * z + 1)
    yield Claim(phase(turned), found.angle)
    yield Check.that("the section of the loop", "compared", (*before, found.section) == tuple(found.loop.sections))
    root = complex(found.root)
    N, D = (np.array([float(c) for c in sp.Poly(p, G.s).all_coeffs()]) for p in
            (found.loop.numerator, found.loop.denominator))  # fmt: skip
    size = np.polyval(np.abs(D), abs(root)) + np.polyval(np.abs(N), abs(root))
    yield Check.within(
        "a root of the loop", "numpy", float(abs(np.polyval(D, root) + np.polyval(N, root)) / size), NEAR
    )
    yield from _right(found.loop, G)
