"""The second variation ∫ P u² + 2 Q u u' + R u'² dt, Jacobi's equation, and points conjugate to the start.

Source: Gelfand and Fomin, Calculus of Variations, §§24–29.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.signs import possible_signs
from solver.exact.stability.inequalities import real_roots, sign_of
from solver.exact.variations.along import along, in_time
from solver.exact.variations.signs_in_time import Open, first_zero, signs_in_time
from solver.exact.variations.table_of_integrals import plain_roots

STRETCHES = 12
"""A first zero is looked for so many times the time from start to end."""
LARGEST = 4


@dataclass(frozen=True)
class SecondVariation:
    """φ_xx, φ_xx' and φ_x'x' along an extremal, as functions of time."""

    P: sp.Expr
    Q: sp.Expr
    R: sp.Expr

    def rest(self, t: sp.Symbol) -> sp.Expr:
        """P − dQ/dt: Jacobi's equation is d/dt (R u') = (P − Q') u."""
        return tidy(self.P - sp.diff(self.Q, t))


@dataclass(frozen=True)
class Conjugate:
    """The first zero after the start; `point` is None where there is none, or none until `searched`."""

    point: sp.Expr | None
    searched: sp.Expr | None = None


def second_variation(
    phi: sp.Expr, q: sp.Symbol, rate: sp.Symbol, jets: Mapping[sp.Symbol, sp.Expr], t: sp.Symbol
) -> SecondVariation:
    """φ's second derivatives by x and x' with the extremal put in."""
    found = [in_motion(sp.diff(phi, a, b), jets, t) for a, b in ((q, q), (q, rate), (rate, rate))]
    return SecondVariation(*found)


def in_motion(expression: sp.Expr, jets: Mapping[sp.Symbol, sp.Expr], t: sp.Symbol) -> sp.Expr:
    """An expression in the functions and their derivatives along an extremal, in t."""
    put_in = expression.xreplace(dict(jets))
    return along(plain_roots(sp.factor(put_in) if put_in.has(sp.Pow) and not put_in.is_polynomial(t) else put_in), t)


def jacobi_equation(of: SecondVariation, u: Sequence[sp.Symbol], t: sp.Symbol) -> sp.Expr:
    """R u'' + R' u' − (P − Q') u, which is zero, in the symbols u, u', u''."""
    return sp.Add(of.R * u[2], sp.diff(of.R, t) * u[1], -of.rest(t) * u[0])


def hessian(phi: sp.Expr, variables: Sequence[sp.Symbol]) -> sp.ImmutableMatrix:
    """The second derivatives of φ, tidied."""
    return sp.ImmutableMatrix(
        len(variables), len(variables), lambda i, j: _short(sp.diff(phi, variables[i], variables[j]))
    )


def _short(value: sp.Expr) -> sp.Expr:
    """The shorter of an expression and its factors."""
    factored = sp.factor(value)
    return factored if sp.count_ops(factored) <= sp.count_ops(value) else value


def bending(H: sp.ImmutableMatrix, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> str:
    """Return "convex" or "concave" for φ with this matrix of second derivatives, everywhere; "" where that is open."""
    if H.rows > LARGEST or H.is_zero_matrix:
        return ""
    for word, sign in (("convex", 1), ("concave", -1)):
        if all(_signs(minor, t, start, stop) <= {0, 1} for minor in _minors(sp.ImmutableMatrix(sign * H))):
            return word
    return ""


def _minors(H: sp.ImmutableMatrix) -> Iterator[sp.Expr]:
    """All principal minors: none is negative where, and only where, H is positive semidefinite."""
    for size in range(1, H.rows + 1):
        for rows in combinations(range(H.rows), size):
            yield sp.factor(H.extract(list(rows), list(rows)).det(method="berkowitz"))


def _signs(value: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> frozenset[int]:
    if not value.has(t) or value.free_symbols == {t}:
        found = signs_in_time(value, t, start, stop) if value.has(t) else frozenset(possible_signs(value))
        return found if found is not None else frozenset({1, -1})
    known = {1: "positive", 0: "nonnegative"}.get(-1 if (sign := sign_of(start)) is None else sign, "real")
    return frozenset(possible_signs(value.xreplace({t: sp.Dummy("t", **{known: True})})))


def definite_in_time(R: sp.ImmutableMatrix, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> str:
    """What a matrix in t is over the time, its ends among it: "positive", "negative" definite or semidefinite.

    "changing" where some direction has both signs, or different ones have; "" where that is not decided.
    """
    entries = [signs_in_time(R[i, i], t, start, stop) for i in range(R.rows)]
    if any(each is not None and {1, -1} <= each for each in entries):
        return "changing"
    seen = frozenset().union(*(each for each in entries if each is not None))
    if {1, -1} <= seen:
        return "changing"
    for word, sign in (("positive", 1), ("negative", -1)):
        leading = [sp.factor((sign * R)[:k, :k].det(method="berkowitz")) for k in range(1, R.rows + 1)]
        if all(signs_in_time(minor, t, start, stop) == frozenset({1}) for minor in leading):
            return word
        minors = [signs_in_time(minor, t, start, stop) for minor in _minors(sp.ImmutableMatrix(sign * R))]
        if all(each is not None and each <= {0, 1} for each in minors):
            return f"{word} semidefinite"
    return ""


def conjugate(u: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> Conjugate | None:
    """The first zero after the start of u with u = 0, u' = 1 there; None where that is not decided."""
    for form in (_of_exponentials, _of_powers):
        found = form(u, t, start)
        if found is not None:
            return found
    if (u.free_symbols | start.free_symbols | stop.free_symbols) - {t}:
        return None
    if u.is_rational_function(t):
        later = [root for root in real_roots(sp.numer(sp.together(u)), t) if sign_of(sp.expand(root - start)) == 1]
        return Conjugate(min(later, key=sp.N, default=None))
    for stretches in (STRETCHES, sp.Rational(11, 10)):
        until = start + stretches * (stop - start)
        try:
            return Conjugate(first_zero(u, t, start, until), until)
        except (Open, ZeroDivisionError, ValueError):
            continue
    return None


def first_zero_from(u: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> Conjugate | None:
    """The first zero after the start, up to the end, of u with u = 1 there; None where that is not decided."""
    if u.is_rational_function(t) and u.free_symbols <= {t}:
        later = [root for root in real_roots(sp.numer(sp.together(u)), t) if sign_of(sp.expand(root - start)) == 1]
        return Conjugate(min(later, key=sp.N, default=None))
    signs = signs_in_time(u, t, start, stop)
    if signs == frozenset({1}):
        return Conjugate(None, stop)
    if signs is None or signs <= {0, 1} or u.free_symbols - {t}:
        return None
    try:
        return Conjugate(first_zero(u, t, start, stop), stop)
    except (Open, ZeroDivisionError, ValueError):
        return None


def with_values(
    general: sp.Expr,
    constants: Sequence[sp.Symbol],
    t: sp.Symbol,
    start: sp.Expr,
    values: tuple[sp.Expr, sp.Expr],
) -> sp.Expr | None:
    """The member of a family, linear in two constants, with this value and slope at the start; None if none has."""
    sides = [general.subs(t, start), sp.diff(general, t).subs(t, start)]
    if any(side.has(sp.nan, sp.zoo, sp.oo) for side in sides) or len(constants) != 2:
        return None
    M = sp.Matrix([[sp.diff(side, c) for c in constants] for side in sides])
    det = M.det(method="berkowitz")
    if sign_of(tidy(sp.expand(det))) == 0:
        return None
    right = sp.Matrix(
        [value - side.subs(dict.fromkeys(constants, 0)) for side, value in zip(sides, values, strict=True)]
    )
    found = [tidy(sp.cancel(each / det)) for each in M.adjugate() * right]
    return in_time(general.subs(dict(zip(constants, found, strict=True))), t)


def _of_exponentials(u: sp.Expr, t: sp.Symbol, start: sp.Expr) -> Conjugate | None:
    """The zero of e^{σt} sin ω(t − a), whatever it is written as; none of e^{λt} − c e^{μt} and (t − a) e^{λt}."""
    rates = _rates(u, t)
    if rates is None:
        return None
    angle, envelopes = rates
    powers = {power for _, power in envelopes}
    if angle is None:
        plain = len(envelopes) <= 2 and (powers == {0} or len({rate for rate, _ in envelopes}) == 1)
        return Conjugate(None) if plain else None
    if len(envelopes) != 1 or powers != {0} or sign_of(angle) == 0:
        return None
    sign = sign_of(angle)
    speed = sp.Abs(angle) if sign is None else sign * angle
    return Conjugate(sp.expand(start + sp.pi / speed))


def _rates(u: sp.Expr, t: sp.Symbol) -> tuple[sp.Expr | None, set[tuple[sp.Expr, int]]] | None:
    """The one angular frequency of the waves, and the exponents λ of e^{λt} (two for t e^{λt}); None for other sums."""
    angles, envelopes = set(), set()
    for term in sp.Add.make_args(sp.expand(u.rewrite(sp.exp) if u.has(sp.sinh, sp.cosh) else u, power_exp=False)):
        exponent, power, wave = sp.S.Zero, 0, None
        for factor in sp.Mul.make_args(term):
            if not factor.has(t):
                continue
            argument: Any = factor.args[0] if factor.args else None
            if factor == t:
                power += 1
            elif isinstance(factor, sp.exp) and not sp.diff(argument, t).has(t):
                exponent += sp.diff(argument, t)
            elif isinstance(factor, sp.sin | sp.cos) and not sp.diff(argument, t).has(t) and wave is None:
                wave = sp.diff(argument, t)
            else:
                return None
        angles.add(wave)
        envelopes.add((sp.expand(exponent), power))
    if len(angles) != 1 or any(power > 1 for _, power in envelopes):
        return None
    (angle,) = angles
    return angle, envelopes


def _of_powers(u: sp.Expr, t: sp.Symbol, start: sp.Expr) -> Conjugate | None:
    """The same for powers of t > 0: tᵐ is e^{ms} and a sine of log t one of s = log t."""
    if sign_of(start) != 1 or not u.has(t):
        return None
    s = sp.Dummy("s", real=True)
    turned = sp.expand_power_base(sp.expand_log(u.xreplace({t: sp.exp(s)}), force=True), force=True)
    turned = sp.expand(sp.powdenest(turned, force=True).xreplace({sp.log(sp.exp(s)): s}))
    found = _of_exponentials(turned, s, sp.log(start))
    if found is None or found.point is None:
        return found
    return Conjugate(start * sp.exp(sp.expand(found.point - sp.log(start))))
