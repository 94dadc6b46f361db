"""How fast the modes of some poles decay: rates −Re p, time constants, and which modes are the slowest.

In discrete time p = e^{sT}, so that the rate −Re s is −ln|p|/T, and the slowest mode has the largest |p|.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy as sp

from solver.exact.linear_algebra.radicals import complex_parts
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.stability.inequalities import sign_of


@dataclass(frozen=True)
class DecayMode:
    """Poles with one real part and opposite imaginary ones: one, or a conjugate pair; `rate` is −Re p.

    `sign` is that of the rate, None where parameters leave it open; `count` is how many poles these are in all.
    In discrete time `rate` is −ln|p|/T, infinite for p = 0, and `square` is |p|².
    """

    poles: tuple[sp.Expr, ...]
    rate: sp.Expr
    sign: int | None
    multiplicity: int
    square: sp.Expr | None = None

    @property
    def count(self) -> int:
        """The number of poles."""
        return len(self.poles) * self.multiplicity

    @property
    def every(self) -> list[sp.Expr]:
        """The poles, each as often as it occurs."""
        return [pole for _ in range(self.multiplicity) for pole in self.poles]

    @property
    def time_constant(self) -> sp.Expr:
        """1/|Re p| of a mode that decays, in discrete time T/|ln|p||."""
        if self.square is not None:
            return 1 / self.rate
        return sp.cancel(1 / self.rate) if self.rate.free_symbols else sp.radsimp(1 / self.rate)

    @property
    def decimals(self) -> sp.Expr | None:
        """The time constant in decimals where it is a number that has a logarithm in it."""
        tau = self.time_constant
        return sp.N(tau, DIGITS) if tau.has(sp.log) and not tau.free_symbols else None


@dataclass(frozen=True)
class Decay:
    """The modes, the slowest first; `in_order` is False where parameters leave open which of two is slower."""

    modes: tuple[DecayMode, ...]
    in_order: bool


def decay(poles: Sequence[sp.Expr], period: sp.Expr | None = None) -> Decay:
    """The modes of poles that are listed with multiplicity, conjugates among them; discrete where there is a period."""
    found: list[DecayMode] = []
    for pole in dict.fromkeys(poles):
        real, imaginary = complex_parts(pole)
        partner = sp.expand(real - sp.I * imaginary)
        known = next((i for i, each in enumerate(found) if _same(each.poles[0], partner)), None)
        if imaginary != 0 and known is not None:
            first = found[known]
            found[known] = replace(first, poles=(*first.poles, pole))
            continue
        if period is not None:
            found.append(_of_power(pole, sp.expand(real**2 + imaginary**2), list(poles).count(pole), period))
            continue
        rate = sp.factor(-real) if real.free_symbols else -real
        found.append(DecayMode((pole,), rate, sign_of(rate), list(poles).count(pole)))
    return _sorted(found)


def _of_power(pole: sp.Expr, square: sp.Expr, multiplicity: int, period: sp.Expr) -> DecayMode:
    """The mode of pᵏ, with the sign of 1 − |p|²."""
    if square == 0:
        return DecayMode((pole,), sp.oo, 1, multiplicity, square)
    size = sp.sqrt(square)  # a root that comes out leaves a shorter logarithm
    rate = -sp.log(size) / period if size.is_Rational else -sp.log(square) / (2 * period)
    if pole.free_symbols:
        rate = -sp.log(sp.Abs(pole)) / period
    sign = sign_of(sp.factor(1 - square))
    return DecayMode((pole,), rate, sign_of(rate) if sign is None else sign, multiplicity, square)


def _same(a: sp.Expr, b: sp.Expr) -> bool:
    return bool(a == b or sp.expand(a - b) == 0)


def _compared(mode: DecayMode, other: DecayMode) -> int | None:
    """The sign of the difference of both rates."""
    if mode.square is not None and other.square is not None:
        sign = sign_of(sp.expand(other.square - mode.square))
        apart = [complex_parts(each.poles[0])[0] for each in (other, mode)]
        return sign if sign != 0 else sign_of(sp.expand(apart[0] - apart[1]))  # of one size that nearer to one first
    return sign_of(sp.expand(mode.rate - other.rate))


def _sorted(modes: list[DecayMode]) -> Decay:
    """By rising rate, as far as it is known which is less; equal ones as they came."""
    listed: list[DecayMode] = []
    in_order = True
    for mode in modes:
        place = len(listed)
        for i, other in enumerate(listed):
            sign = _compared(mode, other)
            in_order = in_order and sign is not None
            if sign == -1:
                place = i
                break
        listed.insert(place, mode)
    return Decay(tuple(listed), in_order)
