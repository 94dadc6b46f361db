"""Lemma: the regulator over N steps of discrete time, by the recursion from the end."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.derivation import Answers, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import inverse
from solver.tasks.variations.energy_question import scalar_or_column
from solver.tasks.variations.horizon_question import HorizonQuestion
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

WORKED_OUT = 6
"""More steps than these are not worked out one by one, except for the first of the recursion and the last."""


@lemma("horizon_recursion")
def recursion_of(asked: HorizonQuestion, steps: int) -> Derivation[Answers]:
    """P_N = S; K_k = (R + BᵀP_{k+1}B)⁻¹BᵀP_{k+1}A and P_k = Q + AᵀP_{k+1}(A − BK_k) for k = N − 1, …, 0."""
    found = exact.riccati_recursion(asked.A, asked.B, asked.Q, asked.R, asked.S, steps, asked.x0)
    yield Step("recursion", unclaimed="the general formulas, derived in the text", Q=asked.Q, R=asked.R, S=asked.S,
               N=steps, factor=asked.factor)  # fmt: skip
    for k in reversed(range(steps)):
        if steps <= WORKED_OUT or k in (0, steps - 1):
            yield _step(asked, found, k)
    yield Step(
        "table",
        claims={
            f"P{k}": Claim(_cost_matrix(asked, found, k), found.P[k], Phrase("$P_{{{k}}}$", k=k))
            for k in reversed(range(steps))
            if steps > WORKED_OUT and k not in (0, steps - 1)
        }
        or {"end": Claim(asked.S, found.P[-1], "the end")},
        P=list(found.P),
        K=list(found.K),
        N=steps,
    )
    answers = Answers(P=list(found.P), K=list(found.K))
    limit = yield from _limit_of(asked)
    if limit is not None:
        answers["P_infinite"] = limit
    if asked.x0 is not None:
        answers |= yield from _motion_of(asked, found)
    return answers


@lemma("horizon_recursion")
def _limit_of(asked: HorizonQuestion) -> Derivation[ImmutableMatrix | None]:
    """P₀ as the number of steps grows: the stabilizing solution of the algebraic equation, or the minimal one."""
    try:
        found = exact.limit_of_the_recursion(asked.A, asked.B, asked.Q, asked.R, asked.S)
    except exact.NotExact:
        return None
    if found is None:
        return None
    P, stabilizing = found
    gain = product(inverse(total(asked.R, product(asked.Bt, P, asked.B))), asked.Bt, P, asked.A)
    At = sp.ImmutableMatrix(asked.A.T)
    stated = difference(total(asked.Q, product(At, P, asked.A)), product(At, P, asked.B, gain))
    claims = {"equation": Claim(stated, P, "the algebraic equation")}
    yield Step("limit", claims=claims, P=P, stabilizing=stabilizing, free=not any(asked.S.flat()))
    return P


def _step(asked: HorizonQuestion, found: exact.Recursion, k: int) -> Step:
    """One step back: the weight of the input, the gain, the cost matrix."""
    later, K = found.P[k + 1], found.K[k]
    weight = sp.ImmutableMatrix((asked.R + asked.Bt * later * asked.B).applyfunc(exact.tidy))
    claims = {
        "weight": Claim(total(asked.R, product(asked.Bt, later, asked.B)), weight, "the weight of the input"),
        "K": Claim(product(inverse(weight), asked.Bt, later, asked.A), K, Phrase("$K_{{{k}}}$", k=k)),
        "P": Claim(_cost_matrix(asked, found, k), found.P[k], Phrase("$P_{{{k}}}$", k=k)),
    }
    return Step("step", claims=claims, k=k, K=K, P=found.P[k], later=later, weight=weight)


def _cost_matrix(asked: HorizonQuestion, found: exact.Recursion, k: int) -> object:
    """Q + AᵀP_{k+1}(A − BK_k) as stated."""
    loop = difference(asked.A, product(asked.B, found.K[k]))
    return total(asked.Q, product(sp.ImmutableMatrix(asked.A.T), found.P[k + 1], loop))


@lemma("horizon_recursion")
def _motion_of(asked: HorizonQuestion, found: exact.Recursion) -> Derivation[Answers]:
    """u_k = −K_k x_k and x_{k+1} = A x_k + B u_k, from the start on, and the cost."""
    claims = {}
    for k, (K, u) in enumerate(zip(found.K, found.u, strict=True)):
        claims[f"u{k}"] = Claim(product(-1, K, found.x[k]), u, Phrase("$u_{{{k}}}$", k=k))
        following = total(product(asked.A, found.x[k]), product(asked.B, u))
        claims[f"x{k + 1}"] = Claim(following, found.x[k + 1], Phrase("$x_{{{k}}}$", k=k + 1))
    yield Step("motion", claims=claims, x=list(found.x), u=[scalar_or_column(u) for u in found.u], N=len(found.K))
    x0 = found.x[0]
    cost = exact.tidy(asked.factor * (x0.T * found.P[0] * x0)[0, 0])
    stated = product(asked.factor, sp.ImmutableMatrix(x0.T), found.P[0], x0)
    yield Step("cost", claims={"J": Claim(stated, cost, "the least cost")}, factor=asked.factor)
    return Answers(x=list(found.x), u=[scalar_or_column(u) for u in found.u], cost=cost)
