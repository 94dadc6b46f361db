"""The poles of a second-order system that meets specifications of its step response."""

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
    Refusal,
    Step,
    Task,
    Unsolved,
    lemma,
    option,
)
from solver.derivation.figures import Region
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.options.choice import Choice
from solver.options.number import Number
from solver.tasks.design.frames import linear_factors
from solver.tasks.figures import plane, roots
from solver.tasks.plant_options import PlantOptions
from solver.tasks.told import short
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import System


@dataclass(frozen=True, kw_only=True)
class StepSpecifications(PlantOptions):
    """What is asked of a step response: any two of the first six fix a pair of poles."""

    overshoot: Expr | None = option(Number(percent=True), "largest overshoot of the step response, a fraction or 14%")
    settling_time: Expr | None = option(Number(), "time after which the step response stays in the settling band")
    peak_time: Expr | None = option(Number(), "time of the first peak of the step response")
    rise_time: Expr | None = option(Number(), "time from 0 to 100 % of the final value")
    damping_ratio: Expr | None = option(Number(), "damping ratio ζ")
    natural_frequency: Expr | None = option(Number(), "natural frequency ω_n")
    settling_band: str = option(Choice(("2%", "5%")), "settling time is 4/(ζω_n) for 2%, 3/(ζω_n) for 5%")


NAMES = ("overshoot", "settling_time", "peak_time", "rise_time", "damping_ratio", "natural_frequency")

desired_poles: Task[System, StepSpecifications] = Task(
    "desired_poles",
    title="Desired poles from time-domain specifications",
    doc="Damping ratio, natural frequency and poles of s² + 2ζω_n s + ω_n² from two specifications of its response.",
    needs=(),
    options=StepSpecifications,
    answers=[
        AnswerName("damping_ratio", r"\sym{damping_ratio}", "the damping ratio"),
        AnswerName("natural_frequency", r"\omega_n", "the natural frequency", unit="rad/s"),
        AnswerName(
            "poles", "s_{1,2}", "the poles", principal=True, numbered=True, earned=("damping_and_frequency", "poles")
        ),
        AnswerName("polynomial", r"\hat{p}(s)", "the characteristic polynomial with these roots"),
    ],
    example={"overshoot": "14%", "settling_time": "2"},
)


def specified(options: StepSpecifications) -> dict[str, Any]:
    """Return the specifications that are given."""
    return {name: value for name in NAMES if (value := getattr(options, name)) is not None}


def band(options: StepSpecifications) -> int:
    """Return ζω_n times the settling time."""
    return 3 if options.settling_band == "5%" else 4


def faults(options: StepSpecifications) -> Iterable[Refusal]:
    """Return what is wrong with specifications that are all known."""
    given = specified(options)
    if options.later & set(NAMES):
        return  # some come from an earlier part
    try:
        exact.second_order(given, band(options))
    except exact.Inconsistent as finding:
        yield next(iter(given), ""), finding.reason


@lemma("second_order")
def second_order_of(options: StepSpecifications) -> Derivation[exact.SecondOrder]:
    """ζ and ω_n from two specifications, then the poles −ζω_n ± jω_d."""
    given, c, s = specified(options), band(options), sp.Symbol("s")
    try:
        found = exact.second_order(given, c)
    except exact.Inconsistent as finding:
        raise Unsolved("second_order/cannot_be_met", why=finding.reason) from finding
    if "settling_time" in given and found.zeta.is_number and found.zeta > 1:
        raise Unsolved("second_order/no_settling_formula", zeta=found.zeta)
    claims = {
        name: Claim(exact.specified(name, found.zeta, found.omega_n, c), given[name], name.replace("_", " "))
        for name in given
        if name in found.used and given[name] != 0
    }
    yield Step(
        "damping_and_frequency",
        claims=claims,
        given=given,
        used=found.used,
        zeta=found.zeta,
        omega_n=found.omega_n,
        sigma=found.sigma,
        omega_d=None if found.overdamped else found.omega_d,
        angle=found.angle,
        band=c,
        others=[name for name in given if name not in found.used],
    )
    polynomial = exact.polynomial_in(s, found.coefficients)
    yield Step(
        "poles",
        claims={
            "polynomial": Claim(linear_factors(s, found.poles), polynomial, "polynomial with these poles"),
        },
        zeta=found.zeta,
        omega_n=found.omega_n,
        sigma=found.sigma,
        omega_d=None if found.overdamped else found.omega_d,
        poles=found.poles,
        figures=plane(
            "The poles, and where the specifications are met", roots("poles", found.poles), region=_region(given, found)
        ),
    )
    return found


def _region(given: Mapping[str, Any], found: exact.SecondOrder) -> Region | None:
    """Where poles meet the specifications, taken as bounds; None where symbols are left, or nothing can be shaded."""
    if found.zeta.free_symbols or found.omega_n.free_symbols:
        return None
    return Region(
        damping=found.zeta if {"overshoot", "damping_ratio"} & set(given) else None,
        decay=found.sigma if "settling_time" in given else None,
        radius=found.omega_n if "natural_frequency" in given else None,
        frequency=found.omega_d if "peak_time" in given and not found.overdamped else None,
    )


@desired_poles.refusal
def two_consistent_specifications(_system: Any, options: StepSpecifications) -> Iterable[Refusal]:
    """Two specifications, not both about the damping, that a second-order system can meet."""
    yield from faults(options)


@desired_poles.method(source="Lecture note, section 3.4")
def by_formulas(given: Given[System, StepSpecifications]) -> Derivation[Answers]:
    """Solve the formulas of the second-order step response for ζ and ω_n; the poles are −ζω_n ± jω_d."""
    found = yield from second_order_of(given.options)
    polynomial = exact.polynomial_in(sp.Symbol("s"), found.coefficients)
    return Answers(damping_ratio=found.zeta, natural_frequency=found.omega_n, poles=found.poles, polynomial=polynomial)


@desired_poles.verification("damping_ratio", "natural_frequency", "poles", "polynomial")
def meets_the_specifications(given: Given[System, StepSpecifications], answers: Answers) -> Iterable[Check]:
    """Compare with the ζ and ω_n that bisection finds for the specifications (mpmath)."""
    specifications, c = specified(given.options), band(given.options)

    def residual(formula: Any, values: list[Any]) -> float:
        return judges.second_order_residual(specifications, c, formula, values)

    for name, formula, values in _judged(answers):
        yield numeric.check_residual(
            Phrase("{name} meets the specifications", name=name.replace("_", " ")),
            "mpmath, bisection",
            lambda formula=formula, values=values: residual(formula, values),  # type: ignore[misc]  # bound here
            answer=name,
        )


def _judged(answers: Answers) -> Iterable[tuple[str, Any, list[Expr]]]:
    """Return each answer's name, its values, and the formula for them in ζ and ω_n."""
    s = sp.Symbol("s")
    if "damping_ratio" in answers:
        yield "damping_ratio", lambda zeta, _: [zeta], [answers["damping_ratio"]]
    if "natural_frequency" in answers:
        yield "natural_frequency", lambda _, omega: [omega], [answers["natural_frequency"]]
    if "poles" in answers:
        poles = list(answers["poles"])
        values = [len(poles), -sp.Add(*poles) / 2, sp.Mul(*poles)]
        yield "poles", lambda zeta, omega: [2, zeta * omega, omega**2], values
    if "polynomial" in answers:
        p = sp.expand(answers["polynomial"])
        values = [p.coeff(s, 2), p.coeff(s, 1), p.coeff(s, 0), sp.degree(p, s) if p.has(s) else sp.Integer(0)]
        yield "polynomial", lambda zeta, omega: [1, 2 * zeta * omega, omega**2, 2], values


@desired_poles.consequence("natural_frequency", of=("damping_ratio",), symbolic=False)
def frequency_of_the_damping(given: Given[System, StepSpecifications], found: Mapping[str, Any]) -> Any:
    """ω_n from ζ and the specification that is not about the damping alone."""
    about_damping = ("damping_ratio", "overshoot")
    others = {name: value for name, value in specified(given.options).items() if name not in about_damping}
    asked = {"damping_ratio": found["damping_ratio"], **others}
    return exact.second_order(asked, band(given.options)).omega_n


@desired_poles.consequence("poles", of=("damping_ratio", "natural_frequency"))
def poles_of_damping_and_frequency(_given: Given[System, StepSpecifications], found: Mapping[str, Any]) -> Any:
    """−ζω_n ± ω_n √(ζ² − 1)."""
    zeta, omega = found["damping_ratio"], found["natural_frequency"]
    apart = omega * sp.sqrt(zeta**2 - 1)
    return [-zeta * omega + apart, -zeta * omega - apart]


@desired_poles.consequence("polynomial", of=("damping_ratio", "natural_frequency"))
def polynomial_of_damping_and_frequency(_given: Given[System, StepSpecifications], found: Mapping[str, Any]) -> Any:
    """s² + 2ζω_n s + ω_n²."""
    s, zeta, omega = sp.Symbol("s"), found["damping_ratio"], found["natural_frequency"]
    return s**2 + 2 * zeta * omega * s + omega**2


@desired_poles.consequence("polynomial", of=("poles",))
def polynomial_of_the_poles(_given: Given[System, StepSpecifications], found: Mapping[str, Any]) -> Any:
    """Π(s − p)."""
    return sp.expand(sp.Mul(*(sp.Symbol("s") - pole for pole in found["poles"])))


ROUNDED = 0.01
"""What poles in rounded numbers may change in a specification."""


@desired_poles.meaning("poles")
def step_response_of_the_poles(wrong: Attempt[System, StepSpecifications]) -> Reason | None:
    """The first specification that the poles do not meet, and what it is with them."""
    if len(wrong.value) != 2:
        return None
    total, omega = -sp.Add(*wrong.value), sp.sqrt(sp.Mul(*wrong.value))
    for name, asked in specified(wrong.given.options).items():
        found = exact.specified(name, total / (2 * omega), omega, band(wrong.given.options))
        if abs(complex(found - asked)) > ROUNDED * abs(complex(asked)):
            return Reason("meanings/step_response", {"name": name, "found": short(found), "wanted": short(asked)})
    return None
