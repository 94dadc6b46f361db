"""What stands under the keys of a system in functions of time: equations, outputs, states, initial values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from solver.problem.equations import EquationReader
from solver.problem.lexicon import Lexicon
from solver.problem.named_functions import sample
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode, scalar
from solver.problem.source import Report, did_you_mean
from solver.systems.ends import End


def _below(name: str, order: int, highest: int) -> str:
    """Why a derivative has no value of its own at an end."""
    if not highest:
        return f"no derivative of {name} occurs"
    return f"the highest derivative of {name} that occurs is of order {highest}, and this is of order {order}"


class FunctionsOfTime:
    """Reads them; a reader of systems builds on it."""

    node: MappingNode
    lexicon: Lexicon
    report: Report
    discrete: bool
    timed: bool = False

    @property
    def barred(self) -> Mapping[str, str]:
        """Names that can't occur in the entries of a system."""
        return {}

    @property
    def _equations(self) -> EquationReader:
        return EquationReader(self.lexicon, discrete=self.discrete, timed=self.timed)

    def _scalars(self, key: str) -> list[ScalarNode]:
        """The texts under a key: none, one or a list."""
        node = self.node.get(key)
        items = node.items if isinstance(node, SequenceNode) else (() if node is None else (node,))
        found: list[ScalarNode] = []
        for item in items:
            with self.report:
                found.append(scalar(item))
        return found

    def dynamic_names(self, key: str) -> list[str]:
        """Return the names that occur with a derivative (discrete: at a sample), in the order of the file."""
        names: dict[str, None] = {}
        for item in self._scalars(key):
            with self.report:
                names.update(dict.fromkeys(self._equations.dynamic_names(item)))
        return list(names)

    def jets(self, key: str) -> tuple[tuple[str, int], ...]:
        """Return functions of time with the orders of their derivatives; each may stand once."""
        found: list[tuple[str, int]] = []
        for item in self._scalars(key):
            with self.report:
                jet = self._equations.jet(item)
                if jet in found:
                    raise item.fault(f"'{item.text}' is given twice")
                found.append(jet)
        return tuple(found)

    def relations(
        self, key: str, functions: Sequence[str]
    ) -> tuple[tuple[tuple[sp.Expr, sp.Expr], ...], dict[Any, Any]]:
        """Return the sides of each equation, and the derivatives that occur by their symbols."""
        sides, jets = [], {}
        for item in self._scalars(key):
            with self.report:
                left, right, inside = self._equations.relation(item, functions)
                sides.append((left, right))
                jets.update(inside)
        return tuple(sides), jets

    def written(self, key: str, functions: Sequence[str]) -> tuple[tuple[tuple[sp.Expr, ...], ...], ...]:
        """Return the terms of the sides of each equation, in the order of the text; of equations that can be read."""
        return tuple(self._equations.written(item, functions) for item in self._scalars(key))

    def formulas(self, key: str, functions: Sequence[str]) -> tuple[tuple[sp.Expr, ...], dict[Any, Any]]:
        """Return expressions in functions of time, and the derivatives that occur by their symbols."""
        found, jets = [], {}
        for item in self._scalars(key):
            with self.report:
                value, inside = self._equations.formula(item, functions)
                found.append(value)
                jets.update(inside)
        return tuple(found), jets

    def initial(self, key: str, functions: Sequence[str]) -> dict[tuple[str, int], sp.Expr]:
        """Return the values of derivatives at the beginning: {x: 0, "x'": 1}, discrete {"y(0)": 0, "y(-1)": 1}."""
        node = self.node.get(key)
        found: dict[tuple[str, int], sp.Expr] = {}
        for entry in node if isinstance(node, MappingNode) else ():
            with self.report:
                text = entry.key.text
                start = sample(text) if self.discrete else None
                jet = start or self._equations.jet(entry.key)
                if jet[0] not in functions:
                    meant = did_you_mean(jet[0], functions)
                    raise entry.key.fault(f"'{text[:40]}' is no unknown of the equations", suggestion=meant)
                found[jet] = self.lexicon.expression(entry.value, barred=self.barred)
        return found

    def ends(self, key: str, orders: Mapping[str, int], *, free_time: bool) -> dict[tuple[str, int], tuple[End, ...]]:
        """Return what is asked at both ends of functions and their derivatives: values, free, or a curve.

        Of a function with a highest derivative (`orders`) only those below it are asked for. Only the last end may lie
        on a curve, and only where the time of it is free.
        """
        node = self.node.get(key)
        found: dict[tuple[str, int], tuple[End, ...]] = {}
        for entry in node if isinstance(node, MappingNode) else ():
            with self.report:
                jet = self._equations.jet(entry.key)
                if jet[0] not in orders:
                    meant = did_you_mean(jet[0], orders)
                    raise entry.key.fault(f"'{entry.key.text[:40]}' is none of the functions", suggestion=meant)
                if jet[1] >= max(orders[jet[0]], 1):
                    raise entry.key.fault("nothing can be asked of this at an end", note=_below(*jet, orders[jet[0]]))
                items = entry.value.items if isinstance(entry.value, SequenceNode) else ()
                if len(items) != 2:
                    raise entry.value.fault("two ends are expected here: what holds at the first and at the last time")
                found[jet] = tuple(self._end(item) for item in items)
                for last, item in enumerate(items):
                    if isinstance(item, MappingNode):
                        self._check_curve(item, jet[1], last=bool(last), free_time=free_time)
        return found

    def _check_curve(self, node: MappingNode, order: int, *, last: bool, free_time: bool) -> None:
        if not last:
            raise node.fault("only the last end may lie on a curve; the first is a value or free")
        if not free_time:
            raise node.fault("an end on a curve needs to: free, since the time is where the curve is met")
        if order:
            raise node.fault("a function may end on a curve; the end of a derivative is a value or free")

    def _end(self, node: Node) -> End:
        if isinstance(node, MappingNode):
            return End(curve=self._equations.formula(scalar(node["on"]), ())[0])
        item = scalar(node)
        if item.text == "free":
            return End()
        value = self._equations.formula(item, ())[0]
        if value.has(sp.Symbol("t")):
            raise item.fault("a value at an end is no function of t", note="a curve is written {on: 2 - t}")
        return End(value=value)

    def assumed(self, functions: Sequence[str]) -> dict[str, Any]:
        """Return the symbols of those functions of time of which more is assumed than that they are real, by name."""
        found: dict[str, Any] = {}
        for name in functions:
            symbol, word = self.lexicon.symbols.get(name), self.lexicon.assumed.get(name, "")
            if symbol is None or word == "real":
                continue
            if word in ("complex", "integer"):
                with self.report:
                    message = f"'{name}' is a function of time, which is real"
                    note = "positive, negative or nonzero may be assumed"
                    raise self.lexicon.assume_nodes[name].fault(message, note=note)
            else:
                found[name] = symbol
        return found
