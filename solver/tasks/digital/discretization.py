"""A continuous plant in discrete time: exactly with a hold, or by a rule for s."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, TypeGuard

from solver.derivation import AnswerName, Answers, Attempt, Derivation, Given, Refusal, Task, Unsolved, option
from solver.derivation.answer_equations import state_equations
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.options.number import Number
from solver.tasks import meanings
from solver.tasks.digital import digital_mistakes, discretization_checks
from solver.tasks.digital.by_rule import mapped_plant_of, mapped_transfer_of
from solver.tasks.digital.held_states import held_states_of
from solver.tasks.digital.matching import matched_of
from solver.tasks.digital.pulse_steps import pulse_of
from solver.tasks.plant_options import PlantOptions
from solver.tasks.representation.transfer_function import transfer_function_of
from solver.tasks.sample_times import sample_time_of, sample_time_option, sample_time_refusals
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import DeadTime, StateSpace, System, TransferFunction

    Plant = StateSpace | TransferFunction | DeadTime


@dataclass(frozen=True, kw_only=True)
class DiscretizationOptions(PlantOptions):
    """The sampling period, and the frequency that Tustin's rule is to keep."""

    sample_time: Expr | None = sample_time_option()
    prewarp: Expr | None = option(
        Number(), "the frequency at which the discrete plant is to be as the continuous one", methods=("tustin",)
    )


def in_state_space(system: Any) -> TypeGuard[StateSpace]:
    """Whether the system has states of its own; a transfer function has none."""
    return not isinstance(system, (systems.TransferFunction, systems.DeadTime))


def has_inputs(system: Any) -> bool:
    """Whether it has states, and inputs."""
    return in_state_space(system) and getattr(system, "B", 1) is not None


def has_outputs(system: Any) -> bool:
    """Whether it has states, and outputs."""
    return in_state_space(system) and getattr(system, "C", 1) is not None


discretization: Task[Plant, DiscretizationOptions] = Task(
    "discretization",
    title="Discretization",
    doc="A discrete model of a continuous plant for a sampling period T; what the methods do to stability.",
    needs=("motion",),
    options=DiscretizationOptions,
    example={"A": "[[0, 1], [0, -1]]", "B": "[0, 1]", "C": "[1, 0]", "sample_time": "T"},
    answers=[
        AnswerName("A", "A_{d}", "the system matrix of the discrete plant, n×n", optional=True, discrete=True,
                   principal=in_state_space, earned=("exponential", "transition", "inverse", "matrices")),
        AnswerName("B", "B_{d}", "the input matrix of the discrete plant, n×m", optional=True, discrete=True,
                   principal=has_inputs, earned=("held_input", "matrices")),
        AnswerName("C", "C_{d}", "the output matrix of the discrete plant, p×n", optional=True, discrete=True),
        AnswerName("D", "D_{d}", "the feedthrough of the discrete plant, p×m", optional=True, discrete=True),
        AnswerName("G", "G(z)", "the transfer function of the discrete plant, in z", optional=True, discrete=True,
                   principal=lambda system: not in_state_space(system),
                   earned=("hold", "partial_fractions", "sampled", "substituted", "poles", "gain")),
    ],
)  # fmt: skip
discretization.together(state_equations())
discretization_checks.register(discretization)


@discretization.refusal
def asked_of_a_continuous_plant(system: System, options: DiscretizationOptions) -> Iterable[Refusal]:
    """The plant is continuous, a sampling period is given, a frequency to be kept is below half the sampling one."""
    if system.discrete:
        yield "", Reason("discretization/discrete")
        return
    yield from sample_time_refusals(system, options)
    prewarp, T = options.prewarp, options.sample_time
    if prewarp is None or T is None:
        return
    if prewarp.is_positive is False:
        yield "prewarp", Reason("discretization/prewarp_not_positive")
    elif (sp.pi - prewarp * T).is_nonpositive:
        yield "prewarp", Reason("discretization/prewarp_too_high", {"limit": sp.pi / T})


@discretization.method(
    "zero_order_hold", title="Zero-order hold", source="Åström and Wittenmark, Computer-Controlled Systems, §2.3",
    time="continuous",
)  # fmt: skip
def by_zero_order_hold(given: Given[Plant, DiscretizationOptions]) -> Derivation[Answers]:
    """A_d = e^{AT}, B_d = ∫₀ᵀ e^{At} dt B; of a transfer function (1 − z⁻¹) 𝒵{G(s)/s}."""
    plant, T = given.system, sample_time_of(given)
    if in_state_space(plant):
        return _states(*(yield from held_states_of(plant, T)))
    return Answers(G=(yield from pulse_of(plant, T, held=True)))


def _rational(plant: Plant) -> Any:
    """The plant, which must have no dead time."""
    if isinstance(plant, systems.DeadTime):
        raise Unsolved("discretization/dead_time")
    return plant


def _by_rule(given: Given[Plant, DiscretizationOptions], name: str) -> Derivation[Answers]:
    plant, T = _rational(given.system), sample_time_of(given)
    if in_state_space(plant):
        return _states(*(yield from mapped_plant_of(plant, name, T, given.options.prewarp)))
    return Answers(G=(yield from mapped_transfer_of(plant, name, T, given.options.prewarp)))


@discretization.method(
    "forward_euler",
    title="Euler's forward method",
    source="Åström and Wittenmark, Computer-Controlled Systems, §8.2",
    time="continuous",
)
def by_eulers_forward_method(given: Given[Plant, DiscretizationOptions]) -> Derivation[Answers]:
    """(z − 1)/T in place of s."""
    return (yield from _by_rule(given, "forward_euler"))


@discretization.method(
    "backward_euler",
    title="Euler's backward method",
    source="Åström and Wittenmark, Computer-Controlled Systems, §8.2",
    time="continuous",
)
def by_eulers_backward_method(given: Given[Plant, DiscretizationOptions]) -> Derivation[Answers]:
    """(z − 1)/(T z) in place of s."""
    return (yield from _by_rule(given, "backward_euler"))


@discretization.method(
    "tustin",
    title="Tustin's method",
    source="Franklin, Powell, Workman, Digital Control of Dynamic Systems, §6.1",
    time="continuous",
)
def by_tustins_method(given: Given[Plant, DiscretizationOptions]) -> Derivation[Answers]:
    """(2/T) (z − 1)/(z + 1) in place of s; prewarped with another factor."""
    return (yield from _by_rule(given, "tustin"))


@discretization.method(
    "matched", title="Matched poles and zeros",
    source="Franklin, Powell, Workman, Digital Control of Dynamic Systems, §6.2", time="continuous",
)  # fmt: skip
def by_matching(given: Given[Plant, DiscretizationOptions]) -> Derivation[Answers]:
    """Poles and zeros to e^{sT}, zeros at infinity to −1 but for one, the gain kept at low frequencies."""
    plant, T = _rational(given.system), sample_time_of(given)
    if in_state_space(plant) and not (has_inputs(plant) and has_outputs(plant)):
        raise Unsolved("discretization/no_path")
    if (plant.size("p"), plant.size("m")) != (1, 1):
        raise Unsolved("discretization/matched_of_matrices")
    G = (yield from transfer_function_of(plant)).matrix if in_state_space(plant) else plant.matrix
    return (yield from matched_of(G[0, 0], T, states=in_state_space(plant)))


def _states(*matrices: Any) -> Answers:
    return Answers(**{name: M for name, M in zip("ABCD", matrices, strict=True) if M is not None})


def answers_by(given: Given[Plant, DiscretizationOptions], method: str) -> Mapping[str, Any]:
    """The answers by another method, none where it has none."""
    other = replace(given, method=method, options=replace(given.options, prewarp=None))
    derivation = discretization.methods[method].derive(other)
    try:
        while True:
            next(derivation)
    except StopIteration as end:
        found: Mapping[str, Any] = end.value
        return found
    except (Unsolved, exact.NotExact):
        return {}


digital_mistakes.name_mistakes_of_discretization(discretization, answers_by)


@discretization.meaning("G")
def value_at_a_point(wrong: Attempt[Plant, DiscretizationOptions]) -> Reason | None:
    """Its value, and that of the discrete plant, at a point."""
    return meanings.at_a_point(wrong.value, wrong.ours)
