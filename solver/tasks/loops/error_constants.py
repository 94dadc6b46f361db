"""Lemma: the type of a loop and its error constants."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power, product, quotient
from solver.stated.limits import limit

if TYPE_CHECKING:
    from solver.systems import OpenLoop
    from solver.tasks.loops.loop_stability import Inside

CONSTANTS = ("position_constant", "velocity_constant", "acceleration_constant")
LIMITS = ("the limit of $L$", "the limit of $s L$", "the limit of $s^{2} L$")
"""What they are, by their names."""


@lemma("error_constants")
def constants_of(loop: OpenLoop, inside: Inside) -> Derivation[dict[str, Any]]:
    """The type of L, and the limits of L, s L, s² L."""
    s, N, D = loop.variable, loop.numerator, loop.denominator
    found = exact.error_constants(N, D, s, inside.positive)
    claims = {}
    for n, (name, value) in enumerate(zip(CONSTANTS, found.limits, strict=True)):
        infinite = value in (sp.oo, -sp.oo)
        if value is not None and not (infinite and (N.free_symbols | D.free_symbols) - {s}):
            stated = product(power(s, n), quotient(N, D)) if n else quotient(N, D)
            claims[name] = Claim(limit(stated, s, sp.S.Zero, "+" if infinite else ""), value, LIMITS[n])
    rows = list(enumerate(found.limits))
    yield Step("constants", claims=claims, unclaimed="" if claims else "infinite", rows=rows, N=N, D=D, s=s,
               integrators=found.integrators, lead=found.lead, closed=loop.closed, unity=loop.H == 1)  # fmt: skip
    named = {name: value for name, value in zip(CONSTANTS, found.limits, strict=True) if value is not None}
    return {"system_type": sp.Integer(found.integrators), **named}
