"""Linear factors multiplied out: conjugate ones first, then one factor after the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.arithmetic.exactness import where_exact
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power, product, total
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@where_exact
def factors_multiplied(x: Symbol, roots: Sequence[Expr]) -> tuple[Step, ...]:
    """Π (x − root), multiplied out; nothing for two real roots, which need only a look."""
    if len(roots) < 3 and not any(root.has(sp.I) for root in roots):
        return ()
    return tuple(_factors_multiplied(x, roots))


@where_exact
def one_after_the_other(x: Symbol, factors: Sequence[Sequence[Expr]]) -> tuple[Step, ...]:
    """Polynomials in x, each by its coefficients from the highest power on, multiplied; none for less than three."""
    return tuple(_in_turn(x, factors)) if len(factors) > 2 or any(len(each) > 2 for each in factors[1:]) else ()


@lemma("arithmetic/factors")
def _in_turn(x: Symbol, factors: Sequence[Sequence[Expr]]) -> Derivation[None]:
    first, *others = factors
    yield _one_after_the_other(x, first, others)


@lemma("arithmetic/factors")
def _factors_multiplied(x: Symbol, roots: Sequence[Expr]) -> Derivation[None]:
    pairs, others = exact.conjugate_pairs(roots)
    quadratic = [exact.monic([sigma + sp.I * omega, sigma - sp.I * omega]) for sigma, omega in pairs]
    claims = {}
    for i, ((sigma, omega), factor) in enumerate(zip(pairs, quadratic, strict=True)):
        squares = total(power(x - sigma, 2), power(omega, 2))
        conjugate = product(x - sigma - sp.I * omega, x - sigma + sp.I * omega)
        claims[f"pair{i}"] = Claim(conjugate, squares, Phrase("conjugate factors"))
        claims[f"quadratic{i}"] = Claim(squares, exact.polynomial_in(x, factor), Phrase("conjugate factors"))
    if claims:
        yield Step("conjugate", detail="tutor", claims=claims, count=len(pairs))
    whole, *rest = [*quadratic, *(exact.monic([root]) for root in others)]
    if rest:
        yield _one_after_the_other(x, whole, rest)


def _one_after_the_other(x: Symbol, whole: Sequence[Expr], factors: Sequence[Sequence[Expr]]) -> Step:
    claims = {}
    for i, factor in enumerate(factors):
        terms = [
            a * b * x ** (len(whole) + len(factor) - 2 - j - k)
            for j, a in enumerate(whole)
            for k, b in enumerate(factor)
            if a != 0 and b != 0
        ]
        both = product(exact.polynomial_in(x, whole), exact.polynomial_in(x, factor))
        whole = _multiplied(whole, factor)
        claims[f"terms{i}"] = Claim(both, total(*terms), Phrase("factors multiplied out"))
        claims[f"collected{i}"] = Claim(total(*terms), exact.polynomial_in(x, whole), Phrase("by powers of {x}", x=x))
    return Step("multiplied", detail="tutor", claims=claims, count=len(factors), x=x)


def _multiplied(left: Sequence[Expr], right: Sequence[Expr]) -> tuple[Expr, ...]:
    """The coefficients of the product of two polynomials."""
    found = [sp.S.Zero] * (len(left) + len(right) - 1)
    for i, a in enumerate(left):
        for j, b in enumerate(right):
            found[i + j] += a * b
    return tuple(map(sp.expand, found))
