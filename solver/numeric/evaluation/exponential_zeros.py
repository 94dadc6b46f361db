"""The real zeros of exponential polynomials: sums of c xⁿ e^{ax} with real c and a.

Between two zeros the derivative has one (Rolle). So the zeros are found from those of the derivatives that are left
when one exponent after the other is divided off and differentiated away.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import mpmath
import sympy as sp

from solver.numeric.evaluation.values import NotEvaluable

Terms = dict[sp.Rational, list[Any]]
"""By each exponent a the coefficients of its polynomial, the lowest power first."""

FARTHEST = 2**12
"""No zeros are sought beyond."""


def exponential_zeros(f: Any, x: Any, digits: int) -> list[Any]:
    """Return the distinct real zeros of f in x, rising, as sympy's numbers of so many digits.

    f is a sum of products of numbers, powers of x and exponentials of a x + b, a rational. Raises NotEvaluable.
    """
    context = mpmath.mp.clone()
    context.dps = 2 * digits
    terms = _terms(f, x, digits, context)
    return [sp.Float(str(zero), digits) for zero in _zeros(terms, context)]


def _terms(f: Any, x: Any, digits: int, context: Any) -> Terms:
    found: Terms = {}
    for term in sp.Add.make_args(sp.expand(f)):
        rest, below = sp.expand(term, power_exp=True).as_independent(x)
        power, exponent = 0, sp.Integer(0)
        for factor in sp.Mul.make_args(below):
            base, n = factor.as_base_exp()
            if factor == 1:
                continue
            if base == x and n.is_Integer and n > 0:
                power += int(n)
            elif isinstance(factor, sp.exp) and (factor.args[0] / x).is_Rational:
                exponent += factor.args[0] / x
            else:
                raise NotEvaluable("an expression is no sum of powers and exponentials")
        value = sp.N(rest, 2 * digits)
        if not value.is_Float and not value.is_Integer:
            raise NotEvaluable("an expression is no sum of powers and exponentials")
        listed = found.setdefault(exponent, [])
        listed += [context.mpf(0)] * (power + 1 - len(listed))
        listed[power] += context.mpf(sp.Float(value, 2 * digits)._to_mpmath(context.prec))
    return _without_zeros(found)


def _without_zeros(terms: Mapping[sp.Rational, Sequence[Any]]) -> Terms:
    """The terms without zeros above and without polynomials that are zero."""
    kept: Terms = {}
    for a, listed in terms.items():
        coefficients = list(listed)
        while coefficients and coefficients[-1] == 0:
            coefficients.pop()
        if coefficients:
            kept[a] = coefficients
    return kept


def _derivative(terms: Terms, context: Any) -> Terms:
    """(p e^{ax})' = (p' + a p) e^{ax}."""
    slopes: dict[sp.Rational, list[Any]] = {}
    for a, p in terms.items():
        factor = context.mpf(a.p) / a.q
        slopes[a] = [factor * c + (i + 1) * (p[i + 1] if i + 1 < len(p) else 0) for i, c in enumerate(p)]
    return _without_zeros(slopes)


def _zeros(terms: Terms, context: Any) -> list[Any]:
    """The real zeros, rising; none of a function that is zero everywhere."""
    if not terms:
        return []
    least = min(terms)
    terms = {a - least: p for a, p in terms.items()}
    if len(terms) == 1 and len(terms[sp.Integer(0)]) == 1:
        return []
    slope = _derivative(terms, context)
    return list(_between(terms, _zeros(slope, context), context))


def _between(terms: Terms, turning: Sequence[Any], context: Any) -> Iterator[Any]:
    """The zeros of a function that is monotone between these places and beyond them."""
    ends = [turning[0] if turning else context.mpf(0), turning[-1] if turning else context.mpf(0)]
    places = [_outward(terms, ends[0], -1, context), *turning, _outward(terms, ends[1], 1, context)]
    signs = [_sign(terms, place, context) for place in places]
    for i, (place, sign) in enumerate(zip(places, signs, strict=True)):
        if sign == 0:
            yield place
        elif i + 1 < len(places) and sign * signs[i + 1] < 0:
            yield _bisected(terms, place, places[i + 1], sign, context)


def _sign(terms: Terms, x: Any, context: Any) -> int:
    """The sign of the function; zero where its terms cancel to half the digits."""
    values = [c * x**i * context.exp(context.mpf(a.p) / a.q * x) for a, p in terms.items() for i, c in enumerate(p)]
    value, size = context.fsum(values), context.fsum(values, absolute=True)
    return 0 if abs(value) <= size * context.mpf(10) ** (-context.dps // 2) else int(context.sign(value))


def _outward(terms: Terms, start: Any, direction: int, context: Any) -> Any:
    """A place on this side of the last turning point beyond which the sign is that of the leading term."""
    a = max(terms) if direction > 0 else min(terms)
    degree = len(terms[a]) - 1
    wanted = int(context.sign(terms[a][-1])) * (direction**degree)
    step = context.mpf(1)
    while _sign(terms, start + direction * step, context) != wanted:
        step *= 2
        if step > FARTHEST:
            raise NotEvaluable("a zero of exponentials lies too far away")
    return start + direction * step


def _bisected(terms: Terms, low: Any, high: Any, sign: int, context: Any) -> Any:
    """The zero between two places of which the function has this sign at the first and the other at the second."""
    for _ in range(context.prec):
        middle = (low + high) / 2
        found = _sign(terms, middle, context)
        if found == 0:
            return middle
        low, high = (middle, high) if found == sign else (low, middle)
    return (low + high) / 2
