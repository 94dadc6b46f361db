"""The algebraic Riccati equation as a lemma: its stabilizing solution by the Hamiltonian matrix."""

from __future__ import annotations

from solver.arithmetic.determinants import worked_out
from solver.arithmetic.products import polynomial_of as polynomial_of_matrix
from solver.arithmetic.roots import factored
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, total
from solver.stated.matrices import determinant, inverse
from solver.tasks.design.regulator import Regulator
from solver.tasks.design.riccati_claims import linear_equations, polynomial_of, residual_claim, riccati_of
from solver.tasks.design.symplectic import solution_by_pencil
from solver.tasks.figures import plane, roots

LARGEST = 2
"""Polynomials of larger Hamiltonian matrices fill the page."""


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
    if "factors" in claims:
        lines += factored(chi, factors, s)
    return Step("hamiltonian", claims=claims, steps=lines, H=equation.H, n=n, chi=chi, **problem.names)


@lemma("hamiltonian")
def solution_by_hamiltonian(problem: Regulator) -> Derivation[exact.Riccati]:
    """The stable half p(s) of det(sI − H), and P from p(H) [I; P] = 0; in discrete time by the symplectic pencil."""
    if problem.discrete:
        return (yield from solution_by_pencil(problem))
    equation = riccati_of(problem)
    solution, n, s = equation.stabilizing, equation.order, sp.Symbol("s")
    step = hamiltonian_step(problem, equation)
    yield Step("hamiltonian", claims=step.claims, steps=step.steps, **step.values)
    p = polynomial_of(problem, solution)
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
            steps=linear_equations(right, left, solution.P) if n <= LARGEST else (),
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
