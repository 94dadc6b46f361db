"""Points as students write them: names with values, tuples in the order of the unknowns, several of them in any way."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Any

import sympy as sp

from solver.classroom.reading import words
from solver.classroom.reading.brackets import enclosed, split
from solver.classroom.reading.expected import Expected
from solver.classroom.reading.latex import NotReadableError, is_latex, translated
from solver.classroom.reading.spelling import typed
from solver.classroom.reading.texts import Pair, TextReader
from solver.problem.nodes import Entry, MappingNode, Node, Place, ScalarNode, SequenceNode
from solver.symbols import MEANINGS

ANY = {"any", "arbitrary", "free", "anything", "beliebig", "frei", "all", "any value", "ℝ", "reals", "real"}
MOST = 60
_INTEGER = re.compile(
    r"\(?\s*(?:(?:with|for|mit|any|all|every)\s+)*(?:integers?\s+\w+|\w+\s*(?:∈|\\in|in|is an|is any|:)?\s*"
    r"(?:Z|ℤ|\\mathbb\{Z\}|integers?|ganz\w*)|[i-n]\s*=\s*0\s*,\s*(?:±|\+-|1\s*,).*)\s*\)?",
    re.IGNORECASE,
)
_APART = re.compile(r"[;\n]|\s+(?:and|or|und|oder)\s+")
_BARRED = re.compile(r"(?:\b[A-Z]_?\d*)?\(([^()|,;]+)\|([^()|,;]+)\)")
_BOTH = re.compile(r"(^|[,;{\[]|\b(?:and|und))\s*±\s*\(([^()]*)\)")
_COLUMN = re.compile(r"\[[^\[\]();,]+(?:;[^\[\]();,]+)+\]")
_TRANSPOSED = re.compile(r"([\])])\s*(?:\^\(?\s*T\s*\)?|ᵀ|')")
_OF_SET = re.compile(r"^\s*\([^()=]*\)\s*(?:∈|\bin\b)\s*(?=\{)")
_MEMBER = re.compile(r"([^\W\d]\w*)\s*(?:∈|\bin\b)\s*\{")
_NAMED = re.compile(r"(^\s*|[,;]\s*|\b(?:and|und|or|oder)\s+)([^\W\d]\w*)\s*[=:]\s*(?=\()")
_NAME_OF = re.compile(r"([^\W\d][\w'’′]*)\s*=(?!=)")
_INTEGERS = re.compile(
    r"[,;]?\s*\b[nkm]\s*=\s*0\s*,\s*(?:±|\+-)?\s*1(?:\s*,\s*(?:±|\+-)?\s*\d)*\s*(?:,\s*(?:\.{2,3}|…))?"
)
_COMMA = re.compile(r",")
_EQUALS = re.compile(r"=(?!=)")
_REMARK = re.compile(r"\(\s*\w+\s+(?:∈|in|any|is)\s[^()]*\)|\(\s*\w+\s+integer\s*\)", re.IGNORECASE)
_NUMBER_BEHIND = re.compile(r"(?<=[^\W\d])_?\d$")
_WITH = re.compile(
    r"\s*,?\s+(?:(?:each|all|both|jeweils|beide|alle)\s+)?(?:with|mit|where|wobei)\s+(?=[^\W\d][\w'’′]*\s*=)"
)
"""x1 = 0, ±1 with x2 = 0: what is behind is said of all."""
_PRIMES = {"'''": "_dddot", "''": "_ddot", "'": "_dot"}


def are_points(ours: Any, node: Node) -> bool:
    """Whether a list of points is asked for, or submitted where ours is empty."""
    if isinstance(ours, list) and ours:
        return isinstance(ours[0], Mapping)
    inside = node.items if isinstance(node, SequenceNode) else (node,)
    return ours == [] and any(isinstance(each, MappingNode) and each.entries for each in inside)


class PointReader:
    """Reads points in the unknowns of ours, in their order."""

    def __init__(self, texts: TextReader, expected: Expected, ours: Sequence[Mapping[Any, Any]]) -> None:
        self.texts = texts
        self.expected = expected
        self.unknowns = list(ours[0]) if ours else []
        self.known = {str(s) for point in ours for v in point.values() for s in v.free_symbols if not s.is_integer}
        self.whole: dict[sp.Symbol, sp.Symbol] = {}

    def read(self, node: Node) -> Pair:
        """Return the points, a mapping each, and their forms; raises Fault."""
        if isinstance(node, ScalarNode) and words.is_none(node.text, self.expected.name):
            return [], []
        pairs = [pair for each in self._apart(_as_text(node)) for pair in self._point(each)]
        if len(pairs) > MOST:
            raise node.fault(f"more than {MOST} points cannot be read")
        return [value for value, _ in pairs], [form for _, form in pairs]

    # ---- several points ----

    def _apart(self, node: Node) -> Iterator[Node]:
        """The nodes of the points one after the other."""
        if isinstance(node, MappingNode):
            inner = [entry.value for entry in node]
            own = (
                inner and all(isinstance(each, MappingNode | SequenceNode) for each in inner) and not self._names(node)
            )
            yield from inner if own else (node,)
        elif isinstance(node, SequenceNode):
            yield from self._of_items(node)
        elif isinstance(node, ScalarNode):
            yield from (ScalarNode(node.place, each, "quoted") for each in self._pieces(node.text))

    def _of_items(self, node: SequenceNode) -> Iterator[Node]:
        items = node.items
        texts = [item.text for item in items if isinstance(item, ScalarNode)]
        named = [_EQUALS.split(text, maxsplit=1)[0].strip() for text in texts if _EQUALS.search(text)]
        single = len(texts) == len(items) and not any("," in text for text in texts) and len(set(named)) == len(named)
        if single and len(self.unknowns) > 1 and (len(named) == len(items) or len(items) == len(self.unknowns)):
            yield node  # [0, pi], or [x = 0, y = pi]: the coordinates of one point
            return
        for item in items:
            yield from self._apart(item) if isinstance(item, ScalarNode) else (item,)

    def _pieces(self, text: str) -> list[str]:
        """The texts of points: between semicolons or words, or in brackets one after the other."""
        text = self._plainly(_WITH.sub("; ", _REMARK.sub("", text)).strip())
        if enclosed(text, "[]") and text[1:].lstrip()[:1] in ("(", "[", "{"):  # a list of points
            text = text[1:-1].strip()
        pieces = self._whole([each.strip() for each in split(text, _APART) if each.strip()])
        found = []
        for piece in pieces:
            parts = [each.strip() for each in split(piece, _COMMA) if not _INTEGER.fullmatch(each)]
            in_brackets = bool(self.unknowns) and all(each[:1] in ("(", "[", "{") for each in parts)
            if len(parts) > 1 and (in_brackets or len(self.unknowns) == 1):
                found += parts
            else:
                found.append(", ".join(parts))
        return [each for each in found if not _INTEGER.fullmatch(each)]

    def _plainly(self, text: str) -> str:
        """Points as (0, 1) without names, P1 = (0|1), P1(0|1), both of ±(0, 1), without a set, and columns as rows."""
        text = _COLUMN.sub(lambda found: f"({found[0][1:-1].replace(';', ',')})", _BARRED.sub(r"(\1, \2)", text))
        text = _INTEGERS.sub("", _OF_SET.sub("", _TRANSPOSED.sub(r"\1", text), count=1))
        text = _MEMBER.sub(r"\1 = {", text)
        named = {*map(str, self.unknowns)}
        text = _NAMED.sub(lambda found: found[0] if found[2] in named else found[1], text)
        text = _BOTH.sub(
            lambda found: f"{found[1]} ({found[2]}), ({', '.join(f'-({x})' for x in found[2].split(','))})", text
        )
        if enclosed(text, "{}") and text[1:].lstrip()[:1] in ("(", "[", "{"):
            text = text[1:-1].strip()
        return text

    def _whole(self, pieces: list[str]) -> list[str]:
        """Pieces of points; x1 = 0, ±1; x2 = 0 is one piece, and what the last alone says is said of all."""
        names = [[self._unknown(each) for each in _NAME_OF.findall(piece)] for piece in pieces]
        every = [name for one in names for name in one]
        if len(pieces) > 1 and all(names) and len(set(every)) == len(every) == len(self.unknowns):
            return [", ".join(pieces)]
        shared = set(names[-1]) - {name for one in names[:-1] for name in one} if len(pieces) > 1 and all(names) else {}
        last = [part for part in split(pieces[-1], _COMMA) if shared and self._unknown(part.split("=")[0]) in shared]
        if last:
            return [*(", ".join([piece, *last]) for piece in pieces[:-1]), pieces[-1]]
        own = set(names[0]) - {name for one in names[1:] for name in one} if len(pieces) > 1 and all(names) else set()
        first = [part for part in split(pieces[0], _COMMA) if own and self._unknown(part.split("=")[0]) in own]
        return [pieces[0], *(", ".join([*first, piece]) for piece in pieces[1:])] if first else pieces

    # ---- one point ----

    def _names(self, node: MappingNode) -> bool:
        return any(self._unknown(entry.key.text) is not None for entry in node)

    def _unknown(self, text: str) -> Any:
        """The unknown that a name means: x', xdot and x_dot are one."""
        name = text.strip().replace("’", "'").replace("′", "'")
        for sign, ending in _PRIMES.items():
            name = name.replace(sign, ending)
        own = {str(x): x for x in self.unknowns} | {str(x).removesuffix("(k)"): x for x in self.unknowns}
        if name.replace(" ", "") in own:
            return own[name.replace(" ", "")]
        try:
            (value, _), *_ = self.texts.alternatives(ScalarNode(Place(), name, "quoted"))
            name = str(value)
        except (TypeError, ValueError, ArithmeticError):
            name = name.strip()
        if name not in own and (bare := _NUMBER_BEHIND.sub("", name)) in own:  # x1, y1 of the first point
            return own[bare]
        plain = {str(x).replace("_", "").replace("{", "").lower(): x for x in self.unknowns}
        return own.get(name) if name in own else plain.get(name.replace("_", "").lower())

    def _point(self, node: Node) -> list[Pair]:
        """The points of a node: several where a value is one of several."""
        values = dict(self._values(node))
        for x in self.unknowns:
            if x not in values and str(x).endswith("dot"):  # at rest: what is not said of a velocity
                values[x] = [(sp.S.Zero, sp.S.Zero)]
                self.texts.respelt = True
        order = [*(x for x in self.unknowns if x in values), *(x for x in values if x not in self.unknowns)]
        found = []
        for choice in product(*(values[x] for x in order)):
            value, form = ({x: pair[i] for x, pair in zip(order, choice, strict=True)} for i in (0, 1))
            found.append((value, form))
        return found

    def _values(self, node: Node) -> Iterator[tuple[Any, list[Pair]]]:
        if isinstance(node, MappingNode):
            for entry in node:
                yield self._named(entry.key, entry.key.text), self._read(entry, entry.value)
            return
        if isinstance(node, SequenceNode):
            if any(isinstance(item, ScalarNode) and _EQUALS.search(item.text) for item in node.items):
                for item in node.items:
                    yield from self._of_text(item, getattr(item, "text", ""))
                return
            yield from self._in_order(node, list(node.items))
            return
        yield from self._of_text(node, getattr(node, "text", ""))

    def _in_order(self, node: Node, items: Sequence[Node]) -> Iterator[tuple[Any, list[Pair]]]:
        if len(items) != len(self.unknowns):
            names = ", ".join(map(str, self.unknowns))
            raise node.fault(f"a point has {len(self.unknowns)} coordinates ({names}), not {len(items)}")
        for x, item in zip(self.unknowns, items, strict=True):
            yield x, self._read(x, item)

    def _of_text(self, node: Node, text: str) -> Iterator[tuple[Any, list[Pair]]]:
        """x = 0, y = 1; (x, y) = (0, 1); (0, 1)."""
        left, *right = _EQUALS.split(text)
        if len(right) == 1 and enclosed(left.strip(), "()") and right[0].strip()[:1] in "([{":
            names, values = ([each.strip() for each in split(side.strip()[1:-1], _COMMA)] for side in (left, right[0]))
            if len(names) != len(values):
                raise node.fault("as many values as names are expected here")
            for name, value in zip(names, values, strict=True):
                yield self._named(node, name), self._read(name, ScalarNode(node.place, value, "quoted"))
            return
        inner = text.strip()
        if inner[:1] in "([{" and any(enclosed(inner, each) for each in ("()", "[]", "{}")):
            inner = inner[1:-1].replace(":", "=") if inner[0] == "{" else inner[1:-1]
        pieces = [each.strip() for each in split(inner, _COMMA) if each.strip() and not _INTEGER.fullmatch(each)]
        if not _EQUALS.search(inner):
            yield from self._in_order(node, [ScalarNode(node.place, each, "quoted") for each in pieces])
            return
        for piece in _grouped(pieces):
            *names, value = [each.strip() for each in _EQUALS.split(piece)]
            for name in names:
                yield self._named(node, name), self._read(name, ScalarNode(node.place, value, "quoted"))

    def _named(self, node: Node, text: str) -> Any:
        found = self._unknown(text)
        if found is None and self.unknowns:
            names = ", ".join(map(str, self.unknowns))
            raise node.fault(f"'{text.strip()[:40]}' is none of the unknowns", note=f"they are: {names}")
        return found if found is not None else sp.Symbol(text.strip(), real=True)

    def _read(self, unknown: Any, node: Node) -> list[Pair]:
        """The value of an unknown, or the several that it may have; its own symbol where it may have any."""
        if isinstance(node, SequenceNode):
            return [pair for item in node.items for pair in self._read(unknown, item)]
        text = node.text.strip() if isinstance(node, ScalarNode) else ""
        own = unknown if isinstance(unknown, sp.Symbol) else self._unknown(_text_of(unknown))
        if text.lower() in ANY and own is not None:
            return [(own, own)]
        if enclosed(text, "{}"):
            several = [ScalarNode(node.place, each.strip(), "quoted") for each in split(text[1:-1], _COMMA)]
            return [pair for each in several for pair in self._read(unknown, each)]
        pairs = self.texts.alternatives(node)
        if own is not None and len(pairs) == 1 and self._is_any(pairs[0][0]):
            return [(own, own)]
        return [(self._with_integers(value), self._with_integers(form)) for value, form in pairs]

    def _with_integers(self, value: Any) -> Any:
        """Letters that mean nothing in the question are whole numbers, named as ours are."""
        names = {str(x): x for x in self.unknowns}
        put = {s: names[s.name] for s in value.free_symbols if s.name in names}
        for s in sorted(value.free_symbols, key=str):
            usual = s.name in MEANINGS or (s.name == "k" and self.texts.discrete)
            meant = s in put or s in self.texts.decimals or s.name in self.known or usual
            if meant or s.name in self.texts.names.values or self._is_of_the_question(s):
                continue
            self.whole.setdefault(s, sp.Symbol(("n", "m", "n1", "n2", "n3")[min(len(self.whole), 4)], integer=True))
        return value.xreplace({**put, **{s: n for s, n in self.whole.items() if value.has(s)}})

    def _is_any(self, value: Any) -> bool:
        """Whether a value is a letter that stands for nothing: (x1, 0) where the first coordinate is free."""
        names = {*map(str, self.unknowns), *self.known, *MEANINGS}
        known = value.is_Symbol and (value in self.texts.decimals or value.name in names or value.is_integer)
        return bool(value.is_Symbol and not known and not self._is_of_the_question(value))

    def _is_of_the_question(self, symbol: Any) -> bool:
        own = self.texts.names.symbols.get(symbol.name)
        return own is not None and not own.is_integer


def _as_text(node: Node) -> Node:
    """A list of points that YAML took apart, [(1, 2), (3, 4)], as the text that it is; other nodes as they are."""
    items = node.items if isinstance(node, SequenceNode) else ()
    torn = any(isinstance(item, ScalarNode) and item.text.count("(") != item.text.count(")") for item in items)
    text = typed(node) if torn else node.text if isinstance(node, ScalarNode) else ""
    if not text:
        return node
    try:
        return ScalarNode(node.place, translated(text) if is_latex(text) else text, "quoted")
    except NotReadableError as error:
        raise node.fault(str(error)) from None


def _grouped(pieces: Sequence[str]) -> list[str]:
    """x = 0 and ±1 as x = {0, ±1}: values without a name belong to the name before."""
    found: list[list[str]] = []
    for piece in pieces:
        if _EQUALS.search(piece) or not found:
            found.append([piece])
        else:
            found[-1].append(piece)
    return [_EQUALS.sub("= {", f"{', '.join(one)}}}", count=1) if len(one) > 1 else one[0] for one in found]


def _text_of(name: Any) -> str:
    return name.key.text if isinstance(name, Entry) else str(name)
