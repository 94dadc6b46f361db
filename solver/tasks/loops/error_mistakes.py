"""Usual mistakes with errors that remain, and what follows from the constants of a loop."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.loops.error_signals import acting_on
from solver.words import Reason

if TYPE_CHECKING:
    from solver.derivation import Given, Task

OPEN_LOOP = Slip("open_loop", "it is the error without feedback, of $r - CG\\,r$")
CLOSED_LOOP = Slip("closed_loop", "it is the error with unity feedback")
OUTPUT = Slip("output", "it is what remains of the output, not of the error")
WITHOUT_ONE = Slip("without_one", "the $1$ of $\\frac{1}{1 + K_p}$ is missing")
CONSTANT = Slip("constant", "it is the error constant, not the error")
AT_ZERO = Slip(
    "at_zero", "the limit is taken for $z \\to 0$; what is constant in the long run belongs to $z = 1$, as to $s = 0$"
)
NO_PERIOD = Slip("no_period", "the sampling period is missing: $K_v$ is $\\lim (z - 1)L/T$, $K_a$ has $T^{2}$ below")
OF_CLOSED_LOOP = Slip("of_closed_loop", "it is counted of the closed loop; the type and the constants are those of $L$")


def register(task: Task[Any, Any]) -> None:
    """Register what goes wrong."""

    @task.mistaken_question(OPEN_LOOP)
    def without_feedback(system: Any, options: Any) -> tuple[Any, Any] | None:
        return None if options.feedback != 1 else (system, replace(options, feedback=None))

    @task.mistaken_question(CLOSED_LOOP)
    def with_feedback(system: Any, options: Any) -> tuple[Any, Any] | None:
        return None if options.feedback is not None else (system, replace(options, feedback=sp.S.One))

    @task.mistake(OUTPUT, "error")
    def output(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        acting = acting_on(wrong.given)
        if not acting.r.has(acting.time) and wrong.ours.is_finite:
            yield acting.r - wrong.ours

    @task.mistake(WITHOUT_ONE, "error")
    def without_one(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        acting, loop = acting_on(wrong.given), wrong.given.system
        r, K = acting.r, _constants(loop)[0]
        if not r.has(acting.time) and loop.closed and loop.H == 1 and K is not None and K.is_finite and K != 0:
            yield r / K

    @task.mistake(CONSTANT, "error")
    def the_constant(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        yield from (K for K in _constants(wrong.given.system) if K is not None and K.is_finite and K != 0)

    @task.mistake(OF_CLOSED_LOOP, "position_constant", "velocity_constant", "acceleration_constant")
    def of_closed_loop(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        found = _of_closed_loop(wrong.given.system)
        yield from (K for K in found.constants if K is not None) if found else ()

    _of_samples(task)
    _told_by_others(task)


def _of_samples(task: Task[Any, Any]) -> None:
    """What goes wrong with discrete loops."""

    @task.mistake(AT_ZERO, "error", "position_constant", "velocity_constant", "acceleration_constant")
    def at_zero(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        yield from _at_zero(wrong)

    @task.mistake(NO_PERIOD, "error", "velocity_constant", "acceleration_constant")
    def without_period(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        T = wrong.given.system.sample_time
        if T is not None and wrong.ours.is_finite and wrong.ours != 0:
            powers = {"velocity_constant": (1,), "acceleration_constant": (2,)}.get(wrong.name, (-1, -2))
            yield from (wrong.ours * T**n for n in powers)


def _told_by_others(task: Task[Any, Any]) -> None:
    """What a type counted elsewhere means, and the error that a constant tells."""

    @task.meaning("system_type")
    def counted_elsewhere(wrong: Attempt[Any, Any]) -> Reason | None:
        found = _of_closed_loop(wrong.given.system)
        counted = found is not None and found.integrators == wrong.value != wrong.ours
        return Reason("steady_state_error/type_of_closed_loop", {"n": found.integrators}) if counted else None

    @task.consequence("error", of=("position_constant",), symbolic=False)
    def by_position(given: Given[Any, Any], found: Mapping[str, Any]) -> Any:
        return _told_by(given, 0, found["position_constant"])

    @task.consequence("error", of=("velocity_constant",), symbolic=False)
    def by_velocity(given: Given[Any, Any], found: Mapping[str, Any]) -> Any:
        return _told_by(given, 1, found["velocity_constant"])

    @task.consequence("error", of=("acceleration_constant",), symbolic=False)
    def by_acceleration(given: Given[Any, Any], found: Mapping[str, Any]) -> Any:
        return _told_by(given, 2, found["acceleration_constant"])


def _constants(loop: Any) -> tuple[Any, ...]:
    """K_p, K_v, K_a."""
    found = exact.error_constants(
        loop.numerator, loop.denominator, loop.variable, discrete=loop.discrete, period=loop.sample_time
    )
    constants: tuple[Any, ...] = found.constants
    return constants


def _at_zero(wrong: Attempt[Any, Any]) -> Iterable[Any]:
    """Limits of a discrete loop as if z were s: those of zⁿ L, of the error to a step 1/(1 + L(0))."""
    loop, acting = wrong.given.system, acting_on(wrong.given)
    if not loop.discrete:
        return
    z = loop.variable
    if wrong.name != "error":
        found = exact.error_constants(loop.numerator, loop.denominator, z)
        yield from (K for K in found.limits if K is not None)
    elif loop.closed and loop.H == 1 and not acting.r.has(acting.time):
        above, below = sp.fraction(exact.rational(loop.denominator / (loop.denominator + loop.numerator)))
        if below.subs(z, 0) != 0:
            yield acting.r * above.subs(z, 0) / below.subs(z, 0)


def _of_closed_loop(loop: Any) -> Any:
    """What the closed loop would have for error constants; None where the loop is not closed."""
    if not loop.closed:
        return None
    return exact.error_constants(
        loop.numerator,
        loop.numerator + loop.denominator,
        loop.variable,
        discrete=loop.discrete,
        period=loop.sample_time,
    )


def _told_by(given: Given[Any, Any], n: int, K: Any) -> Any:
    """The error that a constant tells: with unity feedback, of a reference that is a multiple of tⁿ alone."""
    loop, options = given.system, given.options
    parts = acting_on(given).parts
    if (
        parts is None
        or [m for m, c in enumerate(parts) if c != 0] != [n]
        or not loop.closed
        or loop.H != 1
        or options.disturbance not in (None, 0)
    ):
        return None
    below = K + 1 if n == 0 else K
    return sp.oo if below == 0 else sp.S.Zero if below in (sp.oo, -sp.oo) else parts[n] / below
