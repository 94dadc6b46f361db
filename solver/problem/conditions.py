"""Conditions on parameters, `0 < zeta < 1`, `a != b`: read, and given to the symbols that they are about."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import TYPE_CHECKING

import sympy as sp

from solver.conditions import Condition, Parameter, assumed_of, symbols_of
from solver.problem.model import Chain
from solver.problem.nodes import Node, ScalarNode, SequenceNode, scalar
from solver.problem.source import Diagnostic, Fault, Report, did_you_mean

if TYPE_CHECKING:
    from solver.problem.lexicon import Lexicon

MOST = 20
SIGN = re.compile(r"<=|>=|!=|==|=<|=>|<>|[<>=≤≥≠]")
SIGNS = {"<": "<", "<=": "<=", "≤": "<=", ">": ">", ">=": ">=", "≥": ">=", "!=": "!=", "≠": "!="}
EQUATION = {"=": "=", "==": "="}
INSTEAD = {"=<": "<=", "=>": ">=", "<>": "!="}


@dataclass(frozen=True)
class Sided:
    """A condition as it stands: its node, the sides' nodes and the signs between them."""

    node: ScalarNode
    sides: tuple[ScalarNode, ...]
    signs: tuple[str, ...]


def declare(lexicon: Lexicon, nodes: Sequence[Node], report: Report) -> None:
    """Give the symbols of a lexicon what conditions say of them. What is wrong with these goes to the report."""
    lexicon.condition_nodes = tuple(nodes)
    reading = replace(lexicon, found={})
    for each in (sided for node in nodes for sided in split(node, report)):
        with report:
            chain = chain_of(each, [reading.expression(side) for side in each.sides])
            lexicon.conditions.append((each, chain))
    lexicon.decimals |= reading.decimals
    lexicon.symbols |= declared([chain for _, chain in lexicon.conditions], report)


def check_occurring(lexicon: Lexicon, found: Collection[str], report: Report) -> None:
    """Report conditions on symbols that occur nowhere else: probably misspelt."""
    for sided, chain in lexicon.conditions:
        for x in symbols_of(*chain.sides):
            if x.name not in found:
                suggestion = did_you_mean(x.name, found)
                message = f"there is no parameter '{x.name}': it occurs nowhere but in this condition"
                report.diagnostics.append(sided.node.diagnostic(message, suggestion))


def split(node: Node, report: Report, *, equations: bool = False) -> list[Sided]:
    """Return the conditions of a list, in their sides; `equations` are some too. What is none goes to the report."""
    items = node.items if isinstance(node, SequenceNode) else (node,)
    found: list[Sided] = []
    if len(items) > MOST:
        report.diagnostics.append(node.diagnostic(f"there are {len(items)} conditions; at most {MOST} can be read"))
    for item in items[:MOST]:
        with report:
            found.append(_sided(scalar(item), SIGNS | EQUATION if equations else SIGNS))
    return found


def _sided(node: ScalarNode, known: Mapping[str, str]) -> Sided:
    """A condition cut at its signs, those known; each side keeps its place in the text."""
    text, sides, signs, start = node.text, [], [], 0
    for sign in SIGN.finditer(text):
        sides.append((start, sign.start()))
        signs.append(_sign(node, sign, known))
        start = sign.end()
    sides.append((start, len(text)))
    if not signs:
        note = "conditions are relations: 0 < zeta < 1, a != b, b^2 >= 4 a c"
        raise node.fault("a relation with <, <=, >, >= or != is expected here", note=note)
    for low, high in sides:
        if not text[low:high].strip():
            raise node.fault_inside("an expression is expected on both sides of the relation", max(0, low - 1), 1)
    if "!=" in signs and len(signs) > 1:
        raise node.fault("!= stands between two expressions only", note="write two conditions")
    if len({sign[0] for sign in signs}) > 1:
        raise node.fault("all signs of a chain point the same way", note="write 0 < a < 1, or two conditions")
    padded = tuple(
        replace(node, text=" " * low + text[low:high] + " " * (len(text) - high)) for low, high in sides
    )  # fmt: skip
    return Sided(node, padded, tuple(signs))


def _sign(node: ScalarNode, sign: re.Match[str], known: Mapping[str, str]) -> str:
    written = sign.group()
    if written in known:
        return known[written]
    if written in INSTEAD:
        raise node.fault_inside(f"'{written}' is no relation", sign.start(), 2, suggestion=INSTEAD[written])
    note = "a value is given under 'parameters'; conditions are relations with <, <=, >, >= or !="
    raise node.fault_inside("an equation is no condition", sign.start(), len(written), note=note)


def chain_of(sided: Sided, sides: Sequence[sp.Expr]) -> Chain:
    """Return a condition with its sides read; raises Fault where they cannot be compared."""
    strange = [symbol.name for symbol in symbols_of(*sides) if not symbol.is_real]
    if not {"!=", "="} & set(sided.signs) and (strange or any(side.has(sp.I) for side in sides)):
        what = f"{strange[0]} is complex" if strange else "one side is complex"
        raise sided.node.fault(f"only real quantities can be compared, and {what}")
    if not re.search(r"[^\W\d_]", sided.node.text):
        raise sided.node.fault("a condition is about parameters, and there is none here")
    chain = Chain(tuple(sides), sided.signs, sided.node.place)
    for difference, relation in differences(chain):
        if not difference.free_symbols:
            _check_number(sided, difference, relation)
    return chain


def _check_number(sided: Sided, difference: sp.Expr, relation: str) -> None:
    """Refuse a relation of numbers that does not hold; one that holds says nothing."""
    value = sp.N(difference, 30)
    if not {">": value > 0, ">=": value >= 0, "!=": difference != 0, "=": value == 0}[relation]:
        raise sided.node.fault("this condition never holds")


def differences(chain: Chain) -> Iterator[Condition]:
    """Yield what a chain says of two of its sides each, also what follows from signs that point the same way."""
    for i, j in combinations(range(len(chain.sides)), 2):
        between = chain.signs[i:j]
        left, right = chain.sides[i], chain.sides[j]
        strict = any(len(sign) == 1 for sign in between)
        if between[0] in {"!=", "="}:
            yield Condition(left - right, between[0])
        else:
            larger, smaller = (right, left) if between[0][0] == "<" else (left, right)
            yield Condition(larger - smaller, ">" if strict else ">=")


@dataclass(frozen=True)
class Bound:
    """A number that a symbol is compared with, and the condition that says so."""

    value: sp.Expr
    closed: bool
    chain: Chain


class Bounds:
    """What conditions say of single symbols by numbers: enough to see most contradictions, and signs."""

    def __init__(self) -> None:
        self.low: dict[sp.Symbol, Bound] = {}
        self.high: dict[sp.Symbol, Bound] = {}
        self.nonzero: set[sp.Symbol] = set()

    def take(self, chain: Chain) -> None:
        """Take a condition in; raises Fault, with both places, if it contradicts an earlier one."""
        for difference, relation in differences(chain):
            if len(inside := symbols_of(difference)) != 1:
                continue
            (x,) = inside
            rest, term = difference.as_independent(x, as_Add=True)
            factor, power = term.as_independent(x, as_Add=False)
            if power != x or not factor.is_real:
                continue
            if relation == "!=":
                self.nonzero |= {x} if rest == 0 else set()
                continue
            bound = Bound(-rest / factor, relation == ">=", chain)
            self._tighten(x, bound, lower=bool(factor > 0))

    def _tighten(self, x: sp.Symbol, bound: Bound, *, lower: bool) -> None:
        side, sign = (self.low, 1) if lower else (self.high, -1)
        old = side.get(x)
        gain = sign * sp.N(bound.value - old.value, 30) if old else 1
        if gain > 0 or (gain == 0 and not bound.closed):
            side[x] = bound
        low, high = self.low.get(x), self.high.get(x)
        if low and high:
            room = sp.N(high.value - low.value, 30)
            if room < 0 or (room == 0 and not (low.closed and high.closed)):
                raise _contradiction(bound.chain, (high if lower else low).chain)

    def assumptions(self, x: sp.Symbol) -> dict[str, bool]:
        """Return what sympy can be told of the sign of a symbol."""
        low, high = self.low.get(x), self.high.get(x)
        if low and low.value.is_nonnegative:
            return {"nonnegative": True} if low.value == 0 and low.closed else {"positive": True}
        if high and high.value.is_nonpositive:
            return {"nonpositive": True} if high.value == 0 and high.closed else {"negative": True}
        return {"nonzero": True} if x in self.nonzero else {}


def _contradiction(one: Chain, other: Chain) -> Fault:
    if one.place == other.place:
        return Fault(Node(one.place).diagnostic("this condition never holds"))
    told = [("this condition contradicts another", one), ("this condition contradicts another", other)]
    return Fault(*(_at(chain, message) for message, chain in told))


def _at(chain: Chain, message: str) -> Diagnostic:
    return Node(chain.place).diagnostic(message)


def declared(chains: Sequence[Chain], report: Report) -> dict[str, sp.Symbol]:
    """Return the symbols that the conditions are about, by name, with all they know: signs, and the conditions.

    Contradictions that numbers show go to the report.
    """
    bounds, plain = Bounds(), {}
    for chain in chains:
        with report:
            bounds.take(chain)
    for x in symbols_of(*(side for chain in chains for side in chain.sides)):
        with report:
            plain[x] = sp.Symbol(x.name, **_merged(x, bounds))
    found = [each for chain in chains for each in differences(chain) if each.difference.free_symbols]
    told = [Condition(each.difference.xreplace(plain), each.relation) for each in found]
    return {x.name: Parameter(x.name, _about(y, told), **assumed_of(y)) for x, y in plain.items()}


def _merged(x: sp.Symbol, bounds: Bounds) -> Mapping[str, bool]:
    """The assumptions of a symbol, and those that follow from its bounds; raises Fault where both cannot be."""
    assumed = {"real": True} if not assumed_of(x) and x.is_real else assumed_of(x)
    known = bounds.assumptions(x)
    low, high = bounds.low.get(x), bounds.high.get(x)
    wrong = (high if x.is_positive and known.keys() & {"negative", "nonpositive"} else None) or (
        low if x.is_negative and known.keys() & {"positive", "nonnegative"} else None
    )
    if wrong:
        what = "positive" if x.is_positive else "negative"
        raise Fault(_at(wrong.chain, f"this condition contradicts 'assume', where {x} is {what}"))
    if x.is_positive or x.is_negative:
        return assumed
    if x.is_nonzero and known.keys() & {"nonnegative", "nonpositive"}:
        known = {"positive": True} if "nonnegative" in known else {"negative": True}
    if bounds.nonzero and x in bounds.nonzero and known.keys() & {"nonnegative", "nonpositive"}:
        known = {"positive": True} if "nonnegative" in known else {"negative": True}
    return {**assumed, **known}


def _about(x: sp.Symbol, conditions: Sequence[Condition]) -> tuple[Condition, ...]:
    """The conditions on a symbol, and on those that it is compared with, each once."""
    reached, kept = {x}, set[Condition]()
    while more := {each for each in conditions if each not in kept and each.difference.free_symbols & reached}:
        kept |= more
        reached |= set(symbols_of(*(each.difference for each in more)))
    return tuple(dict.fromkeys(each for each in conditions if each in kept))
