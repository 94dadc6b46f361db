"""When a variable of machine equations first exceeds a given size: exactly of one exponential, else in decimals.

The motion is known in closed form; it is sampled densely enough for every mode, and the first interval at whose end it
is too large is halved in exact arithmetic of many digits.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import reduce
from operator import mul
from typing import Any

import numpy as np
import sympy as sp

from solver.exact.analog.machine_equations import TIME, MachineEquations
from solver.exact.analog.maxima import motions_of

STEP, LONG, MOST = 0.25, 12.0, 20_000
"""The time between samples, and that after which a mode is gone, in time constants; more samples are not taken."""
BEYOND = 1e-9
"""A size may be reached: by that much, relatively, it must be exceeded."""
UNDAMPED, LATER = 60, 280
"""Time constants of what does not decay are so much longer; and samples after all, each 5 % later."""
LATEST = 30.0
"""What grows is followed until it has grown by e to this."""
SEEN = 1e-7
"""A multiple eigenvalue 0 is found as different ones, relatively so large."""
NEAR = 0.95
"""A sample of that share of the size may have a peak beside it that exceeds it."""
DIGITS, HALVED, NEWTON = 40, 46, 3
FUNCTIONS: dict[str, Callable[..., Any]] = {
    "exp": np.exp, "sin": np.sin, "cos": np.cos, "sinh": np.sinh, "cosh": np.cosh,
    "Heaviside": lambda x, *_: np.where(np.real(x) > 0, 1.0, 0.0), "Add": lambda *parts: sum(parts),
    "Mul": lambda *parts: reduce(mul, parts),
}  # fmt: skip


def first_overload(
    equations: MachineEquations, maxima: Mapping[sp.Symbol, sp.Expr]
) -> tuple[sp.Symbol, sp.Expr, sp.Expr] | None:
    """Return the variable that first exceeds its maximum, when, and its motion; None if none does. Raises NotExact."""
    motions = motions_of(equations)
    times = np.array(list(_times(_rates(equations))))
    found = []
    for x, maximum in maxima.items():
        time = first_passage(motions[x], maximum, times) if x in motions and maximum != 0 else None
        if time is not None:
            found.append((float(time), x, time, motions[x]))
    if not found:
        return None
    _, x, time, motion = min(found, key=lambda each: each[0])
    return x, time, motion


def first_passage(motion: sp.Expr, maximum: sp.Expr, times: Any) -> sp.Expr | None:
    """Return the first t > 0 from which on |motion| > maximum, seen at the times; None if there is none."""
    value = _compiled(motion)
    limit = float(maximum)

    def size(at: Any) -> Any:
        with np.errstate(all="ignore"):  # what grows may overflow
            return np.broadcast_to(np.abs(np.real(value(at))) / limit, np.shape(at))

    ends = _first_interval(size, times)
    if ends is None:
        return None
    exact = _in_closed_form(motion, maximum)
    near = next((each for each in exact if abs(float(each) - ends[1]) <= 2 * (ends[1] - ends[0]) + 1e-9), None)
    return near if near is not None else _refined(motion, maximum, ends)


def _rates(equations: MachineEquations) -> list[complex]:
    """The eigenvalues, and how fast the inputs change: the factors of t within their functions, 1/T of a beginning."""
    X = [each.variable for each in equations.integrated]
    A = np.array([[complex(each.terms.get(x, 0)) for x in X] for each in equations.integrated])
    found = [complex(each) for each in np.linalg.eigvals(A)]
    functions = {term for each in equations.integrated for term in each.terms if term.has(TIME)}
    for each in set().union(*(function.atoms(sp.Function) for function in functions)):
        shift, there = (complex(each.args[0].xreplace({TIME: sp.Integer(t)})) for t in (0, 1))
        slope = there - shift
        found.append(slope * 1j if isinstance(each, sp.sin | sp.cos) else slope)
        found.append(slope / shift if shift else 0.0)
    largest = max(map(abs, found), default=0.0)
    return [each for each in found if abs(each) > SEEN * largest]


def _first_interval(size: Callable[[Any], Any], times: Any) -> tuple[float, float] | None:
    """Two times between which the size first exceeds 1."""
    sizes = size(times)
    beyond = np.flatnonzero(sizes > 1 + BEYOND)
    last = int(beyond[0]) if len(beyond) else len(times)
    tops = np.flatnonzero((sizes[1:-1] > sizes[:-2]) & (sizes[1:-1] > sizes[2:]) & (sizes[1:-1] > NEAR)) + 1
    for i in tops[tops < last]:
        fine = np.linspace(times[i - 1], times[i + 1], 81)
        over = np.flatnonzero(size(fine) > 1 + BEYOND)
        if len(over):
            return float(fine[over[0] - 1]), float(fine[over[0]])
    return (float(times[last - 1]), float(times[last])) if 0 < last < len(times) else None


def _times(rates: Sequence[complex]) -> Iterator[float]:
    """Samples that follow the fastest mode that is still there; later ones, for what grows like a power of t."""
    slow = [abs(each.real) if abs(each.real) > SEEN * abs(each) else abs(each) / UNDAMPED for each in rates]
    grown = max((each.real for each in rates), default=0.0)
    end = max(LONG / min(slow, default=1.0), LATEST / grown if grown > 0 else 0.0)
    time, count = 0.0, 0
    while time < end and count < MOST:
        yield time
        left = [abs(each) for each in rates if each.real * time > -LONG]
        time, count = time + STEP / max(left, default=min(slow, default=1.0)), count + 1
    for _ in range(LATER):
        yield time
        time *= 1.05


def _in_closed_form(motion: sp.Expr, maximum: sp.Expr) -> list[sp.Expr]:
    """The times at which a + b e^{rt}, or a + b tᵏ, has the size; empty for another motion."""
    moving = [term for term in sp.Add.make_args(sp.expand(motion)) if term.has(TIME)]
    if len(moving) != 1:
        return []
    rest, (factor, function) = sp.expand(motion) - moving[0], moving[0].as_independent(TIME, as_Add=False)
    levels = [sp.cancel((sign * maximum - rest) / factor) for sign in (1, -1)]
    power = function.as_base_exp()
    if power[0] == TIME:
        return [level ** (1 / power[1]) for level in levels if level > 0]
    if not isinstance(function, sp.exp) or sp.diff(function.args[0], TIME).has(TIME):
        return []
    rate = sp.diff(function.args[0], TIME)
    return [sp.log(1 / level) / -rate if rate.is_negative else sp.log(level) / rate for level in levels if level > 0]


def _refined(motion: sp.Expr, maximum: sp.Expr, ends: tuple[float, float]) -> sp.Expr:
    """The time at which the size is reached, in decimals: halved in doubles, then by Newton's method."""
    value, (low, high) = _compiled(motion), ends
    for _ in range(HALVED):
        middle = (low + high) / 2
        if abs(value(complex(middle)).real) > float(maximum):
            high = middle
        else:
            low = middle
    sign = 1 if value(complex(high)).real > 0 else -1
    slope, time = sp.diff(motion, TIME), sp.Float(repr(high), DIGITS)
    for _ in range(NEWTON if not motion.has(sp.Heaviside) else 0):
        gap, rate = (each.xreplace({TIME: time}).evalf(DIGITS) for each in (motion - sign * maximum, slope))
        time -= gap / rate if rate else 0
    return sp.Float(time, 30)


def _compiled(e: Any) -> Callable[[Any], Any]:
    """A motion as a function of t."""
    if e == TIME:
        return lambda t: t
    if not e.has(TIME):
        number = complex(e.evalf(20))
        return lambda _t: number
    parts: list[Any] = [_compiled(each) for each in e.args]
    if e.is_Pow:
        base, exponent = parts
        return lambda t: base(t) ** exponent(t)
    function = FUNCTIONS[e.func.__name__]
    return lambda t: function(*(part(t) for part in parts))
