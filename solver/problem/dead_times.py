"""The factor e^{−T s} of a transfer function."""

from __future__ import annotations

from typing import Any

import sympy as sp

from solver.problem.lexicon import Lexicon
from solver.problem.nodes import Node


def without_dead_time(
    p: sp.Expr, q: sp.Expr, s: sp.Symbol, node: Node, lexicon: Lexicon
) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Return numerator and denominator without their exponentials in s, and the dead time T of e^{−T s} (or zero).

    A name of which nothing is said is taken as positive from here on where it is the dead time. Raises Fault where the
    exponentials are no factor of the whole, and where T is not known to be positive.
    """
    (p, above), (q, below) = (_split(side, s, node) for side in (p, q))
    delay: Any = sp.expand(below - above)
    if delay.is_Symbol and delay.is_positive is None and delay.name not in lexicon.symbols:
        known = sp.Symbol(delay.name, positive=True)
        p, q = (side.xreplace({delay: known}) for side in (p, q))
        lexicon.symbols[delay.name] = lexicon.found[delay.name] = delay = known
        lexicon.assumed[delay.name] = "positive"
    if delay.is_zero or delay.is_positive:
        return p, q, delay
    if delay.is_negative:
        raise node.fault("a dead time comes out later, not earlier: write exp(-T s) with a positive T")
    names = ", ".join(f"{symbol}: positive" for symbol in sorted(delay.free_symbols, key=str))
    raise node.fault(f"it must be known that the dead time {sp.sstr(delay)} is positive", note=f"assume: {{{names}}}")


def _split(side: sp.Expr, s: sp.Symbol, node: Node) -> tuple[sp.Expr, sp.Expr]:
    """A product without its factors e^{a s}, and the sum of their a."""
    rest, rate = sp.S.One, sp.S.Zero
    for factor in sp.Mul.make_args(side):
        exponent = sp.expand(factor.args[0]) if isinstance(factor, sp.exp) else sp.S.Zero
        a = exponent.coeff(s)
        if not exponent.has(s):
            rest *= factor
        elif (constant := sp.expand(exponent - a * s)).has(s):
            raise node.fault("the exponent of a dead time is a number or name times s: exp(-T s)")
        else:
            rest, rate = rest * sp.exp(constant), rate + a
    if any(each.has(s) for each in rest.atoms(sp.exp)):
        raise node.fault("a dead time is a factor exp(-T s) of the whole transfer function; here it is part of a sum")
    return rest, rate
