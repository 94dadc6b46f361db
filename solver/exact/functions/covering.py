"""Coefficients of partial fractions as they are found by hand: a pole covered up, coefficients compared."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import sympy as sp

from solver.exact.functions.fractions import Fraction, fractions_of, is_simple_pair, real_quadratic
from solver.exact.functions.rational import RationalMatrix, cancelled, in_lowest_terms
from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.fields import in_powers
from solver.exact.linear_algebra.spectrum import Factor, Root, is_lower


@dataclass(frozen=True)
class Covered:
    """What is left of a matrix F of rational functions where the factor of a pole λ of order m is covered up.

    `functions` are G(x) = (x − λ)ᵐ F(x) and its first m − 1 derivatives; `coefficients` are those of 1/(x − λ)ᵐ, …,
    1/(x − λ): the values of G, G′, G″/2!, … at λ. Of a simple pole an entry that does not have it is zero in G.
    """

    pole: sp.Expr
    functions: tuple[sp.ImmutableMatrix, ...]
    coefficients: tuple[sp.ImmutableMatrix, ...]

    @property
    def order(self) -> int:
        """The order m of the pole."""
        return len(self.functions)


@dataclass(frozen=True)
class Compared:
    """Numerator βx + γ over the one quadratic p, where all other coefficients are known, by comparing coefficients.

    Multiplied by the common denominator d of degree n, F = Σ R/(x − λ)ʲ + (βx + γ)/p is N = Σ R d/(x − λ)ʲ + (βx + γ) q
    with q = d/p. `others` are the pairs (R, d/(x − λ)ʲ); `equations` has, for the powers n − 1 and n − 2 of x, the
    coefficient of N, the pairs (R, coefficient of d/(x − λ)ʲ), and the coefficient of q that β has.
    """

    fraction: Fraction
    numerator: sp.ImmutableMatrix
    cofactor: sp.Expr
    others: tuple[tuple[sp.ImmutableMatrix, sp.Expr], ...]
    equations: tuple[tuple[sp.ImmutableMatrix, tuple[tuple[sp.ImmutableMatrix, sp.Expr], ...], sp.Expr], ...]
    degree: int


def covered(image: RationalMatrix, x: sp.Symbol) -> list[Covered]:
    """What is left for each pole with fractions of its own, in the order of the partial fractions."""
    found: dict[sp.Expr, list[Fraction]] = {}
    for each in fractions_of(image, x):
        if each.slope is None:
            found.setdefault(each.root.value, []).append(each)
    return [_covered(image, fractions, x) for fractions in found.values()]


def _covered(image: RationalMatrix, fractions: Sequence[Fraction], x: sp.Symbol) -> Covered:
    order, factor, root = max(each.power for each in fractions), fractions[0].factor, fractions[0].root
    entries = [_covered_entry(entry, image, factor, root, order, x) for entry in _numerators(image)]
    functions = [sp.ImmutableMatrix(*image.shape, entries)]
    for _ in range(order - 1):
        functions.append(functions[-1].applyfunc(lambda entry: slope_of_quotient(entry, x)))
    by_power = {each.power: each.constant for each in fractions}
    nothing = sp.ImmutableMatrix(sp.zeros(*image.shape))
    coefficients = tuple(by_power.get(j, nothing) for j in range(order, 0, -1))
    return Covered(root.value, tuple(functions), coefficients)


def _numerators(image: RationalMatrix) -> list[list[Any]]:
    """The entries of the numerator, row by row, as coefficients over K, the highest power first."""
    return [list(entry) for entry in zip(*(C.to_list_flat() for C in reversed(image.numerator)), strict=True)]


@dataclass(frozen=True)
class AtUpperRoot:
    """A numerator βx + γ over a quadratic p from its value at the upper root σ + jω, where it is what is left of F.

    `function` is p(x) F(x), `value` its value at the root.
    """

    fraction: Fraction
    function: sp.ImmutableMatrix
    value: sp.ImmutableMatrix


def at_upper_roots(image: RationalMatrix, x: sp.Symbol) -> list[AtUpperRoot]:
    """The numerators of several quadratics, each to the power one with roots that are complex numbers; else none."""
    quadratics = [each for each in fractions_of(image, x) if each.slope is not None]
    fit = all(each.power == 1 and each.root.kind == "complex" for each in quadratics)
    if len(quadratics) < 2 or not fit or any(each.base.free_symbols - {x} for each in quadratics):
        return []
    return [_at_upper_root(image, each, x) for each in quadratics]


def _at_upper_root(image: RationalMatrix, fraction: Fraction, x: sp.Symbol) -> AtUpperRoot:
    factor, root = fraction.factor, fraction.root
    lower = next(each for each in factor.roots if each.sigma == root.sigma and each.shift == -root.shift)
    entries = [_covered_entry(entry, image, factor, root, 1, x, lower) for entry in _numerators(image)]
    value = fraction.numerator.xreplace({x: root.value}).applyfunc(sp.expand)
    return AtUpperRoot(fraction, sp.ImmutableMatrix(*image.shape, entries), value)


def _covered_entry(
    numerator: list[Any],
    image: RationalMatrix,
    factor: Factor,
    root: Root,
    order: int,
    x: sp.Symbol,
    lower: Root | None = None,
) -> sp.Expr:
    """(x − λ)ᵐ times an entry, in lowest terms; zero for an entry without a simple pole. With `lower`, of a pair."""
    rest, left = cancelled(numerator, [(each.modulus, each.multiplicity) for each in image.factors])
    power = dict(left).get(factor.modulus, 0)
    if not rest or (order == 1 and not power):
        return sp.Integer(0)
    others = [(p, k) for p, k in left if p != factor.modulus]
    K = factor.modulus.domain
    apart = in_lowest_terms(rest, others, x) if others else in_powers(rest, K, x)
    own = sp.S.One if lower else x - root.value
    return sp.Mul(apart, own ** (order - power), *(each**-power for each in _beside(factor, (root, lower), x)))


def _beside(factor: Factor, own: Sequence[Root | None], x: sp.Symbol) -> list[sp.Expr]:
    """The factor without its own roots: linear in its real roots, quadratic in its simple pairs."""
    found = []
    for each in factor.roots:
        if each in own:
            continue
        if not is_simple_pair(each):
            found.append(x - each.value)
        elif not is_lower(each):
            found.append(real_quadratic(each, x))
    return found


def slope_of_quotient(entry: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """The derivative of N/(q₁ᵏ q₂ˡ …), over the same factors to one power more."""
    parts: tuple[Any, ...] = sp.Mul.make_args(entry)
    below = {each.base: -each.exp for each in parts if each.is_Pow and each.exp.is_negative and each.base.has(x)}
    above = sp.Mul(*(each for each in parts if not (each.is_Pow and each.base in below)))
    terms = [sp.diff(above, x) * sp.Mul(*below)]
    for q, k in below.items():
        terms.append(-k * above * sp.diff(q, x) * sp.Mul(*(each for each in below if each != q)))
    return sp.Mul(_in_powers_of(sp.Add(*terms), x), *(q ** (-k - 1) for q, k in below.items()))


def _in_powers_of(polynomial: sp.Expr, x: sp.Symbol) -> sp.Expr:
    return sp.Add(*(tidy(c) * x**i for (i,), c in sp.Poly(sp.expand(polynomial), x).terms()))


def compared(image: RationalMatrix, x: sp.Symbol) -> Compared | None:
    """The numerator over a quadratic by comparison; None unless there is one, to the power one, beside other poles."""
    fractions = fractions_of(image, x)
    quadratics = [each for each in fractions if each.slope is not None]
    if len(quadratics) != 1 or len(fractions) == 1 or quadratics[0].power > 1:
        return None
    (fraction,) = quadratics
    known = [each for each in fractions if each.slope is None]
    orders: dict[sp.Expr, int] = {}
    for each in known:
        orders[each.base] = max(each.power, orders.get(each.base, 0))
    cofactor = sp.Mul(*(base**order for base, order in orders.items()))
    others = tuple((each.constant, fraction.base * cofactor / each.base**each.power) for each in known)
    n = 2 + sum(orders.values())
    numerator = _over_common_denominator(image, x)
    equations = []
    for power in (n - 1, n - 2):
        shares = tuple((R, c) for R, left in others if (c := _coefficient(left, x, power)) != 0)
        taken = _coefficient(cofactor, x, power - 1) if power == n - 2 else sp.Integer(1)
        equations.append((numerator.applyfunc(partial(_coefficient, x=x, power=power)), shares, taken))
    return Compared(fraction, numerator, cofactor, others, tuple(equations), n)


def put_together(image: RationalMatrix, x: sp.Symbol) -> tuple[sp.ImmutableMatrix, list[tuple[sp.Expr, Fraction]]]:
    """The numerator over the common denominator d, and the partial fractions, each with d over its own."""
    fractions = fractions_of(image, x)
    orders: dict[sp.Expr, int] = {}
    for each in fractions:
        orders[each.base] = max(each.power, orders.get(each.base, 0))
    below = [
        sp.Mul(*(base ** (order - each.power * (base == each.base)) for base, order in orders.items()))
        for each in fractions
    ]
    return _over_common_denominator(image, x), list(zip(below, fractions, strict=True))


def _over_common_denominator(image: RationalMatrix, x: sp.Symbol) -> sp.ImmutableMatrix:
    """The numerator N over the product of the factors that do not cancel in all entries, in powers of x."""
    K, X = image.factors[0].modulus.domain, sp.Dummy("x")
    factors = [(each.modulus, each.multiplicity) for each in image.factors]
    highest = {each.factor.modulus: order for each, order in image.poles}
    entries = []
    for entry in _numerators(image):
        rest, left = cancelled(entry, factors)
        whole = sp.Poly(rest or [K.zero], X, domain=K)
        for p, order in highest.items():
            whole *= sp.Poly([K.one, *reversed(p.low)], X, domain=K) ** (order - dict(left).get(p, 0))
        entries.append(in_powers(whole.rep.to_list(), K, x))
    return sp.ImmutableMatrix(*image.shape, entries)


def _coefficient(polynomial: sp.Expr, x: sp.Symbol, power: int) -> sp.Expr:
    return tidy(sp.expand(polynomial).coeff(x, power))
