"""Lists, matrices and mappings that a text holds, as nodes: of YAML, MATLAB, numpy, sympy, Mathematica, LaTeX.

[1 2; 3 4], [[1, 2], [3, 4]]', np.array([[1, 2]]), Matrix([1, 2]), {{1, 2}, {3, 4}}, (1, 2), 1/2 [1 2], {x: 1, y: 2}.
Rows end with ; or a line, entries with a comma, or with a space where there are no commas. Nothing is evaluated.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from solver.classroom.reading.brackets import are_numbers, by_spaces, enclosed, matching, rows, split
from solver.classroom.reading.choices import Choices
from solver.classroom.reading.grids import side_by_side, transposed
from solver.classroom.reading.latex import NotReadableError, is_latex, translated
from solver.classroom.reading.operations import combined, transposition
from solver.classroom.reading.programs import in_our_brackets, inside_idle_call
from solver.classroom.reading.spelling import typed
from solver.classroom.reading.stacked import stacked
from solver.classroom.reading.vectors import beside, pieces_of
from solver.problem.nodes import Entry, MappingNode, Node, ScalarNode, SequenceNode

MAX_DEPTH = 4
_MAKER = re.compile(
    r"(?:[A-Za-z_]\w*\.)*(?:Immutable)?(?:Sparse|Dense)?"
    r"(?:[Mm]atrix|poly1d|n?d?array|asarray|asmatrix|Array|mat|list|tuple|set|frozenset|[Vv]ector(?:\[(?:row|column)\])?|MatrixForm|FiniteSet)\s*[(\[]"
)
_KEYWORD = re.compile(r"\s*[A-Za-z_]\w*\s*=")
_PAIR = re.compile(r"\s*(?::=|[:=])\s*")
_VECTOR = re.compile(r"(^|[,;]\s*)[^\W\d]\w*\s*=\s*(?=[\[(].*[,;]\s*[^\W\d]\w*\s*=|[\[(][^=]*$)", re.DOTALL)
_SPAN = re.compile(r"\s*(?:span|Span|lin|LH)\s*(?=[({\[])")
_JOINED = re.compile(r"\s+(?:and|und|or|oder|et|ou|∨|∧)\s+", re.IGNORECASE)
_SETS = {"∅": "[]", "{ }": "[]"}
_LIST = re.compile(r"\[\s*[-+]?[1-9]\d*(?:,[-+]?\d+)+\s*\]")
"""Whole numbers in brackets: what stands between them separates."""

_DECIMAL_COMMA = re.compile(r"(?<![\d.,])(\d+),(\d+)(?![\d.]|,\d)")


@dataclass(frozen=True)
class Unfolding:
    """How texts are taken apart: `grid` where a matrix or a list of expressions is expected, so that separators count.

    With `comma` a comma between digits may be a decimal comma; `vectors` tells what the answer is made of, "columns" or
    "rows".
    """

    choices: Choices
    grid: bool = False
    comma: bool = False
    vectors: str = ""

    def node(self, node: Node) -> Node:
        """Return the lists or the mapping that a node holds as a text; other nodes as they are."""
        if isinstance(node, ScalarNode):
            text = _SETS.get(node.text.strip(), node.text)
            return node if node.is_null else self.text(node, self._with_points(_plain(node, text)), 0)
        if not isinstance(node, SequenceNode) or not node.items:
            return node
        if _holds_rows(node) or _is_torn(node) or (self.comma and self.grid and _holds_commas(node)):
            return self.text(node, self._with_points(typed(node)), 0)
        return self._sequence(node)

    def _sequence(self, node: SequenceNode) -> Node:
        """A list of YAML: an item may hold the entries of a row, [1 2], or be a matrix of its own."""
        items: list[Node] = []
        pieces = [by_spaces(item.text) if isinstance(item, ScalarNode) else [] for item in node.items]
        plain = all(isinstance(item, ScalarNode) and item.style == "plain" for item in node.items)
        if len(node.items) == 1 and plain and len(pieces[0]) > 1:
            (only,) = node.items
            return SequenceNode(node.place, tuple(self._leaves(only, typed(only))), node.braces)
        if self.grid and all(len(each) > 1 and are_numbers(each) for each in pieces):
            rows_ = [SequenceNode(node.place, tuple(_leaves(node, each))) for each in pieces]
            return SequenceNode(node.place, tuple(rows_))
        for item in node.items:
            holds = isinstance(item, SequenceNode) or (isinstance(item, ScalarNode) and _holds_list(item.text))
            items.append(self.node(item) if holds else item)
        found = SequenceNode(node.place, tuple(items), node.braces)
        return side_by_side(found) if self.grid else found

    def with_points(self, node: Node) -> Node:
        """Return a text with points for decimal commas; other nodes as they are."""
        if not isinstance(node, ScalarNode):
            return node
        decimal = self.choices.choose("comma", (True, False))
        return ScalarNode(node.place, _DECIMAL_COMMA.sub(r"\1.\2", node.text), "quoted") if decimal else node

    def _with_points(self, text: str) -> str:
        """A text with decimal commas as points; in a list the commas between digits may separate, all or none."""
        if not self.comma or not _DECIMAL_COMMA.search(text):
            return text
        decimal = not self.grid or self.choices.choose("comma", (True, False))
        return _DECIMAL_COMMA.sub(r"\1.\2", text) if decimal else text

    def text(self, node: Node, text: str, depth: int) -> Node:
        """Return what a text holds."""
        text = text.strip()
        if depth > MAX_DEPTH:
            return _leaf(node, text)
        if self.grid and depth == 0:
            text = _JOINED.sub(", ", in_our_brackets(text))
            if (vectors := self._vectors(node, text)) is not None:
                return vectors
            text = _VECTOR.sub(partial(_without_name, text), text)
            if _SPAN.match(text):
                return self._spanned(node, _SPAN.sub("", text, count=1))
        while enclosed(text, "()") and self._is_single(text[1:-1].strip()):
            text = text[1:-1].strip()
        tuple_ = enclosed(text, "()") and self._is_tuple(text[1:-1])
        if enclosed(text, "{}") and (mapped := _mapped(node, text[1:-1])):
            return mapped
        if enclosed(text, "[]") or enclosed(text, "{}") or tuple_:
            return self._bracketed(node, text[1:-1], depth, braces=text.startswith("{"))
        return self._called(node, text, depth) or _leaf(node, text)

    def _spanned(self, node: Node, inside: str) -> Node:
        """The matrix of the vectors in span{…}."""
        if (vectors := self._vectors(node, inside)) is not None:
            return vectors
        called = enclosed(inside, "()") and inside[1:-1].lstrip().startswith("[")
        vectors = self.text(node, f"{{{inside[1:-1]}}}" if called else inside, 1)
        return vectors if ";" in inside else _columns(vectors)

    def _vectors(self, node: Node, text: str) -> Node | None:
        """The matrix of vectors that are listed one by one; None of anything else."""
        listed = pieces_of(text) if self.vectors else None
        if listed is None:
            return None
        pieces, clear = listed
        own = self.vectors == "rows"
        in_rows = own if clear else self.choices.choose("vectors", (own, not own))
        return beside([self.text(node, piece, 1) for piece in pieces], in_rows=in_rows)

    def _called(self, node: Node, text: str, depth: int) -> Node | None:
        """What stands in no brackets of its own: a call, a product, entries with separators; None for one value."""

        def read(piece: str) -> Node:
            return self.text(node, piece, depth + 1)

        if (kept := inside_idle_call(text)) and _holds_list(kept):
            return read(kept)
        if (turned := transposition(text, read)) is not None:
            return turned
        if self.grid and (made := stacked(text, read)) is not None:
            return made
        if (found := _MAKER.match(text)) and matching(text, found.end() - 1) == len(text) - 1:
            return self._made(node, text[found.end() : -1], depth)
        if self.grid and (whole := combined(node, text, read)) is not None:
            return whole
        separated = self.grid and depth == 0 and self._separated(text)
        return self._bracketed(node, text, depth, braces=False) if separated else None

    def _is_single(self, text: str) -> bool:
        """Whether what stands in round brackets is one matrix: a list, or a product of such."""
        return enclosed(text) or (self.grid and "[" in text and not self._is_tuple(text))

    def _is_tuple(self, text: str) -> bool:
        """Whether what stands in round brackets is a list: 1, 2; 1; 2; or numbers with spaces between."""
        pieces = by_spaces(text)
        numbers = self.grid and len(pieces) > 1 and are_numbers(pieces)
        return numbers or len(split(text, ",")) > 1 or len(rows(text)) > 1

    def _separated(self, text: str) -> bool:
        """Whether a text without brackets holds several entries: -1, -2; -1; -2; or numbers with spaces between."""
        return len(rows(text)) > 1 or len(split(text, ",")) > 1 or len(by_spaces(text)) > 1

    def _made(self, node: Node, text: str, depth: int) -> Node:
        """What stands in Matrix(…): lists, or their size and a flat list; keywords such as dtype are left out."""
        arguments = [piece.strip() for piece in split(text, ",") if not _KEYWORD.match(piece)]
        if len(arguments) == 2 and arguments[0].isdigit() and enclosed(arguments[1]):  # Vector[row](2, [1, 2])
            return self.text(node, arguments[1], depth + 1)
        if len(arguments) == 3 and arguments[0].isdigit() and arguments[1].isdigit():
            flat = self.text(node, arguments[2], depth + 1)
            count = int(arguments[1])
            if isinstance(flat, SequenceNode):
                width = max(count, 1)
                lines = [flat.items[at : at + width] for at in range(0, len(flat.items), width)]
                return SequenceNode(node.place, tuple(SequenceNode(node.place, line) for line in lines))
        inside = _unquoted(", ".join(arguments))
        if len(arguments) > 1 and all(enclosed(each) for each in arguments):  # matrix([1, 2], [3, 4]) of Maxima
            inside = f"[{inside}]"
        return self.text(node, inside if inside[:1] in "[{(" else f"[{inside}]", depth + 1)

    def _bracketed(self, node: Node, text: str, depth: int, *, braces: bool) -> Node:
        """The entries between brackets; where there are several rows, a list that stands alone in one is the row."""
        lines = rows(text)
        if len(lines) < 2:
            row = SequenceNode(node.place, self._row(node, text, depth) if text.strip() else (), braces)
            return side_by_side(row) if self.grid else row
        found = [self._row(node, line, depth) for line in lines]
        whole = [row[0] if len(row) == 1 and isinstance(row[0], SequenceNode) else None for row in found]
        pairs = zip(whole, found, strict=True)
        return SequenceNode(node.place, tuple(alone or SequenceNode(node.place, row) for alone, row in pairs))

    def _row(self, node: Node, text: str, depth: int) -> tuple[Node, ...]:
        """The entries of a row."""
        entries = split(text, ",")
        if len(entries) == 1:
            return tuple(self._leaves(node, text, depth))
        kept = entries if entries[-1].strip() else entries[:-1]
        return tuple(self.text(node, entry, depth + 1) for entry in kept)

    def _leaves(self, node: Node, text: str, depth: int = 0) -> list[Node]:
        """The entries between spaces; what is no plain number may as well be one product, or one sum."""
        pieces = by_spaces(text)
        several = len(pieces) > 1
        if several and not are_numbers(pieces):
            several = self.grid and self.choices.choose("spaces", (True, False))
        return [self.text(node, piece, depth + 1) for piece in (pieces if several else [text])]


def has_decimal_comma(node: Node) -> bool:
    """Whether a comma stands between digits as a decimal comma does, and not between the numbers of a list."""
    text = typed(node).strip()
    return bool(_DECIMAL_COMMA.search(text)) and not _LIST.fullmatch(text)


def _columns(node: Node) -> Node:
    """The matrix of the vectors of a list, (1, 2) and (3, 4); anything else as it is."""
    lines = node.items if isinstance(node, SequenceNode) else ()
    vectors = [line.items for line in lines if isinstance(line, SequenceNode)]
    flat = all(isinstance(entry, ScalarNode) for vector in vectors for entry in vector)
    return transposed(node) if isinstance(node, SequenceNode) and len(vectors) == len(lines) and flat else node


def _without_name(text: str, found: re.Match[str]) -> str:
    """What stands before the entries of a vector without its name; the name of one entry in brackets stays."""
    inside = text[found.end() + 1 : matching(text, found.end())]
    several = text[found.end()] == "[" or len(split(inside, re.compile("[,;]"))) > 1 or are_numbers(by_spaces(inside))
    return found[1] if several else found[0]


def _plain(node: ScalarNode, text: str) -> str:
    """A text without LaTeX; raises Fault where it is none."""
    if not is_latex(text):
        return text
    try:
        return translated(text)
    except NotReadableError as error:
        raise node.fault(str(error)) from None


def _holds_rows(node: SequenceNode) -> bool:
    """Whether YAML took a matrix of MATLAB apart: [1, 2; 3, 4] has the items 1, "2; 3" and 4."""
    texts = [item for item in node.items if isinstance(item, ScalarNode) and item.style == "plain"]
    return len(texts) == len(node.items) and any(sign in item.text for item in texts for sign in ";|&■█")


def _is_torn(node: SequenceNode) -> bool:
    """Whether YAML took round brackets apart: [(1, 2), (3, 4)] has the item "(1"."""
    texts = [item.text for item in node.items if isinstance(item, ScalarNode) and item.style == "plain"]
    return any(text.count("(") != text.count(")") for text in texts)


def _holds_commas(node: Node) -> bool:
    """Whether two numbers stand in a list with a comma and no space between them."""
    return isinstance(node, SequenceNode) and (
        bool(_DECIMAL_COMMA.search(typed(node))) or any(map(_holds_commas, node.items))
    )


def _holds_list(text: str) -> bool:
    return any(sign in text for sign in "[{") or bool(_MAKER.match(text.strip())) or "\\begin" in text


def _mapped(node: Node, text: str) -> Node | None:
    """The entries "name: value" or "name = value" of a text, None if it holds anything else."""
    pairs = [split(item, _PAIR) for item in split(text, re.compile(r"[,;\n]"))]
    if not pairs or any(len(pair) != 2 for pair in pairs):
        return None
    named = {name.strip(): _leaf(node, value.strip()) for name, value in pairs}
    entries = {name: Entry(ScalarNode(node.place, name), value) for name, value in named.items()}
    return MappingNode(node.place, entries)


def mapped(node: Node, text: str) -> Node | None:
    """Return the entries of a text such as "x1: 3, x2: 4" or "{x1 = 3}", None if it holds anything else."""
    text = text.strip()
    return _mapped(node, text[1:-1] if enclosed(text, "{}") or enclosed(text, "[]") else text)


def _leaves(node: Node, pieces: Sequence[str]) -> list[Node]:
    return [_leaf(node, piece) for piece in pieces]


def _leaf(node: Node, text: str) -> ScalarNode:
    """The text of an entry, without quotes; the node itself where it has just this text."""
    bare = _unquoted(text)
    if isinstance(node, ScalarNode) and node.text == bare:
        return node
    return ScalarNode(node.place, bare, "plain")


def _unquoted(text: str) -> str:
    return text[1:-1] if len(text) > 1 and text[0] == text[-1] and text[0] in "'\"" else text
