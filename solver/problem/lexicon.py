"""What names mean in one problem, and the reading of its values as expressions."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, TypeVar

import sympy as sp

from solver.conditions import Parameter
from solver.problem.conditions import Sided, declare
from solver.problem.expressions import (
    ExpressionError,
    Names,
    canonical_name,
    parse_alternatives,
    parse_expression,
    parse_fraction,
    uses_decimal,
)
from solver.problem.expressions.tokens import Kind, tokenize
from solver.problem.model import Chain
from solver.problem.nodes import MappingNode, Node, ScalarNode, scalar
from solver.problem.source import Report, did_you_mean
from solver.symbols import MEANINGS

R = TypeVar("R")

_WHOLE = re.compile(r"0|-?[1-9][0-9]{0,8}")

ASSUMPTIONS: Mapping[str, Mapping[str, bool]] = {
    "positive": {"positive": True},
    "negative": {"negative": True},
    "nonzero": {"real": True, "nonzero": True},
    "real": {"real": True},
    "complex": {"complex": True},
    "integer": {"integer": True},
}

NOTHING = "leave the key out where there is nothing"
BARRED = MEANINGS | {"NaN": "it is not a number", "none": NOTHING, "None": NOTHING}
"""Names that can't be parameters."""


@dataclass
class Lexicon:
    """The names of a problem; remembers which were used, and whether a decimal was typed.

    `symbols` are declared ones with their assumptions, `values` what is put in place of a name; `found` all symbols
    that occur in what was read, by name. `assumed` are the words that `assume` has for names. `conditions` are those on
    the symbols, `condition_nodes` where they stand;
    `assume_nodes` where the words of `assumed` stand.
    """

    symbols: dict[str, sp.Symbol] = field(default_factory=dict)
    values: dict[str, sp.Expr] = field(default_factory=dict)
    found: dict[str, sp.Symbol] = field(default_factory=dict)
    assumed: dict[str, str] = field(default_factory=dict)
    used: set[str] = field(default_factory=set)
    decimals: bool = False
    conditions: list[tuple[Sided, Chain]] = field(default_factory=list)
    condition_nodes: tuple[Node, ...] = ()
    assume_nodes: dict[str, Node] = field(default_factory=dict)

    def took_decimals(self) -> bool:
        """Whether a decimal was typed in what was read since this was asked last."""
        taken, self.decimals = self.decimals, False
        return taken

    @property
    def chains(self) -> tuple[Chain, ...]:
        """The conditions as they are shown."""
        return tuple(chain for _, chain in self.conditions)

    @property
    def assumptions(self) -> dict[str, tuple[sp.Symbol, ...]]:
        """What is assumed of symbols as it is shown: each word with its symbols, without `real`, which all are."""
        said = {name: word for name, word in self.assumed.items() if word != "real"}
        return {word: tuple(self.symbols[x] for x in said if said[x] == word) for word in said.values()}

    @property
    def declared(self) -> dict[str, Any]:
        """What a part of its own names keeps of them: its symbols, values and assumptions."""
        symbols = {**self.symbols, **self.found}
        return {"symbols": symbols, "parameters": dict(self.values), "assumed": self.assumptions}

    def expression(self, node: Node, variables: Collection[str] = (), barred: Mapping[str, str] = BARRED) -> sp.Expr:
        """Return a value as a finite exact expression, in which the `variables` may occur and the `barred` may not."""
        if _WHOLE.fullmatch(text := scalar(node).text):  # most entries of a course: they need no grammar
            return sp.Integer(int(text))
        value: sp.Expr = self._read(parse_expression, scalar(node), variables, barred)
        _check_finite(node, value)
        return value

    def fraction(
        self, node: Node, variables: Collection[str] = (), barred: Mapping[str, str] = BARRED
    ) -> tuple[sp.Expr, sp.Expr]:
        """Return a value as numerator and denominator, factors common to both kept as written."""
        sides: tuple[sp.Expr, sp.Expr] = self._read(parse_fraction, scalar(node), variables, barred)
        for side in sides:
            _check_finite(node, side)
        return sides

    def alternatives(self, node: Node, barred: Mapping[str, str] = BARRED) -> tuple[sp.Expr, ...]:
        """Return the one value, or the two of "-3 ± 2j"."""
        values: tuple[sp.Expr, ...] = self._read(parse_alternatives, scalar(node), (), barred)
        for value in values:
            _check_finite(node, value)
        return values

    def _read(
        self, parse: Callable[[str, Names], R], node: ScalarNode, variables: Collection[str], barred: Mapping[str, str]
    ) -> R:
        text = node.text
        names = Names(self.symbols, {name: sp.Symbol(name) for name in variables}, self.values, open=True)
        try:
            tokens = list(tokenize(text))
            for token in tokens:
                if token.text in barred and token.text not in variables:
                    message = f"'{text[token.at : token.end]}' cannot stand here: {barred[token.text]}"
                    raise ExpressionError(message, token.at, token.end - token.at)
            value = parse(text, names)
        except ExpressionError as error:
            note = f"write {error.suggestion}" if error.suggestion else ""
            raise node.fault_inside(error.message, error.at, error.length, note=note) from None
        self.used.update(token.text for token in tokens if token.kind is Kind.NAME)
        self.decimals = self.decimals or uses_decimal(text)
        self._remember(value if isinstance(value, tuple) else (value,), variables)
        return value

    def _remember(self, values: Collection[object], variables: Collection[str]) -> None:
        for value in values:
            for symbol in getattr(value, "free_symbols", ()):
                if symbol.name not in variables:
                    self.found[symbol.name] = symbol


def exact_number(node: Node) -> sp.Rational:
    """Return a value that must be a rational number, such as marks; it is no part of the problem's mathematics."""
    value = Lexicon().expression(node)
    if not isinstance(value, sp.Rational):
        raise node.fault(f"a number is expected here, not {node.what}")
    number: sp.Rational = value
    return number


def name_of(node: ScalarNode) -> str:
    """Return the plain spelling of a name (`lamda` for λ); raises Fault if it is none."""
    try:
        return canonical_name(node.text)
    except ExpressionError as error:
        raise node.fault_inside(error.message, error.at, error.length) from None


@dataclass(frozen=True)
class Declarations:
    """The values that say what names mean, in a problem or a part; None where there is none."""

    parameters: Node | None = None
    assume: Node | None = None
    conditions: Node | None = None

    def __bool__(self) -> bool:
        return isinstance(self.parameters, MappingNode) or self.assume is not None or self.conditions is not None


def read_lexicon(
    given: Declarations, report: Report, around: Lexicon | None = None, positive: Collection[str] = ()
) -> Lexicon:
    """Return the names that the problem declares, or a part: then those `around` it hold where it says nothing else.

    Of `positive` texts those that are names without a value are positive where nothing else is assumed of them.
    What is wrong with some of them goes to the report.
    """
    lexicon = Lexicon()
    for entry in given.assume if isinstance(given.assume, MappingNode) else ():
        with report:
            name = _declared(entry.key, lexicon.symbols)
            lexicon.assumed[name] = scalar(entry.value).text
            lexicon.assume_nodes[name] = entry.value
            lexicon.symbols[name] = sp.Symbol(name, **ASSUMPTIONS[lexicon.assumed[name]])
    own = set(lexicon.symbols)
    for name in _names_among(positive):
        if name not in own and not (isinstance(given.parameters, MappingNode) and name in given.parameters):
            lexicon.assumed[name] = "positive"
            lexicon.symbols[name] = sp.Symbol(name, positive=True)
    if around is not None:
        lexicon.symbols = {**{name: _plain(x) for name, x in around.symbols.items()}, **lexicon.symbols}
    if isinstance(given.parameters, MappingNode):
        _read_values(given.parameters, lexicon, report)
    if around is not None:
        kept = {name: value for name, value in around.values.items() if name not in own}
        lexicon.values = {**kept, **lexicon.values}
    nodes = (*(around.condition_nodes if around else ()), *([given.conditions] if given.conditions else []))
    declare(lexicon, nodes, report)
    return lexicon


def _names_among(texts: Collection[str]) -> list[str]:
    """The texts that are names and may be those of parameters, in their plain spelling."""
    found: list[str] = []
    for text in texts:
        with suppress(ExpressionError):
            value = parse_expression(text, Names({}, {}, {}, open=True))
            found += [value.name] if isinstance(value, sp.Symbol) and value.name not in BARRED else []
    return found


def _plain(x: sp.Symbol) -> sp.Symbol:
    return x.plain if isinstance(x, Parameter) else x


def _read_values(parameters: MappingNode, lexicon: Lexicon, report: Report) -> None:
    """Read the parameters in their order; a value may refer to those before it."""
    later = {entry.key.text: "its value is given further down" for entry in parameters}
    read = dict.fromkeys(later)
    for entry in parameters:
        with report:
            del read[entry.key.text]
            barred = BARRED | {name: later[name] for name in read} | {entry.key.text: "it is what is defined"}
            name = _declared(entry.key, lexicon.values)
            if (word := getattr(entry.value, "text", "")) in ASSUMPTIONS:
                note = f"write assume: {{{entry.key.text}: {word}}}"
                raise entry.value.fault(f"'{word}' is what can be assumed of a name, not a value", note=note)
            lexicon.values[name] = lexicon.expression(entry.value, barred=barred)


def _declared(key: ScalarNode, others: Collection[str]) -> str:
    """Return the name that a key declares."""
    name = name_of(key)
    if name in BARRED:
        raise key.fault(f"'{key.text}' cannot be a parameter: {BARRED[name]}")
    if name in others:
        raise key.fault(f"'{key.text}' is given twice: it is the same name as '{name}'")
    return name


def check_used(parameters: Node | None, lexicon: Lexicon, report: Report) -> None:
    """Report parameters that occur nowhere: probably misspelt."""
    for entry in parameters if isinstance(parameters, MappingNode) else ():
        if name_of(entry.key) not in lexicon.used:
            suggestion = did_you_mean(entry.key.text, lexicon.found)
            message = f"the parameter '{entry.key.text}' occurs nowhere"
            report.diagnostics.append(entry.key.diagnostic(message, suggestion))


def _check_finite(node: Node, value: object) -> None:
    if isinstance(value, sp.Basic) and value.has(sp.oo, -sp.oo, sp.zoo, sp.nan):
        raise node.fault("a finite value is expected here")
