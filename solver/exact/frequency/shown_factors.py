"""Factors of numerators and denominators as a person writes them beside their angles."""

from __future__ import annotations

import sympy as sp

LARGE = 20
"""A linear factor with a coefficient beyond it is written with its time constant, where that is a short decimal."""
PLACES = 6


def shown_factor(factor: sp.Poly) -> sp.Poly:
    """A factor up to a number: whole coefficients, the first one positive; 21.5 s + 1 in place of 43 s + 2."""
    if not (factor.domain.is_QQ or factor.domain.is_ZZ):
        return factor if factor.LC() > 0 else -factor
    whole = factor.clear_denoms(convert=True)[1].primitive()[1]
    whole = whole if whole.LC() > 0 else -whole
    lead, constant = sp.Integer(whole.LC()), sp.Integer(whole.TC())
    if whole.degree() != 1 or constant <= 1 or max(lead, constant) <= LARGE or 10**PLACES % (lead / constant).q:
        return whole
    return sp.Poly({(1,): lead / constant, (0,): sp.S.One}, *whole.gens, domain=sp.QQ)
