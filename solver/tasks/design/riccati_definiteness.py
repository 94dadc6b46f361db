"""What each solution of a Riccati equation is: definite or not, by leading minors, or by eigenvalues."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.arithmetic.determinants import worked_out
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product
from solver.stated.matrices import determinant
from solver.tasks.design.frames import characteristic
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix


def definiteness_of(equation: exact.Riccati, solution: exact.RiccatiSolution) -> str:
    """Return the word. With (A, Q) observable, Q ≥ 0, P has as many negative eigenvalues as p unstable roots."""
    P, n = solution.P, equation.order
    if equation.observable and exact.negative_by_rounding(equation.Q) is None:
        return {0: "positive definite", n: "negative definite"}.get(solution.flips, "indefinite")
    if not P.free_symbols:
        return exact.definiteness_of_numbers(P)
    return exact.definiteness(P) or "depends on the parameters"


@lemma("riccati_definiteness")
def told_definite(solutions: Sequence[exact.RiccatiSolution], words: Sequence[str]) -> Derivation[None]:
    """What each solution is, and why."""
    yield _by_minors(solutions, words)


def _by_minors(solutions: Sequence[exact.RiccatiSolution], words: Sequence[str]) -> Step:
    """The leading minors of every solution, where none of the solutions is singular; else the eigenvalues of each."""
    minors: list[list[tuple[Expr, int]]] = []
    claims: dict[str, Claim] = {}
    lines: list[Step] = []
    if all(each.exact for each in solutions):
        for number, each in enumerate(solutions, 1):
            minors.append([])
            for k in range(1, each.P.rows + 1):
                block = sp.ImmutableMatrix(each.P[:k, :k])
                minor = _minor(block)
                if minor is None:
                    return _by_eigenvalues(solutions, words)
                minors[-1].append((minor, _sign(minor)))
                of_which = f"(P_{{{number}}})" if len(solutions) > 1 else ""
                lines += worked_out(f"\\Delta_{{{k}}}{of_which}", block, minor)
                claims[f"minor{k}_{number}"] = Claim(
                    determinant(block), minor, Phrase("leading minor {k} of $P_{{{number}}}$", k=k, number=number)
                )
    undecided = any(sign == 0 and minor.free_symbols for listed in minors for minor, sign in listed)
    if not minors or undecided or any(each[-1][1] == 0 for each in minors):
        return _by_eigenvalues(solutions, words)
    return Step("definiteness", claims=claims, words=words, minors=minors, steps=tuple(lines))


def _minor(block: ImmutableMatrix) -> Expr | None:
    """The determinant of a leading block; None where its letters stand below roots that allow no exact arithmetic."""
    if block.rows == 1:
        return block[0, 0]
    try:
        return exact.determinant(block)
    except exact.NotExact:
        return None


def _sign(minor: Expr) -> int:
    """The sign of a minor; 0 where it is zero, or where the parameters do not decide it."""
    if not minor.free_symbols:
        return exact.sign_of(minor) or 0
    return 1 if minor.is_positive else -1 if minor.is_negative else 0


def _by_eigenvalues(solutions: Sequence[exact.RiccatiSolution], words: Sequence[str]) -> Step:
    """The eigenvalues of every solution; the words alone where one has parameters or eigenvalues of no usable form."""
    x = sp.Symbol("lamda")
    try:
        usable = all(each.exact and not each.P.free_symbols for each in solutions)
        found = [exact.spectrum(each.P).eigenvalues for each in solutions] if usable else []
    except exact.NotExact:
        found = []
    if not found:
        reason = "definiteness is a matter of signs, not an equality; the verification judges it"
        return Step("definiteness", unclaimed=reason, words=words, minors=[], eigenvalues=[])
    claims = {
        f"eigenvalues_{number}": Claim(
            characteristic(each.P, x),
            product(*(x - value for value in values)),
            Phrase("eigenvalues of $P_{{{number}}}$", number=number),
        )
        for number, (each, values) in enumerate(zip(solutions, found, strict=True), 1)
    }
    return Step("definiteness", claims=claims, words=words, minors=[], eigenvalues=found)
