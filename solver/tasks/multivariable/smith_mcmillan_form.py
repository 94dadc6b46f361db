"""The Smith–McMillan form of a transfer matrix, which shows its poles and zeros with their multiplicities."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Task
from solver.lazy import exact, numeric, systems
from solver.numeric.judges import multivariable as judges
from solver.tasks import mistakes
from solver.tasks.multivariable import smith_mistakes
from solver.tasks.multivariable.diagonals import diagonal_of, on_the_diagonal
from solver.tasks.multivariable.smith_mcmillan import smith_mcmillan_of
from solver.tasks.plant_options import LoopOptions
from solver.tasks.representation.plants import matrices_of, variable_of
from solver.tasks.representation.transfer_function import transfer_function_of

if TYPE_CHECKING:
    from solver.tasks.needed import InputOutput

smith_mcmillan_form: Task[InputOutput, LoopOptions] = Task(
    "smith_mcmillan_form",
    title="Smith–McMillan form",
    doc="The diagonal form of a transfer matrix under unimodular matrices: its poles and zeros with multiplicities.",
    needs=("transfer_function",),
    options=LoopOptions,
    answers=[
        AnswerName(
            "diagonal",
            r"\varepsilon_i/\psi_i",
            "the entries of the diagonal in their order, monic; zeros where the rank falls short",
            ordered=True,
            principal=True,
            earned=("common_denominator", "factors", "divided", "form"),
        ),
        AnswerName("form", "M", "the diagonal matrix, p×m", earned=("form",)),
    ],
)

smith_mistakes.register_for_fractions(smith_mcmillan_form)
smith_mcmillan_form.mistaken_question(mistakes.EXCHANGED)(mistakes.inputs_for_outputs)


@smith_mcmillan_form.method(source="Maciejowski, Multivariable Feedback Design, §2.2")
def by_smith_form(given: Given[InputOutput, LoopOptions]) -> Derivation[Answers]:
    """Smith's form of the numerators over the common denominator, each entry divided by it and cancelled."""
    plant = given.system
    if isinstance(plant, systems.TransferFunction):
        G = exact.transfer_matrix_of_fractions(plant.numerators, plant.denominators, plant.variable)
    else:
        G = yield from transfer_function_of(plant)
    found = yield from smith_mcmillan_of(G)
    return Answers(diagonal=list(found.diagonal), form=found.form)


@smith_mcmillan_form.verification("diagonal", "form")
def are_those_of_the_minors(given: Given[InputOutput, LoopOptions], answers: Answers) -> Iterable[Check]:
    """Over the common denominator the products of the entries are the gcds of the minors; all are monic."""
    plant = given.system
    x = variable_of(plant)
    if isinstance(plant, systems.TransferFunction):
        question: Any = plant.numerators, plant.denominators
    else:
        question = matrices_of(plant)
    for name in ("diagonal", "form"):
        if name in answers:
            listed = diagonal_of(answers[name], _shape(given))
            label = "the products of the entries are the greatest common divisors of the minors"
            check = partial(judges.smith_mcmillan_residual, question, listed, x)
            yield numeric.check_residual(label, judges.MINORS, check, answer=name)


def _shape(given: Given[InputOutput, LoopOptions]) -> tuple[int, int]:
    """Outputs p and inputs m."""
    p, m = (given.system.size(of) for of in "pm")
    assert p is not None and m is not None  # noqa: S101, PT018 - a path from inputs to outputs has both
    return p, m


@smith_mcmillan_form.consequence("form", of=("diagonal",))
def entries_on_the_diagonal(given: Given[InputOutput, LoopOptions], found: Mapping[str, Any]) -> Any:
    """The entries on the diagonal."""
    return on_the_diagonal(list(found["diagonal"]), _shape(given))
