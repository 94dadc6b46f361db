"""The discrete Riccati equation as a lemma: its stabilizing solution by the symplectic pencil."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.arithmetic.determinants import worked_out
from solver.arithmetic.products import polynomial_of as polynomial_of_matrix
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, total
from solver.stated.matrices import determinant, inverse
from solver.tasks.design.regulator import Regulator
from solver.tasks.design.riccati_claims import discrete_riccati_of, linear_equations, polynomial_of, residual_claim
from solver.tasks.figures import plane, roots

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.derivation.figures import Figure
    from solver.stated import Stated

LARGEST = 2
"""Polynomials of larger symplectic matrices fill the page."""


def pencil_step(problem: Regulator, equation: exact.DiscreteRiccati) -> Step:
    """M and E of the pencil zE − M, its determinant and the factors of that."""
    z, n = sp.Symbol("z"), equation.order
    M, E = exact.symplectic_pencil(equation)
    phi, factors = exact.pencil_polynomial(equation, z)
    regular = M.rows == 2 * n
    pencil = sp.ImmutableMatrix((z * E - M).expand())
    claims = {
        "pencil": Claim(difference(product(z, E), M), pencil, "the pencil"),
        "phi": Claim(determinant(pencil), phi, "determinant of the pencil"),
    }
    if regular:
        G = sp.ImmutableMatrix(E[:n, n:])
        stated = product(problem.B, inverse(problem.R), problem.Bt)
        claims["G"] = Claim(stated, G, "the block $B R^{-1} B^T$")
    if sp.expand(factors) == sp.expand(phi) and factors != phi:
        claims["factors"] = Claim(phi, factors, "its factors")
    lines = worked_out(r"\det(zE - M)", pencil, phi, z) if M.rows <= 2 * LARGEST else ()
    return Step(
        "pencil",
        claims=claims,
        steps=lines,
        M=M,
        E=E,
        n=n,
        m=problem.B.cols,
        phi=phi,
        degree=sp.Poly(phi, z).degree(),
        regular=regular,
        singular=equation.symplectic is None,
        unreached=equation.unreached,
        **problem.names,
    )


@lemma("symplectic")
def solution_by_pencil(problem: Regulator) -> Derivation[exact.DiscreteRiccati]:
    """The half p(z) of det(zE − M) with its roots in the unit disc, and P from the linear equations that p makes."""
    equation = discrete_riccati_of(problem)
    solution, n = equation.stabilizing, equation.order
    step = pencil_step(problem, equation)
    if not step.values["regular"]:
        raise Unsolved("regulators/singular_weight", dual=problem.dual)
    yield Step("pencil", claims=step.claims, steps=step.steps, **step.values)
    p, phi = polynomial_of(problem, solution), step.values["phi"]
    factor = exact.reciprocal_factor(equation, solution)
    claims = {"halves": Claim(product(factor, p, reversed_polynomial(solution)), phi, "the two halves")}
    yield Step(
        "stable_half",
        claims=claims,
        p=p,
        phi=phi,
        roots=equation.eigenvalues,
        n=n,
        exact=not p.has(sp.Float),
        factor=factor,
        reciprocal=reversed_polynomial(solution),
        figures=_spectrum(equation),
    )
    E = exact.annihilator(equation, solution)
    if E is None:
        yield Step(
            "decimal_solution",
            claims={"residual": residual_claim(problem, solution.P)},
            P=solution.P,
            singular=step.values["singular"],
            **problem.names,
        )
        return equation
    yield _annihilator(equation, solution, E)
    left, right = (sp.ImmutableMatrix(part) for part in (-E[:, :n], E[:, n:]))
    yield Step(
        "solve",
        claims={
            "linear": Claim(product(right, solution.P), left, "the linear equations for $P$"),
            "residual": residual_claim(problem, solution.P),
        },
        P=solution.P,
        left=left,
        right=right,
        steps=linear_equations(right, left, solution.P) if n <= LARGEST else (),
    )
    return equation


def reversed_polynomial(solution: exact.RiccatiSolution) -> Expr:
    """zⁿ p(1/z): the coefficients in reversed order."""
    z = sp.Symbol("z")
    return sp.Add(*(c * z**i for i, c in enumerate(solution.polynomial)))


def _annihilator(equation: exact.DiscreteRiccati, solution: exact.RiccatiSolution, found: ImmutableMatrix) -> Step:
    """p(S) with S = E⁻¹M where A is regular; else the polynomial in X = (M + E)⁻¹M and Y = (M + E)⁻¹E."""
    M, E = exact.symplectic_pencil(equation)
    S, (X, Y), p, n = equation.symplectic, equation.halves, solution.polynomial, equation.order
    if S is not None:
        claims = {"S": Claim(product(inverse(E), M), S, "the symplectic matrix")}
        terms: list[Stated] = [product(c, power(S, n - i)) for i, c in enumerate(p) if c != 0]
        lines = polynomial_of_matrix(S, p, found) if n <= LARGEST else ()
    else:
        both = inverse(total(M, E))
        claims = {"X": Claim(product(both, M), X, "$X$"), "Y": Claim(product(both, E), Y, "$Y$")}
        terms = [product(c, power(X, n - i), power(Y, i)) for i, c in enumerate(p) if c != 0]
        lines = ()
    claims["value"] = Claim(total(*terms), found, "the stable half, at the pencil")
    return Step(
        "annihilator",
        claims=claims,
        steps=lines,
        n=n,
        singular=S is None,
        M=M,
        E=E,
        X=X,
        Y=Y,
        S=S,
        left=-found[:, :n],
        right=found[:, n:],
    )


def _spectrum(equation: exact.DiscreteRiccati) -> tuple[Figure, ...]:
    """The stable roots and their mirror images, but for those at infinity."""
    others = [sp.radsimp(1 / each) for each in equation.eigenvalues if each != 0]
    return plane(
        "The roots of the determinant, inside and outside of the unit circle",
        roots("the stable half", equation.eigenvalues, "square"),
        roots("the other half", others),
        discrete=True,
        stable=True,
    )
