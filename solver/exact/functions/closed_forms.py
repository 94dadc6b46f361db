"""e^{At} and Aᵏ in closed form, from the residues of the resolvent.

A root λ of multiplicity m contributes Σ_j Z_j t^{j−1}/(j−1)! e^{λt}, in discrete time Σ_j Z_j C(k, j−1) λ^{k−j+1}.
A conjugate pair is added up to real form: with X = Re Z and Y = Im Z it gives 2e^{σt}(X cos ωt − Y sin ωt).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import factorial
from typing import Any

import sympy as sp

from solver.exact.functions.residues import (
    FactorResidues,
    Residue,
    interpolation_residues,
    multiply_by,
    resolvent_residues,
)
from solver.exact.linear_algebra.assembly import linear_combination
from solver.exact.linear_algebra.constants import common_factors_below
from solver.exact.linear_algebra.fields import (
    Algebraic,
    NotExact,
    collected,
    expressions,
    in_sines,
)
from solver.exact.linear_algebra.instances import parts_at, value_at
from solver.exact.linear_algebra.radicals import over_root
from solver.exact.linear_algebra.signs import is_positive
from solver.exact.linear_algebra.spectrum import DIGITS, Factor, Root, is_lower

Term = tuple[sp.Expr, list[sp.Expr]]
"""A function of time and the coefficient it has in each entry of the matrix, row by row."""

Form = Callable[[Factor, int, Residue, sp.Symbol], Iterator[Term]]
"""What a residue Z_j at the roots of a factor contributes."""


@dataclass(frozen=True)
class MatrixFunction:
    """A matrix whose entries are sums of coefficient times function of time."""

    shape: tuple[int, int]
    terms: tuple[Term, ...]

    @cached_property
    def matrix(self) -> sp.ImmutableMatrix:
        """The closed form."""
        rows, columns = self.shape
        functions = [function for function, _ in self.terms]
        by_entry = zip(*(coefficients for _, coefficients in self.terms), strict=True)
        entries = [
            linear_combination((c, f) for c, f in zip(coefficients, functions, strict=True) if c)
            for coefficients in by_entry
        ]
        return sp.ImmutableMatrix(rows, columns, entries)

    @property
    def functions(self) -> list[sp.Expr]:
        """The functions of time that occur."""
        return [function for function, coefficients in self.terms if any(coefficients)]


@lru_cache(maxsize=64)
def exponential(A: sp.ImmutableMatrix, t: sp.Symbol) -> MatrixFunction:
    """e^{At} (n×n) in closed form; raises NotExact where the spectrum has no usable form."""
    return closed_form(A.shape, resolvent_residues(A), t, discrete=False)


@lru_cache(maxsize=64)
def power(A: sp.ImmutableMatrix, k: sp.Symbol) -> MatrixFunction:
    """Aᵏ (n×n), k = 0, 1, …, in closed form; raises NotExact where the spectrum has no usable form."""
    return closed_form(A.shape, resolvent_residues(A), k, discrete=True)


@lru_cache(maxsize=64)
def interpolation_coefficients(A: sp.ImmutableMatrix, x: sp.Symbol, *, discrete: bool) -> tuple[sp.Expr, ...]:
    """α₀ … αₙ₋₁ with e^{At} = Σ αᵢ(t) Aⁱ (in discrete time Aᵏ = Σ αᵢ(k) Aⁱ)."""
    return tuple(closed_form((A.rows, 1), interpolation_residues(A), x, discrete=discrete).matrix.flat())


def closed_form(
    shape: tuple[int, int], residues: Iterable[FactorResidues], x: sp.Symbol, *, discrete: bool
) -> MatrixFunction:
    """The function of time with these residues; terms with the same function of time are added."""
    form: Form = _discrete if discrete else _continuous
    merged: dict[sp.Expr, list[sp.Expr]] = {}
    for each in residues:
        for j, Z in enumerate(each.residues, 1):
            for function, coefficients in form(each.factor, j, Z, x):
                known = merged.get(function)
                merged[function] = (
                    coefficients if known is None else [a + b for a, b in zip(known, coefficients, strict=True)]
                )
    return MatrixFunction(shape, tuple(merged.items()))


def _continuous(factor: Factor, j: int, Z: Residue, t: sp.Symbol) -> Iterator[Term]:
    """Z t^{j−1}/(j−1)! e^{λt}, summed over the roots λ of the factor."""
    weight = sp.Rational(1, factorial(j - 1))
    power_of_t = t ** (j - 1)
    for root, real, imaginary in _instances(factor, Z):
        envelope = power_of_t * _exponential(root.sigma, t)
        if imaginary is None:
            yield power_of_t * _exponential(root.value, t), _times(weight, real)
        elif root.kind == "symbolic":
            yield envelope * sp.cosh(root.shift * t), _times(2 * weight, real)
            yield envelope * sp.sinh(root.shift * t), _times(2 * weight, imaginary)
        else:
            yield envelope * sp.cos(root.shift * t), _times(2 * weight, real)
            yield envelope * sp.sin(root.shift * t), _times(-2 * weight, imaginary)


def _discrete(factor: Factor, j: int, Z: Residue, k: sp.Symbol) -> Iterator[Term]:
    """Z C(k, j−1) λ^{k−j+1}, summed over the roots λ of the factor; λ = 0 gives a pulse at k = j − 1."""
    if factor.degree == 1 and factor.roots[0].value == 0:
        yield sp.KroneckerDelta(k, j - 1), expressions(Z[0])
        return
    named = factor.degree == 1 and bool(factor.roots[0].value.free_symbols)  # k a^{k−1}, but k 2ᵏ/2
    if j > 1 and not named:
        Z = multiply_by(Z, _root_of(factor).inverse() ** (j - 1))
    binomial = sp.Poly(sp.expand(sp.ff(k, j - 1)) / factorial(j - 1), k)
    for root, real, imaginary in _instances(factor, Z):
        for (exponent,), c in binomial.terms():
            if imaginary is None and named:
                yield from _powers_of(root.value, k - j + 1, k**exponent, _times(c, real))
            elif imaginary is None:
                yield k**exponent * root.value**k, _times(c, real)
            else:
                r, theta = polar(root)
                yield k**exponent * r**k * sp.cos(theta * k), _times(2 * c, real)
                yield k**exponent * r**k * sp.sin(theta * k), _times(-2 * c, imaginary)


def _powers_of(base: sp.Expr, exponent: sp.Expr, other: sp.Expr, entries: list[sp.Expr]) -> Iterator[Term]:
    """The entries times a^{k−1}, a power of a in an entry taken into the exponent: a · a^{k−1} is a^k."""
    shifts = [entry.as_powers_dict().get(base, sp.S.Zero) for entry in entries]
    whole = [shift if shift.is_Integer else sp.S.Zero for shift in shifts]
    for shift in sorted({each for entry, each in zip(entries, whole, strict=True) if entry}):
        pairs = zip(entries, whole, strict=True)
        yield (
            other * base ** (exponent + shift),
            [entry / base**shift if each == shift else sp.S.Zero for entry, each in pairs],
        )


def _exponential(value: sp.Expr, t: sp.Symbol) -> sp.Expr:
    """e^{λt}; for a number λ ≠ 0 and a symbol t there is nothing that sympy could rewrite."""
    function: sp.Expr = sp.exp(value * t, evaluate=not (value.is_Number and value))
    return function


def _times(factor: sp.Expr, entries: list[sp.Expr]) -> list[sp.Expr]:
    return entries if factor == 1 else [_multiplied(factor, entry) for entry in entries]


def _multiplied(factor: sp.Expr, entry: Any) -> sp.Expr:
    """The product, with numbers below a line cancelled: 2 · a/(2 + 2w²) = a/(1 + w²)."""
    if entry.is_Add:
        return sp.Add(*(_multiplied(factor, term) for term in entry.args))
    number, others = factor, []
    parts: tuple[Any, ...] = sp.Mul.make_args(entry)
    for each in parts:
        if each.is_Pow and each.exp.is_Integer and each.base.is_Add:
            content, base = each.base.primitive()
            number *= content**each.exp
            others.append(base**each.exp)
        else:
            others.append(each)
    return sp.Mul(number, *others)


def _root_of(factor: Factor) -> Algebraic:
    """The root x of the factor as an element of L."""
    p = factor.modulus
    if p.degree == 1:
        return Algebraic([-p.low[0]], p)
    return Algebraic([p.domain.zero, p.domain.one, *[p.domain.zero] * (p.degree - 2)], p)


def polar(root: Root) -> tuple[sp.Expr, sp.Expr]:
    """Radius and angle (0 < θ < π for ω > 0) of a root σ + jω of a pair; raises NotExact if it may be real."""
    if root.kind == "symbolic":
        raise NotExact("functions/form_of_the_power")
    square = collected(root.sigma**2 + root.shift**2)
    r = sp.sqrt(square if square.free_symbols else in_sines(square))  # not square_root: ω of either sign has radius |ω|
    if root.kind == "decimal":
        return r, sp.atan2(root.shift, root.sigma).evalf(DIGITS)
    for cosine in root.sigma.atoms(sp.cos):
        sine = sp.sin(cosine.args[0])
        if sp.cancel(root.sigma - r * cosine) == 0 and sp.cancel(root.shift**2 - (r * sine) ** 2) == 0:
            return r, cosine.args[0] if sp.cancel(root.shift - r * sine) == 0 else -cosine.args[0]
    if is_positive(root.shift):
        return r, sp.acos(sp.radsimp(root.sigma / r))
    return r, sp.atan2(root.shift, root.sigma)  # the "upper" root is the lower one where a parameter is negative


def _instances(factor: Factor, Z: Residue) -> Iterator[tuple[Root, list[sp.Expr], list[sp.Expr] | None]]:
    """Z (over L) at the roots of its factor: (root, Re Z, Im Z) for a conjugate pair, (root, Z, None) for another root.

    A pair σ ± δ whose nature is undecided counts as a pair, Z = X ± Y, and is given as (upper root, X, Y).
    """
    parts = [expressions(M) for M in Z]
    first = factor.roots[0]
    if factor.degree == 1:
        yield first, [common_factors_below(entry) for entry in parts[0]], None
    elif factor.degree == 2 and first.kind != "surd":
        upper = first if first.kind == "complex" else factor.roots[1]
        constant, linear = parts
        real = [collected(a + b * upper.sigma) for a, b in zip(constant, linear, strict=True)]
        yield upper, real, [over_root(b * upper.shift) for b in linear]
    else:
        yield from _one_by_one(factor, parts)


def _one_by_one(
    factor: Factor, parts: list[list[sp.Expr]]
) -> Iterator[tuple[Root, list[sp.Expr], list[sp.Expr] | None]]:
    """The residue put together at each real root, and at the upper root of each pair."""
    entries = list(zip(*parts, strict=True))
    for root in factor.roots:
        paired = root.kind in ("complex", "decimal") and root.shift != 0
        if not paired:
            yield root, [value_at(coefficients, root) for coefficients in entries], None
        elif not is_lower(root):
            values = [parts_at(coefficients, root) for coefficients in entries]
            yield root, [real for real, _ in values], [imaginary for _, imaginary in values]
