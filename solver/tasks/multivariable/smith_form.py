"""Smith's form of a matrix of polynomials: its invariant factors, each of which divides the next."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Options, Task
from solver.lazy import numeric
from solver.numeric.judges import multivariable as judges
from solver.tasks.multivariable import smith_mistakes
from solver.tasks.multivariable.diagonals import diagonal_of, on_the_diagonal
from solver.tasks.multivariable.smith import smith_form_of

if TYPE_CHECKING:
    from solver.systems import PolynomialMatrix


@dataclass(frozen=True, kw_only=True)
class SmithFormOptions(Options):
    """Nothing to choose."""


smith_form: Task[PolynomialMatrix, SmithFormOptions] = Task(
    "smith_form",
    title="Smith form",
    doc="The diagonal form of a polynomial matrix under elementary operations on rows and columns.",
    needs=("polynomial_matrix",),
    options=SmithFormOptions,
    answers=[
        AnswerName(
            "invariant_factors",
            "e_k",
            "the invariant factors, monic, each dividing the next; zeros where the rank falls short",
            ordered=True,
            principal=True,
            earned=("pivot", "minors", "quotients", "factors"),
        ),
        AnswerName("form", "S", "Smith's form, with the shape of the matrix", earned=("factors",)),
    ],
)

smith_mistakes.register_for_polynomials(smith_form)


@smith_form.method(source="Gantmacher, The Theory of Matrices I, VI §2")
def by_elementary_operations(given: Given[PolynomialMatrix, SmithFormOptions]) -> Derivation[Answers]:
    """Euclid's algorithm on rows and columns, or gcds of minors where the operations grow long."""
    form = yield from smith_form_of(given.system.matrix, given.system.variable, "M")
    return Answers(invariant_factors=list(form.invariant_factors), form=form.form)


@smith_form.verification("invariant_factors", "form")
def are_those_of_the_minors(given: Given[PolynomialMatrix, SmithFormOptions], answers: Answers) -> Iterable[Check]:
    """The product of the first k factors divides all k×k minors, and no more is common to them; all are monic."""
    M, x = given.system.matrix, given.system.variable
    for name in ("invariant_factors", "form"):
        if name in answers:
            listed = diagonal_of(answers[name], M.shape)
            label = "the products of the factors are the greatest common divisors of the minors"
            check = partial(judges.smith_residual, M, listed, x)
            yield numeric.check_residual(label, judges.MINORS, check, answer=name)


@smith_form.consequence("form", of=("invariant_factors",))
def factors_on_the_diagonal(given: Given[PolynomialMatrix, SmithFormOptions], found: Mapping[str, Any]) -> Any:
    """The factors on the diagonal."""
    return on_the_diagonal(list(found["invariant_factors"]), given.system.matrix.shape)
