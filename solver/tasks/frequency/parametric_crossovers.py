"""Lemma: where L(jω) with parameters is real, or of size one, told as crossovers of numbers are, and the margins."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, conjugate, phase
from solver.tasks.frequency.crossovers import approximation

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sympy import Expr

    from solver.systems import OpenLoop


def loop_factors(loop: OpenLoop) -> exact.ParametricFactors:
    """Return L by its factors, what is common cancelled."""
    return exact.parametric_factors(loop.numerator, loop.denominator, loop.variable)


def has_letters(loop: OpenLoop) -> bool:
    """Whether a letter without a value stands in a continuous loop without dead time."""
    return not loop.discrete and loop.delay == 0 and bool(set(loop.parameters) - {loop.variable})


@lemma("crossovers")
def real_axis_with_letters(
    L: exact.ParametricAxis, crossings: Sequence[exact.ParametricCrossing], *, every: bool = True
) -> Derivation[None]:
    """Im(N D̄) = ω I(ω²) = 0, and the value of L at each root; `every` one, or those that are negative are asked for."""
    omega, w, s = sp.Symbol("omega"), L.parts.w, L.N.gen
    parts = {name: real + sp.I * imaginary for name, (real, imaginary) in _even_odd(L).items()}
    real, slope = (p.as_expr().subs(w, omega**2) for p in (L.parts.real, L.parts.imaginary))
    imaginary = sp.expand(omega * slope)
    whole = real + sp.I * imaginary
    claims = {
        "product": Claim(product(parts["N"], conjugate(parts["D"])), whole, "$N(j\\omega)\\overline{D(j\\omega)}$")
    }
    formula, p, rows = formula_of(L), sp.S.Zero + L.parts.imaginary.primitive()[1].as_expr(), []
    for i, each in enumerate((each for each in crossings if not each.start), 1):
        claims[f"root{i}"] = Claim(value_at(p, w, each.square), sp.S.Zero, "a root in $w = \\omega^2$")
        claims[f"value{i}"] = Claim(value_at(formula, s, sp.I * each.omega), each.value,
                                    "the value of $L$ on the real axis")  # fmt: skip
        rows.append(_row(each))
    start = next((each for each in crossings if each.start), None)
    if start is not None:
        claims["start"] = Claim(value_at(formula, s, sp.S.Zero), start.value, "$L(0)$")
    yield Step("real_axis" if every else "phase_crossovers", claims=claims, roots=rows, p=p, w=w, imaginary=imaginary,
               everywhere=False, start=start, crossing=list(crossings), moves=L.parts.imaginary.degree() > 0,
               discrete=False, T=None, above=parts["N"], conjugate=parts["D"].subs(sp.I, -sp.I),
               inner=len(rows))  # fmt: skip


def _row(each: exact.ParametricCrossing) -> dict[str, Any]:
    return {"at": each.omega, "near_at": _near(each.omega), "value": each.value, "near_value": _near(each.value),
            "place": each.square, "end": False, "negative": exact.decided_sign(each.value) < 0}  # fmt: skip


def _near(value: Expr) -> Expr | None:
    return None if value.free_symbols else approximation(value)


def formula_of(L: exact.ParametricAxis) -> Expr:
    """L(s)."""
    found: Expr = sp.factor(L.N.as_expr()) / sp.factor(L.D.as_expr())
    return found


def _even_odd(L: exact.ParametricAxis) -> dict[str, tuple[Expr, Expr]]:
    """Real and imaginary part of N(jω) and D(jω), in ω."""
    omega, parts = sp.Symbol("omega"), L.parts
    found = {"N": (parts.E, parts.O), "D": (parts.e, parts.o)}
    return {
        name: (even.as_expr().subs(parts.w, omega**2), sp.expand(omega * odd.as_expr().subs(parts.w, omega**2)))
        for name, (even, odd) in found.items()
    }


@lemma("crossovers")
def gain_crossovers_with_letters(L: exact.ParametricAxis, found: Sequence[tuple[Expr, Expr]]) -> Derivation[None]:
    """|N|² = |D|² as a polynomial in w = ω², and its positive roots."""
    parts, w, omega = L.parts, L.parts.w, sp.Symbol("omega")
    p = (parts.below - parts.above).primitive()[1].as_expr()
    claims = {}
    for i, (frequency, square) in enumerate(found, 1):
        claims[f"root{i}"] = Claim(value_at(p, w, square), sp.S.Zero, "a root in $w = \\omega^2$")
        at = value_at(formula_of(L), L.N.gen, sp.I * frequency)
        claims[f"size{i}"] = Claim(absolute(at), sp.S.One, "the size of $L$ at a gain crossover")
    roots = [{"square": square, "omega": at, "near": _near(at)} for at, square in found]
    sizes = [each.as_expr().subs(w, omega**2) for each in (parts.above, parts.below)]
    yield Step("gain_crossovers", claims=claims, unclaimed="" if claims else "there is none", p=p, w=w, sizes=sizes,
               roots=roots, sample=None, discrete=False, T=None, constant=not p.has(w), numerically=False,
               below=False)  # fmt: skip


@lemma("parametric_crossovers")
def phase_margin_with_letters(L: exact.ParametricFactors, omega: Expr) -> Derivation[Expr]:
    """The angles of the factors at the gain crossover, their sum, and the phase margin."""
    rows, s, claims = _rows_at(L, omega), L.s, {}
    for i, each in enumerate(rows, 1):
        claims[f"angle{i}"] = Claim(
            phase(value_at(each.factor, s, sp.I * omega)), each.degrees, "the angle of a factor"
        )
    whole = sp.Add(*(each.degrees * each.power for each in rows))
    margin = exact.margin_in_turn(L, omega)
    terms = [each.degrees if each.power == 1 else product(sp.Integer(each.power), each.degrees)
             for each in rows if each.degrees != 0]  # fmt: skip
    if len(terms) > 1:
        claims["sum"] = Claim(total(*terms), whole, "the sum of the angles")
    claims["margin"] = Claim(total(sp.Integer(180), whole), whole + 180, "the phase margin")
    yield Step("phase", claims=claims, rows=rows, whole=whole, margin=margin, turned=margin != whole + 180)
    return margin


def _rows_at(L: exact.ParametricFactors, omega: Expr) -> list[exact.FactorOnAxis]:
    """The factors at a frequency, which is positive though its formula may not show that."""
    if not omega.free_symbols:
        return L.at(omega)
    some = sp.Dummy("omega", positive=True)
    return [replace(each, value=each.value.xreplace({some: omega}), size=each.size.xreplace({some: omega}),
                    degrees=each.degrees.xreplace({some: omega})) for each in L.at(some)]  # fmt: skip


@lemma("parametric_crossovers")
def gain_margin_with_letters(at: exact.ParametricCrossing | None) -> Derivation[tuple[Expr, Expr]]:
    """1/|L| at the only phase crossover, as a ratio and in decibels."""
    if at is None:
        yield Step("gain_margin", unclaimed="there is none", at=None)
        return sp.oo, sp.oo
    ratio = sp.factor(-1 / at.value)
    decibels = 20 * sp.log(ratio) / sp.log(10)
    claims = {"ratio": Claim(quotient(sp.S.One, absolute(at.value)), ratio, "the gain margin")}
    yield Step("gain_margin", claims=claims, at=at, ratio=ratio, decibels=decibels)
    return ratio, decibels


@lemma("parametric_crossovers")
def left_open(what: str, **values: Any) -> Derivation[None]:
    """What is not found with letters, and why."""
    yield Step("left_open", unclaimed="a remark", what=what, **values)


__all__ = ["formula_of", "gain_crossovers_with_letters", "gain_margin_with_letters", "has_letters", "left_open",
           "loop_factors", "phase_margin_with_letters", "real_axis_with_letters"]  # fmt: skip
