"""Poles and zeros of a system with several inputs and outputs: by minors, by Smith and McMillan, by Rosenbrock."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Derivation, Given, Step, Task
from solver.lazy import exact, systems
from solver.tasks.multivariable import poles_zeros_checks, poles_zeros_mistakes
from solver.tasks.multivariable.minors import Found, lowest_of, poles_and_zeros_by_minors
from solver.tasks.multivariable.plants import transfer_matrix_of
from solver.tasks.multivariable.poles_zeros import poles_and_zeros_of
from solver.tasks.multivariable.rosenbrock import (
    hidden_zeros_of,
    invariant_zeros_of,
    system_zeros_of,
    zeros_of_system_matrix,
)
from solver.tasks.multivariable.smith_mcmillan import smith_mcmillan_of
from solver.tasks.plant_options import LoopOptions
from solver.tasks.representation.minimal_parts import kept_part_of, least_realization_of
from solver.tasks.representation.plants import matrices_of, variable_of

if TYPE_CHECKING:
    from solver.systems import StateSpace
    from solver.tasks.needed import InputOutput

transfer_matrix_poles_zeros: Task[InputOutput, LoopOptions] = Task(
    "transfer_matrix_poles_zeros",
    title="Poles and zeros of a transfer matrix",
    doc="Poles and transmission zeros of a system with several inputs and outputs, with their multiplicities.",
    needs=("transfer_function",),
    options=LoopOptions,
    answers=[
        AnswerName(
            "poles",
            "p_i",
            "the poles, each as often as its multiplicity",
            optional=True,
            principal=True,
            earned=("minors", "pole_polynomial", "diagonal"),
        ),
        AnswerName(
            "zeros",
            "z_i",
            "the transmission zeros, with multiplicity",
            optional=True,
            principal=True,
            earned=("minors", "zero_polynomial", "diagonal", "system_matrix", "determinant"),
        ),
        AnswerName(
            "pole_polynomial",
            r"\varphi_{P}",
            "the monic polynomial of the poles",
            earned=("pole_polynomial", "minors"),
        ),
        AnswerName(
            "zero_polynomial",
            r"\varphi_{Z}",
            "the monic polynomial of the transmission zeros",
            earned=("zero_polynomial",),
        ),
        AnswerName("normal_rank", "r", "the normal rank of $G$: its rank at almost every point", count=True),
        AnswerName("determinant", r"\det G", "the determinant of a square $G$, in lowest terms", optional=True),
        AnswerName(
            "invariant_zeros",
            r"z_{\text{inv}}",
            "the points where Rosenbrock's matrix falls in rank, with multiplicity",
            optional=True,
        ),
        AnswerName(
            "input_decoupling_zeros",
            r"z_{\text{in}}",
            "the modes that no input reaches (uncontrollable)",
            optional=True,
        ),
        AnswerName(
            "output_decoupling_zeros", r"z_{\text{out}}", "the modes that no output shows (unobservable)", optional=True
        ),
        AnswerName(
            "zero_directions",
            "U_{z}",
            "columns $u$ with $G(z)\\,u = 0$, in the order of the zeros",
            optional=True,
            free=True,
            vectors="columns",
        ),
    ],
    example={"transfer_matrix": "[[1/({x} + 1), 2/({x} + 2)], [1/({x} + 2), 1/({x} + 1)]]"},
)
poles_zeros_checks.register(transfer_matrix_poles_zeros)
poles_zeros_mistakes.register(transfer_matrix_poles_zeros)


@transfer_matrix_poles_zeros.method(
    "minors",
    title="Minors",
    source="Lecture note, section 6.2; MacFarlane and Karcanias, Int. J. Control 24 (1976)",
)
def by_minors(given: Given[InputOutput, LoopOptions]) -> Derivation[Answers]:
    """Poles by the least common denominator of all minors, zeros by those of normal rank over it."""
    G = yield from transfer_matrix_of(given.system)
    found = yield from poles_and_zeros_by_minors(G)
    return (yield from _all_answers(given, found, by_minors=True))


@transfer_matrix_poles_zeros.method(
    "smith_mcmillan", title="Smith–McMillan form", source="Kailath, Linear Systems, section 6.5"
)
def by_smith_mcmillan(given: Given[InputOutput, LoopOptions]) -> Derivation[Answers]:
    """The products of the denominators and of the numerators on the diagonal of the Smith–McMillan form."""
    G = yield from transfer_matrix_of(given.system)
    yield from lowest_of(G)
    form = yield from smith_mcmillan_of(G)
    found = Found(G, form.rank, form.pole_polynomial, form.zero_polynomial)
    yield Step(
        "diagonal",
        unclaimed="the products are displayed with their roots",
        x=G.variable,
        poles=exact.in_factors(found.poles),
        zeros=exact.in_factors(found.zeros),
    )
    return (yield from _all_answers(given, found))


@transfer_matrix_poles_zeros.method(
    "rosenbrock",
    title="Rosenbrock's system matrix",
    source="Rosenbrock, State-space and Multivariable Theory, chapter 2",
)
def by_rosenbrock(given: Given[InputOutput, LoopOptions]) -> Derivation[Answers]:
    """Where P(s) = [sI − A, −B; C, D] falls in rank; what is hidden is told apart."""
    plant = given.system
    if isinstance(plant, systems.TransferFunction):
        return (yield from _realized(given))
    x, (A, B, C, D) = variable_of(plant), matrices_of(plant)
    G = exact.transfer_matrix(A, B, C, D, x)
    whole = yield from zeros_of_system_matrix((A, B, C, D), x)
    poles = G.pole_polynomial
    minimal = poles.degree() == plant.order
    invariant = yield from invariant_zeros_of(whole, transmission=False)
    hidden = yield from hidden_zeros_of(plant, exact.in_factors(poles))
    least = whole
    if not minimal:
        A, B, C = yield from kept_part_of(A, B, C, "controllable", number="c")
        if A.rows:
            A, B, C = yield from kept_part_of(A, B, C, "observable", number="co")
        least = yield from zeros_of_system_matrix((A, B, C, D), x, minimal=True)
    found = Found(G, whole.rank - plant.order, poles, least.zero_polynomial)
    yield _told_apart(plant, found, minimal=minimal)
    answers = yield from poles_and_zeros_of(found, discrete=plant.discrete)
    extra = hidden if invariant is None else {**hidden, "invariant_zeros": invariant}
    return Answers(**answers, **extra)


def _realized(given: Given[InputOutput, LoopOptions]) -> Derivation[Answers]:
    """A transfer matrix is realized with least order first, so that nothing is hidden."""
    plant: Any = given.system
    G = yield from transfer_matrix_of(plant)
    least = yield from least_realization_of(G, discrete=plant.discrete)
    whole = yield from zeros_of_system_matrix((least.A, least.B, least.C, least.D), G.variable)
    found = Found(G, whole.rank - least.A.rows, G.pole_polynomial, whole.zero_polynomial)
    yield _told_apart(None, found, minimal=True)
    return (yield from poles_and_zeros_of(found, discrete=plant.discrete))


def _told_apart(plant: StateSpace | None, found: Found, *, minimal: bool) -> Step:
    """What the transmission zeros and the poles of a minimal realization are."""
    return Step(
        "minimal",
        unclaimed="a consequence of what was found before",
        minimal=minimal,
        realized=plant is None,
        n=None if plant is None else plant.order,
        degree=found.poles.degree(),
        rank=found.rank,
        x=found.G.variable,
    )


def _all_answers(
    given: Given[InputOutput, LoopOptions], found: Found, *, by_minors: bool = False
) -> Derivation[Answers]:
    """The poles and zeros of G, and for state equations what G does not show."""
    plant = given.system
    answers = yield from poles_and_zeros_of(found, discrete=plant.discrete, by_minors=by_minors)
    if isinstance(plant, systems.TransferFunction):
        return answers
    hidden = yield from system_zeros_of(
        plant, exact.in_factors(found.poles), found.poles.degree(), answers.get("zeros")
    )
    return Answers(**answers, **hidden)
