"""Programs of an analog computer as formulas: what each element gives, a line each, the variables read out last."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import sympy as sp

from solver.formula.building import MINUS, as_factor, is_negative, row, summed
from solver.formula.nodes import Operator, Row, Scripts, Space, Symbol, Table
from solver.patches import Element, Program
from solver.render.symbols import named

Show = Callable[[Any], Row]
EQUALS = row(Operator("="))
INTEGRAL = Scripts(Operator(r"\int"), row("0"), row(r"\tau"))


def program_formula(program: Program, show: Show) -> Row:
    """Return the elements as equations under each other: P1 = 0.5 A2, A1 = 8 - ∫ 10 P1 dτ, A3 = -A1, x = 5 A1."""
    lines = [(row(named(each.id)), row(EQUALS, _given_by(each, show))) for each in program.elements]
    lines += [(row(named(name)), row(EQUALS, _times(factor, of, show))) for name, of, factor in _read_out(program)]
    return row(Table("aligned", tuple(lines)))


def _read_out(program: Program) -> Iterator[tuple[str, str, Any]]:
    for name, (of, factor) in program.readout.items():
        yield name, of, factor


def _given_by(element: Element, show: Show) -> Row:
    """What an element gives."""
    if element.kind == "source":
        return show(element.value)
    if element.kind == "pot":
        return _times(element.setting, element.inputs[0][0], show)
    sum_ = _sum(element.inputs, show)
    if element.kind != "integrator":
        return row(MINUS, as_factor(sum_))
    ends = (Space(r"\,"), Symbol("d"), Symbol(r"\tau"))
    integral = row(MINUS, INTEGRAL, as_factor(sum_), *ends)
    return integral if element.initial == 0 else summed([show(element.initial), integral])


def _sum(inputs: Sequence[tuple[str, Any]], show: Show) -> Row:
    return summed([_times(gain, name, show) for name, gain in inputs]) if inputs else show(sp.S.Zero)


def _times(factor: Any, name: str, show: Show) -> Row:
    """A factor before the name of an element."""
    if factor in (1, -1):
        return row(*([MINUS] if factor == -1 else []), named(name))
    shown = show(factor)
    return row(shown if is_negative(shown) else as_factor(shown), Space(r"\,"), named(name))
