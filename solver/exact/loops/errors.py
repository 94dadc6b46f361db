"""What remains of an error: the limit of s E(s), and the constants of a loop that tell it.

E has poles inside, which die out, and at the origin, which remain; any other pole is of a signal that goes on.
In discrete time it is the limit of (1 − z⁻¹) E(z), inside is the unit disc, and in place of the origin stands z = 1.
Source: Ogata, Discrete-Time Control Systems, section 4-4.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.signs import is_positive
from solver.exact.stability.conditions import all_positive
from solver.exact.stability.inequalities import sign_of
from solver.exact.stability.location import is_stable_polynomial
from solver.exact.time_response.input_generators import read_inputs
from solver.exact.time_response.signals import read_signal, written


@dataclass(frozen=True)
class ErrorConstants:
    """The number of integrators of L, at least 0, and the limits of L, s L and s² L for s → 0 from above.

    In discrete time those of L, (z − 1) L and (z − 1)² L for z → 1.
    A limit is ∞ or −∞ where there are more integrators, or None where parameters decide which; `lead` is the limit of
    sᵏ L, of (z − 1)ᵏ L, that is neither zero nor infinite. `constants` are K_p, K_v, K_a: the limits, in discrete time
    over 1, T, T²; None also where T is needed and is not known.
    """

    integrators: int
    limits: tuple[sp.Expr | None, ...]
    lead: sp.Expr
    constants: tuple[sp.Expr | None, ...]


@dataclass(frozen=True)
class LongRun:
    """What E(s) says of e(t) for t → ∞: its pole at the origin of this order, and lim sᵒʳᵈᵉʳ E there.

    In discrete time its pole at z = 1, and lim (z − 1)ᵒʳᵈᵉʳ E there.

    `others` is the polynomial of the poles that are neither at the origin nor known to be inside, 1 without; `settles`:
    they are inside all the same (None: parameters decide). `value` is the limit of e, which may be infinite; None where
    there is none or the sign of an infinite one is not known. `quotient` is the lead as what is put in leaves it, the
    numerator and the denominator at the origin.
    """

    order: int
    lead: sp.Expr
    others: sp.Expr
    settles: bool | None
    value: sp.Expr | None
    quotient: tuple[sp.Expr, sp.Expr]


def lasting(signal: sp.Expr, t: sp.Symbol, *, discrete: bool = False) -> sp.Expr:
    """A signal as it is once all has begun: steps are one, impulses are over; raises NotExact for other functions."""
    read = read_signal(signal, t, discrete=discrete)
    return sp.Add(*(c * written(term, t, discrete=discrete) for (_, term), c in read.terms.items()))


def usual_parts(signal: sp.Expr, t: sp.Symbol, period: sp.Expr = sp.S.One) -> tuple[sp.Expr, ...] | None:
    """The c₀, c₁, c₂ of c₀ + c₁ t + c₂ t²/2, in discrete time with kT for t; None for other signals."""
    if not signal.is_polynomial(t) or sp.degree(signal, t) > 2:
        return None
    p = sp.Poly(signal, t)
    c, b, a = p.nth(0), p.nth(1), 2 * p.nth(2)
    return (c, b, a) if period == 1 else (c, sp.cancel(b / period), sp.cancel(a / period**2))


def error_constants(
    numerator: sp.Expr,
    denominator: sp.Expr,
    s: sp.Symbol,
    positive: Sequence[sp.Expr] = (),
    *,
    discrete: bool = False,
    period: sp.Expr | None = None,
) -> ErrorConstants:
    """The constants of L = numerator/denominator, common factors cancelled, where some expressions are positive.

    In discrete time with the sampling period, None where it is not known.
    """
    top, bottom = (_beside(p, discrete=discrete) for p in _lowest(numerator / denominator, s))
    zeros, poles = _at_origin(top), _at_origin(bottom)
    integrators = max(poles - zeros, 0)
    lead = _quotient(top.nth(zeros), bottom.nth(poles))
    limits: list[sp.Expr | None] = []
    for power in range(3):
        excess = poles - zeros - power
        sign = _sign_where(lead, positive) if excess > 0 else 0
        infinite = None if sign is None else sign * sp.oo
        limits.append(infinite if excess > 0 else lead if excess == 0 else sp.S.Zero)
    constants = tuple(_over_time(each, power, period) for power, each in enumerate(limits)) if discrete else limits
    return ErrorConstants(integrators, tuple(limits), lead, tuple(constants))


def _over_time(limit: sp.Expr | None, power: int, period: sp.Expr | None) -> sp.Expr | None:
    """A limit over Tⁿ; None where that is not known."""
    if power == 0 or limit in (None, 0, sp.oo, -sp.oo):
        return limit
    return None if period is None else tidy(sp.cancel(limit / period**power))


def integrators_apart(D: sp.Expr, s: sp.Symbol, *, discrete: bool = False) -> tuple[sp.Expr, int]:
    """A polynomial without its roots at the origin (at z = 1), and how many these are."""
    p = sp.Poly(D, s)
    count = _at_origin(_beside(p, discrete=discrete))
    return sp.quo(p, sp.Poly((s - 1 if discrete else s) ** count, s)).as_expr(), count


def long_run(
    E: sp.Expr, s: sp.Symbol, inside: sp.Expr, positive: Sequence[sp.Expr] = (), *, discrete: bool = False
) -> LongRun:
    """What remains of e; the roots of the polynomial `inside` are known to be there, and these to be `positive`."""
    lowest = _lowest(E, s)
    top, bottom = (_beside(p, discrete=discrete) for p in lowest)
    order = _at_origin(bottom)
    lead = _quotient(top.nth(0), bottom.nth(order)) if order else sp.S.Zero
    integrators = sp.Poly((s - 1 if discrete else s) ** order, s)
    others = besides(sp.quo(lowest[1], integrators), sp.Poly(inside, s))
    settles = is_stable_polynomial(others.all_coeffs(), discrete=discrete) if others.degree() > 0 else True
    value = None
    if settles:
        sign = _sign_where(lead, positive) if order > 1 else None
        value = lead if order < 2 else None if sign is None else sign * sp.oo
    put_in = (top.nth(0), bottom.nth(order)) if order else (sp.S.Zero, sp.S.One)
    return LongRun(order, lead, others.as_expr(), settles, value, put_in)


def _beside(p: sp.Poly, *, discrete: bool) -> sp.Poly:
    """A polynomial in z as one in z − 1; one in s as it is."""
    return p.compose(sp.Poly(p.gen + 1, p.gen)) if discrete else p


def _lowest(F: sp.Expr, s: sp.Symbol) -> tuple[sp.Poly, sp.Poly]:
    """Numerator and denominator of a rational function in lowest terms."""
    above, below = sp.fraction(sp.cancel(sp.together(F)))
    return sp.Poly(above, s), sp.Poly(below, s)


def _quotient(above: sp.Expr, below: sp.Expr) -> sp.Expr:
    """The quotient in the form a person would write, e^{−aT} treated as a letter."""
    found = above / below
    return sp.factor(sp.cancel(found)) if found.has(sp.exp) else tidy(found)


def _at_origin(p: sp.Poly) -> int:
    """How often s divides a polynomial; 0 of the zero polynomial."""
    return 0 if p.is_zero else min(powers[0] for powers in p.monoms())


def besides(p: sp.Poly, inside: sp.Poly) -> sp.Poly:
    """A polynomial without the roots that another one has, whatever their multiplicities."""
    common = sp.gcd(p, inside)
    while common.degree() > 0:
        p = sp.quo(p, common)
        common = sp.gcd(p, common)
    return p


def _sign_where(x: sp.Expr, positive: Sequence[sp.Expr]) -> int | None:
    """The sign of x where some expressions are positive; None where that does not decide it."""
    sign = sign_of(x)
    if sign is not None or not positive:
        return sign
    if is_positive(x):
        return 1
    return next((sign for sign in (1, -1) if all_positive([*positive, -sign * x]) is sp.false), None)


def error_transform(transfer: sp.Expr, image: sp.Expr) -> sp.Expr:
    """The product in lowest terms, numerator and denominator as products of their factors."""
    above, below = sp.fraction(sp.cancel(sp.together(transfer * image)))
    product: sp.Expr = sp.factor(above) / sp.factor(below)
    return product


def rational(F: sp.Expr) -> sp.Expr:
    """A quotient of quotients as one of polynomials in lowest terms."""
    quotient: sp.Expr = sp.cancel(sp.together(F))
    return quotient


def transform_of(signal: sp.Expr, t: sp.Symbol, s: sp.Symbol, *, discrete: bool = False) -> sp.Expr:
    """The transform of a signal that begins at zero and does not jump later."""
    (piece,) = read_inputs([signal], t, discrete=discrete)
    image: sp.Expr = piece.image(s, discrete=discrete)[0]
    return sp.factor(image) if image.free_symbols - {s} else image


def held_where(positive: Sequence[sp.Expr]) -> Any:
    """Where some expressions are positive, as a condition on parameters; true or false where these do not decide."""
    signs = [sign_of(each) for each in positive]
    if all(sign == 1 for sign in signs):
        return sp.true
    return sp.false if any(sign in (0, -1) for sign in signs) else all_positive(positive)
