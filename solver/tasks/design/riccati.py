"""The algebraic Riccati equation as a lemma: its stabilizing solution by the Hamiltonian matrix."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.arithmetic.determinants import worked_out
from solver.arithmetic.equations import system_solved
from solver.arithmetic.products import polynomial_of as polynomial_of_matrix
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, total
from solver.stated.matrices import determinant, inverse
from solver.tasks.design.regulator import Regulator, unknown_matrix
from solver.tasks.figures import plane, roots

LARGEST = 2
"""Polynomials of larger Hamiltonian matrices fill the page."""

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix


def riccati_of(problem: Regulator) -> exact.Riccati:
    """Return the equation; raises Unsolved with the reason where there is no stabilizing solution."""
    try:
        return exact.riccati(problem.A, problem.B, problem.Q, problem.R)
    except exact.NotStabilizable as finding:
        raise Unsolved("regulators/not_stabilizable", dual=problem.dual, modes=finding.modes) from finding
    except exact.OnTheAxis as finding:
        raise Unsolved(
            "regulators/on_the_axis", dual=problem.dual, factor=finding.factor.as_expr(sp.Symbol("s"))
        ) from finding


def hamiltonian_step(problem: Regulator, equation: exact.Riccati) -> Step:
    """H, its characteristic polynomial and the factors of that."""
    s, n = sp.Symbol("s"), equation.order
    chi = exact.faddeev_leverrier(equation.H).characteristic_polynomial(s)
    factors = exact.factored(equation.H, s)
    claims = {
        "G": Claim(
            product(problem.B, inverse(problem.R), sp.ImmutableMatrix(problem.B.T)),
            equation.G,
            "the block $B R^{-1} B^T$",
        ),
        "chi": Claim(
            determinant(difference(product(s, sp.ImmutableMatrix(sp.eye(2 * n))), equation.H)),
            chi,
            "characteristic polynomial of the Hamiltonian matrix",
        ),
    }
    if sp.expand(factors) == chi and factors != chi:
        claims["factors"] = Claim(chi, factors, "its factors")
    lines = worked_out(r"\det(sI - H)", exact.pencil(equation.H, s), chi, s) if n <= LARGEST else ()
    return Step("hamiltonian", claims=claims, steps=lines, H=equation.H, n=n, chi=chi, **problem.names)


def polynomial_of(solution: exact.RiccatiSolution) -> Expr:
    """p(s) = det(sI − A + BR⁻¹BᵀP)."""
    s, p = sp.Symbol("s"), solution.polynomial
    return sp.Add(*(c * s ** (len(p) - 1 - i) for i, c in enumerate(p)))


def residual_claim(problem: Regulator, P: ImmutableMatrix) -> Claim:
    """AᵀP + PA + Q = P B R⁻¹ Bᵀ P for a solution found."""
    return Claim(problem.linear_part(P), problem.quadratic_part(P), "the Riccati equation")


def loop_polynomial_claim(problem: Regulator, solution: exact.RiccatiSolution) -> Claim:
    """det(sI − A + B R⁻¹ Bᵀ P) = p(s)."""
    s, G = sp.Symbol("s"), exact.weighted_input(problem.B, problem.R)
    loop = total(product(s, sp.ImmutableMatrix(sp.eye(problem.A.rows))), product(-1, problem.A), product(G, solution.P))
    return Claim(determinant(loop), polynomial_of(solution), "characteristic polynomial of the closed loop")


def _solved(M: ImmutableMatrix, right: ImmutableMatrix, P: ImmutableMatrix) -> tuple[Step, ...]:
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


@lemma("hamiltonian")
def solution_by_hamiltonian(problem: Regulator) -> Derivation[exact.Riccati]:
    """The stable half p(s) of det(sI − H), and P from p(H) [I; P] = 0."""
    equation = riccati_of(problem)
    solution, n, s = equation.stabilizing, equation.order, sp.Symbol("s")
    step = hamiltonian_step(problem, equation)
    yield Step("hamiltonian", claims=step.claims, steps=step.steps, **step.values)
    p = polynomial_of(solution)
    mirrored = sp.Add(*(c * (-s) ** (n - i) for i, c in enumerate(solution.polynomial)))
    yield Step(
        "stable_half",
        claims={"halves": Claim(product((-1) ** n, p, mirrored), step.values["chi"], "the two halves of the spectrum")},
        p=p,
        chi=step.values["chi"],
        roots=equation.eigenvalues,
        n=n,
        exact=not p.has(sp.Float),
        figures=plane(
            "The spectrum of the Hamiltonian matrix",
            roots("the stable half", equation.eigenvalues, "square"),
            roots("the other half", [-each for each in equation.eigenvalues]),
            stable=True,
        ),
    )
    stable = equation.polynomial_of_hamiltonian(solution) if solution.exact else None
    if stable is not None:
        terms = (product(c, power(equation.H, n - i)) for i, c in enumerate(solution.polynomial) if c != 0)
        value = Claim(total(*terms), stable, "the stable half, at the Hamiltonian matrix")
        left, right = (sp.ImmutableMatrix(M) for M in (-stable[:, :n], stable[:, n:]))
        solve = Claim(product(right, solution.P), left, "the linear equations for $P$")
        at_H = polynomial_of_matrix(equation.H, solution.polynomial, stable) if n <= LARGEST else ()
        yield Step("annihilator", claims={"value": value}, n=n, p=p, left=left, right=right, steps=at_H)
        yield Step(
            "solve",
            claims={"linear": solve, "residual": residual_claim(problem, solution.P)},
            P=solution.P,
            steps=_solved(right, left, solution.P) if n <= LARGEST else (),
        )
    else:
        yield Step(
            "decimal_solution",
            claims={"residual": residual_claim(problem, solution.P)},
            P=solution.P,
            exact=solution.exact,
            **problem.names,
        )
    return equation
