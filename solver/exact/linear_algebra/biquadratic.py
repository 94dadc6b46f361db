"""Roots of irreducible polynomials x⁴ + bx² + c, and numbers with square roots beside parameters in one form."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.radicals import is_negative, square_root
from solver.exact.linear_algebra.signs import is_positive

LARGEST = 999
"""The largest whole number in a root that is still written with square roots."""


@dataclass(frozen=True)
class Location:
    """A root σ + δ (`real`), or the roots σ ± jω of a pair: `shift` is δ or ω."""

    real: bool
    sigma: sp.Expr
    shift: sp.Expr


def has_rational_coefficients(K: Any) -> bool:
    """Whether K is the field of rational numbers or of rational functions of parameters, no half-angle tangents."""
    if K.is_QQ:
        return True
    rational = K.is_FractionField and (K.domain.is_ZZ or K.domain.is_QQ)
    return bool(rational and all(generator.is_Symbol for generator in K.symbols))


def biquadratic_roots(b: sp.Expr, c: sp.Expr) -> list[Location] | None:
    """The roots of x⁴ + bx² + c: real ones ascending, then a location for each pair; None if they have no short form.

    x² = −b/2 ± √(b² − 4c)/2 where that is real; otherwise, with r = √c, x = ±√(2r − b)/2 ± j√(2r + b)/2. What
    parameters leave undecided has no form, and neither have roots of sums with parameters.
    """
    radicand = sp.factor(b**2 - 4 * c)
    negative = is_negative(radicand)
    if negative is None:
        return None
    found = _two_pairs(b, c) if negative else _by_squares(b, square_root(radicand))
    return found if found is not None and all(map(_short, found)) else None


def _by_squares(b: sp.Expr, root: sp.Expr) -> list[Location] | None:
    """The roots of the two real values of x²."""
    real: list[Location] = []
    pairs: list[Location] = []
    for sign in (1, -1):
        square = tidied((sign * root - b) / 2)
        negative = is_negative(square)
        if negative is None:
            return None
        shift = root_of_product(-square if negative else square)
        if negative:
            pairs.append(Location(real=False, sigma=sp.S.Zero, shift=shift))
        else:
            real += [Location(real=True, sigma=sp.S.Zero, shift=each) for each in (-shift, shift)]
    return [*sorted(real, key=lambda each: sp.N(each.shift) if each.shift.is_number else 0), *pairs]


def _two_pairs(b: sp.Expr, c: sp.Expr) -> list[Location] | None:
    """The roots of (x² + r)² − (2r − b) x² where c = r²."""
    r = square_root(c)
    if any(each.exp == sp.S.Half for each in r.atoms(sp.Pow)) or not is_positive(r):
        return None
    sigma, omega = (root_of_product(sp.factor(2 * r + sign * b)) / 2 for sign in (-1, 1))
    return [Location(real=False, sigma=sign * sigma, shift=omega) for sign in (-1, 1)]


def _short(found: Location) -> bool:
    """Whether no whole number is large, and no root is one of a sum: with parameters of a sum of numbers it may be.

    A fourth root stands alone.
    """
    roots = [each for each in (found.sigma, found.shift) if each != 0]
    sums = [
        power.base for each in roots for power in each.atoms(sp.Pow) if power.exp == sp.S.Half and power.has(sp.Add)
    ]
    if any(base.free_symbols for base in sums) or (sums and not found.shift.free_symbols):
        return False
    if any(
        power.exp.is_Rational and power.exp.q > 2 for each in roots if each.has(sp.Add) for power in each.atoms(sp.Pow)
    ):
        return False
    return all(abs(n.p) <= LARGEST and n.q <= LARGEST for each in roots for n in each.atoms(sp.Rational))


def root_of_product(square: sp.Expr) -> sp.Expr:
    """√ of a number times a rational function, nested roots taken apart: √((3 − √5)/2) = (√5 − 1)/2."""
    number, rest = square.as_independent(*square.free_symbols, as_Add=False)
    return sp.expand(sp.sqrtdenest(sp.sqrt(sp.expand(number)))) * square_root(rest)


def tidied(value: sp.Expr) -> sp.Expr:
    """A sum of rational functions times square roots of numbers: one number before one product where it can be."""
    expanded = sp.expand(value)
    symbols = expanded.free_symbols
    if not symbols:
        return expanded
    by_root: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(expanded):
        number, rest = term.as_independent(*symbols, as_Add=False)
        rational, irrational = number.as_coeff_Mul()
        by_root[irrational] = by_root.get(irrational, sp.S.Zero) + rational * rest
    parts = {root: sp.factor(part) for root, part in by_root.items()}
    parts = {root: part for root, part in parts.items() if part != 0}
    if not parts:
        return sp.S.Zero
    first, *_ = parts.values()
    ratios = {root: sp.cancel(part / first) for root, part in parts.items()}
    if all(ratio.is_Rational for ratio in ratios.values()):
        number, rest = first.as_coeff_Mul()
        return sp.Mul(sp.expand(number * sp.Add(*(ratio * root for root, ratio in ratios.items()))), rest)
    return sp.Add(*(root * part for root, part in parts.items()))


def multiplied(left: sp.Expr, right: sp.Expr) -> sp.Expr:
    """The product of two such values, their numbers multiplied out."""
    symbols = left.free_symbols | right.free_symbols
    if not symbols:
        return sp.expand(left * right)
    (a, p), (b, q) = (each.as_independent(*symbols, as_Add=False) for each in (left, right))
    return sp.expand(a * b) * p * q


def powers_at(coefficients: Any, sigma: sp.Expr, omega: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part of Σ cᵢ xⁱ at x = σ + jω whose square y is simple: (c₀ + c₂y + …) + (c₁ + c₃y + …) x."""
    y, z = tidied(sigma**2 - omega**2), tidied(2 * sigma * omega)
    even, odd = (_polynomial(coefficients[start::2], y, z) for start in (0, 1))
    real = [even[0], multiplied(odd[0], sigma), -multiplied(odd[1], omega)]
    imaginary = [even[1], multiplied(odd[0], omega), multiplied(odd[1], sigma)]
    return _added(real), _added(imaginary)


def _polynomial(coefficients: Any, y: sp.Expr, z: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part of Σ cᵢ (y + jz)ⁱ."""
    real: sp.Expr = sp.S.Zero
    imaginary: sp.Expr = sp.S.Zero
    for c in reversed(coefficients):
        real, imaginary = tidied(real * y - imaginary * z + c), tidied(real * z + imaginary * y)
    return real, imaginary


def _added(terms: list[sp.Expr]) -> sp.Expr:
    """A sum; tidied where more than one term is left."""
    left = [term for term in terms if term != 0]
    return left[0] if len(left) == 1 else tidied(sp.Add(*left))
