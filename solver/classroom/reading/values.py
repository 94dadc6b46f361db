"""A submitted value, read by the kind of answer it stands for; decimals remember the digits they were written with.

A decimal 0.67 stands for every number that rounds to it. So it is read twice: as the exact number 67/100, and as a
formula with a symbol in its place that may move by half a unit of the last digit. A text of several readings is read in
each: the value has the others beside it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from solver.classroom.reading import counts, polynomials, words
from solver.classroom.reading.choices import MOST_READINGS, Choices, readings
from solver.classroom.reading.expected import Expected
from solver.classroom.reading.labels import (
    ForeignLabelError,
    by_places,
    with_own_labels,
    without_labels,
    without_range,
)
from solver.classroom.reading.likeness import has_step, is_condition, is_like
from solver.classroom.reading.matrices import Unfolding, mapped
from solver.classroom.reading.nodes import flat, is_trivial, labelled, lower, only, rows_of, text_of
from solver.classroom.reading.spelling import typed
from solver.classroom.reading.texts import Pair, TextReader
from solver.classroom.submitted import Submitted, replaced
from solver.problem.expressions import Names
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode
from solver.problem.source import Fault, Report

MAX_ENTRIES = 400


class Reader:
    """Reads values in which the names of a problem and of its answers have their meaning.

    With `decimal_comma` a comma between digits may be a decimal comma.
    """

    def __init__(self, names: Names, *, discrete: bool = False, decimal_comma: bool = False) -> None:
        self.names = names
        self.discrete = discrete
        self.decimal_comma = decimal_comma
        self.expected = Expected()
        self.texts = TextReader(names, Choices(), discrete=discrete)

    def read(self, node: Node, ours: Any, expected: Expected | None = None) -> Submitted:
        """Return the value of a node for an answer of the kind of `ours`, with its other readings; raises Fault."""
        self.expected = expected or Expected()
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
        if not found:
            raise faults[0]
        found = [each for each in found if is_like(each.value, ours)] or found
        if len(found) == 1:
            return found[0]
        first, *others = (replace(each, respelt=True) for each in found)
        return replace(first, others=tuple(others))

    def _reading(self, node: Node, ours: Any, choices: Choices) -> Submitted:
        self.texts = TextReader(self.names, choices, self.expected.unit, discrete=self.discrete)
        value, form = self._read(self._unlabelled(node, ours), ours)
        if not has_step(ours):
            later = replaced(value, self.texts.ones)
            self.texts.respelt = self.texts.respelt or later != value
            value, form = later, replaced(form, self.texts.ones)
        return Submitted(value, form, dict(self.texts.decimals), typed(node), self.texts.respelt)

    def _unlabelled(self, node: Node, ours: Any) -> Node:
        """A text without the label before it; where an equation, a condition or a mapping is asked for it has none."""
        if not isinstance(node, ScalarNode) or isinstance(ours, Mapping) or is_condition(ours):
            return node
        text = without_range(node.text)
        if isinstance(ours, sp.Set | list | tuple):
            text = with_own_labels(text)
            self.texts.respelt = self.texts.respelt or text != node.text
        if polynomials.variable_of(ours) is not None:
            text = polynomials.one_side(text)
            self.texts.respelt = self.texts.respelt or text != node.text
        try:
            text, foreign = self.expected.labels.without(text)
        except ForeignLabelError as error:
            raise node.fault(str(error)) from None
        self.texts.respelt = self.texts.respelt or foreign
        return node if text == node.text else ScalarNode(node.place, text, "quoted")

    def _read(self, node: Node, ours: Any) -> Pair:
        if isinstance(ours, str):
            return (self._word(node, ours),) * 2
        if isinstance(ours, bool):
            return (self._truth(node),) * 2
        if is_condition(ours):
            names = [symbol.name for symbol in ours.free_symbols]
            return (self.texts.condition(node, names[0] if len(names) == 1 else ""),) * 2
        if isinstance(ours, sp.Set | list | tuple):
            return self._set(node, ours)
        if isinstance(ours, sp.MatrixBase):
            return self._matrix(node, ours)
        return self._mapping(node) if isinstance(ours, Mapping) else self._value(node, ours)

    def _unfolded(self, node: Node, *, grid: bool = False) -> Node:
        return Unfolding(self.texts.choices, grid, self.decimal_comma).node(node)

    def _word(self, node: Node, ours: str) -> str:
        """A verdict in words: one of those that the answer has, where its list is known."""
        text = text_of(node)
        if not words.in_words(text):
            raise node.fault("a word is expected here")
        if not self.expected.words:
            return words.in_words(text)
        known = tuple(dict.fromkeys([*self.expected.words, ours]))
        found = words.fitting(text, known)
        if len(found) != 1:
            note = f"its words are: {', '.join(found or known)}"
            raise node.fault("it is not clear which is meant" if found else "no such word is known here", note=note)
        self.texts.respelt = self.texts.respelt or found[0] != words.in_words(text)
        return found[0]

    def _truth(self, node: Node) -> bool:
        said = words.truth(text_of(node), self.expected.name)
        if said is None:
            raise node.fault("yes or no is expected here")
        return said

    def _mapping(self, node: Node) -> Pair:
        """Names with their values."""
        node = self._unfolded(node)
        if isinstance(node, SequenceNode) and all(isinstance(item, MappingNode) for item in node.items):
            listed = [entry for item in node.items if isinstance(item, MappingNode) for entry in item]
            node = MappingNode(node.place, {entry.key.text: entry for entry in listed})
        if not isinstance(node, MappingNode):
            node = mapped(node, typed(node)) or node
        if not isinstance(node, MappingNode):
            raise node.fault("names with their values are expected here, such as {x: 1, y: 2}")
        read = {self.texts.expression(entry.key)[0]: self.texts.expression(entry.value) for entry in node}
        values, forms = ({name: pair[i] for name, pair in read.items()} for i in (0, 1))
        return values, forms

    def _set(self, node: Node, ours: Any) -> Pair:
        """A list; or all real numbers, in a word, where values of a parameter are asked for."""
        if lower(node) in words.ALL:
            return (sp.S.Reals,) * 2
        if isinstance(node, ScalarNode) and words.is_none(node.text, self.expected.name):
            return [], []
        return self._list(node, () if isinstance(ours, sp.Set) else ours)

    def _list(self, node: Node, ours: Sequence[Any]) -> Pair:
        """A list of expressions (with ± for two), of matrices, of conditions, or of words."""
        grid = not (ours and (is_condition(ours[0]) or isinstance(ours[0], sp.MatrixBase | str)))
        node = self._unfolded(node, grid=grid)
        if isinstance(node, MappingNode):
            node = SequenceNode(node.place, tuple(each for entry in node for each in labelled(entry)))
        items = node.items if isinstance(node, SequenceNode) else (node,)
        if not grid:
            pairs = [self._read(item, ours[0]) for item in items]
            return [value for value, _ in pairs], [form for _, form in pairs]
        values: list[Any] = []
        forms: list[Any] = []
        report = Report()
        if len(flat(items)) > MAX_ENTRIES:
            raise node.fault(f"a list of more than {MAX_ENTRIES} items cannot be read")
        for item in self._unlabelled_items(flat(items)) or flat(items):
            with report:
                for value, form in self.texts.alternatives(item):
                    values.append(value)
                    forms.append(form)
        report.conclude()
        return values, forms

    def _unlabelled_items(self, items: Sequence[Node]) -> Sequence[Node]:
        """Items such as λ_1 = -1 without what names them; nothing where none has a name."""
        texts = [item for item in items if isinstance(item, ScalarNode)]
        if len(texts) != len(items):
            return []
        found, labelled = without_labels([item.text for item in texts])
        self.texts.respelt = self.texts.respelt or labelled
        if not labelled:
            return []
        places = [item.place for item in texts] if len(found) == len(texts) else [texts[0].place] * len(found)
        return [ScalarNode(place, text, "quoted") for place, text in zip(places, found, strict=True)]

    def _matrix(self, node: Node, ours: sp.MatrixBase) -> Pair:
        if lower(node) in words.NONE:
            return (sp.ImmutableMatrix(ours.rows, 0, []),) * 2
        if (size := words.whole_space(typed(node))) == ours.rows == ours.cols:
            self.texts.respelt = True
            return (sp.ImmutableMatrix(sp.eye(size)),) * 2
        if ours.shape == (1, 1) and (mixed := words.mixed_number(typed(node))):
            node = ScalarNode(node.place, self.texts.choices.choose("mixed", mixed), "quoted")
        node = self._unfolded(node, grid=True)
        if is_trivial(node):
            return (sp.ImmutableMatrix(ours.rows, 0, []),) * 2
        if isinstance(node, SequenceNode):
            node = self._placed(node) or node
        rows = rows_of(node, ours)
        if self.expected.name == "array":  # Routh's, whose zeros at the end of a row are often left out
            rows = [[*row, *[ScalarNode(node.place, "0")] * (ours.cols - len(row))] for row in rows]
        if any(len(row) != len(rows[0]) for row in rows):
            raise node.fault("the rows of a matrix must have the same length")
        if sum(map(len, rows)) > MAX_ENTRIES:
            raise node.fault(f"a matrix of more than {MAX_ENTRIES} entries cannot be read")
        report = Report()
        values: list[list[Any]] = []
        forms: list[list[Any]] = []
        for row in rows:
            values.append([])
            forms.append([])
            for item in row:
                with report:
                    value, form = self.texts.expression(item)
                    values[-1].append(value)
                    forms[-1].append(form)
        report.conclude()
        return self._turned(sp.ImmutableMatrix(values), sp.ImmutableMatrix(forms), ours)

    def _placed(self, node: SequenceNode) -> SequenceNode | None:
        """A list of entries with their names, p11 = 2 or k_1 = 3; None where they have none."""
        items = flat(node.items)
        texts = [item.text for item in items if isinstance(item, ScalarNode)]
        if texts and len(texts) == len(items) and (lines := by_places(texts)):
            self.texts.respelt = True
            rows = [tuple(ScalarNode(node.place, text, "quoted") for text in line) for line in lines]
            return SequenceNode(node.place, tuple(SequenceNode(node.place, row) for row in rows))
        named = self._unlabelled_items(items)
        return SequenceNode(node.place, tuple(named)) if named else None

    def _turned(self, value: Any, form: Any, ours: sp.MatrixBase) -> Pair:
        """A vector in the orientation of ours: a gain written as a column is the row that is asked for."""
        if value.shape == ours.shape or 1 not in value.shape or value.shape != ours.shape[::-1]:
            return value, form
        self.texts.respelt = True
        return value.T, form.T

    def _count(self, node: ScalarNode) -> ScalarNode:
        """A whole number in digits, where it is said in words; raises Fault where a full one cannot be told."""
        asked = self.expected
        said = counts.counted(node.text, asked.name, asked.most) if asked.count else counts.count(node.text)
        if said is None:
            raise node.fault("it is not clear which number is meant")
        return node if said == node.text else ScalarNode(node.place, said)

    def _value(self, node: Node, ours: Any) -> Pair:
        """An expression; a polynomial also by its coefficients, or in another variable."""
        if isinstance(ours, sp.Integer) and isinstance(node, ScalarNode):
            node = self._count(node)
        variable = polynomials.variable_of(ours)
        listed = not isinstance(node, ScalarNode) or polynomials.holds_coefficients(node.text)
        node = only(self._unfolded(node, grid=variable is not None and listed))
        if variable is None:
            return self.texts.expression(node)
        if isinstance(node, SequenceNode) and 1 < len(node.items) <= polynomials.MAX_DEGREE:
            self.texts.respelt = True
            pairs = [self.texts.expression(item) for item in node.items]
            value, form = (polynomials.of_coefficients([pair[i] for pair in pairs], variable) for i in (0, 1))
            return value, form
        read = self.texts.expression(node)
        known = {*self.names.symbols.values(), *self.texts.decimals}
        renamed = polynomials.in_variable(read, variable, known)
        self.texts.respelt = self.texts.respelt or renamed[0] != read[0]
        return renamed
