"""Lemma: the control of least energy by the controllability Gramian, weighted with R⁻¹."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.arithmetic.equations import system_solved
from solver.arithmetic.integrals import integrated
from solver.derivation import Answers, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, exponential, product
from solver.stated.calculus import integral
from solver.stated.matrices import inverse, transpose
from solver.tasks.variations.energy_by_variations import by_hand, cost_of, motion_and_cost
from solver.tasks.variations.energy_question import Transfer, scalar_or_column

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


@lemma("energy_by_gramian")
def gramian_of(transfer: Transfer, best: exact.MinimumEnergy) -> Derivation[None]:
    """W = ∫₀ᵀ e^{At} B R⁻¹ Bᵀ e^{Aᵀt} dt, entry by entry."""
    t, T = sp.Symbol("t"), transfer.T
    e = exponential(product(transfer.A, t))
    moved = sp.ImmutableMatrix((best.transition * transfer.B).expand())
    weight = [] if sp.eye(transfer.R.rows) == transfer.R else [inverse(transfer.R)]
    yield Step("response", claims={"motion": Claim(product(e, transfer.B), moved, "response of the modes")},
               transition=best.transition, weighed=bool(weight), T=T)  # fmt: skip
    stated = product(moved, *weight, transpose(moved))
    square = _square(transfer, moved)
    claims = {
        "square": Claim(stated, square, "what is integrated"),
        "integral": Claim(integral(stated, t, sp.S.Zero, T), best.gramian, "the Gramian"),
    }
    worked_out = integrated(square, t, sp.S.Zero, T, best.gramian)
    yield Step("gramian", claims=claims, steps=worked_out, W=best.gramian, T=T, weighed=bool(weight))


def _square(transfer: Transfer, moved: ImmutableMatrix) -> ImmutableMatrix:
    """e^{At} B R⁻¹ Bᵀ e^{Aᵀt}, multiplied out."""
    inverted = exact.weighted_transpose(sp.ImmutableMatrix(sp.eye(transfer.R.rows)), transfer.R)
    return sp.ImmutableMatrix((moved * inverted * moved.T).expand())  # no field: the modes may be in decimals


@lemma("energy_by_gramian")
def control_by_gramian(transfer: Transfer, best: exact.MinimumEnergy) -> Derivation[Answers]:
    """W η = x_f − e^{AT} x₀, and u = R⁻¹ Bᵀ e^{Aᵀ(T−t)} η."""
    t, T, n = sp.Symbol("t"), transfer.T, transfer.A.rows
    e = exponential(product(transfer.A, T))
    claims = {
        "drift": Claim(product(e, transfer.x0), best.drift, "where the free motion would end"),
        "gap": Claim(difference(transfer.xf, best.drift), best.gap, "what is missing at the end"),
    }
    yield Step("gap", claims=claims, T=T, at_rest=not any(transfer.x0.flat()), xf=transfer.xf)
    if best.unreached.rows:
        claims = {
            "gramian": Claim(product(best.unreached, best.gramian), _zeros(best.unreached.rows, n), "$qW = 0$"),
            "gap": Claim(product(best.unreached, best.gap), _zeros(best.unreached.rows, 1), "$qd = 0$"),
        }
        yield Step("reachable", claims=claims, rows=best.unreached)
    unknowns = [sp.Symbol(f"eta{i + 1}") for i in range(n)]
    whole = not best.unreached.rows
    equations = list(zip((best.gramian * sp.Matrix(unknowns)).flat(), best.gap.flat(), strict=True))
    solved = system_solved(equations, unknowns, best.eta.flat()) if whole and by_hand(equations) else ()
    backwards = exponential(product(T - t, transpose(transfer.A)))
    weight = [] if sp.eye(transfer.R.rows) == transfer.R else [inverse(transfer.R)]
    yield Step("weights", claims={"solve": Claim(product(best.gramian, best.eta), best.gap, r"$W\eta = d$")},
               steps=solved, eta=best.eta, whole=whole, weighed=bool(weight))  # fmt: skip
    stated = product(*weight, transpose(transfer.B), backwards, best.eta)
    yield Step("control", claims={"u": Claim(stated, best.u, "the control")}, u=scalar_or_column(best.u),
               weighed=bool(weight), T=T)  # fmt: skip
    yield from motion_and_cost(transfer, best, by_gap=True)
    return Answers(u=scalar_or_column(best.u), x=best.x, cost=cost_of(transfer, best), gramian=best.gramian)


def _zeros(rows: int, columns: int) -> ImmutableMatrix:
    return sp.ImmutableMatrix(sp.zeros(rows, columns))
