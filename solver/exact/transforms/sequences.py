"""z-transforms of sequences by a short table and rules: powers of k, factors aᵏ, delays. Read as `signals` does."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.time_response.signals import Signal, in_order, read_signal, written
from solver.exact.transforms.rules import Pair, TransformedTerm, TransformPiece
from solver.exact.transforms.sampled import SampledImage

MOST_IN_THE_TABLE = 2
"""The highest power of k in the table."""

MOST_VALUES = 12
"""So many values of a sequence that ends are written out."""


@dataclass(frozen=True)
class _Image:
    """N/qᵐ with q monic, of degree one or two."""

    above: sp.Expr
    base: sp.Expr
    power: int

    def expression(self, *, factored: bool = False) -> sp.Expr:
        above = sp.factor(self.above) if factored else self.above
        return above / self.base**self.power

    def multiplied(self, z: sp.Symbol) -> _Image:
        """The image of k g(k), −z dG/dz."""
        slope = sp.diff(self.above, z) * self.base - self.power * self.above * sp.diff(self.base, z)
        return _Image(sp.expand(-z * slope), self.base, self.power + 1)

    def damped(self, a: sp.Expr, z: sp.Symbol) -> _Image:
        """The image of aᵏ g(k), G(z/a), multiplied through by powers of a."""
        degree = int(sp.degree(self.base, z))
        return _Image(_scaled(self.above, degree * self.power, a, z), _scaled(self.base, degree, a, z), self.power)


def _scaled(polynomial: sp.Expr, degree: int, a: sp.Expr, z: sp.Symbol) -> sp.Expr:
    """aⁿ p(z/a), the lowest power of z in front."""
    terms = sp.Poly(sp.expand(polynomial), z).terms()
    least = min(i for (i,), _ in terms)
    return z**least * sp.Add(*(c * a ** (degree - i) * z ** (i - least) for (i,), c in terms))


@dataclass(frozen=True)
class SequenceTerm(TransformedTerm):
    """A term `factor` · kⁿ aᵏ w(θk), a = `growth`, w one of `WAVES` or none ("")."""

    def function(self, k: sp.Symbol) -> sp.Expr:
        """The sequence without its factor."""
        return k**self.power * self.growth**k * self._wave(k)

    @property
    def entry(self) -> str:
        """The line of the table that the term begins with."""
        if self.wave:
            return self.wave
        if self.power:
            return "square" if self.power > 1 else "power"
        return "exponential" if self.growth != 1 else "constant"

    def pairs(self, k: sp.Symbol, z: sp.Symbol) -> tuple[Pair, ...]:
        """The pair of the table, and what each rule makes of it: −z d/dz for each further k, then G(z/a) for aᵏ."""
        if not (self.wave or self.power):
            return (Pair("table", self.growth**k, z / (z - self.growth)),)
        if self.wave:
            cosine, sine = (sp.cos, sp.sin) if self.wave in ("cos", "sin") else (sp.cosh, sp.sinh)
            c, s = cosine(self.angle), sine(self.angle)
            above = z * (z - c) if self.wave in ("cos", "cosh") else z * s
            image, have = _Image(above, z**2 - 2 * c * z + 1, 1), 0
        else:
            have = min(self.power, MOST_IN_THE_TABLE)
            image = _Image(z if have == 1 else z * (z + 1), z - 1, have + 1)
        found = [Pair("table", k**have * self._wave(k), image.expression())]
        for power in range(have + 1, self.power + 1):
            image = image.multiplied(z)
            found.append(Pair("derivative", k**power * self._wave(k), image.expression(factored=True)))
        if self.growth != 1:
            image = image.damped(self.growth, z)
            factored = not self.growth.has(sp.exp)
            found.append(Pair("damping", self.function(k), image.expression(factored=factored)))
        return tuple(found)

    def abscissa(self) -> sp.Expr:
        """The absolute value that z must exceed for the series to converge."""
        return sp.Abs(self.growth)


def terms_of_samples(image: SampledImage) -> tuple[SequenceTerm, ...]:
    """The terms of a sampled function as the table has them."""
    found = []
    for each in image.samples:
        wave = each.wave + ("h" if each.wave and each.base.hyperbolic else "")
        found.append(SequenceTerm(each.factor, each.power, each.base.radius, each.base.angle, wave))
    return tuple(found)


def sequence_pieces(f: sp.Expr, k: sp.Symbol) -> tuple[TransformPiece, ...]:
    """The pieces of a sequence, the earliest first, a unit pulse as an `impulse`.

    Raises NotExact for a sequence whose transform is not rational.
    """
    signal = read_signal(f, k, discrete=True)
    delays = in_order(signal.delays) or signal.delays
    pieces = (_piece(signal, delay, k) for delay in delays)
    return tuple(each for each in pieces if each.terms or each.impulse != 0)


def _piece(signal: Signal, delay: sp.Expr, k: sp.Symbol) -> TransformPiece:
    here = sp.Add(*(c * written(term, k, discrete=True) for (begin, term), c in signal.terms.items() if begin == delay))
    local = here if delay == 0 else here.subs(k, k + delay)
    terms: list[TransformedTerm] = []
    for (_, (n, growth, angle, sine)), c in read_signal(local, k, discrete=True).terms.items():
        wave = "" if angle == 0 else "sin" if sine else "cos"
        terms.append(SequenceTerm(c, n, growth, angle, wave))
    moved = sp.Add(*(each.factor * each.function(k) for each in terms))
    pulse: sp.Expr = signal.impulses.get(delay, sp.S.Zero)
    return TransformPiece(delay, here, moved, pulse, tuple(terms))


def sequence_transform(pieces: Sequence[TransformPiece], k: sp.Symbol, z: sp.Symbol) -> sp.Expr:
    """Σ z^{−n} times the image of each piece."""
    return sp.Add(*(moved_image(each.delay, each.image(k, z), z) for each in pieces))


def moved_image(delay: sp.Expr, image: sp.Expr, z: sp.Symbol) -> sp.Expr:
    """The image times z^{−n}, cancelled where it is one fraction."""
    if delay == 0:
        return image
    if image.is_Add:
        terms: tuple[Any, ...] = image.args
        return sp.Add(*(moved_image(delay, term, z) for term in terms))
    found: Any = image * z**-delay
    return found


def radius_of(pieces: Sequence[TransformPiece]) -> sp.Expr | None:
    """The absolute value of z beyond which the series converges; None where it does for every z ≠ 0."""
    found = [term.abscissa() for piece in pieces for term in piece.terms]
    return sp.Max(*found) if found else None


def finite_values(f: sp.Expr, k: sp.Symbol) -> tuple[sp.Expr, ...] | None:
    """The values f(0), f(1), … of a sequence that is zero after few of them, steps in it; None for any other."""
    signal = read_signal(f, k, discrete=True)
    last = max(signal.delays, default=sp.S.Zero)
    whole = sp.Add(*(c * written(term, k, discrete=True) for (_, term), c in signal.terms.items()))
    if not signal.terms or sp.expand(whole) != 0 or last > MOST_VALUES:
        return None
    values = []
    for at in range(int(last) + 1):
        begun = (c * written(term, k, discrete=True) for (begin, term), c in signal.terms.items() if begin <= at)
        values.append(sp.expand(sp.Add(*begun).subs(k, at)) + signal.impulses.get(sp.Integer(at), sp.S.Zero))
    return tuple(values)


def value_of_pieces(pieces: Sequence[TransformPiece], k: sp.Symbol, at: int) -> sp.Expr:
    """The value of a sequence at a sample k ≥ 0."""
    begun = [each.function.subs(k, at) for each in pieces if each.delay <= at]
    found: sp.Expr = sp.expand(sp.Add(*begun, *(each.impulse for each in pieces if each.delay == at)))
    return found
