"""How programs are judged: patched on the machine of the question, simulated, and compared with its equations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Check, Given
from solver.numeric.judges import analog as judges
from solver.patches import Program, faults_of
from solver.tasks.analog.machine_form import machine_model
from solver.tasks.analog.machine_options import initial_of, states_of
from solver.tasks.modelling.first_order import result_of
from solver.tasks.modelling.questions import question_of
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.systems import Equations
    from solver.tasks.analog.analog_program import ProgramOptions

SIMULATED = "scipy.linalg.expm, step by step"
COMPARED = "numpy.linalg.lstsq"
NEAR = 1e-6
"""What roundings within the digits of a program leave of a comparison."""
SOON = 1e-3
"""How much earlier than its variable an amplifier may seem to overload, in proportion."""
PATCHED = {
    "loop": "every loop has an integrator",
    "setting": "every setting is between 0 and 1",
    "gain": "every gain is one of the machine",
    "reference": "no voltage that is set exceeds the reference",
}


def asked_of(given: Given[Equations, ProgramOptions]) -> judges.Asked:
    """The question as the judge takes it."""
    own, options = given.system, given.options
    initial = initial_of(own, options)
    model = machine_model(own, initial)
    inputs = {name: (options.input or {}).get(name) for name in model.inputs}
    read: dict[str, Any] = {str(model.symbol(jet)): model.symbol(jet) for jet in states_of(model)}
    read |= {name: model.symbol((name, 0)) for name in model.unknowns}
    required = []
    for i, (output, value) in enumerate(zip(own.outputs, model.outputs, strict=True), 1):
        name = _name_of(output, own, i)
        read[name] = value
        required.append(name)
    maxima = {
        str(model.symbol(jet)): value for jet, value in (options.maximum or {}).items() if jet in states_of(model)
    }
    start = initial if model is own else model.initial
    return judges.Asked(question_of(model), start, inputs, read, required, options.beta, options.volts, maxima)


def _name_of(output: Any, model: Equations, i: int) -> str:
    """The name under which an output is read out."""
    if output in model.jets:
        return str(output)
    return "y" if len(model.outputs) == 1 else f"y{i}"


def of_program(given: Given[Equations, ProgramOptions], program: Any) -> Iterator[Check]:
    """It can be patched, computes what is asked, and does not overload before the solution must."""
    if not isinstance(program, Program):
        yield Check.that("it is a program", SIMULATED, False, answer="program")
        return
    wrong = {fault.kind for fault in faults_of(program, given.options.amplifications)}
    for kind, says in PATCHED.items():
        yield Check.that(says, "inspection", kind not in wrong, answer="program")
    if "loop" in wrong:
        return
    asked = asked_of(given)
    fitted = judges.within_digits(asked, program)
    for name, gap in judges.readout_gaps(asked, fitted):
        yield Check.within(Phrase("the motion of {name}", name=name), SIMULATED, gap, NEAR, answer="program")
    freed = judges.freed_gap(asked, fitted)
    if freed is not None:
        says = "whatever the integrators start at, the equations hold"
        yield Check.within(says, COMPARED, freed, NEAR, answer="program")
    if all(value is not None for value in asked.inputs.values()):
        yield _in_range(asked, program)


def _in_range(asked: judges.Asked, program: Program) -> Check:
    """No amplifier leaves its range before a variable exceeds the maximum that is given for it."""
    overload, must = judges.overload_of(asked, program), judges.expected_overload(asked)
    holds = overload is None or (must is not None and overload[1] >= must * (1 - SOON))
    says = "no amplifier overloads" if must is None else "no amplifier overloads before the solution exceeds a maximum"
    return Check.that(says, SIMULATED, holds, answer="program")


def of_potentiometers(given: Given[Equations, ProgramOptions], answers: Answers) -> Iterator[Check]:
    """They are those of the program; by themselves they are put into ours, where the names are the same."""
    settings = {str(name): value for name, value in dict(answers["potentiometers"]).items()}
    if isinstance(answers.get("program"), Program):
        own: Mapping[str, Any] = answers["program"].potentiometers
        same = set(own) == set(settings) and all(own[name] == value for name, value in settings.items())
        yield Check.that("the potentiometers are those of the program", "compared", same, answer="potentiometers")
        return
    from solver.tasks.analog.analog_program import by_integrators  # noqa: PLC0415 - the task imports this file

    program = result_of(by_integrators(given))["program"]
    if set(program.potentiometers) != set(settings):
        why = "the settings tell nothing without the program that they belong to"
        yield Check.skipped("the settings", SIMULATED, why, answer="potentiometers")
        return
    elements = tuple(replace(e, setting=settings[e.id]) if e.kind == "pot" else e for e in program.elements)
    for check in of_program(given, replace(program, elements=elements)):
        yield replace(check, judges=("potentiometers",))


def of_overload(given: Given[Equations, ProgramOptions], time: Any) -> Iterator[Check]:
    """The largest of the variables is at its maximum then, and none was beyond before."""
    residual = judges.overload_residual(asked_of(given), time)
    yield Check.within("a variable reaches its maximum then, and none before", SIMULATED, residual, NEAR)
