"""Roots that no formula gives, searched in a box: in one unknown by intervals, in several by Newton's method.

In one unknown the box is divided until each piece is shown to hold no root (its image, or the derivative's, does not
hold zero) or exactly one: nothing is lost. In several, Newton's method starts from many points.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

import mpmath
import sympy as sp

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.modelling.evaluation import DIGITS, OutsideError, decimal, evaluator, vanishes

MAX_PIECES = 6_000
STARTS = 400
"""Points from which Newton's method starts, for each unknown."""
NARROW = 1e-9
SIMPLE = 1000
"""The largest denominator of a root that is tried as a rational number."""

Interval = tuple[Any, Any]


def roots_between(f: Any, x: sp.Symbol, low: Any, high: Any) -> tuple[list[Any], bool]:
    """Return the roots of f in [low, high] in rising order, and whether intervals prove that there are no others."""
    derivative = sp.diff(f, x)
    value, slope = evaluator(f, [x]), evaluator(derivative, [x])
    pieces: list[Interval] = [(mpmath.mpf(low), mpmath.mpf(high))]
    found, certain, count = [], True, 0
    while pieces:
        count += 1
        if count > MAX_PIECES:
            raise NotExact("solutions/too_many_roots", unknown=x)
        a, b = pieces.pop()
        if not _may_vanish(value, a, b):
            continue
        if not _may_vanish(slope, a, b):
            found += _between(value, slope, a, b)
        elif b - a > NARROW * max(1, abs(a), abs(b)):
            middle = a + (b - a) * mpmath.mpf("0.4871")  # hardly ever a root, as the middle often is
            pieces += [(a, middle), (middle, b)]
        else:
            touching = _touching(value, slope, a, b)
            found += touching
            certain = certain and (bool(touching) or not _finite(value, a, b))
    return [_simple(f, x, root) for root in _apart(found)], certain


def _may_vanish(function: Any, a: Any, b: Any) -> bool:
    try:
        image = function(mpmath.iv, [mpmath.iv.mpf([a, b])])
    except OutsideError:
        return False
    except (ZeroDivisionError, ValueError, OverflowError, TypeError):
        return True
    low, high = mpmath.mpf(image.a), mpmath.mpf(image.b)
    return not (low > 0 or high < 0)


def _finite(function: Any, a: Any, b: Any) -> bool:
    with mpmath.workdps(DIGITS):
        try:
            return all(abs(function(mpmath.mp, [end])) < 1 for end in (a, b))
        except (ZeroDivisionError, OverflowError):
            return False


def _between(function: Any, slope: Any, a: Any, b: Any) -> list[Any]:
    """The one root of a monotone function between a and b, if its sign changes there."""
    with mpmath.workdps(DIGITS + 10):
        at_a, at_b = (function(mpmath.mp, [end]) for end in (a, b))
        if isinstance(at_a, mpmath.mpc) or isinstance(at_b, mpmath.mpc):
            return []
        if at_a * at_b > 0:
            return []
        for end, value in ((a, at_a), (b, at_b)):
            if value == 0:
                return [mpmath.mpf(end)]
        return [_bracketed(function, slope, mpmath.mpf(a), mpmath.mpf(b), at_a)]


def _bracketed(function: Any, slope: Any, a: Any, b: Any, at_a: Any) -> Any:
    """Newton's method that never leaves the interval in which the sign changes; where it would, the middle is taken."""
    x, tiny = (a + b) / 2, mpmath.mpf(10) ** -DIGITS
    for _ in range(400):
        value = function(mpmath.mp, [x])
        if value == 0:
            return x
        if (value > 0) == (at_a > 0):
            a = x
        else:
            b = x
        rate = slope(mpmath.mp, [x])
        following = x - value / rate if rate else a
        following = following if a < following < b else (a + b) / 2
        if abs(following - x) <= tiny * (1 + abs(x)):
            return following
        x = following
    return x


def _touching(value: Any, slope: Any, a: Any, b: Any) -> list[Any]:
    """A root where the slope vanishes too."""
    with mpmath.workdps(DIGITS + 10):
        try:
            at = mpmath.findroot(lambda x: slope(mpmath.mp, [x]), (a, b), solver="secant", tol=0, verify=False)
            near = abs(at - (a + b) / 2) <= 2 * (b - a)
            return [at] if near and abs(value(mpmath.mp, [at])) < mpmath.mpf(10) ** (-DIGITS // 2) else []
        except (ZeroDivisionError, ValueError, OverflowError, TypeError):
            return []


def _apart(roots: Sequence[Any]) -> list[Any]:
    tiny = mpmath.mpf(10) ** -20
    ordered = sorted(roots)
    return [r for i, r in enumerate(ordered) if not i or abs(r - ordered[i - 1]) > tiny * (1 + abs(r))]


def _simple(f: Any, x: sp.Symbol, root: Any) -> Any:
    """The root as a rational number, or as such a multiple of π, where that is one."""
    with mpmath.workdps(DIGITS):
        for unit, size in ((sp.S.One, mpmath.mpf(1)), (sp.pi, +mpmath.pi)):
            near = Fraction(str(mpmath.nstr(root / size, 25))).limit_denominator(SIMPLE)
            if abs(root / size - mpmath.mpf(near.numerator) / near.denominator) < mpmath.mpf(10) ** -20:
                exact = sp.Rational(near.numerator, near.denominator) * unit
                if vanishes(f.xreplace({x: exact})):
                    return exact
        return decimal(root)


def newton_roots(functions: Sequence[Any], unknowns: Sequence[Any], box: Sequence[Interval]) -> list[list[Any]]:
    """Return the roots of n functions of n unknowns that Newton's method reaches from many points of the box."""
    values = [evaluator(f, unknowns) for f in functions]
    slopes = [[evaluator(sp.diff(f, x), unknowns) for x in unknowns] for f in functions]
    found: list[list[Any]] = []
    for start in _starts(box):
        near = _newton(mpmath.fp, values, slopes, start, 40, 1e-12)
        if near is None or any(_close(near, each, 1e-8) for each in found):
            continue
        with mpmath.workdps(DIGITS):
            at = _newton(mpmath.mp, values, slopes, [mpmath.mpf(v) for v in near], 60, mpmath.mpf(10) ** -50)
            inside = at is not None and all(a <= v <= b for v, (a, b) in zip(at, box, strict=True))
            if at is not None and inside and not any(_close(at, each, 1e-15) for each in found):
                found.append(at)
    return [[_exactly(functions, unknowns, at, i) for i in range(len(unknowns))] for at in sorted(found)]


def _exactly(functions: Sequence[Any], unknowns: Sequence[Any], at: Sequence[Any], i: int) -> Any:
    """A coordinate as a rational number where all of them are such and the functions vanish there."""
    near = [Fraction(str(mpmath.nstr(v, 25))).limit_denominator(SIMPLE) for v in at]
    put = {x: sp.Rational(q.numerator, q.denominator) for x, q in zip(unknowns, near, strict=True)}
    close = all(abs(v - mpmath.mpf(q.numerator) / q.denominator) < 1e-18 for v, q in zip(at, near, strict=True))
    if close and all(vanishes(f.xreplace(put)) for f in functions):
        return put[unknowns[i]]
    return decimal(at[i])


def _close(a: Sequence[Any], b: Sequence[Any], by: float) -> bool:
    return all(abs(x - y) <= by * (1 + abs(y)) for x, y in zip(a, b, strict=True))


def _starts(box: Sequence[Interval]) -> Iterator[list[float]]:
    """Points of the box that are spread evenly (Halton's), also of smaller boxes around its middle."""
    primes = (2, 3, 5, 7, 11, 13)
    for scale in (1.0, 0.1, 0.01):
        for i in range(1, STARTS * len(box) // 2):
            place = [_halton(i, primes[j]) - 0.5 for j in range(len(box))]
            yield [float((a + b) / 2 + (b - a) * p * scale) for p, (a, b) in zip(place, box, strict=True)]


def _halton(i: int, base: int) -> float:
    found, part = 0.0, 1.0
    while i:
        part /= base
        i, digit = divmod(i, base)
        found += part * digit
    return found


def _newton(ctx: Any, values: Any, slopes: Any, at: list[Any], steps: int, tolerance: Any) -> list[Any] | None:
    """Newton's method with numbers of one kind; None where it does not end in a root."""
    n = len(at)
    for _ in range(steps):
        try:
            f = [value(ctx, at) for value in values]
            J = [[slope(ctx, at) for slope in row] for row in slopes]
            step = _solved(J, f, n)
        except (ZeroDivisionError, OverflowError, ValueError, TypeError):
            return None
        if step is None or any(isinstance(v, complex | mpmath.mpc) or mpmath.isnan(v) for v in step):
            return None
        at = [v - s for v, s in zip(at, step, strict=True)]
        if max(abs(s) / (1 + abs(v)) for s, v in zip(step, at, strict=True)) < tolerance:
            return at
    return None


def _solved(J: Any, f: Any, n: int) -> list[Any] | None:
    """J⁻¹ f by elimination with pivots."""
    rows = [[*row, value] for row, value in zip(J, f, strict=True)]
    for j in range(n):
        pivot = max(range(j, n), key=lambda i: abs(rows[i][j]))
        if not rows[pivot][j]:
            return None
        rows[j], rows[pivot] = rows[pivot], rows[j]
        for i in range(n):
            if i != j:
                factor = rows[i][j] / rows[j][j]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[j], strict=True)]
    return [rows[i][n] / rows[i][i] for i in range(n)]
