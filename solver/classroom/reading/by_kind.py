"""A value read by the kind of answer it stands for: a word, yes or no, a condition, a list, a matrix, an expression."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from solver.classroom.reading import counts, in_order, polynomials, units, words
from solver.classroom.reading import items as listed
from solver.classroom.reading.expected import Expected
from solver.classroom.reading.likeness import is_condition
from solver.classroom.reading.matrices import Unfolding, mapped
from solver.classroom.reading.names import symbols_of, unknown_of
from solver.classroom.reading.nodes import are_single, flat, is_trivial, labelled, lower, only, rows_of, text_of
from solver.classroom.reading.prepared import with_powers, without_powers
from solver.classroom.reading.segments import are_intervals, segments
from solver.classroom.reading.spanned import spanned
from solver.classroom.reading.spelling import typed
from solver.classroom.reading.texts import Pair, TextReader
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode
from solver.problem.source import Report
from solver.symbols import POLYNOMIAL

MAX_ENTRIES = 400


class KindReader:
    """Reads a value in one way, as `texts` chooses, by the kind of our own answer."""

    def __init__(self, texts: TextReader, expected: Expected, *, decimal_comma: bool) -> None:
        self.texts = texts
        self.names = texts.names
        self.expected = expected
        self.decimal_comma = decimal_comma

    def read(self, node: Node, ours: Any) -> Pair:
        """Return the value of a node and its form; raises Fault."""
        if isinstance(ours, str | bool):
            return (self._word(node, ours) if isinstance(ours, str) else self._truth(node),) * 2
        if is_condition(ours):
            names = [symbol.name for symbol in ours.free_symbols]
            if self.decimal_comma:
                node = Unfolding(self.texts.choices, comma=True).with_points(node)
            alone = names[0] if len(names) == 1 else ""
            value, written = (self.texts.condition(node, alone, form=form) for form in (False, True))
            return self._in_case(value, ours), self._in_case(written, ours)
        if isinstance(ours, sp.Set | list | tuple):
            return self._set(node, ours)
        if isinstance(ours, sp.MatrixBase):
            return self._matrix(node, ours)
        if isinstance(ours, Mapping):
            cases = bool(ours) and all(isinstance(name, str) for name in ours)
            return self._cases(node, ours) if cases else self._mapping(node, ours)
        return self._value(node, ours)

    def _cases(self, node: Node, ours: Mapping[str, Any]) -> Pair:
        """Cases by their names, each with the condition under which it is met."""
        node = self._unfolded(node)
        if not isinstance(node, MappingNode):
            node = mapped(node, typed(node)) or node
        if not isinstance(node, MappingNode):
            raise node.fault("cases with their conditions are expected here, such as {underdamped: d < 4}")
        symbols = {symbol.name for condition in ours.values() for symbol in condition.free_symbols}
        alone = next(iter(symbols)) if len(symbols) == 1 else ""
        read = {
            entry.key.text.strip().lower().replace(" ", "_"): self.texts.condition(entry.value, alone) for entry in node
        }
        return read, read

    def _in_case(self, read: Any, ours: Any) -> Any:
        """A condition on k as one on K, where this is the parameter and no other is there."""
        parameters, own = symbols_of(ours), symbols_of(read) - set(self.texts.decimals)
        if len(parameters) != 1 or len(own) != 1 or parameters == own:
            return read
        (meant,), (written,) = parameters, own
        if meant.name.lower() != written.name.lower() or written in self.names.symbols.values():
            return read
        self.texts.respelt = True
        return read.xreplace({written: meant})

    def _unfolded(self, node: Node, *, grid: bool = False) -> Node:
        return Unfolding(self.texts.choices, grid, self.decimal_comma, self.expected.vectors).node(node)

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

    def _mapping(self, node: Node, ours: Mapping[Any, Any]) -> Pair:
        """Names with their values; a single one may be left out."""
        if not ours and self._says_none(node):
            return {}, {}
        if len(ours) == 1 and isinstance(node, ScalarNode) and mapped(node, typed(node)) is None:
            (name,) = ours
            value, form = self.texts.expression(node)
            return {name: value}, {name: form}
        node = self._unfolded(node)
        if isinstance(node, SequenceNode) and all(isinstance(item, MappingNode) for item in node.items):
            listed = [entry for item in node.items if isinstance(item, MappingNode) for entry in item]
            node = MappingNode(node.place, {entry.key.text: entry for entry in listed})
        node = node if isinstance(node, MappingNode) else mapped(node, typed(node)) or node
        node = in_order.named(node, ours, self.expected.name)
        if not isinstance(node, MappingNode):
            raise node.fault("names with their values are expected here, such as {x: 1, y: 2}")
        read = dict(self._entry(entry.key, entry.value, ours) for entry in node)
        values, forms = ({name: pair[i] for name, pair in read.items()} for i in (0, 1))
        return values, forms

    def _entry(self, key: ScalarNode, value: Node, ours: Mapping[Any, Any]) -> tuple[Any, Pair]:
        """An unknown with its value, in our letter where it is a sequence in another one."""
        name, read = unknown_of(self.texts.expression(key)[0], ours), self.texts.expression(value)
        own = ours.get(name)
        if not isinstance(own, sp.Expr):
            return name, read
        return name, self._renamed(read, polynomials.in_usual_letter(read, own, self._known))

    def _set(self, node: Node, ours: Any) -> Pair:
        """A list; or all real numbers, in a word, where values of a parameter are asked for."""
        if lower(node) in words.ALL:
            return (sp.S.Reals,) * 2
        if isinstance(node, ScalarNode) and words.is_none(node.text, self.expected.name):
            return [], []
        if self.expected.zero:
            node = listed.as_differences(node)
        if self.expected.intervals or are_intervals(ours):
            return (segments(node, self.texts),) * 2
        return self._list(node, () if isinstance(ours, sp.Set) else ours)

    def _list(self, node: Node, ours: Sequence[Any]) -> Pair:
        """A list of expressions (with ± for two), of matrices, of conditions, or of words."""
        single = bool(ours) and getattr(ours[0], "shape", ()) == (1, 1) and are_single(node)  # 3, -1 of [3], [-1]
        grid = single or not (ours and (is_condition(ours[0]) or isinstance(ours[0], sp.MatrixBase | str)))
        if (
            ours
            and isinstance(ours[0], sp.MatrixBase)
            and isinstance(node, ScalarNode)
            and (each := listed.matrices_of(node.text))
        ):
            self.texts.respelt = True
            node = SequenceNode(node.place, tuple(ScalarNode(node.place, text, "quoted") for text in each))
        if ours and isinstance(ours[0], str) and isinstance(node, ScalarNode):
            node = listed.words_of(node)
        if isinstance(node, ScalarNode) and (bare := units.inside(node.text, self.texts.unit)) != node.text:
            node = ScalarNode(node.place, bare, "quoted")
        node = self._unfolded(listed.without_dots(node) if self.expected.continued else node, grid=grid)
        if isinstance(node, MappingNode):
            node = SequenceNode(node.place, tuple(each for entry in node for each in labelled(entry)))
        if self.expected.zero:
            node = listed.as_differences(node)
        items = listed.items_of(node, self.texts)
        if not grid:
            pairs = [self.read(item, ours[0]) for item in items]
            return [value for value, _ in pairs], [form for _, form in pairs]
        values: list[Any] = []
        forms: list[Any] = []
        report = Report()
        if len(flat(items)) > MAX_ENTRIES:
            raise node.fault(f"a list of more than {MAX_ENTRIES} items cannot be read")
        for item in self._with_unit(listed.unlabelled(flat(items), self.texts) or flat(items)):
            with report:
                for value, form in self.texts.alternatives(item):
                    values.append(sp.ImmutableMatrix([[value]]) if single else value)
                    forms.append(sp.ImmutableMatrix([[form]]) if single else form)
        report.conclude()
        return values, forms

    def _with_unit(self, items: Sequence[Node]) -> Sequence[Node]:
        """Items with the unit that stands behind the last of them for all."""
        texts = [item.text for item in items if isinstance(item, ScalarNode)]
        if len(texts) < max(2, len(items)):
            return items
        found = units.shared(texts, self.texts.unit)
        if found == texts:
            return items
        self.texts.respelt = True
        return [ScalarNode(item.place, text, "quoted") for item, text in zip(items, found, strict=True)]

    def _matrix(self, node: Node, ours: sp.MatrixBase) -> Pair:
        if lower(node) in words.NONE:
            return (self._nothing(node, ours),) * 2
        if (size := words.whole_space(typed(node))) == ours.rows == ours.cols:
            self.texts.respelt = True
            return (sp.ImmutableMatrix(sp.eye(size)),) * 2
        if ours.shape == (1, 1) and (mixed := words.mixed_number(typed(node))):
            node = ScalarNode(node.place, self.texts.choices.choose("mixed", mixed), "quoted")
        node = self._unfolded(node, grid=True)
        if isinstance(node, MappingNode) and node.entries:
            node = SequenceNode(node.place, tuple(each for entry in node for each in labelled(entry)))
        if is_trivial(node):
            return (sp.ImmutableMatrix(ours.rows, 0, []),) * 2
        if isinstance(node, SequenceNode):
            node = listed.placed(node, self.texts) or node
        rows = rows_of(node, ours)
        if self.expected.name == "array":  # Routh's, whose zeros at the end of a row are often left out
            rows = without_powers(rows)
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
        read = sp.ImmutableMatrix(values), sp.ImmutableMatrix(forms)
        read = self._renamed(read, spanned(read, self._known, self.expected))
        return self._turned(*self._renamed(read, polynomials.in_usual_letter(read, ours, self._known)), ours)

    def _nothing(self, node: Node, ours: sp.MatrixBase) -> Any:
        """What "none" stands for: no vectors, or that nothing goes through to the output."""
        if self.expected.name == "D" and 0 not in ours.shape:
            return sp.ImmutableMatrix(sp.zeros(*ours.shape))
        if ours.cols and not self.expected.vectors and self.expected.name in ("A", "B", "C", "D"):
            raise node.fault("a matrix is expected here")
        return sp.ImmutableMatrix(ours.rows, 0, [])

    def _turned(self, value: Any, form: Any, ours: sp.MatrixBase) -> Pair:
        """A vector in the orientation of ours: a gain written as a column is the row that is asked for."""
        if value.shape == ours.shape or 1 not in value.shape or value.shape != ours.shape[::-1]:
            return value, form
        self.texts.respelt = True
        return value.T, form.T

    def _count(self, node: ScalarNode) -> ScalarNode:
        """A whole number in digits, where it is said in words; raises Fault where a full one cannot be told."""
        asked = self.expected
        said = counts.said(node.text, asked.name, asked.most, things=asked.count)
        if said is None:
            raise node.fault("it is not clear which number is meant")
        return node if said == node.text else ScalarNode(node.place, said)

    def _says_none(self, node: Node) -> bool:
        """Whether a text says that there is no such value."""
        text = node.text if isinstance(node, ScalarNode) else ""
        return words.is_none(text, self.expected.name) or words.is_missing(text)

    def _value(self, node: Node, ours: Any) -> Pair:
        """An expression; a polynomial also by its coefficients, or in another variable."""
        if ours is sp.oo and self.expected.name.endswith("_crossover") and self._says_none(node):
            return (sp.oo,) * 2
        if isinstance(ours, sp.Integer) and isinstance(node, ScalarNode):
            node = self._count(node)
        variable = polynomials.variable_of(ours)
        if isinstance(node, ScalarNode) and symbols_of(ours) and (text := self._squared(node.text, ours)) != node.text:
            node = ScalarNode(node.place, text, "quoted")
        listed = not isinstance(node, ScalarNode) or polynomials.holds_coefficients(node.text)
        node = only(self._unfolded(node, grid=variable is not None and listed))
        if variable is None:
            read = self.texts.expression(node)
            return self._renamed(read, polynomials.in_usual_letter(read, ours, self._known))
        if isinstance(node, SequenceNode) and 1 < len(node.items) <= polynomials.MAX_DEGREE:
            self.texts.respelt = True
            pairs = [self.texts.expression(item) for item in node.items]
            value, form = (polynomials.of_coefficients([pair[i] for pair in pairs], variable) for i in (0, 1))
            return value, form
        read = self.texts.expression(node)
        read = self._renamed(read, polynomials.with_positive_powers(read, variable, sp.degree(ours, variable)))
        return self._renamed(read, polynomials.in_variable(read, variable, self._known))

    @property
    def _known(self) -> set[sp.Symbol]:
        """The symbols that have a meaning in the problem, and those that stand for decimals."""
        return {*self.names.symbols.values(), *self.texts.decimals}

    def _squared(self, text: str, ours: Any) -> str:
        """A polynomial, or a transfer function, with s2 as s^2."""
        if not any(symbol.name in POLYNOMIAL for symbol in symbols_of(ours)):
            return text
        return with_powers(text, [*self.names.symbols, *self.names.values])

    def _renamed(self, read: Pair, renamed: Pair) -> Pair:
        """A value in our variable; that it is written in another one is told."""
        self.texts.respelt = self.texts.respelt or renamed[0] != read[0]
        return renamed
