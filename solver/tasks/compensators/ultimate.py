"""Lemma: the gain at which a loop begins to oscillate, by putting s = jω."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.calculus import value_at
from solver.tasks.compensators.refusals import no_ultimate_gain, no_ultimate_gain_with_dead_time

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import OpenLoop


@lemma("ultimate_gain")
def ultimate_gain_of(G: OpenLoop) -> Derivation[tuple[Expr, Expr]]:
    """K_u and T_u: where a stable loop begins to oscillate, by roots of D + K N on the axis; raises Unsolved."""
    s, N, D = G.variable, G.numerator, G.denominator
    K = sp.Symbol("K")
    polynomial = sp.collect(sp.expand(D + K * N), s)
    claim = Claim(total(D, product(K, N)), polynomial, "the characteristic polynomial")
    yield Step("polynomial", claims={"p": claim}, s=s, K=K)
    axis = exact.on_the_axis(N, D, s)
    found = exact.ultimate_gain(N, D, s)
    yield _on_the_axis(polynomial, axis, s, K)
    yield _crossings(axis, found)
    yield Step(
        "intervals",
        unclaimed="counted by Routh's criterion; what was found has a check of its own",
        intervals=found.intervals,
        ultimate=found.ultimate,
        K=K,
    )
    if found.ultimate is None:
        raise no_ultimate_gain(found.why)
    T = 2 * sp.pi / found.ultimate.frequency
    T = sp.N(T, 30) if T.has(sp.Float) else sp.radsimp(T)
    claim = Claim(quotient(2 * sp.pi, found.ultimate.frequency), T, "the period")
    yield Step("period", claims={"T": claim}, ultimate=found.ultimate)
    return found.ultimate.gain, T


@lemma("ultimate_gain")
def ultimate_gain_with_dead_time(G: OpenLoop) -> Derivation[tuple[Expr, Expr]]:
    """K_u and T_u where the phase of the plant reaches −180°; raises Unsolved."""
    found, why = exact.ultimate_with_dead_time(G.numerator, G.denominator, G.variable, G.delay)
    if found is None:
        raise no_ultimate_gain_with_dead_time(why)
    plant = G.numerator / G.denominator * sp.exp(-G.delay * G.variable)
    there = value_at(plant, G.variable, sp.I * found.frequency)
    claims = {
        "value": Claim(there, -1 / found.gain, "the plant at this frequency"),
        "K": Claim(quotient(sp.Integer(1), 1 / found.gain), found.gain, "the ultimate gain"),
    }
    yield Step("late", claims=claims, ultimate=found, delay=G.delay, s=G.variable)
    T = sp.N(2 * sp.pi / found.frequency, 30)
    claim = Claim(quotient(2 * sp.pi, found.frequency), T, "the period")
    yield Step("period", claims={"T": claim}, ultimate=found)
    return found.gain, T


def _on_the_axis(polynomial: Expr, axis: exact.Axis, s: Symbol, K: Symbol) -> Step:
    """Real and imaginary part at s = jω."""
    omega = sp.Symbol("omega")
    real, imaginary = (
        sp.collect(sp.expand(without + K * factor).xreplace({axis.w: omega**2}), omega)
        for without, factor in (axis.real, axis.imaginary)
    )
    parts = total(real, product(sp.I * omega, imaginary))
    claim = Claim(value_at(polynomial, s, sp.I * omega), parts, "real and imaginary part on the axis")
    return Step("axis", claims={"at": claim}, real=real, imaginary=imaginary, omega=omega)


def _crossings(axis: exact.Axis, found: exact.UltimateGain) -> Step:
    """K eliminated, the frequencies, and the gains there."""
    omega = sp.Symbol("omega")
    put = {axis.w: omega**2}
    (De, Ne), (Do, No) = ((a.xreplace(put), b.xreplace(put)) for a, b in (axis.real, axis.imaginary))
    crossings = [each for each in found.crossings if each.frequency != 0]
    claims = {}
    equation = sp.collect(sp.expand(axis.equation), axis.w).xreplace(put)
    if No == 0:
        equation = Do  # the imaginary part is free of K as it stands
    else:
        stated = difference(product(De, No), product(Do, Ne))
        claims["eliminated"] = Claim(stated, equation, "the gain eliminated")
    for i, each in enumerate(crossings):
        above, below = (De, Ne) if Ne.xreplace({omega: each.frequency}) != 0 else (Do, No)
        stated = value_at(quotient(-above, below), omega, each.frequency)
        claims[f"K{i}"] = Claim(stated, each.gain, "the gain there")
    return Step("crossings", claims=claims, unclaimed="" if claims else "no equation has a solution",
                equation=equation, crossings=crossings, omega=omega)  # fmt: skip
