"""What a problem gives about a system, as Markdown."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from solver.render.displays import display
from solver.render.width import LINE, width
from solver.stated.algebra import quotient
from solver.systems import StateSpace, System, TransferFunction

GAP = r",\qquad "


def given_markdown(system: System, tex: Callable[[Any], str]) -> str:
    """Return the equations of the system, where it has an input or output, and its matrices or transfer function."""
    equations = ""
    if not isinstance(system, StateSpace):
        pieces = [f"G({tex(system.variable)}) = {tex(_as_given(system))}"]
    elif system.bare:
        pieces = [f"A = {tex(system.A)}"]
    else:
        equations, pieces = display(_equations(system)), _state_space(system, tex)
    if system.sample_time is not None:
        pieces.append(f"T = {tex(system.sample_time)}")
    return equations + "".join(display(line) for line in _lines(pieces))


def _as_given(system: TransferFunction) -> Any:
    """The transfer function with the factors that cancel."""
    if system.matrix.shape == (1, 1):
        return quotient(system.numerators[0][0], system.denominators[0][0])
    rows = zip(system.numerators, system.denominators, strict=True)
    return sp.ImmutableMatrix([[p / q for p, q in zip(*row, strict=True)] for row in rows])


def _equations(system: StateSpace) -> str:
    """The state equation, and that of the output where there is one."""
    next_state, k = ("x(k+1)", "(k)") if system.discrete else (r"\dot{x}", "")
    feedthrough = system.D is not None and not system.D.is_zero_matrix
    drive = f" + Bu{k}" if system.B is not None else ""
    state = f"{next_state} = Ax{k}{drive}"
    output = f"y{k} = Cx{k}" + (f" + Du{k}" if feedthrough else "")
    return f"{state}{GAP}{output}" if system.C is not None else state


def _state_space(system: StateSpace, tex: Callable[[Any], str]) -> list[str]:
    D = None if system.D is None or system.D.is_zero_matrix else system.D
    initial = "x(0)"
    named = {"A": system.A, "B": system.B, "C": system.C, "D": D, initial: system.x0}
    return [f"{name} = {tex(matrix)}" for name, matrix in named.items() if matrix is not None]


def _lines(pieces: list[str]) -> list[str]:
    """Put as many pieces on a line as fit."""
    lines = [pieces[0]]
    for piece in pieces[1:]:
        if width(lines[-1] + GAP + piece) <= LINE:
            lines[-1] += GAP + piece
        else:
            lines.append(piece)
    return lines
