"""Real roots of a polynomial in one unknown: exact up to degree two and of biquadratics, otherwise decimals."""

from __future__ import annotations

from typing import Any

import mpmath
import sympy as sp

from solver.exact.modelling.evaluation import DIGITS, decimal, evaluator, is_not_negative, sign_of
from solver.exact.modelling.factors_of_equations import without_known_signs
from solver.exact.modelling.quotients import Quotients, quotients_in

Root = tuple[Any, tuple[Any, ...]]
"""A root and the conditions on parameters under which it is real."""


def complex_roots(coefficients: list[Any]) -> list[Root] | None:
    """Return the different roots, also complex ones; None where they can't be told."""
    n = len(coefficients) - 1
    if n == 1:
        return real_roots(coefficients)
    if n == 2:
        a, b, c = coefficients
        D = sp.expand(b**2 - 4 * a * c)
        middle = quotient(-b, 2 * a)
        if sign_of(D) == 0:
            return [(middle, ())]
        half = square_root(-D) * sp.I if sign_of(D) == -1 else square_root(D)
        return [(middle + s * half / (2 * a), ()) for s in (-1, 1)]
    if any(c.free_symbols for c in coefficients):
        return None
    if not all(c.is_Rational for c in coefficients):
        return [(root, ()) for root in _numerical(coefficients, real=False)]
    found: list[Root] = []
    for factor, _ in sp.Poly(coefficients, sp.Dummy(), domain=sp.QQ).factor_list()[1]:
        own = factor.all_coeffs()
        found += complex_roots(own) or [] if len(own) <= 3 else [(root, ()) for root in _numerical(own, real=False)]
    return found


def real_roots(coefficients: list[Any]) -> list[Root] | None:
    """Return the different real roots, the highest power first in `coefficients`; None where they can't be told."""
    n = len(coefficients) - 1
    if n == 1:
        return [(quotient(-coefficients[1], coefficients[0]), ())]
    if n == 2:
        return _quadratic(*coefficients)
    if all(c == 0 for c in coefficients[1:-1]):
        return _pure(coefficients[0], coefficients[-1], n)
    if n == 4 and coefficients[1] == coefficients[3] == 0:
        squares = _quadratic(coefficients[0], coefficients[2], coefficients[4])
        return [root for square, needs in squares for root in _roots_of_square(square, needs)]
    if any(c.free_symbols for c in coefficients):
        return None
    return _decimals(coefficients)


def quotient(a: Any, b: Any) -> Any:
    """Return a/b as a person writes it: multiplied out over a number, else both parts in factors, cancelled."""
    if a.has(sp.Float) or b.has(sp.Float):
        return a / b
    if b.is_Rational:
        return sp.expand(a / b) if not a.is_Mul else a / b
    field = quotients_in([a, b])
    (above, below), (over, under) = field.of(a), field.of(b)
    above, below = field.reduced(above * under, below * over)
    return _product(field, above) / _product(field, below)


def in_factors(value: Any) -> Any:
    """Return an expression as one quotient in factors, where that is shorter."""
    field = quotients_in([value])
    above, below = field.of(value)
    found = _product(field, above) / _product(field, below)
    return found if found.count_ops() < value.count_ops() else value


def _product(field: Quotients, p: Any) -> Any:
    if not p:
        return sp.S.Zero
    number, factors = p.factor_list()
    found = [f.as_expr(*field.variables) ** k for f, k in factors]
    if number < 0 and (sums := [i for i, (f, k) in enumerate(factors) if len(f) > 1 and k == 1]):
        number, found[sums[0]] = -number, sp.expand(-found[sums[0]])
    return sp.Mul(sp.Rational(number), *found)


def _quadratic(a: Any, b: Any, c: Any) -> list[Root]:
    if b == 0:
        return _roots_of_square(quotient(-c, a), ())
    D = sp.expand(b**2 - 4 * a * c)
    sign = sign_of(D)
    if sign == -1:
        return []
    if sign == 0:
        return [(quotient(-b, 2 * a), ())]
    root = square_root(D)
    needs = () if is_not_negative(D) else (sp.Ge(without_known_signs(D), 0),)
    middle, half = quotient(-b, 2 * a), root / (2 * a)
    return [(middle + s * half, needs) for s in (-1, 1)]


def _roots_of_square(square: Any, needs: tuple[Any, ...]) -> list[Root]:
    """± the root of an expression."""
    sign = sign_of(square)
    if sign == 0:
        return [(sp.S.Zero, needs)]
    if sign == -1:
        return []
    more = () if is_not_negative(square) else (sp.Ge(without_known_signs(square), 0),)
    root = square_root(square)
    return [(s * root, (*needs, *more)) for s in (-1, 1)]


def square_root(value: Any) -> Any:
    """Return the root with squares before it; the sign may be any where those of the symbols are not known."""
    if not value.free_symbols:
        return sp.sqrt(value)
    above, below = sp.fraction(sp.together(value))
    number, factors = sp.factor_list(above * below)
    outside, inside = sp.S.One / below, sp.sqrt(number)
    within = sp.S.One
    for factor, power in factors:
        outside *= factor ** (power // 2)
        within *= factor if power % 2 else 1
    return outside * inside * sp.sqrt(within)


def _pure(a: Any, c: Any, n: int) -> list[Root]:
    """a xⁿ + c = 0."""
    value = quotient(-c, a)
    if value == 0:
        return [(sp.S.Zero, ())]
    sign = sign_of(value)
    if n % 2:
        if sign is None:
            return [(sp.real_root(value, n), ())]
        return [(sign * (sign * value) ** sp.Rational(1, n), ())]
    if sign == -1:
        return []
    needs = () if is_not_negative(value) else (sp.Ge(without_known_signs(value), 0),)
    root = value ** sp.Rational(1, n)
    return [(-root, needs), (root, needs)]


def _decimals(coefficients: list[Any]) -> list[Root]:
    """Rational roots and those of quadratic factors exactly, the others in decimals."""
    x = sp.Dummy()
    if not all(c.is_Rational for c in coefficients):
        return [(root, ()) for root in _numerical(coefficients)]
    found: list[Root] = []
    for factor, _ in sp.Poly(coefficients, x, domain=sp.QQ).factor_list()[1]:
        own = factor.all_coeffs()
        pure = all(c == 0 for c in own[1:-1])
        if len(own) <= 3 or pure or (len(own) == 5 and own[1] == own[3] == 0):
            found += real_roots(own) or []
        else:
            found += [(root, ()) for root in _numerical(own)]
    return found


def _numerical(coefficients: list[Any], *, real: bool = True) -> list[Any]:
    with mpmath.workdps(DIGITS + 20):
        values = [evaluator(c, [])(mpmath.mp, []) for c in coefficients]
        roots = mpmath.polyroots(values, maxsteps=400, extraprec=400)
        tiny = mpmath.mpf(10) ** -(DIGITS // 2)
        every = sorted(((mpmath.re(r), mpmath.im(r)) for r in roots), key=lambda r: (r[0], r[1]))
        every = [(re, im if abs(im) > tiny * (1 + abs(re)) else mpmath.mpf(0)) for re, im in every]
        every = [each for each in every if not real or not each[1]]
        apart = [r for i, r in enumerate(every) if not any(_near(r, other, tiny) for other in every[:i])]
        return [decimal(re) + decimal(im) * sp.I if im else decimal(re) for re, im in apart]


def _near(a: Any, b: Any, tiny: Any) -> bool:
    return bool(abs(a[0] - b[0]) + abs(a[1] - b[1]) <= tiny * (1 + abs(a[0]) + abs(a[1])))
