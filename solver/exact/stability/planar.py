"""What kind of equilibrium the origin of x' = A x is for two states, also where parameters decide it.

The kind is told by the signs of trace, determinant and discriminant. Where one of them is open the general kind is
that at a typical point: a rational one inside what is assumed, positive values before negative ones, at which none of
the open ones is zero.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.conditions import Parameter, conditions_of, without_conditions
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.signs import is_not_zero, possible_signs, values_of
from solver.exact.stability.conditions import all_positive
from solver.exact.stability.inequalities import Condition, sign_of

Signs = tuple[int, int, int]
"""Of trace, determinant and discriminant."""

TRIED = 60
SIZES = tuple(map(sp.Rational, ("1", "1/2", "2", "3", "1/3", "5", "1/5", "7", "10", "1/10", "20")))


@dataclass(frozen=True)
class PlanarSigns:
    """The signs for general values, those that are open, and the exceptions: where the kind is another.

    `positive` are what decides the kind, is positive for general values and not for all.
    """

    signs: Signs
    open: tuple[bool, bool, bool]
    positive: tuple[sp.Expr, ...]
    exceptions: tuple[Condition, ...]

    def sign_of(self, x: sp.Expr) -> int | None:
        """The sign of an expression for general values; None where it is not the same for all."""
        known = sign_of(x)
        if known is not None or not self.positive:
            return known
        possible = [sign for sign in (1, -1) if all_positive([*self.positive, sign * x]) is not sp.false]
        return possible[0] if len(possible) == 1 else None


def invariants(A: sp.ImmutableMatrix) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Trace, determinant and discriminant of A (2×2): the characteristic polynomial is λ² − tr λ + det."""
    tr, det = sp.expand(A[0, 0] + A[1, 1]), sp.expand(A[0, 0] * A[1, 1] - A[0, 1] * A[1, 0])
    return tr, det, sp.expand(tr**2 - 4 * det)


def planar_signs(A: sp.ImmutableMatrix) -> PlanarSigns:
    """The signs for general values of the parameters of A (2×2); raises NotExact where no typical values are found."""
    values = invariants(A)
    known = [_sign(x, form) for x, form in zip(values, _as_they_arise(A), strict=True)]
    found: Any = known if None not in known else next(_at_typical_points(values, known), None)
    if found is None:
        raise NotExact("phase_portrait/no_typical_values")
    signs: Signs = tuple(found)
    tr, det, discriminant = (sign is None for sign in known)
    deciding = [
        x * sign for x, sign, was, of in zip(values, signs, known, _decisive(signs), strict=True) if was is None and of
    ]
    exceptions = _negations(deciding)
    if signs[1] == 0 and tr:
        exceptions.append(sp.Eq(sp.factor(values[0]), 0))
    if signs[2] == 0:
        exceptions += _without_chain(A)
    return PlanarSigns(signs, (tr, det, discriminant), tuple(deciding), tuple(exceptions))


def _as_they_arise(A: sp.ImmutableMatrix) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Trace, determinant and discriminant, squares not multiplied out: these are seen not to be negative."""
    (a, b), (c, d) = A.tolist()
    return a + d, a * d - b * c, (a - d) ** 2 + 4 * b * c


def _sign(x: sp.Expr, form: sp.Expr) -> int | None:
    """The sign of an expression by one of two forms; None where parameters decide it."""
    known = sign_of(x)
    if known is None and len(possible := possible_signs(form)) == 1:
        return next(iter(possible))
    return known


def _decisive(signs: Signs) -> tuple[bool, bool, bool]:
    """Which of trace, determinant and discriminant must keep their sign for the kind to stay."""
    _, det, discriminant = signs
    return det > 0, det < 0 or discriminant > 0 < det, det > 0 and discriminant != 0


def _negations(positive: Sequence[sp.Expr]) -> list[Condition]:
    """Where not all of the expressions are positive."""
    whole = all_positive(positive) if positive else sp.true
    parts = sorted(whole.args, key=sp.default_sort_key) if isinstance(whole, sp.And) else [whole]
    return [sp.Not(part) for part in parts if part is not sp.true]


def _without_chain(A: sp.ImmutableMatrix) -> list[Condition]:
    """Where both entries beside the diagonal vanish, so that every direction is that of an eigenvector."""
    beside = [x for x in (A[0, 1], A[1, 0]) if x != 0]
    if not beside or any(is_not_zero(x) for x in beside):
        return []
    return [sp.And(*(sp.Eq(sp.factor(x), 0) for x in beside))]


def _at_typical_points(values: Sequence[sp.Expr], known: Sequence[int | None]) -> Iterator[Signs]:
    """The signs at typical points at which none of those that are open is zero."""
    symbols = sorted(set().union(*(x.free_symbols for x in values)), key=str)
    for point in _typical_points(symbols):
        signs = [sign_of(x.xreplace(point)) if sign is None else sign for x, sign in zip(values, known, strict=True)]
        if all(sign not in (0, None) or was == 0 for sign, was in zip(signs, known, strict=True)):
            yield tuple(signs)  # type: ignore[misc]


def _typical_points(symbols: Sequence[Any]) -> Iterator[dict[Any, sp.Expr]]:
    """Values of symbols that their assumptions and conditions allow, first ones alone, then more and more mixed."""
    choices = [_choices(symbol) for symbol in symbols]
    for i in range(TRIED):
        point = {x: own[(i * (j + 1)) % len(own)] for j, (x, own) in enumerate(zip(symbols, choices, strict=True))}
        if _holds(point):
            yield point


def _choices(symbol: Any) -> list[sp.Expr]:
    """Values between the ends that conditions on the symbol alone leave; by its assumptions where there are none."""
    bounds = values_of(symbol) if isinstance(symbol, Parameter) else None
    if bounds is not None and bounds[0].is_finite and bounds[1].is_finite:
        low, high = bounds[:2]
        return [low + (high - low) * q / (1 + q) for q in SIZES]
    sizes = [q for q in SIZES if q.is_Integer] if symbol.is_integer else list(SIZES)
    if bounds is not None and (bounds[0].is_finite or bounds[1].is_finite):
        return [bounds[0] + q if bounds[0].is_finite else bounds[1] - q for q in sizes]
    if symbol.is_negative or symbol.is_nonpositive:
        return [-q for q in sizes]
    return sizes if symbol.is_positive or symbol.is_nonnegative else [*sizes, *(-q for q in sizes)]


def _holds(point: dict[Any, sp.Expr]) -> bool:
    """Whether the conditions that the symbols carry hold at a point, those on other symbols left aside."""
    plain = {without_conditions(symbol): value for symbol, value in point.items()}
    for condition in conditions_of(point):
        value = condition.difference.xreplace(plain)
        sign = None if value.free_symbols else sign_of(value)
        if sign is not None and not {">": sign > 0, ">=": sign >= 0}.get(condition.relation, sign != 0):
            return False
    return True
