"""Equations of first order solved for x', and those of them whose variables can be separated.

x'² = a x² + b x + c is solved by its complete square: y'² = a y² + k has y = √(−k/a) cosh, √(k/a) sinh or sin of
√|a| (t + C) (E. Kamke, Differentialgleichungen, I, §1 and §4).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.radicals import square_root
from solver.exact.linear_algebra.signs import possible_signs
from solver.exact.variations.table_of_integrals import table_integral


@dataclass(frozen=True)
class Rate:
    """x' (`power` 1) or x'² (`power` 2) as a function of x, t and constants."""

    value: sp.Expr
    power: int


@dataclass(frozen=True)
class Separated:
    """x as functions of t and of a new constant; `kind` says how: "time", "linear", "square", "of_square", "table".

    `auxiliary` is what is found first: −b/(2a) ("square"), x² ("of_square"), the integral over x ("table"). `integral`
    is ∫ dx/x' for the positive root, where it is known in short.
    """

    kind: str
    functions: tuple[sp.Expr, ...]
    auxiliary: sp.Expr
    integral: sp.Expr = sp.S.Zero


def rate_of(equation: sp.Expr, rate: sp.Symbol) -> Rate | None:
    """The equation solved for x' or x'²; roots in it are squared away. None where that is not possible."""
    left = sp.numer(sp.together(equation))
    roots = [p for p in left.atoms(sp.Pow) if p.exp.is_Rational and not p.exp.is_Integer and p.has(rate)]
    bases = {p.base for p in roots}
    if len(bases) > 1 or any(p.exp.q != 2 for p in roots):
        return None
    if bases:
        (base,) = bases
        r = sp.Dummy("r")
        inside = sp.expand(left.xreplace({p: r ** (2 * p.exp) for p in roots}))
        if not inside.is_polynomial(r) or sp.degree(inside, r) != 1:
            return None
        slope, rest = sp.Poly(inside, r).all_coeffs()
        left = sp.numer(sp.together(rest**2 - slope**2 * base))
    left = sp.expand(left)
    if not left.is_polynomial(rate):
        return None
    monomials = {power: c for (power,), c in sp.Poly(left, rate).terms()}
    highest = max(monomials)
    if highest not in (1, 2) or set(monomials) - {0, highest}:
        return None
    value = -monomials.get(0, sp.S.Zero) / monomials[highest]
    return Rate(min((sp.factor(value), sp.expand(value)), key=sp.count_ops), highest)


def with_square(rate: Rate, constants: Sequence[sp.Symbol]) -> tuple[Rate, sp.Symbol] | None:
    """The rate with C² or −C² in place of a constant C whose sign is known, as x'²/C is a function of one sign."""
    for constant in constants:
        rest, power = rate.value.as_independent(constant, as_Add=False)
        if rate.power == 2 and power in (constant, 1 / constant) and len(signs := _signs(rest) - {0}) == 1:
            return Rate(rate.value.xreplace({constant: next(iter(signs)) * constant**2}), 2), constant
    return None


def separated(rate: Rate, x: sp.Symbol, t: sp.Symbol, constant: sp.Symbol) -> Separated | None:
    """The functions with this rate; None where its variables cannot be separated, or an integral is not known."""
    if not rate.value.has(x):
        return _in_time(rate, t, constant)
    if rate.value.has(t):
        return None
    if rate.power == 2 and rate.value.is_polynomial(x) and sp.degree(rate.value, x) <= 2:
        return _of_quadratic(rate.value, x, t + constant)
    square = sp.expand(rate.value * x**2)
    if rate.power == 2 and square.is_polynomial(x) and not sp.diff(square, x).subs(x, 0) and sp.degree(square, x) == 2:
        return _of_square(square, x, t + constant)
    return _by_table(rate, x, t + constant)


def _signs(value: sp.Expr) -> frozenset[int]:
    """The signs of a value where nothing in it is zero."""
    open_ones: list[Any] = [each for each in value.free_symbols if each.is_real and each.is_nonzero is None]
    generic: dict[Any, Any] = {each: sp.Dummy(str(each), real=True, nonzero=True) for each in open_ones}
    return frozenset(possible_signs(value.xreplace(generic)))


def _root(value: sp.Expr) -> Any:
    """A root with squares of constants before it, without bars: they may have either sign."""
    above, below = sp.fraction(sp.factor(value))
    if above.could_extract_minus_sign():
        above, below = -above, -below
    found: Any = square_root(above) / square_root(sp.expand(below) if below.is_Mul and below.has(sp.Add) else below)
    return found.replace(sp.Abs, lambda inner: inner)


def _in_time(rate: Rate, t: sp.Symbol, constant: sp.Symbol) -> Separated | None:
    slope = rate.value if rate.power == 1 else _root(rate.value)
    integral = table_integral(slope, t)
    if integral is None:
        return None
    both = (1,) if rate.power == 1 or _has_free_sign(slope) else (1, -1)
    return Separated("time", tuple(sign * integral + constant for sign in both), slope)


def _has_free_sign(root: sp.Expr) -> bool:
    """Whether a constant of integration stands before the root, which may have either sign."""
    return any(f.is_Symbol and str(f).startswith("C") for f in sp.Mul.make_args(root))


def _of_quadratic(value: sp.Expr, x: sp.Symbol, T: sp.Expr) -> Separated | None:
    """x'² = a x² + b x + c."""
    c, b, a = (sp.expand(value).coeff(x, k) for k in range(3))
    if a == 0:
        return Separated("linear", (tidy(b / 4) * T**2 - tidy(c / b),), sp.S.Zero, 2 * _root(value) / b)
    middle, k = tidy(-b / (2 * a)), sp.factor(c - b**2 / (4 * a))
    sign, of_k = _signs(a), _signs(k)
    if sign == {1} and of_k == {-1}:
        size, speed, wave, inverse = _root(-k / a), _root(a), sp.cosh, sp.acosh
    elif sign == {1} and of_k == {1}:
        size, speed, wave, inverse = _root(k / a), _root(a), sp.sinh, sp.asinh
    elif sign == {-1}:
        size, speed, wave, inverse = _root(-k / a), _root(-a), sp.sin, sp.asin
    else:
        return None
    return Separated("square", (middle + size * wave(speed * T),), middle, inverse((x - middle) / size) / speed)


def _of_square(square: sp.Expr, x: sp.Symbol, T: sp.Expr) -> Separated:
    """(x x')² = α + β x²: z = x² has z'² = 4 (α + β z)."""
    beta, alpha = square.coeff(x, 2), square.coeff(x, 0)
    z = tidy(beta) * T**2 - tidy(alpha / beta)
    return Separated("of_square", (sp.sqrt(z), -sp.sqrt(z)), z)


def _by_table(rate: Rate, x: sp.Symbol, T: sp.Expr) -> Separated | None:
    """∫ dx/x' = t + C, turned round where the integral is a power, a logarithm or an exponential."""
    slope = rate.value if rate.power == 1 else _root(rate.value)
    integral = table_integral(sp.factor(1 / slope), x)
    if integral is None:
        return None
    factor, moving = integral.as_independent(x, as_Add=False)
    base, exponent = moving.as_base_exp()
    if base == x and exponent.is_Rational:
        power = (T / factor) ** (1 / exponent)
        both = (power, -power) if exponent.is_even else (power,)
        return Separated("table", both, integral)
    if isinstance(moving, sp.log) and sp.diff(moving.args[0], x, 2) == 0:
        a = sp.diff(moving.args[0], x)
        b = moving.args[0] - a * x
        return Separated("table", (sp.expand((sp.exp(T / factor) - b) / a),), integral)
    return None
