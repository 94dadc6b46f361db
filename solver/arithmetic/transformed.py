"""Partial fractions transformed back: a numerator over a quadratic split for cosine and sine, and the terms added."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.matrices import entries, entry_alone
from solver.stated.algebra import product, quotient, total

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol


LARGEST_DENOMINATOR = 10
"""1/(√3/2) is written as 2/√3, with a larger denominator it is left."""


@where_exact
def term_by_term(
    image: exact.RationalMatrix, x: Symbol, time: Symbol, value: ImmutableMatrix, *, discrete: bool
) -> tuple[Step, ...]:
    """How the function of time comes from the partial fractions in x (in discrete time: of the image divided by z)."""
    return tuple(_term_by_term(image, x, time, value, discrete=discrete))


@lemma("arithmetic/transformed")
def _term_by_term(
    image: exact.RationalMatrix, x: Symbol, time: Symbol, value: ImmutableMatrix, *, discrete: bool
) -> Derivation[None]:
    found = exact.transformed_fractions(image, x, time, discrete=discrete)
    for each in found:
        if each.fraction.slope is not None and (each.fraction.root.sigma != 0 or each.scale != 1):
            yield _split(each, x)
    terms = [product(function, C) for one in found for function, C in one.functions if any(entries(C))]
    if len(value) > 1 and len(terms) > 1:
        claim = Claim(total(*terms), value, "terms added entry by entry")
        yield Step("terms", detail="tutor", claims={"sum": claim})


def _split(found: exact.Transformed, x: Symbol) -> Step:
    """βx + γ = β(x − σ) + ((γ + βσ)/ω) ω."""
    fraction, sigma, omega = found.fraction, found.fraction.root.sigma, found.scale
    (_, beta), (_, rest) = [(function, entry_alone(C)) for function, C in found.functions]
    gamma: Any = entry_alone(fraction.constant)
    alone = not any(entries(found.functions[0][1]))
    above = gamma if sigma == 0 or alone else total(gamma, product(sigma, beta))
    claims = {} if alone else {"rest": Claim(_over(above, omega), rest, "the rest as a multiple")}
    terms = [] if alone else [product(x - sigma, beta)]
    split = total(*terms, product(omega, rest))
    claims["numerator"] = Claim(entry_alone(fraction.numerator), split, "numerator split")
    denominator = fraction.base**fraction.power
    return Step("split", detail="tutor", claims=claims, denominator=denominator, x=x, sigma=sigma, omega=omega)


def _over(above: Any, omega: Any) -> Any:
    """What stands above, divided by ω; with a small denominator of ω on top."""
    if omega == 1:
        return above
    over, under = omega.as_numer_denom()
    if over == 1:
        return product(under, above)
    small = under.is_Integer and under <= LARGEST_DENOMINATOR
    return product(quotient(under, over) if small else quotient(1, omega), above)
