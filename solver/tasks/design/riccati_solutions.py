"""All solutions of a Riccati equation as a lemma: entry by entry, then the choice of the one that stabilizes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Attempt, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.tasks.design.frames import expansion_of
from solver.tasks.design.regulator import Regulator, unknown_matrix
from solver.tasks.design.riccati_cases import cases_of
from solver.tasks.design.riccati_claims import (
    loop_polynomial_claim,
    polynomial_of,
    residual_claim,
    riccati_of,
    variable_of,
)
from solver.tasks.design.riccati_definiteness import definiteness_of, told_definite
from solver.tasks.design.riccati_equations import entries_of, spectrum_step

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

LISTED = (
    AnswerName(
        "equations",
        r"\text{equations}",
        "the entries of the Riccati equation, each of which is zero",
        ("riccati",),
        zero=True,
        told=("equations",),
    ),
    AnswerName(
        "solutions",
        r"P_i",
        "all real symmetric solutions",
        ("riccati",),
        optional=True,
        told=("cases", "solution"),
    ),
    AnswerName(
        "definiteness",
        r"\text{definiteness}",
        "the definiteness of each solution of the Riccati equation",
        ("riccati",),
        optional=True,
        ordered=True,
        words=(
            "positive definite",
            "positive semidefinite",
            "negative definite",
            "negative semidefinite",
            "indefinite",
        ),
        told=("definiteness",),
    ),
)
"""The answers of the method `riccati` beside the stabilizing solution."""


LARGEST_BY_CASES = {False: 3, True: 2}
"""The largest matrices whose equations may be solved case by case, in continuous and in discrete time."""


@dataclass(frozen=True)
class Listed:
    """What the equation method finds: the equations, all solutions (None if endless or too many) and what each is."""

    P: ImmutableMatrix
    equations: list[Expr]
    solutions: list[ImmutableMatrix] | None
    definiteness: list[str] | None


def listed_answers(problem: Regulator, listed: Listed) -> Answers:
    """What was listed, in the symbols of the problem."""
    answers = Answers(equations=problem.restored(listed.equations))
    if listed.solutions is not None:
        answers |= {"solutions": problem.restored(listed.solutions), "definiteness": listed.definiteness}
    return answers


@lemma("riccati_equations")
def solutions_by_equations(problem: Regulator) -> Derivation[tuple[exact.Riccati, Listed]]:
    """Write the equation entry by entry, list all symmetric solutions, choose the stabilizing one."""
    n = problem.A.rows
    P = unknown_matrix(n)
    facts, left = entries_of(problem, P)
    yield Step("unknown", **facts)
    pairs = [(i, j) for i in range(n) for j in range(i, n)]
    rows = [(i + 1, j + 1, left[i, j]) for i, j in pairs]
    equations = [each for *_, each in rows]
    impossible = any(each.is_number and each != 0 for each in equations)  # 1 = 0, where the input reaches nothing
    yield Step("equations", unclaimed="the entries on and above the diagonal, as found before", rows=rows,
               impossible=impossible)  # fmt: skip
    equation = riccati_of(problem)
    if not equation.listable:
        yield from _splitting(problem, equation, solved=False)
        yield _endless(problem, equation) if equation.count is None else _many(problem, equation)
        return equation, Listed(P, equations, None, None)
    always = [each for each in equation.solutions if each.radicand is None]
    conditional = [each for each in equation.solutions if each.radicand is not None]
    solved = n <= LARGEST_BY_CASES[problem.discrete] and (yield from cases_of(P, rows, [*always, *conditional]))
    yield from _splitting(problem, equation, solved=solved)
    for number, each in enumerate(always, 1):
        yield _solution(problem, equation, each, number, len(always), solved=solved)
    if conditional:
        yield _conditional(problem, conditional, first=len(always) + 1)
    words = [definiteness_of(equation, each) for each in always]
    yield from told_definite(always, words)
    yield _choice(problem, always, words)
    return equation, Listed(P, equations, [each.P for each in always], words)


@lemma("riccati_equations")
def _splitting(problem: Regulator, equation: exact.Riccati, *, solved: bool) -> Derivation[None]:
    """Where the solutions come from: the factors of degree n of det(sI − H)."""
    step = spectrum_step(problem, equation)
    yield Step(
        "splitting",
        claims=step.claims,
        steps=step.steps,
        count=equation.count,
        solved=solved,
        fixed=any(equation.fixed),
        **step.values,
    )


def _solution(
    problem: Regulator,
    equation: exact.Riccati,
    solution: exact.RiccatiSolution,
    number: int,
    count: int,
    *,
    solved: bool,
) -> Step:
    """Return the test of a solution; one that was `solved` for, case by case, has been shown there."""
    claims = {"residual": residual_claim(problem, solution.P), "polynomial": loop_polynomial_claim(problem, solution)}
    worked, lines = _loop_worked_out(problem, equation, solution)
    return Step(
        "solution",
        claims=claims | worked,
        steps=lines,
        P=solution.P,
        p=polynomial_of(problem, solution),
        number=number,
        count=count,
        exact=solution.exact,
        solved=solved,
        **problem.names,
    )


def _loop_worked_out(
    problem: Regulator, equation: exact.Riccati, solution: exact.RiccatiSolution
) -> tuple[dict[str, Claim], tuple[Step, ...]]:
    """The matrix of the loop and the first line of its determinant, where P is of rational numbers."""
    numbers = (entry for M in (solution.P, problem.A, problem.B, problem.R) for entry in M.flat())
    if not all(entry.is_Rational for entry in numbers):
        return {}, ()
    if isinstance(equation, exact.DiscreteRiccati):
        gain = equation.loop_gain(solution)
        loop = sp.ImmutableMatrix(problem.A - problem.B * gain)
        stated = difference(problem.A, product(problem.B, gain))
    else:
        G = exact.weighted_input(problem.B, problem.R)
        loop = sp.ImmutableMatrix(problem.A - exact.multiply(G, solution.P))
        stated = difference(problem.A, product(sp.ImmutableMatrix(G), solution.P))
    claims, lines = expansion_of(loop, variable_of(problem), polynomial_of(problem, solution))
    return {"loop": Claim(stated, loop, "matrix of the loop"), **claims}, lines


def _conditional(problem: Regulator, solutions: Sequence[exact.RiccatiSolution], first: int) -> Step:
    """The solutions that follow those which are always real; `first` is the number of the first one."""
    claims = {f"residual{i}": residual_claim(problem, each.P) for i, each in enumerate(solutions, 1)}
    return Step("conditional", claims=claims, listed=[(each.P, each.radicand) for each in solutions], first=first)


def _choice(problem: Regulator, solutions: Sequence[exact.RiccatiSolution], words: Sequence[str]) -> Step:
    first = solutions[0]
    claims = {"polynomial": loop_polynomial_claim(problem, first)}
    return Step(
        "choice",
        claims=claims,
        P=first.P,
        p=polynomial_of(problem, first),
        others=[polynomial_of(problem, each) for each in solutions[1:]],
        cheaper=[number for number, word in enumerate(words[1:], 2) if word.startswith("positive")],
        **problem.names,
    )


def _many(problem: Regulator, equation: exact.Riccati) -> Step:
    """More solutions than anyone would read: the stabilizing one alone."""
    first = equation.stabilizing
    claims = {"residual": residual_claim(problem, first.P), "polynomial": loop_polynomial_claim(problem, first)}
    return Step(
        "many", claims=claims, P=first.P, p=polynomial_of(problem, first), count=equation.count, **problem.names
    )


def _endless(problem: Regulator, equation: exact.Riccati) -> Step:
    """A continuum of solutions: the stabilizing one, and a family with one parameter where it has a simple form."""
    first = equation.stabilizing
    claims = {"residual": residual_claim(problem, first.P), "polynomial": loop_polynomial_claim(problem, first)}
    family = equation.family(sp.Symbol("tau"))
    if family is not None:
        claims["family"] = residual_claim(problem, family[0])
    return Step(
        "endless",
        claims=claims,
        P=first.P,
        p=polynomial_of(problem, first),
        family=family[0] if family else None,
        eigenvalue=family[1] if family else None,
        **problem.names,
    )


def other_solutions(wrong: Attempt[Any, Any]) -> Iterable[Any]:
    """The solutions of the Riccati equation that are not the stabilizing one."""
    yield from (P for P in wrong.answers.get("solutions", ()) if wrong.ours != P)
