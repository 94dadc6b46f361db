"""Images in z: F/z as a polynomial and a strictly proper rest, and powers of 1/z as delays of whole samples."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.spectrum import spectrum_of_polynomial
from solver.exact.transforms.images import RationalImage, lowest_terms, split_image

FEW, LONG, LONGEST = 2, 4, 60
"""So many powers of 1/z are delays by themselves; of more, only where the longest is at least `LONG`; the longest."""


@dataclass(frozen=True)
class SequenceImage:
    """F(z) (`fraction`), and F/z (`divided`), whose partial fractions get back their z for the table."""

    fraction: RationalImage
    divided: RationalImage

    @property
    def whole(self) -> sp.Expr:
        """F in lowest terms."""
        return self.fraction.whole

    @property
    def advanced(self) -> bool:
        """Whether the sequence begins before k = 0: the numerator is of a higher degree than the denominator."""
        return bool(self.divided.direct)

    def function(self, k: sp.Symbol) -> sp.Expr:
        """The sequence with this image for k ≥ 0; where there are unit pulses before, for all k."""
        if not self.advanced:
            return self.rest(k)
        pulses = [c * sp.KroneckerDelta(k, -i - 1) for i, c in enumerate(self.divided.direct) if c != 0]
        return sp.Add(self.rest(k) * sp.Heaviside(k, 1), *pulses)

    def rest(self, k: sp.Symbol) -> sp.Expr:
        """The sequence of z times the strictly proper rest of F/z."""
        proper = self.divided.proper
        return proper.function(k, discrete=True).matrix[0] if proper is not None else sp.S.Zero


@dataclass(frozen=True)
class DelayedSequenceImage:
    """A term F(z) z⁻ⁿ of an image."""

    delay: sp.Integer
    image: SequenceImage


def sequence_image(F: sp.Expr, z: sp.Symbol) -> SequenceImage:
    """F and F/z; raises NotExact where F is no quotient of polynomials in z."""
    try:
        N, D, cancels = lowest_terms(F, z)
    except NotExact as failure:
        raise NotExact("transforms/not_rational_in_z", part=F) from failure
    if N.is_zero:
        raise NotExact("transforms/zero_image")
    roots = spectrum_of_polynomial(D)
    whole = split_image(F, N, D, z, cancels=cancels, roots=roots)
    x = sp.Poly(z, z, domain=D.domain)
    if N.rem(x).is_zero:
        return SequenceImage(whole, split_image(whole.whole / z, N.quo(x), D, z, roots=roots))
    return SequenceImage(whole, split_image(whole.whole / z, N, D * x, z))


def is_in_inverse_powers(F: sp.Expr, z: sp.Symbol) -> bool:
    """Whether a denominator of F is given as a polynomial in 1/z."""
    sums = [each.base for each in F.atoms(sp.Pow) if each.exp.is_negative and each.base.is_Add]
    return any(_inverse_power(factor, z) for each in sums for term in each.args for factor in sp.Mul.make_args(term))


def _inverse_power(factor: Any, z: sp.Symbol) -> int:
    """n of z⁻ⁿ; 0 for any other factor."""
    base, exponent = factor.as_base_exp()
    return int(-exponent) if base == z and exponent.is_Integer and exponent < 0 else 0


def read_sequence_image(F: sp.Expr, z: sp.Symbol) -> tuple[DelayedSequenceImage, ...]:
    """The terms of F by their delays, the earliest first: a factor z⁻ⁿ shifts a sequence by n samples.

    Single powers of 1/z become delays where that leaves a simpler image. Raises NotExact for an F that is not rational.
    """
    whole = sequence_image(F, z)
    return _by_delays(F, z) or (_shifted(whole, z),)


def _by_delays(F: sp.Expr, z: sp.Symbol) -> tuple[DelayedSequenceImage, ...] | None:
    """The terms of a sum or product in which powers of 1/z stand as factors; None where that is of no use."""
    if not any(_inverse_power(each, z) for each in F.atoms(sp.Pow)):
        return None
    terms: dict[int, sp.Expr] = {}
    for term in sp.Add.make_args(F):
        for n, part in _terms_of(term, z):
            one = int(n > 0 and _relative_degree(part, z) > 0)
            terms[n + one] = terms.get(n + one, sp.S.Zero) + part * z**one
    useful = max(terms) > 1 and (len(terms) <= FEW or max(terms) >= LONG)
    if not useful or len(terms) < FEW or max(terms) > LONGEST:
        return None
    found = [(n, sequence_image(part, z)) for n, part in sorted(terms.items())]
    if any(image.advanced or not image.fraction.denominator.has(z) for _, image in found):
        return None
    return tuple(DelayedSequenceImage(sp.Integer(n), image) for n, image in found if image.fraction.numerator != 0)


def _relative_degree(F: sp.Expr, z: sp.Symbol) -> int:
    """By how much the denominator has the higher degree."""
    above, below = sp.fraction(sp.together(F))
    return int(sp.degree(below, z) - sp.degree(above, z)) if above.is_polynomial(z) and below.is_polynomial(z) else 0


def _terms_of(term: sp.Expr, z: sp.Symbol) -> Iterator[tuple[int, sp.Expr]]:
    """The delays of a product, with what they are multiplied by."""
    w = sp.Dummy("w")
    powers, rest = sp.S.One, sp.S.One
    factors: tuple[Any, ...] = sp.Mul.make_args(term)
    for each in factors:
        base, exponent = each.as_base_exp()
        inside = sp.expand(base).subs(z, 1 / w) if exponent.is_Integer and exponent > 0 else base
        if n := _inverse_power(each, z):
            powers *= w**n
        elif base.is_Add and base.has(z) and exponent.is_Integer and exponent > 0 and inside.is_polynomial(w):
            powers *= inside**exponent
        else:
            rest *= each
    for (n,), c in sp.Poly(sp.expand(powers), w).terms():
        yield n, c * rest


def _shifted(image: SequenceImage, z: sp.Symbol) -> DelayedSequenceImage:
    """F = z⁻ⁿ F₁ where a pole at zero of order two and more goes away; else F itself."""
    below = sp.Poly(image.fraction.denominator, z)
    order = min(n for (n,) in below.monoms())
    relative = below.degree() - int(sp.degree(image.fraction.numerator, z))
    n = min(relative, order + 1)
    if order <= 1 or n < order or below.degree() == order:
        return DelayedSequenceImage(sp.S.Zero, image)
    return DelayedSequenceImage(sp.Integer(n), sequence_image(sp.cancel(image.whole * z**n), z))
