"""Pulse transfer functions: what a sampler after a plant sees of a sequence that drives it, held or as impulses.

With a hold of order zero G(z) = (1 − z⁻¹) 𝒵{G(s)/s}, without one 𝒵{G(s)}. A dead time (l − μ)T, 0 ≤ μ < 1, is the
factor z⁻ˡ of what is sampled at (k + μ)T (Jury's modified z-transform; Franklin, Powell, Workman, Digital Control of
Dynamic Systems, §4.3).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import sympy as sp

from solver.exact.digital.fractions import FractionInZ
from solver.exact.functions.rational import fraction_of_term
from solver.exact.functions.transforms import transformed_fractions
from solver.exact.linear_algebra.signs import possible_signs
from solver.exact.transforms.images import RationalImage, rational_image
from solver.exact.transforms.sampled import Base, SampledImage, sampled_image

MOST = 50
"""So many periods a dead time may take."""
ONE = Base(sp.S.One)
ZERO = Base(sp.S.Zero)


@dataclass(frozen=True)
class SampledTerm:
    """A partial fraction of what is sampled, its function of time, and the transform of its samples."""

    fraction: sp.Expr
    function: sp.Expr
    sampled: SampledImage

    def image(self, z: sp.Symbol) -> sp.Expr:
        """The transform of the samples; zero where all of them are."""
        whole = FractionInZ.of(self.sampled.numerator, dict(self.sampled.factors))
        return whole.times_zero(ZERO).expression(z)


@dataclass(frozen=True)
class Pulse:
    """G(z) = z⁻ˡ 𝒵{f((k + μ)T)}, times 1 − z⁻¹ where a hold drives the plant; f has the image F.

    `late` is l, `ahead` is μ; `function` is f, `terms` its parts.
    """

    image: RationalImage
    function: sp.Expr
    terms: tuple[SampledTerm, ...]
    sampled: SampledImage
    late: int
    ahead: sp.Expr
    result: FractionInZ


@lru_cache(maxsize=32)
def pulse(G: sp.Expr, s: sp.Symbol, T: sp.Expr, *, held: bool, late: int = 0, ahead: sp.Expr = sp.S.Zero) -> Pulse:
    """The pulse transfer function of a rational G, for a period T; raises NotExact where its poles have no usable form.

    Without a hold G must be strictly proper.
    """
    t = sp.Symbol("t")
    image = rational_image(G / s if held else G, s)
    proper = image.proper
    assert proper is not None  # noqa: S101 - G is not zero, and strictly proper or divided by s
    terms = []
    for each in transformed_fractions(proper, s, t, discrete=False):
        function = sp.Add(*(f * C[0] for f, C in each.functions))
        terms.append(
            SampledTerm(fraction_of_term(each.fraction.stated), function, sampled_image(function, t, T, ahead))
        )
    function = proper.function(t, discrete=False).matrix[0]
    sampled = sampled_image(function, t, T, ahead)
    return Pulse(image, function, tuple(terms), sampled, late, ahead, _result(sampled, late, held=held))


def _result(sampled: SampledImage, late: int, *, held: bool) -> FractionInZ:
    """(z − 1) N/Π pᵢ z⁻ˡ of a held input, z N/Π pᵢ z⁻ˡ of impulses, in lowest terms."""
    if not sampled.samples:
        return FractionInZ((), ())
    found = FractionInZ.of(sampled.numerator, dict(sampled.factors))
    found = found.times_zero(ONE) if held else found.times_zero(ZERO)
    for _ in range(late):
        found = found.times_pole(ZERO)
    return found


def dead_time_in_periods(delay: sp.Expr, T: sp.Expr) -> tuple[int, sp.Expr] | None:
    """(l, μ) of a dead time (l − μ)T ≥ 0, 0 ≤ μ < 1; None where parameters leave l open."""
    for late in range(MOST + 1):
        signs = possible_signs(sp.expand(late * T - delay))
        if signs <= {0, 1}:
            return late, sp.cancel(late - delay / T)
        if 1 in signs:
            return None
    return None


def two_factors(G: sp.Expr, s: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """G as a product of two factors of order one, the constant in the second; None for any other G."""
    above, below = sp.fraction(sp.together(G))
    if above.has(s):
        return None
    constant, listed = sp.factor_list(below, s)
    roots = [p for p, m in listed for _ in range(m)]
    if len(roots) != 2 or any(sp.degree(p, s) != 1 for p in roots):
        return None
    first, second = sorted(roots, key=lambda p: (p != s, sp.default_sort_key(p)))
    return 1 / first, above / constant / second
