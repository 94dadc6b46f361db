"""Lemma: where branches cross the imaginary axis, and for which gains the loop is stable."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.stated.calculus import value_at
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.root_locus.locus_equation import Form


@dataclass(frozen=True, slots=True)
class Axis:
    """The crossings; `along` says that whole branches lie on the axis."""

    crossings: tuple[exact.Crossing, ...]
    along: bool


@lemma("locus_axis")
def crossings_of(form: Form) -> Derivation[Axis]:
    """D(jω) + K N(jω) = 0 in two real equations, K eliminated; then what happens between the critical gains."""
    omega = sp.Symbol("omega", real=True)
    parts = exact.on_imaginary_axis(form.equation)
    a, c, b, d = (exact.in_squares(p, omega) for p in (*parts.real, *parts.imaginary))
    real, imaginary = a + form.K * c, b + form.K * d
    eliminated = exact.in_squares(parts.eliminated, omega)
    p = form.D + form.K * form.N
    there = value_at(p, form.s, sp.I * omega)
    claims = {
        "parts": Claim(there, real + sp.I * omega * imaginary, "real and imaginary part"),
        "eliminated": Claim(_eliminated(a, b, c, d), eliminated, "$K$ eliminated"),
    }
    factors = sp.factor(eliminated)
    if factors != eliminated and eliminated.free_symbols:
        claims["factors"] = Claim(eliminated, factors, "its factors")
    yield Step("parts", claims=claims, p=p, s=form.s, K=form.K, omega=omega, real=real, imaginary=imaginary,
               c=c, d=d, along=parts.eliminated.is_zero)  # fmt: skip
    found = exact.crossings(form.equation)
    yield _crossings(form, found, p, along=parts.eliminated.is_zero)
    ranges = exact.stable_gains(form.equation)
    yield Step("ranges", unclaimed="counted by the Routh array at one gain of each range",
               ranges=[(each.low, each.high, each.outside, each.on) for each in ranges], K=form.K,
               conditions=_conditions(ranges, form.K), n=form.equation.denominator.degree(),
               fixed=form.equation.common.degree())  # fmt: skip
    return Axis(found, bool(parts.eliminated.is_zero))


def _eliminated(a: Expr, b: Expr, c: Expr, d: Expr) -> Any:
    """A d − b c without what is zero."""
    if d == 0:
        return product(sp.Integer(-1), b, c) if b != 0 else sp.Integer(0)
    return difference(product(a, d), product(b, c)) if b != 0 and c != 0 else product(a, d)


def _crossings(form: Form, found: tuple[exact.Crossing, ...], p: Expr, *, along: bool) -> Step:
    claims = {}
    for i, each in enumerate(found, 1):
        at = value_at(p.xreplace({form.K: each.gain}), form.s, sp.I * each.frequency)
        claims[f"crossing{i}"] = Claim(at, sp.Integer(0), Phrase("crossing {i} of the imaginary axis", i=i))
    rows = [{"omega": each.frequency, "square": each.square, "gain": each.gain} for each in found]
    none = "" if claims else "there is no such point; the answer has a check"
    return Step("crossings", claims=claims, unclaimed=none, rows=rows, K=form.K, along=along, s=form.s)


def _conditions(ranges: tuple[exact.Range, ...], K: Any) -> list[Any]:
    """Where the loop is stable, as conditions on K > 0; ranges that touch at a gain of no crossing stay apart."""
    found = []
    for each in ranges:
        if not each.outside and not each.on:
            low, high = sp.Gt(K, each.low), sp.Lt(K, each.high) if each.high != sp.oo else sp.true
            found.append(sp.And(low, high))
    return found
