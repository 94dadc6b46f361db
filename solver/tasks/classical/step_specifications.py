"""Rise time, peak time, overshoot and settling time of a step response: by the formulas of second order, or from y."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Task, Unsolved, option
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import classical as judges
from solver.options.choice import Choice
from solver.tasks.classical import step_mistakes
from solver.tasks.classical.paths import Path, numbers_of, path_of
from solver.tasks.classical.sampled_measures import sampled
from solver.tasks.classical.step_formulas import BANDS, by_second_order
from solver.tasks.classical.step_measures import measured
from solver.tasks.mistakes import OPEN_LOOP, not_closed
from solver.tasks.plant_options import LoopOptions

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.classical.paths import Plant


@dataclass(frozen=True, kw_only=True)
class StepOptions(LoopOptions):
    """What is meant by settled and by risen."""

    settling_band: str = option(
        Choice(("2%", "5%")), "the band about the final value in which the response stays", conventions=("5%",)
    )
    rise: str = option(
        Choice(("0-100", "10-90")), "the shares of the final value between which it rises, in %", conventions=("10-90",)
    )
    overshoot_in: str = option(
        Choice(("fraction", "percent")), "whether the overshoot is a fraction or in %", conventions=("percent",)
    )

    @property
    def band(self) -> Any:
        """The half width of the band, as a fraction."""
        return sp.Rational(5 if self.settling_band == "5%" else 2, 100)

    @property
    def whole(self) -> bool:
        """Whether the rise is asked for from 0 to 100 %."""
        return self.rise == "0-100"


step_specifications: Task[Plant, StepOptions] = Task(
    "step_specifications",
    title="Specifications of the step response",
    doc="Rise time, peak time, overshoot, settling time and final value of the response to a unit step.",
    needs=("path",),
    options=StepOptions,
    answers=[
        AnswerName(
            "rise_time", r"\sym{rise_time}", "the rise time", unit="s", principal=True,
            earned=("standard", "samples", "rise"),
        ),
        AnswerName(
            "peak_time", r"\sym{peak_time}", "the peak time", optional=True, unit="s", principal=True, earned=("peak",)
        ),
        AnswerName(
            "overshoot", r"\sym{overshoot}", "the overshoot, a fraction of the final value", principal=True,
            earned=("overshoot", "peak"),
        ),
        AnswerName(
            "settling_time", r"\sym{settling_time}", "the settling time", unit="s", principal=True,
            earned=("samples", "settling"),
        ),
        AnswerName("final_value", r"y_{\infty}", "the final value", earned=("standard", "final")),
    ],
    example={"transfer_function": "4/(s^2 + 2s + 4)"},
)  # fmt: skip
step_mistakes.register(step_specifications)


@step_specifications.method(
    "formulas", title="Formulas of second order", source="Ogata, Modern Control Engineering, section 5-3",
    time="continuous",
)  # fmt: skip
def by_formulas(given: Given[Plant, StepOptions]) -> Derivation[Answers]:
    """The formulas of k ω_n²/(s² + 2ζω_n s + ω_n²) with 0 < ζ < 1."""
    path = yield from path_of(given)
    found = yield from by_second_order(path, given.options)
    return _in_unit(found, given.options)


@step_specifications.method(
    "response", title="The response itself", source="Ogata, Modern Control Engineering, section 5-3"
)
def by_response(given: Given[Plant, StepOptions]) -> Derivation[Answers]:
    """Where y has a slope of zero, and where it reaches the levels that the specifications name; at samples of y(k)."""
    path = yield from path_of(given)
    settles(path)
    found = yield from (sampled if path.discrete else measured)(path, given.options)
    return _in_unit(found, given.options)


def _in_unit(found: Answers, options: StepOptions) -> Answers:
    """The overshoot in % where that is asked for."""
    if options.overshoot_in == "percent":
        found["overshoot"] = 100 * found["overshoot"]
    return found


def settles(path: Path) -> None:
    """Raise Unsolved where the response has parameters, or does not settle at a value other than zero."""
    if path.parameters:
        raise Unsolved("step_specifications/parameters", names=list(path.parameters), discrete=path.discrete)
    outside = [pole for pole in path.fraction.poles or [] if not _inside(pole, discrete=path.discrete)]
    if outside:
        raise Unsolved("step_specifications/unstable", poles=outside, discrete=path.discrete)
    if sp.expand(path.top.subs(path.variable, path.rest)) == 0:
        raise Unsolved("step_specifications/no_final_value", discrete=path.discrete)


def _inside(pole: Expr, *, discrete: bool) -> bool:
    """Whether the mode of a pole dies out."""
    real, imaginary = pole.as_real_imag()
    distance = sp.expand(real**2 + imaginary**2) - 1 if discrete else real
    return bool(exact.sign_of(distance) == -1)


@step_specifications.verification("rise_time", "peak_time", "overshoot", "settling_time", "final_value")
def are_seen_in_the_response(given: Given[Plant, StepOptions], answers: Answers) -> Iterable[Check]:
    """The response by matrix exponentials, searched and refined; of a discrete system by its recursion."""
    options, plant = given.options, given.system
    formula = BANDS[options.settling_band] if given.method == "formulas" else None
    period = (plant.sample_time or sp.Integer(1)) if plant.discrete else None
    asked = judges.Specification(getattr(plant, "delay", sp.Integer(0)), options.band, options.whole, formula, period)
    numbers = numbers_of(plant)
    for name in ("rise_time", "peak_time", "overshoot", "settling_time", "final_value"):
        if name not in answers:
            continue
        percent = name == "overshoot" and options.overshoot_in == "percent"
        value = answers[name] / 100 if percent else answers[name]
        check = partial(judges.specification_residual, numbers, asked, name, value)
        oracle = "the recursion (50 digits)" if plant.discrete else "scipy.linalg.expm, refined by mpmath"
        yield numeric.check_residual(LABELS[name], oracle, check, answer=name)


LABELS = {
    "rise_time": "the rise of the response",
    "peak_time": "the time of its largest value",
    "overshoot": "its largest value",
    "settling_time": "when it is settled",
    "final_value": "where it settles",
}


step_specifications.mistaken_question(OPEN_LOOP)(not_closed)
