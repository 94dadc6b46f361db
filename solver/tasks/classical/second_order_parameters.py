"""Natural frequency, damping ratio and damping of a system of second order, also as they depend on a parameter."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Check,
    Claim,
    Derivation,
    Given,
    Refusal,
    Step,
    Task,
    Unsolved,
    option,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import classical as judges
from solver.options.names import Names
from solver.stated.algebra import difference, power, product, quotient
from solver.stated.calculus import value_at
from solver.tasks.classical import damping_mistakes
from solver.tasks.classical.sampled_second_order import sampled_second_order
from solver.tasks.figures import plane, roots
from solver.tasks.mistakes import OPEN_LOOP, not_closed
from solver.tasks.plant_options import LoopOptions
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Symbol

    from solver.systems import Polynomial, System


@dataclass(frozen=True, kw_only=True)
class SecondOrderOptions(LoopOptions):
    """What the damping is asked for in terms of."""

    parameter: tuple[str, ...] | None = option(
        Names(), "the parameter whose critical value is asked for (default: the one that the damping depends on)"
    )


WORDS = ("undamped", "underdamped", "critically damped", "overdamped")

second_order_parameters: Task[Polynomial, SecondOrderOptions] = Task(
    "second_order_parameters",
    title="Natural frequency and damping",
    doc="ω_n and ζ of s² + 2ζω_n s + ω_n² (discrete: of the poles (ln z)/T), the damping, where it is critical.",
    needs=("polynomial",),
    options=SecondOrderOptions,
    answers=[
        AnswerName(
            "natural_frequency", r"\omega_n", "the natural frequency", unit="rad/s", principal=True, earned=("compare",)
        ),
        AnswerName("damping_ratio", r"\sym{damping_ratio}", "the damping ratio", principal=True, earned=("compare",)),
        AnswerName(
            "damping", r"\text{damping}", "the case of damping", optional=True, words=WORDS, principal=True,
            earned=("damping",),
        ),
        AnswerName(
            "cases",
            r"\text{cases}",
            "where each case of damping holds, by its name",
            optional=True,
            principal=True,
            earned=("discriminant", "cases"),
        ),
        AnswerName(
            "critical_value",
            r"\text{critical value}",
            "the value of the parameter at which the damping is critical",
            optional=True,
            principal=True,
            earned=("discriminant", "critical"),
        ),
    ],
    example={"polynomial": "s^2 + d s + 4"},
)  # fmt: skip


@second_order_parameters.refusal
def has_no_such_parameter(system: System, options: SecondOrderOptions) -> Iterable[Refusal]:
    """One parameter, and the system must have it."""
    found = options.parameters_with(system)
    for name in options.parameter or ():
        if name not in found and not options.later:
            yield "parameter", Reason("stability/no_parameter", {"name": name})
    if len(options.parameter or ()) > 1:
        yield "parameter", Reason("second_order_parameters/one_parameter")
    if system.discrete and system.sample_time is None:
        yield "", Reason("sample_times/missing", {"discrete": True})


@second_order_parameters.method(
    source="Ogata, Modern Control Engineering, section 5-3; Franklin, Powell and Workman, section 4.3"
)
def by_comparison(given: Given[Polynomial, SecondOrderOptions]) -> Derivation[Answers]:
    """Compare the characteristic polynomial with s² + 2ζω_n s + ω_n²; a discrete one by its poles s = (ln z)/T."""
    p, s = given.system, given.system.variable
    if p.discrete:
        _of_second_order(p)
        return (yield from sampled_second_order(p, p.sample_time))
    found = _damping_of(p)
    monic = s**2 + found.twice * s + found.square
    claims = {"monic": Claim(quotient(p.expression, p.coefficients[0]), monic, "leading coefficient one")}
    if p.coefficients[0] != 1:
        yield Step("monic", claims=claims, x=s, p=p.expression, lead=p.coefficients[0])
    whole = s**2 + 2 * found.zeta * found.omega_n * s + found.omega_n**2
    yield Step("compare", claims={"standard": Claim(monic, whole, "standard form")}, x=s, found=found, monic=monic,
               assumed=exact.sign_of(found.square) is None)  # fmt: skip
    answers = Answers(natural_frequency=found.omega_n, damping_ratio=found.zeta)
    if found.damping or not p.parameters:
        answers |= _one_case(found)
        yield _verdict(found, s)
    else:
        answers |= yield from _by_cases(given, found)
    if found.damping and given.options.parameter:
        yield Step("decided", unclaimed="a consequence of what is assumed", word=found.damping)
    return answers


def _damping_of(p: Polynomial) -> exact.Damping:
    """ω_n and ζ; raises Unsolved for another degree, and where ω_n² is not positive."""
    _of_second_order(p)
    try:
        return exact.damping_of(p.coefficients)
    except exact.NoFrequency as finding:
        raise Unsolved("second_order_parameters/no_frequency", square=finding.square) from None


def _of_second_order(p: Polynomial) -> None:
    """Raise Unsolved for another degree than two."""
    if p.degree != 2:
        raise Unsolved("second_order_parameters/order", n=p.degree, p=p.expression)


def _one_case(found: exact.Damping) -> dict[str, Any]:
    """The case in words, where the damping is not negative."""
    return {"damping": found.damping} if found.damping else {}


def _verdict(found: exact.Damping, s: Symbol) -> Step:
    """What the case means for the poles and the response."""
    poles = exact.poles_of_damping(found)
    monic = s**2 + found.twice * s + found.square
    claims = {f"pole{i}": Claim(value_at(monic, s, pole), sp.Integer(0), "a pole") for i, pole in enumerate(poles)}
    return Step(
        "damping",
        claims=claims,
        word=found.damping,
        found=found,
        poles=poles,
        negative=found.sign == -1,
        turn=exact.damped_frequency(found),
        figures=plane("The poles", roots("poles", poles), stable=True),
    )


def _by_cases(given: Given[Polynomial, SecondOrderOptions], found: exact.Damping) -> Derivation[dict[str, Any]]:
    """Where each case holds: by the sign of the discriminant b₁² − 4b₂b₀ for b₁ > 0."""
    named = given.options.parameter or ()
    wanted = next((symbol for symbol in given.system.parameters if symbol.name in named), None)
    cases = exact.damping_cases(found, wanted)
    b2, b1, b0 = found.coefficients
    stated = difference(power(b1, sp.Integer(2)), product(sp.Integer(4), b2, b0))
    claims = {"discriminant": Claim(stated, found.discriminant, "discriminant")}
    if cases.critical is not None:
        claims["critical"] = Claim(
            value_at(found.discriminant, cases.parameter, cases.critical), sp.Integer(0), "critical damping"
        )
    yield Step("discriminant", claims=claims, found=found, cases=cases, b=found.coefficients)
    yield Step("cases", unclaimed="the answer, which has a check of its own", cases=cases.where, found=found,
               parameter=cases.parameter, open=found.sign is None)  # fmt: skip
    answers: dict[str, Any] = {"cases": cases.where}
    if cases.critical is not None:
        answers["critical_value"] = cases.critical
    elif wanted is not None:
        yield Step("never", unclaimed="a remark", parameter=wanted)
    return answers


BY_ROOTS = "mpmath, the roots (50 digits)"


@second_order_parameters.verification("natural_frequency", "damping_ratio")
def are_told_by_the_roots(given: Given[Polynomial, SecondOrderOptions], answers: Answers) -> Iterable[Check]:
    """ω_n = √(p₁p₂), ζ = −(p₁ + p₂)/(2ω_n), at values of the parameters."""
    c, period = given.system.coefficients, given.system.sample_time if given.system.discrete else None
    residuals = {"natural_frequency": judges.natural_frequency_residual, "damping_ratio": judges.damping_ratio_residual}
    labels = {"natural_frequency": r"$\omega_n^2$ is the product of the roots",
              "damping_ratio": r"the sum of the roots is $-2\,\sym{damping_ratio}\,\omega_n$"}  # fmt: skip
    for name, residual in residuals.items():
        if name in answers:
            yield numeric.check_residual(
                labels[name], BY_ROOTS, partial(residual, c, answers[name], period), answer=name
            )


@second_order_parameters.verification("damping", "cases", "critical_value")
def are_those_of_the_roots(given: Given[Polynomial, SecondOrderOptions], answers: Answers) -> Iterable[Check]:
    """At many values of the parameters, also at and beside the edges, the roots are as the case says."""
    c = given.system.coefficients
    if "damping" in answers:
        words = judges.damping_words(c, discrete=given.system.discrete)
        right = words == {str(answers["damping"]).replace(" ", "_")}
        yield Check.that("the case of damping", BY_ROOTS, right, answer="damping")
    if "cases" in answers:
        fault = judges.cases_fault(c, answers["cases"])
        yield Check.that("each case holds where the roots say", BY_ROOTS, not fault, answer="cases")
    if "critical_value" in answers:
        check = partial(judges.critical_residual, c, _parameter(given), answers["critical_value"])
        yield numeric.check_residual("the roots meet there", BY_ROOTS, check, answer="critical_value")


def _parameter(given: Given[Polynomial, SecondOrderOptions]) -> Symbol | None:
    """The parameter that is asked for, or the one that the damping depends on."""
    p, named = given.system, given.options.parameter or ()
    asked = next((symbol for symbol in p.parameters if symbol.name in named), None)
    return asked or exact.damping_parameter(p.coefficients)


damping_mistakes.register(second_order_parameters)


@second_order_parameters.consequence("damping_ratio", of=("natural_frequency",))
def ratio_of_the_frequency(given: Given[Polynomial, SecondOrderOptions], found: Mapping[str, Any]) -> Any:
    """b₁/(2b₂ω_n); None in discrete time, where the decay is another."""
    if given.system.discrete:
        return None
    b2, b1, _ = given.system.coefficients
    return b1 / (2 * b2 * found["natural_frequency"])


@second_order_parameters.consequence("damping", of=("damping_ratio",), symbolic=False)
def case_of_the_ratio(_given: Given[Polynomial, SecondOrderOptions], found: Mapping[str, Any]) -> Any:
    """Undamped for ζ = 0, underdamped for 0 < ζ < 1, critically damped for ζ = 1, overdamped above."""
    zeta = found["damping_ratio"]
    return WORDS[0] if zeta == 0 else WORDS[1] if 0 < zeta < 1 else WORDS[2] if zeta == 1 else WORDS[3]


second_order_parameters.mistaken_question(OPEN_LOOP)(not_closed)
