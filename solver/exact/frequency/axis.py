"""A quotient of polynomials with a dead time on the imaginary axis: L(jω) = N(jω)/D(jω) e^{−jωT}, by w = ω².

N(jω) = E(w) + jω O(w) with the even and the odd part of N; so N(jω) times the conjugate of D(jω) is R(w) + jω I(w).
What is said of ω² and ω here a discrete loop says of cos ωT and sin ωT, on the unit circle.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import mpmath
import sympy as sp

from solver.exact.frequency.parts import Parts, parts_by_squares
from solver.exact.frequency.places import Place, real_roots
from solver.exact.frequency.shown_factors import shown_factor
from solver.exact.frequency.surds import WORKING, decimal, ratio_of, root_of, value_of
from solver.exact.linear_algebra.fields import NotExact, domain_matrix
from solver.exact.linear_algebra.spectrum import DIGITS

ORDERS = (1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 18, 20, 24, 30)
"""Roots of unity of these orders are tried for an angle that is a rational number of degrees."""

NEAR = mpmath.mpf(10) ** (8 - DIGITS)


@dataclass(frozen=True)
class Angle:
    """What a factor of N (`power` > 0) or D (`power` < 0) gives at jω: a + jb and its angle in (−180, 180], degrees."""

    factor: sp.Expr
    power: int
    real: sp.Expr
    imaginary: sp.Expr
    degrees: sp.Expr


@dataclass(frozen=True)
class OnAxis:
    """L₀ = N/D in lowest terms, polynomials in s over a field of numbers, and the dead time T ≥ 0.

    Of a discrete loop they are polynomials in z, and `sample_time` is known (`OnCircle`).
    """

    N: sp.Poly
    D: sp.Poly
    delay: sp.Expr
    sample_time: sp.Expr | None = None

    @property
    def variable(self) -> sp.Symbol:
        """The symbol s."""
        return self.N.gen

    @property
    def discrete(self) -> bool:
        """Whether the boundary is the unit circle."""
        return self.sample_time is not None

    @property
    def late(self) -> bool:
        """Whether there is a dead time."""
        return bool(self.delay != 0)

    @cached_property
    def parts(self) -> Parts:
        """What N and D are made of on the axis."""
        return parts_by_squares(self.N, self.D)

    @cached_property
    def end(self) -> Place | None:
        """The last frequency; there is none on the axis."""
        return None

    @cached_property
    def start(self) -> tuple[sp.Expr, int]:
        """The c and ν of L ≈ c s^ν about s = 0."""
        (a, k), (b, m) = (_lowest(p) for p in (self.N, self.D))
        return a / b, k - m

    def place(self, omega: sp.Expr) -> sp.Expr:
        """What the parts are polynomials in, at a frequency: ω²."""
        return sp.expand(omega**2)

    def unit(self, omega: sp.Expr) -> sp.Expr:
        """The factor of the odd parts at a frequency: ω."""
        return omega

    def point(self, omega: sp.Expr) -> sp.Expr:
        """The point of the boundary: jω."""
        return sp.I * omega

    def places(self, p: sp.Poly) -> list[Place]:
        """The frequencies between the ends at which a polynomial in ω² is zero, rising."""
        return [Place(root_of(x), x, m) for x, m in real_roots(p) if decimal(x) > 0]

    def first_sign(self, p: sp.Poly) -> int:
        """The sign of a polynomial in ω² that is not zero, at low frequencies."""
        return int(mpmath.sign(decimal(next(c for c in reversed(p.all_coeffs()) if c != 0))))

    def distance(self, r: Any) -> Any:
        """Up to about which frequency a pole or zero does not bend the curve much: |r|."""
        return abs(r)

    @property
    def samples(self) -> list[sp.Expr]:
        """Some values of what the parts are polynomials in, over all frequencies."""
        return [sp.Integer(10) ** k for k in range(-12, 13)]

    @property
    def excess(self) -> int:
        """The degree of D less that of N."""
        return int(self.D.degree() - self.N.degree())

    def rational_value(self, square: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Re L₀ and Im L₀/ω at ω² = `square` (Im L/sin ωT at cos ωT), a number that is no pole."""
        real, imaginary, below = self.parts.real, self.parts.imaginary, self.parts.below
        return ratio_of(real, below, square), ratio_of(imaginary, below, square)

    def value(self, omega: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Re L and Im L at a frequency; with a dead time in decimals, unless ωT is a simple part of π."""
        real, slope = self.rational_value(self.place(omega))
        imaginary = sp.expand(self.unit(omega) * slope)
        if not self.late:
            return real, imaginary
        angle = sp.expand(-omega * self.delay)
        if not (angle / sp.pi).is_Rational:
            angle = sp.N(angle, WORKING)
        c, s = sp.cos(angle), sp.sin(angle)
        turned = (sp.expand(real * c - imaginary * s), sp.expand(real * s + imaginary * c))
        x, y = (sp.Float(each, DIGITS) if each.has(sp.Float) else each for each in turned)
        return x, y

    def magnitude(self, omega: sp.Expr) -> sp.Expr:
        """|L| at a frequency."""
        return root_of(ratio_of(self.parts.above, self.parts.below, self.place(omega)))

    def phase(self, omega: sp.Expr) -> sp.Expr:
        """∠L at a frequency in degrees, in (−180, 180]: rational where it is, else 30 digits."""
        angle = self._rational_phase(omega)
        late = sp.expand(180 * omega * self.delay / sp.pi)
        if not late.is_Rational:
            late = sp.N(late, WORKING)
        found = angle - late
        if not found.is_Rational:
            found = sp.N(found, WORKING)
        turned = found - 360 * sp.ceiling((found - 180) / 360)
        return turned if turned.is_Rational else sp.Float(turned, DIGITS)

    def _rational_phase(self, omega: sp.Expr) -> sp.Expr:
        """∠L₀: where it is a rational number of degrees, a power of L₀ is real."""
        place = self.place(omega)
        real, slope = self.rational_value(place)
        with mpmath.workdps(WORKING):
            x, y = (decimal(each) for each in (real, self.unit(omega) * slope))
            degrees = mpmath.degrees(mpmath.atan2(y, x))
            if not place.has(sp.Float):
                square = value_of(self.parts.unit, place)
                for m in ORDERS:
                    whole = mpmath.nint(degrees * m / 180)
                    if abs(degrees * m / 180 - whole) < NEAR and _is_real_power(real, slope, square, m):
                        return sp.Rational(180 * int(whole), m)
            return sp.Float(degrees, WORKING)

    def angles(self, omega: sp.Expr) -> list[Angle]:
        """The angles of the number before the factors, if it is negative, of those of N, and of those of D."""
        s, listed = self.variable, []
        number = sp.S.One
        for p, sign in ((self.N, 1), (self.D, -1)):
            for factor, m in p.factor_list()[1]:
                listed.append((self.shown_factor(factor).as_expr(), sign * m))
            number *= (p.LC() / sp.Mul(*(sp.Poly(f, s).LC() ** abs(m) for f, m in listed if m * sign > 0))) ** sign
        negative = [(sp.Integer(-1), 1)] if decimal(number) < 0 else []
        return [self._angle(factor, power, omega) for factor, power in (*negative, *listed)]

    def shown_factor(self, factor: sp.Poly) -> sp.Poly:
        """A factor of N or D up to a positive or negative number, see `shown_factor`."""
        return shown_factor(factor)

    def _angle(self, factor: sp.Expr, power: int, omega: sp.Expr) -> Angle:
        p = sp.Poly(factor, self.variable, extension=True)
        found = type(self)(p, sp.Poly(1, self.variable, domain=p.domain), sp.S.Zero, self.sample_time)
        real, imaginary = found.value(omega)
        return Angle(factor, power, real, imaginary, found.phase(omega))

    @cached_property
    def roots(self) -> tuple[tuple[Any, int], ...]:
        """The zeros (power > 0) and poles (power < 0) but s = 0, of pairs the upper one, in decimals."""
        found: list[tuple[Any, int]] = []
        for p, sign in ((self.N, 1), (self.D, -1)):
            for factor, m in p.factor_list()[1]:
                found += [(r, sign * m) for r in upper_roots(factor) if r != 0]
        return tuple(found)

    def continuous_phase(self, omega: sp.Expr) -> sp.Float:
        """The phase in degrees, continuous from ω → 0 on: each factor of Bode's form begins with 0°, K < 0 with −180°.

        At a pole or zero on the axis the phase jumps as if that lay just to the left.
        """
        with mpmath.workdps(WORKING):
            return sp.Float(self.turned(decimal(omega)), DIGITS)

    def turned(self, omega: Any) -> Any:
        """The same in numbers of mpmath."""
        c, power = self.start
        total = mpmath.mpf(90) * power - (180 if decimal(c) < 0 else 0)
        for r, m in self.roots:
            if r.imag:
                total += m * mpmath.degrees(mpmath.atan2(-2 * omega * r.real + 0, abs(r) ** 2 - omega**2))
            else:
                total += m * mpmath.degrees(mpmath.atan(-omega / r.real))
        return total - mpmath.degrees(omega * decimal(self.delay))


@lru_cache(maxsize=64)
def on_axis(numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol, delay: sp.Expr = sp.S.Zero) -> OnAxis:
    """Return N/D e^{−Ts} cancelled; raises NotExact where a parameter is left."""
    return OnAxis(*in_lowest_terms(numerator, denominator, s, delay), sp.S.Zero + delay)


def in_lowest_terms(
    numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol, *numbers: sp.Expr
) -> tuple[sp.Poly, sp.Poly]:
    """N and D over one field, cancelled; raises NotExact where a parameter is left, there or in `numbers`."""
    free = set().union(*((sp.S.Zero + each).free_symbols for each in (numerator, denominator, *numbers))) - {s}
    if free:
        raise NotExact("frequency/parameters", names=sorted(free, key=str))
    p, q = sp.Poly(numerator, s), sp.Poly(denominator, s)
    if p.is_zero:
        raise NotExact("frequency/nothing_passes")
    flat = [*p.all_coeffs(), *q.all_coeffs()]
    matrix = domain_matrix(sp.Matrix([flat]))
    ((*entries,),) = matrix.to_list()
    n = p.degree() + 1
    N, D = (sp.Poly(each, s, domain=matrix.domain) for each in (entries[:n], entries[n:]))
    common = N.gcd(D)
    return N.quo(common), D.quo(common)


def _lowest(p: sp.Poly) -> tuple[sp.Expr, int]:
    """The coefficient of the lowest power, and the power."""
    power = next(i for i, c in enumerate(reversed(p.all_coeffs())) if c != 0)
    return p.nth(power), power


def _is_real_power(real: sp.Expr, slope: sp.Expr, square: sp.Expr, m: int) -> bool:
    """Whether (a + jub)^m is real, with u² = `square`."""
    a, b = real, slope
    for _ in range(m - 1):
        a, b = sp.expand(a * real - square * b * slope), sp.expand(a * slope + b * real)
    return bool(b == 0 or square == 0 or sp.radsimp(b) == 0)


def upper_roots(p: sp.Poly) -> Iterator[Any]:
    """The real roots of an irreducible polynomial, and the upper one of each pair, in decimals."""
    with mpmath.workdps(2 * DIGITS):
        coefficients = [decimal(c) for c in p.all_coeffs()]
        even = all(c == 0 for c in coefficients[1::2])
        found = (
            [-coefficients[1] / coefficients[0]]
            if len(coefficients) == 2
            else mpmath.polyroots(coefficients, maxsteps=500, extraprec=400)
        )
        for each in map(mpmath.mpc, found):
            flat = abs(each.imag) < NEAR * (1 + abs(each))
            upright = even and abs(each.real) < NEAR * (1 + abs(each))
            if flat:
                yield mpmath.mpc(each.real)
            elif each.imag > 0:
                yield mpmath.mpc(0 if upright else each.real, each.imag)


__all__ = ["NEAR", "Angle", "OnAxis", "in_lowest_terms", "on_axis", "upper_roots"]
