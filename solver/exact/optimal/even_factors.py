"""Even factors of an even polynomial: s² − α² and s⁴ + e s² + f, and the choices of their roots in square roots."""

from __future__ import annotations

from typing import Any

import mpmath
import sympy as sp

from solver.exact.linear_algebra.fields import expression
from solver.exact.linear_algebra.signs import is_positive, possible_signs
from solver.exact.optimal.root_choices import (
    DIGITS,
    Builder,
    Choice,
    Coefficients,
    OnTheAxis,
    coefficients_of,
    decimal,
    decimal_choices,
    divided,
    known_negative,
    linear_powers,
    power_product,
    roots_in_decimals,
    roots_of_quadratic,
)
from solver.exact.optimal.square_roots import RootTower, root_of


def near_the_axis(z: Any) -> bool:
    """Whether the real part of a decimal cannot be told from zero."""
    return bool(abs(z.real) < mpmath.mpf(10) ** -DIGITS * (1 + abs(z)))


def quadratic_choices(q: sp.Poly, m: int) -> tuple[Choice, ...]:
    """(s + α)^{m−k} (s − α)ᵏ for the even factor s² − α². Raises OnTheAxis."""
    K = q.domain
    square = -coefficients_of(q)[2]
    if known_negative(K, square):
        raise OnTheAxis(q)
    alpha = root_of(K, square)
    value = mpmath.sqrt(decimal(K, expression(K, square)))

    def factor(k: int) -> Builder:
        def build(tower: RootTower) -> Coefficients:
            return power_product(tower, linear_powers(tower, tower.square_root((square,)), m, k))

        return build

    return tuple(
        Choice(k, factor(k), () if K.is_Composite else divided(value, m, k), divided(alpha, m, k)) for k in range(m + 1)
    )


def biquadratic_choices(q: sp.Poly, m: int) -> tuple[Choice, ...]:
    """The choices of s⁴ + e s² + f: a pair of roots flipped as a whole, or where they are real also one by one.

    Raises OnTheAxis.
    """
    K, (_, _, e, _, f) = q.domain, coefficients_of(q)
    numbers = not K.is_Composite
    roots = roots_in_decimals(q) if numbers else []
    if any(map(near_the_axis, roots)) or (not numbers and known_negative(K, f)):
        raise OnTheAxis(q)
    stable = [z for z in roots if z.real < 0]
    all_real = numbers and all(z.imag == 0 for z in roots)
    if m > 1 and all_real:
        return decimal_choices(stable, m)
    whole = _flipped_as_a_whole(K, e, f, m, stable)
    if m > 1 or (numbers and not all_real):
        return whole
    radicand = None if numbers else _second_radicand(K, e, f)
    if radicand is False:
        return whole
    return whole[0], *_flipped_one_by_one(K, e, f, stable, None if radicand is True else radicand), whole[1]


def _flipped_as_a_whole(K: Any, e: Any, f: Any, m: int, stable: list[Any]) -> tuple[Choice, ...]:
    def mixed(k: int) -> Builder:
        def build(tower: RootTower) -> Coefficients:
            straight, flipped = (_half(K, e, f, 1, b_sign)(tower) for b_sign in (1, -1))
            return power_product(tower, [(straight, m - k), (flipped, k)])

        return build

    spelled = _spelled_roots(K, e, f)
    return tuple(
        Choice(2 * k, mixed(k), (*stable * (m - k), *(-z for z in stable * k)), () if k else spelled * m)
        for k in range(m + 1)
    )


def _flipped_one_by_one(K: Any, e: Any, f: Any, stable: list[Any], radicand: Any) -> tuple[Choice, ...]:
    """The slower of two real roots flipped, or the faster one: the product of the roots is negative then."""
    mixed: list[tuple[Any, ...]] = [(), ()]
    if stable:
        fast, slow = sorted(stable, key=lambda z: z.real)
        mixed = [(fast, -slow), (-fast, slow)]
    return tuple(
        Choice(1, _half(K, e, f, -1, b_sign), taken, (), radicand) for b_sign, taken in zip((1, -1), mixed, strict=True)
    )


def _half(K: Any, e: Any, f: Any, c_sign: int, b_sign: int) -> Builder:
    """s² + b s + c with s⁴ + e s² + f = (s² + b s + c)(s² − b s + c), so c = ±√f and b = ±√(2c − e)."""

    def build(tower: RootTower) -> Coefficients:
        c = tower.scale(K(c_sign), tower.square_root((f,)))
        b = tower.scale(K(b_sign), tower.square_root(tower.add(tower.scale(K(2), c), (-e,))))
        return [tower.constant(K.one), b, c]

    return build


def _second_radicand(K: Any, e: Any, f: Any) -> Any:
    """−2√f − e, which must be positive for real roots: True or False where that is known, else the expression."""
    radicand = -2 * sp.sqrt(expression(K, f)) - expression(K, e)
    if len(signs := possible_signs(radicand)) == 1:
        return signs == {1}
    discriminant = sp.factor(expression(K, e * e - K(4) * f))
    if is_positive(-discriminant) or -1 not in possible_signs(expression(K, e)):
        return False
    return sp.factor(expression(K, -e)) - 2 * sp.sqrt(sp.factor(expression(K, f)))


def _spelled_roots(K: Any, e: Any, f: Any) -> tuple[sp.Expr, ...]:
    """The stable roots of s⁴ + e s² + f: of s² + b s + c as below, or −√(−e/2 ± √(e²/4 − f)) where c is irrational."""
    tower = RootTower(K)
    _, b, c = _half(K, e, f, 1, 1)(tower)
    square = e * e / K(4) - f
    if any(c[1:]) and is_positive(expression(K, square)):
        other = RootTower(K)
        delta = other.square_root((square,))
        squares = [other.add((-e / K(2),), each) for each in (delta, other.negative(delta))]
        return tuple(-sp.sqrt(other.expression(each)) for each in squares)
    return roots_of_quadratic(tower, b, c)
