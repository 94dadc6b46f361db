"""The z-transform of a sampled function f((k + μ)T), f a sum of c tⁿ e^{σt} times 1, cos ωt, sin ωt, cosh ωt, sinh ωt.

With a = e^{(σ + jω)T} a term is the real part of a multiple of kⁿ aᵏ, and Z{kⁿ aᵏ} = z a eₙ(z, a)/(z − a)^{n+1}, where
z a eₙ comes from k of the one before: Z{k x} = −z dX/dz (Ogata, Discrete-Time Control Systems, table 2-1).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, reduce
from math import comb
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact

Coefficients = list[sp.Expr]
"""Of a polynomial in z, the highest power first."""

WAVES = (sp.cos, sp.sin, sp.cosh, sp.sinh)


@dataclass(frozen=True)
class Base:
    """a = r e^{jθ} of the powers aᵏ, r(cosh θ ± sinh θ) where `hyperbolic`; θ = 0: a is r."""

    radius: sp.Expr
    angle: sp.Expr = sp.S.Zero
    hyperbolic: bool = False

    @property
    def waves(self) -> tuple[Any, Any]:
        """Cosine and sine."""
        return (sp.cosh, sp.sinh) if self.hyperbolic else (sp.cos, sp.sin)

    def polynomial(self, z: sp.Symbol) -> sp.Expr:
        """z − a, or the quadratic of the pair: z² − 2r cos θ z + r²."""
        return sp.Add(*(c * z**i for i, c in enumerate(reversed(self.coefficients))))

    @property
    def coefficients(self) -> Coefficients:
        """Those of the polynomial."""
        if self.angle == 0:
            return [sp.S.One, -self.radius]
        return [sp.S.One, -2 * self.radius * self.waves[0](self.angle), sp.expand(self.radius**2)]


@dataclass(frozen=True)
class Sample:
    """A term c kⁿ rᵏ w(θk) of a sequence, w by its `wave`: "cos", "sin" (hyperbolic as the base is), or none ("")."""

    factor: sp.Expr
    power: int
    base: Base
    wave: str = ""

    def function(self, k: sp.Symbol) -> sp.Expr:
        """The term as a function of k."""
        cosine, sine = self.base.waves
        wave = {"": sp.S.One, "cos": cosine(self.base.angle * k), "sin": sine(self.base.angle * k)}[self.wave]
        return self.factor * k**self.power * self.base.radius**k * wave


@dataclass(frozen=True)
class SampledImage:
    """A z-transform z N(z)/Π pᵢ^{mᵢ}: the terms of the sequence, grouped by their bases."""

    samples: tuple[Sample, ...]

    @cached_property
    def groups(self) -> dict[Base, tuple[int, Coefficients]]:
        """By base: the power m of its polynomial below, and the numerator over z (coefficients in z)."""
        bases = dict.fromkeys(each.base for each in self.samples)
        return {base: _group(base, [each for each in self.samples if each.base == base]) for base in bases}

    @cached_property
    def numerator(self) -> Coefficients:
        """N, over the product of all denominators."""
        total: Coefficients = []
        for base, (_, above) in self.groups.items():
            others = [powered(each.coefficients, m) for each, (m, _) in self.groups.items() if each != base]
            total = added(total, reduce(multiplied, others, above))
        return trimmed(total)

    @property
    def factors(self) -> list[tuple[Base, int]]:
        """The polynomials of the denominator with their powers."""
        return [(base, m) for base, (m, _) in self.groups.items()]

    def terms(self, z: sp.Symbol) -> list[sp.Expr]:
        """The transform base by base, as fractions."""
        return [
            z * in_z(above, z) / base.polynomial(z) ** m for base, (m, above) in self.groups.items() if trimmed(above)
        ]

    def sequence(self, k: sp.Symbol) -> sp.Expr:
        """The sequence that is transformed."""
        return sp.Add(*(each.function(k) for each in self.samples))


def sampled_image(f: sp.Expr, t: sp.Symbol, T: sp.Expr, ahead: sp.Expr = sp.S.Zero) -> SampledImage:
    """The transform of f((k + μ)T), k = 0, 1, …, with μ = `ahead`; raises NotExact where f is no sum of such terms."""
    merged: dict[tuple[Base, int, str], sp.Expr] = {}
    marks = {each: sp.Dummy() for each in f.atoms(sp.exp) if each.has(t)}  # e^{-at}/c is not to become 1/(c e^{at})
    back = {mark: each for each, mark in marks.items()}
    for term in sp.Add.make_args(sp.expand(f.xreplace(marks), power_exp=False).xreplace(back)):
        for each in _sampled(term, t, T, ahead):
            key = (each.base, each.power, each.wave)
            merged[key] = merged.get(key, sp.S.Zero) + each.factor
    expanded = {key: sp.expand(c, power_exp=False) for key, c in merged.items()}
    return SampledImage(tuple(Sample(c, n, base, wave) for (base, n, wave), c in expanded.items() if c != 0))


def _sampled(term: sp.Expr, t: sp.Symbol, T: sp.Expr, ahead: sp.Expr) -> Iterator[Sample]:
    """A term of f at t = (k + μ)T: its power by the binomial theorem, its wave by the addition theorem."""
    constant, n, sigma, wave, omega = _read(term, t)
    constant *= sp.exp(sp.expand(sigma * ahead * T))
    base, turned = base_of(sigma, omega, T, wave)
    for name, weight in _parts(wave, omega * ahead * T):
        if base.angle == 0 and name == "sin":
            continue
        turn = turned if name == "sin" else sp.S.One
        for i in range(n + 1):
            factor = constant * turn * weight * comb(n, i) * T**n * ahead ** (n - i)
            yield Sample(factor, i, base, name if base.angle != 0 else "")


def _read(term: sp.Expr, t: sp.Symbol) -> tuple[sp.Expr, int, sp.Expr, Any, sp.Expr]:
    """c, n, σ, w (None: no wave), ω of a term c tⁿ e^{σt} w(ωt)."""
    constant, n, sigma, wave, omega = sp.S.One, 0, sp.S.Zero, None, sp.S.Zero
    parts: Sequence[Any] = sp.Mul.make_args(term)
    for each in parts:
        if not each.has(t):
            constant *= each
        elif each == t or (each.is_Pow and each.base == t and each.exp.is_Integer and each.exp > 0):
            n += int(each.as_base_exp()[1])
        elif isinstance(each, (sp.exp, *WAVES)) and (wave is None or isinstance(each, sp.exp)):
            slope = sp.expand(each.args[0]).coeff(t, 1)
            offset = sp.expand(each.args[0] - slope * t)
            if slope.has(t) or offset.has(t) or (offset != 0 and not isinstance(each, sp.exp)):
                raise NotExact("transforms/not_rational", part=term)
            if isinstance(each, sp.exp):
                sigma, constant = sigma + slope, constant * sp.exp(offset)
            else:
                wave, omega = each.func, slope
        else:
            raise NotExact("transforms/not_rational", part=term)
    return constant, n, sigma, wave, omega


def base_of(sigma: sp.Expr, omega: sp.Expr, T: sp.Expr, wave: Any = None) -> tuple[Base, sp.Expr]:
    """The base of e^{σkT} w(ωkT), and the sign that a sine gets as a function of the angle of the base."""
    sign, angle, turned = _turned(sp.expand(omega * T), wave)
    return Base(sign * sp.exp(sp.expand(sigma * T)), angle, wave in (sp.cosh, sp.sinh)), turned


def _turned(angle: sp.Expr, wave: Any) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """(±1, θ, sign) with cos kφ = (±1)ᵏ cos kθ and sin kφ = sign sin kθ for an angle φ.

    The same samples have the same θ; it is zero where the wave is sampled at its nodes: cos kπ = (−1)ᵏ.
    """
    if wave not in (sp.cos, sp.sin):
        return sp.S.One, angle, sp.S.One
    turns = angle / sp.pi
    if turns.is_Rational:
        turns = turns % 2
        sign = sp.S.NegativeOne if turns > 1 else sp.S.One
        turns = 2 - turns if turns > 1 else turns
        return (sp.S.NegativeOne, sp.S.Zero, sp.S.One) if turns == 1 else (sp.S.One, turns * sp.pi, sign)
    return (sp.S.One, -angle, sp.S.NegativeOne) if angle.could_extract_minus_sign() else (sp.S.One, angle, sp.S.One)


def _parts(wave: Any, phase: sp.Expr) -> list[tuple[str, sp.Expr]]:
    """w(x + φ) = Σ weight · cos x or sin x (hyperbolic as w is), by the addition theorem."""
    if wave is None:
        return [("", sp.S.One)]
    hyperbolic = wave in (sp.cosh, sp.sinh)
    c, s = (sp.cosh(phase), sp.sinh(phase)) if hyperbolic else (sp.cos(phase), sp.sin(phase))
    if wave in (sp.cos, sp.cosh):
        return [("cos", c), ("sin", s if hyperbolic else -s)]
    return [("sin", c), ("cos", s)]


def _group(base: Base, samples: Sequence[Sample]) -> tuple[int, Coefficients]:
    """The power m below, and the numerator over z, of the terms of one base."""
    m = 1 + max(each.power for each in samples)
    total: Coefficients = []
    for each in samples:
        own = _of_real(base.radius, each.power) if base.angle == 0 else _of_pair(base, each.power, each.wave)
        rest = powered(base.coefficients, m - 1 - each.power)
        total = added(total, multiplied([each.factor], multiplied(own, rest)))
    return m, total


def _of_real(a: sp.Expr, n: int) -> Coefficients:
    """The numerator over z of Z{kⁿ aᵏ} above (z − a)^{n+1}."""
    return [c * a**i for i, c in enumerate(_eulerian(n))]


def _eulerian(n: int) -> list[int]:
    """The coefficients of z^{n−i} aⁱ in the numerator over z of Z{kⁿ aᵏ}: 1; 0, 1; 0, 1, 1; 0, 1, 4, 1."""
    row = [1]
    for order in range(1, n + 1):
        longer = [0, *row]
        row = [0] + [i * (row[i] if i < len(row) else 0) + (order + 1 - i) * longer[i] for i in range(1, order + 1)]
    return row


def _of_pair(base: Base, n: int, wave: str) -> Coefficients:
    """The numerator over z of Z{kⁿ rᵏ w(θk)} above the quadratic's power n + 1: Re or Im of eₙ(z, a)(z − ā)^{n+1}."""
    found: list[sp.Expr] = [sp.S.Zero] * (2 * n + 2)
    for i, c in enumerate(_eulerian(n)):
        for j in range(n + 2):
            weight = c * comb(n + 1, j) * (-1) ** j
            found[i + j] += weight * base.radius ** (i + j) * _wave_at(base, i - j, wave)
    return trimmed(found)


def _wave_at(base: Base, n: int, wave: str) -> sp.Expr:
    """w(nθ)."""
    cosine, sine = base.waves
    value: sp.Expr = cosine(n * base.angle) if wave == "cos" else sine(n * base.angle)
    return value


def multiplied(p: Coefficients, q: Coefficients) -> Coefficients:
    """The product of two polynomials, its coefficients multiplied out."""
    found = [sp.S.Zero] * max(len(p) + len(q) - 1, 0)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            found[i + j] += a * b
    return [sp.expand(c, power_exp=False) for c in found]


def powered(p: Coefficients, m: int) -> Coefficients:
    """pᵐ."""
    found: Coefficients = [sp.S.One]
    for _ in range(m):
        found = multiplied(found, p)
    return found


def added(p: Coefficients, q: Coefficients) -> Coefficients:
    """The sum of two polynomials."""
    n = max(len(p), len(q))
    padded = [[sp.S.Zero] * (n - len(each)) + each for each in (p, q)]
    return [sp.expand(a + b, power_exp=False) for a, b in zip(*padded, strict=True)]


def trimmed(p: Coefficients) -> Coefficients:
    """The polynomial without leading zeros."""
    start = next((i for i, c in enumerate(p) if c != 0), len(p))
    return p[start:]


def in_z(p: Coefficients, z: sp.Symbol) -> sp.Expr:
    """The polynomial as an expression."""
    return sp.Add(*(c * z ** (len(p) - 1 - i) for i, c in enumerate(p)))
