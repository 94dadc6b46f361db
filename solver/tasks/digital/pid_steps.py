"""Lemma: a PID controller with its integral and derivative replaced, in position form and in velocity form."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, quotient, total
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@lemma("pid_in_z")
def sampled_pid(gains: exact.Gains, T: Expr, rule: str, z: Symbol) -> Derivation[exact.DiscretePid]:
    """The law, what takes the place of integral and derivative, u(k) by its terms, and from the value before it."""
    found = exact.discrete_pid(gains, T, rule, z)
    facts: dict[str, Any] = {"gains": gains, "T": T, "z": z, "rule": rule}
    yield Step("law", unclaimed="as given", **facts)
    new, old = found.weights
    if gains.K_i != 0:
        late = [product(old, power(z, -1))] if old != 0 else []
        stated = quotient(total(*([new] if new != 0 else []), *late), difference(sp.Integer(1), power(z, -1)))
        yield Step("integral", claims={"I": Claim(stated, found.integral, "the integral in z")}, **facts)
    if gains.K_d != 0:
        stated = quotient(difference(sp.Integer(1), power(z, -1)), T)
        yield Step("derivative", claims={"d": Claim(stated, found.derivative, "the derivative in z")}, **facts)
    yield _position(gains, found, facts)
    yield _velocity(gains, found, facts)
    return found


def _position(gains: exact.Gains, found: exact.DiscretePid, facts: dict[str, Any]) -> Step:
    """The sum of the three terms."""
    parts: list[Any] = [gains.K_p] if gains.K_p != 0 else []
    acted = ((gains.K_i, found.integral), (gains.K_d, found.derivative))
    parts += [product(gain, part) for gain, part in acted if gain != 0]
    claim = Claim(total(*parts), found.controller, "the controller")
    return Step("position", claims={"D": claim}, single=len(parts) == 1, **facts)


def _velocity(gains: exact.Gains, found: exact.DiscretePid, facts: dict[str, Any]) -> Step:
    """The difference of two values of u: its coefficients, and the same controller in z⁻¹."""
    (K_p, K_i, K_d), (new, old), T = gains, found.weights, facts["T"]
    slope: Any = quotient(K_d, T) if K_d != 0 else 0
    areas: list[Any] = [product(K_i, weight) if K_i * weight != 0 else 0 for weight in (new, old)]
    twice: Any = product(sp.Integer(-2), slope) if K_d != 0 else 0
    terms = [[K_p, areas[0], slope], [-K_p, areas[1], twice], [slope]]
    claims: dict[str, Claim] = {}
    for i, (listed, each) in enumerate(zip(terms, found.coefficients, strict=True)):
        kept = [term for term in listed if term != 0]
        claims[f"q{i}"] = Claim(total(*kept) if kept else sp.Integer(0), each, Phrase("coefficient {i}", i=i))
    z, q = facts["z"], found.coefficients
    stated = quotient(total(*(each * z**-i for i, each in enumerate(q) if each != 0)), 1 - 1 / z)
    claims["D"] = Claim(stated, found.controller, "the controller by its coefficients")
    return Step("velocity", claims=claims, q=list(q), numbers=not any(each.free_symbols for each in q), **facts)
