"""One text as an expression or a condition, in one reading of a value."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import sympy as sp

from solver.classroom.reading.angles import readings_in_degrees, with_arcs, with_rounded_degrees
from solver.classroom.reading.choices import Choices
from solver.classroom.reading.condition_words import in_relations, is_unclear, with_ends
from solver.classroom.reading.conditions import ConditionReader
from solver.classroom.reading.decimals import decimals_of
from solver.classroom.reading.latex import is_latex, translated
from solver.classroom.reading.nodes import At, only, text_of
from solver.classroom.reading.notations import has_bare_call, plain
from solver.classroom.reading.programs import inside_idle_call
from solver.classroom.reading.said_twice import agree, sides
from solver.classroom.reading.spelling import respelled, typed
from solver.classroom.reading.transfer_functions import with_quotients
from solver.classroom.reading.units import ForeignUnitError, without_unit
from solver.classroom.reading.words import mixed_number
from solver.classroom.submitted import Decimal
from solver.problem.expressions import Doubt, ExpressionError, Names, parse_written
from solver.problem.expressions.notation import MAX_CHARACTERS
from solver.problem.nodes import Node, ScalarNode
from solver.problem.source import Fault

_DECIBELS = re.compile(r"(\b20\s*[*·]?\s*)log(?=\s*[(|√]|\s+\d)")
"""20 log of decibels is that to the base 10."""
Pair = tuple[Any, Any]
"""A value, and its form with a symbol for each decimal."""


class TextReader:
    """Reads the texts of a value; `decimals` are those met so far, `respelt` tells that a text was read as another.

    Where `numbers` are asked for, one may be said twice, π/3 ≈ 1.047.
    """

    def __init__(self, names: Names, choices: Choices, unit: str = "", *, discrete: bool = False) -> None:
        self.names = names
        self.choices = choices
        self.unit = unit
        self.variable = "z" if discrete else "s"
        self.discrete = discrete
        self.decimals: dict[sp.Symbol, Decimal] = {}
        self.respelt = False
        self.numbers = False

    def expression(self, node: Node) -> Pair:
        """Return the value of an expression; raises Fault."""
        values = self.alternatives(only(node))
        if len(values) > 1:
            raise node.fault("± stands for two values; one is expected here")
        return values[0]

    def alternatives(self, node: Node) -> list[Pair]:
        """Return the value, or the two of an expression with ±, each with its form; raises Fault."""
        written = text_of(node)
        if self.numbers and len(equal := sides(written)) > 1 and (said := self._first_of(node, equal)):
            self.respelt = True
            return said
        if mixed := mixed_number(self._bare(written)):
            written = self.choices.choose(("mixed", written), mixed)
        with At(node):
            text = self._plain(written)
        with At(node, inside=text == written):
            decimals = decimals_of(text, len(self.decimals), whole=self.unit == "°" and self.numbers)
            self.decimals |= dict(decimals.values())
            symbols = {place: symbol for place, (symbol, _) in decimals.items()}
            pairs = parse_written(text, self.names, symbols, self._decide)
            if self.unit == "°":
                pairs = tuple(map(self._in_degrees, pairs))
            return [(self._sampled(value), self._sampled(form)) for value, form in pairs]

    def _in_degrees(self, pair: Pair) -> Pair:
        """An angle in degrees: what has π or an arctangent is in radians."""
        values, forms = (readings_in_degrees(each, self.decimals) for each in pair)
        found = list(zip(values, forms, strict=False))
        self.respelt = self.respelt or found[0] != pair
        return self.choices.choose(("angle", pair[0]), found) if len(found) > 1 else found[0]

    def _first_of(self, node: Node, equal: list[str]) -> list[Pair]:
        """The first of numbers that are said to be equal; nothing where they are none. Raises Fault if they differ."""
        found: list[Pair] = []
        known = [dict(self.decimals)]
        for text in equal:
            try:
                found += self.alternatives(ScalarNode(node.place, text, "quoted"))
            except Fault:
                return []
            known.append(dict(self.decimals))
        if len(found) != len(equal) or any(value.free_symbols for value, _ in found):
            return []
        (_, first), *others = found
        if not all(agree(first, form, self.decimals) for _, form in others):
            raise node.fault(f"{' and '.join(each.strip() for each in equal)} are not equal")
        self.decimals = known[1]
        return found[:1]

    def condition(self, node: Node, name: str = "", *, form: bool = False) -> Any:
        """Return a condition such as "0 < K < 6", True for "always", False for "never"; raises Fault.

        Decimals in it stand for themselves, in its form for what they are rounded from.

        The interval (0, 6) alone is a condition on the parameter of this name.
        """
        text = text_of(node) if isinstance(node, ScalarNode) else typed(node)
        if len(text) > MAX_CHARACTERS:
            raise node.fault(f"a condition is longer than {MAX_CHARACTERS} characters")
        with At(node):
            text = translated(text) if is_latex(text) else text
            self.respelt = self.respelt or in_relations(text) != text.strip()
            if is_unclear(text):
                text = with_ends(text, closed=self.choices.choose(("ends", text), (False, True)))
            return ConditionReader(self._form_of_side if form else self._side, name).read(text)

    def _side(self, text: str) -> Any:
        """One side of a condition, where decimals stand for themselves. Raises ExpressionError."""
        return self._pair_of_side(text, {})[0]

    def _form_of_side(self, text: str) -> Any:
        """One side of a condition, with a symbol for each decimal. Raises ExpressionError."""
        decimals = decimals_of(self._plain(text), len(self.decimals))
        self.decimals |= dict(decimals.values())
        return self._pair_of_side(text, {place: symbol for place, (symbol, _) in decimals.items()})[1]

    def _pair_of_side(self, text: str, decimals: Mapping[int, sp.Symbol]) -> Pair:
        pair, *others = parse_written(self._plain(text), self.names, decimals, self._decide)
        if others:
            raise ExpressionError("± stands for two values; one is expected here", 0, len(text))
        return pair

    @property
    def ones(self) -> dict[Any, Any]:
        """What u(t) is where an answer holds from t = 0 on, and ours does without it."""
        t, k = (self.names.variables.get(name, sp.Symbol(name)) for name in ("t", "k"))
        return {sp.Heaviside(k + sp.S.Half) if self.discrete else sp.Heaviside(t): sp.S.One}

    def _decide(self, doubt: Doubt) -> bool:
        self.respelt = True
        usual = doubt in (Doubt.EXPONENT, Doubt.ARGUMENT)
        return self.choices.choose(doubt, (usual, not usual))

    def _bare(self, text: str) -> str:
        """A text without its unit, where it has one that belongs to the answer."""
        try:
            return without_unit(text, self.unit)
        except ForeignUnitError:
            return text

    def _plain(self, text: str) -> str:
        """A text in our notation, without its unit; one that is too long stays as it is, and is refused."""
        if len(text) > MAX_CHARACTERS:
            return text
        while (kept := inside_idle_call(text.strip())) and not self.names.declares(
            text.split("(", maxsplit=1)[0].strip()
        ):
            text = kept
        bare = without_unit(_DECIBELS.sub(r"\1log10", text) if self.unit == "dB" else text, self.unit)
        bare = with_arcs(bare) if self.unit == "°" else with_rounded_degrees(bare)
        found = with_quotients(bare, self.variable)
        found = plain(found, self.names, self.choices)
        said = _squeezed(found) == _squeezed(respelled(bare))
        self.respelt = self.respelt or not said or has_bare_call(found)
        return found if found.strip() != text.strip() else text

    def _sampled(self, value: Any) -> Any:
        """In discrete time δ(k) is 1 at k = 0, and the step is 1 from 0 on."""
        if not self.discrete:
            return value
        value = value.replace(sp.DiracDelta, lambda at, *_: sp.KroneckerDelta(at, 0))
        return value.replace(sp.Heaviside, lambda at, *_: sp.Heaviside(at + sp.S.Half))


def _squeezed(text: str) -> str:
    """A text without the spaces that separate nothing."""
    return re.sub(r"\s*([^\w\s])\s*", r"\1", text).strip()
