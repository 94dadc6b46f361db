"""Bode's form K s^ν ∏(1 + s/ω_i)^±1 ∏(1 + 2ζ s/ω_n + s²/ω_n²)^±1: gain, corner frequencies, slopes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import sympy as sp

from solver.exact.frequency.axis import OnAxis
from solver.exact.frequency.surds import decimal, root_of
from solver.exact.linear_algebra.spectrum import Root, roots_of

PER_POWER = 20
"""dB a decade for each power of ω."""


@dataclass(frozen=True)
class Corner:
    """A corner at `omega`: `factor` is 1 at s = 0, `power` > 0 in the numerator; `damping` is that of a pair, or None.

    `change` is that of the slope in dB a decade, all `power`s together.
    """

    omega: sp.Expr
    factor: sp.Expr
    power: int
    damping: sp.Expr | None

    @property
    def change(self) -> int:
        """What the slope gains there, in dB a decade."""
        return PER_POWER * self.power * (1 if self.damping is None else 2)


@dataclass(frozen=True)
class BodeForm:
    """The gain K, the power ν, and the corners, rising; `slopes` before the first and after each different corner."""

    gain: sp.Expr
    power: int
    corners: tuple[Corner, ...]
    slopes: tuple[int, ...]

    @property
    def frequencies(self) -> list[sp.Expr]:
        """The corner frequencies, a multiple one as often as it counts, a pair once at its ω_n."""
        return [each.omega for each in self.corners for _ in range(abs(each.power))]

    @property
    def places(self) -> list[sp.Expr]:
        """The different corner frequencies."""
        return list(dict.fromkeys(each.omega for each in self.corners))


@lru_cache(maxsize=64)
def bode_form(L: OnAxis) -> BodeForm:
    """Return Bode's form of a quotient of polynomials (a dead time stays beside it)."""
    s, found = L.variable, []
    for p, sign in ((L.N, 1), (L.D, -1)):
        for factor, m in p.factor_list()[1]:
            if factor.degree() and factor.TC() != 0:
                found += [_corner(root, sign * m, s) for root in roots_of(factor) if not _is_lower(root)]
    corners = tuple(sorted(found, key=lambda each: (decimal(each.omega), -each.power)))
    gain, power = L.start
    slopes, level = [PER_POWER * power], PER_POWER * power
    for place in dict.fromkeys(each.omega for each in corners):
        level += sum(each.change for each in corners if each.omega == place)
        slopes.append(level)
    return BodeForm(sp.radsimp(gain) if not gain.is_Rational else gain, power, corners, tuple(slopes))


def _is_lower(root: Root) -> bool:
    return root.value.has(sp.I) and bool(root.shift.is_negative)


def _corner(root: Root, power: int, s: sp.Symbol) -> Corner:
    """1 − s/r of a real root, 1 − 2σ s/ω_n² + s²/ω_n² of a pair."""
    if not root.value.has(sp.I):
        value = sp.expand(root.value)
        omega = -value if value.is_negative else value
        return Corner(omega, 1 - s / value if value.is_Rational else 1 - s * sp.radsimp(1 / value), power, None)
    square = sp.expand(root.sigma**2 + root.shift**2)
    omega = root_of(square)
    factor = 1 - sp.radsimp(2 * root.sigma / square) * s + s**2 * sp.radsimp(1 / square)
    damping = -root.sigma / omega
    return Corner(omega, factor, power, damping if damping.has(sp.Float) else sp.radsimp(damping))


__all__ = ["BodeForm", "Corner", "bode_form"]
