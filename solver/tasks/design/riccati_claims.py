"""What is claimed of the solutions of a Riccati equation, in continuous or in discrete time."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar

from solver.arithmetic.equations import system_solved
from solver.arithmetic.exactness import where_exact
from solver.derivation import Claim, Step, Unsolved
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import determinant
from solver.tasks.design.regulator import Regulator, unknown_matrix

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

T = TypeVar("T")


def variable_of(problem: Regulator) -> Symbol:
    """The variable of polynomials: s, or z in discrete time."""
    return sp.Symbol("z" if problem.discrete else "s")


def riccati_of(problem: Regulator) -> exact.Riccati:
    """Return the equation; raises Unsolved with the reason where there is no stabilizing solution."""
    return discrete_riccati_of(problem) if problem.discrete else _solved(problem, exact.riccati)


def discrete_riccati_of(problem: Regulator) -> exact.DiscreteRiccati:
    """The same for a problem that is known to be one of discrete time."""
    return _solved(problem, exact.discrete_riccati)


def _solved(problem: Regulator, solve: Callable[..., T]) -> T:
    dual = problem.dual
    try:
        return solve(problem.A, problem.B, problem.Q, problem.R)
    except exact.NotStabilizable as finding:
        raise Unsolved("regulators/not_stabilizable", dual=dual, modes=finding.modes) from finding
    except exact.Undetermined as finding:
        raise Unsolved("regulators/undetermined", dual=dual) from finding
    except exact.OnTheAxis as finding:
        factor = finding.factor.as_expr(variable_of(problem))
        if problem.discrete:
            raise Unsolved("regulators/on_the_circle", dual=dual, factor=factor) from finding
        raise Unsolved("regulators/on_the_axis", dual=dual, factor=factor) from finding


def polynomial_of(problem: Regulator, solution: exact.RiccatiSolution) -> Expr:
    """The characteristic polynomial p of the loop that a solution makes."""
    x, p = variable_of(problem), solution.polynomial
    return sp.Add(*(c * x ** (len(p) - 1 - i) for i, c in enumerate(p)))


def residual_claim(problem: Regulator, P: ImmutableMatrix) -> Claim:
    """AᵀP + PA + Q = P B R⁻¹ Bᵀ P for a solution found; discrete: Q + AᵀPA − AᵀPB (R + BᵀPB)⁻¹ BᵀPA = P."""
    linear, quadratic = problem.linear_part(P), problem.quadratic_part(P)
    if problem.discrete:
        return Claim(difference(linear, quadratic), P, "the Riccati equation")
    return Claim(linear, quadratic, "the Riccati equation")


def loop_polynomial_claim(problem: Regulator, solution: exact.RiccatiSolution) -> Claim:
    """det(sI − A + B R⁻¹ Bᵀ P) = p(s), or in z with the gain of discrete time."""
    if problem.discrete:
        correction = product(problem.B, problem.gain_of(solution.P))
    else:
        correction = product(exact.weighted_input(problem.B, problem.R), solution.P)
    identity = sp.ImmutableMatrix(sp.eye(problem.A.rows))
    loop = total(product(variable_of(problem), identity), product(-1, problem.A), correction)
    return Claim(determinant(loop), polynomial_of(problem, solution), "characteristic polynomial of the closed loop")


@where_exact
def linear_equations(M: ImmutableMatrix, right: ImmutableMatrix, P: ImmutableMatrix) -> tuple[Step, ...]:
    """M P = `right`, as many independent equations as P has entries on and above the diagonal."""
    unknown, n = unknown_matrix(P.rows), P.rows
    pairs = [(i, j) for i in range(n) for j in range(i, n)]
    unknowns = [unknown[i, j] for i, j in pairs]
    equations = [each for each in zip((M * unknown).flat(), right.flat(), strict=True) if each[0] != 0]
    try:
        independent = exact.independent_equations(equations, unknowns)
    except exact.NotExact:  # roots of parameters: not for a pen
        return ()
    return system_solved(independent, unknowns, [P[i, j] for i, j in pairs])
