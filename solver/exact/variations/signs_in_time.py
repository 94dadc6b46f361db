"""Signs of functions of time over an interval, and their first zeros, decided by enclosures.

Intervals are evaluated with outward rounding (mpmath's `iv`), and halved until each has one sign; a function that
vanishes at an end of the interval is divided by the power of t − a that it holds, where it is a polynomial.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import pairwise
from typing import Any

import mpmath
import sympy as sp

from solver.exact.linear_algebra.signs import possible_signs
from solver.exact.stability.inequalities import real_roots, sign_of

HALVINGS, SAMPLES = 2000, 16
DIGITS = 30
SHOWN = 20
iv: Any = mpmath.iv
FUNCTIONS: dict[str, Callable[..., Any]] = {"exp": iv.exp, "sin": iv.sin, "cos": iv.cos, "log": iv.log}


@contextmanager
def _digits() -> Iterator[None]:
    """Many digits while this lasts."""
    before = iv.dps
    iv.dps = DIGITS
    try:
        with mpmath.workdps(DIGITS):
            yield
    finally:
        iv.dps = before


class Open(Exception):  # noqa: N818 - nothing went wrong: the enclosures do not decide
    """The enclosures leave it open."""


def signs_in_time(f: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> frozenset[int] | None:
    """The signs that f takes for start ≤ t ≤ stop; None where that is not decided.

    With parameters the signs that their assumptions leave, where it is one, or one and zero.
    """
    if not f.has(t):
        sign = sign_of(f)
        return None if sign is None else frozenset({sign})
    if (f.free_symbols | start.free_symbols | stop.free_symbols) - {t}:
        return _with_parameters(f, t, start)
    try:
        with _digits():
            return frozenset(_of_factors(f, t, start, stop))
    except (Open, ZeroDivisionError, ValueError):
        return None


def leaves_reals(f: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> bool:
    """Whether f certainly is not real, or not finite, at some time between: a root of what is negative, or a pole."""
    for power in f.atoms(sp.Pow):
        if power.base.has(t) and not (power.exp.is_integer and power.exp.is_nonnegative):
            found = signs_in_time(power.base, t, start, stop) or frozenset()
            is_root = power.exp.is_Rational and power.exp.q % 2 == 0
            if (power.exp.is_negative and {-1, 1} <= found) or (is_root and -1 in found):
                return True
    return any(-1 in (signs_in_time(log.args[0], t, start, stop) or ()) for log in f.atoms(sp.log) if log.has(t))


def without_squares(f: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> sp.Expr:
    """Return f with q or −q for √(q²), q a polynomial in t that has one sign between."""
    put: dict[sp.Expr, sp.Expr] = {}
    for root in f.atoms(sp.Pow):
        if root.exp != sp.Rational(1, 2) or not (root.base.has(t) and root.base.is_polynomial(t)):
            continue
        factor, parts = sp.Poly(root.base, t).sqf_list()
        q = sp.Mul(*(part.as_expr() ** (times // 2) for part, times in parts))
        signs = (signs_in_time(q, t, start, stop) or frozenset({-1, 1})) - {0}
        if all(times % 2 == 0 for _, times in parts) and factor.is_positive and len(signs) == 1:
            put[root] = sp.expand(sp.sqrt(factor) * q * next(iter(signs)))
    return f.xreplace(put)


def _with_parameters(f: sp.Expr, t: sp.Symbol, start: sp.Expr) -> frozenset[int] | None:
    known = {1: "positive", 0: "nonnegative"}.get(-1 if (sign := sign_of(start)) is None else sign, "real")
    time = sp.Dummy("t", **{known: True})
    found = possible_signs(f.xreplace({t: time}))
    return None if {1, -1} <= found else found


def _of_factors(f: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> set[int]:
    """The signs of a product; those of one that vanishes nowhere inside times those of the others."""
    found, mixed = {1}, []
    for factor in sp.Mul.make_args(sp.factor(f)):
        base, exponent = factor.as_base_exp()
        if not factor.has(t):
            found = {sign * (sign_of(factor) or 0) for sign in found}
            continue
        signs = _of_polynomial(base, t, start, stop) if base.is_polynomial(t) else _of_enclosures(base, t, start, stop)
        if exponent.is_Integer and exponent % 2 == 0:
            signs = {sign * sign for sign in signs}
        if exponent.could_extract_minus_sign() and 0 in signs:
            raise Open
        if {1, -1} <= signs:
            mixed.append(base)
        found = {a * b for a in found for b in signs}
    if len(mixed) > 1:
        raise Open
    return found


def _of_polynomial(p: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> set[int]:
    a, b = (sp.N(end, DIGITS) for end in (start, stop))
    tiny = sp.Float(10) ** -(DIGITS // 2) * (1 + abs(a) + abs(b))
    inside = [root for root in real_roots(p, t) if a - tiny <= sp.N(root, DIGITS) <= b + tiny]
    cuts = [a, *(sp.N(root, DIGITS) for root in inside), b]
    found = {0} if inside else set()
    for low, high in pairwise(cuts):
        if high - low > tiny:
            found.add(int(sp.sign(sp.N(p.subs(t, (low + high) / 2), DIGITS))))
    return found


def _of_enclosures(f: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> set[int]:
    """The signs of a function without zeros in the closed interval; both and zero where it has both inside."""
    at = enclosed(f, t)
    found: set[int] = set()
    for part in range(SAMPLES + 1):
        value = at(_enclosure(start) + (_enclosure(stop) - _enclosure(start)) * part / SAMPLES)
        found |= {1} if value > 0 else {-1} if value < 0 else set()
    whole = [iv.mpf([_enclosure(start).a, _enclosure(stop).b])]
    if {1, -1} <= found:
        return {1, 0, -1}
    for _ in range(HALVINGS):
        if not whole:
            return found
        piece = whole.pop()
        value = at(piece)
        if value > 0 or value < 0:
            found.add(1 if value > 0 else -1)
        else:
            middle = piece.mid
            whole += [iv.mpf([piece.a, middle.b]), iv.mpf([middle.a, piece.b])]
    raise Open


def enclosed(f: Any, t: sp.Symbol) -> Callable[[Any], Any]:
    """The function as one of intervals; raises Open for functions that are not known."""
    if f == t:
        return lambda x: x
    if f.is_number and not f.has(sp.I):
        value = _enclosure(f)
        return lambda _: value
    if isinstance(f, sp.sinh | sp.cosh | sp.tanh):
        return enclosed(f.rewrite(sp.exp), t)
    parts = [enclosed(part, t) for part in f.args]
    if f.is_Add or f.is_Mul:
        return lambda x: _joined((part(x) for part in parts), product=f.is_Mul)
    if isinstance(f, sp.Pow):
        return _power(f, parts[0])
    if f.func.__name__ not in FUNCTIONS:
        raise Open
    function = FUNCTIONS[f.func.__name__]
    return lambda x: function(parts[0](x))


def _joined(values: Iterator[Any], *, product: bool) -> Any:
    found = iv.mpf(1 if product else 0)
    for value in values:
        found = found * value if product else found + value
    return found


def _power(f: Any, base: Callable[[Any], Any]) -> Callable[[Any], Any]:
    if not f.exp.is_Rational:
        raise Open
    p, q = int(f.exp.p), int(f.exp.q)
    if q == 1:
        return lambda x: base(x) ** p
    return lambda x: _root(base(x), q) ** p


def _root(value: Any, q: int) -> Any:
    if value.a < 0:
        raise Open
    return iv.exp(iv.log(value) / q) if q != 2 else iv.sqrt(value)


def _enclosure(number: Any) -> Any:
    """An interval that holds a real number."""
    if number.is_Rational:
        return iv.mpf(int(number.p)) / int(number.q)
    value = sp.N(number, DIGITS)
    if not value.is_real:
        raise Open
    middle = mpmath.mpf(str(value))
    near = abs(middle) * mpmath.mpf(10) ** (3 - DIGITS)
    return iv.mpf([middle - near, middle + near])


def first_zero(u: sp.Expr, t: sp.Symbol, start: sp.Expr, until: sp.Expr) -> sp.Expr | None:
    """The first zero after the start of a function with u = 0, u' > 0 there, to 20 digits; None if none until then.

    Raises Open where the enclosures do not decide, as where the function only touches zero.
    """
    with _digits():
        return _walked(u, t, _enclosure(start), _enclosure(until))


def _walked(u: sp.Expr, t: sp.Symbol, low: Any, end: Any) -> sp.Expr | None:
    """Step by step, as long as the function rises from zero, or is positive."""
    at, slope = enclosed(u, t), enclosed(sp.diff(u, t), t)
    step = (end - low).b / 64
    rising = True
    for _ in range(HALVINGS):
        if low.a >= end.a:
            return None
        high = min(low.b + step, end.b)
        piece = iv.mpf([low.a, high])
        rising = rising and slope(piece) > 0
        if rising or at(piece) > 0:
            low, step = iv.mpf(high), step * 2
            continue
        if slope(piece) < 0 and at(iv.mpf(high)) < 0:
            return _bisected(u, t, low.b, high)
        step = step / 2
        if step < mpmath.mpf(10) ** -12:
            break
    raise Open


def _bisected(u: sp.Expr, t: sp.Symbol, low: Any, high: Any) -> sp.Expr:
    """The only zero in an interval over which the function falls."""
    with mpmath.workdps(2 * DIGITS):
        a, b = mpmath.mpf(low), mpmath.mpf(high)
        for _ in range(4 * DIGITS):
            middle = (a + b) / 2
            value = sp.N(u.subs(t, sp.Float(middle, 2 * DIGITS)), 2 * DIGITS)
            a, b = (middle, b) if value > 0 else (a, middle)
        return sp.Float((a + b) / 2, SHOWN)
