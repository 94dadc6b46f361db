"""Lemma: where branches cross the boundary of stability, and for which gains the loop is stable."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.quadratics import both_roots
from solver.arithmetic.roots import values_at
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.stated.calculus import value_at
from solver.tasks.root_locus.rules import factored
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.root_locus.locus_equation import Form


@dataclass(frozen=True, slots=True)
class Axis:
    """The crossings; `along` says that whole branches lie on the boundary."""

    crossings: tuple[exact.Crossing, ...]
    along: bool


def pair(point: Expr) -> list[Expr]:
    """A point that is not real, and its mirror image."""
    return [point, point.subs(sp.I, -sp.I)]


@lemma("locus_axis")
def crossings_of(form: Form) -> Derivation[Axis]:
    """D + K N = 0 on the boundary in two real equations, K eliminated; then what happens between the critical gains."""
    found, along = exact.crossings(form.equation), bool(exact.on_boundary(form.equation).eliminated.is_zero)
    yield _parts(form, along=along)
    yield _crossings(form, found, along=along)
    ranges = exact.stable_gains(form.equation)
    yield Step("ranges", unclaimed="counted by the Routh array at one gain of each range",
               ranges=[(each.low, each.high, each.outside, each.on) for each in ranges], K=form.K,
               conditions=_conditions(ranges, form.K), n=form.equation.denominator.degree(),
               fixed=form.equation.common.degree(), discrete=form.discrete)  # fmt: skip
    return Axis(found, along)


def _parts(form: Form, *, along: bool) -> Step:
    """Real and imaginary part at s = jω with ω², at z = cos θ + j sin θ with c for cos θ; K is eliminated."""
    discrete, parts = form.discrete, exact.on_boundary(form.equation)
    angle = sp.Symbol("theta" if discrete else "omega", real=True)
    cosine = sp.Symbol("c")
    a, c, b, d = (
        p.as_expr().subs(p.gen, cosine) if discrete else exact.in_squares(p, angle)
        for p in (*parts.real, *parts.imaginary)
    )
    rest = parts.eliminated
    whole = rest.as_expr().subs(rest.gen, cosine) if discrete else exact.in_squares(rest, angle)
    real, imaginary = a + form.K * c, b + form.K * d
    alone = "" if along else "second" if d == 0 else "first" if c == 0 else ""
    left = {"second": b, "first": a, "": whole}[alone]
    p = form.D + form.K * form.N
    there = sp.cos(angle) + sp.I * sp.sin(angle) if discrete else sp.I * angle
    unit = sp.I * sp.sin(angle) if discrete else there
    both = real + unit * imaginary
    claims = {
        "parts": Claim(value_at(p, form.s, there), both.subs(cosine, sp.cos(angle)), "real and imaginary part"),
        "eliminated": Claim({"second": b, "first": a, "": _eliminated(a, b, c, d)}[alone], left, "$K$ eliminated"),
    }
    factors = factored(left, cosine if discrete else angle)
    if factors is not None and sp.degree(left, cosine if discrete else angle) > 1:
        claims["factors"] = Claim(left, factors, "its factors")
    lines = () if alone or along else both_roots(cosine if discrete else angle**2, rest.as_expr(), rest.gen)
    return Step("parts", claims=claims, steps=lines, p=p, s=form.s, K=form.K, there=there, real=real,
                imaginary=imaginary,
                alone=alone, along=along, discrete=discrete, both=both, cosine=sp.cos(angle),
                powers=max(sp.degree(form.D, form.s), sp.degree(form.N, form.s)))  # fmt: skip


def _eliminated(a: Expr, b: Expr, c: Expr, d: Expr) -> Any:
    """A d − b c without what is zero."""
    return difference(product(a, d), product(b, c)) if b != 0 and c != 0 else product(a, d)


def _crossings(form: Form, found: tuple[exact.Crossing, ...], *, along: bool) -> Step:
    p, circle, claims = form.D + form.K * form.N, form.discrete, {}
    for i, each in enumerate(found, 1):
        at = value_at(p.xreplace({form.K: each.gain}), form.s, each.point)
        says = "crossing {i} of the unit circle" if circle else "crossing {i} of the imaginary axis"
        claims[f"crossing{i}"] = Claim(at, sp.Integer(0), Phrase(says, i=i))
    squared = sp.Symbol("c") if circle else sp.Symbol("omega", real=True) ** 2
    rows = [
        {"real": each.real, "squared": squared, "square": each.place, "point": each.point, "pair": pair(each.point),
         "gain": each.gain, "omega": _frequency(form, each)}
        for each in found
    ]  # fmt: skip
    none = "" if claims else "there is no such point; the answer has a check"
    return Step("crossings", claims=claims, unclaimed=none, steps=_gains(form, squared, rows), rows=rows,
                K=form.K, along=along, s=form.s,
                discrete=circle)  # fmt: skip


@where_exact
def _gains(form: Form, squared: Expr, rows: Sequence[Mapping[str, Any]]) -> tuple[Step, ...]:
    """K from the equation in which it is alone with ω², or c, where that is linear."""
    parts, places = exact.on_boundary(form.equation), [row["square"] for row in rows if not row["real"]]
    for p, q in (parts.imaginary, parts.real):
        gain = None if q.is_zero else sp.Poly(sp.cancel(-p.as_expr() / q.as_expr()), p.gen) if q.degree() == 0 else None
        if places and gain is not None and gain.degree() == 1:
            w = sp.Symbol("c" if form.discrete else "w")
            of_w = gain.as_expr().subs(p.gen, w)
            return values_at(of_w, w, places, form.K, None if form.discrete else squared)
    return ()


def _frequency(form: Form, at: exact.Crossing) -> Expr | None:
    """The frequency in rad/s of the oscillation at a crossing of the unit circle, where T is a number."""
    if not form.discrete or form.sample_time is None or not form.sample_time.is_number or at.point == 1:
        return None
    return sp.N(sp.acos(at.place) / form.sample_time, 30)


def _conditions(ranges: tuple[exact.Range, ...], K: Any) -> list[Any]:
    """Where the loop is stable, as conditions on K > 0; ranges that touch at a gain of no crossing stay apart."""
    found = []
    for each in ranges:
        if not each.outside and not each.on:
            low, high = sp.Gt(K, each.low), sp.Lt(K, each.high) if each.high != sp.oo else sp.true
            found.append(sp.And(low, high))
    return found
