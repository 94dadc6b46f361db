"""Gain and phase margin of a loop L: how far L(jω) is from −1 along the real axis and along the unit circle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import mpmath
import sympy as sp

from solver.exact.frequency.axis import OnAxis
from solver.exact.frequency.crossings import Crossover, GainCrossovers, gain_crossovers
from solver.exact.frequency.real_axis import PhaseCrossovers, phase_crossovers
from solver.exact.frequency.surds import decimal, reciprocal, value_of
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.spectrum import DIGITS


@dataclass(frozen=True)
class Margins:
    """The crossovers, and of those the two that are nearest to −1 (None: there is none) with their margins.

    `gain_margin` is 1/|L|, in dB `gain_margin_db`; `phase_margin` is 180° + ∠L in (−180, 180]; `oo` without crossover.
    """

    gains: GainCrossovers
    phases: PhaseCrossovers
    at_gain: Crossover | None
    at_phase: Crossover | None
    gain_margin: sp.Expr
    phase_margin: sp.Expr

    @property
    def gain_crossover(self) -> sp.Expr:
        """The frequency at which the phase margin is taken."""
        return sp.oo if self.at_gain is None else self.at_gain.omega

    @property
    def phase_crossover(self) -> sp.Expr:
        """The frequency at which the gain margin is taken."""
        return sp.oo if self.at_phase is None else self.at_phase.omega

    @property
    def gain_margin_db(self) -> sp.Expr:
        """20 log₁₀ of the gain margin: whole where that is a power of ten, else 30 digits."""
        return in_decibels(self.gain_margin)


def in_decibels(ratio: sp.Expr) -> sp.Expr:
    """20 log₁₀ of a positive number: rational for powers of ten and their roots, else 30 digits."""
    if not ratio.is_finite:
        return ratio
    if not ratio.has(sp.Float):
        square = sp.expand(ratio**2)
        if square.is_Rational:
            tens = sp.multiplicity(10, square) if square.is_Integer else -sp.multiplicity(10, 1 / square)
            if square == sp.Integer(10) ** tens:
                return sp.Integer(10 * tens)
    with mpmath.workdps(2 * DIGITS):
        return sp.Float(20 * mpmath.log10(decimal(ratio)), DIGITS)


def phase_margin_of(phase: sp.Expr) -> sp.Expr:
    """180° + φ, in (−180, 180]."""
    margin = phase + 180
    return margin if decimal(margin) <= 180 else margin - 360


@lru_cache(maxsize=64)
def margins_of(L: OnAxis) -> Margins:
    """The margins of a loop; raises NotExact where every frequency is a crossover."""
    gains, phases = gain_crossovers(L), phase_crossovers(L)
    if gains.everywhere:
        raise NotExact("frequency/gain_of_one_everywhere")
    if phases.everywhere:
        phases = _on_the_real_axis(L, gains, phases)
    at_gain = _nearest(gains.found, [abs(decimal(phase_margin_of(each.phase))) for each in gains.found])
    at_phase = _nearest(phases.found, [abs(mpmath.log(decimal(each.magnitude))) for each in phases.found])
    gain_margin = sp.oo if at_phase is None else reciprocal(at_phase.magnitude)
    phase_margin = sp.oo if at_gain is None else phase_margin_of(at_gain.phase)
    return Margins(gains, phases, at_gain, at_phase, gain_margin, phase_margin)


def _on_the_real_axis(L: OnAxis, gains: GainCrossovers, phases: PhaseCrossovers) -> PhaseCrossovers:
    """Where L is real for all ω: it is −1 at a gain crossover with the phase 180°, else no frequency decides."""
    through = tuple(each for each in gains.found if each.phase == 180)
    if through:
        return PhaseCrossovers(phases.polynomial, through, everywhere=True)
    samples = [L.rational_value(each)[0] for each in L.samples if value_of(L.parts.below, each) != 0]
    if any(decimal(each) < 0 for each in samples):
        raise NotExact("frequency/real_everywhere")
    return phases


def _nearest(found: Sequence[Crossover], distances: Sequence[object]) -> Crossover | None:
    """The one of smallest distance, of equals the first."""
    best = min(range(len(found)), key=lambda i: distances[i], default=None)  # type: ignore[arg-type,return-value]
    return None if best is None else found[best]


__all__ = ["Margins", "in_decibels", "margins_of", "phase_margin_of"]
