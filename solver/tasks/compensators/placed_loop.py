"""Lemma: the gains of a PID controller by comparing coefficients with the polynomial wanted."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.tasks.compensators.closed_loop import number_first
from solver.tasks.design.frames import linear_factors

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop


@lemma("placed_loop")
def gains_that_place(G: OpenLoop, kind: str, poles: Sequence[Expr]) -> Derivation[exact.Gains]:
    """D·s + N (K_d s² + K_p s + K_i) compared with the polynomial of the poles; raises Unsolved where none fits."""
    s, N, D = G.variable, G.numerator, G.denominator
    found = exact.placed_gains(N, D, s, kind, poles)
    own = exact.polynomial_in(s, found.own)
    wanted = exact.polynomial_in(s, found.wanted)
    K_p, K_i, K_d = exact.gains_of(found.unknowns)
    top, bottom = (K_p, sp.Integer(1)) if kind == "P" else (K_d * s**2 + K_p * s + K_i, s)
    stated = total(product(bottom, D), number_first(top, N))
    yield Step("polynomial", claims={"own": Claim(stated, own, "the characteristic polynomial")}, s=s, kind=kind)
    lead = found.own[0]
    claim = Claim(product(lead, linear_factors(s, list(poles))), wanted, "the polynomial wanted")
    yield Step("wanted", claims={"wanted": claim}, poles=list(poles), s=s, lead=lead)
    equations = [
        (len(found.own) - 1 - i, a, b) for i, (a, b) in enumerate(zip(found.own, found.wanted, strict=True)) if i
    ]
    if found.gains is None:
        told = "they contradict each other"
        yield Step("equations", unclaimed=told, equations=equations, s=s, unknowns=[])
        raise Unsolved("pid_tuning/cannot_place", kind=kind, n=len(poles), unknowns=len(found.unknowns))
    if found.free:
        raise Unsolved("pid_tuning/not_fixed", kind=kind, n=len(poles), unknowns=len(found.unknowns))
    values = dict(zip(found.unknowns, found.gains, strict=False))
    claims = {
        f"power{power}": Claim(a.xreplace(values), b.xreplace(values), "a coefficient compared")
        for power, a, b in equations
    }
    yield Step("equations", claims=claims, equations=equations, s=s, unknowns=list(values.items()))
    return found.gains
