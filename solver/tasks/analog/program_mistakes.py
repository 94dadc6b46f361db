"""Usual mistakes with programs: signs, scale factors and the time scale where they do not belong."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.derivation.conversion import converted
from solver.lazy import sympy as sp
from solver.numeric.judges import analog as judges
from solver.patches import Program, algebraic_loop
from solver.tasks.analog.machine_options import initial_of
from solver.tasks.analog.program_checks import asked_of
from solver.tasks.modelling.first_order import result_of
from solver.words import Reason

if TYPE_CHECKING:
    from solver.derivation import Task
    from solver.jets import Jet
    from solver.systems import Equations, System
    from solver.tasks.analog.analog_program import ProgramOptions

START = Slip("initial_sign", "the initial values have the wrong sign: an integrator that gives $-x$ starts at $-x(0)$")
START_IN_TIME = Slip(
    "initial_time", "the time scale is applied to the initial values; these are volts and do not change"
)
NO_TIME = Slip("time_scale", "the time scale is left out: the integrators run as fast as the problem")
FASTER = Slip("time_scale", "the time scale is upside down: the gains of the integrators are multiplied by it")
NO_START = Slip("initial", "the initial values are left out")

TOLD = {
    "readout": Reason("programs/readout"),
    "readout_sign": Reason("programs/readout_sign"),
    "initial": Reason("programs/initial"),
    "input": Reason("programs/input"),
    "setting": Reason("programs/setting"),
}
"""What is said of the one change that would make a program right."""


def register(task: Task[Equations, ProgramOptions]) -> None:
    """Register what goes wrong with programs."""
    task.mistaken_question(START)(started_with_the_other_sign)
    task.mistaken_question(NO_START)(started_at_zero)
    task.mistaken_question(START_IN_TIME)(started_in_machine_time)
    task.mistaken_question(NO_TIME)(without_time_scale)
    task.mistaken_question(FASTER)(with_the_inverse_time_scale)
    task.meaning("program")(changed_once)


def changed_once(attempt: Attempt[Equations, ProgramOptions]) -> Reason | None:
    """The one change with which the program would be right."""
    if not isinstance(attempt.value, Program) or algebraic_loop(attempt.value):
        return None
    repair = judges.repair_of(asked_of(attempt.given), attempt.value)
    return None if repair is None else replace(TOLD[repair[0]], values={"element": repair[1], "fed": repair[2]})


def _started(system: Any, options: ProgramOptions, by: Any) -> tuple[System, ProgramOptions] | None:
    """The question with all initial values multiplied."""
    initial: Mapping[Jet, Any] = initial_of(result_of(converted(system, ["machine"])), options)
    if not any(value != 0 for value in initial.values()):
        return None
    return system, replace(options, initial={jet: by * value for jet, value in initial.items()})


def started_with_the_other_sign(system: System, options: ProgramOptions) -> tuple[System, ProgramOptions] | None:
    """x(0) with the sign of -x(0)."""
    return _started(system, options, -1)


def started_at_zero(system: System, options: ProgramOptions) -> tuple[System, ProgramOptions] | None:
    """All integrators start at 0 V."""
    return _started(system, options, 0)


def started_in_machine_time(system: System, options: ProgramOptions) -> tuple[System, ProgramOptions] | None:
    """The initial values divided by β."""
    return _started(system, options, 1 / options.beta) if options.beta != 1 else None


def without_time_scale(system: System, options: ProgramOptions) -> tuple[System, ProgramOptions] | None:
    """β = 1."""
    return (system, replace(options, time_scale=sp.S.One)) if options.beta != 1 else None


def with_the_inverse_time_scale(system: System, options: ProgramOptions) -> tuple[System, ProgramOptions] | None:
    """1/β."""
    if options.beta == 1:
        return None
    return system, replace(options, time_scale=1 / options.beta)
