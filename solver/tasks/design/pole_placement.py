"""State feedback u = −K x that gives the closed loop the poles asked for."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Derivation,
    Given,
    Refusal,
    Task,
    Way,
    control_law,
    option,
)
from solver.lazy import numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.options.expression_list import ExpressionList
from solver.options.matrix import MatrixOf
from solver.tasks import consequences, meanings, mistakes
from solver.tasks.design.eigenvector_assignment import Question, assign_eigenvectors
from solver.tasks.design.frames import Placement, Wanted
from solver.tasks.design.gain_checks import Asked, judge_gain, judge_gain_polynomial
from solver.tasks.design.loop_figures import block_diagram, zero_input_response
from solver.tasks.design.mapped_poles import with_mapping_mistakes
from solver.tasks.design.placement import place
from solver.tasks.design.pole_options import PLACING, PoleOptions, asked_poles, numeric_poles, pole_faults, variable
from solver.tasks.design.wanted_eigenvectors import eigenvector_faults, judge_eigenvectors
from solver.tasks.freedom import loop_is_free, placed_gain_is_free
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.tasks.needed import WithInput

MATCHING = ("coefficient_matching",)


@dataclass(frozen=True, kw_only=True)
class PolePlacementOptions(PoleOptions):
    """The poles, and what is known of the gain."""

    structure: tuple[Expr, ...] | None = option(
        ExpressionList(),
        "shape of the row K: symbols to find and entries that are fixed, e.g. [alpha, 0, beta]",
        methods=MATCHING,
    )
    eigenvectors: ImmutableMatrix | None = option(
        MatrixOf("n"),
        "eigenvectors wanted of the closed loop (several inputs), as columns in the order of the poles; "
        "the nearest attainable ones are taken",
        way=Way("Assignment of eigenvectors", "B. C. Moore, IEEE Trans. Automatic Control 21 (1976)"),
    )


pole_placement: Task[WithInput, PolePlacementOptions] = Task(
    "pole_placement",
    title="Pole placement by state feedback",
    doc="The gain K of u = −K x for which A − BK has the poles asked for.",
    needs=("A", "B"),
    options=PolePlacementOptions,
    answers=[
        AnswerName(
            "K",
            r"\sym{K}",
            "the gain of the feedback (entries that may have any value stay letters)",
            free=placed_gain_is_free,
            principal=True,
            earned=PLACING,
        ),
        AnswerName("closed_loop_A", r"A - B\sym{K}", "the matrix of the closed loop", free=loop_is_free),
        AnswerName("polynomial", r"\hat{p}", "the characteristic polynomial of the closed loop"),
        AnswerName(
            "gain_polynomial",
            "p_k",
            "the characteristic polynomial with the unknown gains $k_{1}$, $k_{2}$, …",
            MATCHING,
            True,
            told=("gain_polynomial",),
        ),
        AnswerName(
            "fixed_poles",
            r"\lambda_{\text{fixed}}",
            "the eigenvalues that no such gain moves",
            (),
            True,
            told=("fixed_factor", "decomposition"),
        ),
        AnswerName(
            "conditions", r"\text{conditions}", "what the letters of the prescribed gain must satisfy", MATCHING, True
        ),
        AnswerName(
            "eigenvectors",
            "V",
            "the eigenvectors of the closed loop, as columns in the order of the poles",
            optional=True,
            free=True,
            vectors="columns",
        ),
    ],
    example={"poles": '["-3 ± 2j"]'},
)
pole_placement.together(control_law(("-K", "x")))


def shape_of(given: Given[WithInput, PolePlacementOptions]) -> tuple[ImmutableMatrix | None, list[Symbol]]:
    """Return the row K of the option `structure` (None without it) and the symbols in it that are to be found."""
    if not given.options.structure:
        return None, []
    row = sp.ImmutableMatrix([list(given.options.structure)])
    return row, sorted(row.free_symbols - set(given.system.parameters), key=str)


@pole_placement.refusal
def options_fit_the_plant(system: Any, options: PolePlacementOptions) -> Iterable[Refusal]:
    """Poles are given, as many as the plant has states (or movable ones); the structure is a row of n entries."""
    faults = [*pole_faults(system, options)]
    yield from faults or eigenvector_faults(system, options, options.eigenvectors)
    structure = options.structure
    if not structure or not isinstance(system, systems.StateSpace) or system.B is None:
        return
    n = system.order
    if system.B.cols > 1:
        yield "structure", Reason("placement/structure_for_one_input")
    elif len(structure) != n:
        yield "structure", Reason("placement/size_of_the_structure", {"n": n, "given": len(structure)})
    else:
        unknowns = sorted(set().union(*(entry.free_symbols for entry in structure)) - set(system.parameters), key=str)
        if not unknowns:
            yield "structure", Reason("placement/nothing_to_find")
        elif any(sp.diff(entry, a, b) != 0 for entry in structure for a in unknowns for b in unknowns):
            yield "structure", Reason("placement/structure_not_linear")


def _placed(given: Given[WithInput, PolePlacementOptions], method: str) -> Derivation[Answers]:
    """Find K by one of the methods, and show what the loop does."""
    plant, x = given.system, variable(given.system)
    yield from block_diagram("state_feedback", r"State feedback $u = -\sym{K} x$", discrete=plant.discrete)
    if given.options.eigenvectors is not None:
        return (yield from _with_eigenvectors(given, given.options.eigenvectors))
    poles = yield from asked_poles(given)
    row, unknowns = shape_of(given)
    found = yield from place(plant.A, plant.B, poles, method, x=x, wanted=Wanted(row, unknowns))
    if not found.free:
        yield from zero_input_response(found.loop, plant, found.K)
    return _answers(found, structured=row is not None)


def _with_eigenvectors(given: Given[WithInput, PolePlacementOptions], wanted: ImmutableMatrix) -> Derivation[Answers]:
    """The gain that the eigenvectors decide, whatever the method."""
    plant = given.system
    poles = yield from asked_poles(given)
    question = Question(plant, poles, wanted)
    found, V = yield from assign_eigenvectors(question, variable(plant))
    yield from zero_input_response(found.loop, plant, found.K)
    answers = _answers(found, structured=False)
    answers["eigenvectors"] = V
    return answers


def _answers(found: Placement, *, structured: bool) -> Answers:
    answers = Answers(K=found.K, closed_loop_A=found.loop, polynomial=found.polynomial)
    if found.gain_polynomial is not None:
        answers["gain_polynomial"] = found.gain_polynomial
    if found.fixed:
        answers["fixed_poles"] = list(found.fixed)
    if structured:
        answers["conditions"] = list(found.conditions)
    return answers


@pole_placement.method("coefficient_matching", title="Comparison of coefficients", source="Lecture note, section 3.5")
def by_coefficient_matching(given: Given[WithInput, PolePlacementOptions]) -> Derivation[Answers]:
    """det(sI − A + BK) with unknown entries of K is compared with the desired polynomial, power by power."""
    return (yield from _placed(given, "coefficient_matching"))


@pole_placement.method("bass_gura", title="Formula of Bass and Gura", source="Lecture note, equation (3.1.3)")
def by_bass_gura(given: Given[WithInput, PolePlacementOptions]) -> Derivation[Answers]:
    """K = (â − a)ᵀ (𝒞 W)⁻¹, W triangular with the coefficients of the open-loop polynomial."""
    return (yield from _placed(given, "bass_gura"))


@pole_placement.method("canonical_form", title="Canonical form", source="Lecture note, equation (3.1.4)")
def by_canonical_form(given: Given[WithInput, PolePlacementOptions]) -> Derivation[Answers]:
    """In controllable canonical form the gain is â − a; it is brought back to the original coordinates."""
    return (yield from _placed(given, "canonical_form"))


@pole_placement.method("ackermann", title="Ackermann's formula", source="Lecture note, equation (3.1.5)")
def by_ackermann(given: Given[WithInput, PolePlacementOptions]) -> Derivation[Answers]:
    """K = (0, …, 0, 1) 𝒞⁻¹ p̂(A)."""
    return (yield from _placed(given, "ackermann"))


@pole_placement.method("unity_rank", title="Gain of unity rank", source="Kailath, Linear Systems, section 7.1")
def by_unity_rank(given: Given[WithInput, PolePlacementOptions]) -> Derivation[Answers]:
    """K = g k: the inputs act together as one, b = Bg, and k is found for (A, b)."""
    return (yield from _placed(given, "unity_rank"))


@pole_placement.verification(
    "K", "closed_loop_A", "polynomial", "gain_polynomial", "fixed_poles", "conditions", "eigenvectors"
)
def has_the_poles(given: Given[WithInput, PolePlacementOptions], answers: Answers) -> Iterable[Check]:
    """The spectrum of A − BK is the one asked for; modes that no gain moves are found by two random gains."""
    row, unknowns = shape_of(given)
    asked = Asked(given.system.A, given.system.B, numeric_poles(given), variable(given.system), row, unknowns)
    yield from judge_gain(asked, answers)
    if given.options.eigenvectors is not None:
        yield from judge_eigenvectors(asked, given.options.eigenvectors, answers)
    if "gain_polynomial" in answers:
        yield judge_gain_polynomial(asked, answers["gain_polynomial"])
    if "fixed_poles" in answers:
        yield numeric.check_residual(
            "the fixed poles are those that two random gains leave in place",
            "mpmath.eig",
            lambda: judges.fixed_modes_residual(asked.A, asked.B, answers["fixed_poles"], row, unknowns),
            answer="fixed_poles",
        )
    if "conditions" in answers and row is not None:
        equations = [each.lhs - each.rhs if isinstance(each, sp.Equality) else each for each in answers["conditions"]]
        yield numeric.check_residual(
            "the gains that meet the conditions are those that place the poles",
            "numpy.linalg.det",
            lambda: judges.shape_residual(asked.A, asked.B, row, unknowns, equations, asked.poles),
            answer="conditions",
        )


pole_placement.consequence("closed_loop_A", of=("K",))(consequences.closed_loop)
pole_placement.consequence("polynomial", of=("closed_loop_A",))(consequences.polynomial_of("closed_loop_A"))


pole_placement.mistaken_question(mistakes.EXCHANGED)(mistakes.inputs_for_outputs)


pole_placement.mistake(mistakes.ADDED, "closed_loop_A")(mistakes.plus_for_minus)
pole_placement.mistake(mistakes.GAIN_ADDED, "K")(mistakes.negative)


@pole_placement.mistake(mistakes.NOT_ATTAINABLE, "eigenvectors")
def taken_as_asked(wrong: Attempt[WithInput, PolePlacementOptions]) -> Iterable[Any]:
    """The wanted eigenvectors themselves."""
    if wrong.given.options.eigenvectors is not None:
        yield wrong.given.options.eigenvectors


with_mapping_mistakes(pole_placement)


@pole_placement.meaning("K", "closed_loop_A", "polynomial")
def poles_of_the_loop(wrong: Attempt[WithInput, PolePlacementOptions]) -> Reason | None:
    """The poles that the gain, the loop or the polynomial has."""
    plant, asked = wrong.given.system, numeric_poles(wrong.given)
    if wrong.name == "polynomial":
        return meanings.roots_given(wrong.value, variable(plant), asked)
    loop = wrong.value if wrong.name == "closed_loop_A" else plant.A - plant.B * wrong.value
    return meanings.poles_given(loop, asked)


pole_placement.meaning("fixed_poles")(meanings.hidden)
