"""Programs of an analog computer as formulas: what each element gives, a line each, the variables read out last."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import sympy as sp

from solver.formula.building import MINUS, as_factor, is_negative, row, separated, summed
from solver.formula.nodes import Operator, Row, Scripts, Space, Symbol, Table
from solver.patches import Element, Program
from solver.render.symbols import named

Show = Callable[[Any], Row]
EQUALS = row(Operator("="))
MOST = 9
"""Potentiometers behind each other that are written out; a loop of them has no end."""
INTEGRAL = Scripts(Operator(r"\int"), row("0"), row(r"\tau"))


def program_formula(program: Program, show: Show) -> Row:
    """Return a program as equations under each other: P1 = 0.5, A1 = 8 - ∫ 10 P1 A2 dτ, A3 = -A1, x = 5 A1.

    The name of a potentiometer stands for its setting, that of another element for its volts.
    """
    writer = _Writer(program, show)
    lines = [(row(named(each.id)), row(EQUALS, writer.given_by(each))) for each in program.elements]
    read = program.readout.items()
    lines += [(row(named(name)), row(EQUALS, writer.times(factor, of))) for name, (of, factor) in read]
    return row(Table("aligned", tuple(lines)))


class _Writer:
    """Writes what the elements of a program give."""

    def __init__(self, program: Program, show: Show) -> None:
        self.elements = {each.id: each for each in program.elements}
        self.show = show

    def given_by(self, element: Element) -> Row:
        """Volts of a source or an amplifier, the setting of a potentiometer."""
        if element.kind in ("source", "pot"):
            return self.show(element.value if element.kind == "source" else element.setting)
        sum_ = self._sum(element.inputs)
        if element.kind != "integrator":
            return row(MINUS, as_factor(sum_))
        integral = row(MINUS, INTEGRAL, as_factor(sum_), Space(r"\,"), Symbol("d"), Symbol(r"\tau"))
        return integral if element.initial == 0 else summed([self.show(element.initial), integral])

    def _sum(self, inputs: Sequence[tuple[str, Any]]) -> Row:
        return summed([self.times(gain, name) for name, gain in inputs]) if inputs else self.show(sp.S.Zero)

    def times(self, factor: Any, name: str) -> Row:
        """A factor before the volts of an element, those of a potentiometer written as setting times what feeds it."""
        names = [named(name)]
        while (element := self.elements.get(name)) is not None and element.kind == "pot" and len(names) < MOST:
            name = element.inputs[0][0]
            names.append(named(name))
        shown = [] if factor in (1, -1) else [self.show(factor)]
        first = [each if is_negative(each) else as_factor(each) for each in shown]
        product = separated([*first, *(row(each) for each in names)], Space(r"\,"))
        return row(MINUS, product) if factor == -1 else product
