"""Natural frequency and damping of b₂s² + b₁s + b₀ = b₂ (s² + 2ζω_n s + ω_n²), and where each case of damping holds.

Source: Ogata, Modern Control Engineering, section 5-3.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.radicals import square_root
from solver.exact.stability.conditions import all_positive
from solver.exact.stability.inequalities import sign_of

UNDAMPED, UNDERDAMPED, CRITICAL, OVERDAMPED = "undamped", "underdamped", "critically_damped", "overdamped"


@dataclass(frozen=True)
class Damping:
    """ω_n and ζ of a polynomial with b₂ > 0; `square` is ω_n², `twice` is 2ζω_n, `discriminant` b₁² − 4b₂b₀.

    `damping` is the case in words, empty where parameters decide it or the damping is negative (`sign` is that of
    b₁, None where it is open).
    """

    coefficients: tuple[sp.Expr, sp.Expr, sp.Expr]
    omega_n: sp.Expr
    zeta: sp.Expr
    square: sp.Expr
    twice: sp.Expr
    damping: str
    sign: int | None

    @property
    def discriminant(self) -> sp.Expr:
        """b₁² − 4b₂b₀, negative for a conjugate pair."""
        b2, b1, b0 = self.coefficients
        return sp.expand(b1**2 - 4 * b2 * b0)


class NoFrequency(Exception):  # noqa: N818 - it is a finding
    """ω_n² = `square` is not positive: there is no natural frequency."""

    def __init__(self, square: sp.Expr) -> None:
        super().__init__(str(square))
        self.square = square


def damping_of(coefficients: Sequence[sp.Expr]) -> Damping:
    """ω_n and ζ of a polynomial of degree two, highest power first; raises NoFrequency where b₀/b₂ ≤ 0."""
    b2, b1, b0 = coefficients
    if sign_of(b2) == -1:
        b2, b1, b0 = -b2, -b1, -b0
    square, twice = sp.cancel(b0 / b2), sp.cancel(b1 / b2)
    if sign_of(square) in (0, -1):
        raise NoFrequency(square)
    omega_n = square_root(square)
    above, below = sp.fraction(twice)
    zeta = sp.radsimp(twice / (2 * omega_n)) if not (square.free_symbols) else above / (
        2 * square_root(sp.factor(square * below**2))
    )  # fmt: skip
    sign = sign_of(b1)
    found = Damping((b2, b1, b0), omega_n, zeta, square, twice, "", sign)
    word = "undamped" if sign == 0 else "" if sign != 1 else {
        -1: "underdamped", 0: "critically damped", 1: "overdamped"
    }.get(sign_of(found.discriminant), "")  # type: ignore[arg-type]  # None is no key  # fmt: skip
    return Damping((b2, b1, b0), omega_n, zeta, square, twice, word, sign)


def poles_of_damping(found: Damping) -> list[sp.Expr]:
    """The roots −ζω_n ± √(ζ² − 1) ω_n, the upper one, or the slower one, first; empty where parameters decide."""
    sign = sign_of(found.discriminant)
    if sign is None:
        return []
    center = -found.twice / 2
    if sign == 0:
        return [center, center]
    apart = square_root(sp.factor(sign * (found.twice**2 / 4 - found.square)))
    apart = sp.I * apart if sign < 0 else apart
    return [center + apart, center - apart]


def damped_frequency(found: Damping) -> sp.Expr | None:
    """ω_d = ω_n √(1 − ζ²) of a conjugate pair."""
    pair = sign_of(found.discriminant) == -1
    return square_root(sp.factor(found.square - found.twice**2 / 4)) if pair else None


def damping_parameter(coefficients: Sequence[sp.Expr]) -> sp.Symbol | None:
    """The only parameter, or the only one on which the coefficient of s alone depends."""
    return _natural(damping_of(coefficients))


@dataclass(frozen=True)
class Cases:
    """Where each case of damping holds, by its name; the value of `parameter` at which the damping is critical."""

    parameter: sp.Symbol | None
    where: dict[str, Any]
    critical: sp.Expr | None
    rising: bool | None


def damping_cases(found: Damping, wanted: sp.Symbol | None = None) -> Cases:
    """The cases in terms of a parameter (None: the one that only the damping depends on, or the only one).

    Cases that the assumptions exclude are left out.
    """
    p = wanted or _natural(found)
    critical = _critical(found, p) if p is not None else []
    if p is not None and len(critical) == 1:
        rising = sign_of(sp.diff(found.discriminant, p).subs(p, critical[0]))
        if rising:
            return Cases(p, dict(_on_both_sides(found, p, critical[0], rising > 0)), critical[0], rising > 0)
    return Cases(p, dict(_unsolved(found, p, critical)), critical[0] if len(critical) == 1 else None, None)


def _natural(found: Damping) -> sp.Symbol | None:
    """The only parameter, or the only one that b₁ alone depends on."""
    b2, b1, b0 = found.coefficients
    every = (b2 + b1 + b0).free_symbols | b1.free_symbols
    alone = b1.free_symbols - b2.free_symbols - b0.free_symbols
    chosen = every if len(every) == 1 else alone
    only: Any = next(iter(chosen)) if len(chosen) == 1 else None
    return only


def _critical(found: Damping, p: sp.Symbol) -> list[sp.Expr]:
    """The zeros of the discriminant in p at which the damping is positive."""
    d = found.discriminant
    if not d.is_polynomial(p) or not 1 <= sp.degree(d, p) <= 2:
        return []
    listed = sp.Poly(d, p).all_coeffs()
    if len(listed) == 2:
        roots = [sp.factor(-listed[1] / listed[0])]
    else:
        a, b, c = listed
        root = square_root(sp.factor(b**2 / 4 - a * c))
        roots = list(dict.fromkeys(sp.factor((-b / 2 + sign * root) / a) for sign in (1, -1)))
    if any(root.has(sp.I) for root in roots):
        return []
    admitted = [root for root in roots if _admitted(found, p, root)]
    damping = [sp.factor(found.coefficients[1].subs(p, root)) for root in admitted]
    positive = [root for root, b1 in zip(admitted, damping, strict=True) if not b1.could_extract_minus_sign()]
    return positive if len(positive) == 1 else admitted


def _admitted(found: Damping, p: sp.Symbol, value: sp.Expr) -> bool:
    """Whether a value of p is not against what is assumed of it, and leaves b₁ and b₀ positive."""
    own = sign_of(value)
    against = (p.is_positive and own in (0, -1)) or (p.is_negative and own in (0, 1)) or (p.is_nonzero and own == 0)
    signs = [sign_of(sp.cancel(each.subs(p, value))) for each in found.coefficients]
    return not against and all(sign not in (0, -1) for sign in signs)


def _on_both_sides(found: Damping, p: sp.Symbol, critical: sp.Expr, rising: bool) -> Iterator[tuple[str, Any]]:
    """The cases below and above the critical value, within the bounds that b₁ > 0 and b₀ > 0 set."""
    _, b1, b0 = found.coefficients
    undamped = _zero_of(b1, p)
    if undamped is not None and _admits_zero(found, p, undamped):
        yield UNDAMPED, sp.Eq(p, undamped)
    under, over = (sp.Lt, sp.Gt) if rising else (sp.Gt, sp.Lt)
    yield UNDERDAMPED, sp.And(under(p, critical), *_bounds([b1], p, above=not rising))
    yield CRITICAL, sp.Eq(p, critical)
    yield OVERDAMPED, sp.And(over(p, critical), *_bounds([b1, b0], p, above=rising))


def _zero_of(b: sp.Expr, p: sp.Symbol) -> sp.Expr | None:
    """Where b, linear in p, is zero; None where it does not depend on p, or not in this way."""
    if not b.is_polynomial(p) or sp.degree(b, p) != 1:
        return None
    a, c = sp.Poly(b, p).all_coeffs()
    return sp.factor(-c / a)


def _admits_zero(found: Damping, p: sp.Symbol, value: sp.Expr) -> bool:
    """Whether the damping may be zero there."""
    own = sign_of(value)
    against = (p.is_positive and own in (0, -1)) or (p.is_negative and own in (0, 1)) or (p.is_nonzero and own == 0)
    b2, _, b0 = found.coefficients
    return not against and sign_of(sp.cancel((b0 * b2).subs(p, value))) not in (0, -1)


def _bounds(positive: Sequence[sp.Expr], p: sp.Symbol, *, above: bool) -> Iterator[Any]:
    """What b > 0 asks of p on one side of the critical value, without what is said already."""
    for b in positive:
        bound = _zero_of(b, p)
        if bound is None:
            continue
        slope = sign_of(sp.Poly(b, p).all_coeffs()[0])
        if slope is None:
            yield sp.Gt(b, 0)
        elif (slope > 0) != above:  # on the same side it follows
            known = p.is_positive if slope > 0 and bound == 0 else p.is_negative if slope < 0 and bound == 0 else None
            if not known:
                yield sp.Gt(p, bound) if slope > 0 else sp.Lt(p, bound)


def _unsolved(found: Damping, p: sp.Symbol | None, critical: Sequence[sp.Expr]) -> Iterator[tuple[str, Any]]:
    """The cases by the coefficients themselves."""
    b2, b1, b0 = found.coefficients
    d, wanted = found.discriminant, [p] if p is not None else []
    if found.sign is None:
        zero = _zero_of(b1, p) if p is not None else None
        if zero is None or _admits_zero(found, p, zero):  # type: ignore[arg-type]  # p is there where zero is
            yield UNDAMPED, sp.Eq(p, zero) if zero is not None else sp.Eq(b1, 0)
    conditions = {
        UNDERDAMPED: all_positive([b1, b2, -d], wanted),
        CRITICAL: sp.Or(*(sp.Eq(p, each) for each in critical)) if critical else sp.Eq(b1, 2 * square_root(b2 * b0)),
        OVERDAMPED: all_positive([b1, b2, b0, d], wanted),
    }
    for name, condition in conditions.items():
        if name == CRITICAL and p is not None and not critical and len(d.free_symbols) == 1:
            continue  # never
        if condition not in (sp.false, sp.true):
            yield name, condition
