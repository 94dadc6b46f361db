"""Mistakes as questions: the question changed as the mistake changes it (poles with the wrong sign, Aᵀ for A)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import sympy as sp

from solver.problem.model import Part
from solver.systems import StateSpace

Change = Callable[[Part], Part | None]


def _option(part: Part, name: str, of: Callable[[Any], Any]) -> Part | None:
    value = part.options.get(name)
    if value is None or not isinstance(value, tuple | sp.MatrixBase):
        return None
    return replace(part, options={**part.options, name: of(value)})


def _system(part: Part, **changes: Any) -> Part | None:
    return replace(part, system=replace(part.system, **changes)) if isinstance(part.system, StateSpace) else None


def _poles_reversed(part: Part) -> Part | None:
    return _option(part, "poles", lambda poles: tuple(-pole for pole in poles))


ABOUT_CHANNELS = ("controllability", "observability", "transfer_function", "pole_placement", "observer", "response")


def _poles_squared(part: Part) -> Part | None:
    return _option(part, "poles", lambda poles: tuple(pole**2 for pole in poles))


def _inputs_for_outputs(part: Part) -> Part | None:
    if part.task not in ABOUT_CHANNELS:
        return None
    B, C = getattr(part.system, "B", None), getattr(part.system, "C", None)
    return None if B is None or C is None or B.cols != C.rows else _system(part, B=C.T, C=B.T)


def _with(part: Part, option: str, word: str) -> Part | None:
    """The question with another word for an option that has one."""
    return None if part.options.get(option) in (None, word) else replace(part, options={**part.options, option: word})


def _weight_reversed(part: Part) -> Part | None:
    return _option(part, "Q", lambda Q: -Q)


def _A_transposed(part: Part) -> Part | None:
    return _system(part, A=part.system.A.T) if isinstance(part.system, StateSpace) else None


def _left_for_right(part: Part) -> Part | None:
    return _A_transposed(part) if part.task == "eigenstructure" else None


def _without_D(part: Part) -> Part | None:
    D = getattr(part.system, "D", None)
    return None if D is None or D.is_zero_matrix else _system(part, D=sp.ImmutableMatrix(sp.zeros(*D.shape)))


def _B_reversed(part: Part) -> Part | None:
    B = getattr(part.system, "B", None)
    return None if B is None else _system(part, B=-B)


def _without_initial_state(part: Part) -> Part | None:
    return _option(part, "initial_state", lambda x0: sp.ImmutableMatrix(sp.zeros(*x0.shape)))


def _other_time(part: Part) -> Part | None:
    return _system(part, discrete=not part.system.discrete)


CHANGED: tuple[tuple[str, Change], ...] = (
    ("the poles have the wrong sign", _poles_reversed),
    ("$D$ is forgotten", _without_D),
    ("the right side has the wrong sign: $-Q$ for $Q$", _weight_reversed),
    ("left and right eigenvectors are exchanged", _left_for_right),
    ("$A$ is transposed", _A_transposed),
    ("$B$ and $C$ are exchanged", _inputs_for_outputs),
    ("it is the observable form", partial(_with, option="form", word="observable")),
    ("it is the controllable form", partial(_with, option="form", word="controllable")),
    (
        "it follows the other convention: coefficients in the first row (column)",
        partial(_with, option="convention", word="first_row"),
    ),
    (
        "it follows the other convention: coefficients in the last row (column)",
        partial(_with, option="convention", word="last_row"),
    ),
    (
        "it follows the other convention: ones below the diagonal",
        partial(_with, option="convention", word="subdiagonal"),
    ),
    (
        "it follows the other convention: ones above the diagonal",
        partial(_with, option="convention", word="superdiagonal"),
    ),
    ("the poles are squared", _poles_squared),
    ("$B$ has the wrong sign", _B_reversed),
    ("the initial state is forgotten", _without_initial_state),
    ("it is right for the other kind of time, discrete or continuous", _other_time),
)
