"""Lemma: the type of a loop and its error constants."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power, product, quotient
from solver.stated.limits import Side, limit
from solver.tasks.loops.late_loops import with_dead_time

if TYPE_CHECKING:
    from solver.systems import OpenLoop
    from solver.tasks.loops.loop_stability import Inside

CONSTANTS = ("position_constant", "velocity_constant", "acceleration_constant")
LIMITS = ("the limit of $L$", "the limit of $s L$", "the limit of $s^{2} L$")
DISCRETE_LIMITS = ("the limit of $L$", "the limit of $(z - 1) L$", "the limit of $(z - 1)^{2} L$")
"""What they are, by their names."""


def limit_stated(loop: OpenLoop, n: int, side: Side = "", *, inverse: bool = False) -> Any:
    """The limit of sⁿ L for s → 0, of (z − 1)ⁿ L for z → 1, as it is written; that of 1 over it."""
    x, L = loop.variable, with_dead_time(loop, quotient(loop.numerator, loop.denominator))
    zero, goal = (x - 1, sp.S.One) if loop.discrete else (x, sp.S.Zero)
    found = product(power(zero, n) if n > 1 else zero, L) if n else L
    return limit(quotient(1, found) if inverse else found, x, goal, side)


@lemma("error_constants")
def constants_of(loop: OpenLoop, inside: Inside) -> Derivation[dict[str, Any]]:
    """The type of L, and the limits of L, s L, s² L; in discrete time those of (z − 1)ⁿ L over Tⁿ.

    Where T is not known, a constant that needs it is left out.
    """
    s, N, D, T = loop.variable, loop.numerator, loop.denominator, loop.sample_time
    found = exact.error_constants(N, D, s, inside.positive, discrete=loop.discrete, period=T)
    claims, names = {}, DISCRETE_LIMITS if loop.discrete else LIMITS
    for n, (name, value) in enumerate(zip(CONSTANTS, found.limits, strict=True)):
        infinite, K = value in (sp.oo, -sp.oo), found.constants[n]
        if value is not None and not (infinite and (N.free_symbols | D.free_symbols) - {s}):
            claims[name] = Claim(limit_stated(loop, n, "+" if infinite else ""), value, names[n])
        if T is not None and n and K is not None and not infinite:
            claims[f"{name}_over_time"] = Claim(quotient(value, power(T, n) if n > 1 else T), K, "per unit of time")
    rows = list(zip(range(3), found.limits, found.constants, strict=True))
    yield Step("constants", claims=claims, unclaimed="" if claims else "infinite", rows=rows, N=N, D=D, s=s,
               integrators=found.integrators, lead=found.lead, closed=loop.closed, unity=loop.H == 1,
               discrete=loop.discrete, T=T)  # fmt: skip
    named = {name: K for name, K in zip(CONSTANTS, found.constants, strict=True) if K is not None}
    return {"system_type": sp.Integer(found.integrators), **named}
