"""A submitted value, read by the kind of answer it stands for; decimals remember the digits they were written with.

A decimal 0.67 stands for every number that rounds to it. So it is read twice: as the exact number 67/100, and as a
formula with a symbol in its place that may move by half a unit of the last digit. A text of several readings is read in
each: the value has the others beside it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from solver.classroom.reading import polynomials, words
from solver.classroom.reading.by_kind import KindReader
from solver.classroom.reading.choices import MOST_READINGS, Choices, readings
from solver.classroom.reading.definitions import own_statement, with_told_names, without_constants
from solver.classroom.reading.eigenpairs import eigenpairs, with_plain_signs
from solver.classroom.reading.expected import Expected
from solver.classroom.reading.labels import (
    ForeignLabelError,
    Labels,
    of_another_argument,
    with_own_labels,
    without_range,
)
from solver.classroom.reading.last_sides import VARIABLES, last_side
from solver.classroom.reading.latex import plainly
from solver.classroom.reading.likeness import has_step, is_condition, is_like, is_of_time
from solver.classroom.reading.matrices import has_decimal_comma
from solver.classroom.reading.names import symbols_of
from solver.classroom.reading.otherwise import other_texts
from solver.classroom.reading.patched import program_in
from solver.classroom.reading.phasors import as_sinusoid
from solver.classroom.reading.points import PointReader, are_points
from solver.classroom.reading.prepared import as_rows, prepared, strange_word
from solver.classroom.reading.quantities import is_value_at_rest
from solver.classroom.reading.said_twice import sides
from solver.classroom.reading.signal_values import SignalReader
from solver.classroom.reading.spelling import typed
from solver.classroom.reading.texts import TextReader
from solver.classroom.submitted import Submitted, replaced
from solver.derivation import AnswerName
from solver.patches import Program
from solver.problem.expressions import Names
from solver.problem.expressions.notation import MAX_CHARACTERS
from solver.problem.nodes import Node, ScalarNode, SequenceNode
from solver.problem.source import Fault

MAX_ENTRIES = 400
MOST_LAYERS = 2
"""Sentences within sentences that are gone into."""


class Reader:
    """Reads values in which the names of a problem and of its answers have their meaning.

    With `decimal_comma` a comma between digits may be a decimal comma.
    """

    def __init__(self, names: Names, *, discrete: bool = False, decimal_comma: bool = False) -> None:
        self.names = names
        self.discrete = discrete
        self.decimal_comma = decimal_comma
        self.expected = Expected()
        self.equation = False
        self.texts = TextReader(names, Choices(), discrete=discrete)

    def read(self, node: Node, ours: Any, expected: Expected | None = None) -> Submitted:
        """Return the value of a node for an answer of the kind of `ours`, with its other readings; raises Fault."""
        self.expected = expected or Expected()
        if isinstance(ours, Program):
            return program_in(node, self.texts)
        if self.expected.signals and isinstance(node, ScalarNode):
            return SignalReader(self, self.expected.signals).read(node, ours)
        return self.read_as_expected(node, ours, self.expected)

    def read_as_expected(self, node: Node, ours: Any, expected: Expected) -> Submitted:
        """Return the value of a node, with its other readings; raises Fault."""
        self.expected, written = expected, node
        node = prepared(node, ours, self.expected.name)
        source = written if isinstance(written, ScalarNode) else node
        if expected.paired and (pairs := eigenpairs(plainly(with_plain_signs(typed(source))))):
            return self._vectors_of(pairs, node, ours)
        if symbols_of(ours) and (found := self._with_told_names(node, ours)):
            return self._one_of([replace(each, respelt=True, typed=typed(written)) for each in found])
        found, faults = self._readings(node, ours)
        if not any(is_like(each.value, ours) for each in found):
            others = [each for each in self._other_readings(node, ours) if is_like(each.value, ours)]
            found = [replace(each, respelt=True) for each in others] or found
        if not any(is_like(each.value, ours) for each in found):
            found = [replace(each, respelt=True, typed=typed(node)) for each in self._within(source, ours)] or found
        if not found:
            raise faults[0]
        return self._one_of([each for each in found if is_like(each.value, ours)] or found)

    def _one_of(self, found: list[Submitted]) -> Submitted:
        """The value of one reading, or of several with each other."""
        if len(found) == 1:
            return found[0]
        first, *rest = (replace(each, respelt=True) for each in found)
        return replace(first, others=tuple(rest))

    def _vectors_of(self, pairs: Sequence[tuple[str, str]], node: Node, ours: Any) -> Submitted:
        """Vectors that are told with their eigenvalues, (eigenvalue, vector), with these; raises Fault."""
        listed = ", ".join(f"v{i} = {vector}" for i, (_, vector) in enumerate(pairs, 1))
        found, faults = self._readings(ScalarNode(node.place, listed, "quoted"), ours)
        texts = ", ".join(value for value, _ in pairs)
        values, strange = self._readings(ScalarNode(node.place, f"[{texts}]", "quoted"), [sp.S.Zero] * len(pairs))
        if len(found) != 1 or len(values) != 1:
            unread = [*faults, *strange]
            raise unread[0] if unread else node.fault("it is not clear which vector belongs to which eigenvalue")
        return replace(found[0], respelt=True, typed=typed(node), eigenvalues=values[0])

    def _readings(self, node: Node, ours: Any) -> tuple[list[Submitted], list[Fault]]:
        """The different values that a node may mean, and why other readings are none."""
        found: list[Submitted] = []
        faults: list[Fault] = []
        for count, choices in enumerate(readings()):
            if count == MOST_READINGS:
                raise node.fault("this has too many readings")
            try:
                each = self._reading(node, ours, choices)
            except Fault as fault:
                faults.append(fault)
                continue
            if all(type(each.value) is not type(other.value) or each.value != other.value for other in found):
                found.append(each)
        return found, faults

    def _other_readings(self, node: Node, ours: Any) -> list[Submitted]:
        """What a node may mean where nothing else has the shape of ours: with decimal commas, with / between rows."""
        if not self.decimal_comma and has_decimal_comma(node):
            with_points = Reader(self.names, discrete=self.discrete, decimal_comma=True)
            with_points.expected = self.expected
            return with_points._readings(node, ours)[0]
        lines = as_rows(node) if isinstance(ours, list | tuple | sp.MatrixBase) else None
        return self._readings(lines, ours)[0] if lines is not None else []

    def _within(self, node: Node, ours: Any, depth: int = 0) -> list[Submitted]:
        """What a text says that has the shape of ours: within a sentence, behind signs of equality, in another form."""
        if isinstance(node, SequenceNode):  # [1 2 | 3 4]
            node = ScalarNode(node.place, typed(node), "quoted")
        if not isinstance(node, ScalarNode) or isinstance(ours, str | bool) or is_condition(ours):
            return []
        if len(node.text) > MAX_CHARACTERS or depth > MOST_LAYERS:
            return []
        if isinstance(ours, Mapping) and (whole := self._as_function(node, ours)):
            return whole
        for text in other_texts(node.text, ours, self.expected):
            other = prepared(ScalarNode(node.place, text, "quoted"), ours, self.expected.name)
            if found := self._like(other, ours) or self._within(other, ours, depth + 1):
                return found
        return (self._with_told_names(node, ours) if depth else []) or last_side(
            node, ours, self.expected, lambda side: self._like(side, ours)
        )

    def _with_told_names(self, node: Node, ours: Any) -> list[Submitted]:
        """What a text says with what it tells of its names put in their place; nothing of any other text."""
        if not isinstance(node, ScalarNode) or isinstance(ours, str | bool) or is_condition(ours):
            return []
        own = [str(each) for each in symbols_of(ours)]
        text = with_told_names(node.text, own, [*self.names.symbols, *self.names.values]) or node.text
        if own and isinstance(ours, sp.Expr):
            text = own_statement(text, self.expected.labels) or without_constants(text) or text
        if text == node.text:
            return []
        bare = ScalarNode(node.place, text, "quoted")
        return self._like(bare, ours) or self._within(bare, ours, MOST_LAYERS)

    def _as_function(self, node: ScalarNode, ours: Mapping[Any, Any]) -> list[Submitted]:
        """The solution for one unknown read as a function with the unknown as its label."""
        ((name, own),) = ours.items() if len(ours) == 1 else ((None, None),)
        told = re.search(rf"(?<!\w){re.escape(str(name))}(?!\w)", node.text) or "=" not in node.text
        if not symbols_of(own) or not told:
            return []
        expected = Expected(str(name), Labels(AnswerName(str(name), str(name), "")))
        reader = Reader(self.names, discrete=self.discrete, decimal_comma=self.decimal_comma)
        try:
            found = reader.read_as_expected(node, own, expected)
        except Fault:
            return []
        readings = (replace(found, others=()), *found.others)
        return [replace(each, value={name: each.value}, form={name: each.form}) for each in readings]

    def _like(self, node: Node, ours: Any) -> list[Submitted]:
        """The readings of a node that have the shape of ours."""
        try:
            return [each for each in self._readings(node, ours)[0] if is_like(each.value, ours)]
        except Fault:
            return []

    def _reading(self, node: Node, ours: Any, choices: Choices) -> Submitted:
        self.equation = False
        self.texts = TextReader(self.names, choices, self.expected.unit, discrete=self.discrete)
        self.texts.numbers = not symbols_of(ours)
        if "z" in {symbol.name for symbol in symbols_of(ours)}:
            self.texts.variable = "z"
        kinds = KindReader(self.texts, self.expected, decimal_comma=self.decimal_comma)
        if are_points(ours, node):
            value, form = PointReader(self.texts, self.expected, ours).read(node)
        else:
            value, form = kinds.read(self._unlabelled(node, ours), ours)
        if not has_step(ours) and is_of_time(ours, self.expected.name):
            later = replaced(value, self.texts.ones)
            self.texts.respelt = self.texts.respelt or later != value
            value, form = later, replaced(form, self.texts.ones)
        if self.equation and (variable := polynomials.variable_of(ours)) is not None:
            value, form = (polynomials.with_leading_one(each, variable) for each in (value, form))
        if has_step(value) and not has_step(ours) and not is_of_time(ours, self.expected.name):
            raise node.fault("a step has no meaning here")
        if word := strange_word(symbols_of(value), [*self.names.symbols, *self.names.variables]):
            raise node.fault(f"the word '{word}' has no meaning here")
        return Submitted(value, form, dict(self.texts.decimals), typed(node), self.texts.respelt)

    def _unlabelled(self, node: Node, ours: Any) -> Node:
        """A text without the label before it; where an equation, a condition or a mapping is asked for it has none."""
        if not isinstance(node, ScalarNode) or isinstance(ours, Mapping) or is_condition(ours):
            return node
        if self.expected.zero:
            return node
        text = without_range(node.text)
        if isinstance(ours, sp.Set | list | tuple):
            text = with_own_labels(text)
            self.texts.respelt = self.texts.respelt or text != node.text
        if polynomials.variable_of(ours) is not None:
            text = polynomials.one_side(text)
            self.equation = self.equation or text != node.text
            self.texts.respelt = self.texts.respelt or text != node.text
        if isinstance(ours, str) and (
            words.is_concluded(text) or words.fitting(self.expected.labels.before(text)[0], self.expected.words)
        ):
            return node  # ζ = 1.25 > 1, overdamped; unstable, since λ = 1
        if isinstance(ours, bool) and words.truth(text, self.expected.name) is not None:
            return node
        if isinstance(ours, bool):
            label, value = self.expected.labels.before(text)
            if label and (len(value) < 2 or not words.is_name(label, self.expected.name)):  # rank = n is no "n"
                return node
        of_a_variable = isinstance(ours, sp.Expr) and bool({x.name for x in symbols_of(ours)} & VARIABLES)
        of_a_variable = of_a_variable and not is_value_at_rest(text, self.expected.name)
        end = self.expected.name in ("y_final", "y_peak")
        if of_another_argument(text, of_a_variable=of_a_variable, at_its_end=end):
            raise node.fault("it is labelled as something else than is asked for")
        try:
            if isinstance(ours, sp.Expr) and not isinstance(ours, sp.MatrixBase) and not symbols_of(ours):
                text = self._said_twice(text)
            text, foreign = self.expected.labels.without(text)
        except ForeignLabelError as error:
            raise node.fault(str(error)) from None
        told = as_sinusoid(text, ours)
        self.texts.respelt, text = self.texts.respelt or foreign or told != text, told
        return node if text == node.text else ScalarNode(node.place, text, "quoted")

    def _said_twice(self, text: str) -> str:
        """t_p = π/3 = 1.047 without the label before two equal numbers; any other text as it is."""
        first, *equal = sides(text)
        if len(equal) < 2 or self.expected.labels.without(f"{first} = 0")[0] != "0":
            return text
        return text[text.index("=") + 1 :]
