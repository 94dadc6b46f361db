"""Quotients of exponential sums in the form shown: common factors cancelled, hyperbolic where that is shorter."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.radicals import over_rational
from solver.exact.linear_algebra.signs import is_positive
from solver.exact.variations.exponential_sums import ExponentialSum, Mode, tidied
from solver.symbols import TIME

MOST_TERMS, MOST_WITH_ROOTS = 60, 12
"""Common factors of longer sums are not looked for; nor of these, where they hold roots."""


def quotient(
    numerator: ExponentialSum, denominator: ExponentialSum, *, reduce_: bool = True, rising: bool = False
) -> sp.Expr:
    """Return N/D written out, without common factors if they are to be looked for (`reduce_`).

    Exponentials decay where they can; if `rising`, the smallest one of D is 1.
    """
    if not numerator:
        return sp.S.Zero
    if reduce_ and len(denominator.terms) > 1:
        numerator, denominator = _reduced(numerator, denominator)
    if len(denominator.terms) == 1 and denominator.terms[0][0].angle == 0:
        return _written(_divided(numerator, *denominator.terms[0]))
    if _is_shorter_hyperbolic(numerator, denominator):
        above, below = _hyperbolic(numerator), _hyperbolic(denominator)
    else:
        shift = _shift(denominator, rising=rising)
        above, below = (_terms(part.shifted(shift)) for part in (numerator, denominator))
    return _over(*_without_content(above, below))


def _divided(numerator: ExponentialSum, mode: Mode, c: sp.Expr) -> ExponentialSum:
    """N over one term without a wave."""
    inverse = sp.S.One / c if c.is_Rational else over_rational(1 / c) if not c.free_symbols else 1 / c
    moved = ((m._replace(monomial=m.monomial / mode.monomial), a * inverse) for m, a in numerator.terms)
    return ExponentialSum.of(moved).shifted(-mode.exponent)


def _reduced(N: ExponentialSum, D: ExponentialSum) -> tuple[ExponentialSum, ExponentialSum]:
    """N and D without the factors that they share, where there are no waves; exponentials are powers of generators."""
    modes = [mode for part in (N, D) for mode, _ in part.terms]
    rooted = any(c.has(sp.Pow) for part in (N, D) for mode, c in part.terms if c.is_number)
    if any(mode.angle != 0 for mode in modes) or len(modes) > (MOST_WITH_ROOTS if rooted else MOST_TERMS):
        return N, D
    exponents = [_rational_parts(mode.exponent) for mode in modes]
    bases = list(dict.fromkeys(base for each in exponents for base in each))
    if any(base.has(sp.Float) for base in bases):
        return N, D
    shares = [[each.get(base, sp.S.Zero) for each in exponents] for base in bases]
    least = [min(each) for each in shares]
    common = [reduce(sp.lcm, map(sp.denom, each), sp.S.One) for each in shares]
    marks = [sp.Dummy(f"e{i}") for i in range(len(bases))]
    times = sorted({s for mode in modes for s in mode.monomial.free_symbols}, key=str)

    def power(X: sp.Expr) -> sp.Expr:
        parts = _rational_parts(X)
        spots = zip(marks, bases, least, common, strict=True)
        return sp.Mul(*(e ** ((parts.get(base, sp.S.Zero) - low) * scale) for e, base, low, scale in spots))

    def polynomial(part: ExponentialSum) -> sp.Expr:
        return sp.Add(*(c * mode.monomial * power(mode.exponent) for mode, c in part.terms))

    unknowns = (*marks, *times)
    if not unknowns:
        return N, D
    try:
        first, second = (sp.Poly(polynomial(part), *unknowns, extension=True) for part in (N, D))
        factor, above, below = first.cancel(second)
    except (sp.PolynomialError, sp.CoercionFailed, NotImplementedError):  # powers below one, roots of parameters
        return N, D
    if below.degree_list() == second.degree_list():
        return N, D

    def back(poly: Any) -> ExponentialSum:
        terms = []
        for powers, c in poly.terms():
            parts = zip(bases, powers, common, strict=False)
            exponent = sp.expand(sp.Add(*(base * sp.Rational(k, scale) for base, k, scale in parts)))
            monomial = sp.Mul(*(s**k for s, k in zip(times, powers[len(marks) :], strict=True)))
            terms.append((Mode(monomial, exponent, sp.S.Zero, False), c))
        return ExponentialSum.of(terms)

    return back(above).times(sp.S.Zero + factor), back(below)


def _rational_parts(X: sp.Expr) -> dict[sp.Expr, sp.Expr]:
    """A sum as rational multiples of other expressions: √5 τ/2 − τ as {√5 τ: 1/2, τ: −1}."""
    pairs = (term.as_coeff_Mul() for term in sp.Add.make_args(X))
    return {base: c for c, base in pairs if c != 0}


def _without_content(above: Terms, below: Terms) -> tuple[Terms, Terms]:
    """Both sums times one number, such that the coefficients have no denominators and share no factor."""
    coefficients = [c for c, _ in (*above, *below)]
    lead = below[0][0]
    if any(c.has(sp.Float) for c in coefficients):
        return _scaled(above, 1 / lead), _scaled(below, 1 / lead)
    if any(c.free_symbols for c in coefficients):
        return tuple(_scaled(part, _cleared(coefficients, lead)) for part in (above, below))  # type: ignore[return-value]
    if not lead.is_Rational and all(tidied(over_rational(c / lead)).is_Rational for c, _ in below):
        above, below = (_scaled(part, over_rational(1 / lead)) for part in (above, below))
    rational = [r for c, _ in (*above, *below) for r in c.as_coefficients_dict().values()]
    content = reduce(sp.gcd, map(abs, rational))
    negative = all(c.could_extract_minus_sign() for c, _ in below)
    return tuple(_scaled(part, (-1 if negative else 1) / content) for part in (above, below))  # type: ignore[return-value]


def _scaled(terms: Terms, factor: sp.Expr) -> Terms:
    return [(tidied(c * factor), f) for c, f in terms]


def _cleared(coefficients: Sequence[sp.Expr], lead: sp.Expr) -> sp.Expr:
    """The factor that takes the denominators of coefficients with symbols away, and what all of them share."""
    below = reduce(sp.lcm, (sp.fraction(sp.together(c))[1] for c in coefficients))
    shared = reduce(sp.gcd, (sp.cancel(c * below) for c in coefficients))
    scale: sp.Expr = below / shared
    return -scale if tidied(lead * scale).could_extract_minus_sign() else scale


def _rate(mode: Mode) -> sp.Expr:
    """How fast an exponential grows: its exponent with the times put to one."""
    symbols: set[Any] = mode.exponent.free_symbols
    return mode.exponent.xreplace({s: sp.S.One for s in symbols if s.name in {*TIME, "T"}})


def _falls(mode: Mode) -> bool:
    """Whether an exponential decays; where that is open, whether it is written with a minus."""
    rate = _rate(mode)
    return is_positive(-rate) or (not is_positive(rate) and mode.exponent.could_extract_minus_sign())


def _shift(D: ExponentialSum, *, rising: bool) -> sp.Expr:
    """What the exponents are to be lessened by, so that the largest of D (if `rising`: the least) is 0."""
    found = D.terms[0][0]
    for mode, _ in D.terms[1:]:
        gap = _rate(mode) - _rate(found)
        if is_positive(-gap if rising else gap):
            found = mode
    return -found.exponent


def _is_shorter_hyperbolic(N: ExponentialSum, D: ExponentialSum) -> bool:
    """Whether all exponentials come in pairs e^{±X} of which cosh and sinh make fewer terms, or symbols are left."""
    pairs = [_pairs(part) for part in (N, D)]
    if any(pair is None for pair in pairs):
        return False
    shown = sum(_length(c) for pair in pairs if pair for both in pair.values() for c in both if c != 0)
    there = sum(_length(c) for part in (N, D) for _, c in part.terms)
    rates = [_rate(mode) for mode, _ in D.terms]
    if all(rate.is_Rational for rate in rates):  # e^{−4τ} is what the integration of a scalar equation gives
        return shown + 1 < there
    return shown < there or (shown == there and any(rate.free_symbols for rate in rates))


def _length(c: sp.Expr) -> int:
    """How much a reader has to read of a coefficient: a sum counts twice."""
    return 2 if c.is_Add else 1


Terms = list[tuple[sp.Expr, sp.Expr]]
"""Coefficients with the functions that they belong to."""
Pairs = dict[Mode, tuple[sp.Expr, sp.Expr]]


def _pairs(part: ExponentialSum) -> Pairs | None:
    """The coefficients of cosh X and sinh X by modes with the exponent X (zero: the term alone); None without pairs."""
    terms = dict(part.terms)
    found: Pairs = {}
    for mode, c in part.terms:
        if mode in found:
            continue
        if mode.exponent == 0:
            found[mode] = (c, sp.S.Zero)
            continue
        turned = mode._replace(exponent=sp.expand(-mode.exponent))
        if turned in found:
            continue
        if turned not in terms:
            return None
        upper, lower = (turned, mode) if _falls(mode) else (mode, turned)
        found[upper] = (tidied(terms[upper] + terms[lower]), tidied(terms[upper] - terms[lower]))
    return found


def _hyperbolic(part: ExponentialSum) -> Terms:
    """The coefficients and functions with cosh and sinh for pairs of exponentials."""
    found = []
    for mode, (even, odd) in (_pairs(part) or {}).items():
        X = collected_exponent(mode.exponent)
        rest = mode._replace(exponent=sp.S.Zero).expression
        if mode.exponent == 0:
            found.append((even, rest))
            continue
        found += [(c, f * rest) for c, f in ((even, sp.cosh(X)), (odd, sp.sinh(X))) if c != 0]
    return found


def _terms(part: ExponentialSum) -> Terms:
    return [(c, mode._replace(exponent=collected_exponent(mode.exponent)).expression) for mode, c in part.terms]


def collected_exponent(X: sp.Expr) -> sp.Expr:
    """√5 τ − τ as (√5 − 1) τ."""
    return sp.collect(X, sorted(X.free_symbols, key=str)) if X.is_Add else X


def _written(part: ExponentialSum) -> sp.Expr:
    """A sum alone, hyperbolic where that is shorter."""
    pairs = _pairs(part)
    if pairs is not None and sum(c != 0 for both in pairs.values() for c in both) < len(part.terms):
        return sp.Add(*(c * f for c, f in _hyperbolic(part)))
    return sp.Add(*(c * f for c, f in _terms(part)))


def _over(above: Terms, below: Terms) -> sp.Expr:
    """The fraction, with the factor that all terms above share before it; sinh over cosh is tanh."""
    if len(above) == 1 and len(below) == 1:
        (c, f), (d, g) = above[0], below[0]
        if isinstance(f, sp.sinh) and g == sp.cosh(f.args[0]):
            return tidied(over_rational(c / d)) * sp.tanh(f.args[0])
    shared = common_factor([c for c, _ in above])
    divided = ((c / shared if shared.free_symbols else over_rational(c / shared), f) for c, f in above)
    numerator = _sum([(tidied(c), f) for c, f in divided]) if shared != 1 else _sum(above)
    found: sp.Expr = sp.Mul(shared, numerator, sp.Pow(_sum(below), -1))
    return found


def _sum(terms: Terms) -> sp.Expr:
    return sp.Add(*(c * f for c, f in terms))


def common_factor(coefficients: Sequence[sp.Expr]) -> sp.Expr:
    """A number that all coefficients are whole multiples of, or a root; 1 where symbols are left."""
    lead = coefficients[0]
    if len(coefficients) == 1 or any(c.has(sp.Float) for c in coefficients):
        return sp.S.One
    if any(c.free_symbols for c in coefficients):
        shared = reduce(sp.gcd, coefficients)
        return shared if shared.free_symbols and not shared.is_Add else sp.S.One
    ratios = [tidied(over_rational(c / lead)) for c in coefficients]
    if not all(r.is_Rational for r in ratios):
        return sp.S.One
    found = lead * reduce(sp.gcd, map(abs, ratios))
    found = -found if found.could_extract_minus_sign() else found
    if all((c / found).could_extract_minus_sign() for c in coefficients):
        found = -found
    return tidied(found)
