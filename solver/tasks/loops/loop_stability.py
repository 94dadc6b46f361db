"""Lemma: a loop must be stable before anything remains of its signals; decided by its characteristic polynomial."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.tasks.stability.routh_array import rows_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sympy import Expr, Symbol

    from solver.systems import OpenLoop

BY_SIGNS = 2
"""Up to this degree the signs of the coefficients decide."""


@dataclass(frozen=True, slots=True)
class Inside:
    """The polynomial whose roots are inside, and what must be positive for that where parameters decide."""

    polynomial: Expr
    positive: tuple[Expr, ...]


@lemma("loop_stability")
def stable_loop(loop: OpenLoop) -> Derivation[Inside]:
    """All roots of the numerator of 1 + L are inside, nothing cancelled; of an open loop the poles but those at zero.

    Raises Unsolved where they are not, whatever the parameters are.
    """
    s = loop.variable
    p = yield from _characteristic(loop)
    degree, p_shown = sp.degree(p, s), p
    if degree == 0:
        yield Step("static", unclaimed="a constant has no roots", closed=loop.closed)
        return Inside(sp.S.One, ())
    coefficients = yield from _positive_lead(p, s)
    if degree <= BY_SIGNS:
        positive = list(coefficients)
    else:
        array = yield from rows_of(exact.routh(coefficients), s)
        special = any(row.special for row in array.rows)
        positive = [sp.Integer(-1)] if special else list(array.first_column)
    condition = exact.held_where(positive)
    if condition is sp.false:
        raise Unsolved("loops/unstable", **_unstable(coefficients, loop, p_shown))
    undecided = tuple(each for each in positive if exact.sign_of(each) != 1)
    yield Step(
        "stable",
        unclaimed="the signs decide",
        p=p,
        s=s,
        degree=degree,
        closed=loop.closed,
        condition=None if condition is sp.true else condition,
    )
    return Inside(p, undecided if condition is not sp.true else ())


def _characteristic(loop: OpenLoop) -> Derivation[Expr]:
    """The numerator of 1 + L; of an open loop the denominator of C G without its roots at zero."""
    s, N, D = loop.variable, loop.numerator, loop.denominator
    if not loop.closed:
        integrators = min(powers[0] for powers in sp.Poly(D, s).monoms())
        rest = sp.Poly(sp.cancel(D / s**integrators), s).as_expr()
        claims = {"split": Claim(D, product(s**integrators, rest), "the integrators apart")} if integrators else {}
        yield Step("open", claims=claims, unclaimed="" if claims else "it is read off", p=D, rest=rest, s=s,
                   integrators=integrators)  # fmt: skip
        return rest
    p = sp.Poly(D + N, s).as_expr()
    if p == 0:
        raise Unsolved("conversions/ill_posed_loop")
    if sp.degree(p, s) < sp.degree(D, s):
        raise Unsolved("conversions/ill_posed_direct_path")
    yield Step("characteristic", claims={"p": Claim(total(D, N), p, "characteristic polynomial")}, s=s, p=p)
    return p


def _positive_lead(p: Expr, s: Symbol) -> Derivation[tuple[Expr, ...]]:
    """The coefficients, the first made positive."""
    coefficients = tuple(sp.Poly(p, s).all_coeffs())
    sign = exact.sign_of(coefficients[0])
    if sign == 1:
        return coefficients
    factor = sp.Integer(-1) if sign == -1 else 1 / coefficients[0]
    changed = tuple(sp.cancel(c * factor) for c in coefficients)
    n = len(changed) - 1
    same = sp.Add(*(c * s ** (n - i) for i, c in enumerate(changed)))
    yield Step("lead", claims={"lead": Claim(product(factor, p), same, "the same roots")}, negative=sign == -1, s=s)
    return changed


def _unstable(coefficients: Sequence[Expr], loop: OpenLoop, p: Expr) -> dict[str, Any]:
    """What a reason says of an unstable loop: how many roots lie where, where that is known."""
    known = not any(c.free_symbols for c in coefficients)
    counts = exact.root_counts(coefficients) if known else None
    return {
        "p": p,
        "s": loop.variable,
        "closed": loop.closed,
        "outside": counts.outside if counts else None,
        "on": counts.on if counts else None,
    }
