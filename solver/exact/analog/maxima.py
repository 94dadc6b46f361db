"""The largest size of each variable of machine equations for t ≥ 0, from the exact response.

Where the equation "slope = 0" is solved in closed form the peak is exact; else it is searched between samples, which
are dense enough for every mode, and refined in decimals. What oscillates for ever comes as near as one likes to the sum
of its constant and its amplitude; with several frequencies it is searched over their period.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import mpmath
import sympy as sp

from solver.exact.analog.machine_equations import TIME, MachineEquations, Terms
from solver.exact.analog.swings import Motion, Sustained, searched, sustained
from solver.exact.functions.rational import RationalMatrix
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.time_response.long_run import constant_root, limit
from solver.exact.time_response.peaks import modes_of
from solver.exact.time_response.response import ClosedForm, response
from solver.exact.time_response.stationary import Stationary, stationary
from solver.systems import StateSpace

SEEN = 1e-9
"""What exceeds another candidate by less than that, relatively, is not called larger."""


class Undecided(ValueError):  # noqa: N818 - a finding
    """The largest size is not found, as there are parameters."""


@dataclass(frozen=True)
class Largest:
    """The largest size of a variable x(t) (`motion`), t ≥ 0.

    `kind` is zero (it stays there), start, limit, peak, corner (where an input switches) or swing (it oscillates for
    ever, and its size comes as near to `value` as one likes). `time` is that of a peak or corner. `flat` tells where
    the slope is zero, if that has a closed form, and `values` are the values there; a peak is the one of its `number`.
    """

    motion: sp.Expr
    kind: str
    value: sp.Expr
    time: sp.Expr | None = None
    flat: Stationary | None = None
    values: tuple[sp.Expr, ...] = ()
    number: int | None = None


def state_space(equations: MachineEquations, terms: Sequence[Terms]) -> tuple[StateSpace, list[sp.Expr]]:
    """The equations in state space with these sums as outputs, and the functions of time that are its inputs."""
    X = [each.variable for each in equations.integrated]
    rows = [each.terms for each in equations.integrated]
    drives = list(dict.fromkeys(g for row in (*rows, *terms) for g in row if g not in X)) or [sp.S.One]

    def matrix(listed: Sequence[Terms], over: Sequence[sp.Expr]) -> sp.ImmutableMatrix:
        entries = [row.get(each, sp.S.Zero) for row in listed for each in over]
        return sp.ImmutableMatrix(len(listed), len(over), entries)

    A, B, C, D = matrix(rows, X), matrix(rows, drives), matrix(terms, X), matrix(terms, drives)
    x0 = sp.ImmutableMatrix([each.initial for each in equations.integrated])
    return StateSpace(A, B, C, D, x0), drives


def largest_size(equations: MachineEquations, terms: Terms) -> Largest:
    """The largest size of a sum of the variables; raises Unbounded, Undecided, NotExact."""
    system, drives = state_space(equations, [terms])
    found = response(system, system.x0, drives, TIME)
    y = found.y
    motion, symbols = (y[0] if y is not None else sp.S.Zero), system.A.free_symbols
    if motion.free_symbols - {TIME} or symbols:
        raise Undecided
    start = sp.expand(sp.Add(*(terms.get(each.variable, 0) * each.initial for each in equations.integrated)))
    candidates = _candidates(found, motion, start)
    return candidates[max(range(len(candidates)), key=lambda i: _size(candidates[i]))]


def _size(each: Largest) -> float:
    """Its size; a peak or swing must be larger by more than what decimals tell apart."""
    size = float(sp.N(each.value, DIGITS))
    return size * (1 - SEEN if each.kind in ("peak", "swing") else 1)


def _candidates(found: ClosedForm, motion: sp.Expr, start: sp.Expr) -> list[Largest]:
    """What may be the largest: the start, the limit or the swing, peaks and corners."""
    if motion == 0 and start == 0:
        return [Largest(motion, "zero", sp.S.Zero)]
    pieces = [(delay, each.y) for delay, each in found.pieces if each.y is not None]
    with mpmath.workdps(DIGITS + 15):
        moved = Motion([(mpmath.mpmathify(sp.N(delay, DIGITS + 15)), modes_of(image)) for delay, image in pieces])
    last = sustained(moved)
    candidates = [Largest(motion, "start", sp.Abs(start))]
    if last.level and not last.swings:
        candidates.append(_in_the_end(motion, pieces, last))
    flat = _solved(pieces[0][1], motion) if len(pieces) == 1 and pieces[0][0] == 0 else None
    if flat is not None:
        return _in_closed_form(candidates, flat)
    if last.swings:
        candidates.append(_in_the_end(motion, pieces, last))
    return candidates + [
        Largest(motion, "corner" if each.corner else "peak", sp.Float(each.size, DIGITS), sp.Float(each.time, DIGITS))
        for each in searched(moved, last)
    ]


def _in_the_end(motion: sp.Expr, pieces: Sequence[tuple[sp.Expr, RationalMatrix]], last: Sustained) -> Largest:
    """The limit, or what an oscillation comes near to for ever, exactly where one piece and one frequency allow it."""
    kind, value = "swing" if last.swings else "limit", sp.Float(last.size, DIGITS)
    if len(pieces) == 1:
        image = pieces[0][1]
        level = limit(image, discrete=False)
        exact = sp.Abs(level[0]) if level is not None else _swing(motion)
        if exact is not None and abs(sp.N(exact - value, DIGITS)) < 1e-20 * max(1.0, float(value)):
            return Largest(motion, kind, exact)
    return Largest(motion, kind, value)


def _swing(motion: sp.Expr) -> sp.Expr | None:
    """|c| + √(a² + b²) of the terms c + a cos ωt + b sin ωt that last; None where there are others."""
    parts: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(sp.expand(motion)):
        factor, function = term.as_independent(TIME, as_Add=False)
        if function == 1 or isinstance(function, sp.cos | sp.sin):
            parts[function] = parts.get(function, sp.S.Zero) + factor
        elif not function.has(sp.exp):
            return None
    waves = [each for each in parts if each != 1]
    if len({wave.args[0] for wave in waves}) != 1:
        return None
    return sp.Abs(parts.get(sp.S.One, sp.S.Zero)) + sp.sqrt(sp.expand(sp.Add(*(parts[wave] ** 2 for wave in waves))))


def _solved(image: RationalMatrix, motion: sp.Expr) -> Stationary | None:
    """The times t > 0 without a slope, where they have a closed form."""
    moving = [pole for pole in image.poles if not constant_root(pole[0].factor, discrete=False)]
    modes = [(root, order) for each, order in moving for root in each.factor.roots]
    return stationary(motion, modes, TIME) if moving else Stationary("constant", sp.S.Zero, None, [])


def _in_closed_form(candidates: Sequence[Largest], flat: Stationary) -> list[Largest]:
    """The candidates and the peaks, each with all values where the slope is zero."""
    motion = candidates[0].motion
    flat = replace(flat, times=[time for time in flat.times if float(sp.N(time, DIGITS)) > 0])
    values = tuple(sp.expand(motion.subs(TIME, time), power_exp=False, log=False) for time in flat.times)
    peaks = [
        Largest(motion, "peak", sp.Abs(value), time, number=number)
        for number, (time, value) in enumerate(zip(flat.times, values, strict=True))
    ]
    return [replace(each, flat=flat, values=values) for each in (*candidates, *peaks)]


def motions_of(equations: MachineEquations) -> dict[sp.Symbol, sp.Expr]:
    """Each integrated variable as a function of time t ≥ 0; raises NotExact."""
    system, drives = state_space(equations, [])
    found = response(replace(system, C=None, D=None), system.x0, drives, TIME).x
    return {each.variable: found[i] for i, each in enumerate(equations.integrated)}
