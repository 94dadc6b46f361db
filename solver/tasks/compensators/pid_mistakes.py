"""What goes wrong where a PID controller is tuned, and what follows from what."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Given, Slip, Task
from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from solver.tasks.compensators.pid_options import PidOptions

TIMES = Slip("times_for_gains", "this is the time $T_i$ or $T_d$, not the gain $K_i = K_p/T_i$ or $K_d = K_p T_d$")
FREQUENCY = Slip("frequency_for_period", r"the frequency $\omega_u$ stands where the period $2\pi/\omega_u$ belongs")
ULTIMATE = Slip("ultimate_for_gain", "this is the ultimate gain itself; the table takes a part of it")
ROW = Slip("other_row", "this is from the row of another kind of controller")

Tuning = Attempt[Any, "PidOptions"]


def register(task: Task[Any, PidOptions]) -> None:
    """Register the usual mistakes of the task, and which answers follow from others."""
    task.mistake(TIMES, "K_i", "K_d")(times_for_gains)
    task.mistake(FREQUENCY, "T_u")(frequency_for_period)
    task.mistake(FREQUENCY, "K_i", "K_d")(gains_of_the_frequency)
    task.mistake(ULTIMATE, "K_p")(the_ultimate_gain)
    task.mistake(ROW, "K_p", "K_i", "K_d")(of_another_row)
    task.consequence("controller", of=("K_p", "K_i", "K_d"))(controller_of_gains)
    task.consequence("K_p", of=("K_u",))(gain_of_the_ultimate)
    task.consequence("K_i", of=("K_p", "T_u"))(integral_of_the_period)
    task.consequence("K_d", of=("K_p", "T_u"))(derivative_of_the_period)


def times_for_gains(wrong: Tuning) -> Iterable[Any]:
    """T_i for K_i, T_d for K_d."""
    K_p = wrong.answers["K_p"]
    if wrong.ours != 0:
        yield K_p / wrong.ours if wrong.name == "K_i" else wrong.ours / K_p


def frequency_for_period(wrong: Tuning) -> Iterable[Any]:
    """ω_u for T_u."""
    yield 2 * sp.pi / wrong.ours


def gains_of_the_frequency(wrong: Tuning) -> Iterable[Any]:
    """The row of the table with ω_u for T_u."""
    T = wrong.answers.get("T_u")
    if T is not None and wrong.ours != 0:
        factor = 2 * sp.pi / T**2
        yield wrong.ours / factor if wrong.name == "K_i" else wrong.ours * factor


def the_ultimate_gain(wrong: Tuning) -> Iterable[Any]:
    """K_u for K_p."""
    if "K_u" in wrong.answers:
        yield wrong.answers["K_u"]


def of_another_row(wrong: Tuning) -> Iterable[Any]:
    """The gain by the rules for the other kinds of controllers."""
    of = _table(wrong.given)
    if of is None:
        return
    own = exact.tuning_rules(of)[wrong.given.options.controller_type]
    gain = wrong.answers["K_p"] / own.gain
    if own.integral is not None:
        time = wrong.answers["K_p"] / wrong.answers["K_i"] / own.integral
    elif wrong.answers.get("T_u") is not None:
        time = wrong.answers["T_u"]
    else:
        return
    for kind, rule in exact.tuning_rules(of).items():
        if kind != wrong.given.options.controller_type:
            gains = dict(zip(("K_p", "K_i", "K_d"), exact.tuned(rule, gain, time).gains, strict=True))
            if gains[wrong.name] != 0:
                yield gains[wrong.name]


def _table(given: Given[Any, PidOptions]) -> str | None:
    """The table that the method uses."""
    return {"ziegler_nichols_ultimate": "ultimate", "ziegler_nichols_step": "step"}.get(given.method)


def controller_of_gains(_given: Given[Any, PidOptions], found: Mapping[str, Any]) -> Any:
    """K_p + K_i/s + K_d s."""
    s = sp.Symbol("s")
    return found["K_p"] + found["K_i"] / s + found["K_d"] * s


def gain_of_the_ultimate(given: Given[Any, PidOptions], found: Mapping[str, Any]) -> Any:
    """The part of K_u that the table takes."""
    if _table(given) != "ultimate":
        return None
    return exact.tuning_rules("ultimate")[given.options.controller_type].gain * found["K_u"]


def integral_of_the_period(given: Given[Any, PidOptions], found: Mapping[str, Any]) -> Any:
    """K_p over T_i, a part of T_u."""
    rule = exact.tuning_rules("ultimate")[given.options.controller_type]
    if _table(given) != "ultimate" or rule.integral is None:
        return None
    return found["K_p"] / (rule.integral * found["T_u"])


def derivative_of_the_period(given: Given[Any, PidOptions], found: Mapping[str, Any]) -> Any:
    """K_p times T_d, a part of T_u."""
    rule = exact.tuning_rules("ultimate")[given.options.controller_type]
    if _table(given) != "ultimate" or rule.derivative is None:
        return None
    return found["K_p"] * rule.derivative * found["T_u"]
