"""Lemma: what follows from P: its form in t, the gain, the limit of a long horizon, the motion and the cost."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.stated.calculus import derivative, value_at
from solver.tasks.variations.energy_question import scalar_or_column
from solver.tasks.variations.horizon_figures import matrices_over, signals_over
from solver.tasks.variations.horizon_hamiltonian import over_one_denominator
from solver.tasks.variations.horizon_question import HorizonQuestion

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


@lemma("horizon_control")
def control_of(asked: HorizonQuestion, found: exact.FiniteHorizon) -> Derivation[Answers]:
    """P(t) and K(t), the limit, and where a start is given the motion and its cost."""
    t, T = sp.Symbol("t"), asked.horizon
    P, K = (found.in_time(M, T) for M in (found.P, found.K))
    claims = {
        "equation": Claim(
            total(derivative(P, t), asked.linear_part(P)), asked.quadratic_part(P), "the Riccati differential equation"
        ),
        "end": Claim(value_at(scalar_or_matrix(P), t, T), scalar_or_matrix(asked.S), "$P(T)$"),
        "shown": Claim(P, over_one_denominator(P), "$P(t)$"),
    }
    yield Step("solution", claims=claims, P=P, T=T, S=asked.S, free=not any(asked.S.flat()), n=asked.order)
    claims = {
        "K": Claim(product(*asked.weight, asked.Bt, P), K, "the gain"),
        "shown": Claim(K, over_one_denominator(K), "$K(t)$"),
    }
    figures = matrices_over(T, {"P": P, "K": K}, "The solution of the Riccati equation and the gain over the horizon")
    yield Step("gain", claims=claims, K=K, weighed=bool(asked.weight), T=T, figures=figures)
    answers = Answers(P=P, K=K)
    limit = yield from _limit_of(asked, found)
    if limit is not None:
        answers["P_infinite"] = limit
    if asked.x0 is not None:
        answers |= yield from _motion_of(asked, found, asked.x0, (P, K))
    return answers


@lemma("horizon_control")
def _limit_of(asked: HorizonQuestion, found: exact.FiniteHorizon) -> Derivation[ImmutableMatrix | None]:
    """P(0) as the horizon grows, beside the stabilizing solution of the algebraic equation."""
    limit = found.limit
    try:
        stabilizing, trouble = exact.riccati(asked.A, asked.B, asked.Q, asked.R).stabilizing.P, ""
    except exact.NotStabilizable:
        stabilizing, trouble = None, "modes"
    except exact.OnTheAxis:
        stabilizing, trouble = None, "axis"
    except exact.NotExact:
        stabilizing, trouble = None, "open"
    if limit is None:
        yield Step("no_limit", unclaimed="no solution of the algebraic equation is meant", trouble=trouble)
        return None
    same = stabilizing is not None and _equal(limit, stabilizing)
    claims = {"equation": Claim(asked.linear_part(limit), asked.quadratic_part(limit), "the algebraic equation")}
    yield Step("limit", claims=claims, P=limit, stabilizing=stabilizing, same=same, trouble=trouble,
               free=not any(asked.S.flat()), n=asked.order)  # fmt: skip
    return limit


def scalar_or_matrix(M: ImmutableMatrix) -> Any:
    """The one entry of a matrix, or the matrix."""
    return M[0, 0] if M.shape == (1, 1) else M


def _equal(left: ImmutableMatrix, right: ImmutableMatrix) -> bool:
    """Whether two matrices have the same entries, in whatever form they are written."""
    gaps = [sp.radsimp(a - b) for a, b in zip(left.flat(), right.flat(), strict=True)]
    return all(exact.tidy(gap) == 0 or _is_tiny(gap) for gap in gaps)


def _is_tiny(gap: Any) -> bool:
    return not gap.free_symbols and abs(gap.evalf(50)) < sp.Float(10) ** -25


@lemma("horizon_control")
def _motion_of(
    asked: HorizonQuestion, found: exact.FiniteHorizon, x0: ImmutableMatrix, laws: tuple[Any, Any]
) -> Derivation[Answers]:
    """x(t) = X(T − t) X(T)⁻¹ x(0), u = −K x, and the cost."""
    t, T = sp.Symbol("t"), asked.horizon
    (P, K), (x, u) = laws, (found.in_time(M, T) for M in found.motion(x0, T))
    claims = {
        "rate": Claim(derivative(x, t), total(product(asked.A, x), product(asked.B, u)), r"$\dot{x} = Ax + Bu$"),
        "start": Claim(value_at(x, t, sp.S.Zero), x0, "$x(0)$"),
        "law": Claim(product(-1, K, x), u, "$u = -Kx$"),
    }
    figures = signals_over(T, {"x": x, "u": u}, "The optimal motion and its control")
    yield Step("motion", claims=claims, x=x, u=scalar_or_column(u), x0=x0, n=asked.order, T=T, figures=figures,
               slope=scalar_or_matrix(sp.ImmutableMatrix(x.diff(t))))  # fmt: skip
    cost = asked.factor * found.value(x0, T)
    start = sp.ImmutableMatrix(P.xreplace({t: sp.S.Zero}))
    stated = product(asked.factor, sp.ImmutableMatrix(x0.T), start, x0)
    yield Step(
        "cost", claims={"J": Claim(stated, cost, "the least cost")}, factor=asked.factor, cost=cost, n=asked.order
    )
    return Answers(x=x, u=scalar_or_column(u), cost=cost)
