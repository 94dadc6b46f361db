"""Answers as equations: ẋ = […] x + […] u, y = […] x + […] u, on one line where it fits."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import sympy as sp

from solver.derivation.answer_equations import AnswerEquations, Equation
from solver.formula.building import parenthesized, row, separated
from solver.formula.nodes import Row
from solver.formula.width import LINE, width
from solver.matrices import entry_alone
from solver.render.displaying import GAP
from solver.render.displays import EQUALS, NOTHING, READABLE, aligned

Show = Callable[[Any], Row]


def formula_of(
    equations: AnswerEquations,
    values: Mapping[str, Any],
    show: Show,
    *,
    discrete: bool,
    moved: Any = None,
    narrow: bool = False,
) -> Row | None:
    """Return the equations with these values; none where one is too wide to be read, or says nothing.

    `moved` are the derivatives, or next values, of the states by name: they stand in place of that of x,
    and where the whole is wide, or has to be `narrow`, each has an equation of its own.
    """
    lines = [_sides(each, values, show, discrete=discrete) for each in equations.lines]
    if moved is not None:
        named = show(entry_alone(moved))
        lines = [(named if e.motion else left, right) for e, (left, right) in zip(equations.lines, lines, strict=True)]
    told = [(left, right) for left, right in lines if right.items]
    if moved is not None and told and (narrow or max(width(row(*pair)) for pair in told) > LINE):
        return aligned(
            [(left, row(EQUALS, right)) for left, right in _one_by_one(equations, values, show, moved, told)]
        )
    if not told or any(_is_empty(value) for value in values.values()):
        return None
    shown = [row(left, EQUALS, right) for left, right in told]
    if max(map(width, shown)) > READABLE * LINE:
        return None
    together = separated(shown, *GAP.items)
    return together if width(together) <= LINE else aligned([(left, row(EQUALS, right)) for left, right in told])


def _one_by_one(
    equations: AnswerEquations, values: Mapping[str, Any], show: Show, moved: Any, told: list[tuple[Row, Row]]
) -> list[tuple[Row, Row]]:
    """Return an equation for each state, but where it says that a state is the derivative of another, and the rest."""
    names = [each.terms[0][0] for each in equations.lines if each.motion]
    rows = [(show(d), show(f)) for name in names for d, f in zip(moved, values[name], strict=True) if d != f]
    return [*rows, *(pair for pair, each in zip(told, equations.lines, strict=True) if not each.motion)]


def _is_empty(value: Any) -> bool:
    return isinstance(value, sp.MatrixBase) and 0 in value.shape


def _sides(line: Equation, values: Mapping[str, Any], show: Show, *, discrete: bool) -> tuple[Row, Row]:
    now = "(k)" if discrete else ""
    derivative = f"{line.left}(k+1)" if discrete else rf"\dot{{{line.left}}}"
    left = row(derivative if line.motion else f"{line.left}{now}")
    right = NOTHING
    for name, on in line.terms:
        value = entry_alone(values.get(name.removeprefix("-"), 0) if name else sp.S.One)
        if _is_zero(value):
            continue
        minus, factor = _signed(value, show, minus=name.startswith("-"), alone=not on)
        sign = row("-") if minus else row("+") if right.items else NOTHING
        right = row(right, sign, factor, f"{on}{now}" if on else NOTHING)
    return left, right


def _is_zero(value: Any) -> bool:
    return value is None or bool(value.is_zero_matrix if isinstance(value, sp.MatrixBase) else value == 0)


def _signed(value: Any, show: Show, *, minus: bool, alone: bool) -> tuple[bool, Row]:
    """Return whether there is a minus before a factor, and the factor; nothing for one unless it stands `alone`."""
    if isinstance(value, sp.MatrixBase) or (alone and not minus):
        return minus, show(value)
    if not value.is_Add and value.could_extract_minus_sign():
        minus, value = not minus, -value
    shown = show(value)
    return minus, NOTHING if value == 1 else row(parenthesized(shown)) if value.is_Add else shown
