"""Lemma: the directions in which branches leave complex poles and reach complex zeros."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total
from solver.stated.complex_numbers import phase
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.root_locus.locus_equation import Form


@lemma("locus_angles")
def directions_of(form: Form) -> Derivation[tuple[list[Expr], list[Expr]]]:
    """One step for each complex pole and zero of the upper half plane; returns the angles of both."""
    leaving, arriving = exact.departures(form.equation), exact.arrivals(form.equation)
    for each in (*leaving, *arriving):
        yield _step(each, positive=form.equation.positive)
    return [angle for each in leaving for angle in each.angles], [angle for each in arriving for angle in each.angles]


def _step(found: exact.Bearings, *, positive: bool) -> Step:
    claims: dict[str, Claim] = {}
    rows = []
    for i, arrow in enumerate(found.arrows, 1):
        says = Phrase("the angle of arrow {i}", i=i)
        claims[f"arrow{i}"] = Claim(phase(arrow.arrow), arrow.degrees, says)
        sign = "+" if arrow.pole != found.pole else "-"
        rows.append({"claim": f"arrow{i}", "start": arrow.start, "pole": arrow.pole, "times": arrow.times, "sign": sign,
                     "degrees": arrow.degrees})  # fmt: skip
    start = sp.Integer(180 if positive else 0)
    m = found.point.multiplicity
    if found.arrows:
        signed = [_signed(row) for row in rows]
        claims["sum"] = Claim(total(*([start] if start else []), *signed), found.total, "the angles summed up")
    claims |= {
        f"angle{q}": Claim(quotient(found.total + 360 * q, sp.Integer(m)), _unreduced(found.total, q, m), "a direction")
        for q in range(m if m > 1 else 0)
    }
    return Step("direction", claims=claims, unclaimed="" if claims else "there is nothing to add up", rows=rows,
                pole=found.pole, point=found.point.value, start=start, total=found.total, m=m,
                angles=list(found.angles), turned=[_unreduced(found.total, q, m) for q in range(m)])  # fmt: skip


def _signed(row: dict[str, Any]) -> Any:
    """An angle with its sign, as often as it counts."""
    factor = sp.Integer(row["times"] * (1 if row["sign"] == "+" else -1))
    return row["degrees"] if factor == 1 else product(factor, row["degrees"])


def _unreduced(total: Any, q: int, m: int) -> Any:
    """(total + 360 q)/m, before it is brought between −180° and 180°."""
    return (total + 360 * q) / m
