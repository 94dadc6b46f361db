"""Responses to an initial state and to inputs: x(t) and y(t), in discrete time x(k) and y(k)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
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
    option,
)
from solver.lazy import sympy as sp
from solver.options.choice import Choice
from solver.options.expression_list import ExpressionList
from solver.options.matrix import MatrixOf
from solver.tasks import mistakes
from solver.tasks.linear_algebra.resolvent import inverse_of_pencil
from solver.tasks.plant_options import LoopOptions
from solver.tasks.time_response import by_convolution as convolution
from solver.tasks.time_response import by_transfer_function as transfer
from solver.tasks.time_response import by_transform as transform
from solver.tasks.time_response.question import Question, entry_or_column
from solver.tasks.time_response.response_checks import (
    checks_of,
    final_value_checks,
    peak_checks,
    what_x_would_mean,
    what_y_would_mean,
)
from solver.tasks.time_response.whole_response import passed_on, put_together
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import System
    from solver.tasks.time_response.question import Moving


@dataclass(frozen=True, kw_only=True)
class ResponseOptions(LoopOptions):
    """What moves the system."""

    kind: str = option(
        Choice(("complete", "zero_input", "zero_state")),
        "complete; zero_input: the initial state alone; zero_state: the input alone",
        titles={
            "complete": "Complete response",
            "zero_input": "Zero-input response",
            "zero_state": "Zero-state response",
        },
    )
    input: tuple[Expr, ...] | None = option(
        ExpressionList(("t", "k")), "u as an expression in t (discrete: k), a list for several inputs"
    )
    initial_state: ImmutableMatrix | None = option(
        MatrixOf("n", 1, flat="column"), "x(0), numbers or symbols; else that of the system", needs=("states",)
    )


def _has_states(system: System) -> bool:
    """Whether the question has states; those of a realization are not asked for."""
    return hasattr(system, "A")


def _has_output(system: System) -> bool:
    return not _has_states(system) or "C" in system.provides


response: Task[Moving, ResponseOptions] = Task(
    "response",
    title="Response",
    doc="States and outputs for an initial state and given inputs: zero-input, zero-state or complete response.",
    needs=("motion",),
    options=ResponseOptions,
    answers=[
        AnswerName(
            "x",
            "x",
            "the states (none of a transfer function from rest)",
            optional=True,
            principal=_has_states,
            earned=("zero_input_transform", "zero_state_transform", "convolution", "convolution_sum", "free_motion"),
        ),
        AnswerName(
            "y",
            "y",
            "the output (several: a column)",
            optional=True,
            principal=_has_output,
            earned=("output_transform", "partial_fractions", "convolution", "convolution_sum"),
        ),
        AnswerName("y_final", r"y_{\infty}", "the final value, the limit of $y$", optional=True),
        AnswerName("y_peak", r"y_{\text{peak}}", "the peak, the value of largest size", optional=True),
        AnswerName(
            "t_peak",
            r"t_{\text{peak}}",
            "when the peak is reached first (in discrete time: the sample)",
            optional=True,
            unit="s",
        ),
    ],
    example={"B": "[0, 1]", "input": "exp(-t)", "initial_state": "[1, 0]"},
)


@response.refusal
def incomplete_question(system: System, options: ResponseOptions) -> Iterable[Refusal]:
    """What the question needs by its kind: an input for each input of the system, an initial state."""
    kind = options.kind
    if kind == "zero_input":
        if not options.has("initial_state") and "initial_state" not in system.provides:
            yield "", Reason("response/no_initial_state")
        return
    inputs = _number_of_inputs(system)
    if not inputs:
        yield "", Reason("response/no_input_matrix")
    elif not options.has("input"):
        yield "", Reason("response/no_input", {"zero_state": kind == "zero_state"})
    elif options.input is not None and len(options.input) != inputs:
        yield "input", Reason("response/number_of_inputs", {"inputs": inputs, "given": len(options.input)})


def _number_of_inputs(system: System) -> int:
    return system.size("m") or 0


@response.method("laplace", title="Laplace transform", source="Lecture note, section 1.13", time="continuous")
def by_laplace(given: Given[Moving, ResponseOptions]) -> Derivation[Answers]:
    """X(s) = (sI − A)⁻¹ [x(0) + B U(s)], or Y(s) = G(s) U(s), transformed back by partial fractions."""
    return (yield from _by_transform(given))


@response.method("z_transform", title="z-transform", source="Lecture note, section 7.5", time="discrete")
def by_z_transform(given: Given[Moving, ResponseOptions]) -> Derivation[Answers]:
    """X(z) = (zI − A)⁻¹ [z x(0) + B U(z)], or Y(z) = G(z) U(z), transformed back by partial fractions of X(z)/z."""
    return (yield from _by_transform(given))


def _by_transform(given: Given[Moving, ResponseOptions]) -> Derivation[Answers]:
    asked = Question.of(given)
    yield from transfer.apart_from_dead_time(given)
    if not asked.system.order:
        return (yield from passed_on(asked))
    if asked.transfer is not None:
        yield from transfer.output_by_transform(asked, asked.transfer.matrix)
        return (yield from put_together(asked))
    yield from transform.equation_of_transforms(asked)
    yield from inverse_of_pencil(asked.system.A, asked.variable)
    if asked.x0 is not None:
        yield from transform.zero_input_by_transform(asked)
    for piece in asked.pieces:
        yield from transform.zero_state_by_transform(asked, piece)
    answers = yield from put_together(asked)
    return answers


@response.method("convolution", title="Convolution", source="Lecture note, equation (1.13.3)")
def by_convolution(given: Given[Moving, ResponseOptions]) -> Derivation[Answers]:
    """x(t) = Φ(t) x(0) + ∫ Φ(t − τ) B u(τ) dτ; in discrete time x(k) = Aᵏ x(0) + Σ Aᵏ⁻¹⁻ⁱ B u(i); or y = g ∗ u."""
    asked = Question.of(given)
    yield from transfer.apart_from_dead_time(given)
    if not asked.system.order:
        return (yield from passed_on(asked))
    if asked.transfer is not None:
        yield from transfer.output_by_convolution(asked, asked.transfer.matrix)
        return (yield from put_together(asked))
    yield from convolution.formula_of_convolution(asked)
    Phi = yield from convolution.transition_matrix_of(asked)
    if asked.x0 is not None:
        yield from convolution.zero_input_by_convolution(asked, Phi)
    for piece in asked.pieces:
        yield from convolution.zero_state_by_convolution(asked, piece, Phi)
    answers = yield from put_together(asked)
    return answers


@response.verification("x")
def states_solve_the_state_equation(given: Given[Moving, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """x(0) = x0, x' = A x + B u, and the convolution formula by expm and quadrature; discrete: the recursion."""
    yield from checks_of(given, answers["x"], "x")


@response.verification("y")
def output_follows_the_convolution_formula(given: Given[Moving, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """The equation y = C x + D u with x by the convolution formula, in discrete time by the recursion."""
    yield from checks_of(given, answers["y"], "y")


@response.verification("y_final")
def limit_is_the_equilibrium(given: Given[Moving, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """The equilibrium of the system for the limit of its input."""
    yield from final_value_checks(given, answers["y_final"])


@response.verification("y_peak", "t_peak")
def peak_is_that_of_a_simulation(given: Given[Moving, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """Simulated step by step, and refined between the steps."""
    yield from peak_checks(given, answers.get("y_peak"), answers.get("t_peak"))


@response.consequence("y", of=("x",))
def output_of_the_states(given: Given[Moving, ResponseOptions], found: Mapping[str, Any]) -> Any:
    """C x, and what the input adds to the output directly."""
    asked = Question.of(given)
    C, right = asked.system.C, asked.answer
    return None if right.y is None else entry_or_column(sp.ImmutableMatrix(right.y + C * (found["x"] - right.x)))


@response.consequence("y_peak", of=("y", "t_peak"))
def value_at_the_peak(given: Given[Moving, ResponseOptions], found: Mapping[str, Any]) -> Any:
    """y at the time of the peak."""
    return found["y"].subs(Question.of(given).time, found["t_peak"])


response.mistaken_question(mistakes.EXCHANGED)(mistakes.inputs_for_outputs)


@response.mistaken_question(mistakes.WITHOUT_INITIAL_STATE)
def without_initial_state(system: System, options: ResponseOptions) -> tuple[System, ResponseOptions] | None:
    """The response from rest."""
    x0 = options.initial_state
    return None if x0 is None else (system, replace(options, initial_state=sp.ImmutableMatrix(sp.zeros(*x0.shape))))


@response.meaning("x")
def state_at_the_start(wrong: Attempt[Moving, ResponseOptions]) -> Reason | None:
    """The state that it begins with, or where it leaves the differential (difference) equation."""
    return what_x_would_mean(wrong.given, wrong.value)


@response.meaning("y")
def output_at_the_start(wrong: Attempt[Moving, ResponseOptions]) -> Reason | None:
    """The output that it begins with."""
    return what_y_would_mean(wrong.given, wrong.value)
