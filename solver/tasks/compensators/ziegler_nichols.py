"""Lemmas: what the tables of Ziegler and Nichols make of an ultimate gain, or of a reaction curve."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.derivation.figures import Curve, Mark, Plot
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.calculus import derivative, value_at
from solver.stated.limits import limit
from solver.tasks.compensators.refusals import no_reaction_curve

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import OpenLoop


@lemma("tuning_table")
def tuned_by_table(of: str, kind: str, gain: Expr, time: Expr, letters: dict[str, Expr]) -> Derivation[exact.Tuned]:
    """K_p, T_i, T_d by the row of the table, then K_i = K_p/T_i and K_d = K_p T_d.

    `of` is "ultimate" (of K_u and T_u) or "step" (of 1/(R L) and L); `letters` are the values of these letters.
    """
    rules = exact.tuning_rules(of)
    rule = rules[kind]
    found = exact.tuned(rule, gain, time)
    K_p, K_i, K_d = found.gains
    claims = {"K_p": Claim(product(rule.gain, _gain(of, letters)), K_p, "the gain of the controller")}
    if rule.integral is not None and found.T_i is not None:
        claims["T_i"] = Claim(product(rule.integral, time), found.T_i, "the integral time")
        claims["K_i"] = Claim(quotient(K_p, found.T_i), K_i, "the gain of the integral")
    if rule.derivative is not None and found.T_d is not None:
        claims["T_d"] = Claim(product(rule.derivative, time), found.T_d, "the derivative time")
        claims["K_d"] = Claim(product(K_p, found.T_d), K_d, "the gain of the derivative")
    values: dict[str, Any] = dict(letters)
    yield Step("table", claims=claims, rules=rules, kind=kind, of=of, **values)
    return found


def _gain(of: str, letters: dict[str, Expr]) -> Any:
    if of == "ultimate":
        return letters["K_u"]
    return quotient(sp.Integer(1), product(letters["R"], letters["L"]))


@lemma("pid_controller")
def controller_of(gains: exact.Gains, s: Symbol) -> Derivation[tuple[Expr, Expr]]:
    """K_p + K_i/s + K_d s as one fraction."""
    K_p, K_i, K_d = gains
    parts = exact.pid_parts(gains, s)
    terms = [K_p, *([quotient(K_i, s)] if K_i != 0 else []), *([product(K_d, s)] if K_d != 0 else [])]
    claim = Claim(total(*terms), parts[0] / parts[1], "the controller")
    yield Step("controller", claims={"C": claim}, s=s)
    return parts


@lemma("reaction_curve")
def reaction_curve_of(G: OpenLoop) -> Derivation[exact.ReactionCurve]:
    """The response to a unit step, its steepest tangent, the slope R and the dead time L; raises Unsolved."""
    found = exact.reaction_curve(G.numerator, G.denominator, G.variable, G.delay)
    if isinstance(found, exact.NoCurve):
        raise no_reaction_curve(found.why)
    t, y, g = found.t, found.y, found.g
    yield Step("curve", claims={"g": Claim(derivative(y, t), g, "the slope of the step response")}, y=y, t=t,
               delay=G.delay)  # fmt: skip
    claims = {}
    if found.kind == "ramp":
        claims["R"] = Claim(limit(g, t, sp.oo), found.slope, "the slope in the long run")
        line = total(product(found.slope, t), found.height)
        claims["height"] = Claim(limit(difference(y, product(found.slope, t)), t, sp.oo), found.height, "the offset")
        own = quotient(-found.height, found.slope)
    else:
        claims["R"] = Claim(value_at(g, t, found.time), found.slope, "the largest slope")
        claims["height"] = Claim(value_at(y, t, found.time), found.height, "the output there")
        line = None
        own = difference(found.time, quotient(found.height, found.slope))
    claims["own"] = Claim(own, found.own, "where the tangent meets the axis")
    claims["L"] = Claim(total(found.own, G.delay), found.dead_time, "the dead time")
    yield Step("tangent", claims=claims, kind=found.kind, time=found.time, line=line, t=t, delay=G.delay,
               slope_of_g=_slope_of_slope(found), own=found.own, flat=found.flat,
               figures=_figure(found, G))  # fmt: skip
    return found


def _slope_of_slope(found: exact.ReactionCurve) -> Expr | None:
    """The derivative of g, whose zero is the point of inflection."""
    return found.flat.stationary.slope if found.flat is not None and found.flat.stationary is not None else None


def _figure(found: exact.ReactionCurve, G: OpenLoop) -> tuple[Plot, ...]:
    """The reaction curve with its tangent."""
    t, L = found.t, found.dead_time
    delay = G.delay
    y = sp.Piecewise((0, t < delay), (found.y.xreplace({t: t - delay}), True)) if delay != 0 else found.y
    end = L + 3 * _rise(found) if found.kind != "ramp" else 4 * L
    stop = sp.Rational(str(round(float(sp.N(end)), 2)))
    tangent = Curve(found.slope * (t - L), r"R\,(t - L)", style="dashed")
    marks = [Mark(L, sp.Integer(0), "L")]
    if found.kind == "inflection":
        marks.append(Mark(found.time + delay, found.height, r"t_i"))
    top = float(sp.N(found.y.xreplace({t: sp.N(stop - delay)})))
    window = (sp.Integer(0), stop, sp.Integer(0), sp.Float(1.15 * top)) if top > 0 else None
    return (
        Plot("The response to a unit step and its steepest tangent", "t", "y", t, sp.Integer(0), stop,
             (Curve(y, "y"), tangent), tuple(marks), window=window),
    )  # fmt: skip


def _rise(found: exact.ReactionCurve) -> Expr:
    """The time in which the tangent rises to the final value."""
    final = found.y.xreplace({each: sp.Integer(0) for each in found.y.atoms(sp.exp)})
    if final.has(found.t):
        return 2 * sp.N(found.time)  # it goes on rising
    return abs(sp.N(final)) / abs(sp.N(found.slope))
