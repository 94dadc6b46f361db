"""Lemma: the control of least energy by Lagrange's multipliers, with constants from both ends."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.equations import system_solved
from solver.arithmetic.integrals import integrated
from solver.derivation import Answers, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import exponential, product, total
from solver.stated.calculus import denoted, derivative, integral, partial_derivative, value_at
from solver.stated.matrices import inverse, transpose
from solver.tasks.variations.energy_question import Transfer, scalar_or_column
from solver.tasks.variations.horizon_figures import signals_over
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

LARGEST, LARGEST_ROUGH = 3, 2
"""The equations for more constants are not solved by hand; nor these, where they hold exponentials or waves."""


def by_hand(equations: list[tuple[Any, Any]]) -> bool:
    """Whether a pen would solve the equations, given by their sides."""
    rough = any(left.has(sp.exp, sp.E, sp.sin, sp.cos) for left, _ in equations)
    return len(equations) <= (LARGEST_ROUGH if rough else LARGEST)


def hamiltonian_of(transfer: Transfer) -> Expr:
    """H = c uᵀRu + λᵀ(Ax + Bu), multiplied out."""
    u, x, costates = transfer.u, transfer.x, transfer.costates
    cost = transfer.factor * (u.T * transfer.R * u)[0, 0]
    found: Expr = sp.expand(cost + (costates.T * (transfer.A * x + transfer.B * u))[0, 0])
    return found


@lemma("energy_by_variations")
def conditions_of(transfer: Transfer) -> Derivation[list[Any]]:
    """λ' = −∂H/∂x and ∂H/∂u = 0; returns the equations, as expressions that are zero."""
    u, x, costates = transfer.u, transfer.x, transfer.costates
    H = hamiltonian_of(transfer)
    moving = total(product(transfer.A, x), product(transfer.B, u))
    stated = total(transfer.integrand(u), product(transpose(costates), moving))
    yield Step("hamiltonian", claims={"H": Claim(stated, H, "the Hamiltonian")}, u=u, x=x, costates=costates,
               factor=transfer.factor)  # fmt: skip
    H_named = denoted("H", H)
    rates = [sp.expand(-sp.diff(H, each)) for each in x.flat()]
    claims = {
        f"rate{i}": Claim(product(-1, partial_derivative(H_named, each)), rate, "costate equation")
        for i, (each, rate) in enumerate(zip(x.flat(), rates, strict=True))
    }
    yield Step("costate_equations", claims=claims, names=transfer.rates[0].flat())
    slopes = [sp.expand(sp.diff(H, each)) for each in u.flat()]
    claims = {
        f"slope{j}": Claim(partial_derivative(H_named, each), slope, "what must vanish")
        for j, (each, slope) in enumerate(zip(u.flat(), slopes, strict=True))
    }
    law = sp.ImmutableMatrix(transfer.law * costates)
    weight = [] if sp.eye(u.rows) == transfer.R else [inverse(transfer.R)]
    factor = -1 / (2 * transfer.factor)
    claims["law"] = Claim(product(factor, *weight, transpose(transfer.B), costates), law, "the control by the costates")
    yield Step("stationary", claims=claims, u=scalar_or_column(law), weighed=bool(weight), factor=factor)
    motion = transfer.A * x + transfer.B * u
    return [
        *(rate - value for rate, value in zip(transfer.rates[0].flat(), rates, strict=True)),
        *slopes,
        *(sp.expand(rate - value) for rate, value in zip(transfer.rates[1].flat(), motion.flat(), strict=True)),
    ]


@lemma("energy_by_variations")
def constants_of(transfer: Transfer, best: exact.MinimumEnergy) -> Derivation[ImmutableMatrix]:
    """λ(t) and x(t) in the constants λ(0), and these from x(T) = x_f; returns their values."""
    t = sp.Symbol("t")
    c = sp.ImmutableMatrix(transfer.constants)
    backwards = sp.ImmutableMatrix(best.transition.T.xreplace({t: -t}))
    costates = sp.ImmutableMatrix((backwards * c).expand())
    e = exponential(product(-t, transpose(transfer.A)))
    yield Step("costates", claims={"costates": Claim(product(e, c), costates, "the costates in their constants")})
    u = sp.ImmutableMatrix((transfer.law * costates).expand())
    free = sp.ImmutableMatrix((best.transition * transfer.x0).expand())
    driven = sp.ImmutableMatrix((-best.spread * c / (2 * transfer.factor)).expand())
    x = sp.ImmutableMatrix((free + driven).expand())
    claims = {
        "u": Claim(product(transfer.law, costates), u, "the control in the constants"),
        "rate": Claim(derivative(x, t), total(product(transfer.A, x), product(transfer.B, u)), r"$\dot{x} = Ax + Bu$"),
        "start": Claim(value_at(x, t, sp.S.Zero), transfer.x0, "$x(0)$"),
    }
    tau = sp.Symbol("tau")
    inside = best.transition.xreplace({t: t - tau}) * transfer.B * u.xreplace({t: tau})
    worked_out = integrated(sp.ImmutableMatrix(inside.expand()), tau, sp.S.Zero, t, driven)
    yield Step("states", claims=claims, steps=worked_out, u=scalar_or_column(u), x=x, x0=transfer.x0)
    values = sp.ImmutableMatrix([exact.tidy(-2 * transfer.factor * each) for each in best.start.flat()])
    yield _ends(transfer, x, c, values)
    return values


def _ends(transfer: Transfer, x: ImmutableMatrix, c: ImmutableMatrix, values: ImmutableMatrix) -> Step:
    """The linear equations x(T) = x_f for the constants, and their solution."""
    t = sp.Symbol("t")
    at_end = [sp.expand(each.xreplace({t: transfer.T})) for each in x.flat()]
    claims = {}
    for i, (each, wanted) in enumerate(zip(at_end, transfer.xf.flat(), strict=True)):
        put_in: Any = each
        for constant, value in zip(c.flat(), values.flat(), strict=True):
            put_in = value_at(put_in, constant, value)
        claims[f"end{i}"] = Claim(put_in, wanted, Phrase("end {i} with the constants put in", i=i + 1))
    equations = list(zip(at_end, transfer.xf.flat(), strict=True))
    solved = system_solved(equations, c.flat(), values.flat()) if by_hand(equations) else ()
    M, _ = exact.affine(at_end, c.flat())
    return Step(
        "ends",
        claims=claims,
        steps=solved,
        equations=equations,
        found=list(zip(c.flat(), values.flat(), strict=True)),
        T=transfer.T,
        chosen=exact.reachable_order(transfer.A, transfer.B) < len(c),
        M=M,
    )


@lemma("energy_by_variations")
def optimum_of(transfer: Transfer, best: exact.MinimumEnergy, constants: ImmutableMatrix) -> Derivation[Answers]:
    """The constants put in: λ(t), u(t), x(t), and what it costs."""
    t = sp.Symbol("t")
    costates = sp.ImmutableMatrix([exact.tidy(-2 * transfer.factor * each) for each in best.adjoint.flat()])
    e = exponential(product(-t, transpose(transfer.A)))
    claims = {
        "costates": Claim(product(e, constants), costates, "the costates"),
        "u": Claim(product(transfer.law, costates), best.u, "the control"),
    }
    yield Step("control", claims=claims, u=scalar_or_column(best.u), costates=costates)
    yield from motion_and_cost(transfer, best)
    return Answers(u=scalar_or_column(best.u), x=best.x, cost=cost_of(transfer, best), costates=costates.flat())


def cost_of(transfer: Transfer, best: exact.MinimumEnergy) -> Expr:
    """The factor times ∫ uᵀ R u dt."""
    found: Expr = exact.tidy(transfer.factor * best.energy)
    return found


@lemma("energy_by_variations")
def motion_and_cost(transfer: Transfer, best: exact.MinimumEnergy, *, by_gap: bool = False) -> Derivation[None]:
    """x(t) with its ends, and the cost: the integral, or c dᵀη (`by_gap`)."""
    t, T = sp.Symbol("t"), transfer.T
    claims = {
        "rate": Claim(
            derivative(best.x, t),
            total(product(transfer.A, best.x), product(transfer.B, best.u)),
            r"$\dot{x} = Ax + Bu$",
        ),
        "start": Claim(value_at(best.x, t, sp.S.Zero), transfer.x0, "where it begins"),
        "end": Claim(value_at(best.x, t, T), transfer.xf, "where it ends"),
    }
    figures = signals_over(T, {"x": best.x, "u": best.u}, "The motion and the control of least energy")
    yield Step("motion", claims=claims, x=best.x, x0=transfer.x0, xf=transfer.xf, T=T, figures=figures)
    cost = cost_of(transfer, best)
    integrand = sp.ImmutableMatrix([sp.expand(transfer.factor * (best.u.T * transfer.R * best.u)[0, 0])])
    integral_of_u = integral(transfer.integrand(best.u), t, sp.S.Zero, T)
    claims = {"integral": Claim(integral_of_u, cost, "the cost")}
    if by_gap:
        claims["gap"] = Claim(product(transfer.factor, transpose(best.gap), best.eta), cost, r"$c\,d^{T}\eta$")
    worked_out = (
        () if by_gap else integrated(integrand, t, sp.S.Zero, T, sp.ImmutableMatrix([cost]), transfer.integrand(best.u))
    )
    yield Step("cost", claims=claims, steps=worked_out, cost=cost, factor=transfer.factor, T=T, by_gap=by_gap,
               single=best.u.rows == 1, unit=sp.eye(best.u.rows) == transfer.R)  # fmt: skip
