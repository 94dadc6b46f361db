"""Lemma: where branches meet, by N D' − N' D = 0 and the gain there."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.stated.algebra import difference, product, quotient
from solver.stated.calculus import derivative, value_at
from solver.tasks.root_locus.rules import factored
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.root_locus.locus_equation import Form


@lemma("locus_meetings")
def meetings_of(form: Form) -> Derivation[list[exact.Meeting]]:
    """All candidates with their gains; returns those that belong to the locus."""
    s, N, D = form.s, form.N, form.D
    p = exact.turning_polynomial(form.equation)
    turning = exact.written(p)
    found = exact.meetings(form.equation)
    slopes = exact.written(form.equation.numerator.diff()), exact.written(form.equation.denominator.diff())
    claims = {"numerator": Claim(derivative(N, s), slopes[0], "the derivative of $N$")} if N.has(s) else {}
    claims |= {
        "denominator": Claim(derivative(D, s), slopes[1], "the derivative of $D$"),
        "turning": Claim(_turning(N, D, slopes), turning, "what is zero where branches meet"),
    }
    factors = factored(turning, s)
    if factors is not None:
        claims["factors"] = Claim(turning, factors, "its factors")
    yield Step("turning", claims=claims, N=N, D=D, s=s, K=form.K, slopes=slopes, none=not found,
               decimals=any(each.point.root.kind == "decimal" for each in found),
               points=[each.point.value for each in found])  # fmt: skip
    if found:
        yield _gains(form, found)
    return [each for each in found if each.belongs]


def _turning(N: Expr, D: Expr, slopes: tuple[Expr, Expr]) -> Any:
    if slopes[0] == 0:
        return product(N, slopes[1])
    return difference(product(N, slopes[1]), product(slopes[0], D))


def _gains(form: Form, found: tuple[exact.Meeting, ...]) -> Step:
    """K = −D/N at each candidate, and what that says."""
    ratio = quotient(-form.D, form.N)
    claims, rows = {}, []
    for i, each in enumerate(found, 1):
        if each.gain is not None:
            says = Phrase("the gain at candidate {i}", i=i)
            claims[f"gain{i}"] = Claim(value_at(ratio, form.s, each.point.value), each.gain, says)
        rows.append({
            "point": each.point.value, "gain": each.gain, "why": each.why, "branches": each.branches,
            "real": each.point.real, "claim": f"gain{i}" if each.gain is not None else "",
        })  # fmt: skip
    return Step("gains", claims=claims, unclaimed="" if claims else "L has zeros at all of them", rows=rows, K=form.K,
                s=form.s, shown=[row["claim"] for row in rows if row["claim"] and row["why"] != "pole"])  # fmt: skip
