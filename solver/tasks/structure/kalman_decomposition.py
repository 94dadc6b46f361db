"""Kalman's decomposition into what is controllable, observable, both or neither."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import accumulate
from typing import TYPE_CHECKING, Any

from solver.arithmetic.row_operations import row_operations
from solver.derivation import (
    AnswerName,
    Answers,
    Check,
    CheckStatus,
    Claim,
    Derivation,
    Given,
    Refusal,
    Step,
    Task,
    option,
    state_equations,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import structure as judges
from solver.options.choice import Choice
from solver.stated import Stated
from solver.stated.algebra import product
from solver.stated.matrices import inverse, partitioned, transpose
from solver.tasks.plant_options import PlantOptions
from solver.tasks.structure import decomposition_formulas as formulas
from solver.tasks.structure.pairs import controllability_pair, observability_pair
from solver.tasks.structure.parts import parts_of
from solver.tasks.structure.rank_exceptions import rank_exceptions
from solver.tasks.structure.subspaces import subspaces_of
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.systems import StateSpace, System

PARTS = ("controllable", "observable", "full")
TITLES = {"controllable": "Decomposition by controllability", "observable": "Decomposition by observability"}
SUFFIXES = {"controllable": "c", "observable": "o", "full": "co"}


@dataclass(frozen=True, kw_only=True)
class KalmanDecompositionOptions(PlantOptions):
    """Which part is separated."""

    part: str = option(Choice(PARTS), "what is separated from the rest; full: all four parts", titles=TITLES)


kalman_decomposition: Task[StateSpace, KalmanDecompositionOptions] = Task(
    "kalman_decomposition",
    title="Kalman decomposition",
    doc="Coordinates x = T ξ that separate what is controllable, observable, or both from the rest.",
    needs=("A",),
    options=KalmanDecompositionOptions,
    answers=[
        AnswerName(
            "T",
            "T",
            r"the transformation $x = T\xi$; its columns are bases of the subspaces, part by part",
            free=True,
            vectors="columns",
            principal=True,
            earned=("matrix", "reachable", "seen", "intersection", "bases"),
        ),
        AnswerName("A", r"\bar{A}", "$T^{-1}AT$", free=True, principal=True, earned=("transformed",)),
        AnswerName("B", r"\bar{B}", "$T^{-1}B$", optional=True, free=True, principal=True),
        AnswerName("C", r"\bar{C}", "$CT$", optional=True, free=True, principal=True),
        AnswerName(
            "orders", r"\text{orders}", "the orders of the parts, as in $T$", ordered=True, numbered=True, count=True
        ),
        AnswerName("hidden_modes", r"\lambda_{\text{hidden}}", "the eigenvalues of all parts but the first"),
        *(
            AnswerName(
                f"{name}_{suffix}",
                rf"{name}_{{{suffix}}}" if len(suffix) > 1 else f"{name}_{suffix}",
                Phrase("${name}$ of the {words} part", name=name, words=words),
                optional=True,
                free=True,
            )
            for suffix, words in (("c", "controllable"), ("o", "observable"), ("co", "controllable and observable"))
            for name in "ABC"
        ),
    ],
    example={"A": "[[-1, 2], [0, -3]]", "B": "[1, 0]", "C": "[1, 1]"},
)
kalman_decomposition.together(state_equations(r"\xi", "ABC"))


@kalman_decomposition.refusal
def needs_input_or_output(system: System, options: KalmanDecompositionOptions) -> Iterable[Refusal]:
    """What is controllable depends on B, what is observable on C."""
    part = options.part
    if part != "observable" and getattr(system, "B", True) is None:
        yield "part", Reason("structure/needs_input")
    if part != "controllable" and getattr(system, "C", True) is None:
        yield "part", Reason("structure/needs_output")


@kalman_decomposition.method(source="Lecture note, section 2.4")
def by_subspaces(given: Given[StateSpace, KalmanDecompositionOptions]) -> Derivation[Answers]:
    """T from bases of the reachable and of the unseen subspace, completed; then T⁻¹AT, T⁻¹B and CT."""
    plant, part = given.system, given.options.part
    found = _decomposed(plant, part)
    yield from subspaces_of(plant, part)
    if found.trivial:
        yield Step("whole", unclaimed="nothing is computed: it follows from the rank", part=part, found=found)
    else:
        if part == "full":
            yield _intersection(plant, found)
        yield _bases(plant, found, part)
        yield from parts_of(plant, found, part)
    blocks = {"A": found.block(0, 0), "B": found.input_block(0), "C": found.output_block(0)}
    answers: dict[str, Any] = {"T": found.T, "A": found.A, "B": found.B, "C": found.C}
    answers |= {"orders": [sp.Integer(order) for order in found.orders], "hidden_modes": found.hidden_modes}
    answers |= {f"{name}_{SUFFIXES[part]}": block for name, block in blocks.items()}
    return Answers(**{name: value for name, value in answers.items() if value is not None})


def _decomposed(plant: Any, part: str) -> exact.Decomposition:
    if part == "controllable":
        return exact.controllable_decomposition(plant.A, plant.B, plant.C)
    if part == "observable":
        return exact.observable_decomposition(plant.A, plant.B, plant.C)
    return exact.kalman_decomposition(plant.A, plant.B, plant.C)


def _intersection(plant: Any, found: exact.Decomposition) -> Step:
    """What the output shows of the reachable subspace, and what it does not: R ∩ N."""
    observability, V, N, both = observability_pair(plant).matrix, found.reached, found.unseen, found.bases[1]
    claims = {}
    if V is not None and V.cols:
        claims["shown"] = Claim(
            product(observability, V), exact.multiply(observability, V), r"$\sym{observability_matrix} V$"
        )
    if N is not None and N.cols:
        claims["unseen"] = _vanishing(observability, N, r"the basis of $\mathcal{N}$ is unseen")
    if both.cols:
        claims["both"] = _vanishing(observability, both, r"the basis of $\mathcal{R} \cap \mathcal{N}$ is unseen")
    return Step(
        "intersection",
        claims=claims,
        unclaimed="nothing is reachable or unseen",
        V=V,
        N=N,
        both=both,
        exceptions=_exceptions_of_the_intersection(plant),
    )


def _exceptions_of_the_intersection(plant: Any) -> list[Any]:
    """Conditions under which 𝒪 𝒞 has a lower rank though 𝒪 and 𝒞 have not."""
    seen, reached = observability_pair(plant).matrix, controllability_pair(plant).matrix
    of_each = [*(rank_exceptions(seen) or []), *(rank_exceptions(reached) or [])]
    return [each for each in rank_exceptions(exact.multiply(seen, reached)) or [] if each not in of_each]


def _bases(plant: Any, found: exact.Decomposition, part: str) -> Step:
    """The columns of T, part by part, with what puts them there; the inverse of T."""
    first, second, *others = found.bases
    claims: dict[str, Claim] = {}
    if part == "controllable" and first.cols:
        claims["complement"] = _vanishing(transpose(first), second, "the complement is orthogonal")
    if part == "observable":
        claims["unseen"] = _vanishing(observability_pair(plant).matrix, second, "the second basis is unseen")
    if part == "full" and others[0].cols < plant.order and others[0].cols:
        rest = sp.ImmutableMatrix(sp.Matrix.hstack(first, second, others[1]))
        claims["complement"] = _vanishing(transpose(rest), others[0], "the complement is orthogonal")
    claims["inverse"] = Claim(inverse(found.T), found.T_inverse, "$T^{-1}$")
    T = partitioned(found.T, (), tuple(accumulate(found.orders)))
    beside = sp.ImmutableMatrix(sp.Matrix.hstack(found.T, sp.eye(plant.order)))
    lines = row_operations(beside, exact.row_reduction(beside))
    return Step("bases", claims=claims, steps=lines, part=part, found=found, T=T)


def _vanishing(left: Any, right: ImmutableMatrix, says: str) -> Claim:
    """The product is zero."""
    rows = left.operands[0].cols if isinstance(left, Stated) else left.rows
    return Claim(product(left, right), sp.ImmutableMatrix(sp.zeros(rows, right.cols)), says)


@kalman_decomposition.verification(*kalman_decomposition.answers)
def separates_what_is_hidden(given: Given[StateSpace, KalmanDecompositionOptions], answers: Answers) -> Iterable[Check]:
    """Any T is right that separates the subspaces; the other answers are right if it, or some such T, leads to them."""
    part, plant = given.options.part, _matrices(given)
    T = answers.get("T")
    if T is not None:
        regular = _check("$T$ is invertible", "T", lambda: 0.0 if numeric.independent(T) else float("inf"))
        yield regular
        says = "the columns of $T$ separate the subspaces"
        check = _check(says, "T", lambda: judges.separation_residual(part, T, *plant))
        T = T if check.status is CheckStatus.PASSED else None
        if regular.status is CheckStatus.PASSED:
            yield check
    yield from _new_matrices(given, answers, T)
    yield from _first_part(given, answers, T)
    if "orders" in answers:
        right = judges.kalman_orders(part, *plant)
        yield Check.that("dimensions by ranks", "numpy.linalg.svd", list(answers["orders"]) == right, answer="orders")
    if "hidden_modes" in answers:
        modes = answers["hidden_modes"]
        yield numeric.check_residual(
            r"$\det(xI - \bar{A}) = \prod_i (x - \lambda_i)$ for the hidden parts",
            "numpy.linalg.det",
            lambda: judges.hidden_polynomial_residual(part, plant, modes),
            1e-7,
            answer="hidden_modes",
        )


def _matrices(given: Given[StateSpace, KalmanDecompositionOptions]) -> tuple[Any, Any, Any]:
    return given.system.A, given.system.B, given.system.C


def _check(says: str, answer: str, residual: Callable[[], float]) -> Check:
    return numeric.check_residual(says, "numpy.linalg.svd", residual, answer=answer)


def _new_matrices(
    given: Given[StateSpace, KalmanDecompositionOptions], answers: Answers, T: ImmutableMatrix | None
) -> Iterator[Check]:
    """T A = A₀ T, T B = B₀, C = C₀ T; without T that there is one, shared by all that are right."""
    part, (A, B, C) = given.options.part, _matrices(given)
    found = {name: answers[name] for name in "ABC" if name in answers}
    if T is None:
        yield from _one_by_one(
            found,
            {name: name for name in found},
            lambda name: Phrase(r"some $T$ leads to $\bar{{{name}}}$", name=name),
            lambda those: judges.coordinates_residual(part, (A, B, C), those),
        )
        return
    for name, M in found.items():
        sides = {"A": (product(T, M), product(A, T)), "B": (product(T, M), B), "C": (product(C, T), M)}
        yield numeric.check_claim(
            Claim(*sides[name]), Phrase(r"$\bar{{{name}}}$ belongs to $T$", name=name), answer=name
        )


def _first_part(
    given: Given[StateSpace, KalmanDecompositionOptions], answers: Answers, T: ImmutableMatrix | None
) -> Iterator[Check]:
    """The first blocks of T⁻¹A₀T, T⁻¹B₀, C₀T; without T that they are those in some coordinates."""
    part, plant = given.options.part, _matrices(given)
    suffix = SUFFIXES[part]
    names = {name: f"{name}_{suffix}" for name in "ABC" if f"{name}_{suffix}" in answers}
    found = {name: answers[whole] for name, whole in names.items()}
    k = judges.kalman_orders(part, *plant)[0] if found else 0
    if T is None or k == 0:
        yield from _one_by_one(
            found,
            names,
            lambda name: Phrase("${name}_{{{part}}}$ is of that part, in some coordinates", name=name, part=suffix),
            lambda those: judges.visible_part_residual(part, plant, those),
        )
        return
    A, B, C = plant
    E = sp.ImmutableMatrix(sp.eye(A.rows)[:k, :])
    sides = {"A": (E, inverse(T), A, T, E.T), "B": (E, inverse(T), B), "C": (C, T, E.T)}
    for name, M in found.items():
        says = Phrase("${name}_{{{part}}}$ is the first block", name=name, part=suffix)
        yield numeric.check_claim(Claim(product(*sides[name]), M), says, answer=names[name])


def _one_by_one(
    found: Mapping[str, Any],
    names: Mapping[str, str],
    says: Callable[[str], str],
    residual: Callable[[Mapping[str, Any]], float],
) -> Iterator[Check]:
    """Each matrix together with those found right before it, so that one wrong matrix spoils no other.

    A block of B or C may be wrong by itself, but hardly right: without that of A it is in some coordinates.
    """
    right: dict[str, Any] = {}
    for name, M in found.items():
        together = {**right, name: M}
        check = _check(says(name), names[name], partial(residual, together))
        right = together if check.status is CheckStatus.PASSED else right
        if check.status is CheckStatus.PASSED and "A" not in found and names[name] != name:
            beside = names[name].replace(name, "A")
            reason = Phrase("the coordinates are free: it is judged together with {other}", other=beside)
            check = Check.skipped(check.claim, check.oracle, reason, answer=names[name])
        yield check


for letter in "ABC":
    kalman_decomposition.consequence(letter, of=("T",))(partial(formulas.in_coordinates, letter))
    for suffix in SUFFIXES.values():
        kalman_decomposition.consequence(f"{letter}_{suffix}", of=("T", "orders"))(
            partial(formulas.first_block, letter)
        )
