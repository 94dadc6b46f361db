"""What poles and zeros of a system with several inputs and outputs must be, judged by the matrices of the question."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Check, Claim, Given, Task
from solver.lazy import numeric
from solver.numeric.judges import multivariable as judges
from solver.numeric.judges import representation
from solver.stated.matrices import determinant
from solver.tasks.plant_options import LoopOptions
from solver.tasks.representation.plants import numbers_of, stated_matrix, variable_of
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.tasks.needed import InputOutput

ORACLE = "orthogonal bases (50 digits)"
KINDS: dict[str, tuple[Any, str]] = {
    "zeros": ("transmission", "the zeros are where the system matrix of the minimal part falls in rank"),
    "invariant_zeros": ("invariant", "the invariant zeros are where the system matrix falls in rank"),
    "input_decoupling_zeros": ("input", "the input decoupling zeros are where $[xI - A, -B]$ falls in rank"),
    "output_decoupling_zeros": ("output", "the output decoupling zeros are where $[xI - A; C]$ falls in rank"),
}


def register(task: Task[Any, Any]) -> None:
    """Add the verifications to a task with these answers."""
    task.verification("poles", "zeros", "pole_polynomial", "zero_polynomial", *list(KINDS)[1:])(are_of_the_system)
    task.verification("normal_rank")(is_the_rank_at_random)
    task.verification("determinant")(has_the_values_of_the_formula)
    task.verification("zero_directions")(are_blocked)


def are_of_the_system(given: Given[InputOutput, LoopOptions], answers: Answers) -> Iterable[Check]:
    """Poles are eigenvalues of the minimal part; zeros of each kind where a pencil falls in rank."""
    plant, x = numbers_of(given.system), variable_of(given.system)
    residuals: dict[str, Any] = {
        "poles": (
            "the poles are the eigenvalues of the minimal part",
            partial(representation.pole_residual, plant, _listed(answers, "poles")),
        ),
        "pole_polynomial": (
            r"the polynomial of the poles is $\det(xI - A)$ of the minimal part",
            partial(judges.pole_polynomial_residual, plant, answers.get("pole_polynomial"), x),
        ),
        "zero_polynomial": (
            "the polynomial of the zeros is what the minors of the system matrix have in common",
            partial(judges.zero_polynomial_residual, plant, answers.get("zero_polynomial"), x),
        ),
        **{
            name: (label, partial(judges.zeros_residual, plant, _listed(answers, name), kind))
            for name, (kind, label) in KINDS.items()
        },
    }
    for name, (label, residual) in residuals.items():
        if name in answers:
            yield numeric.check_residual(label, ORACLE, residual, answer=name)


def _listed(answers: Answers, name: str) -> list[Any]:
    return list(answers.get(name, ()))


def is_the_rank_at_random(given: Given[InputOutput, LoopOptions], answers: Answers) -> Iterable[Check]:
    """The rank of G at a random point."""
    right = judges.normal_rank(numbers_of(given.system)) == answers["normal_rank"]
    yield Check.that("the rank at a random point", ORACLE, right, answer="normal_rank")


def has_the_values_of_the_formula(given: Given[InputOutput, LoopOptions], answers: Answers) -> Iterable[Check]:
    """The determinant at random points, that of the matrix by numpy."""
    label = Phrase(r"$\det G({x})$ at random points", x=variable_of(given.system))
    claim = Claim(determinant(stated_matrix(given.system)), answers["determinant"])
    yield numeric.check_claim(claim, label, answer="determinant")


def are_blocked(given: Given[InputOutput, LoopOptions], answers: Answers) -> Iterable[Check]:
    """G(z) u = 0 for each column; without the list of zeros, each at a zero of its own."""
    plant, zeros = numbers_of(given.system), answers.get("zeros")
    residual = partial(
        judges.directions_residual, plant, answers["zero_directions"], None if zeros is None else list(zeros)
    )
    yield numeric.check_residual(r"$G(z)\,u = 0$", ORACLE, residual, answer="zero_directions")
