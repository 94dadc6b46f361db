"""State equations for a transfer function: companion, diagonal, Jordan and modal form."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Derivation,
    Given,
    Refusal,
    Slip,
    Task,
    Unsolved,
    option,
    state_equations,
)
from solver.lazy import systems
from solver.options.choice import Choice
from solver.tasks.form_meanings import other_transfer
from solver.tasks.plant_options import LoopOptions
from solver.tasks.representation.completing import register
from solver.tasks.representation.lowest_terms import fractions_of
from solver.tasks.representation.modal_forms import mode_form_of
from solver.tasks.representation.multivariable_forms import companion_coordinates_of
from solver.tasks.representation.realization_checks import realization_checks
from solver.tasks.representation.realization_lemmas import companion_form_of, direct_path_of
from solver.tasks.representation.transfer_function import transfer_function_of
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from solver.systems import System
    from solver.tasks.needed import InputOutput

COMPANION = ("controllable", "observable")
FORMS = (*COMPANION, "diagonal", "jordan", "modal")
CONVENTIONS = ("last_row", "first_row", "subdiagonal", "superdiagonal")


@dataclass(frozen=True, kw_only=True)
class RealizationOptions(LoopOptions):
    """The form, and how it is written."""

    form: str = option(
        Choice(FORMS),
        "the canonical form",
        titles={
            "controllable": "Controllable canonical form",
            "observable": "Observable canonical form",
            "diagonal": "Diagonal form",
            "jordan": "Jordan form",
            "modal": "Modal form",
        },
    )
    convention: str = option(
        Choice(CONVENTIONS),
        "companion forms: coefficients in the last row (controllable; observable: column) or in the first; "
        "Jordan and modal form: the ones of a chain below or above the diagonal (subdiagonal if not said)",
        conventions=CONVENTIONS,
    )


realization: Task[InputOutput, RealizationOptions] = Task(
    "realization",
    title="Realization",
    doc="State equations with a given transfer function, in one of the canonical forms; no common factor is cancelled.",
    needs=("transfer_function",),
    options=RealizationOptions,
    answers=[
        AnswerName(
            "A",
            "A",
            "system matrix; its order is the degree of the denominator as given",
            free=True,
            earned=("coefficients", "partial_fractions", "blocks"),
        ),
        AnswerName("B", "B", "input matrix", free=True),
        AnswerName("C", "C", "output matrix", free=True),
        AnswerName("D", "D", r"direct path, $G(\infty)$"),
    ],
)
realization.together(state_equations())


@realization.refusal
def of_a_convention_of_another_form(_system: System, options: RealizationOptions) -> Iterable[Refusal]:
    """A convention belongs to the companion forms or to the chains."""
    form, convention = options.form, options.convention
    if form in COMPANION and convention in ("subdiagonal", "superdiagonal"):
        yield "convention", Reason("realization/convention_of_chains", {"convention": convention, "form": form})
    if form not in COMPANION and convention == "first_row":
        yield "convention", Reason("realization/convention_of_companions", {"form": form})
    if form == "diagonal" and convention in ("subdiagonal", "superdiagonal"):
        yield "convention", Reason("realization/no_chains", {"convention": convention})


@realization.method(source="Lecture note, section 1.10; Kailath, Linear Systems, section 2.1")
def by_inspection(given: Given[InputOutput, RealizationOptions]) -> Derivation[Answers]:
    """The coefficients of the fraction, or its poles and residues, placed into matrices."""
    form, discrete, first = (
        given.options.form,
        given.system.discrete,
        given.options.convention == "first_row",
    )
    if isinstance(given.system, systems.TransferFunction):
        G = yield from fractions_of(given.system)
    else:
        several = given.system.B.cols > 1 if form == "controllable" else given.system.C.rows > 1
        if several and form in COMPANION:
            moved = yield from companion_coordinates_of(given.system, form, first=first)
            if moved is not None:
                return Answers(A=moved.A, B=moved.B, C=moved.C, D=moved.D)
        G = yield from transfer_function_of(given.system)
    if G.common_denominator.degree() == 0:
        raise Unsolved("realization/constant")
    yield from direct_path_of(G)
    if form in COMPANION:
        found = yield from companion_form_of(G, form, first=first, discrete=discrete)
    else:
        found = yield from mode_form_of(
            G, form, superdiagonal=given.options.convention == "superdiagonal", discrete=discrete
        )
    return Answers(A=found.A, B=found.B, C=found.C, D=found.D)


@realization.verification("A", "B", "C", "D")
def has_the_form_and_the_transfer_function(
    given: Given[InputOutput, RealizationOptions], answers: Answers
) -> Iterable[Check]:
    """The form by inspection, det(xI − A) and C (xI − A)⁻¹ B + D at random points; alone, what each one must be."""
    yield from realization_checks(given, answers)


register(realization)


@realization.meaning("A", "B", "C")
def another_transfer_function(wrong: Attempt[InputOutput, RealizationOptions]) -> Reason | None:
    """What the matrices have for a transfer function, where all three are there."""
    system = wrong.given.system
    if not isinstance(system, systems.TransferFunction):
        return None
    return other_transfer(wrong.submitted, wrong.answers["D"], system.matrix, system.variable)


def with_form(system: System, options: RealizationOptions, *, form: str) -> tuple[System, RealizationOptions] | None:
    """The question about another form."""
    return None if options.form == form else (system, replace(options, form=form))


def with_convention(
    system: System, options: RealizationOptions, *, convention: str
) -> tuple[System, RealizationOptions] | None:
    """The question by another convention."""
    return None if options.convention == convention else (system, replace(options, convention=convention))


FOLLOWED = {
    "first_row": "coefficients in the first row (column)",
    "last_row": "coefficients in the last row (column)",
    "subdiagonal": "ones below the diagonal",
    "superdiagonal": "ones above the diagonal",
}
for each in ("observable", "controllable"):
    slip = Slip("other_form", Phrase("it is the {each} form", each=each))
    realization.mistaken_question(slip)(partial(with_form, form=each))
for each, what in FOLLOWED.items():
    slip = Slip("convention", Phrase("it follows the other convention: {what}", what=what))
    realization.mistaken_question(slip)(partial(with_convention, convention=each))
