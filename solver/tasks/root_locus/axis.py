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
    along = bool(parts.eliminated.is_zero)
    alone = "" if along else "second" if d == 0 else "first" if c == 0 else ""
    left = {"second": b, "first": a, "": exact.in_squares(parts.eliminated, omega)}[alone]
    p = form.D + form.K * form.N
    there = sp.I * omega
    claims = {
        "parts": Claim(value_at(p, form.s, there), real + there * imaginary, "real and imaginary part"),
        "eliminated": Claim({"second": b, "first": a, "": _eliminated(a, b, c, d)}[alone], left, "$K$ eliminated"),
    }
    factors = sp.factor(left)
    if factors != left and left.free_symbols:
        claims["factors"] = Claim(left, factors, "its factors")
    yield Step("parts", claims=claims, p=p, s=form.s, K=form.K, there=there, real=real, imaginary=imaginary,
               alone=alone, along=along)  # fmt: skip
    found = exact.crossings(form.equation)
    yield _crossings(form, found, p, omega, along=along)
    ranges = exact.stable_gains(form.equation)
    yield Step("ranges", unclaimed="counted by the Routh array at one gain of each range",
               ranges=[(each.low, each.high, each.outside, each.on) for each in ranges], K=form.K,
               conditions=_conditions(ranges, form.K), n=form.equation.denominator.degree(),
               fixed=form.equation.common.degree())  # fmt: skip
    return Axis(found, along)


def _eliminated(a: Expr, b: Expr, c: Expr, d: Expr) -> Any:
    """A d − b c without what is zero."""
    return difference(product(a, d), product(b, c)) if b != 0 and c != 0 else product(a, d)


def _crossings(form: Form, found: tuple[exact.Crossing, ...], p: Expr, omega: Expr, *, along: bool) -> Step:
    claims = {}
    for i, each in enumerate(found, 1):
        at = value_at(p.xreplace({form.K: each.gain}), form.s, sp.I * each.frequency)
        claims[f"crossing{i}"] = Claim(at, sp.Integer(0), Phrase("crossing {i} of the imaginary axis", i=i))
    rows = [
        {"omega": w, "squared": omega**2, "square": each.square, "point": sp.I * w, "gain": each.gain}
        for each in found
        for w in (each.frequency,)
    ]
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
