"""A quotient of polynomials in z on the unit circle: L(e^{jωT}) = N/D for 0 ≤ ω ≤ π/T, by c = cos ωT.

N(e^{jωT}) = E(c) + j sin ωT O(c), with Chebyshev's polynomials; so what holds of the imaginary axis with w = ω² holds
here with c, which falls from 1 to −1, and with 1 − c² for the square of the factor of the odd parts.
"""

from __future__ import annotations

from functools import cached_property, lru_cache
from typing import Any

import mpmath
import sympy as sp

from solver.exact.frequency.axis import NEAR, OnAxis, in_lowest_terms, upper_roots
from solver.exact.frequency.parts import Parts, parts_by_cosines
from solver.exact.frequency.places import Place, real_roots
from solver.exact.frequency.surds import WORKING, decimal, root_of, surd
from solver.exact.linear_algebra.spectrum import DIGITS

PARTS_OF_PI = (1, 2, 3, 4, 5, 6, 8, 10, 12)
"""Of an angle that is such a part of π, or a multiple of it, the cosine is written with square roots."""


class OnCircle(OnAxis):
    """L = N/D in lowest terms, polynomials in z; `sample_time` is T, there is no dead time apart from powers of z."""

    @cached_property
    def parts(self) -> Parts:
        """What N and D are made of on the circle."""
        return parts_by_cosines(self.N, self.D)

    @property
    def period(self) -> sp.Expr:
        """The sampling period T."""
        return sp.S.One if self.sample_time is None else self.sample_time

    @cached_property
    def end(self) -> Place | None:
        """The Nyquist frequency π/T, where z = −1."""
        return Place(sp.pi / self.period, sp.S.NegativeOne, 1)

    @cached_property
    def start(self) -> tuple[sp.Expr, int]:
        """The c and ν of L ≈ c (z − 1)^ν about z = 1."""
        (a, k), (b, m) = (_without_ones(p) for p in (self.N, self.D))
        return sp.radsimp(a / b), k - m

    def place(self, omega: sp.Expr) -> sp.Expr:
        """Cos ωT: in a closed form where ω was found by it, or ωT is a simple part of π, else in decimals."""
        angle = sp.expand(omega * self.period)
        if angle.func is sp.acos:
            return angle.args[0]
        return _of_angle(sp.cos, angle)

    def unit(self, omega: sp.Expr) -> sp.Expr:
        """Sin ωT; a decimal where a square root stands below the root."""
        angle = sp.expand(omega * self.period)
        if angle.func is not sp.acos:
            return _of_angle(sp.sin, angle)
        square = sp.expand(1 - angle.args[0] ** 2)
        found = root_of(square)
        nested = not square.is_Rational and not (surd(found) or square.has(sp.Float)) and _is_nested(found)
        return sp.Float(sp.N(found, WORKING), DIGITS) if nested else found

    def point(self, omega: sp.Expr) -> sp.Expr:
        """The point of the circle, e^{jωT}."""
        return sp.exp(sp.I * sp.expand(omega * self.period))

    def places(self, p: sp.Poly) -> list[Place]:
        """The frequencies between 0 and π/T at which a polynomial in cos ωT is zero, rising."""
        inner = [(x, m) for x, m in real_roots(p) if -1 < decimal(x) < 1]
        return [Place(sp.acos(x) / self.period, x, m) for x, m in reversed(inner)]

    def first_sign(self, p: sp.Poly) -> int:
        """The sign of a polynomial in cos ωT that is not zero, at low frequencies: just below 1."""
        below = p.compose(sp.Poly(1 - p.gen, p.gen, domain=p.domain))
        return super().first_sign(below)

    def distance(self, r: Any) -> Any:
        """|r − 1|/T."""
        return abs(r - 1) / decimal(self.period)

    @property
    def samples(self) -> list[sp.Expr]:
        """Some cosines."""
        return [sp.Rational(k, 13) for k in range(12, -13, -1)]

    def shown_factor(self, factor: sp.Poly) -> sp.Poly:
        """A factor of N or D up to a number: monic, so that a root is read off."""
        return factor.to_field().monic()

    @cached_property
    def roots(self) -> tuple[tuple[Any, int], ...]:
        """The zeros (power > 0) and poles (power < 0) but z = 1, of pairs the upper one, in decimals."""
        found: list[tuple[Any, int]] = []
        for p, sign in ((self.N, 1), (self.D, -1)):
            for factor, m in p.factor_list()[1]:
                found += [(r, sign * m) for r in upper_roots(factor) if r != 1]
        return tuple(found)

    def turned(self, omega: Any) -> Any:
        """The phase in degrees, continuous from ω → 0 on: (z − r)/(1 − r) begins with 0°, a negative gain with −180°.

        At a pole or zero on the circle the phase jumps as if that lay just inside.
        """
        c, power = self.start
        theta = omega * decimal(self.period)
        z = mpmath.expj(theta)
        total = (90 + mpmath.degrees(theta) / 2) * power - (180 if decimal(c) < 0 else 0)
        for r, m in self.roots:
            if not r.imag:
                total += m * mpmath.degrees(mpmath.arg((z - r.real) / (1 - r.real)))
            elif abs(r) <= 1 + NEAR:
                total += m * mpmath.degrees(2 * theta + sum(mpmath.arg(1 - each / z) for each in (r, mpmath.conj(r))))
            else:
                total += m * mpmath.degrees(sum(mpmath.arg(1 - z / each) for each in (r, mpmath.conj(r))))
        return total


@lru_cache(maxsize=64)
def on_circle(numerator: sp.Expr, denominator: sp.Expr, z: sp.Symbol, sample_time: sp.Expr) -> OnCircle:
    """Return N/D cancelled; raises NotExact where a parameter is left, the sampling period among them."""
    N, D = in_lowest_terms(numerator, denominator, z, sample_time)
    return OnCircle(N, D, sp.S.Zero, sp.S.Zero + sample_time)


def _of_angle(f: Any, angle: sp.Expr) -> sp.Expr:
    """The cosine or sine of an angle: in square roots where it is such a part of π, else a decimal."""
    if angle.free_symbols:
        return f(angle)
    part = angle / sp.pi
    if part.is_Rational and part.q in PARTS_OF_PI:
        found = sp.expand(f(angle))
        if not _is_nested(found):
            return found
    return sp.Float(sp.N(f(angle), WORKING), WORKING)


def _is_nested(x: sp.Expr) -> bool:
    """Whether a square root stands below another."""
    return any(each.base.has(sp.Pow) for each in x.atoms(sp.Pow) if not each.base.is_Rational)


def _without_ones(p: sp.Poly) -> tuple[sp.Expr, int]:
    """The value at 1 of a polynomial without its factors z − 1, and how many these are."""
    one, count = sp.Poly(p.gen - 1, p.gen, domain=p.domain), 0
    while True:
        rest, left = p.div(one)
        if not left.is_zero:
            return p(1), count
        p, count = rest, count + 1


__all__ = ["OnCircle", "on_circle"]
