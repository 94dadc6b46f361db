"""Sampled plants: what is sampled, dead times in periods, factors, mapped roots, the periods of a rule."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.stated.algebra import difference, exponential, product, quotient, total
from solver.stated.complex_numbers import conjugate
from solver.stated.transforms import inverse_laplace


def of_pulse(
    found: Any, G: Any, s: Any, T: Any, *, held: bool, late: int = 0, ahead: Any = sp.S.Zero
) -> Iterator[Claim | Check]:
    """What is sampled is G, or G/s behind a hold; f is its function of time, the sum of those of the fractions."""
    t = sp.Symbol("t")
    whole = quotient(G, s) if held else G
    yield Claim(whole, found.image.whole)
    yield Claim(whole, total(*(each.fraction for each in found.terms)))
    yield Claim(inverse_laplace(found.image.whole, s, t), found.function)
    yield Claim(total(*(each.function for each in found.terms)), found.function)
    yield Check.that("the dead time", "compared", (found.late, found.ahead) == (late, ahead) and T != 0)


def of_dead_time_in_periods(found: Any, delay: Any, T: Any) -> Iterator[Claim | Check]:
    """l T − μT is the dead time, and 0 ≤ μ < 1."""
    if found is not None:
        late, ahead = found
        yield Claim(difference(product(late, T), product(ahead, T)), delay)
        yield Check.that("a part of a period", "compared", not ahead.is_negative and not (ahead - 1).is_nonnegative)


def of_two_factors(found: Any, G: Any, s: Any) -> Iterator[Claim | Check]:
    """Two factors of order one whose product is G."""
    if found is not None:
        yield Claim(product(*found), G)
        orders = [sp.degree(sp.denom(sp.together(each)), s) for each in found]
        yield Check.that("factors of order one", "counted", orders == [1, 1])


def of_factors_in_z(found: Any, poles: Any, T: Any) -> Iterator[Claim | Check]:
    """The product of the polynomials is that of z − e^{sT} over all poles."""
    z = sp.Symbol("z")
    below = [each.base.polynomial(z) for each in found for _ in range(each.multiplicity)]
    yield Claim(product(*below), product(*(difference(z, exponential(product(s, T))) for s in poles)))
    pairs = [each.pair for each in found]
    yield Check.that("pairs", "counted", pairs == [each.root.as_real_imag()[1] != 0 for each in found])


def of_longest_period(found: Any, roots: Any) -> Iterator[Claim | Check]:
    """|1 + Tλ| = 1 at the period found; each root is there, one for a pair."""
    listed = [root for root, _ in found]
    for root, limit in found:
        moved = total(1, product(limit, root.value))
        yield Claim(product(moved, conjugate(moved)), sp.S.One)
    alone = [root for root in roots if not any(_mirrors(root, each) for each in listed)]
    yield Check.that("each pole or its conjugate", "counted", not alone)


def _mirrors(root: Any, other: Any) -> bool:
    value = other.value
    return bool(root.value in (value, value.conjugate()) or sp.expand(root.value - value.conjugate()) == 0)


def of_matched(found: Any, G: Any, s: Any, T: Any) -> Iterator[Claim | Check]:
    """The poles and zeros are those of G, all zeros at infinity but one are counted, the order is that at s = 0."""
    above, below = (sp.Poly(side, s) for side in sp.fraction(sp.cancel(sp.together(G))))
    excess = below.degree() - above.degree()
    order = min(m for (m,) in below.monoms()) - min(m for (m,) in above.monoms())
    counted = (found.excess, found.at_minus_one, found.order) == (excess, max(excess - 1, 0), order)
    yield Check.that("zeros at infinity", "counted", counted and T != 0)
    for side, roots in ((below, found.poles), (above, found.zeros)):
        factors = [s - each for root in roots for each in _both(root) for _ in range(_times(root))]
        yield Claim(product(*factors), side.monic().as_expr() if side.degree() else sp.S.One)


def _both(root: Any) -> list[Any]:
    return [root.root] if root.mirror is None else [root.root, root.mirror]


def _times(root: Any) -> int:
    return int(root.multiplicity // (2 if root.pair and root.base.angle == 0 else 1))


def of_spectrum_of_polynomial(found: Any, p: Any) -> Iterator[Claim | Check]:
    """The product of x − λ over all roots is the polynomial, made monic."""
    x = p.gens[0]
    factors = [difference(x, root.value) for root in found.roots for _ in range(root.multiplicity)]
    if factors:
        yield Claim(product(*factors), p.monic().as_expr())
