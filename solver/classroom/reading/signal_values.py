"""A value in signals: what differentiates and integrates them is read apart, and put in where it stands."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import sympy as sp

from solver.classroom.reading.components import in_numbers
from solver.classroom.reading.expected import Expected
from solver.classroom.reading.input_names import told_by_input
from solver.classroom.reading.signals import Operators
from solver.classroom.submitted import Submitted
from solver.derivation.answer_names import SignalNames
from solver.problem.expressions.notation import MAX_CHARACTERS
from solver.problem.nodes import ScalarNode

if TYPE_CHECKING:
    from solver.classroom.reading.values import Reader

INSIDE = sp.Symbol("v", real=True)
"""What stands inside of an operation is read as an expression like any."""


class SignalReader:
    """Reads with a reader of values, which does not know of operations on signals."""

    def __init__(self, reader: Reader, signals: SignalNames) -> None:
        self.reader = reader
        self.expected = reader.expected
        self.operators = Operators(signals.names, signals.of_time, signals.output, signals.held)
        self.decimals: dict[Any, Any] = {}

    def read(self, node: ScalarNode, ours: Any) -> Submitted:
        """Return the value of a text, with its other readings; raises Fault."""
        if len(node.text) > MAX_CHARACTERS:
            return self.reader.read_as_expected(node, ours, self.expected)
        known = {*self.reader.names.symbols, *self.reader.names.values}
        told = in_numbers(node.text, known.__contains__)
        text = self.operators.without(told_by_input(told, self.operators.names))
        outside = self.reader.names
        names = {name: sp.Symbol(name, real=True) for name in self.operators.found}
        self.reader.names = replace(outside, symbols={**outside.symbols, **names})
        changed = node if text == node.text else ScalarNode(node.place, text, "quoted")
        try:
            found = self._whole(self.reader.read_as_expected(changed, ours, self.expected), node)
        finally:
            self.reader.names, self.reader.expected = outside, self.expected
        return found

    def _whole(self, read: Submitted, node: ScalarNode) -> Submitted:
        """What was read with the operations put in."""
        value = self.operators.put_in(read.value, lambda text: self._inside(node, text).value)
        form = self.operators.put_in(read.form, lambda text: self._inside(node, text).form)
        return replace(
            read,
            value=value,
            form=form,
            decimals={**read.decimals, **self.decimals},
            typed=node.text,
            respelt=read.respelt or bool(self.operators.found),
            others=tuple(self._whole(each, node) for each in read.others),
        )

    def _inside(self, node: ScalarNode, text: str) -> Submitted:
        """What an operation acts on."""
        found = self.reader.read_as_expected(ScalarNode(node.place, text.strip(), "quoted"), INSIDE, Expected())
        self.decimals.update(found.decimals)
        return found
