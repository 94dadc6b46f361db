"""The limit of a response and how long it takes, from the residues of its transform."""

from __future__ import annotations

import cmath
from collections.abc import Sequence

import mpmath
import sympy as sp

from solver.exact.functions.fractions import residue_at
from solver.exact.functions.rational import RationalMatrix
from solver.exact.linear_algebra.fields import expression
from solver.exact.linear_algebra.signs import is_positive
from solver.exact.linear_algebra.spectrum import Factor


def decays(factor: Factor, *, discrete: bool) -> bool:
    """Whether the modes of a factor are known to die out."""
    if factor.degree == 1:
        value = factor.roots[0].value
        return is_positive(1 - sp.Abs(value)) if discrete else is_positive(-value)
    if factor.degree == 2:
        K = factor.modulus.domain
        c0, c1 = (expression(K, c) for c in factor.modulus.low)
        conditions = (1 + c1 + c0, 1 - c1 + c0, 1 - c0) if discrete else (c0, c1)
        return all(map(is_positive, conditions))
    if discrete:
        return all(is_positive(sp.expand(1 - root.sigma**2 - root.shift**2)) for root in factor.roots)
    return all(is_positive(-(root.value if root.kind == "surd" else root.sigma)) for root in factor.roots)


def constant_root(factor: Factor, *, discrete: bool) -> bool:
    """Whether the mode of a factor is a constant."""
    return factor.degree == 1 and bool(factor.roots[0].value == (1 if discrete else 0))


def limit(image: RationalMatrix, *, discrete: bool) -> sp.ImmutableMatrix | None:
    """The limit of the function with an image (in discrete time divided by z); None where none is known to exist."""
    total = sp.zeros(*image.shape)
    for each, order in image.poles:
        if decays(each.factor, discrete=discrete):
            continue
        if not constant_root(each.factor, discrete=discrete) or order > 1:
            return None
        total += residue_at(each.residues[0], each.factor.roots[0], image.shape)
    return sp.ImmutableMatrix(total)


def slowest(image: RationalMatrix, *, discrete: bool) -> float | None:
    """The time constant of the slowest mode that dies out (in samples); None if there is none, or with parameters."""
    rates = []
    for each, _ in image.poles:
        for root in each.factor.roots:
            if root.value.free_symbols:
                return None
            value = complex(root.value)
            rate = -mpmath.log(abs(value)) if discrete else -value.real
            if rate > 1e-12 and not (discrete and not value):
                rates.append(float(rate))
    return 1 / min(rates) if rates else None


def horizon(images: Sequence[RationalMatrix], *, discrete: bool) -> sp.Expr | None:
    """A time up to which a plot shows what happens; None with parameters."""
    values = [root.value for image in images for each, _ in image.poles for root in each.factor.roots]
    if any(value.free_symbols for value in values):
        return None
    numbers = [complex(value) for value in values]
    if discrete:
        radii = [abs(value) for value in numbers if 0 < abs(value) < 1 - 1e-9]
        return sp.Integer(min(40, max([8, *(int(5 / -cmath.log(r).real) for r in radii)])))
    growing = [value.real for value in numbers if value.real > 1e-9]
    if growing:
        return sp.Rational(round(300 / max(growing)), 100)
    decaying = [-value.real for value in numbers if value.real < -1e-9]
    turning = [abs(value.imag) for value in numbers if abs(value.imag) > 1e-9 and value.real > -1e-9]
    spans = [*([6 / min(decaying)] if decaying else []), *([4 * cmath.pi / min(turning)] if turning else [])]
    return sp.Rational(max(1, round(100 * max(spans))), 100) if spans else sp.Integer(5)
