"""A problem scaled for a machine: the largest sizes, volts per unit, the equations in volts and machine time."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Attempt, Check, Derivation, Given, Task
from solver.lazy import exact
from solver.tasks.analog import scaling_checks as checks
from solver.tasks.analog import scaling_mistakes
from solver.tasks.analog.machine_form import form_of
from solver.tasks.analog.machine_options import MachineOptions, faults_of
from solver.tasks.analog.scaling import maxima_of, scaled_equations_of, used_range_of, voltages_of
from solver.tasks.modelling.first_order import result_of

if TYPE_CHECKING:
    from solver.systems import Equations, System
    from solver.words import Reason


@dataclass(frozen=True, kw_only=True)
class ScalingOptions(MachineOptions):
    """Those of every question about a machine."""


amplitude_scaling: Task[Equations, ScalingOptions] = Task(
    "amplitude_scaling",
    title="Amplitude scaling",
    doc="The equations of a problem in volts and machine time, so that no amplifier of an analog computer overloads.",
    needs=("machine",),
    options=ScalingOptions,
    example={"equations": "[\"x'' + 8 x' + 25 x = 500\"]", "initial": "{x: 40}"},
    answers=[
        AnswerName("maximum", r"\text{maximum}", "the largest size of each variable, by its name", principal=True,
                   earned=("maximum", "given")),
        AnswerName("scale_factors", "L", "volts per unit of each variable, by its name", principal=True,
                   earned=("factors",)),
        AnswerName("scaled_equations", r"\text{scaled equations}",
                   "the derivatives of the voltages by the machine time: `X1_dot`, `X2_dot`, … in the order of states",
                   principal=True, earned=("row",)),
    ],
)  # fmt: skip
scaling_mistakes.register(amplitude_scaling)


@amplitude_scaling.refusal
def wrong_question(system: System, options: ScalingOptions) -> Iterable[tuple[str, Reason]]:
    """Names, maxima and initial values that do not fit."""
    yield from faults_of(system, options)


@amplitude_scaling.method(time="continuous", source="Jackson, Analog Computation, chapter 3")
def by_maxima(given: Given[Equations, ScalingOptions]) -> Derivation[Answers]:
    """The largest sizes, L = reference/maximum, x = X/L and τ = β t put into the equations."""
    model, options = given.system, given.options
    equations = yield from form_of(given)
    own = {model.symbol(jet): value for jet, value in (options.maximum or {}).items()}
    maxima = yield from maxima_of(equations, own)
    reference, beta = options.volts, options.beta
    scaling, scaled = yield from scaled_equations_of(equations, maxima, reference, beta)
    yield from used_range_of(equations, scaling, own, reference)
    return Answers(maximum=maxima, scale_factors=dict(scaling.factors), scaled_equations=voltages_of(scaled))


@amplitude_scaling.verification("maximum")
def is_reached_and_not_passed(given: Given[Equations, ScalingOptions], answers: Answers) -> Iterable[Check]:
    """A maximum that the question gives is that; any other is reached by the simulated motion, and not passed."""
    yield from checks.of_maxima(given, answers["maximum"])


@amplitude_scaling.verification("scale_factors")
def are_reference_over_maximum(given: Given[Equations, ScalingOptions], answers: Answers) -> Iterable[Check]:
    """Each factor brings the largest size of its variable to the reference voltage."""
    yield from checks.of_factors(given, answers["scale_factors"])


@amplitude_scaling.verification("scaled_equations")
def are_the_equations_in_volts(given: Given[Equations, ScalingOptions], answers: Answers) -> Iterable[Check]:
    """At random points the voltages change as the equations of the question say of the variables."""
    yield from checks.of_equations(given, answers["scaled_equations"])


@amplitude_scaling.meaning("maximum")
def larger_than_needed(wrong: Attempt[Equations, ScalingOptions]) -> Reason | None:
    """A bound that is passed by nothing, or one that a variable passes."""
    return checks.what_maxima_would_mean(wrong.given, wrong.value)


@amplitude_scaling.consequence("scale_factors", of=("maximum",))
def factors_of_maxima(given: Given[Equations, ScalingOptions], found: Mapping[str, Any]) -> Any:
    """Reference over maximum."""
    return exact.scale_factors(dict(found["maximum"]), given.options.volts)


@amplitude_scaling.consequence("scaled_equations", of=("scale_factors",))
def equations_of_factors(given: Given[Equations, ScalingOptions], found: Mapping[str, Any]) -> Any:
    """The equations with these volts per unit."""
    equations = result_of(form_of(given))
    known = {str(x): x for x in (*equations.variables, *equations.inputs)}
    factors = {known[str(x)]: L for x, L in dict(found["scale_factors"]).items() if str(x) in known}
    return voltages_of(exact.scaled(equations, exact.Scaling(factors, given.options.beta)))
