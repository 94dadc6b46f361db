"""What the three tasks of compensators have in common: their answers, and how they are judged."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Given, Task
from solver.lazy import numeric
from solver.numeric.judges import compensators as judges
from solver.tasks.compensators.plants import loop_of
from solver.tasks.compensators.specifications import LETTERS, CompensatorOptions, accuracy
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.systems import OpenLoop

EARNED = ("gain", "margins", "attempts", "section", "crossing", "free_gain", "check")
TOGETHER = "it is judged together with the controller"
NEAR = 4e-10


def is_any_gain(given: Given[Any, CompensatorOptions]) -> bool:
    """Whether nothing fixes the gain."""
    return accuracy(given.options) is None or given.method == "root_locus"


def answers_of(several: bool) -> list[AnswerName]:
    """Return the answers of a task; of `several` sections T and α are lists, those of the lead first."""
    zero = "the time constants of the zeros, lead first" if several else "the time constant of the zero"
    ratio = "the ratios of zero and pole, lead first" if several else "the ratio of zero and pole"
    return [
        AnswerName("controller", "C(s)", "the compensator", free=True, principal=True, earned=EARNED),
        AnswerName(
            "K",
            "K",
            "the gain of the compensator at $s = 0$",
            free=is_any_gain,
            principal=True,
            earned=("gain", "free_gain"),
        ),
        AnswerName("T", "T", zero, free=True, ordered=True, unit="s", earned=EARNED),
        AnswerName("alpha", r"\alpha", ratio, free=True, ordered=True, earned=EARNED),
        AnswerName(
            "phase_margin",
            r"\mathrm{PM}",
            "the phase margin of the loop, in degrees",
            free=True,
            unit="°",
            earned=("check",),
        ),
        AnswerName(
            "gain_crossover", r"\omega_g", "the gain crossover of the loop", free=True, unit="rad/s", earned=("check",)
        ),
        AnswerName("error", r"e_{\infty}", "the error after a unit step", optional=True, free=True, earned=("check",)),
    ]


def judged_by(task: Task[Any, CompensatorOptions], kind: str) -> None:
    """Register the judge of a task: any compensator of the kind ("lead", "lag", "lead_lag") that does what is asked."""
    names = ("controller", "K", "T", "alpha", "phase_margin", "gain_crossover", "error")

    def does_what_is_asked(given: Given[Any, CompensatorOptions], answers: Answers) -> Iterable[Check]:
        """The specifications in numbers, and the other answers as those of the compensator."""
        yield from checks_of(given, answers, kind)

    task.verification(*names)(does_what_is_asked)


def checks_of(given: Given[Any, CompensatorOptions], answers: Answers, kind: str) -> Iterable[Check]:
    """Yield the checks of some answers."""
    question = _question(given, kind)
    controller = answers.get("controller")
    if controller is None and all(name in answers for name in ("K", "T", "alpha")):
        controller = judges.controller_from(answers["K"], answers["T"], answers["alpha"], question.variable)
    if controller is None:
        yield from _without_controller(question, answers)
        return
    made = tuple(name for name in ("controller", "K", "T", "alpha") if name in answers)
    for label, oracle, holds in judges.faults_of(question, controller):
        for name in made if "controller" not in answers else ("controller",):
            yield Check.that(label, oracle, holds, answer=name)
    for name, value in answers.items():
        if name != "controller":
            yield numeric.check_residual(
                Phrase("{name} is that of the compensator", name=name),
                "numpy.roots",
                lambda name=name, value=value: judges.compensator_residual(question, controller, name, value),  # type: ignore[misc]  # bound here
                NEAR,
                answer=name,
            )


def _without_controller(question: judges.CompensatorQuestion, answers: Answers) -> Iterable[Check]:
    """Only the least gain can be judged alone."""
    for name, value in answers.items():
        if name == "K" and question.accuracy is not None and question.method != "root_locus":
            yield numeric.check_residual(
                "the least gain that the error allows",
                "numpy.polyval",
                lambda value=value: judges.least_gain_residual(question, value),  # type: ignore[misc]  # bound here
                NEAR,
                answer=name,
            )
        elif name == "gain_crossover" and question.crossover is not None:
            near = judges.is_the_crossover(question, value)
            yield Check.that("the gain crossover is the one asked for", "compared", near, answer=name)
        elif name in ("T", "alpha") and not judges.fits_the_sections(question, value):
            yield Check.that("a value for each section", "counted", False, answer=name)
        else:
            yield Check.skipped(name, "numpy.roots", TOGETHER, answer=name)


def _question(given: Given[Any, CompensatorOptions], kind: str) -> judges.CompensatorQuestion:
    options, G = given.options, _loop(given.system)
    method = given.method or "frequency_response"
    asked = accuracy(options)
    of_bode = method == "frequency_response"
    return judges.CompensatorQuestion(
        kind,
        method,
        G.numerator,
        G.denominator,
        G.variable,
        G.delay,
        asked and (asked[0], asked[1]),
        options.phase_margin if of_bode else None,
        options.crossover if of_bode else None,
        None if of_bode else tuple(options.poles),
    )


def _loop(system: Any) -> OpenLoop:
    return loop_of(system)


__all__ = ["EARNED", "LETTERS", "answers_of", "checks_of", "judged_by"]
