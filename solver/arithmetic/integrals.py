"""Definite integrals: products of sines and cosines as sums, the antiderivative of each term, the limits put in."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.values import put_in
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.matrices import entry_alone
from solver.stated.algebra import difference
from solver.stated.calculus import derivative, value_at

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol


@where_exact
def integrated(
    integrand: ImmutableMatrix, x: Symbol, lower: Any, upper: Any, value: ImmutableMatrix, stated: Any = None
) -> tuple[Step, ...]:
    """∫ f dx = F(upper) − F(lower) = value; none where f has terms that a table of integrals does not have.

    `stated` is f as the page has it, where that has to be multiplied out first.
    """
    found = exact.antiderivative(integrand, x)
    return () if found is None else tuple(_integrated(integrand, found, x, (lower, upper), value, stated))


@lemma("arithmetic/integrals")
def _integrated(
    integrand: ImmutableMatrix,
    found: exact.Antiderivative,
    x: Symbol,
    limits: tuple[Any, Any],
    value: ImmutableMatrix,
    stated: Any,
) -> Derivation[None]:
    terms, F = entry_alone(found.integrand), entry_alone(found.function)
    lower, upper = limits
    claims = {}
    if found.integrand != integrand or stated is not None:
        left = entry_alone(integrand) if stated is None else stated
        claims["terms"] = Claim(left, terms, "the integrand as a sum")
    at_upper, at_lower = put_in(F, x, upper), put_in(F, x, lower)
    at_limits = at_upper if at_lower in (0, sp.zeros(*integrand.shape)) else difference(at_upper, at_lower)
    claims |= {
        "antiderivative": Claim(derivative(F, x), terms, "derivative of the antiderivative"),
        "limits": Claim(difference(value_at(F, x, upper), value_at(F, x, lower)), at_limits, "limits put in"),
    }
    known = isinstance(at_upper, sp.Expr) and isinstance(at_lower, sp.Expr)
    if not known or at_upper - at_lower != entry_alone(value):
        claims["value"] = Claim(at_limits, entry_alone(value), "worked out")
    yield Step("integral", detail="tutor", claims=claims, F=F, x=x, lower=lower, upper=upper)
