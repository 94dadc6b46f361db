"""Fractions brought to a common denominator: each numerator times what its denominator lacks, and their sum."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.arithmetic.exactness import where_exact
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol

LONG = 12
"""A sum of more terms is not written out."""


@where_exact
def brought_together(fractions: Sequence[Expr], x: Symbol) -> tuple[Step, ...]:
    """The numerator of a sum of fractions in x, whose denominators stand in factors; none for a single fraction."""
    parts = [sp.fraction(each) for each in fractions]
    powers: dict[Expr, int] = {}
    for _, below in parts:
        for factor, times in _factors(below, x).items():
            powers[factor] = max(powers.get(factor, 0), times)
    if len(parts) < 2 or not powers:
        return ()
    return tuple(_brought_together(parts, powers, x))


@lemma("arithmetic/denominators")
def _brought_together(parts: Sequence[tuple[Expr, Expr]], powers: dict[Expr, int], x: Symbol) -> Derivation[None]:
    common = sp.Mul(*(factor**times for factor, times in powers.items()))
    terms, values = [], []
    for above, below in parts:
        own = _factors(below, x)
        number = sp.Mul(*(each for each in sp.Mul.make_args(below) if not each.has(x)))
        lacking = [factor ** (times - own.get(factor, 0)) for factor, times in powers.items()]
        factors = [each for each in (above / number, *lacking) if each != 1]
        terms.append(product(*factors) if factors else sp.S.One)
        values.append(exact.multiplied_out(sp.Mul(above / number, *lacking), x))
    whole = exact.multiplied_out(sp.Add(*values), x)
    if sum(len(sp.Add.make_args(each)) for each in values) > LONG:
        return
    claims = {"terms": Claim(total(*terms), total(*values), Phrase("each times what it lacks"))}
    if len(sp.Add.make_args(whole)) < sum(len(sp.Add.make_args(each)) for each in values):
        claims["sum"] = Claim(total(*values), whole, Phrase("the numerators added"))
    yield Step("numerator", detail="tutor", claims=claims, common=common)


def _factors(below: Expr, x: Symbol) -> dict[Expr, int]:
    """The factors that hold x, with how often they occur."""
    found: dict[Expr, int] = {}
    for each in sp.Mul.make_args(below):
        base, times = each.as_base_exp()
        if base.has(x):
            found[base] = found.get(base, 0) + int(times)
    return found
