"""Classical control in the time domain: gains, poles and what a step response shows."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import pairwise
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.lazy import numeric
from solver.numeric.judges import classical as judges
from solver.numeric.judges import representation
from solver.stated.algebra import quotient
from solver.stated.complex_numbers import absolute, real_part
from solver.words import Phrase

ORACLE = "mpmath (50 digits)"


def of_value_at_zero(found: Any, G: Any, *, discrete: bool = False) -> Iterator[Claim | Check]:
    """The order is that of the zero of the denominator at the origin, or at 1, and G₀ has the value there."""
    x = G.variable
    top, bottom = G.numerators[0][0], G.denominators[0][0]
    apart = x - 1 if discrete else x
    yield Claim(bottom, sp.expand(apart**found.order * found.below), "integrators of the denominator")
    rest = sp.Matrix([[top / found.below]])
    check = partial(judges.dc_gain_residual, rest, found.value, x, int(discrete))
    yield numeric.check_residual("value beside the integrators", ORACLE, check)


def of_pole_zero_factors(found: Any, G: Any) -> Iterator[Claim]:
    """The factors make the function, and so do the roots."""
    x, fraction = G.variable, G.numerators[0][0] / G.denominators[0][0]
    yield Claim(fraction, found.function, "the function in factors")
    top, bottom = (sp.Mul(*(x - root for root in roots)) for roots in (found.zeros, found.poles))
    yield Claim(fraction, found.gain * top / bottom, "the function by its roots")


def of_pole_factors(found: Any, G: Any) -> Iterator[Claim]:
    """The factors make the denominator."""
    yield Claim(G.denominators[0][0], found, "the denominator in factors")


def of_decay(found: Any, poles: Any, period: Any = None) -> Iterator[Claim | Check]:
    """Every pole is in a mode, with its real part; signs and order are those of numbers; in discrete time with |p|."""
    listed = [pole for mode in found.modes for pole in mode.every]
    yield Check.that("every pole belongs to a mode", "counted", sorted(map(str, listed)) == sorted(map(str, poles)))
    for mode in found.modes:
        for pole in mode.poles:
            if period is None:
                yield Claim(real_part(pole), -mode.rate, "the real part of a pole")
            elif pole != 0:
                yield Claim(absolute(pole), sp.exp(-mode.rate * period), "the size of a pole")
        if mode.sign is not None and not mode.rate.free_symbols:
            yield Check.that("the sign of a rate", ORACLE, bool(sp.N(mode.rate * mode.sign, 30) > 0) or mode.sign == 0)
    if not any(mode.rate.free_symbols for mode in found.modes):
        yield Check.that("the order of numbers is known", ORACLE, bool(found.in_order))
    rates = [sp.N(mode.rate, 30) for mode in found.modes]
    if all(rate.is_number for rate in rates):
        rising = all(a <= b + sp.Float("1e-25") for a, b in pairwise(rates))
        yield Check.that("the slowest mode comes first", ORACLE, bool(rising))


def of_damping_of(found: Any, coefficients: Any) -> Iterator[Claim | Check]:
    """The polynomial is that of ω_n and ζ; the case is that of its roots."""
    b2, b1, b0 = found.coefficients
    yield Claim(found.omega_n**2 * b2, b0, "the natural frequency")
    yield Claim(2 * found.zeta * found.omega_n * b2, b1, "the damping ratio")
    words = judges.damping_words(tuple(coefficients))
    if found.damping:
        yield Check.that("the case of damping", ORACLE, words == {found.damping.replace(" ", "_")})
    elif not b1.free_symbols:
        yield Check.that("no case of damping", ORACLE, words == {""} or bool(b2.free_symbols | b0.free_symbols))


def of_damping_cases(found: Any, damping: Any, wanted: Any = None) -> Iterator[Claim | Check]:
    """Each case holds where the roots say; the roots meet at the critical value."""
    fault = judges.cases_fault(damping.coefficients, found.where)
    yield Check.that("the cases of damping", ORACLE, not fault)
    if found.critical is not None:
        check = partial(judges.critical_residual, damping.coefficients, wanted or found.parameter, found.critical)
        yield numeric.check_residual("the critical value", ORACLE, check)


def of_poles_of_damping(found: Any, damping: Any) -> Iterator[Claim | Check]:
    """The poles are the roots, both or none."""
    x = sp.Symbol("s")
    yield Check.that("both poles are there, or none", "counted", len(found) in (0, 2))
    for pole in found:
        yield Claim((x**2 + damping.twice * x + damping.square).subs(x, pole), sp.Integer(0), "a pole")


def of_damped_frequency(found: Any, damping: Any) -> Iterator[Claim]:
    """ω_d² = ω_n² − (ζω_n)²."""
    if found is not None:
        yield Claim(found**2, damping.square - damping.twice**2 / 4, "the damped frequency")


def of_step_events(found: Any, response: Any, band: Any, *, whole: bool) -> Iterator[Claim | Check]:
    """The times and shares are those of the response by matrix exponentials, searched and refined."""
    system = response.system
    plant = (system.A, system.B, system.C, system.D if system.D is not None else sp.zeros(1, 1))
    asked = judges.Specification(sp.Integer(0), band, whole)
    judged = {
        "final_value": found.final,
        "settling_time": found.settling,
        "rise_time": found.rise.time,
        "overshoot": sp.Integer(0) if found.peak is None else found.peak.share - 1,
        **({} if found.peak is None else {"peak_time": found.peak.time}),
    }
    for name, value in judged.items():
        check = partial(judges.specification_residual, plant, asked, name, value)
        yield numeric.check_residual(
            Phrase("the {name} of the response", name=name.replace("_", " ")), "scipy.linalg.expm", check
        )
    if found.under is not None:
        fault = judges.undershoot_residual(plant, found.under.time, found.under.share)
        yield Check.within("the undershoot of the response", "scipy.linalg.expm", fault, 1e-9)


def of_sampled_events(found: Any, response: Any, band: Any, *, whole: bool, shown: int = 12) -> Iterator[Claim | Check]:
    """Samples and shares are those of the recursion; the bound holds, and falls below the band where it says."""
    del shown
    system = response.system
    plant = (system.A, system.B, system.C, system.D if system.D is not None else sp.zeros(1, 1))
    asked = judges.Specification(sp.Integer(0), band, whole, period=sp.Integer(1))
    judged = {
        "final_value": found.final,
        "settling_time": found.settling,
        "rise_time": found.rise.time,
        "overshoot": sp.Integer(0) if found.peak is None else found.peak.share - 1,
        **({} if found.peak is None else {"peak_time": found.peak.time}),
    }
    for name, value in judged.items():
        check = partial(judges.specification_residual, plant, asked, name, value)
        label = Phrase("the {name} of the response", name=name.replace("_", " "))
        yield numeric.check_residual(label, "the recursion (50 digits)", check)
    yield Check.that("it is told whether it overshoots", "the recursion (50 digits)",
                     judges.overshoots(plant) == (found.peak is not None))  # fmt: skip
    counted = [found.within, found.settling, found.rise.begins, found.rise.ends]
    yield Check.that("samples are counted", "compared", all(each.is_Integer for each in counted))
    fault = judges.samples_fault(plant, found.samples, [each for each in (found.under, found.outside) if each])
    yield Check.within("the samples of the response", "the recursion (50 digits)", fault, 1e-12)
    yield Check.that("no sample exceeds the bound", "the recursion (50 digits)",
                     judges.is_bounded(plant, found.bound, int(found.within), band))  # fmt: skip


def of_reduction(found: Any, form: Any, order: int, *, discrete: bool = False) -> Iterator[Claim | Check]:
    """The slowest poles are kept and no pair is split; the function has them, and the value at zero (at one)."""
    fraction = form.function
    top, bottom = (sp.expand(each) for each in sp.fraction(sp.together(fraction)))
    plant = representation.realized(((top,),), ((bottom,),), form.variable)
    for name, poles in (("kept", found.poles_kept), ("dropped", found.poles_dropped)):
        check = partial(judges.dominant_residual, plant, order, name, poles, discrete=discrete)
        yield numeric.check_residual(Phrase("the poles that are {name}", name=name), ORACLE, check)
    check = partial(judges.reduced_residual, plant, order, found.function, discrete=discrete)
    yield numeric.check_residual("the reduced function", ORACLE, check)
    rest = sp.Integer(1 if discrete else 0)
    above, below = (sp.Mul(*(rest - root for root in roots)) for roots in (found.zeros_dropped, found.poles_dropped))
    yield Claim(above / below, found.constant, "the fast factors for slow signals")
    for mode in (*found.kept, *found.dropped) if discrete else ():
        yield Claim(absolute(mode.poles[0]), sp.exp(-mode.rate), "the rate of a mode")
    if found.ratio is not None and discrete and not found.ratio.is_infinite:
        yield Claim(found.ratio * found.kept[-1].rate, found.dropped[0].rate, "the ratio of rates")
    if found.ratio is not None and not discrete:
        first, last = (real_part(mode.poles[0]) for mode in (found.dropped[0], found.kept[-1]))
        yield Claim(quotient(first, last), found.ratio, "the ratio of real parts")
    zeros = sorted(map(str, (*found.zeros_kept, *found.zeros_dropped)))
    yield Check.that("every zero is kept or dropped", "counted", zeros == sorted(map(str, form.zeros)))


def of_largest_error(found: Any, response: Any) -> Iterator[Check]:
    """No sample of the response is larger, and it has this value at its time."""
    system = response.system
    plant = (system.A, system.B, system.C, system.D if system.D is not None else sp.zeros(1, 1))
    check = partial(judges.largest_size_residual, plant, found.time, found.value)
    yield numeric.check_residual("the largest size of the difference", "scipy.linalg.expm", check)


def of_largest_sampled_error(found: Any, response: Any) -> Iterator[Check]:
    """No sample of the response is larger, and it has this value at its time."""
    system = response.system
    plant = (system.A, system.B, system.C, system.D if system.D is not None else sp.zeros(1, 1))
    fault = judges.largest_sample_fault(plant, found.time, found.value)
    yield Check.within("the largest size of the difference", "the recursion (50 digits)", fault, 1e-8)


def of_largest_difference(found: Any, whole: Any, modes: Any) -> Iterator[Check]:
    """No sample of the difference is larger."""
    plant = (whole.system.A, whole.system.B, whole.system.C, whole.system.D)
    largest = judges.largest_sampled_difference(plant, modes)
    if largest is not None:
        yield Check.within("the largest size of the difference", "scipy.linalg.expm",
                           max(0.0, largest / float(abs(found.value)) - 1), 1e-6)  # fmt: skip
