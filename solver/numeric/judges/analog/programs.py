"""Whether a program computes what is asked: its netlist is simulated beside the question's own equations.

A program is judged by what it computes and not by its likeness to another one. Its numbers may have been rounded: a
decimal of three significant digits or more stands for what is within half a unit of its last digit.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
import sympy as sp
from scipy.optimize import lsq_linear

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.judges.analog.netlists import Netlist, netlist_of, number
from solver.numeric.judges.analog.posed import TIME, Asked, Posed
from solver.numeric.judges.analog.simulation import Signal
from solver.patches import Element, Program

FULL = 1e-3
"""A voltage may touch the reference: by that much it may be above it, in proportion, as settings are rounded."""
SHARP = 1e-8
"""What the steps of both simulations leave, in proportion."""
ROUNDS, NARROW = 5, 1e-6
"""Steps of Newton's method, and by how much more than half a unit a decimal may be off."""
MOST_PLACES = 18
DIGITS = 3
"""A decimal of fewer significant digits is the number that it is."""
MACHINE_TIME = "tau"


@dataclass(frozen=True)
class Run:
    """A program run beside the question; `voltages` by element and `read` by variable are at the times of the grid."""

    posed: Posed
    net: Netlist

    @cached_property
    def slower(self) -> float:
        """β of τ = β t."""
        return number(self.posed.asked.time_scale)

    @cached_property
    def _signals(self) -> list[Signal]:
        """The sources as functions of τ, or of t where they are inputs."""
        found = []
        for value in self.net.sources:
            names = {str(symbol): symbol for symbol in value.free_symbols}
            own = next((name for name in self.posed.functions if name in names), None)
            if own is not None:
                function = value.xreplace({names[own]: self.posed.functions[own]})
                found.append(Signal(function.xreplace({TIME: TIME / self.posed.asked.time_scale}), TIME))
            else:
                found.append(Signal(value, names.get(MACHINE_TIME)))
        return found

    def _drive(self, times: Array) -> Array:
        if not self._signals:
            return np.zeros((*times.shape, 0))
        return np.stack([each.at(times.reshape(-1)).reshape(times.shape) for each in self._signals], axis=-1)

    @cached_property
    def motion(self) -> Array:
        """The outputs of integrators and sources at the times of the grid."""
        grid = self.posed.grid.faster(self.slower)
        states = grid.states(self.net.F, self.net.G, self.net.start, self._drive)
        return np.hstack([states, self._drive(grid.times)])

    def read(self, name: str) -> Array:
        """A variable as the program gives it."""
        return np.asarray(self.motion @ self.net.readouts[name])

    def wanted(self, name: str) -> Array:
        """A variable as the question's equations give it."""
        return np.asarray(self.posed.motion @ self.posed.rows[name])

    def gap(self, name: str) -> float:
        """The largest difference, in proportion to the largest value so far; inf where it is not finite."""
        worst = float(np.max(np.abs(self.gaps([name])), initial=0.0))
        return worst if np.isfinite(worst) else np.inf

    def gaps(self, names: Sequence[str]) -> Array:
        """The differences of some variables at all times, each in proportion to its largest value so far."""
        found = []
        for name in names:
            wanted, read = self.wanted(name), self.read(name)
            sizes = np.maximum.accumulate(np.abs(wanted))
            floor = 1e-6 * max(float(np.max(sizes, initial=0.0)), 1e-3)
            found.append((read - wanted) / np.maximum(sizes, floor))
        return np.concatenate(found) if found else np.zeros(0)

    def overload(self) -> tuple[str, float] | None:
        """The first amplifier whose voltage leaves the range, and when, in t."""
        return _first_beyond(
            {each: self.motion @ self.net.rows[each] for each in self.net.amplifiers},
            self.net.reference,
            self.posed.grid.times,
        )


def _first_beyond(voltages: Mapping[str, Array], reference: float, times: Array) -> tuple[str, float] | None:
    """The first to leave the range, and the time between two steps by a straight line."""
    found = []
    for name, volts in voltages.items():
        sizes = np.abs(volts)
        beyond = np.flatnonzero(sizes > reference * (1 + FULL))
        if len(beyond):
            inside = np.flatnonzero(sizes[: beyond[0]] <= reference)
            i = int(inside[-1]) if len(inside) else 0
            j = min(i + 1, len(times) - 1)
            share = (reference - sizes[i]) / (sizes[j] - sizes[i]) if sizes[j] > sizes[i] else 0.0
            found.append((float(times[i] + max(share, 0.0) * (times[j] - times[i])), name))
    return (min(found)[1], min(found)[0]) if found else None


def readout_gaps(asked: Asked, program: Program) -> Iterator[tuple[str, float]]:
    """Yield for each variable that is to be read out, or is, how far the program is from it, within its digits.

    A variable that is unknown, or required and missing, is infinitely far. Raises NotEvaluable.
    """
    run = Run(asked.posed, netlist_of(program))
    for name in dict.fromkeys([*asked.required, *program.readout]):
        known = name in program.readout and name in asked.readouts
        yield name, run.gap(name) if known else np.inf


def within_digits(asked: Asked, program: Program) -> Program:
    """Return the program with its decimals moved within their last digit, so that it computes what is asked if it can.

    Gauss and Newton's method with bounds; a program that is right as it stands is returned as it is.
    """
    names = [name for name in program.readout if name in asked.readouts]
    places, here, posed = list(_decimals(program)), program, asked.posed
    moved = np.zeros(len(places))
    for _ in range(ROUNDS):
        run = Run(posed, netlist_of(here))
        gaps = run.gaps(names)
        if not places or not np.all(np.isfinite(gaps)) or np.max(np.abs(gaps), initial=0.0) <= SHARP:
            break
        slopes = [Run(posed, netlist_of(_with(here, place, place.by))).gaps(names) - gaps for place in places]
        bounds = (-1.0 - NARROW - moved, 1.0 + NARROW - moved)
        moved = moved + lsq_linear(np.array(slopes).T, -gaps, bounds).x
        here = program
        for place, by in zip(places, moved, strict=True):
            here = _with(here, place, place.by * sp.Rational(float(by)))
    return here


class Decimal(NamedTuple):
    """A number of a program: `key` of the element at a place, or the factor of a readout; with half a unit of it."""

    key: str
    place: Any
    by: Any


def _decimals(program: Program) -> Iterator[Decimal]:
    """The settings, initial voltages and factors that are decimals."""
    for i, each in enumerate(program.elements):
        for key in ("setting", "initial"):
            if by := half_unit(getattr(each, key)):
                yield Decimal(key, i, by)
    for name, (_, factor) in program.readout.items():
        if by := half_unit(factor):
            yield Decimal("readout", name, by)


def _with(program: Program, decimal: Decimal, by: Any) -> Program:
    """A program with one of its numbers changed."""
    key, place, _ = decimal
    if key == "readout":
        element, factor = program.readout[place]
        return replace(program, readout={**program.readout, place: (element, factor + by)})
    own: Element = replace(program.elements[place], **{key: getattr(program.elements[place], key) + by})
    return replace(program, elements=(*program.elements[:place], own, *program.elements[place + 1 :]))


def half_unit(value: Any) -> Any:
    """Half a unit of the last digit of a decimal of three significant ones or more; None of another number."""
    if not getattr(value, "is_Rational", False) or value == 0:
        return None
    places = next((k for k in range(MOST_PLACES) if 10**k % int(value.q) == 0), None)
    if places is None or abs(value) * 10**places < 10 ** (DIGITS - 1):
        return None
    return sp.Rational(1, 2) / 10**places


def overload_of(asked: Asked, program: Program) -> tuple[str, float] | None:
    """Return the first amplifier of a program whose voltage leaves the range, and when (in t). Raises NotEvaluable."""
    return Run(asked.posed, netlist_of(program)).overload()


def expected_overload(asked: Asked) -> float | None:
    """When (in t) a variable exceeds the maximum that is given for it, by the question's own equations."""
    posed = asked.posed
    found = _first_beyond(_shares(posed), 1.0, posed.grid.times)
    return found[1] if found else None


def _shares(posed: Posed) -> dict[str, Array]:
    """Each variable that has a maximum, in proportion to it."""
    maxima = {name: number(value) for name, value in posed.asked.maxima.items()}
    return {name: posed.motion @ posed.rows[name] / value for name, value in maxima.items() if value}


def overload_residual(asked: Asked, time: Any) -> float:
    """How far the largest of the variables is from its maximum at that time (in t), and from being below it before."""
    posed = Posed(asked)  # of its own: it is followed until that time
    if not number(time) >= 0:
        return np.inf
    posed.__dict__["grid"] = posed.grid.until(number(time))
    shares = _shares(posed)
    at_the_end = max((abs(float(share[-1])) for share in shares.values()), default=0.0)
    before = max((float(np.max(np.abs(share))) for share in shares.values()), default=0.0)
    return max(abs(at_the_end - 1.0), before - 1.0)


def freed_gap(asked: Asked, program: Program) -> float | None:
    """How far what is read out is from a motion of the equations where the integrators start at any voltages.

    Compared by the derivatives at the start without inputs, where the program has as many integrators as the equations
    states; None elsewhere: a program may make an input by integrators, too.
    """
    posed, net = asked.posed, netlist_of(program)
    n = len(posed.states)
    if len(net.start) != n or n == 0:
        return None
    names = [name for name in program.readout if name in posed.rows]
    H = np.array([net.readouts[name][:n] for name in names])
    C = np.array([posed.rows[name][:n] for name in names])
    scale = max(float(np.max(np.abs(np.linalg.eigvals(posed.A)), initial=0.0)), 1e-9)
    F, A = net.F * number(asked.time_scale) / scale, posed.A / scale
    largest = np.maximum(np.abs(C), np.abs(H)).max(axis=1) if names else np.ones(0)
    size = np.diag(1.0 / np.where(largest > 0, largest, 1.0))  # what is always zero is compared as it is
    mine, wanted = [size @ H], [size @ C]
    for _ in range(2 * n):
        mine.append(mine[-1] @ F)
        wanted.append(wanted[-1] @ A)
    M, W = np.vstack(mine), np.vstack(wanted)
    left = M - W @ np.linalg.lstsq(W, M, rcond=1e-12)[0]
    return float(np.max(np.abs(left)) / max(float(np.max(np.abs(M))), 1e-300))
