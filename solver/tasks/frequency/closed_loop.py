"""Lemma: whether a loop is stable, by Routh's array of D + N, discrete of its image; late loops by Nyquist's count."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.tasks.loops.loop_stability import inside_circle
from solver.tasks.stability.routh_array import rows_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sympy import Expr, Symbol

    from solver.systems import OpenLoop

BY_SIGNS = 2
"""Up to this degree the signs of the coefficients decide."""


@lemma("closed_loop_stability")
def is_stable(loop: OpenLoop) -> Derivation[bool]:
    """Whether all poles of the closed loop are in the region of stability, those that cancel in L among them."""
    if loop.delay != 0:
        return (yield from _by_counting(loop))
    s, N, D = loop.variable, loop.numerator, loop.denominator
    p = sp.Poly(D + N, s).as_expr()
    if p == 0:
        raise Unsolved("conversions/ill_posed_loop")
    if sp.degree(p, s) < sp.degree(D, s):
        raise Unsolved("conversions/ill_posed_direct_path")
    yield Step("characteristic", claims={"p": Claim(total(D, N), p, "characteristic polynomial")}, s=s, p=p)
    listed = sp.Poly(p, s).all_coeffs()
    if len(listed) == 1:
        return (yield from _verdict(listed, s, None, discrete=loop.discrete))
    if exact.sign_of(listed[0]) == -1:
        listed = [-c for c in listed]
        claim = Claim(product(sp.Integer(-1), p), _polynomial(listed, s), "the same roots")
        yield Step("lead", claims={"lead": claim}, s=s)
    if loop.discrete:
        yield from inside_circle(listed)
        return (yield from _verdict(listed, s, None, discrete=True))
    if len(listed) - 1 <= BY_SIGNS:
        return (yield from _verdict(listed, s, None))
    array = yield from rows_of(exact.routh(listed), s)
    return (yield from _verdict(listed, s, array))


def _polynomial(listed: Sequence[Expr], s: Symbol) -> Expr:
    n = len(listed) - 1
    return sp.Add(*(c * s ** (n - i) for i, c in enumerate(listed)))


def _verdict(listed: Sequence[Expr], s: Symbol, array: Any, *, discrete: bool = False) -> Derivation[bool]:
    """The count of the roots outside of the region of stability and on its boundary."""
    counts: Any = exact.root_counts(listed, discrete=discrete)
    stable = not counts.outside and not counts.on
    yield Step(
        "verdict",
        unclaimed="counted; the answer has a check of its own",
        stable=stable,
        degree=len(listed) - 1,
        outside=counts.outside,
        on=counts.on,
        special=array is not None and any(row.special for row in array.rows),
        s=s,
        discrete=discrete,
    )
    return stable


def _by_counting(loop: OpenLoop) -> Derivation[bool]:
    """Z = P + N for the loop with a dead time."""
    found = exact.encirclements(loop.numerator, loop.denominator, loop.variable, loop.delay)
    yield Step("counted", unclaimed="counted; the answer has a check of its own", found=found, stable=found.stable)
    return found.stable


__all__ = ["is_stable"]
