"""When several expressions are positive together, and where one of them vanishes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import sympy as sp

from solver.conditions import Parameter, conditions_of
from solver.derivation import Check, Claim
from solver.numeric.evaluation.points import admissible
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.stability.regions import is_admissible
from solver.stated.calculus import value_at

DRAWN, TURNS = 24, 2
"""Points at which signs are compared, and values of the other parameters with which zeros are."""
NEAR = 1e-9
DIGITS, ZERO = 30, sp.Float(10) ** -15
LOW = 3
"""Below this degree all special values are found."""

Point = Mapping[Any, Any]


def of_all_positive(found: Any, conditions: Sequence[Any], *_: Any) -> Iterator[Check]:
    """At random points it holds where all are positive; where it ends one of them is zero or not defined.

    It may end too where what is known of the parameters does.
    """
    listed = [sp.S.Zero + each for each in conditions]
    points = _drawn(set(found.free_symbols).union(*(each.free_symbols for each in listed)))
    yield Check.that("when all are positive", "random points", all(_agrees(found, listed, point) for point in points))
    carrying = {x.plain: x for x in found.free_symbols if isinstance(x, Parameter)}
    known = [difference.xreplace(carrying) for difference, _ in conditions_of(found.free_symbols)]
    ends = [*(part for each in listed for part in sp.fraction(sp.together(each))), *known]
    for each in found.atoms(sp.core.relational.Relational):
        held = all(_is_zero_where(ends, each.lhs - each.rhs, point) for point in points[:TURNS])
        yield Check.that("where a condition ends", "sympy.nroots", held)


def of_vanishing_factors(found: Sequence[Any], value: Any) -> Iterator[Check]:
    """One of them is zero where the numerator is, and it is zero where one of them is."""
    above = sp.numer(sp.together(sp.S.Zero + value))
    for point in _drawn(above.free_symbols)[:TURNS] if above.free_symbols else ():
        yield Check.that("where it vanishes", "sympy.nroots", _is_zero_where(found, above, point))
        for each in found:
            yield Check.that("where it vanishes", "sympy.nroots", _is_zero_where([above], each, point))


def of_special_values(found: Sequence[Any], f: Any) -> Iterator[Check | Claim]:
    """It is zero there; of one parameter, up to degree two, these are all the zeros that the parameter may have.

    Of several parameters one that it is linear in, with a number beside it, has a value where it may be zero.
    """
    symbols = f.free_symbols
    known = all(x in symbols for x, _ in found)
    yield Check.that("the parameter", "counted", known)
    for x, value in found if known else ():
        yield Claim(value_at(f, x, value), sp.S.Zero, "a special value")
    if len(symbols) == 1 and known:
        (x,) = symbols
        values = [sp.N(value, DIGITS) for _, value in found]
        zeros = [zero for zero in _low_zeros(f, x) if is_admissible({x: zero})]
        held = all(any(abs(zero - value) < NEAR * (1 + abs(zero)) for value in values) for zero in zeros)
        yield Check.that("all special values", "sympy.nroots", held)
    elif not found and f.is_polynomial(*symbols):
        yield Check.that("no special value", "random points", not any(_may_be_zero_along(x, f) for x in symbols))


def _may_be_zero_along(x: Any, f: Any) -> bool:
    """Whether a parameter with a number beside it is one that it may be at some point where the sum is zero."""
    p = sp.Poly(f, x)
    if p.degree() != 1 or not p.LC().is_number:
        return False
    value = -p.TC() / p.LC()
    return any(is_admissible({**point, x: value.xreplace(point)}) for point in _drawn(f.free_symbols))


def _low_zeros(f: Any, x: Any) -> list[Any]:
    """The real zeros of a polynomial with real coefficients, up to degree two."""
    if not f.is_polynomial(x) or x.is_real is False or not 0 < sp.degree(f, x) < LOW:
        return []
    p = sp.Poly(f, x)
    return [z for z in p.nroots(n=DIGITS) if z.is_real] if all(c.is_real for c in p.all_coeffs()) else []


def _drawn(symbols: set[Any]) -> list[Point]:
    """Some points of rational numbers; none where what is assumed allows none."""
    try:
        drawn = admissible(symbols, DRAWN)
    except NotEvaluable:
        return []
    return [{x: sp.Rational(str(complex(value).real)) for x, value in point.items()} for point in drawn]


def _agrees(found: Any, conditions: Sequence[Any], point: Point) -> bool:
    """Whether the truth at a point is that of the conditions; nothing is said where one is zero or not defined."""
    values = [sp.N(each.xreplace(point)) for each in conditions]
    told = found.xreplace(point)
    if told not in (True, False) or any(not value.is_real or abs(value) < NEAR for value in values):
        return True
    return bool(told) == all(value > 0 for value in values)


def _is_zero_where(others: Sequence[Any], gap: Any, point: Point) -> bool:
    """Whether one of the others is zero where the gap is, for each parameter with the rest of them at a point."""
    return all(_is_zero_along(x, others, gap, point) for x in gap.free_symbols)


def _is_zero_along(x: Any, others: Sequence[Any], gap: Any, point: Point) -> bool:
    """The same for one parameter, or for the one function of it that is there (sin x), within its range."""
    inside = [each for each in gap.atoms(sp.Function) if x in each.free_symbols]
    u = x if not inside else sp.Dummy("u")
    moved = {each: value for each, value in point.items() if each != x} | dict.fromkeys(inside, u)
    p = sp.numer(sp.together(gap.xreplace(moved)))
    if len(inside) > 1 or p.free_symbols != {u} or not p.is_polynomial(u):
        return True
    roots = [root for root in sp.Poly(p, u).sqf_part().nroots(n=DIGITS, maxsteps=500) if root.is_real]
    told = [root for root in roots if (0 < root < 1 if inside else is_admissible({**point, x: root}))]
    there = [sp.expand(each.xreplace(moved)) for each in others]
    return all(any(_vanishes(each, {u: root}) for each in there) for root in told)


def _vanishes(value: Any, at: Point) -> bool:
    """Whether an expression, multiplied out, is zero at a point beside its terms there."""
    terms = [sp.N(term.xreplace(at), DIGITS) for term in sp.Add.make_args(value)]
    return bool(abs(sum(terms)) <= ZERO * (1 + sum(map(abs, terms))))
