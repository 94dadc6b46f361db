"""Usual mistakes with frequency responses: units, logarithms, the open loop, the sign of the phase."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from solver.derivation import Task
    from solver.systems import OpenLoop, System
    from solver.tasks.frequency.frequency_response import ResponseOptions

    Wrong = Attempt[OpenLoop, ResponseOptions]

RADIANS = Slip("radians", "the angle is in radians; degrees are asked for")
SIGN = Slip("phase_sign", "the sign of the phase is reversed")
DECIBELS = Slip("decibels", "this is the magnitude in dB; the ratio is asked for")
SQUARED = Slip("squared", "this is $|T|^2$; the root is missing")
HERTZ = Slip("hertz", "the frequency is in Hz; rad/s are asked for")
OPEN_LOOP = Slip("open_loop", "this is the answer of the open loop")


def register(task: Task[OpenLoop, ResponseOptions]) -> None:
    """Register what goes wrong."""
    task.mistake(RADIANS, "phase", "resonant_phase")(in_radians)
    task.mistake(SIGN, "phase", "resonant_phase")(reversed_sign)
    task.mistake(DECIBELS, "magnitude", "resonant_peak")(in_decibels)
    task.mistake(SQUARED, "magnitude", "resonant_peak")(squared)
    task.mistake(HERTZ, "resonant_frequency", "bandwidth")(in_hertz)
    task.mistaken_question(OPEN_LOOP)(without_feedback)


def in_radians(wrong: Wrong) -> Iterable[Any]:
    """The angle times π/180."""
    yield sp.expand(wrong.ours * sp.pi / 180) if not wrong.ours.is_number else sp.N(wrong.ours * sp.pi / 180, 30)


def reversed_sign(wrong: Wrong) -> Iterable[Any]:
    """−φ."""
    yield -wrong.ours


def in_decibels(wrong: Wrong) -> Iterable[Any]:
    """20 log₁₀ |T|."""
    if wrong.ours.is_number:
        yield exact.in_decibels(wrong.ours)


def squared(wrong: Wrong) -> Iterable[Any]:
    """|T|²."""
    yield sp.expand(wrong.ours**2)


def in_hertz(wrong: Wrong) -> Iterable[Any]:
    """The frequency over 2π."""
    yield sp.N(wrong.ours / (2 * sp.pi), 30)


def without_feedback(system: System, options: ResponseOptions) -> tuple[System, ResponseOptions] | None:
    """C G in place of C G/(1 + C G H)."""
    return None if options.feedback is None else (system, replace(options, feedback=None))


__all__ = ["register"]
