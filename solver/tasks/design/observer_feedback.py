"""State feedback of the estimate of an observer of full or reduced order."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Derivation,
    Given,
    Refusal,
    Step,
    Task,
    Unsolved,
    option,
)
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.options.flag import Flag
from solver.options.matrix import MatrixOf
from solver.options.poles import Poles
from solver.tasks import consequences, meanings, mistakes
from solver.tasks.design import observer_feedback_checks as checks
from solver.tasks.design.full_order import observer_gain_of, observer_pole_faults
from solver.tasks.design.mapped_poles import (
    SampledPoles,
    listed,
    mapped_poles,
    mapping_faults,
    numeric_poles_in_z,
    poles_in_z,
    with_mapping_mistakes,
)
from solver.tasks.design.output_feedback import (
    Design,
    compensator_of,
    feedback_of,
    full_compensator,
    full_loop_of,
    given_observer_of,
    reduced_compensator,
    reduced_loop_of,
    separation_of,
)
from solver.tasks.design.plants import Plant, measuring
from solver.tasks.design.reduced_order import (
    error_equation_of,
    measurement_fault,
    observer_matrices_of,
    partition_of,
    pole_faults,
    reduced_gain_of,
)
from solver.tasks.freedom import one_of_the_gains_is_free
from solver.tasks.sample_times import sample_time_of
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import System
    from solver.tasks.needed import WithBoth


@dataclass(frozen=True, kw_only=True)
class ObserverFeedbackOptions(SampledPoles):
    """The gains, given or by their poles."""

    poles: tuple[Expr, ...] | None = option(Poles(), "the poles of A − BK, where K is to be found")
    gain: ImmutableMatrix | None = option(
        MatrixOf("m", "n", flat="row"), "the state feedback K, where it is given", answer="K"
    )
    observer_poles: tuple[Expr, ...] | None = option(Poles(), "the poles of the observer, where L is to be found")
    observer_s_poles: tuple[Expr, ...] | None = option(
        Poles(), "of a discrete plant, in place of observer_poles: the poles in s", answer="poles"
    )
    observer_gain: ImmutableMatrix | None = option(
        MatrixOf(None, "p", flat="column"), "the observer gain L, where it is given", answer="L"
    )
    reduced: bool = option(Flag(), "an observer of reduced order, for the states that are not measured")


observer_feedback: Task[WithBoth, ObserverFeedbackOptions] = Task(
    "observer_feedback",
    title="Feedback of estimated states",
    doc="u = −K x̂ with the estimate of an observer: closed loop, separation principle, compensator from y to u.",
    needs=("A", "B", "C"),
    options=ObserverFeedbackOptions,
    answers=[
        AnswerName(
            "closed_loop_A",
            r"A_{\text{closed}}",
            r"the closed loop, in $(x, x - \hat{x})$; reduced: in $(\eta_{1}, \eta_{2}, \eta_{2} - \hat{\eta}_{2})$",
            free=one_of_the_gains_is_free,
            principal=True,
            earned=("separation",),
        ),
        AnswerName(
            "eigenvalues",
            r"\lambda_i",
            "the eigenvalues of the closed loop",
            optional=True,
            numbered=True,
            earned=("separation",),
        ),
        AnswerName(
            "compensator",
            "G_c",
            "the compensator: the transfer function from $y$ to $u$",
            free=one_of_the_gains_is_free,
            principal=True,
            earned=("compensator_equations",),
        ),
        AnswerName(
            "S1",
            "S_1",
            r"the first columns of $T = [S_{1}\; S_{2}]$, those of what is measured",
            optional=True,
            free=True,
        ),
        AnswerName("S2", "S_2", "the other columns of $T$", optional=True, free=True),
    ],
    example={"poles": '["-3 ± 2j"]', "observer_poles": "[-6, -7]"},
)


@observer_feedback.refusal
def what_the_file_shows(system: System, options: ObserverFeedbackOptions) -> Iterator[Refusal]:
    """Both or neither of poles and gain, for the feedback and for the observer; wrong numbers or shapes."""
    for poles, in_s, gain in (("poles", "s_poles", "gain"), ("observer_poles", "observer_s_poles", "observer_gain")):
        placed = options.has(poles) or options.has(in_s)
        if placed and options.has(gain):
            yield gain, Reason("observers/poles_and_gain", {"poles": poles, "gain": gain})
        elif not placed and not options.has(gain):
            yield "", Reason("observers/poles_or_gain", {"poles": poles, "gain": gain})
    if options.has("observer_s_poles"):
        if not system.discrete:
            yield "observer_s_poles", Reason("mapped_poles/continuous")
        elif options.has("observer_poles"):
            yield "observer_s_poles", Reason("mapped_poles/both")
    unmapped = [*mapping_faults(system, options, others=options.has("observer_s_poles"))]
    yield from unmapped
    if unmapped:
        return
    if isinstance(system, systems.StateSpace) and system.B is not None and system.C is not None:
        yield from _faults_of_numbers(system, options)


def _faults_of_numbers(system: Any, options: ObserverFeedbackOptions) -> Iterator[Refusal]:
    plant, n = measuring(system), system.order
    L = options.observer_gain
    name, own = listed(options)
    in_s = options.observer_poles is None
    where, poles = (
        ("observer_s_poles", options.observer_s_poles) if in_s else ("observer_poles", options.observer_poles)
    )
    if own is not None:
        reached = exact.reachable_order(plant.A, plant.B)
        if len(own) not in (n, reached):
            numbers = {"given": len(own), "n": n, "reached": reached}
            yield name, Reason("observers/poles_of_the_feedback", numbers)
    reduced = options.reduced
    rows = n - plant.p if reduced else n
    if L is not None and L.shape != (rows, plant.p):
        yield "observer_gain", Reason("observers/size_of_the_gain", {"wanted": (rows, plant.p), "given": L.shape})
    if not reduced:
        if poles is not None:
            yield from observer_pole_faults(system, poles, where)
        return
    wrong = measurement_fault(plant)
    if wrong is not None:
        yield "reduced", wrong
    elif poles is not None:
        yield from pole_faults(plant, poles, where)


@observer_feedback.method(source="Lecture note, sections 4.4 and 4.5")
def by_separation(given: Given[WithBoth, ObserverFeedbackOptions]) -> Derivation[Answers]:
    """K for A − BK and L for A − LC are found apart; the poles of the whole are those of both."""
    plant = measuring(given.system)
    for _, fault in what_the_file_shows(given.system, given.options):
        raise Unsolved("engine/refused", message=fault)
    yield Step("plan", unclaimed="what is going to be done", reduced=given.options.reduced)
    own = yield from poles_in_z(given)
    control = yield from feedback_of(plant, own, given.options.gain)
    if given.options.reduced:
        return (yield from _with_reduced_observer(given, plant, control))
    if given.options.observer_gain is None:
        poles = yield from _observer_poles(given)
        placed = yield from observer_gain_of(given.system, poles)
        listed = [*poles, *(placed.fixed if len(poles) < plant.n else ())]
        observer = Design(placed.K, placed.polynomial, listed)
    else:
        observer = yield from given_observer_of(
            plant.A, plant.C, given.options.observer_gain, plant.variable, reduced=False
        )
    whole = yield from full_loop_of(plant, control, observer)
    yield from separation_of(whole, plant, control, observer)
    found, claims = full_compensator(plant, control.gain, observer.gain)
    G = yield from compensator_of(plant, found, claims, reduced=False)
    return _answers(whole, control, observer, G)


def _observer_poles(given: Given[WithBoth, ObserverFeedbackOptions]) -> Derivation[list[Expr]]:
    """The poles of the observer, those in s mapped to z by a step."""
    if given.options.observer_s_poles is None:
        return list(given.options.observer_poles or ())
    return (yield from mapped_poles(given.options.observer_s_poles, sample_time_of(given)))


def _with_reduced_observer(
    given: Given[WithBoth, ObserverFeedbackOptions], plant: Plant, control: Design
) -> Derivation[Answers]:
    """The same with the measured states in place of their estimates."""
    parts = yield from partition_of(plant)
    yield from error_equation_of(discrete=plant.discrete)
    blocks = parts.blocks
    if given.options.observer_gain is None:
        poles = yield from _observer_poles(given)
        design = yield from reduced_gain_of(parts, poles, discrete=plant.discrete)
        fixed = design.fixed if len(poles) < blocks["A22"].rows else ()
        observer = Design(design.L, design.polynomial, [*poles, *fixed])
    else:
        A22, A12 = blocks["A22"], blocks["A12"]
        observer = yield from given_observer_of(A22, A12, given.options.observer_gain, plant.variable, reduced=True)
    J, N, M = yield from observer_matrices_of(parts, observer.gain, plant)
    whole = yield from reduced_loop_of(plant, parts, control, observer)
    yield from separation_of(whole, plant, control, observer)
    found, claims = reduced_compensator(plant, parts, control.gain, (observer.gain, J, N, M))
    G = yield from compensator_of(plant, found, claims, reduced=True)
    answers = _answers(whole, control, observer, G)
    answers["S1"] = sp.ImmutableMatrix(parts.T[:, : plant.p])
    answers["S2"] = sp.ImmutableMatrix(parts.T[:, plant.p :])
    return answers


def _answers(whole: Any, control: Design, observer: Design, G: Any) -> Answers:
    answers = Answers(closed_loop_A=whole, compensator=G[0, 0] if G.shape == (1, 1) else G)
    if control.eigenvalues is not None and observer.eigenvalues is not None:
        answers["eigenvalues"] = [*control.eigenvalues, *observer.eigenvalues]
    return answers


observer_feedback.verification("closed_loop_A")(checks.has_both_spectra)
observer_feedback.verification("eigenvalues")(checks.are_those_of_both)
observer_feedback.verification("compensator")(checks.closes_the_loop)
observer_feedback.verification("S1", "S2")(checks.split_the_state)


observer_feedback.consequence("eigenvalues", of=("closed_loop_A",), symbolic=False)(
    consequences.eigenvalues_of("closed_loop_A")
)


@observer_feedback.meaning("closed_loop_A")
def poles_of_the_whole(wrong: Attempt[WithBoth, ObserverFeedbackOptions]) -> Reason | None:
    """The poles that the whole has, where those of both are asked for."""
    asked, of_observer = numeric_poles_in_z(wrong.given), checks.observer_poles(wrong.given)
    if not asked or not of_observer:
        return None
    return meanings.poles_given(wrong.value, [*asked, *of_observer])


observer_feedback.mistake(mistakes.ADDED, "closed_loop_A")(mistakes.plus_for_minus)
with_mapping_mistakes(observer_feedback)
