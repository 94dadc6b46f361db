"""Equations in functions of time, read: their derivatives (discrete: samples) become symbols of their own."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from solver.jets import Jet, jet_symbol
from solver.problem.expressions import ExpressionError, Names, parse_equation, parse_expression, uses_decimal
from solver.problem.expressions.notation import FUNCTIONS
from solver.problem.expressions.tokens import Kind, Token, tokenize
from solver.problem.lexicon import Lexicon
from solver.problem.nodes import ScalarNode

Jets = dict[sp.Symbol, Jet]
MAX_ORDER = 12
BINDING = ("*", "/", "^")
"""Operators after which a sign belongs to the operand: x^-1."""


class EquationReader:
    """Reads texts in which some names are functions of time; where it is `timed`, t may stand by itself."""

    def __init__(self, lexicon: Lexicon, *, discrete: bool, timed: bool = False) -> None:
        self.lexicon = lexicon
        self.discrete = discrete
        self.timed = timed
        self.time = sp.Symbol("k" if discrete else "t", **({"integer": True} if discrete else {"real": True}))

    def dynamic_names(self, node: ScalarNode) -> Iterator[str]:
        """Yield the names with a derivative x', x^(4) (discrete: with an argument, y(k+1)), in their order."""
        tokens = _tokens(node)
        for at, token in enumerate(tokens[:-1]):
            if token.kind is Kind.NAME and token.text not in FUNCTIONS and self._is_dynamic(tokens[at + 1 : at + 5]):
                yield token.text

    def _is_dynamic(self, following: list[Token]) -> bool:
        signs = [token.text for token in following]
        if self.discrete:
            return signs[:2] == ["(", "k"]
        return signs[0] == "'" or (signs[:2] == ["^", "("] and signs[2].isdigit() and signs[3] == ")")

    def relation(self, node: ScalarNode, functions: Collection[str]) -> tuple[sp.Expr, sp.Expr, Jets]:
        """Return left and right side of an equation, or an expression and zero."""
        if any(token.text == "=" for token in _tokens(node)):
            left, right = self._parse(node, functions, parse_equation)
        else:
            left, right = self._parse(node, functions, parse_expression), sp.Integer(0)
        jets: Jets = {}
        return self._in_jets(left, node, jets), self._in_jets(right, node, jets), jets

    def written(self, node: ScalarNode, functions: Collection[str]) -> tuple[tuple[sp.Expr, ...], ...]:
        """Return the terms of the left and of the right side of a relation that is read, in the order of the text."""
        sides: tuple[list[sp.Expr], list[sp.Expr]] = ([], [])
        for side, sign, text in _terms(node):
            value = self._parse(ScalarNode(node.place, text), functions, parse_expression)
            sides[side].append(sign * self._in_jets(value, node, {}))
        return tuple(tuple(term for term in terms if term != 0) for terms in sides)

    def formula(self, node: ScalarNode, functions: Collection[str]) -> tuple[sp.Expr, Jets]:
        """Return an expression."""
        jets: Jets = {}
        return self._in_jets(self._parse(node, functions, parse_expression), node, jets), jets

    def jet(self, node: ScalarNode) -> Jet:
        """Return the function and the order of x, x', x^(4), y(k+1)."""
        (name, *_) = _tokens(node)
        _, jets = self.formula(node, [name.text])
        if name.kind is not Kind.NAME or len(jets) != 1:
            raise node.fault("a function of time or a derivative of one is expected here: x, x', y(k+1)")
        return next(iter(jets.values()))

    def _parse(self, node: ScalarNode, functions: Collection[str], parse: Any) -> Any:
        lexicon, t = self.lexicon, self.time
        table = {name: sp.Function(name, real=True)(t) for name in functions}
        values = {name: value for name, value in lexicon.values.items() if name not in table}
        names = Names(lexicon.symbols, {str(t): t}, values, table, open=True)
        try:
            found = parse(node.text, names)
        except ExpressionError as error:
            note = f"write {error.suggestion}" if error.suggestion else ""
            raise node.fault_inside(error.message, error.at, error.length, note=note) from None
        lexicon.used.update(token.text for token in _tokens(node) if token.kind is Kind.NAME)
        lexicon.decimals = lexicon.decimals or uses_decimal(node.text)
        return found

    def _in_jets(self, value: sp.Expr, node: ScalarNode, jets: Jets) -> sp.Expr:
        """Put symbols in place of the functions of time; `jets` has them in the order of the text, the latest first."""
        found: Any = value
        names = list(dict.fromkeys(token.text for token in _tokens(node)))
        for kind in (sp.Derivative, AppliedUndef):  # the derivatives first: x stands within x'
            put: dict[Any, sp.Symbol] = {}
            for each in sorted(found.atoms(kind), key=lambda each: _place(self._jet_of(each, node), names)):
                jet = self._jet_of(each, node)
                put[each] = jet_symbol(jet, discrete=self.discrete)
                jets[put[each]] = jet
            found = found.xreplace(put)
        if self.timed:
            found = found.xreplace({self.time: sp.Symbol("t")})
        elif self.time in found.free_symbols and not self.discrete:
            raise node.fault("the time t cannot stand in the equations of a system by itself")
        for symbol in found.free_symbols - {*jets, *([sp.Symbol("t")] if self.timed else [])}:
            self.lexicon.found[str(symbol)] = symbol
        return found

    def _jet_of(self, each: Any, node: ScalarNode) -> Jet:
        """Return the function and the order of a derivative, or of a function at a time."""
        function, order = (each.expr, int(each.derivative_count)) if isinstance(each, sp.Derivative) else (each, 0)
        ahead = self._ahead(function, node)
        order = order or ahead
        if abs(order) > MAX_ORDER:
            raise node.fault(f"derivatives and samples are read up to order {MAX_ORDER}")
        return str(function.func.__name__), order

    def _ahead(self, function: Any, node: ScalarNode) -> int:
        """How many samples ahead: 2 for y(k+2)."""
        ahead = sp.expand(function.args[0] - self.time)
        if not ahead.is_Integer:
            variable = "k, as in y(k+1)" if self.discrete else "t"
            raise node.fault(f"a function of time is written at the time {variable}")
        if ahead and not self.discrete:
            note = "a dead time is written in a transfer function: exp(-s)/(s + 1); samples need time: discrete"
            raise node.fault(f"{function.func.__name__}({function.args[0]}) is the value at another time", note=note)
        return int(ahead)


def _place(jet: Jet, names: list[str]) -> tuple[int, str, int]:
    """Where a jet comes: after those of names that stand before its own, and after the higher ones of its own."""
    name, order = jet
    return (names.index(name) if name in names else len(names), name, -order)


def _terms(node: ScalarNode) -> Iterator[tuple[int, int, str]]:
    """Yield the terms of an equation: 0 or 1 for the left or right side, the sign, and the text without it."""
    side, sign, start, depth, before = 0, 1, 0, 0, ""
    for token in _tokens(node):
        depth += (token.text == "(") - (token.text == ")")
        inside, before = depth or before in BINDING, token.text
        if token.kind is not Kind.END and (inside or token.text not in {"+", "-", "="}):
            continue
        if text := node.text[start : token.at].strip():
            yield side, sign, text
            sign = 1
        side += token.text == "="
        sign, start = -sign if token.text == "-" else sign, token.end


def _tokens(node: ScalarNode) -> list[Token]:
    try:
        return tokenize(node.text)
    except ExpressionError as error:
        raise node.fault_inside(error.message, error.at, error.length) from None
