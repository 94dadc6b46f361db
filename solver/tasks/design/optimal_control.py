"""The control of a regulator: its gain, its law, the closed loop and the cost, as a lemma."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.arithmetic.determinants import worked_out
from solver.arithmetic.exactness import where_exact
from solver.arithmetic.roots import roots_found
from solver.derivation import Answers, Claim, Derivation, Given, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import inverse
from solver.tasks.design.loop_figures import optimal_loop
from solver.tasks.design.regulator import Regulator
from solver.tasks.design.regulator_formulas import initial_state_of, states_of
from solver.tasks.design.regulator_products import products_of_a_form, products_of_the_gain
from solver.tasks.design.weights import cost_factor

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.tasks.design.lqr import LqrOptions
    from solver.tasks.needed import WithInput


def gain_claims(problem: Regulator, P: ImmutableMatrix, K: ImmutableMatrix) -> dict[str, Claim]:
    """The gain K of a solution P; in discrete time R + BᵀPB and BᵀPA first."""
    if not problem.discrete:
        return {"K": Claim(problem.gain_of(P), K, "the gain")}
    weight = exact.riccati_weight(problem.B, problem.R, P)
    seen = sp.ImmutableMatrix((problem.Bt * P * problem.A).applyfunc(exact.expanded_around_roots))
    cross = [] if problem.N is None else [sp.ImmutableMatrix(problem.N.T)]
    return {
        "weight": Claim(problem.weight_of(P), weight, "the weight of the input"),
        "seen": Claim(product(problem.Bt, P, problem.A), seen, "what the input acts on"),
        "K": Claim(product(inverse(weight), total(seen, *cross) if cross else seen), K, "the gain"),
    }


@where_exact
def _eigenvalues(loop: ImmutableMatrix, eigenvalues: Sequence[Expr], *, discrete: bool) -> tuple[Step, ...]:
    """The characteristic polynomial of a loop of order two in numbers and its roots, which were found another way."""
    if loop.rows != 2 or loop.free_symbols:
        return ()
    x = sp.Symbol("z" if discrete else "s")
    chi = exact.faddeev_leverrier(loop).characteristic_polynomial(x)
    return worked_out("", exact.pencil(loop, x), chi, x) + roots_found(chi, list(eigenvalues), x)


@lemma("regulator")
def control_of(given: Given[WithInput, LqrOptions], problem: Regulator, equation: exact.Riccati) -> Derivation[Answers]:
    """Find K = R⁻¹(BᵀP + Nᵀ), in discrete time (R + BᵀPB)⁻¹(BᵀPA + Nᵀ), u = −K x, the closed loop and the cost."""
    P, n, N, discrete = equation.stabilizing.P, problem.A.rows, problem.N, problem.discrete
    K = equation.gain(problem.B, problem.R, N)
    yield Step(
        "gain",
        claims=gain_claims(problem, P, K),
        K=K,
        cross=N is not None,
        discrete=discrete,
        steps=products_of_the_gain(problem, P),
    )
    states = states_of(given)
    control = sp.ImmutableMatrix(-K * sp.Matrix(states))
    u = control[0, 0] if control.rows == 1 else control
    yield Step("law", claims={"u": Claim(product(-1, K, sp.ImmutableMatrix(states)), control, "the control law")}, u=u)
    expand = exact.expanded_around_roots if discrete else sp.expand
    loop = sp.ImmutableMatrix((problem.A - problem.B * K).applyfunc(expand))
    yield Step(
        "closed_loop",
        claims={"loop": Claim(difference(problem.A, product(problem.B, K)), loop, "closed loop $A - BK$")},
        steps=_eigenvalues(loop, equation.eigenvalues, discrete=discrete),
        eigenvalues=equation.eigenvalues,
        n=n,
        discrete=discrete,
        figures=optimal_loop(problem.A, loop, K, equation.eigenvalues, initial_state_of(given), discrete=discrete),
    )
    answers = Answers(P=P, K=K, u=u, Q=problem.Q, R=problem.R, closed_loop_A=loop, eigenvalues=equation.eigenvalues)
    x0 = initial_state_of(given)
    if x0 is not None:
        start = x0.xreplace({plain: positive for positive, plain in problem.plain.items()})
        stated = product(cost_factor(given.options), sp.ImmutableMatrix(start.T), P, start)
        cost = expand((start.T * P * start)[0, 0] * cost_factor(given.options))
        yield Step(
            "cost",
            claims={"J": Claim(stated, cost, "the least cost")},
            factor=cost_factor(given.options),
            discrete=discrete,
            steps=products_of_a_form(start, P, ("Px(0)", "x(0)^{T}Px(0)")),
        )
        answers["cost"] = cost
    return Answers(**{name: problem.restored(value) for name, value in answers.items()})
