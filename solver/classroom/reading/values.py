"""A submitted value, read by the kind of answer it stands for; decimals remember the digits they were written with.

A decimal 0.67 stands for every number that rounds to it. So it is read twice: as the exact number 67/100, and as a
formula with a symbol in its place that may move by half a unit of the last digit.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from solver.classroom.reading.spelling import matching, respelled, split, typed, unfolded
from solver.classroom.submitted import Decimal, Submitted
from solver.problem.expressions import ExpressionError, Names, parse_alternatives, parse_equation, parse_expression
from solver.problem.expressions.tokens import is_decimal, tokenize
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode
from solver.problem.source import Report
from solver.symbols import MEANINGS, SAMPLES

MAX_ENTRIES = 400
MAX_NESTING = 12
TRUTHS = {"yes": True, "no": False, "true": True, "false": False, "always": True, "never": False}
RELATIONS = (("<=", sp.Le), (">=", sp.Ge), ("≤", sp.Le), ("≥", sp.Ge), ("!=", sp.Ne), ("≠", sp.Ne), ("<", sp.Lt),
             (">", sp.Gt), ("=", sp.Eq))  # fmt: skip
ALL, NONE = ("reals", "all", "any", "every", "always", "all reals"), ("none", "never", "no", "[]")
_RELATION = re.compile(r"<=|>=|!=|[≤≥≠<>]|==?")
_AND = re.compile(r"\s+(?:and|und)\s+|\s*(?:&&?|∧|;|,)\s*", re.IGNORECASE)
_OR = re.compile(r"\s+(?:or|oder)\s+|\s*(?:\|\|?|∨)\s*", re.IGNORECASE)
_EQUATION = re.compile(r"^(Eq|Ne)\s*\((.*)\)$", re.DOTALL)


class Reader:
    """Reads values in which the names of a problem and of its answers have their meaning."""

    def __init__(self, names: Names, *, discrete: bool = False) -> None:
        self.names = names
        self.discrete = discrete
        self.decimals: dict[sp.Symbol, Decimal] = {}

    def read(self, node: Node, ours: Any) -> Submitted:
        """Return the value of a node for an answer of the kind of `ours`; raises Fault."""
        self.decimals = {}
        value, form = self._read(node, ours)
        return Submitted(value, form, dict(self.decimals), typed(node))

    def _read(self, node: Node, ours: Any) -> tuple[Any, Any]:
        node = unfolded(node)
        if isinstance(ours, str):
            return (_words(node),) * 2
        if isinstance(ours, bool):
            if _word(node) not in TRUTHS:
                raise node.fault("yes or no is expected here")
            return (TRUTHS[_word(node)],) * 2
        if isinstance(ours, sp.logic.boolalg.Boolean) and not isinstance(ours, sp.Expr):
            return (self._condition(node),) * 2
        if isinstance(ours, sp.Set | list | tuple):
            return self._set(node, ours)
        if isinstance(ours, sp.MatrixBase):
            return self._matrix(node, ours)
        return self._mapping(node) if isinstance(ours, Mapping) else self._expression(_only(node))

    def _mapping(self, node: Node) -> tuple[Any, Any]:
        """Names with their values."""
        if not isinstance(node, MappingNode):
            raise node.fault("names with their values are expected here, such as {x: 1, y: 2}")
        read = {self._expression(entry.key)[0]: self._expression(entry.value) for entry in node}
        values, forms = ({name: pair[i] for name, pair in read.items()} for i in (0, 1))
        return values, forms

    def _set(self, node: Node, ours: Any) -> tuple[Any, Any]:
        """A list; or all real numbers, in a word, where values of a parameter are asked for."""
        if _word(node) in ALL:
            return (sp.S.Reals,) * 2
        if _word(node) in NONE:
            return [], []
        return self._list(node, () if isinstance(ours, sp.Set) else ours)

    def _list(self, node: Node, ours: Sequence[Any]) -> tuple[Any, Any]:
        """A list of expressions (with ± for two), of matrices, of conditions, or of words."""
        items = node.items if isinstance(node, SequenceNode) else (node,)
        conditions = ours and isinstance(ours[0], sp.logic.boolalg.Boolean) and not isinstance(ours[0], sp.Expr)
        if conditions or (ours and isinstance(ours[0], sp.MatrixBase | str)):
            pairs = [self._read(item, ours[0]) for item in items]
            return [value for value, _ in pairs], [form for _, form in pairs]
        values: list[Any] = []
        forms: list[Any] = []
        report = Report()
        for item in items:
            with report:
                for value, form in self._alternatives(item):
                    values.append(value)
                    forms.append(form)
        report.conclude()
        return values, forms

    def _matrix(self, node: Node, ours: sp.MatrixBase) -> tuple[Any, Any]:
        rows = _rows(node, ours)
        if not rows:
            return (sp.ImmutableMatrix(ours.rows, 0, []),) * 2
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
                    value, form = self._expression(item)
                    values[-1].append(value)
                    forms[-1].append(form)
        report.conclude()
        return sp.ImmutableMatrix(values), sp.ImmutableMatrix(forms)

    def _expression(self, node: Node) -> tuple[Any, Any]:
        values = self._alternatives(node)
        if len(values) > 1:
            raise node.fault("± stands for two values; one is expected here")
        return values[0]

    def _alternatives(self, node: Node) -> list[tuple[Any, Any]]:
        """Return the value, or the two of an expression with ±, each with its form."""
        text = respelled(_text(node))
        with _at(node):
            values = parse_alternatives(text, self.names)
            rewritten, names = self._with_symbols(text)
            forms = parse_alternatives(rewritten, names) if rewritten != text else values
            return [(self._sampled(value), self._sampled(form)) for value, form in zip(values, forms, strict=True)]

    def _sampled(self, value: Any) -> Any:
        """In discrete time δ(k) is 1 at k = 0, and the step is 1 from 0 on."""
        if not self.discrete:
            return value
        value = value.replace(sp.DiracDelta, lambda at, *_: sp.KroneckerDelta(at, 0))
        return value.replace(sp.Heaviside, lambda at, *_: sp.Heaviside(at + sp.S.Half))

    def _with_symbols(self, text: str) -> tuple[str, Names]:
        """Return the text with a symbol in brackets in place of each decimal."""
        pieces, at = [], 0
        known = dict(self.names.variables)
        for token in tokenize(text):
            if not is_decimal(token):
                continue
            symbol = sp.Dummy(f"d_{len(self.decimals)}", real=True)
            name = f"decimal{len(self.decimals)}"
            self.decimals[symbol] = _decimal(token.text)
            known[name] = symbol
            pieces.append(f"{text[at : token.at]}({name})")
            at = token.end
        names = Names(self.names.symbols, known, self.names.values, self.names.functions, self.names.open)
        return "".join([*pieces, text[at:]]), names

    def _condition(self, node: Node) -> Any:
        """Return a condition such as "0 < K < 6" or "a > 0 and b > a", True for "always", False for "never"."""
        text = _text(node)
        with _at(node):
            return self._any_of(text, 0)

    def _any_of(self, text: str, depth: int) -> Any:
        """Conditions joined by "or", each of them of conditions joined by "and", with brackets."""
        text = text.strip()
        if text.lower() in TRUTHS:
            return sp.true if TRUTHS[text.lower()] else sp.false
        if depth > MAX_NESTING:
            raise ExpressionError("the condition is nested too deeply", 0, len(text))
        if found := _EQUATION.match(text):
            sides = [parse_expression(respelled(side), self.names) for side in split(found[2], ",")]
            if len(sides) != 2:
                raise ExpressionError(f"{found[1]} has two sides", 0, len(text))
            return sp.Eq(*sides, evaluate=False) if found[1] == "Eq" else sp.Ne(*sides)
        for pattern, join in ((_OR, sp.Or), (_AND, sp.And)):
            if len(pieces := split(text, pattern)) > 1:
                return join(*(self._any_of(piece, depth + 1) for piece in pieces))
        if text.startswith("(") and matching(text, 0) == len(text) - 1 and _RELATION.search(text):
            return self._any_of(text[1:-1], depth + 1)
        return sp.And(*self._chain(text))

    def _chain(self, text: str) -> list[Any]:
        """The relations of "0 < K < 6"."""
        signs = _RELATION.findall(text)
        if not signs:
            raise ExpressionError("a condition such as 0 < K < 6 is expected here", 0, len(text))
        if signs in (["="], ["=="]):
            return [sp.Eq(*parse_equation(respelled(text).replace("==", "="), self.names), evaluate=False)]
        sides = [parse_expression(respelled(side).strip(), self.names) for side in _RELATION.split(text)]
        relations: dict[str, Any] = dict(RELATIONS) | {"==": sp.Eq}
        try:
            return [relations[sign](sides[i], sides[i + 1]) for i, sign in enumerate(signs)]
        except TypeError:
            raise ExpressionError("only real quantities can be compared", 0, len(text)) from None


def names_for(symbols: Mapping[str, sp.Symbol], values: Mapping[str, Any], ours: Any, discrete: bool) -> Names:
    """Return what names mean in an answer: symbols of the problem and of our answers, and the usual variables."""
    usual = (*MEANINGS, *(name for name in SAMPLES if discrete or name not in symbols))
    own = {str(symbol): symbol for symbol in _symbols_of(ours)}
    known = {**symbols, **own}
    variables: dict[str, Any] = {name: sp.Symbol(name) for name in usual if name not in own}
    units = {"i": sp.I, "I": sp.I, "E": sp.E}
    variables |= {name: unit for name, unit in units.items() if name not in known and name not in values}
    kept = {name: value for name, value in values.items() if name not in own}
    return Names(known, variables, kept, open=True)


def _symbols_of(value: Any) -> set[sp.Symbol]:
    if isinstance(value, Mapping):
        return set().union(*(_symbols_of(each) for each in value.values()))
    if isinstance(value, list | tuple):
        return set().union(*map(_symbols_of, value))
    return set(getattr(value, "free_symbols", ()))


def _decimal(text: str) -> Decimal:
    """Return what a decimal stands for: 0.67 is known to 1/200 and has two digits, 1.5e3 to 50; 0.0 has none."""
    mantissa, _, exponent = text.lower().partition("e")
    places = len(mantissa.partition(".")[2])
    half_unit = sp.Rational(1, 2) * sp.Rational(10) ** (int(exponent or 0) - places)
    return Decimal(sp.Rational(text), half_unit, len(mantissa.replace(".", "").lstrip("0")))


def _rows(node: Node, ours: sp.MatrixBase) -> list[Sequence[Node]]:
    """Return the nodes of a matrix row by row; a flat list is a column where ours is one, else a row."""
    if not isinstance(node, SequenceNode):
        return [[node]]
    if any(isinstance(item, SequenceNode) for item in node.items):
        return [item.items if isinstance(item, SequenceNode) else [item] for item in node.items if _filled(item)]
    if not node.items:
        return []
    column = ours.cols == 1 or (ours.rows != 1 and ours.rows == len(node.items))
    return [[item] for item in node.items] if column else [node.items]


def _filled(node: Node) -> bool:
    return not isinstance(node, SequenceNode) or bool(node.items)


def _word(node: Node) -> str:
    return node.text.strip().lower() if isinstance(node, ScalarNode) else ""


def _words(node: Node) -> str:
    """A verdict in words; case, hyphens and underscores do not matter."""
    return " ".join(_text(node).lower().replace("_", " ").replace("-", " ").split())


def _only(node: Node) -> Node:
    """The one value of a list of one value, as of a matrix of one entry."""
    while isinstance(node, SequenceNode) and len(node.items) == 1:
        node = node.items[0]
    return node


def _text(node: Node) -> str:
    if not isinstance(node, ScalarNode) or node.is_null:
        raise node.fault(f"a value is expected here, not {node.what}")
    return node.text


class _at:  # noqa: N801 - reads as a word: with _at(node)
    """Turns an error in an expression into a fault at its place in the file."""

    def __init__(self, node: Node) -> None:
        self.node = node

    def __enter__(self) -> None:
        return None

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        if isinstance(error, ExpressionError) and isinstance(self.node, ScalarNode):
            note = f"write {error.suggestion}" if error.suggestion else ""
            raise self.node.fault_inside(error.message, error.at, error.length, note=note) from None
