"""The reaction curve of a plant, its response to a unit step, and the tangent where it is steepest.

The tangent y = R (t − L) meets the time axis at the dead time L. Source: Ziegler and Nichols, Trans. ASME 64, 1942.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from solver.exact.design.model_matching import descending_form
from solver.exact.functions.rational import RationalMatrix
from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.stability.root_counts import root_counts
from solver.exact.time_response.peaks import Peak, peak
from solver.exact.time_response.response import weighting
from solver.systems import StateSpace


@dataclass(frozen=True)
class ReactionCurve:
    """y and its slope g for t after the dead time of the plant; the tangent at `time` with `height` and `slope` R.

    `dead_time` is L. `kind` is "inflection" (g largest at `time`), "start" (at 0), or "ramp": y tends to the
    tangent, and `time` is oo. `flat` is how the time was found, the largest value of g.
    """

    y: sp.Expr
    g: sp.Expr
    t: sp.Symbol
    kind: str
    time: sp.Expr
    height: sp.Expr
    slope: sp.Expr
    own: sp.Expr
    dead_time: sp.Expr
    flat: Peak | None = None


@dataclass(frozen=True)
class NoCurve:
    """Why the rules do not apply: "unstable", "overshoots", "no_dead_time", "steepest_at_first", "constant"."""

    why: str


def reaction_curve(numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol, delay: sp.Expr) -> ReactionCurve | NoCurve:
    """Return the tangent of the step response of N/D e^{−delay s}, all numbers, N of lower degree than D."""
    common = sp.gcd(numerator, denominator)
    N, D = (sp.quo(p, common, s) for p in (numerator, denominator))
    if sp.degree(D, s) == 0 or sp.degree(N, s) >= sp.degree(D, s):
        return NoCurve("constant")
    integrating = sp.Poly(D, s).coeff_monomial(1) == 0
    counts = root_counts(sp.Poly(D, s).all_coeffs())
    if counts is None or counts.outside or counts.on > integrating:
        return NoCurve("unstable")
    t = sp.Symbol("t")
    image, whole = _image(N, D, s), _image(N, s * D, s)
    g, y = (each.function(t, discrete=False).matrix[0] for each in (image, whole))
    if not integrating and peak(whole, y, t, discrete=False) is not None:
        return NoCurve("overshoots")
    return _tangent(image, y, g, t, integrating=integrating, delay=delay)


def _image(numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol) -> RationalMatrix:
    A, B, C, _ = descending_form(numerator, denominator, s)
    return weighting(StateSpace(A, B, C))


def _tangent(
    image: RationalMatrix, y: sp.Expr, g: sp.Expr, t: sp.Symbol, *, integrating: bool, delay: sp.Expr
) -> ReactionCurve | NoCurve:
    flat = peak(image, g, t, discrete=False)
    if flat is not None:
        kind, time, slope = "inflection", flat.time, flat.value
        height = _value(y, t, time)
    elif integrating:
        kind, time = "ramp", sp.oo
        steady = sp.expand(y.xreplace({each: sp.Integer(0) for each in y.atoms(sp.exp)}))
        slope, height = steady.coeff(t, 1), steady.coeff(t, 0)
        if abs(sp.N(g.xreplace({t: sp.Integer(0)}), DIGITS)) > abs(sp.N(slope, DIGITS)):
            return NoCurve("steepest_at_first")
    else:
        kind, time, height, slope = "start", sp.Integer(0), sp.Integer(0), g.xreplace({t: sp.Integer(0)})
    own = tidy(-height / slope) if kind == "ramp" else tidy(time - height / slope)
    L = tidy(own + delay)
    if sp.N(L, DIGITS) <= sp.Float("1e-20"):
        return NoCurve("no_dead_time")
    return ReactionCurve(y, g, t, kind, time, height, slope, own, L, flat)


def _value(y: sp.Expr, t: sp.Symbol, time: sp.Expr) -> sp.Expr:
    value = y.xreplace({t: time})
    return sp.N(value, DIGITS) if time.has(sp.Float) else sp.expand(value, power_exp=False, log=False)
