"""What acts on a loop whose error is asked for: reference and disturbance as functions of its time."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.options.signal import period
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.derivation import Given, Refusal
    from solver.systems import OpenLoop, System
    from solver.tasks.loops.steady_state_error import ErrorOptions


@dataclass(frozen=True, slots=True)
class Acting:
    """The reference r and the disturbance d, zero without one, in `time`, t or k; `unit` is T, or 1."""

    r: Expr
    d: Expr
    time: Symbol
    unit: Expr

    @property
    def parts(self) -> Any:
        """The reference as a sum of a step, a ramp and a parabola; None where it is none."""
        return exact.usual_parts(self.r, self.time, self.unit)


def acting_on(given: Given[OpenLoop, ErrorOptions]) -> Acting:
    """What acts on the loop of a question, with its sampling period in the usual signals."""
    loop, options = given.system, given.options
    time = sp.Symbol("k" if loop.discrete else "t")
    T = loop.sample_time if loop.discrete and loop.sample_time is not None else sp.S.One
    r, d = (each.xreplace({period(): T}) for each in (options.reference, options.disturbance or sp.S.Zero))
    return Acting(r, d, time, T)


def needs_the_sample_time(system: System, options: ErrorOptions) -> Iterable[Refusal]:
    """A ramp kT needs T."""
    for name in ("reference", "disturbance"):
        signal = getattr(options, name)
        if system.discrete and system.sample_time is None and getattr(signal, "has", lambda _: False)(period()):
            yield name, Reason("steady_state_error/no_sample_time", {"signal": signal})
