"""A realization of least order: the part that is controllable and observable."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from solver.derivation import AnswerName, Answers, Check, Claim, Derivation, Given, Step, Task, state_equations
from solver.lazy import exact, numeric, systems
from solver.numeric.judges import representation as judges
from solver.stated.algebra import product
from solver.tasks.plant_options import LoopOptions
from solver.tasks.representation.completing import register
from solver.tasks.representation.lowest_terms import fractions_of, lowest_terms_of
from solver.tasks.representation.minimal_parts import kept_part_of, least_realization_of
from solver.tasks.representation.plants import matrices_of, numbers_of, stated_matrix, variable_of
from solver.tasks.representation.realization_checks import at_infinity, same_transfer, shape_of
from solver.tasks.representation.realization_lemmas import assembled, companion_form_of, direct_path_of
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.systems import StateSpace, TransferFunction
    from solver.tasks.needed import InputOutput

minimal_realization: Task[InputOutput, LoopOptions] = Task(
    "minimal_realization",
    title="Minimal realization",
    doc="State equations of least order with the same transfer function, and the modes that are left out.",
    needs=("transfer_function",),
    options=LoopOptions,
    answers=[
        AnswerName(
            "A",
            "A",
            "system matrix of the minimal realization",
            free=True,
            principal=True,
            earned=("complete", "reduction", "parts", "coefficients", "residue"),
        ),
        AnswerName("B", "B", "input matrix of the realization", free=True, principal=True),
        AnswerName("C", "C", "output matrix of the realization", free=True, principal=True),
        AnswerName("D", "D", "$D$, as before", principal=True),
        AnswerName(
            "cancelled", r"\text{cancelled}", "the modes that the transfer function does not show", optional=True
        ),
    ],
)
minimal_realization.together(state_equations())


@minimal_realization.method(source="Lecture note, section 2.4; Kailath, Linear Systems, section 2.4")
def by_reduction(given: Given[InputOutput, LoopOptions]) -> Derivation[Answers]:
    """Keep the controllable part, and of this the observable part."""
    plant = given.system
    if not isinstance(plant, systems.TransferFunction):
        return (yield from _reduced(plant))
    G = yield from fractions_of(plant)
    if G.shape == (1, 1):
        return (yield from _from_lowest_terms(plant, G))
    found = yield from least_realization_of(G, discrete=plant.discrete)
    return Answers(A=found.A, B=found.B, C=found.C, D=found.D)  # what cancels depends on where one starts from


def _from_lowest_terms(plant: TransferFunction, G: exact.TransferMatrix) -> Derivation[Answers]:
    """One input, one output: cancel, then write the companion form of what is left."""
    found = yield from lowest_terms_of(G)
    reduced = G.reduced
    yield from direct_path_of(reduced)
    form = exact.controllable_realization(reduced)
    if form.A.rows:
        form = yield from companion_form_of(reduced, "controllable", first=False, discrete=plant.discrete)
    answers = Answers(A=form.A, B=form.B, C=form.C, D=form.D)
    return Answers(**answers, **{name: found[name] for name in ("cancelled",) if name in found})


def _reduced(plant: StateSpace) -> Derivation[Answers]:
    """The controllable part of the plant, then the observable part of that."""
    A, B, C, D = matrices_of(plant)
    A, B, C = yield from kept_part_of(A, B, C, "controllable")
    if A.rows:
        A, B, C = yield from kept_part_of(A, B, C, "observable")
    G = exact.transfer_matrix(*matrices_of(plant), variable_of(plant))
    cancelled = G.cancelled
    yield Step(
        "modes_left_out",
        claims={
            "polynomial": Claim(
                G.chi, product(G.poles_factored, G.cancelled_factored), "poles and modes left out make up $\\chi$"
            )
        },
        x=G.variable,
        cancelled=cancelled,
        factor=G.cancelled_factored,
        n=plant.order,
        least=A.rows,
        plant=plant.A,
        kept=A,
    )
    if A.rows:
        yield from assembled(G, exact.Realization(A, B, C, D), cancelled=True, x=G.variable, discrete=plant.discrete)
    found = Answers(A=A, B=B, C=C, D=D)
    return found if cancelled is None else Answers(**found, cancelled=cancelled)


@minimal_realization.verification("A", "B", "C", "D")
def has_least_order_and_the_transfer_function(
    given: Given[InputOutput, LoopOptions], answers: Answers
) -> Iterable[Check]:
    """The order is the McMillan degree, det(sI − A) that of the minimal part, and G is the same."""
    plant, (outputs, inputs) = numbers_of(given.system), shape_of(given.system)
    n = judges.order_of_minimal_part(plant)
    wanted = {"A": (n, n), "B": (n, inputs), "C": (outputs, n), "D": (outputs, inputs)}
    fits = {name: answers[name].shape == shape for name, shape in wanted.items() if name in answers}
    for name, fit in fits.items():
        rows, columns = wanted[name]
        label = Phrase("${name}$ is {rows}×{columns}, of the least order", name=name, rows=rows, columns=columns)
        yield Check.that(label, "orthogonal bases (50 digits)", fit, answer=name)
    if not all(fits.values()):
        return
    if "D" in answers:
        yield numeric.check_claim(Claim(answers["D"], at_infinity(given.system)), r"$D = G(\infty)$", answer="D")
    if "A" in answers and n:
        says, A = "the eigenvalues of $A$ are the poles", answers["A"]
        yield numeric.check_residual(
            says, "orthogonal bases (50 digits)", lambda: judges.characteristic_residual(plant, A), answer="A"
        )
    if {"A", "B", "C"} <= answers.keys():
        yield _same_constant(given, answers) if n == 0 else same_transfer(given, answers)
        return
    for name in ("B", "C"):
        if name in answers and n:
            reason = Phrase("the coordinates are free, so {name} is judged with A, B and C together", name=name)
            yield Check.skipped(
                Phrase("${name}$ belongs to a minimal realization", name=name), "inspection", reason, answer=name
            )


def _same_constant(given: Given[InputOutput, LoopOptions], answers: Answers) -> Check:
    """Without states the transfer function is D."""
    D = answers.get("D", at_infinity(given.system))
    return numeric.check_claim(Claim(D, stated_matrix(given.system)), "$D = G$ at random points")


@minimal_realization.verification("cancelled")
def complete_the_characteristic_polynomial(given: Given[InputOutput, LoopOptions], answers: Answers) -> Iterable[Check]:
    """det(sI − A) is det(sI − A_min) times the factors of the cancelled modes."""
    plant, listed = numbers_of(given.system), list(answers["cancelled"])
    yield numeric.check_residual(
        r"poles and cancelled modes make up $\det(sI - A)$",
        "orthogonal bases (50 digits)",
        lambda: judges.cancelled_residual(plant, listed),
    )


register(minimal_realization)
