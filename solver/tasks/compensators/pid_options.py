"""What a question about a PID controller says, and what is wrong with it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Options, Refusal, option
from solver.lazy import sympy as sp
from solver.lazy import systems
from solver.options.choice import Choice
from solver.options.number import Number
from solver.options.poles import Poles
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

STEP, PLACING = ("ziegler_nichols_step",), ("pole_placement",)


@dataclass(frozen=True, kw_only=True)
class PidOptions(Options):
    """The kind of controller, and what is known beside the plant."""

    controller_type: str = option(Choice(("PID", "PI", "P")), "the terms that the controller has")
    dead_time: Expr | None = option(
        Number(), "L, where the tangent of the measured unit step response meets the time axis", methods=STEP
    )
    slope: Expr | None = option(Number(), "R, the slope of that tangent, in place of a plant", methods=STEP)
    poles: tuple[Expr, ...] = option(Poles(), "all poles of the closed loop", required=True, methods=PLACING)


def is_measured(options: PidOptions) -> bool:
    """Whether a step response is given by its tangent."""
    return options.has("dead_time") or options.has("slope")


def has_plant(system: Any) -> bool:
    """Whether the question has a plant."""
    return not (isinstance(system, systems.StateSpace) and system.bare and system.order == 0)


def number_of_poles(kind: str, numerator: Any, denominator: Any, s: Any) -> int:
    """Return how many poles the loop of a plant and a controller of some kind has."""
    N, D = sp.degree(numerator, s), sp.degree(denominator, s)
    return int(max(D + (kind != "P"), N + {"P": 0, "PI": 1, "PID": 2}[kind]))


def pid_faults(system: Any, options: PidOptions) -> Iterable[Refusal]:
    """No plant and no tangent, half a tangent, values that are not positive."""
    if is_measured(options):
        for name, other in (("dead_time", "slope"), ("slope", "dead_time")):
            if not options.has(name):
                yield other, Reason("pid_tuning/half_a_tangent", {"missing": name, "given": other})
        time = options.dead_time
        if time is not None and (time.is_negative or time.is_zero):
            yield "dead_time", Reason("pid_tuning/not_positive", {"name": "dead_time"})
        if options.slope is not None and options.slope.is_zero:
            yield "slope", Reason("pid_tuning/level_tangent")
    elif not has_plant(system):
        yield "", Reason("pid_tuning/no_plant")
    elif options.poles is not None and isinstance(system, systems.TransferFunction) and system.matrix.shape == (1, 1):
        kind, count = options.controller_type, len(options.poles)
        n = number_of_poles(kind, system.numerators[0][0], system.denominators[0][0], system.variable)
        if count != n:
            yield "poles", Reason("pid_tuning/number_of_poles", {"kind": kind, "n": n, "count": count})
