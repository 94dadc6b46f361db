"""Where rational functions of parameters are positive: signs, intervals of one parameter, conjunctions for several.

One parameter k is solved for exactly: the real roots of all numerators and denominators cut the line into intervals,
and a rational point of each tells the signs in it. What depends on k only by sin k, cos k or eᵏ is solved for that.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import mpmath
import sympy as sp

from solver.conditions import conditions_of
from solver.exact.linear_algebra.fields import in_sines
from solver.exact.linear_algebra.radicals import square_root
from solver.exact.linear_algebra.signs import is_not_zero, possible_signs, values_of
from solver.exact.linear_algebra.spectrum import DIGITS

WORKING_DIGITS = 60

Condition = Any
"""A relation, a conjunction or disjunction of relations, or one of sympy's truth values."""


@dataclass(frozen=True)
class Generator:
    """What the conditions are rational functions of: k itself or a function of it, and its range.

    An end belongs to the range where it is closed (both of sin and cos).
    """

    value: sp.Expr
    low: sp.Expr
    high: sp.Expr
    low_closed: bool = False
    high_closed: bool = False


@dataclass(frozen=True)
class Interval:
    """low < g < high; with `low_end`, `high_end` the end of the range belongs to it too."""

    low: sp.Expr
    high: sp.Expr
    low_end: bool = False
    high_end: bool = False


def sign_of(x: sp.Expr) -> int | None:
    """The sign of an exact expression, for all values of its parameters; None where it is not the same for all."""
    if x.is_Rational:
        return int(bool(x > 0)) - int(bool(x < 0))
    if not x.free_symbols:
        value = sp.re(sp.N(x, WORKING_DIGITS))
        return 0 if abs(value) < sp.Float(10) ** -40 else (1 if value > 0 else -1)
    decided = possible_signs(x) if conditions_of(x.free_symbols) else frozenset()
    if len(decided) == 1:
        return next(iter(decided))
    sign = 1
    for factor, exponent in signed_factors(x):
        known = _sign_of_factor(factor)
        if known == 0:
            return 0
        if known is None:
            if exponent % 2 or not is_not_zero(factor):
                return None
            known = 1
        sign *= known if exponent % 2 else 1
    return sign


def signed_factors(x: sp.Expr) -> list[tuple[sp.Expr, int]]:
    """The factors of a rational function and their exponents (negative below the bar), the constant first."""
    factored = sp.factor(in_sines(sp.together(x)))
    found: list[tuple[sp.Expr, int]] = []
    for factor, exponent in factored.as_powers_dict().items():
        found.append((factor, int(exponent)) if exponent.is_Integer else (factor**exponent, 1))
    return sorted(found, key=lambda pair: (bool(pair[0].free_symbols), sp.default_sort_key(pair[0])))


def _sign_of_factor(factor: sp.Expr) -> int | None:
    if not factor.free_symbols:
        return sign_of(factor)
    if factor.is_zero:
        return 0
    if factor.is_positive or factor.is_negative:
        return 1 if factor.is_positive else -1
    generator = generator_of([factor])
    if generator is None:
        return None
    for sign in (1, -1):
        if whole_range(positive_intervals([sign * factor], generator), generator):
            return sign
    return None


def generator_of(expressions: Iterable[sp.Expr]) -> Generator | None:
    """What expressions in one real parameter are rational functions of; None for several parameters or else."""
    listed = list(expressions)
    symbols: set[Any] = set().union(*(x.free_symbols for x in listed))
    if len(symbols) != 1:
        return None
    (k,) = symbols
    if k.is_real is False or (k.is_complex and k.is_real is None):
        return None
    if not all(x.is_rational_function(k) for x in listed):
        return _function_of(k, listed)
    low = sp.Integer(0) if k.is_nonnegative else -sp.oo
    range_of = values_of(k)
    if range_of is not None:
        return Generator(k, *range_of)
    return Generator(k, low, sp.Integer(0) if k.is_nonpositive else sp.oo)


def _function_of(k: sp.Symbol, listed: Sequence[sp.Expr]) -> Generator | None:
    """The one function of k, of known range, in which all expressions are rational."""
    functions: set[sp.Expr] = set().union(*(x.atoms(sp.Function) for x in listed))
    if len(functions) != 1:
        return None
    (f,) = functions
    u = sp.Dummy("u")
    replaced = [x.xreplace({f: u}) for x in listed]
    if any(k in x.free_symbols or not x.is_rational_function(u) for x in replaced):
        return None
    if isinstance(f, sp.sin | sp.cos):
        return Generator(f, sp.Integer(-1), sp.Integer(1), low_closed=True, high_closed=True)
    return Generator(f, sp.Integer(0), sp.oo) if isinstance(f, sp.exp) else None


def positive_intervals(conditions: Sequence[sp.Expr], generator: Generator) -> list[Interval]:
    """The open intervals of the generator's range in which all conditions (rational in it) are positive, rising."""
    u = sp.Dummy("u", real=True)
    functions = [sp.together(x.xreplace({generator.value: u})) for x in conditions]
    polynomials = [part for x in functions for part in sp.fraction(x) if u in part.free_symbols]
    inside = [r for r in _distinct(r for p in polynomials for r in real_roots(p, u)) if _within(r, generator)]
    cuts = [generator.low, *inside, generator.high]
    found = []
    for low, high in pairwise(cuts):
        if _holds(functions, u, _between(low, high)):
            low_end = generator.low_closed and low == generator.low and _holds(functions, u, low)
            high_end = generator.high_closed and high == generator.high and _holds(functions, u, high)
            found.append(Interval(low, high, low_end, high_end))
    return found


def whole_range(intervals: Sequence[Interval], generator: Generator) -> bool:
    """Whether the intervals are all of the generator's range."""
    if len(intervals) != 1:
        return False
    return _reach(intervals) == _reach_of(generator)


def relational(intervals: Sequence[Interval], generator: Generator) -> Condition:
    """The intervals as a condition; True for the whole range, False for none of it."""
    if whole_range(intervals, generator):
        return sp.true
    g, parts = generator.value, []
    if len(intervals) == 2 and intervals[0].high == intervals[1].low and _reach(intervals) == _reach_of(generator):
        return sp.Ne(g, intervals[0].high)
    for each in intervals:
        bounds: list[Any] = []
        if each.low != -sp.oo and not (each.low_end and not g.is_Symbol):
            bounds.append(sp.Ge(g, each.low) if each.low_end else sp.Gt(g, each.low))
        if each.high != sp.oo and not (each.high_end and not g.is_Symbol):
            bounds.append(sp.Le(g, each.high) if each.high_end else sp.Lt(g, each.high))
        parts.append(sp.And(*bounds))
    return sp.Or(*parts)


def _reach(intervals: Sequence[Interval]) -> tuple[sp.Expr, sp.Expr, bool, bool]:
    first, last = intervals[0], intervals[-1]
    return first.low, last.high, first.low_end, last.high_end


def _reach_of(generator: Generator) -> tuple[sp.Expr, sp.Expr, bool, bool]:
    return generator.low, generator.high, generator.low_closed, generator.high_closed


def real_roots(polynomial: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    """The real roots of a polynomial in x with numbers for coefficients; decimals for factors of degree ≥ 3."""
    try:
        p = sp.Poly(polynomial, x, extension=True)
    except (sp.CoercionFailed, NotImplementedError):
        p = sp.Poly(polynomial, x)
    found: list[sp.Expr] = []
    for factor, _ in p.factor_list()[1]:
        found += _roots_of_factor(factor)
    return _distinct(found)


def _roots_of_factor(p: sp.Poly) -> list[sp.Expr]:
    if p.degree() == 1:
        a, b = p.all_coeffs()
        return [sp.radsimp(-b / a)]
    if p.degree() == 2:
        a, b, c = p.all_coeffs()
        radicand = sp.expand(b**2 - 4 * a * c)
        sign = sign_of(radicand)
        if sign == -1:
            return []
        shift = square_root(sp.radsimp(radicand / (4 * a**2)))
        return [sp.radsimp(-b / (2 * a)) + s * shift for s in ((-1, 1) if sign else (0,))]
    with mpmath.workdps(2 * WORKING_DIGITS):
        coefficients = [mpmath.mpmathify(sp.N(c, 2 * WORKING_DIGITS)) for c in p.all_coeffs()]
        zeros = mpmath.polyroots(coefficients, maxsteps=1000, extraprec=1000)
        real = [z.real for z in zeros if abs(z.imag) < mpmath.mpf(10) ** (-WORKING_DIGITS) * (1 + abs(z))]
        return [sp.Float(r, DIGITS) for r in sorted(real)]


def _number(x: sp.Expr) -> sp.Float:
    return sp.N(x, WORKING_DIGITS)


def _distinct(roots: Iterable[sp.Expr]) -> list[sp.Expr]:
    """The roots, rising, each once."""
    found: list[sp.Expr] = []
    for root in sorted(roots, key=_number):
        if not found or abs(_number(root - found[-1])) > sp.Float(10) ** (5 - DIGITS):
            found.append(root)
    return found


def _within(root: sp.Expr, generator: Generator) -> bool:
    return bool(_number(root - generator.low) > 0 if generator.low.is_finite else True) and bool(
        _number(generator.high - root) > 0 if generator.high.is_finite else True
    )


def _between(low: sp.Expr, high: sp.Expr) -> sp.Rational:
    """A rational point between two ends."""
    if low == -sp.oo and high == sp.oo:
        return sp.Integer(0)
    if low == -sp.oo:
        return sp.floor(_number(high)) - 1
    if high == sp.oo:
        return sp.ceiling(_number(low)) + 1
    a, b = _number(low), _number(high)
    return sp.Rational(str(sp.N((a + b) / 2, WORKING_DIGITS)))


def _holds(functions: Sequence[sp.Expr], u: sp.Symbol, value: sp.Expr) -> bool:
    """Whether all functions are positive at a value."""
    at = [sp.expand(part.xreplace({u: value})) for x in functions for part in sp.fraction(x)]
    signs = [sign_of(part) for part in at]
    return all((above or 0) * (below or 0) > 0 for above, below in zip(signs[::2], signs[1::2], strict=True))
