"""What kind of equilibrium the origin of x' = A x, or x(k+1) = A x(k), is for two states, also with parameters.

The kind is told by the signs of trace, determinant and discriminant; in discrete time by those of p(1), p(−1), det − 1
and the discriminant, p the characteristic polynomial. Where one of them is open the general kind is that at a typical
point: a rational one inside what is assumed, positive values before negative ones, at which none of the open ones is
zero.
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

Signs = tuple[int, ...]
"""Of trace, determinant and discriminant; in discrete time of p(1), p(−1), det − 1 and the discriminant."""

TRIED = 60
SIZES = tuple(map(sp.Rational, ("1", "1/2", "2", "3", "1/3", "5", "1/5", "7", "10", "1/10", "20")))


@dataclass(frozen=True)
class PlanarSigns:
    """The signs for general values, those that are open, and the exceptions: where the kind is another.

    `positive` are what decides the kind, is positive for general values and not for all.
    """

    signs: Signs
    open: tuple[bool, ...]
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


def invariants_in_z(A: sp.ImmutableMatrix) -> tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]:
    """p(1), p(−1), det − 1 and the discriminant of A (2×2), p(λ) = λ² − tr λ + det."""
    tr, det, discriminant = invariants(A)
    return sp.expand(1 - tr + det), sp.expand(1 + tr + det), sp.expand(det - 1), discriminant


def planar_signs(A: sp.ImmutableMatrix) -> PlanarSigns:
    """The signs for general values of the parameters of A (2×2); raises NotExact where no typical values are found."""
    values = invariants(A)
    signs, known = _general(values, _as_they_arise(A))
    deciding = _open_ones(values, signs, known, _decisive(signs))
    exceptions = _negations(deciding)
    if signs[1] == 0 and known[0] is None:
        exceptions.append(sp.Eq(sp.factor(values[0]), 0))
    if signs[2] == 0:
        exceptions += _without_chain(A)
    return PlanarSigns(signs, tuple(sign is None for sign in known), tuple(deciding), tuple(exceptions))


def planar_signs_in_z(A: sp.ImmutableMatrix) -> PlanarSigns:
    """The same in discrete time, of p(1), p(−1), det − 1 and the discriminant."""
    values = invariants_in_z(A)
    (a, b), (c, d) = A.tolist()
    forms = (1 - a - d + a * d - b * c, 1 + a + d + a * d - b * c, a * d - b * c - 1, (a - d) ** 2 + 4 * b * c)
    signs, known = _general(values, forms)
    deciding, further = _deciding_in_z(values, signs, known)
    exceptions = [*_negations(deciding), *further]
    if signs[0] == 0 and known[2] is None:
        exceptions.append(sp.Eq(sp.factor(values[2]), 0))
    if signs[3] == 0:
        exceptions += _without_chain(A)
    return PlanarSigns(signs, tuple(sign is None for sign in known), tuple(deciding), tuple(exceptions))


def _general(values: Sequence[sp.Expr], forms: Sequence[sp.Expr]) -> tuple[Signs, list[int | None]]:
    """The signs for general values, and those that are the same for all."""
    known = [_sign(x, form) for x, form in zip(values, forms, strict=True)]
    found: Any = known if None not in known else next(_at_typical_points(values, known), None)
    if found is None:
        raise NotExact("phase_portrait/no_typical_values")
    return tuple(found), known


def _open_ones(
    values: Sequence[sp.Expr], signs: Signs, known: Sequence[int | None], decisive: Sequence[bool]
) -> list[sp.Expr]:
    """What is open and decisive, with the sign that makes it positive for general values."""
    told = zip(values, signs, known, decisive, strict=True)
    return [x * sign for x, sign, was, of in told if was is None and of]


def _deciding_in_z(
    values: Sequence[sp.Expr], signs: Signs, known: Sequence[int | None]
) -> tuple[list[sp.Expr], list[Condition]]:
    """What must be positive for the kind to stay, and further exceptions.

    A saddle has p(1) p(−1) < 0, whichever of the two is negative; an unstable node has both negative, or both positive
    and det > 1.
    """
    at_one, at_minus_one, size, _ = values
    both = _open_ones(values, signs, known, (True, True, False, False))
    if signs[0] == 0:
        return [], []
    if signs[0] * signs[1] < 0 or -1 in known[:2]:
        return ([sp.expand(sp.Mul(*both))] if both else []), []
    if signs[3] > 0 and signs[2 if signs[0] > 0 else 0] * signs[0] > 0 and len(both) > 1:
        node = [sp.expand(at_one * at_minus_one), *_open_ones(values, signs, known, (False, False, False, True))]
        stable = all_positive([at_one, -size])
        return node, [] if stable is sp.false else [stable]
    real = signs[3] > 0
    return _open_ones(values, signs, known, (real, real, True, signs[3] != 0)), []


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


def _decisive(signs: Signs) -> Sequence[bool]:
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
            yield tuple(sign for sign in signs if sign is not None)


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
