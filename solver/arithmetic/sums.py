"""Convolution sums: the powers in them apart from constants, and what the sums of powers are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.matrices import entry_alone
from solver.stated.algebra import difference, power, product, quotient, total
from solver.stated.lists import summation

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@where_exact
def added_up(summand: ImmutableMatrix, i: Symbol, k: Symbol, value: ImmutableMatrix) -> tuple[Step, ...]:
    """Σ f(i), i = 0 … k − 1, of f(i) = Σ C λ^{k−1−i} μⁱ; none for another f, or where only ones are added up."""
    found = exact.geometric_terms(summand, i, k)
    if not found or all(a == b == 1 for a, b in found):
        return ()
    return tuple(_added_up(summand, found, (i, k), value))


@lemma("arithmetic/sums")
def _added_up(
    summand: ImmutableMatrix,
    found: dict[tuple[Expr, Expr], ImmutableMatrix],
    symbols: tuple[Symbol, Symbol],
    value: ImmutableMatrix,
) -> Derivation[None]:
    i, k = symbols
    constants = {bases: entry_alone(C) for bases, C in found.items()}
    powers = {(a, b): product(_power(a, difference(k - 1, i)), _power(b, i)) for a, b in found}
    sums = {bases: _sum(*bases, k) for bases in found}
    claims = {}
    if len(summand) > 1 or len(found) > 1:
        apart = total(*(product(powers[bases], C) for bases, C in constants.items()))
        claims["apart"] = Claim(entry_alone(summand), apart, "powers apart")
    for number, bases in enumerate(found, 1):
        stated = summation(powers[bases], i, sp.S.Zero, k - 1)
        claims[f"series{number}"] = Claim(stated, sums[bases], "geometric series")
    put_in = total(*(product(sums[bases], C) for bases, C in constants.items()))
    claims["sum"] = Claim(put_in, entry_alone(value), "series put in")
    same = any(a == b for a, b in found)
    yield Step("series", detail="tutor", claims=claims, i=i, k=k, count=len(found), same=same)


def _power(base: Any, exponent: Any) -> Any:
    return sp.S.One if base == 1 else power(base, exponent)


def _sum(a: Any, b: Any, k: Symbol) -> Any:
    """(λᵏ − μᵏ)/(λ − μ), of equal bases k λ^{k−1}; the difference below positive where it is a number."""
    if a == b:
        return product(k, _power(a, k - 1))
    if (a - b).is_negative:
        a, b = b, a
    above = difference(_power(a, k), _power(b, k))
    below = a - b
    return above if below == 1 else product(1 / below, above) if below.is_Rational else quotient(above, below)
