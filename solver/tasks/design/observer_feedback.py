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
from solver.tasks.plant_options import PlantOptions
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import System
    from solver.tasks.needed import WithBoth


@dataclass(frozen=True, kw_only=True)
class ObserverFeedbackOptions(PlantOptions):
    """The gains, given or by their poles."""

    poles: tuple[Expr, ...] | None = option(Poles(), "the poles of A − BK, where K is to be found")
    gain: ImmutableMatrix | None = option(
        MatrixOf("m", "n", flat="row"), "the state feedback K, where it is given", answer="K"
    )
    observer_poles: tuple[Expr, ...] | None = option(Poles(), "the poles of the observer, where L is to be found")
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
            "eigenvalues", r"\lambda_i", "the eigenvalues of the closed loop", optional=True, earned=("separation",)
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
    for poles, gain in (("poles", "gain"), ("observer_poles", "observer_gain")):
        if options.has(poles) and options.has(gain):
            yield gain, Reason("observers/poles_and_gain", {"poles": poles, "gain": gain})
        elif not options.has(poles) and not options.has(gain):
            yield "", Reason("observers/poles_or_gain", {"poles": poles, "gain": gain})
    if isinstance(system, systems.StateSpace) and system.B is not None and system.C is not None:
        yield from _faults_of_numbers(system, options)


def _faults_of_numbers(system: Any, options: ObserverFeedbackOptions) -> Iterator[Refusal]:
    plant, n = measuring(system), system.order
    poles, L = options.observer_poles, options.observer_gain
    if options.poles is not None:
        reached = exact.reachable_order(plant.A, plant.B)
        if len(options.poles) not in (n, reached):
            numbers = {"given": len(options.poles), "n": n, "reached": reached}
            yield "poles", Reason("observers/poles_of_the_feedback", numbers)
    reduced = options.reduced
    rows = n - plant.p if reduced else n
    if L is not None and L.shape != (rows, plant.p):
        yield "observer_gain", Reason("observers/size_of_the_gain", {"wanted": (rows, plant.p), "given": L.shape})
    if not reduced:
        if poles is not None:
            yield from observer_pole_faults(system, poles, "observer_poles")
        return
    wrong = measurement_fault(plant)
    if wrong is not None:
        yield "reduced", wrong
    elif poles is not None:
        yield from (("observer_poles", fault) for _, fault in pole_faults(plant, poles))


@observer_feedback.method(source="Lecture note, sections 4.4 and 4.5")
def by_separation(given: Given[WithBoth, ObserverFeedbackOptions]) -> Derivation[Answers]:
    """K for A − BK and L for A − LC are found apart; the poles of the whole are those of both."""
    plant, poles = measuring(given.system), given.options.observer_poles or ()
    for _, fault in what_the_file_shows(given.system, given.options):
        raise Unsolved("engine/refused", message=fault)
    yield Step("plan", unclaimed="what is going to be done", reduced=given.options.reduced)
    control = yield from feedback_of(plant, given.options.poles, given.options.gain)
    if given.options.reduced:
        return (yield from _with_reduced_observer(given, plant, control))
    if given.options.observer_gain is None:
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


def _with_reduced_observer(
    given: Given[WithBoth, ObserverFeedbackOptions], plant: Plant, control: Design
) -> Derivation[Answers]:
    """The same with the measured states in place of their estimates."""
    parts = yield from partition_of(plant)
    yield from error_equation_of(discrete=plant.discrete)
    blocks, poles = parts.blocks, given.options.observer_poles or ()
    if given.options.observer_gain is None:
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
    options = wrong.given.options
    if options.poles is None or options.observer_poles is None:
        return None
    return meanings.poles_given(wrong.value, [*options.poles, *options.observer_poles])


observer_feedback.mistake(mistakes.ADDED, "closed_loop_A")(mistakes.plus_for_minus)
