"""The algebraic Riccati equation as lemmas: all solutions entry by entry, or the stabilizing one by the Hamiltonian."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.derivation.stated import determinant, difference, inverse, power, product, total
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.design.regulator import Regulator
from solver.tasks.design.riccati_cases import cases_of

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix


@dataclass(frozen=True)
class Listed:
    """What the equation method finds: the equations, all solutions and what each is; None where they are endless."""

    P: ImmutableMatrix
    equations: list[Expr]
    solutions: list[ImmutableMatrix] | None
    definiteness: list[str] | None


def riccati_of(problem: Regulator) -> exact.Riccati:
    """Return the equation; raises Unsolved with the reason where there is no stabilizing solution."""
    try:
        return exact.riccati(problem.A, problem.B, problem.Q, problem.R)
    except exact.NotStabilizable as finding:
        modes = ", ".join(f"$\\lambda = {sp.latex(mode)}$" for mode in finding.modes)
        raise Unsolved(_not_stabilizable(problem.dual, modes, len(finding.modes) > 1)) from finding
    except exact.OnTheAxis as finding:
        raise Unsolved(_on_the_axis(problem.dual, finding.factor.as_expr(sp.Symbol("s")))) from finding


def _not_stabilizable(dual: bool, modes: str, several: bool) -> str:
    s, are = ("s", "are") if several else ("", "is")
    if dual:
        return (
            f"The pair $(A, C)$ is not detectable: the mode{s} {modes} {are} not asymptotically stable, and the output "
            f"does not show {'them' if several else 'it'}. No observer gain makes $A - LC$ stable."
        )
    return (
        f"The pair $(A, B)$ is not stabilizable: the mode{s} {modes} {are} not asymptotically stable, and the input "
        f"does not reach {'them' if several else 'it'}. No state feedback makes it stable, and the cost is infinite."
    )


def _on_the_axis(dual: bool, factor: Expr) -> str:
    noise = "not excited by the noise" if dual else "not seen by the weight $Q$"
    return (
        "The Hamiltonian matrix has eigenvalues on the imaginary axis: its characteristic polynomial has the factor "
        f"${sp.latex(factor)}$. A mode there is {noise}, so the Riccati equation has no stabilizing solution."
    )


@lemma("riccati_equations")
def solutions_by_equations(problem: Regulator) -> Derivation[tuple[exact.Riccati, Listed]]:
    """Write the equation entry by entry, list all symmetric solutions, choose the stabilizing one."""
    n, names = problem.A.rows, problem.names
    P = unknown_matrix(n)
    left = entries_of_equation(problem, P)
    stated = difference(problem.linear_part(P), problem.quadratic_part(P))
    yield Step("unknown", claims={"entries": Claim(stated, left, "the Riccati equation entry by entry")}, P=P, **names)
    pairs = [(i, j) for i in range(n) for j in range(i, n)]
    equations = [left[i, j] for i, j in pairs]
    yield Step(
        "equations",
        unclaimed="the entries on and above the diagonal, as found before",
        rows=[(i + 1, j + 1, equation) for (i, j), equation in zip(pairs, equations, strict=True)],
    )
    equation = riccati_of(problem)
    if equation.count is None:
        yield from _splitting(problem, equation, solved=False)
        yield from _endless(problem, equation)
        return equation, Listed(P, equations, None, None)
    always = [each for each in equation.solutions if each.radicand is None]
    conditional = [each for each in equation.solutions if each.radicand is not None]
    solved = yield from cases_of(P, equations, [*always, *conditional])
    yield from _splitting(problem, equation, solved=solved)
    for number, each in enumerate(always, 1):
        yield _solution(problem, each, number, len(always))
    if conditional:
        yield _conditional(problem, conditional)
    words = [definiteness_of(equation, each) for each in always]
    yield Step(
        "definiteness",
        unclaimed="definiteness is a matter of signs, not an equality; the verification judges it",
        words=words,
        exact=all(each.exact for each in always),
    )
    yield _choice(problem, always, words)
    return equation, Listed(P, equations, [each.P for each in always], words)


def unknown_matrix(n: int) -> ImmutableMatrix:
    """The symmetric matrix of p11, p12, … (with an underscore between the indices from n = 10 on)."""
    between = "" if n < 10 else "_"
    return sp.ImmutableMatrix(n, n, lambda i, j: sp.Symbol(f"p{min(i, j) + 1}{between}{max(i, j) + 1}"))


def entries_of_equation(problem: Regulator, P: ImmutableMatrix) -> ImmutableMatrix:
    """AᵀP + PA − P B R⁻¹ Bᵀ P + Q multiplied out."""
    G = exact.weighted_input(problem.B, problem.R)
    return sp.ImmutableMatrix((problem.A.T * P + P * problem.A - P * G * P + problem.Q).expand())


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
    return Step("hamiltonian", claims=claims, H=equation.H, n=n, chi=chi, **problem.names)


@lemma("riccati_equations")
def _splitting(problem: Regulator, equation: exact.Riccati, *, solved: bool) -> Derivation[None]:
    """Where the solutions come from: the factors of degree n of det(sI − H)."""
    step = hamiltonian_step(problem, equation)
    yield Step(
        "splitting", claims=step.claims, count=equation.count, solved=solved, fixed=any(equation.fixed), **step.values
    )


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


def _solution(problem: Regulator, solution: exact.RiccatiSolution, number: int, count: int) -> Step:
    claims = {"residual": residual_claim(problem, solution.P), "polynomial": loop_polynomial_claim(problem, solution)}
    return Step(
        "solution",
        claims=claims,
        P=solution.P,
        p=polynomial_of(solution),
        number=number,
        count=count,
        exact=solution.exact,
        **problem.names,
    )


def _conditional(problem: Regulator, solutions: Sequence[exact.RiccatiSolution]) -> Step:
    claims = {f"residual{i}": residual_claim(problem, each.P) for i, each in enumerate(solutions, 1)}
    return Step("conditional", claims=claims, listed=[(each.P, each.radicand) for each in solutions])


def definiteness_of(equation: exact.Riccati, solution: exact.RiccatiSolution) -> str:
    """Return the word. With parameters and (A, Q) observable P has as many negative eigenvalues as p unstable roots."""
    P, n = solution.P, equation.order
    if not P.free_symbols:
        return exact.definiteness_of_numbers(P)
    if equation.observable:
        return {0: "positive definite", n: "negative definite"}.get(solution.flips, "indefinite")
    if solution.flips == 0:
        return "positive semidefinite"
    return "depends on the parameters"


def _choice(problem: Regulator, solutions: Sequence[exact.RiccatiSolution], words: Sequence[str]) -> Step:
    first = solutions[0]
    claims = {"polynomial": loop_polynomial_claim(problem, first)}
    return Step(
        "choice",
        claims=claims,
        P=first.P,
        p=polynomial_of(first),
        others=[polynomial_of(each) for each in solutions[1:]],
        cheaper=[number for number, word in enumerate(words[1:], 2) if word.startswith("positive")],
        **problem.names,
    )


def _endless(problem: Regulator, equation: exact.Riccati) -> Derivation[None]:
    """A continuum of solutions: the stabilizing one, and a family with one parameter where it has a simple form."""
    first = equation.stabilizing
    claims = {"residual": residual_claim(problem, first.P), "polynomial": loop_polynomial_claim(problem, first)}
    family = equation.family(sp.Symbol("tau"))
    if family is not None:
        claims["family"] = residual_claim(problem, family[0])
    yield Step(
        "endless",
        claims=claims,
        P=first.P,
        p=polynomial_of(first),
        family=family[0] if family else None,
        eigenvalue=family[1] if family else None,
        **problem.names,
    )


@lemma("hamiltonian")
def solution_by_hamiltonian(problem: Regulator) -> Derivation[exact.Riccati]:
    """The stable half p(s) of det(sI − H), and P from p(H) [I; P] = 0."""
    equation = riccati_of(problem)
    solution, n, s = equation.stabilizing, equation.order, sp.Symbol("s")
    step = hamiltonian_step(problem, equation)
    yield Step("hamiltonian", claims=step.claims, **step.values)
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
    )
    stable = equation.polynomial_of_hamiltonian(solution) if solution.exact else None
    if stable is not None:
        terms = (product(c, power(equation.H, n - i)) for i, c in enumerate(solution.polynomial) if c != 0)
        value = Claim(total(*terms), stable, "the stable half, at the Hamiltonian matrix")
        left, right = (sp.ImmutableMatrix(M) for M in (-stable[:, :n], stable[:, n:]))
        solve = Claim(product(right, solution.P), left, "the linear equations for $P$")
        yield Step("annihilator", claims={"value": value}, n=n, p=p, left=left, right=right)
        yield Step("solve", claims={"linear": solve, "residual": residual_claim(problem, solution.P)}, P=solution.P)
    else:
        yield Step(
            "decimal_solution",
            claims={"residual": residual_claim(problem, solution.P)},
            P=solution.P,
            exact=solution.exact,
            **problem.names,
        )
    return equation
