"""What makes a problem a family: the names that are drawn, what must hold of them, and what must come out.

`vary` gives names of `parameters`, which hold the default member, other values; `require` holds conditions on them and
words about the system; `nice` says of answers that they must be integers, rationals or exact.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from decimal import Decimal
from math import prod
from typing import Any

import sympy as sp

from solver.conditions import symbols_of
from solver.derivation import Task
from solver.problem.asked import given_by
from solver.problem.conditions import SIGN, chain_of, split
from solver.problem.lexicon import Declarations, Lexicon, name_of, read_lexicon
from solver.problem.model import Chain, Part
from solver.problem.nodes import Entry, MappingNode, Node, Place, ScalarNode, SequenceNode, scalar
from solver.problem.source import Fault, Report, did_you_mean

KEYS = ("vary", "require", "nice")
WORDS = ("controllable", "observable", "stable", "unstable", "minimal")
STEPS = ("from", "to", "step")
MOST_VALUES = 10_000
MOST_NAMES = 40


@dataclass(frozen=True, slots=True)
class Varied:
    """A name that is drawn, its values, and how each is written in a file."""

    name: str
    values: tuple[sp.Expr, ...]
    texts: tuple[str, ...]
    place: Place = field(compare=False)


@dataclass(frozen=True, slots=True)
class Required:
    """What must hold, as it is written: a condition on the values that are drawn, or (`chain` is None) a word."""

    text: str
    chain: Chain | None
    place: Place = field(compare=False)


@dataclass(frozen=True, slots=True)
class Nice:
    """What must come out: an answer of a part in `integers`, `rationals` (denominators to 12) or `exact`."""

    part: str
    answer: str
    kind: str
    place: Place = field(compare=False)

    @property
    def text(self) -> str:
        """How it is written in the file."""
        return f"{self.part}.{self.answer}: {self.kind}"


@dataclass(frozen=True, slots=True)
class Family:
    """The members of a problem: what is drawn, and what must hold of each."""

    varied: tuple[Varied, ...]
    required: tuple[Required, ...] = ()
    nice: tuple[Nice, ...] = ()

    @property
    def size(self) -> int:
        """How many choices of values there are, whether something holds of them or not."""
        return prod(len(each.values) for each in self.varied)


def read_family(
    sections: Mapping[str, Node | None],
    declared: Declarations,
    parts: Sequence[Part],
    catalogue: Mapping[str, Task[Any, Any]],
    report: Report,
) -> Family | None:
    """Return the family that the sections `vary`, `require`, `nice` tell, None without them.

    What is wrong with them goes to the report.
    """
    vary, require, nice = (sections.get(key) for key in KEYS)
    if vary is None:
        for key, node in (("require", require), ("nice", nice)):
            if node is not None:
                note = "a family has vary: {a: {from: 1, to: 9}}, with the default of a under 'parameters'"
                report.diagnostics.append(node.diagnostic(f"'{key}' is about a family: 'vary' is missing", note=note))
        return None
    varied = _varied(vary, declared.parameters, report)
    names = {canonical(entry.key) for entry in vary} if isinstance(vary, MappingNode) else set[str]()
    lexicon = _letters(declared, names)
    required = _required(require, lexicon, names, report) if require is not None else ()
    return Family(varied, required, _nice(nice, parts, catalogue, report) if nice is not None else ())


def _letters(declared: Declarations, names: Collection[str]) -> Lexicon:
    """The names of the problem where those that are drawn have no value."""
    parameters = declared.parameters
    if isinstance(parameters, MappingNode):
        kept = {key: entry for key, entry in parameters.entries.items() if canonical(entry.key) not in names}
        parameters = MappingNode(parameters.place, kept)
    return read_lexicon(Declarations(parameters), Report())  # what is wrong with them is reported already


def canonical(key: ScalarNode) -> str:
    """Return the plain spelling of a name, "" where it is none."""
    with suppress(Fault):
        return name_of(key)
    return ""


def _varied(node: Node, parameters: Node | None, report: Report) -> tuple[Varied, ...]:
    """Return the names that are drawn; what is wrong with some of them goes to the report."""
    entries = list(node) if isinstance(node, MappingNode) else []
    if not entries or len(entries) > MOST_NAMES:
        message = f"at most {MOST_NAMES} names can be drawn" if entries else "nothing is drawn here"
        report.diagnostics.append(node.diagnostic(message, note="write vary: {a: {from: 1, to: 9}}"))
        return ()
    known = [canonical(entry.key) for entry in parameters] if isinstance(parameters, MappingNode) else []
    found: dict[str, Varied] = {}
    for entry in entries:
        with report:
            name = name_of(entry.key)
            if name in found:
                raise entry.key.fault(f"'{entry.key.text}' is given twice: it is the same name as '{name}'")
            if name not in known:
                note = "'parameters' holds the default member of the family"
                message = f"'{entry.key.text[:40]}' has no value under 'parameters'"
                raise entry.key.fault(message, suggestion=did_you_mean(name, known), note=note)
            found[name] = _values(name, entry)
    return tuple(found.values())


def _values(name: str, entry: Entry) -> Varied:
    """Return what a name is drawn from; raises Fault."""
    node = entry.value
    if isinstance(node, MappingNode) and "choose" in node:
        values, texts = _chosen(node["choose"])
    elif isinstance(node, MappingNode):
        values, texts = _steps(node)
    else:
        raise node.fault("a mapping such as {from: 1, to: 9} is expected here")
    if len(values) == 1:
        raise node.fault(f"'{entry.key.text}' has one value only: leave it to 'parameters'")
    return Varied(name, values, texts, entry.key.place)


def _chosen(node: Node) -> tuple[tuple[sp.Expr, ...], tuple[str, ...]]:
    """Return the values of a list, each once; raises Fault."""
    report, found = Report(), dict[sp.Expr, str]()
    items = node.items if isinstance(node, SequenceNode) else (node,)
    for item in items[:MOST_VALUES]:
        with report:
            value = _constant(item)
            if value in found:
                raise item.fault(f"'{scalar(item).text[:40]}' is in the list already")
            found[value] = scalar(item).text.strip()
    report.conclude()
    return tuple(found), tuple(found.values())


def _steps(node: MappingNode) -> tuple[tuple[sp.Expr, ...], tuple[str, ...]]:
    """Return the values from one number to another; raises Fault."""
    report, decimal = Report(), False
    given: dict[str, Any] = {"step": sp.Integer(1)}
    for entry in (each for each in node if each.key.text in STEPS):  # of other keys the shape of the file tells
        with report:
            lexicon = Lexicon()
            given[entry.key.text] = _constant(entry.value, lexicon)
            decimal = decimal or lexicon.took_decimals()
            if not given[entry.key.text].is_Rational:
                raise entry.value.fault("a rational number is expected here", note="other values go under choose: [..]")
    report.conclude()
    first, last, step = given["from"], given["to"], given["step"]
    if step <= 0:
        raise node["step"].fault("the step must be positive")
    count = int((last - first) // step) + 1
    if count < 1:
        raise node["to"].fault(f"this is less than 'from', {first}")
    if count > MOST_VALUES:
        raise node["to"].fault(f"there are {count} values; at most {MOST_VALUES} can be drawn from")
    values = tuple(first + i * step for i in range(count))
    return values, tuple(_as_decimal(value) if decimal else str(value) for value in values)


def _constant(node: Node, lexicon: Lexicon | None = None) -> sp.Expr:
    """Return a number that is written without names; raises Fault."""
    value = (lexicon or Lexicon()).expression(node)
    if value.free_symbols:
        raise node.fault(f"a number is expected here, not {node.what}")
    return value


def _as_decimal(value: sp.Rational) -> str:
    """Return a rational number as a decimal where it ends, else as a quotient."""
    rest = value.q
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    return f"{Decimal(value.p) / Decimal(value.q):f}" if rest == 1 else str(value)


def _required(node: Node, lexicon: Lexicon, names: Collection[str], report: Report) -> tuple[Required, ...]:
    """Return what must hold, in the order of the file; what is wrong with some of it goes to the report."""
    found: list[Required] = []
    for item in node.items if isinstance(node, SequenceNode) else (node,):
        with report:
            text = scalar(item)
            found += [_condition(text, lexicon, names)] if SIGN.search(text.text) else [_word(text)]
    return tuple(found)


def _word(node: ScalarNode) -> Required:
    if node.text.strip() not in WORDS:
        note = f'a condition on what is drawn, "a != 2" or "a b = 6", or one of {", ".join(WORDS)}'
        message = f"'{node.text[:40]}' cannot be required"
        raise node.fault(message, suggestion=did_you_mean(node.text, WORDS), note=note)
    return Required(node.text.strip(), None, node.place)


def _condition(node: ScalarNode, lexicon: Lexicon, names: Collection[str]) -> Required:
    """Return a condition on what is drawn; raises Fault for one on something else."""
    report = Report()
    sided = split(node, report, equations=True)
    report.conclude()
    sides = [lexicon.expression(side) for side in sided[0].sides]
    strangers = sorted({x.name for x in symbols_of(*sides)} - set(names))
    if strangers:
        message = f"'{strangers[0][:40]}' is not drawn: 'require' is about the names under 'vary'"
        raise node.fault(message, suggestion=did_you_mean(strangers[0], names))
    return Required(node.text.strip(), chain_of(sided[0], sides), node.place)


def _nice(
    node: Node, parts: Sequence[Part], catalogue: Mapping[str, Task[Any, Any]], report: Report
) -> tuple[Nice, ...]:
    """Return what must come out; what is wrong with some of it goes to the report."""
    found: list[Nice] = []
    by_id = {part.id: part for part in parts}
    for entry in node if isinstance(node, MappingNode) else ():
        name, _, answer = entry.key.text.rpartition(".")
        with report:
            if name not in by_id:
                if report.diagnostics and name:
                    continue  # the part may be one of those that could not be read
                note = "write the part and its answer, as in b.K"
                message = f"there is no part '{name[:40]}'" if name else f"'{answer[:40]}' names no part"
                raise entry.key.fault(message, suggestion=did_you_mean(name, by_id) if name else "", note=note)
            part = by_id[name]
            answers = given_by(catalogue[part.task], part.methods[:1])
            if answer not in answers:
                message = f"{part.task} has no answer '{answer[:60]}'"
                near = did_you_mean(answer, answers)
                note = f"its answers are: {', '.join(answers)}"
                raise entry.key.fault(message, suggestion=f"{name}.{near}" if near else "", note=note)
            found.append(Nice(name, answer, scalar(entry.value).text, entry.key.place))
    return tuple(found)
