"""The Smith–McMillan form of a transfer matrix: Smith's form over the common denominator, cancelled."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.stated.algebra import quotient
from solver.tasks.multivariable.smith import smith_form_of
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr


@lemma("smith_mcmillan")
def smith_mcmillan_of(G: exact.TransferMatrix) -> Derivation[exact.SmithMcMillan]:
    """G = N/d in lowest terms, Smith's form of N, its entries divided by d and cancelled."""
    found = exact.smith_mcmillan(G)
    x, d, N = found.variable, exact.in_factors(found.denominator), found.numerator
    one = found.denominator.degree() == 0
    over = N if one else quotient(N, d)
    yield Step(
        "common_denominator",
        claims={"over": Claim(over, G.matrix, Phrase("the common denominator"))},
        x=x, d=d, N=N, G=G.matrix, one=one,
    )  # fmt: skip
    if found.rank:
        yield from smith_form_of(N, x, "N", found.smith)
        yield _divided(found, d)
    yield Step(
        "form",
        unclaimed="the entries found above",
        x=x,
        form=found.form,
        rank=found.rank,
        most=min(found.shape),
        poles=exact.in_factors(found.pole_polynomial),
        zeros=exact.in_factors(found.zero_polynomial),
        shared=exact.in_factors(found.pole_polynomial.gcd(found.zero_polynomial).monic()),
        exceptions=found.exceptions,
        general=found.smith.is_general,
    )
    return found


def _divided(found: exact.SmithMcMillan, d: Expr) -> Step:
    """Each eᵢ/d in lowest terms."""
    claims = {}
    invariants = [exact.in_factors(e) for e in found.smith.invariants]
    for i, e in enumerate(invariants, 1):
        stated = quotient(e, d) if d != 1 else e
        claims[f"entry{i}"] = Claim(stated, found.diagonal[i - 1], Phrase("an entry in lowest terms"))
    fractions = [tuple(map(exact.in_factors, pair)) for pair in found.fractions]
    return Step("divided", claims=claims, x=found.variable, d=d, invariants=invariants, fractions=fractions)
