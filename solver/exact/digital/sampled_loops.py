"""Loops around a sampled plant: polynomials in z whose coefficients hold exponentials of the sampling period."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce

import sympy as sp
from sympy import prime

from solver.exact.digital.fractions import FractionInZ, content_of, marks_of
from solver.exact.transforms.sampled import Base, Coefficients, added, in_z, multiplied, powered, trimmed

Pair = tuple[Coefficients, Coefficients]
"""Numerator and denominator, the highest power first."""


@dataclass(frozen=True)
class SampledLoop:
    """`above` over `below`, multiplied out with what cancels, and the same in lowest terms as it is shown."""

    above: sp.Expr
    below: sp.Expr
    whole: sp.Expr


def in_series_in_z(C: sp.Expr, G: FractionInZ, z: sp.Symbol) -> SampledLoop:
    """C(z) G(z)."""
    (c, d), (p, q) = _pair(C, z), (_above(G), G.denominator)
    return _loop(multiplied(c, p), multiplied(d, q), z)


def closed_in_z(C: sp.Expr, G: FractionInZ, H: sp.Expr | FractionInZ, z: sp.Symbol) -> SampledLoop:
    """C G/(1 + C G H) with H in z, or C G/(1 + C GH), where the product GH was sampled as a whole."""
    c, d = _pair(C, z)
    p, q = _above(G), G.denominator
    if not isinstance(H, FractionInZ):
        h, k = _pair(H, z)
        above = reduce(multiplied, (c, p, k))
        return _loop(above, added(reduce(multiplied, (d, q, k)), reduce(multiplied, (c, p, h))), z)
    r, shared = _above(H), dict(G.poles)
    rest = [(base, m - shared.get(base, 0)) for base, m in H.poles]
    extra = _product([(base, m) for base, m in rest if m > 0])
    missing = {base: -m for base, m in rest if m < 0} | {b: m for b, m in G.poles if b not in dict(H.poles)}
    lacking = _product([*missing.items()])
    above = reduce(multiplied, (c, p, extra))
    inner = added(multiplied(d, H.denominator), multiplied(c, r))
    return _loop(above, multiplied(inner, lacking), z)


def _product(powers: Sequence[tuple[Base, int]]) -> Coefficients:
    """The product of powers of the polynomials of some bases."""
    one: Coefficients = [sp.S.One]
    return reduce(multiplied, [powered(base.coefficients, m) for base, m in powers], one)


def _above(G: FractionInZ) -> Coefficients:
    return [*G.numerator]


def _pair(element: sp.Expr, z: sp.Symbol) -> Pair:
    """The coefficients of a quotient of polynomials."""
    above, below = (sp.Poly(side, z).all_coeffs() for side in sp.fraction(sp.together(element)))
    return above, below


def _loop(above: Coefficients, below: Coefficients, z: sp.Symbol) -> SampledLoop:
    above, below = trimmed(above), trimmed(below)
    return SampledLoop(in_z(above, z), in_z(below, z), _lowest(above, below, z))


def _lowest(above: Coefficients, below: Coefficients, z: sp.Symbol) -> sp.Expr:
    """The quotient without common factors, exponentials taken for independent; monic below where it can be."""
    if not above:
        return sp.S.Zero
    if not any(c.has(sp.Float) for c in (*above, *below)):
        marks = marks_of([*above, *below])
        back = {dummy: each for each, dummy in marks.items()}
        p, q = (sp.Poly(in_z([c.xreplace(marks) for c in side], z), z) for side in (above, below))
        shared = p.gcd(q) if _may_share(p, q) else sp.Poly(1, z)
        above, below = ([c.xreplace(back) for c in _quotient(side, shared)] for side in (p, q))
    (common, above), (scale, below) = content_of(above), content_of(below)
    lead = below[0] if below[0].is_number else sp.S.One
    below = [sp.expand(c / lead, power_exp=False) for c in below]
    return sp.Mul(common / scale / lead, in_z(above, z), 1 / in_z(below, z))


def _may_share(p: sp.Poly, q: sp.Poly) -> bool:
    """Whether two polynomials may have a common root: not where they have none for some values of the symbols."""
    symbols = sorted(p.free_symbols_in_domain | q.free_symbols_in_domain, key=str)
    values = {x: sp.Rational(prime(i + 5), prime(i + 12)) for i, x in enumerate(symbols)}
    one, other = (sp.Poly(side.as_expr().xreplace(values), *side.gens, extension=True) for side in (p, q))
    if one.degree() < p.degree() or other.degree() < q.degree():
        return True
    return bool(one.gcd(other).degree() > 0)


def _quotient(p: sp.Poly, shared: sp.Poly) -> Sequence[sp.Expr]:
    found: Sequence[sp.Expr] = p.quo(shared).all_coeffs() if shared.degree() > 0 else p.all_coeffs()
    return found
