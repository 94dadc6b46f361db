"""PID controllers K_p + K_i/s + K_d s: their rules of thumb, the loop that they close, gains by comparing coefficients.

The rules are those of J. G. Ziegler and N. B. Nichols, Trans. ASME 64, 1942.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import sympy as sp

from solver.exact.design.placement import monic, roots_of
from solver.exact.linear_algebra.affine import affine, solve_affine, tidy
from solver.exact.linear_algebra.spectrum import DIGITS


class Gains(NamedTuple):
    """The gains of the error, of its integral and of its derivative."""

    K_p: sp.Expr
    K_i: sp.Expr
    K_d: sp.Expr


@dataclass(frozen=True)
class TuningRule:
    """A row of a table of Ziegler and Nichols: K_p = `gain` times a gain, T_i and T_d as multiples of a time."""

    gain: sp.Rational
    integral: sp.Rational | None = None
    derivative: sp.Rational | None = None


def tuning_rules(of: str) -> dict[str, TuningRule]:
    """Return the rules by kind of controller, "ultimate": of K_u and T_u; "step": of 1/(R L) and L."""
    r = sp.Rational
    if of == "ultimate":
        return {
            "P": TuningRule(r(1, 2)),
            "PI": TuningRule(r(9, 20), r(5, 6)),
            "PID": TuningRule(r(3, 5), r(1, 2), r(1, 8)),
        }
    return {"P": TuningRule(r(1)), "PI": TuningRule(r(9, 10), r(10, 3)), "PID": TuningRule(r(6, 5), r(2), r(1, 2))}


@dataclass(frozen=True)
class Tuned:
    """The gains, and the times T_i and T_d where the controller has them."""

    gains: Gains
    T_i: sp.Expr | None = None
    T_d: sp.Expr | None = None


def tuned(rule: TuningRule, gain: sp.Expr, time: sp.Expr) -> Tuned:
    """Return the gains that a rule gives for the gain and the time that it is about."""
    K_p = _one_quotient(rule.gain * gain)
    T_i = _one_quotient(rule.integral * time) if rule.integral is not None else None
    T_d = _one_quotient(rule.derivative * time) if rule.derivative is not None else None
    K_i = _one_quotient(K_p / T_i) if T_i is not None else sp.Integer(0)
    K_d = _one_quotient(K_p * T_d) if T_d is not None else sp.Integer(0)
    return Tuned(Gains(K_p, K_i, K_d), T_i, T_d)


def _one_quotient(value: sp.Expr) -> sp.Expr:
    """A number without fractions in fractions: with powers of e one quotient in lowest terms, its denominator > 0."""
    if not value.has(sp.exp) or value.has(sp.Float) or value.free_symbols:
        return tidy(value)
    above, below = sp.fraction(sp.cancel(sp.together(value)))
    sign = -1 if sp.N(below) < 0 else 1
    return sp.expand(sign * above) / sp.expand(sign * below)


def gains_of(values: Sequence[sp.Expr]) -> Gains:
    """Return K_p, K_i, K_d; those that are not there are zero."""
    filled = [*values, *[sp.Integer(0)] * (3 - len(values))]
    return Gains(filled[0], filled[1], filled[2])


def pid_parts(gains: Gains, s: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """Return numerator and denominator of the controller: (K_d s² + K_p s + K_i)/s, or K_d s + K_p where K_i = 0."""
    K_p, K_i, K_d = gains
    if any(gain.free_symbols for gain in gains):
        top, bottom = sp.fraction(sp.together(sp.Add(K_p, K_i / s, K_d * s)))
        return _collected(top, s), bottom
    if K_i == 0:
        return sp.Add(K_d * s, K_p), sp.Integer(1)
    return sp.Add(K_d * s**2, K_p * s, K_i), s


@dataclass(frozen=True)
class ClosedLoop:
    """T = `numerator`/`denominator` of unity feedback, nothing cancelled; its poles where all is a number."""

    numerator: sp.Expr
    denominator: sp.Expr
    poles: tuple[sp.Expr, ...]
    stable: bool | None


def closed_by(controller: tuple[sp.Expr, sp.Expr], plant: tuple[sp.Expr, sp.Expr], s: sp.Symbol) -> ClosedLoop:
    """Return the loop C G/(1 + C G) of C and G, each as numerator and denominator (polynomials in s)."""
    top = _collected(controller[0] * plant[0], s)
    bottom = _collected(controller[1] * plant[1] + controller[0] * plant[0], s)
    if (top.free_symbols | bottom.free_symbols) - {s}:
        return ClosedLoop(top, bottom, (), None)
    poles = _poles(bottom, s)
    return ClosedLoop(top, bottom, poles, all(sp.re(sp.N(pole, DIGITS)) < 0 for pole in poles))


def _collected(p: sp.Expr, s: sp.Symbol) -> sp.Expr:
    """A polynomial by powers of s, each coefficient as a person writes it."""
    return sp.Add(*(_one_quotient(c) * s**k for (k,), c in sp.Poly(p, s).terms()))


def _poles(p: sp.Expr, s: sp.Symbol) -> tuple[sp.Expr, ...]:
    """The roots: exact where the coefficients are rational and the factors short, else in decimals."""
    listed = sp.Poly(p, s).all_coeffs()
    if all(c.is_Rational for c in listed):
        return tuple(roots_of([c / listed[0] for c in listed]))
    found = sp.Poly([sp.N(c, DIGITS + 10) for c in listed], s).nroots(n=DIGITS, maxsteps=300)
    return tuple(sorted((sp.N(root, DIGITS) for root in found), key=_place))


def _place(root: sp.Expr) -> tuple[float, float]:
    """Roots by their real parts, of a pair the upper one first."""
    z = complex(root)
    return round(z.real, 12), -z.imag


@dataclass(frozen=True)
class ComparedGains:
    """Coefficients, highest first, of the polynomial with the unknown gains and of the one wanted, and the gains.

    `gains` is None where no gains give the poles: then `conditions` are what is left, expressions that are not zero.
    `free`: other gains do it too.
    """

    unknowns: tuple[sp.Symbol, ...]
    own: tuple[sp.Expr, ...]
    wanted: tuple[sp.Expr, ...]
    gains: Gains | None
    conditions: tuple[sp.Expr, ...] = ()
    free: bool = False


def placed_gains(
    numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol, kind: str, poles: Sequence[sp.Expr]
) -> ComparedGains:
    """Return the gains of a P, PI or PID controller with these poles of the loop, compared coefficient by coefficient.

    The polynomial wanted has the leading coefficient of the loop's own. As many poles as the loop has are needed.
    """
    letters = {"P": ("K_p",), "PI": ("K_p", "K_i"), "PID": ("K_p", "K_i", "K_d")}[kind]
    unknowns = tuple(sp.Symbol(letter) for letter in letters)
    K_p, K_i, K_d = gains_of(unknowns)
    top, bottom = (K_p, sp.Integer(1)) if kind == "P" else (K_d * s**2 + K_p * s + K_i, s)
    own = tuple(sp.Poly(bottom * denominator + top * numerator, s).all_coeffs())
    wanted = tuple(sp.expand(own[0] * c) for c in monic(poles))
    M, rest = affine([a - b for a, b in zip(own, wanted, strict=True)], unknowns)
    solution = solve_affine(M, [-c for c in rest], unknowns)
    if solution.residue:
        return ComparedGains(unknowns, own, wanted, None, solution.residue)
    values = [value.xreplace(dict.fromkeys(unknowns, sp.Integer(0))) for value in solution.values]
    gains = gains_of([tidy(value) for value in values])
    return ComparedGains(unknowns, own, wanted, gains, free=bool(solution.free))
