"""Values before they are read by their kind: rules of other programs, remarks, what belongs to other values."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection, Mapping, Sequence
from typing import Any

import sympy as sp

from solver.classroom.reading import solution_sets, state_equations
from solver.classroom.reading.brackets import rows, split
from solver.classroom.reading.control_laws import gains_of
from solver.classroom.reading.latex import plainly
from solver.classroom.reading.likeness import is_condition
from solver.classroom.reading.matrix_remarks import of_products
from solver.classroom.reading.names import symbols_of
from solver.classroom.reading.nodes import labelled
from solver.classroom.reading.quantities import told_otherwise, without_limit
from solver.classroom.reading.remarks import without_remarks
from solver.classroom.reading.space_words import is_zero_space, without_space_words
from solver.classroom.reading.spelling import typed
from solver.classroom.reading.vectors_told import of_unit_vectors, with_commas, with_conjugates, without_kinds
from solver.problem.expressions.notation import GREEK_NAMES, MAX_CHARACTERS
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode
from solver.symbols import POLYNOMIAL

_RULE = re.compile(r"\s*(?:->|→)\s*(?!\s*(?:∞|\+∞|oo|inf|\\infty))")
_TURNED = re.compile(r"^(\s*[^\W\d]\w*)\s*(?:\^\(?\s*T\s*\)?|ᵀ|\^\{T\})\s*=\s*(.*[\])])\s*$", re.DOTALL)
_NOT_ZERO = re.compile(
    r"\s*(?:≠|!=|\\neq?\b)\s*0\s*$|\s*[,;(]\s*(?:(?:which )?is |ist )?(?:not|nicht|≠) ?(?:zero|null|0)\s*\)?\s*\.?$"
)
_PARTS = re.compile(r"^\s*(?:σ|sigma|Re)\s*=[^=]*[,;]\s*(?:ω|omega|ω_d|Im)\s*=[^=]*$")
_STATED = re.compile(r"\s*([^\W\d]\w*(?:\s*[-−+]\s*[^\W\d]\w*\*?\w?)?)\s*=[^=]")
_STATEMENTS = re.compile(
    r"\s*(?:[,;]?\s*(?:\b(?:i\.\s?e\.|d\.\s?h\.|so|hence|thus|also|damit|somit)\s*:?\s|=>|⇒|→)|[,;])\s*"
)
_ADDED = re.compile(r"\s*u\w*(?:\(\w\))?\s*=\s*\+?\s*[A-Za-z]")
_OUTPUT = re.compile(r"^\s*Y(?:\((?:s|z)\))?\s*=\s*(.*?)\s*[*·]?\s*U(?:\((?:s|z)\))?\s*$", re.DOTALL)
_SQUARE = re.compile(r"(?<![\w.])([spzλ]|lambda)([2-9])(?!\w)")
_POWER_OF_ROW = re.compile(r"\s*[sz]\s*\^?\s*[({]?[\d⁰¹²³⁴-⁹]{1,2}[)}]?\s*(?:[|:]|$)")
_BLANKS = re.compile(r"[^\S\n]+")
MOST_CHARACTERS = 2000
"""Longer texts are no matrices told otherwise."""
_DIGITS = re.compile(r"[\d⁰¹²³⁴-⁹]{1,2}")
_QUOTED = re.compile(r"^\s*[“”„«»‘’‚\"`]([^“”„«»`]*)[“”«»‘’\"`]\s*$|(?<=[\])'])\s*;+\s*$", re.DOTALL)
_BELOW = re.compile(
    r"(?:\s+Sample time: [\d.]+ (?:seconds|s))?\s+(?:# )?(?:Continuous|Discrete)-time "
    r"(?:transfer function|zero/pole/gain model)\.?\s*(?:Model Properties\s*)?$"
    r"|\s*\((?:check|probe|test|kontrolle)\b[^()]*(?:\([^()]*\)[^()]*)*\)\s*\.?$",
    re.IGNORECASE,
)
"""What MATLAB says below a transfer function, or how a value was checked."""
_SLASH = re.compile(r"\s//?\s")
_WORD = re.compile(r"[a-z]{2,}|[A-Z][a-z]{2,}")


def prepared(node: Node, ours: Any, name: str) -> Node:
    """Return the node of an answer without what is not part of its value; raises Fault where it is another quantity."""
    if isinstance(ours, sp.MatrixBase):
        node = _matrix_prepared(node, ours, name)
    if isinstance(ours, sp.Expr) and isinstance(node, MappingNode):
        node = _quotient(node) or node
    text = typed(node)
    bare = _QUOTED.sub(lambda found: found[1] or "", _BELOW.sub("", text))
    if isinstance(node, ScalarNode) and bare != text:
        node, text = ScalarNode(node.place, bare, "quoted"), bare
    if isinstance(node, ScalarNode) and (bare := without_limit(text, name)) != text:
        node, text = ScalarNode(node.place, bare, "quoted"), bare
    if _RULE.search(text) and isinstance(ours, list) and ours and isinstance(ours[0], Mapping):
        return ScalarNode(node.place, _RULE.sub(" = ", text), "quoted")
    if _RULE.search(text) and not isinstance(ours, str | bool) and not is_condition(ours):  # {{k1 -> 22, k2 -> 7}}
        return ScalarNode(node.place, _RULE.sub(" = ", text.replace("{", "").replace("}", "")), "quoted")
    if not isinstance(node, ScalarNode) or isinstance(ours, str | bool):
        return node
    if isinstance(ours, list | tuple) and _PARTS.match(text):
        raise node.fault("the values themselves are expected, not their real and imaginary parts")
    if name == "G" and (law := _OUTPUT.match(text)) and law[1]:  # Y(s) = G(s) U(s)
        return ScalarNode(node.place, law[1], "quoted")
    bare = _own_statement(_NOT_ZERO.sub("", text), name)
    bare = _quantity(bare, name, ours)
    if name == "array":
        bare = _without_powers(text)
    if isinstance(ours, sp.MatrixBase) and (found := _TURNED.match(bare)):
        bare = f"{found[1]} = {found[2]}'"
    return node if bare == text else ScalarNode(node.place, bare, "quoted")


def _quantity(text: str, name: str, ours: Any) -> str:
    """A text of the quantity that is asked for, without remarks; one that is too long as it is."""
    if len(text) > MAX_CHARACTERS:
        return text
    text = told_otherwise(text, name, ours)
    numbers = not symbols_of(ours) and not isinstance(ours, Mapping | sp.MatrixBase) and not _is_listed(ours)
    return without_remarks(text, name) if numbers else text


def _matrix_prepared(node: Node, ours: sp.MatrixBase, name: str) -> Node:
    """The entries of a mapping as a list; a matrix that is told by equations or by other vectors, written out."""
    space = name.endswith("_space")
    text = _in_order(node) if isinstance(node, MappingNode) and space else typed(node)
    if (isinstance(node, ScalarNode) or space) and (told := _matrix_told(text, name, ours)):
        return ScalarNode(node.place, told, "quoted")
    if text.startswith("{("):
        return ScalarNode(node.place, text, "quoted")
    return _named_entries(node) if isinstance(node, MappingNode) else node


def _in_order(node: MappingNode) -> str:
    """What stands between braces, {(t, 2t) : t ∈ R}, where YAML took its brackets apart."""
    entries = sorted(node, key=lambda entry: (entry.key.place.line, entry.key.place.column))
    return f"{{{', '.join(f'{entry.key.text}: {typed(entry.value)}'.removesuffix(': ') for entry in entries)}}}"


def _matrix_told(text: str, name: str, ours: sp.MatrixBase) -> str:
    """A matrix told by equations or by other vectors, written out; "" of any other text."""
    text = _BLANKS.sub(" ", text)
    space = name.endswith("_space")
    if len(text) > MOST_CHARACTERS or (0 in ours.shape and not space):
        return ""
    if space:
        return "{0}" if is_zero_space(text) else _space_told(text, ours)
    if name in state_equations.NAMES:
        return state_equations.matrix_of(plainly(text), name, ours.shape) if "=" in text else ""
    if name.endswith("eigenvectors"):
        bare = with_commas(without_kinds(text))
        told = with_conjugates(bare) or of_unit_vectors(bare, ours.rows)
        return told or (bare if bare != text else "")
    if name == "K" and ours.rows > 1:
        return gains_of(text)
    return of_products(text) if name == "controllability_matrix" else ""


def _space_told(text: str, ours: sp.MatrixBase) -> str:
    """A space by its vectors, told by equations, by unit vectors or in words; "" of any other text."""
    if 0 in ours.shape:
        return ""
    bare = with_commas(without_space_words(plainly(text)))
    told = ("=" in bare and solution_sets.solved(bare, ours.rows)) or of_unit_vectors(bare, ours.rows)
    return told or (bare if bare != plainly(text) else "")


def _named_entries(node: MappingNode) -> Node:
    """The entries of {k1: 3, k2: 4} with their names as a list; the vectors of {v1: [1, 2], v2: [3, 4]} as a text."""
    vectors = all(isinstance(entry.value, SequenceNode) for entry in node)
    if (
        vectors and node.entries and not any(entry.key.text.strip()[:1].isalpha() for entry in node)
    ):  # {-1: [1, 0], -2: [1, 1]}
        text = ", ".join(f"{entry.key.text}: {typed(entry.value)}" for entry in node)
        return ScalarNode(node.place, text, "quoted")
    items = [each for entry in node for each in labelled(entry)]
    if items and all(typed(entry.value).lstrip()[:1] in ("[", "(") for entry in node):
        return ScalarNode(node.place, ", ".join(map(typed, items)), "quoted")
    return SequenceNode(node.place, tuple(items))


def _is_listed(ours: Any) -> bool:
    """Whether our own answer is a list of anything but numbers."""
    return isinstance(ours, list | tuple) and not all(isinstance(each, sp.Expr) for each in ours)


def _quotient(node: MappingNode) -> Node | None:
    """{num: [1], den: [1, 2]} as num = [1], den = [1, 2]; None of any other mapping."""
    entries = {entry.key.text: typed(entry.value) for entry in node}
    if set(entries) != {"num", "den"}:
        return None
    return ScalarNode(node.place, f"num = {entries['num']}, den = {entries['den']}", "quoted")


def _own_statement(text: str, name: str) -> str:
    """K = [1 2] of u = -Kx, K = [1 2]; any other text as it is."""
    pieces = split(text, _STATEMENTS)
    stated = [found[1] if (found := _STATED.match(piece)) else "" for piece in pieces]
    if name.upper() not in stated and name.lower() in stated:
        name = name.lower()
    own = len(pieces) > 1 and all(stated) and stated.count(name) == 1 and len(name) == 1
    if any(map(_ADDED.match, pieces)):  # the gain of u = Kx is another one
        return text
    if not own:
        return text
    whole = pieces[stated.index(name)]
    uses = any(re.search(rf"\b{re.escape(each)}\b", whole) for each in stated if each != name)
    return text if uses else whole  # K = [k1 k2], k1 = 3, k2 = 4


def _without_powers(text: str) -> str:
    """The rows of a Routh array without s^3 | before them; a text of other rows as it is."""
    lines = rows(text)
    bare = [_POWER_OF_ROW.sub("", line, count=1) for line in lines]
    named = len(lines) > 1 and all(map(_POWER_OF_ROW.match, lines)) and _is_falling(lines)
    return "\n".join(bare) if named else text


def _is_falling(lines: Sequence[str]) -> bool:
    """Whether the powers at the beginning of lines fall one by one."""
    powers = [int(unicodedata.normalize("NFKC", found[0])) for found in map(_DIGITS.search, lines) if found]
    return powers == list(range(powers[0], powers[0] - len(lines), -1)) if powers else False


def as_rows(node: Node) -> Node | None:
    """Return -1 / -2 or 0 1 / -2 -3 with the slashes between rows as separators; None where there are none."""
    if not isinstance(node, ScalarNode) or not _SLASH.search(node.text):
        return None
    return ScalarNode(node.place, _SLASH.sub("; ", node.text), "quoted")


def without_powers(lines: Sequence[Sequence[Node]]) -> list[Sequence[Node]]:
    """Return the rows of a Routh array without their powers in the first column, if that holds nothing else."""
    first = [line[0] for line in lines if len(line) > 1]
    powers = [each for each in first if isinstance(each, ScalarNode) and _POWER_OF_ROW.fullmatch(each.text)]
    falling = len(powers) == len(lines) and _is_falling([each.text for each in powers])
    return [line[1:] for line in lines] if falling else list(lines)


def with_powers(text: str, known: Collection[str]) -> str:
    """Return a polynomial with s2 as s^2, where no such name is known."""
    return _SQUARE.sub(lambda found: found[0] if found[0] in known else f"{found[1]}^{found[2]}", text)


def strange_word(symbols: Collection[sp.Symbol], known: Collection[str]) -> str:
    """Return a word among symbols that stands for nothing in the problem, "" if there is none."""
    names = sorted(symbol.name for symbol in symbols if not isinstance(symbol, sp.Dummy))
    usual = {*known, *GREEK_NAMES, *POLYNOMIAL}
    return next((each for each in names if each not in usual and _WORD.fullmatch(each)), "")
