"""The program of an analog computer for linear equations: its elements with their settings, and how it is patched."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Task, Unsolved, option
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.options.expression_list import ExpressionList
from solver.tasks.analog import program_checks as checks
from solver.tasks.analog import program_mistakes
from solver.tasks.analog.machine_form import form_of
from solver.tasks.analog.machine_options import MachineOptions, faults_of
from solver.tasks.analog.program_steps import overload_of, patched
from solver.tasks.analog.scaled_program import Machine, scaled_for_machine
from solver.words import Reason

if TYPE_CHECKING:
    from solver.patches import Program
    from solver.systems import Equations, System

GAINS = (1, 10)


@dataclass(frozen=True, kw_only=True)
class ProgramOptions(MachineOptions):
    """How the problem is put on the machine, and what the machine has."""

    gains: Any = option(ExpressionList(), "the gains of the inputs of the machine's amplifiers", default=[1, 10])

    @property
    def amplifications(self) -> list[Any]:
        """The gains, also where they are the usual ones."""
        return [sp.Integer(gain) if isinstance(gain, int) else gain for gain in self.gains or GAINS]


analog_program: Task[Equations, ProgramOptions] = Task(
    "analog_program",
    title="Program of an analog computer",
    doc="The program that computes linear equations on an analog computer, with as few amplifiers as possible.",
    needs=("machine",),
    options=ProgramOptions,
    example={"equations": "[\"x'' + 8 x' + 25 x = 500\"]", "initial": "{x: 40}"},
    answers=[
        AnswerName("potentiometers", r"\text{potentiometers}", "the setting of each potentiometer, by its name",
                   free=True, principal=True, earned=("settings",)),
        AnswerName("program", r"\text{program}", "the elements, what feeds them, and what is read out", free=True,
                   principal=True, earned=("signs", "program")),
        AnswerName("overload_time", "t", "when a variable first exceeds its maximum, in t", optional=True,
                   earned=("overload",)),
    ],
)  # fmt: skip
program_mistakes.register(analog_program)


@analog_program.refusal
def wrong_question(system: System, options: ProgramOptions) -> Iterable[tuple[str, Reason]]:
    """Names, maxima and initial values that do not fit, and gains that no amplifier has."""
    yield from (each for each in faults_of(system, options) if each[1].kind != "machines/no_function")
    if not all(gain.is_positive for gain in options.amplifications):
        yield "gains", Reason("analog_program/gains")


@analog_program.method(time="continuous", source="Jackson, Analog Computation, chapters 2 and 3")
def by_integrators(given: Given[Equations, ProgramOptions]) -> Derivation[Answers]:
    """An integrator for each state in volts, each coefficient as gain times setting, each sign carried if it can be."""
    model, options = given.system, given.options
    equations = yield from form_of(given)
    machine = yield from scaled_for_machine(model, equations, options)
    try:
        found = exact.synthesized(machine.scaled, machine.readout, options.amplifications, machine.reference)
    except exact.TooLarge as case:
        raise _too_large(case, machine) from None
    except exact.NoBound as case:
        raise Unsolved("analog_program/no_bound", function=case.function) from None
    yield from patched(found, machine)
    answers = Answers(potentiometers=settings_of(found.program), program=found.program)
    overload = yield from overload_of(equations, machine)
    if overload is not None:
        answers["overload_time"] = overload
    return answers


def settings_of(program: Program) -> dict[Any, Any]:
    """The setting of each potentiometer, by its symbol."""
    return {sp.Symbol(name): setting for name, setting in program.potentiometers.items()}


def _too_large(case: exact.TooLarge, machine: Machine) -> Unsolved:
    """What to change where a coefficient is too large: a slower machine, for a sum other maxima."""
    integrated = any(each.variable == case.variable for each in machine.scaled.integrated)
    most = case.inputs * case.most
    slower = _slow_enough(machine, most) if integrated else None
    return Unsolved(
        "analog_program/too_large",
        variable=case.variable,
        term=case.term,
        coefficient=case.coefficient,
        gain=case.most,
        most=most,
        inputs=case.inputs,
        slower=slower,
    )


def _slow_enough(machine: Machine, most: Any) -> Any:
    """The least whole β with which no coefficient of an integrator is too large; of a constant the source counts."""
    sizes = [
        abs(c) / (machine.reference if term == 1 else 1)
        for each in machine.scaled.integrated
        for term, c in each.terms.items()
    ]
    return sp.ceiling(machine.beta * sp.Max(*sizes) / most)


@analog_program.verification("program", "potentiometers")
def computes_the_equations(given: Given[Equations, ProgramOptions], answers: Answers) -> Iterable[Check]:
    """The program is simulated as it is patched, and compared with the question's own equations."""
    if "program" in answers:
        yield from checks.of_program(given, answers["program"])
    if "potentiometers" in answers:
        yield from checks.of_potentiometers(given, answers)


@analog_program.verification("overload_time")
def is_when_the_range_is_left(given: Given[Equations, ProgramOptions], answers: Answers) -> Iterable[Check]:
    """At that time a variable is at its maximum, and none is beyond before."""
    yield from checks.of_overload(given, answers["overload_time"])


@analog_program.consequence("potentiometers", of=("program",))
def potentiometers_of(given: Given[Equations, ProgramOptions], found: Mapping[str, Any]) -> Any:  # noqa: ARG001 - the program tells them
    """Those of the program."""
    return settings_of(found["program"])
