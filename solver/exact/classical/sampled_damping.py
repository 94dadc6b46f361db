"""Natural frequency and damping of a sampled system of second order: those of the poles s = (ln z)/T.

Source: Franklin, Powell and Workman, Digital Control of Dynamic Systems, section 4.3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.classical.damping import NoFrequency
from solver.exact.linear_algebra.radicals import square_root
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.stability.inequalities import sign_of


class NoCounterpart(Exception):  # noqa: N818 - it is a finding
    """A pole z that is zero or negative is e^{sT} of no pole s with which a system of second order is real."""

    def __init__(self, pole: sp.Expr) -> None:
        super().__init__(str(pole))
        self.pole = pole


@dataclass(frozen=True)
class SampledDamping:
    """The poles in z and in s, ω_n, ζ, and the case of damping, "" where it is negative.

    Of a pair `size` is |z| and `angle` is arg z of the upper pole; real poles have neither.
    """

    poles_z: tuple[sp.Expr, sp.Expr]
    poles_s: tuple[sp.Expr, sp.Expr]
    omega_n: sp.Expr
    zeta: sp.Expr
    damping: str
    sign: int
    size: sp.Expr | None = None
    angle: sp.Expr | None = None

    @property
    def angle_decimals(self) -> sp.Expr | None:
        """The angle in decimals where it is no fraction of π."""
        return self.decimals_of(self.angle) if self.angle is not None and self.angle.has(sp.acos) else None

    def decimals_of(self, value: sp.Expr) -> sp.Expr | None:
        """A number with a logarithm or an angle in it, in decimals; None of others."""
        special = value.has(sp.log, sp.acos, sp.pi) and not value.free_symbols
        return sp.N(value, DIGITS) if special else None


def sampled_damping_of(coefficients: Sequence[sp.Expr], period: sp.Expr) -> SampledDamping:
    """ω_n and ζ of b₂z² + b₁z + b₀ (numbers), sampled with a period.

    Raises NoFrequency where ω_n² is not positive, NoCounterpart for a pole z ≤ 0.
    """
    b2, b1, b0 = coefficients
    middle, square = -b1 / (2 * b2), sp.cancel(b0 / b2)
    apart = sp.expand(middle**2 - square)
    if sign_of(apart) == -1:
        return _of_a_pair(middle, square, square_root(-apart), period)
    root = square_root(apart)
    z = (sp.expand(middle + root), sp.expand(middle - root))
    for pole in z:
        if sign_of(pole) != 1:
            raise NoCounterpart(pole)
    return _of_real_poles(z, period)


def _of_a_pair(middle: sp.Expr, square: sp.Expr, above: sp.Expr, period: sp.Expr) -> SampledDamping:
    """The poles z = r e^{±jθ}: s = (ln r ± jθ)/T."""
    size = square_root(square)
    logarithm, angle = sp.log(square) / 2, sp.acos(sp.radsimp(middle / size))
    distance = sp.sqrt(logarithm**2 + angle**2)
    sign = -(sign_of(square - 1) or 0)
    return SampledDamping(
        (middle + sp.I * above, middle - sp.I * above),
        ((logarithm + sp.I * angle) / period, (logarithm - sp.I * angle) / period),
        distance / period,
        -logarithm / distance if sign else sp.S.Zero,
        {0: "undamped", 1: "underdamped"}.get(sign, ""),
        sign,
        size,
        angle,
    )


def _of_real_poles(z: tuple[sp.Expr, sp.Expr], period: sp.Expr) -> SampledDamping:
    """Positive poles: s = (ln z)/T, both negative or both positive."""
    first, second = (sp.log(pole) for pole in z)
    signs = {sign_of(pole - 1) or 0 for pole in z}
    if len(signs) > 1 or 0 in signs:
        raise NoFrequency(first * second / period**2)
    sign = -signs.pop()
    double = z[0] == z[1]
    root = sp.Abs(first) if double else sp.sqrt(first * second)
    zeta = sp.Integer(sign) if double else -(first + second) / (2 * root)
    word = "critically damped" if double else "overdamped"
    return SampledDamping(
        z, (first / period, second / period), root / period, zeta, word if sign > 0 else "", sign
    )  # fmt: skip
