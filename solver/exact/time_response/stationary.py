"""Where the slope of a response is zero: of one conjugate pair, of two real modes, of a repeated one, exactly."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.signs import is_positive
from solver.exact.linear_algebra.spectrum import Root


@dataclass(frozen=True)
class Stationary:
    """The slope as a function of time, and its first zeros for t > 0 (of a pair two, else all).

    `kind` is pair, modes, repeated or searched; `equation` is what the slope is brought to, as left and right side.
    """

    kind: str
    slope: sp.Expr
    equation: tuple[sp.Expr, sp.Expr] | None
    times: Sequence[sp.Expr]


def stationary(y: sp.Expr, modes: Sequence[tuple[Root, int]], t: sp.Symbol) -> Stationary | None:
    """The zeros of the slope of y, a constant and these modes with their orders; None for other modes than above."""
    slope = [sp.expand(sp.diff(y, t, i).subs(t, 0)) for i in (1, 2)]
    if len(modes) > 2:  # as all factors with decimal roots have
        return None
    if len(modes) == 2 and all(order == 1 for _, order in modes):
        (first, _), (second, _) = modes
        if first.kind == "complex":
            return _of_pair(first if is_positive(first.shift) else second, slope, t)
        return _of_two(first.value, second.value, slope, t)
    return _of_repeated(y, modes[0][0].value, t) if len(modes) == 1 else None


def _of_pair(root: Root, slope: list[sp.Expr], t: sp.Symbol) -> Stationary:
    """Zeros of e^{σt}(a cos ωt + b sin ωt): tan ωt = −a/b."""
    a, omega = slope[0], root.shift
    b = sp.radsimp(sp.expand((slope[1] - root.sigma * a) / omega))
    whole = sp.exp(root.sigma * t) * (a * sp.cos(omega * t) + b * sp.sin(omega * t))
    if a == 0:
        angle, equation = sp.pi, (sp.sin(omega * t), sp.S.Zero)
    elif b == 0:
        angle, equation = sp.pi / 2, (sp.cos(omega * t), sp.S.Zero)
    else:
        tangent = sp.radsimp(-a / b)
        angle, equation = sp.atan(tangent), (sp.tan(omega * t), tangent)
    first = angle if angle.is_positive else angle + sp.pi
    return Stationary("pair", whole, equation, [sp.radsimp(first / omega), sp.radsimp((first + sp.pi) / omega)])


def _of_two(p: sp.Expr, q: sp.Expr, slope: list[sp.Expr], t: sp.Symbol) -> Stationary:
    """Zeros of c e^{pt} + d e^{qt}."""
    d = (slope[1] - p * slope[0]) / (q - p)
    c = slope[0] - d
    whole = sp.radsimp(sp.expand(c)) * sp.exp(p * t) + sp.radsimp(sp.expand(d)) * sp.exp(q * t)
    ratio = sp.radsimp(sp.expand(-d / c)) if sp.expand(c) != 0 else sp.S.Zero
    if not ratio.is_positive:
        return Stationary("modes", whole, None, [])
    if (1 - ratio).is_positive:
        ratio, p, q = sp.radsimp(1 / ratio), q, p
    apart = sp.radsimp(sp.expand(p - q))
    return Stationary("modes", whole, (sp.exp(apart * t), ratio), [sp.radsimp(sp.log(ratio) / apart)])


def _of_repeated(y: sp.Expr, p: sp.Expr, t: sp.Symbol) -> Stationary | None:
    """Zeros of q(t) e^{pt}, q a polynomial, of degree two at most beside its zeros at t = 0."""
    q = sp.Poly(sp.expand(sp.expand(sp.diff(y, t)) * sp.exp(-p * t), power_exp=True), t)
    whole = sp.factor(q.as_expr()) * sp.exp(p * t)
    rest = q.quo(sp.Poly(t ** min(power for (power,), _ in q.terms()), t))
    if rest.degree() > 2:
        return None
    times = [root for root in map(sp.radsimp, sp.roots(rest)) if root.is_positive]
    equation = (rest.as_expr(), sp.S.Zero) if rest.degree() else None
    return Stationary("repeated", whole, equation, sorted(times, key=sp.N))
