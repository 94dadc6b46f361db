"""Conditions as students write them: 0 < K < 6, a > 0 and b > a, K in (0, 6), Eq(a, b), always."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import sympy as sp

from solver.classroom.reading.brackets import matching, split
from solver.classroom.reading.condition_words import in_relations
from solver.classroom.reading.words import NO, YES
from solver.problem.expressions import ExpressionError

MAX_NESTING = 12
RELATIONS = (("<=", sp.Le), (">=", sp.Ge), ("≤", sp.Le), ("≥", sp.Ge), ("!=", sp.Ne), ("≠", sp.Ne), ("<", sp.Lt),
             (">", sp.Gt), ("=", sp.Eq))  # fmt: skip
_RELATION = re.compile(r"<=|>=|!=|[≤≥≠<>]|==?")
_AND = re.compile(r"\s+(?:and|und|et)\s+|\s*(?:&&?|∧|;|,)\s*", re.IGNORECASE)
_OR = re.compile(r"\s+(?:or|oder|ou)\s+|\s*(?:\|\|?|∨)\s*", re.IGNORECASE)
_SEVERAL = re.compile(r"^((?:[^\W\d]\w*\s*,\s*)+[^\W\d]\w*)\s*([<>≤≥].*)$", re.DOTALL)
_EQUATION = re.compile(r"^(Eq|Ne|And|Or)\s*\((.*)\)$", re.DOTALL)
_INTERVAL = re.compile(r"^([^()\[\]]+?)\s*(?:∈|\bin\b)\s*([\[\](])([^,;<>=]+)[,;]([^,;<>=]+)([\])\[])$", re.DOTALL)


class ConditionReader:
    """Reads conditions; `side` reads what stands beside their signs. An interval alone is of the parameter `name`."""

    def __init__(self, side: Callable[[str], Any], name: str = "") -> None:
        self.side = side
        self.name = name

    def read(self, text: str) -> Any:
        """Return the condition, True for "always", False for "never". Raises ExpressionError."""
        text = in_relations(text)
        if found := _SEVERAL.match(text):  # a, b > 0
            text = " and ".join(f"{name} {found[2]}" for name in found[1].split(","))
        return self._any_of(text, 0)

    def _any_of(self, text: str, depth: int) -> Any:
        """Conditions joined by "or", each of them of conditions joined by "and", with brackets."""
        text = text.strip()
        if self.name and text[:1] in tuple("()[]") and _INTERVAL.match(f"{self.name} in {text}"):
            text = f"{self.name} in {text}"
        if self.name and _RELATION.match(text):  # > 4
            text = f"{self.name} {text}"
        if text.lower() in YES | NO:
            return sp.true if text.lower() in YES else sp.false
        if depth > MAX_NESTING:
            raise ExpressionError("the condition is nested too deeply", 0, len(text))
        if found := _EQUATION.match(text):
            return self._called(found[1], text, depth)
        if found := _INTERVAL.match(text):
            return self._interval(found)
        for pattern, join in ((_OR, sp.Or), (_AND, sp.And)):
            if len(pieces := split(text, pattern)) > 1:
                return join(*(self._any_of(piece, depth + 1) for piece in pieces))
        if text.startswith("(") and matching(text, 0) == len(text) - 1 and _RELATION.search(text):
            return self._any_of(text[1:-1], depth + 1)
        return sp.And(*self._chain(text))

    def _called(self, name: str, text: str, depth: int) -> Any:
        """The relations of sympy: Eq(a, b), And(a > 0, b > 0)."""
        arguments = split(text[text.index("(") + 1 : -1], ",")
        if name in ("And", "Or"):
            joined = [self._any_of(each, depth + 1) for each in arguments]
            return sp.And(*joined) if name == "And" else sp.Or(*joined)
        if len(arguments) != 2:
            raise ExpressionError(f"{name} has two sides", 0, len(text))
        left, right = map(self.side, arguments)
        return sp.Eq(left, right, evaluate=False) if name == "Eq" else sp.Ne(left, right)

    def _interval(self, found: re.Match[str]) -> Any:
        """K in (0, 6], or ]0, 6]; a bound of infinity is none."""
        name, lower, upper = (self.side(found[i]) for i in (1, 3, 4))
        below = sp.Le(lower, name) if found[2] == "[" else sp.Lt(lower, name)
        above = sp.Le(name, upper) if found[5] == "]" else sp.Lt(name, upper)
        bounds = [each for each, bound in ((below, lower), (above, upper)) if bound not in (sp.oo, -sp.oo)]
        return sp.And(*bounds)

    def _chain(self, text: str) -> list[Any]:
        """The relations of "0 < K < 6"."""
        signs = _RELATION.findall(text)
        if not signs:
            raise ExpressionError("a condition such as 0 < K < 6 is expected here", 0, len(text))
        if signs in (["="], ["=="]):
            return [sp.Eq(*map(self.side, _RELATION.split(text)), evaluate=False)]
        sides = [self.side(side) for side in _RELATION.split(text)]
        relations: dict[str, Any] = dict(RELATIONS) | {"==": sp.Eq}
        try:
            return [relations[sign](sides[i], sides[i + 1]) for i, sign in enumerate(signs)]
        except TypeError:
            raise ExpressionError("only real quantities can be compared", 0, len(text)) from None
