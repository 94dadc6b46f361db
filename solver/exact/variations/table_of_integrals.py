"""Antiderivatives that a table has: tⁿ e^{at} cos bt, rational functions, powers and roots of simple terms."""

from __future__ import annotations

from typing import Any

import sympy as sp

from solver.exact.functions.antiderivatives import antiderivative
from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.radicals import square_root
from solver.exact.linear_algebra.signs import possible_signs

HALF = sp.Rational(1, 2)


def table_integral(f: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """An antiderivative of f in x; None where the table has none."""
    f = plain_roots(f)
    found = antiderivative(sp.ImmutableMatrix([[f]]), x)
    if found is not None:
        return found.function[0]
    parts = [_of_term(term, x) for term in sp.Add.make_args(sp.expand_mul(f))]
    known = [part for part in parts if part is not None]
    return sp.Add(*known) if len(known) == len(parts) else _of_term(sp.factor(f), x)


def plain_roots(f: sp.Expr) -> sp.Expr:
    """An expression with 1/√w in place of √(1/w)."""
    put: Any = {part: part.base.base**-part.exp for part in f.atoms(sp.Pow) if _is_root_of_quotient(part)}
    return f.xreplace(put)


def _is_root_of_quotient(part: Any) -> bool:
    """Whether it is √(1/w), for 1/√w."""
    return bool(part.is_Pow and part.exp.is_Rational and part.base.is_Pow and part.base.exp == -1)


def integrated(f: sp.Expr, x: sp.Symbol, times: int) -> tuple[sp.Expr, ...] | None:
    """The antiderivative of f, that of it, and so on; None where the table does not have one of them."""
    found: list[sp.Expr] = []
    for _ in range(times):
        following = table_integral(f, x)
        if following is None:
            return None
        found.append(sp.expand(following) if following.is_polynomial(x) else following)
        f = found[-1]
    return tuple(found)


def _of_term(term: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """The antiderivative of one term, its constant in front."""
    constant, rest = term.as_independent(x, as_Add=False)
    for rule in (_power, _rational, _over_root, _usual, _chain):
        found = rule(rest, x)
        if found is not None:
            return constant * found
    known = antiderivative(sp.ImmutableMatrix([[rest]]), x)
    return None if known is None else constant * known.function[0]


def _power(f: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """(ax + b)ʳ: the power raised by one, or a logarithm."""
    base, exponent = f.as_base_exp()
    slope = sp.diff(base, x)
    if exponent.has(x) or slope == 0 or slope.has(x):
        return None
    if sp.expand(exponent + 1) == 0:
        return sp.log(base) / slope
    return base ** (exponent + 1) / slope / (exponent + 1)


def _rational(f: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """Partial fractions: powers of linear factors, and simple quadratic ones."""
    if not f.is_rational_function(x):
        return None
    terms: list[Any] = list(sp.Add.make_args(sp.apart(f, x)))
    found = [each for term in terms if (each := _fraction(term, x)) is not None]
    return sp.Add(*found) if len(found) == len(terms) else None


def _fraction(term: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    above, below = sp.fraction(sp.together(term))
    if not below.has(x):
        known = antiderivative(sp.ImmutableMatrix([[sp.expand(term)]]), x)
        return None if known is None else known.function[0]
    constant, factor = sp.factor(below).as_independent(x, as_Add=False)
    base, power = factor.as_base_exp()
    degree = sp.degree(base, x)
    if degree == 1 and not above.has(x):
        found = _power(base**-power, x)
        return None if found is None else above / constant * found
    if degree != 2 or power != 1:
        return None
    a, b, c = sp.Poly(base, x).all_coeffs()
    slope, rest = sp.Poly(above / constant, x).all_coeffs() if above.has(x) else (sp.S.Zero, above / constant)
    share, left = slope / (2 * a), rest - slope * b / (2 * a)
    other = _over_quadratic(left, a, b, c, x)
    return None if other is None else share * sp.log(base) + other


def _over_quadratic(factor: Any, a: sp.Expr, b: sp.Expr, c: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """∫ k/(ax² + bx + c) dx by an arc tangent, or by logarithms where there are real roots."""
    if factor == 0:
        return sp.S.Zero
    D = tidy(4 * a * c - b**2)
    signs = possible_signs(D) - {0}  # generic
    if signs == {1}:
        root = square_root(D)
        return 2 * factor / root * sp.atan(tidy((2 * a * x + b) / root))
    if signs == {-1}:
        root = square_root(-D)
        return factor / root * (sp.log(2 * a * x + b - root) - sp.log(2 * a * x + b + root))
    return None


def _over_root(f: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """(px + q)/√(ax² + bx + c): the root, and an arc sine, or an area sine or cosine."""
    above, below = sp.fraction(f)
    if not isinstance(below, sp.Pow) or below.exp != HALF or not below.base.is_polynomial(x):
        return None
    if sp.degree(below.base, x) != 2 or not above.is_polynomial(x) or sp.degree(above, x) > 1:
        return None
    a, b, c = sp.Poly(below.base, x).all_coeffs()
    p, q = sp.diff(above, x), above.subs(x, 0)
    left = q - p * b / (2 * a)
    inner = _inverse(left, a, b, c, x)
    return None if inner is None else p / a * below + inner


def _inverse(factor: Any, a: sp.Expr, b: sp.Expr, c: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """∫ k/√(ax² + bx + c) dx."""
    if factor == 0:
        return sp.S.Zero
    sign, discriminant = (possible_signs(each) - {0} for each in (a, tidy(4 * a * c - b**2)))  # generic
    if sign == {-1}:
        return factor / square_root(-a) * sp.asin(tidy(-(2 * a * x + b) / square_root(tidy(b**2 - 4 * a * c))))
    if sign != {1}:
        return None
    if discriminant == {1}:
        return factor / square_root(a) * sp.asinh(tidy((2 * a * x + b) / square_root(tidy(4 * a * c - b**2))))
    if discriminant == {-1}:
        return factor / square_root(a) * sp.acosh(tidy((2 * a * x + b) / square_root(tidy(b**2 - 4 * a * c))))
    return None


def _usual(f: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """1/cos², 1/sin², 1/cosh² and tan of a linear argument; log x."""
    base, exponent = f.as_base_exp()
    argument: Any = base.args[0] if base.args else None
    if argument is None or sp.diff(argument, x, 2) != 0:
        return None
    slope = sp.diff(argument, x)
    squares = {sp.cos: sp.tan(argument), sp.sin: -1 / sp.tan(argument), sp.cosh: sp.tanh(argument)}
    if exponent == -2 and base.func in squares:
        return squares[base.func] / slope
    if exponent == 1 and isinstance(base, sp.log):
        return (argument * base - argument) / slope
    return -sp.log(sp.cos(argument)) / slope if exponent == 1 and isinstance(base, sp.tan) else None


def _chain(f: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """g' e^g and g' gʳ."""
    for factor in sp.Mul.make_args(f):
        base, exponent = (factor, sp.S.One) if isinstance(factor, sp.exp) else factor.as_base_exp()
        inner: Any = factor.args[0] if isinstance(factor, sp.exp) else base
        slope = sp.diff(inner, x)
        if slope == 0 or exponent.has(x) or (not isinstance(factor, sp.exp) and inner == x):
            continue
        share = sp.cancel(f / factor / slope)
        if share.has(x):
            continue
        if isinstance(factor, sp.exp):
            return share * factor
        return share * (sp.log(base) if exponent == -1 else base ** (exponent + 1) / (exponent + 1))
    return None
