"""Smith's form and the Smith–McMillan form, gcds of minors."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, pairwise
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.stated.algebra import product, quotient
from solver.stated.matrices import determinant, rank


def of_smith_form(found: Any, M: Any, x: Any) -> Iterator[Claim | Check]:
    """U M V is the form, U and V are unimodular, the factors are monic and each divides the next."""
    yield Check.that("the variable", "compared", found.variable == x)
    if found.left is not None:
        yield Claim(product(found.left, M, found.right), found.form)
    for unimodular in (found.left, found.right) if found.left is not None else ():
        constant = unimodular.subs(x, 0).det()
        yield Claim(determinant(unimodular), sp.cancel(constant))
        yield Check.that("a unimodular matrix", "compared", sp.cancel(constant) != 0)
    yield Claim(rank(M), sp.Integer(found.rank))
    yield from _divides_the_next([each.as_expr() for each in found.invariants], x)
    listed = [*found.invariant_factors]
    for factor, invariant in zip(listed, found.invariants, strict=False):
        yield Claim(invariant.as_expr(), factor)
    yield Check.that("zeros beyond the rank", "compared", not any(listed[found.rank :]))


def _divides_the_next(factors: list[Any], x: Any) -> Iterator[Check]:
    for each in factors:
        yield Check.that("a monic polynomial", "coefficients", sp.Poly(each, x).LC() == 1)
    for one, following in pairwise(factors):
        yield Check.that("each divides the next", "sympy.rem", sp.rem(following, one, x).equals(0) is True)


def of_smith_mcmillan(found: Any, G: Any) -> Iterator[Claim | Check]:
    """N/d is G, eᵢ/d is εᵢ/ψᵢ in lowest terms, εᵢ divides the next, ψᵢ is divided by it."""
    x, d = found.variable, found.denominator.as_expr()
    yield Claim(quotient(found.numerator, d), G.matrix)
    yield Claim(rank(found.numerator), sp.Integer(found.rank))
    yield from of_smith_form(found.smith, found.numerator, x)
    for e, (above, below) in zip(found.smith.invariants, found.fractions, strict=True):
        yield Claim(quotient(e.as_expr(), d), above.as_expr() / below.as_expr())
        yield Check.that("lowest terms", "sympy.gcd", above.gcd(below).degree() <= 0)
    yield from _divides_the_next([above.as_expr() for above, _ in found.fractions], x)
    yield from _divides_the_next([below.as_expr() for _, below in reversed(found.fractions)], x)
    for entry, (above, below) in zip(found.diagonal, found.fractions, strict=False):
        yield Claim(quotient(above.as_expr(), below.as_expr()), entry)
    yield Check.that("zeros beyond the rank", "compared", not any(found.diagonal[found.rank :]))
    parts = (([above for above, _ in found.fractions], found.zero_polynomial),
             ([below for _, below in found.fractions], found.pole_polynomial))  # fmt: skip
    for factors, whole in parts:
        if factors:
            yield Claim(product(*(each.as_expr() for each in factors)), whole.as_expr())


def of_determinantal_divisors(found: Any, M: Any, x: Any) -> Iterator[Claim | Check]:
    """As many as the rank; each is monic, divides all minors of its order and is their greatest common divisor."""
    yield Claim(rank(M), sp.Integer(len(found)))
    for k, d in enumerate(found, 1):
        minors = [
            sp.expand(M.extract(list(rows), list(columns)).det(method="berkowitz"))
            for rows in combinations(range(M.rows), k)
            for columns in combinations(range(M.cols), k)
        ]
        yield Check.that("a monic polynomial", "coefficients", d.LC() == 1)
        left = [sp.div(minor, d.as_expr(), x) for minor in minors]
        yield Check.that("it divides all minors", "sympy.div", all(rest.equals(0) is True for _, rest in left))
        common = sp.gcd_list([each for each, _ in left])
        yield Check.that("no more is common to them", "sympy.gcd", not common.has(x))
