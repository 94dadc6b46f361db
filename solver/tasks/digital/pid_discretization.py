"""A PID controller in discrete time: in position form and in velocity form."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Options,
    Refusal,
    Slip,
    Task,
    option,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import digital as judges
from solver.options.number import Number
from solver.tasks.digital.pid_steps import sampled_pid
from solver.tasks.sample_times import sample_time_of, sample_time_option, sample_time_refusals
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import System

GAINS = ("K_p", "K_i", "K_d")
EARNED = ("integral", "derivative", "velocity")


@dataclass(frozen=True, kw_only=True)
class PidDiscretizationOptions(Options):
    """The gains and the sampling period."""

    K_p: Expr | None = option(Number(), "the gain of the error; without any gain all three are symbols")
    K_i: Expr | None = option(Number(), "the gain of its integral (default 0)")
    K_d: Expr | None = option(Number(), "the gain of its derivative (default 0)")
    sample_time: Expr | None = sample_time_option()


pid_discretization: Task[Any, PidDiscretizationOptions] = Task(
    "pid_discretization",
    title="PID controller in discrete time",
    doc="The sampled form of u = K_p e + K_i ∫ e dt + K_d e', with the derivative as a difference backward.",
    needs=(),
    options=PidDiscretizationOptions,
    answers=[
        AnswerName("controller", "D(z)", "the controller in z", discrete=True, principal=True, earned=EARNED),
        AnswerName(
            "coefficients",
            "q_i",
            r"the coefficients in $u(k) = u(k - 1) + q_0 e(k) + q_1 e(k - 1) + q_2 e(k - 2)$",
            ordered=True,
            numbered=True,
            earned=EARNED,
        ),
    ],
    example={"K_p": "2", "K_i": "1", "K_d": "1/2", "sample_time": "1/10"},
)


@pid_discretization.refusal
def incomplete_question(system: System, options: PidDiscretizationOptions) -> Iterable[Refusal]:
    """A sampling period is needed, and a gain that is not zero."""
    yield from sample_time_refusals(system, options)
    given = [getattr(options, name) for name in GAINS if options.has(name)]
    if given and not options.later and all(each == 0 for each in given):
        yield next(name for name in GAINS if options.has(name)), Reason("pid_discretization/no_gain")


def gains_of(options: PidDiscretizationOptions) -> exact.Gains:
    """The gains given, zero where one is left out; symbols where all are."""
    values = [getattr(options, name) for name in GAINS]
    if all(value is None for value in values):
        return exact.Gains(*(sp.Symbol(name, real=True) for name in GAINS))
    return exact.Gains(*(sp.Integer(0) if value is None else value for value in values))


def _by_rule(given: Given[Any, PidDiscretizationOptions], rule: str) -> Derivation[Answers]:
    """Replace integral and derivative, then take the difference of two values of u."""
    z, T, gains = sp.Symbol("z"), sample_time_of(given), gains_of(given.options)
    found = yield from sampled_pid(gains, T, rule, z)
    return Answers(controller=found.controller, coefficients=list(found.coefficients))


@pid_discretization.method(
    "backward", title="Integral backward", source="Åström and Wittenmark, Computer-Controlled Systems, §8.5"
)
def with_areas_by_their_end(given: Given[Any, PidDiscretizationOptions]) -> Derivation[Answers]:
    """I(k) = I(k − 1) + T e(k)."""
    return (yield from _by_rule(given, "backward"))


@pid_discretization.method(
    "forward", title="Integral forward", source="Åström and Wittenmark, Computer-Controlled Systems, §8.5"
)
def with_areas_by_their_beginning(given: Given[Any, PidDiscretizationOptions]) -> Derivation[Answers]:
    """I(k) = I(k − 1) + T e(k − 1)."""
    return (yield from _by_rule(given, "forward"))


@pid_discretization.method(
    "tustin", title="Integral by trapezoids", source="Åström and Wittenmark, Computer-Controlled Systems, §8.5"
)
def with_trapezoids(given: Given[Any, PidDiscretizationOptions]) -> Derivation[Answers]:
    """I(k) = I(k − 1) + T (e(k) + e(k − 1))/2."""
    return (yield from _by_rule(given, "tustin"))


RULES = ("backward", "forward", "tustin")


@pid_discretization.verification("controller", "coefficients")
def answers_a_pulse_as_defined(given: Given[Any, PidDiscretizationOptions], answers: Answers) -> Iterable[Check]:
    """The response to a pulse of the error, sample by sample, is that of the sums and differences."""
    z, T, rule = sp.Symbol("z"), sample_time_of(given), given.method or "backward"
    wanted = judges.pid_samples(gains_of(given.options), T, rule)
    if "controller" in answers:
        for k, (own, right) in enumerate(zip(judges.controller_samples(answers["controller"], z), wanted, strict=True)):
            label = Phrase("sample {k} after a pulse of the error, by a contour integral", k=k)
            yield numeric.check_claim(Claim(own, right), label, answer="controller")
    if "coefficients" in answers:
        listed = list(answers["coefficients"])
        for k, (own, right) in enumerate(zip(judges.recursion_samples(listed), wanted, strict=True)):
            label = Phrase("sample {k} after a pulse of the error, by the recursion", k=k)
            yield numeric.check_claim(Claim(own, right), label, answer="coefficients")


WITHOUT_T = Slip("without_T", "the sampling period $T$ is missing in the integral")
OTHER_RULE = Slip("other_rule", "the integral is replaced by another rule than the one asked for")
DERIVATIVE_TIMES_T = Slip("derivative_times_T", "the derivative is multiplied by $T$; it must be divided")
POSITION = Slip("position_for_velocity", "$u(k - 1)$ is not used: these are no coefficients of the velocity form")

Wrong = Attempt[Any, PidDiscretizationOptions]


def _as_asked(wrong: Wrong, found: exact.DiscretePid) -> Any:
    return found.controller if wrong.name == "controller" else list(found.coefficients)


@pid_discretization.mistake(WITHOUT_T, "controller", "coefficients")
def integral_without_T(wrong: Wrong) -> Iterable[Any]:
    """K_i for K_i T."""
    z, T, (K_p, K_i, K_d) = sp.Symbol("z"), sample_time_of(wrong.given), gains_of(wrong.given.options)
    yield _as_asked(wrong, exact.discrete_pid(exact.Gains(K_p, K_i / T, K_d), T, wrong.given.method or "backward", z))


@pid_discretization.mistake(DERIVATIVE_TIMES_T, "controller", "coefficients")
def derivative_with_T(wrong: Wrong) -> Iterable[Any]:
    """K_d T for K_d/T."""
    z, T, (K_p, K_i, K_d) = sp.Symbol("z"), sample_time_of(wrong.given), gains_of(wrong.given.options)
    rule = wrong.given.method or "backward"
    yield _as_asked(wrong, exact.discrete_pid(exact.Gains(K_p, K_i, K_d * T**2), T, rule, z))


@pid_discretization.mistake(OTHER_RULE, "controller", "coefficients")
def by_another_rule(wrong: Wrong) -> Iterable[Any]:
    """What the other rules give."""
    z, T, gains = sp.Symbol("z"), sample_time_of(wrong.given), gains_of(wrong.given.options)
    for rule in RULES:
        if rule != (wrong.given.method or "backward") and gains.K_i != 0:
            yield _as_asked(wrong, exact.discrete_pid(gains, T, rule, z))


@pid_discretization.mistake(POSITION, "coefficients")
def of_the_position_form(wrong: Wrong) -> Iterable[Any]:
    """K_p + K_i T + K_d/T and −K_d/T: what stands beside the sum of all errors."""
    T, (K_p, K_i, K_d) = sample_time_of(wrong.given), gains_of(wrong.given.options)
    new, old = exact.integral_weights(wrong.given.method or "backward", T)
    yield [K_p + K_i * new + K_d / T, K_i * old - K_d / T, sp.Integer(0)]


@pid_discretization.consequence("controller", of=("coefficients",))
def controller_of_coefficients(_given: Given[Any, PidDiscretizationOptions], found: Mapping[str, Any]) -> Any:
    """(q₀ z² + q₁ z + q₂)/(z (z − 1))."""
    z, q = sp.Symbol("z"), [*found["coefficients"], 0, 0, 0]
    return (q[0] * z**2 + q[1] * z + q[2]) / (z * (z - 1))
