"""Mistakes as questions: the question changed as the mistake changes it (poles with the wrong sign, Aᵀ for A)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import sympy as sp

from solver.derivation import Slip, Task
from solver.derivation import usual_mistakes as usual
from solver.problem.model import Part, Reference
from solver.systems import StateSpace

Change = Callable[[Part], Part | None]
DeclaredChange = Callable[[Any, Any], tuple[Any, Any] | None]


def _option(part: Part, name: str, of: Callable[[Any], Any]) -> Part | None:
    value = part.options.get(name)
    if value is None or not isinstance(value, tuple | sp.MatrixBase):
        return None
    return replace(part, options={**part.options, name: of(value)})


def _system(part: Part, **changes: Any) -> Part | None:
    return replace(part, system=replace(part.system, **changes)) if isinstance(part.system, StateSpace) else None


def _poles_reversed(part: Part) -> Part | None:
    return _option(part, "poles", lambda poles: tuple(-pole for pole in poles))


def _poles_squared(part: Part) -> Part | None:
    return _option(part, "poles", lambda poles: tuple(pole**2 for pole in poles))


def _A_transposed(part: Part) -> Part | None:
    return _system(part, A=part.system.A.T) if isinstance(part.system, StateSpace) else None


def _without_D(part: Part) -> Part | None:
    D = getattr(part.system, "D", None)
    return None if D is None or D.is_zero_matrix else _system(part, D=sp.ImmutableMatrix(sp.zeros(*D.shape)))


def _B_reversed(part: Part) -> Part | None:
    B = getattr(part.system, "B", None)
    return None if B is None else _system(part, B=-B)


def _other_time(part: Part) -> Part | None:
    return _system(part, discrete=not part.system.discrete)


CHANGED: tuple[tuple[Slip, Change], ...] = (
    (usual.POLES_REVERSED, _poles_reversed),
    (usual.WITHOUT_D, _without_D),
    (usual.A_TRANSPOSED, _A_transposed),
    (usual.POLES_SQUARED, _poles_squared),
    (usual.B_REVERSED, _B_reversed),
    (usual.OTHER_TIME, _other_time),
)
"""What goes wrong in questions of any task; what does so in some is declared with them."""


def declared(change: DeclaredChange, task: Task[Any, Any], part: Part) -> Part | None:
    """Return the part as a mistake declared with its task changes it."""
    known = {name: None if isinstance(value, Reference) else value for name, value in part.options.items()}
    options = task.options_class.of(known)
    changed = change(part.system, options)
    if changed is None:
        return None
    system, new = changed
    others = {name: getattr(new, name) for name in task.options if getattr(new, name) is not getattr(options, name)}
    # Where an option may be left out, None is a value not known yet; elsewhere it is a choice, as of no feedback.
    left_out = {name for name, value in others.items() if value is None and task.options[name].default is None}
    asked = {name: value for name, value in {**part.options, **others}.items() if name not in left_out}
    return replace(part, system=system, options=asked)
