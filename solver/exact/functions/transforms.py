"""The resolvent (xI − A)⁻¹, its partial fractions, and the transform pairs that partial fractions need."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.functions.closed_forms import closed_form, polar
from solver.exact.functions.fractions import (
    Fraction,
    fractions_of,
    is_simple_pair,
    keeps_quadratic,
    real_quadratic,
    upper_root,
)
from solver.exact.functions.rational import RationalMatrix, cancelled, resolvent_matrix, written_out
from solver.exact.functions.residues import residues_at
from solver.exact.linear_algebra.faddeev import faddeev_leverrier
from solver.exact.linear_algebra.fields import Modulus, collected
from solver.exact.linear_algebra.radicals import over_root
from solver.exact.linear_algebra.spectrum import Factor, Root, irreducible_factors, is_lower
from solver.matrices import entries
from solver.stated import Stated


@lru_cache(maxsize=16)
def resolvent(A: sp.ImmutableMatrix, x: sp.Symbol) -> sp.ImmutableMatrix:
    """(xI − A)⁻¹ (n×n): entries in lowest terms, denominators as products of the irreducible factors of χ."""
    K = faddeev_leverrier(A).domain
    return sp.ImmutableMatrix(A.rows, A.rows, [written_out(rest, left, K, x) for rest, left in _cancelled(A)])


def resolvent_cancels(A: sp.ImmutableMatrix) -> bool:
    """Whether an entry of (xI − A)⁻¹ that is not zero has a factor in common with χ."""
    factors = _factors_of(A)
    return any(rest and below != factors for rest, below in _cancelled(A))


@lru_cache(maxsize=16)
def _cancelled(A: sp.ImmutableMatrix) -> list[tuple[list[Any], list[tuple[Modulus, int]]]]:
    """What is left above and below of the entries of (xI − A)⁻¹, row by row."""
    factors = _factors_of(A)
    numerators = zip(*(N.to_list_flat() for N in faddeev_leverrier(A).N), strict=True)  # the highest power first
    return [cancelled(entry, factors) for entry in numerators]


def _factors_of(A: sp.ImmutableMatrix) -> list[tuple[Modulus, int]]:
    """The irreducible factors of χ with their multiplicities."""
    K = faddeev_leverrier(A).domain
    return [(Modulus(tuple(reversed(p.rep.to_list()[1:])), K), power) for p, power in irreducible_factors(A)]


def partial_fractions(A: sp.ImmutableMatrix, x: sp.Symbol) -> list[Stated]:
    """The terms of (xI − A)⁻¹ = Σ (1/p(x)ʲ) R_j(x), see `RationalMatrix.partial_fractions`."""
    return resolvent_matrix(A).partial_fractions(x)


def transform_pairs(
    A: sp.ImmutableMatrix, x: sp.Symbol, time: sp.Symbol, *, discrete: bool
) -> list[tuple[sp.Expr, sp.Expr]]:
    """The pairs for the partial fractions of (xI − A)⁻¹; in discrete time the images carry the factor z."""
    return pairs_for(resolvent_matrix(A), x, time, discrete=discrete)


@dataclass(frozen=True)
class Denominators:
    """What the partial fractions of an image have below: (x − λ)ʲ, and quadratics p = (x − σ)² + ω² as (p, σ, ω)."""

    simple: bool
    repeated: bool
    quadratics: tuple[tuple[sp.Expr, sp.Expr, sp.Expr], ...]
    alone: bool

    @property
    def named(self) -> dict[str, Any]:
        """What the wording of partial fractions asks."""
        return {
            "simple": self.simple,
            "repeated": self.repeated,
            "quadratic": bool(self.quadratics),
            "alone": self.alone,
        }

    @classmethod
    def of(cls, image: RationalMatrix, x: sp.Symbol) -> Denominators:
        """Those of the factors that do not cancel; `alone`: there is one quadratic and nothing else."""
        simple = repeated = False
        quadratics = []
        for each, highest in image.poles:
            first = each.factor.roots[0]
            if keeps_quadratic(each.factor):
                if first.kind == "complex":
                    quadratics.append((each.factor.polynomial(x), first.sigma, first.shift))
                continue
            pairs = [root for root in each.factor.roots if is_simple_pair(root)]
            quadratics += [(real_quadratic(root, x), root.sigma, root.shift) for root in pairs if not is_lower(root)]
            simple, repeated = simple or len(pairs) < len(each.factor.roots), repeated or highest > 1
        alone = len(image.poles) == 1 and keeps_quadratic(image.poles[0][0].factor) and image.poles[0][1] == 1
        return cls(simple, repeated, tuple(quadratics), alone)


def pairs_for(image: RationalMatrix, x: sp.Symbol, time: sp.Symbol, *, discrete: bool) -> list[tuple[sp.Expr, sp.Expr]]:
    """Pairs (image, function of time) for partial fractions; in discrete time the images carry the factor z.

    Those of fractions with the numerator zero are left out.
    """
    pairs: list[tuple[sp.Expr, sp.Expr]] = []
    for each, highest in image.poles:
        for j in range(1, highest + 1):
            of_factor = _quadratic_pairs if keeps_quadratic(each.factor) else _linear_pairs
            pairs += of_factor(each.factor, j, x, time, discrete=discrete)
    terms = [term for each in transformed_fractions(image, x, time, discrete=discrete) for term in each.functions]
    occurring = {function for function, coefficients in terms if any(entries(coefficients))}
    used = [(left, function) for left, function in pairs if function in occurring]
    return used if len(used) == len(occurring) else pairs


@dataclass(frozen=True)
class Transformed:
    """A partial fraction and the functions of time that it gives, each with its matrix of coefficients.

    Of a numerator βx + γ over a quadratic they are β and (γ + σβ)/`scale`.
    """

    fraction: Fraction
    functions: tuple[tuple[sp.Expr, sp.ImmutableMatrix], ...]
    scale: sp.Expr = sp.S.One


def transformed_fractions(image: RationalMatrix, x: sp.Symbol, time: sp.Symbol, *, discrete: bool) -> list[Transformed]:
    """The partial fractions transformed back one by one; in discrete time the images carry the factor z."""
    found = []
    for each in fractions_of(image, x):
        if each.slope is None:
            _, function = _of_root(each.root, each.power, x, time, discrete=discrete)
            found.append(Transformed(each, ((function, each.constant),)))
        else:
            found.append(_split(each, each.slope, x, time, discrete=discrete))
    return found


def _split(each: Fraction, beta: sp.ImmutableMatrix, x: sp.Symbol, time: sp.Symbol, *, discrete: bool) -> Transformed:
    if keeps_quadratic(each.factor):
        (_, cosine), (_, sine) = _quadratic_pairs(each.factor, each.power, x, time, discrete=discrete)
    else:
        (_, cosine), (_, sine) = _of_pair(each.root, x, time, discrete=discrete)
    scale = each.root.shift if each.power == 1 else sp.Integer(1)
    rest = (each.constant + each.root.sigma * beta).applyfunc(lambda entry: _over(entry, scale))
    return Transformed(each, ((cosine, beta), (sine, sp.ImmutableMatrix(rest))), scale)


def _over(entry: sp.Expr, scale: sp.Expr) -> sp.Expr:
    """entry/scale, where the scale may be a root of what holds parameters."""
    if not scale.free_symbols:
        return collected(sp.expand(entry) / scale)
    return over_root(sp.factor(entry / sp.expand(scale**2)) * scale)


def _quadratic_pairs(
    factor: Factor, j: int, x: sp.Symbol, time: sp.Symbol, *, discrete: bool
) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """The pairs of (x − σ)/pʲ and of ω/p or 1/pʲ."""
    K, low = factor.modulus.domain, factor.modulus.low
    p, root = factor.polynomial(x), upper_root(factor)
    carried = x if discrete else sp.Integer(1)
    scale = root.shift if j == 1 else sp.Integer(1)
    yield carried * (x - root.sigma) / p**j, _scalar(factor, j, [low[1] / 2, K.one], time, discrete=discrete)
    sine = _scalar(factor, j, [K.one], time, discrete=discrete)
    yield carried * scale / p**j, collected(scale * sine) if j == 1 and not scale.free_symbols else scale * sine


def _linear_pairs(
    factor: Factor, j: int, x: sp.Symbol, time: sp.Symbol, *, discrete: bool
) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """The pairs of 1/(x − λ)ʲ; of a simple pair, those of its real quadratic."""
    for root in factor.roots:
        if not is_simple_pair(root):
            yield _of_root(root, j, x, time, discrete=discrete)
        elif not is_lower(root):
            yield from _of_pair(root, x, time, discrete=discrete)


def _of_root(root: Root, j: int, x: sp.Symbol, time: sp.Symbol, *, discrete: bool) -> tuple[sp.Expr, sp.Expr]:
    if discrete and root.value == 0:
        return x ** (1 - j), sp.KroneckerDelta(time, j - 1)
    if discrete:
        binomial = sp.expand(sp.ff(time, j - 1)) / sp.factorial(j - 1)
        return x / (x - root.value) ** j, binomial * root.value ** (time - j + 1)
    mode = sp.exp(root.value * time)
    return 1 / (x - root.value) ** j, time ** (j - 1) / sp.factorial(j - 1) * mode if j > 1 else mode


def _of_pair(root: Root, x: sp.Symbol, time: sp.Symbol, *, discrete: bool) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    if discrete:
        r, theta = polar(root)
        envelope, angle = r**time, theta * time
    else:
        envelope, angle = sp.exp(root.sigma * time), root.shift * time
    carried, p = x if discrete else sp.Integer(1), real_quadratic(root, x)
    yield carried * (x - root.sigma) / p, envelope * sp.cos(angle)
    yield carried * root.shift / p, envelope * sp.sin(angle)


def _scalar(factor: Factor, j: int, numerator: list[Any], time: sp.Symbol, *, discrete: bool) -> sp.Expr:
    """The function of time with the image numerator/pʲ (times z in discrete time)."""
    K = factor.modulus.domain
    p = sp.Poly([K.one, *reversed(factor.modulus.low)], sp.Dummy("x"), domain=K)
    alone = Factor(factor.modulus, j, factor.roots)
    coefficients = [DomainMatrix([[c]], (1, 1), K) for c in numerator]
    residues = residues_at(coefficients, (p**j).rep.to_list()[::-1], alone)
    return closed_form((1, 1), [residues], time, discrete=discrete).matrix[0]
