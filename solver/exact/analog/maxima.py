"""The largest size of each variable of machine equations for t ≥ 0, from the exact response.

Where the equation "slope = 0" is solved in closed form the peak is exact; else it is searched between samples, which
are dense enough for every mode, and refined in decimals. What oscillates for ever comes as near as one likes to the sum
of its constant and its amplitudes, if no two of its frequencies have a rational ratio.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import mpmath
import sympy as sp

from solver.exact.analog.machine_equations import TIME, MachineEquations, Terms
from solver.exact.analog.swings import Motion, Sustained, searched, sustained
from solver.exact.functions.rational import RationalMatrix
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.time_response.long_run import constant_root, limit
from solver.exact.time_response.peaks import Peak, modes_of, peak
from solver.exact.time_response.response import ClosedForm, response
from solver.exact.time_response.stationary import stationary
from solver.systems import StateSpace

SEEN = 1e-9
"""What exceeds another candidate by less than that, relatively, is not called larger."""


class Undecided(ValueError):  # noqa: N818 - a finding
    """The largest size is not found, as there are parameters."""


@dataclass(frozen=True)
class Largest:
    """The largest size of a variable x(t) (`motion`), t ≥ 0.

    `kind` is zero (it stays there), start, limit, peak, corner (where an input switches) or swing (it oscillates for
    ever, and its size comes as near to `value` as one likes). `time` is that of a peak or corner; `peak` tells how one
    was found in closed form.
    """

    motion: sp.Expr
    kind: str
    value: sp.Expr
    time: sp.Expr | None = None
    peak: Peak | None = None


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
    if y is None or any(value.free_symbols - {TIME} for value in y):
        raise Undecided("parameters")
    start = sp.expand(sp.Add(*(terms.get(each.variable, 0) * each.initial for each in equations.integrated)))
    return max(_candidates(found, y[0], start), key=_size)


def _size(each: Largest) -> float:
    """Its size; a peak or swing must be larger by more than what decimals tell apart."""
    return float(each.value) * (1 - SEEN if each.kind in ("peak", "swing") else 1)


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
    if len(pieces) == 1 and pieces[0][0] == 0 and _is_solved(pieces[0][1], motion):
        top = peak(pieces[0][1], motion, TIME, discrete=False)
        return candidates + ([Largest(motion, "peak", sp.Abs(top.value), top.time, top)] if top is not None else [])
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
        if exact is not None and abs(sp.N(exact - value, DIGITS)) < 1e-20 * max(1, value):
            value = exact
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


def _is_solved(image: RationalMatrix, motion: sp.Expr) -> bool:
    """Whether the times without a slope have a closed form."""
    moving = [pole for pole in image.poles if not constant_root(pole[0].factor, discrete=False)]
    modes = [(root, order) for each, order in moving for root in each.factor.roots]
    return not moving or stationary(motion, modes, TIME) is not None
