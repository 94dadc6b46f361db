"""Lemma: a loop must be stable before anything remains of its signals; decided by its characteristic polynomial."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, total
from solver.tasks.stability.routh_array import bilinear_image_of, rows_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sympy import Expr, Symbol

    from solver.systems import OpenLoop

BY_SIGNS = 2
"""Up to this degree the signs of the coefficients decide, in discrete time those of p(1), ±p(−1) and a₂ − a₀."""


@dataclass(frozen=True, slots=True)
class Inside:
    """The polynomial whose roots are inside, and what must be positive for that where parameters decide."""

    polynomial: Expr
    positive: tuple[Expr, ...]


@lemma("loop_stability")
def stable_loop(loop: OpenLoop) -> Derivation[Inside]:
    """All roots of the numerator of 1 + L are inside, nothing cancelled; of an open loop the poles but integrators.

    Raises Unsolved where they are not, whatever the parameters are.
    """
    s = loop.variable
    p = yield from _characteristic(loop)
    degree, p_shown = sp.degree(p, s), p
    if degree == 0:
        yield Step("static", unclaimed="a constant has no roots", closed=loop.closed)
        return Inside(sp.S.One, ())
    coefficients = yield from _positive_lead(p, s)
    positive = yield from inside_circle(coefficients) if loop.discrete else _left_of_axis(coefficients, s)
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
        discrete=loop.discrete,
        condition=None if condition is sp.true else condition,
    )
    return Inside(p, undecided if condition is not sp.true else ())


@lemma("loop_stability")
def _left_of_axis(coefficients: Sequence[Expr], s: Symbol) -> Derivation[list[Expr]]:
    """What must be positive for all roots to have negative real parts: the coefficients, or the first column."""
    if len(coefficients) - 1 <= BY_SIGNS:
        return list(coefficients)
    return (yield from _first_column(coefficients, s))


@lemma("loop_stability")
def inside_circle(coefficients: Sequence[Expr]) -> Derivation[list[Expr]]:
    """What must be positive for all roots to lie inside the unit circle; of three and more by the bilinear image."""
    if len(coefficients) - 1 <= BY_SIGNS:
        found = exact.root_conditions(coefficients, discrete=True)
        yield _at_both_ends(coefficients, found)
        return found
    if sp.expand(sum(coefficients)) == 0:  # p(1) = 0
        return [sp.Integer(-1)]
    w = sp.Symbol("w")
    image, _ = yield from bilinear_image_of(coefficients, w)
    return (yield from _first_column(image, w))


def _at_both_ends(coefficients: Sequence[Expr], found: Sequence[Expr]) -> Step:
    """The values p(1) and ±p(−1), and of two roots a₂ − a₀."""
    n = len(coefficients) - 1
    stated = [total(*coefficients), total(*((-1) ** i * c for i, c in enumerate(coefficients)))]
    stated += [difference(coefficients[0], coefficients[2])] if n == 2 else []
    claims = {
        name: Claim(left, right, "for roots inside the unit circle")
        for name, left, right in zip(("at_one", "at_minus_one", "product"), stated, found, strict=False)
    }
    return Step("at_both_ends", claims=claims, degree=n)


@lemma("loop_stability")
def _first_column(coefficients: Sequence[Expr], s: Symbol) -> Derivation[list[Expr]]:
    """The first column of the array; −1 where a root lies on the axis, or symmetrically to the origin with another."""
    if coefficients[0] == 0:
        return [sp.Integer(-1)]
    array = yield from rows_of(exact.routh(coefficients), s)
    special = any(row.special for row in array.rows)
    return [sp.Integer(-1)] if special else list(array.first_column)


def _characteristic(loop: OpenLoop) -> Derivation[Expr]:
    """The numerator of 1 + L; of an open loop the denominator of C G without its roots at zero."""
    s, N, D = loop.variable, loop.numerator, loop.denominator
    if not loop.closed:
        rest, integrators = exact.integrators_apart(D, s, discrete=loop.discrete)
        one = s - 1 if loop.discrete else s
        stated = product(power(one, integrators) if integrators > 1 else one, rest)
        claims = {"split": Claim(D, stated, "the integrators apart")} if integrators else {}
        yield Step("open", claims=claims, unclaimed="" if claims else "it is read off", p=D, rest=rest, s=s,
                   integrators=integrators, discrete=loop.discrete)  # fmt: skip
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
    yield Step("lead", claims={"lead": Claim(product(factor, p), same, "the same roots")}, negative=sign == -1, s=s,
               named=str(s) == "z")  # fmt: skip
    return changed


def _unstable(coefficients: Sequence[Expr], loop: OpenLoop, p: Expr) -> dict[str, Any]:
    """What a reason says of an unstable loop: how many roots lie where, where that is known."""
    known = not any(c.free_symbols for c in coefficients)
    left, ones = exact.off_the_point_one(coefficients) if loop.discrete else (coefficients, 0)
    counts = exact.root_counts(exact.bilinear(left) if loop.discrete else left) if known else None
    return {
        "p": p,
        "s": loop.variable,
        "closed": loop.closed,
        "discrete": loop.discrete,
        "outside": counts.outside if counts else None,
        "on": counts.on + ones if counts else None,
    }
