"""How far the step response of a reduced transfer function is from that of the whole one, in 30 digits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mpmath
import sympy as sp

from solver.exact.classical.exponential_sums import WORKING, ExponentialSum, zeros
from solver.exact.classical.reduction import Reduction
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.time_response.peaks import modes_of
from solver.exact.time_response.response import ClosedForm


@dataclass(frozen=True)
class LargestError:
    """The largest size of a difference and when; `time` is ∞ where it is only tended to."""

    time: sp.Expr
    value: sp.Expr


def largest_error(found: ClosedForm) -> LargestError:
    """The value of largest size of a response that tends to a limit, in 30 digits."""
    with mpmath.workdps(WORKING):
        return _largest(ExponentialSum.of_modes(modes_of(found.pieces[0][1].y)))  # type: ignore[arg-type]  # it has an output


def _largest(f: ExponentialSum) -> LargestError:
    with mpmath.workdps(WORKING):
        limit = f.constant
        moving = ExponentialSum(tuple(term for term in f.terms if term[0]))
        best, time = f.value(mpmath.mpf(0)), sp.Integer(0)
        if not moving.terms:
            return LargestError(time, sp.Float(best, DIGITS))
        seen = max(abs(f.at(moving.slowest * i / 16)) for i in range(64)) - abs(float(limit))
        end = moving.below(max(seen, 1e-6 * moving.bound(0.0, 0.0)) * (1 - 1e-9))
        for zero in zeros(moving.slope, 0.0, end):
            value = f.value(mpmath.mpmathify(zero.time))
            if abs(value) > abs(best):
                best, time = value, zero.time
        if abs(limit) > abs(best):
            best, time = limit, sp.oo
        return LargestError(time, sp.Float(best, DIGITS))


Modes = list[tuple[Any, int, Any]]
"""λ, j, c of terms c t^{j−1}/(j−1)! e^{λt}."""


def reduced_modes(found: Reduction) -> Modes | None:
    """The modes of the step response of a reduced function with simple poles; None for others."""
    poles = [mpmath.mpmathify(sp.N(pole, WORKING)) for pole in found.poles_kept]
    if any(mode.multiplicity > 1 for mode in found.kept):
        return None
    x = next(iter(found.bottom.free_symbols))
    with mpmath.workdps(WORKING):
        gain = mpmath.mpmathify(sp.N(found.gain, WORKING))
        top = [mpmath.mpmathify(sp.N(c, WORKING)) for c in sp.Poly(found.top, x).all_coeffs()]
        modes: Modes = []
        for i, p in enumerate(poles):
            if p:
                others = mpmath.fprod(p - q for j, q in enumerate(poles) if j != i)
                modes.append((mpmath.mpc(p), 1, mpmath.mpc(gain * mpmath.polyval(top, p) / (p * others))))
        start = gain if len(top) == len(poles) + 1 else mpmath.mpf(0)
        modes.append((mpmath.mpc(0), 1, mpmath.mpc(start - mpmath.fsum(c for _, _, c in modes).real)))
        if any(not p for p in poles):
            below = mpmath.fprod(-q for q in poles if q)
            modes.append((mpmath.mpc(0), 2, mpmath.mpc((gain * top[-1] / below).real)))
        return modes


def reduced_response(modes: Modes, t: sp.Symbol) -> sp.Expr:
    """The response with these modes, in decimals."""
    terms = []
    for m, j, c in modes:
        if m.imag < 0:
            continue
        sigma, omega, a, b = (sp.Float(each, DIGITS) for each in (m.real, m.imag, c.real, c.imag))
        if m.imag:
            terms.append(2 * sp.exp(sigma * t) * (a * sp.cos(omega * t) - b * sp.sin(omega * t)))
        else:
            terms.append(a * t ** (j - 1) * (sp.exp(sigma * t) if m else 1))
    return sp.Add(*terms)


def largest_difference(whole: ClosedForm, modes: Modes) -> LargestError:
    """The largest difference of a response and one with these modes, both bounded or with the same slope in the end."""
    with mpmath.workdps(WORKING):
        listed = modes_of(whole.pieces[0][1].y) + [(m, j, -c) for m, j, c in modes]  # type: ignore[arg-type]
        lasting = [(m, j, c) for m, j, c in listed if not m]
        level = mpmath.fsum(c for _, j, c in lasting if j == 1)
        moving = [(m, j, c) for m, j, c in listed if m]
        size = max(abs(c) for _, _, c in listed)
        kept = [(mpmath.mpc(0), 1, mpmath.mpc(level))] if abs(level) > size * mpmath.mpf(10) ** (5 - DIGITS) else []
        return _largest(ExponentialSum.of_modes([*moving, *kept]))
