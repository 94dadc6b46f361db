"""The items of a list or of a matrix that say more than a value: their names, their places, how often they count."""

from __future__ import annotations

import re
from collections.abc import Sequence

from solver.classroom.reading.brackets import enclosed, split
from solver.classroom.reading.grids import diagonal_of
from solver.classroom.reading.labels import SUBSCRIPTS, twice_named, without_labels
from solver.classroom.reading.list_texts import times_over
from solver.classroom.reading.nodes import flat
from solver.classroom.reading.spelling import typed
from solver.classroom.reading.texts import TextReader
from solver.problem.nodes import Node, ScalarNode, SequenceNode

_PLACE = re.compile(r"\s*\\?[^\W\d]+_?\{?(\d),?(\d)\}?\s*=\s*(?!=)")
_COUNTS = tuple(map(str, range(1, 10)))
_DOTS = re.compile(r"\s*[,;]?\s*(?:\.{2,}|…|\\[lc]?dots|etc\.?|usw\.?)\s*([\])}]?)\s*$")
_CHAIN = re.compile(r"([^=,;\n]+)=((?:(?!\b(?:and|und)\b)[^=,;\n])+)=([^=,;\n]+)")
_WORDS = re.compile(r"[^\W\d]\w*")
_AT_END = re.compile(r"\s*[^\W\d]\w*['′]?\s*\(\s*(?:[\d.]+|T|t_?f)\s*\)\s*=")
"""What holds at an end, P(2) = 0, beside an equation."""
_NUMBERED = re.compile(r"\s*(?:\((\d|[iI]{1,3}|[iI][vV]|[a-h])\)|(\d|[iI]{1,3}|[iI][vV]|[a-h])[:.)])\s+")
"""(1) m x'' = F, (2) …"""
_BETWEEN = re.compile(r"\s*[,;\n]\s*|\s+(?:and|und)\s+")


def matrices_of(text: str) -> list[str]:
    """Return the matrices of K_0 = [1 2], K_1 = [3 4], or of [1 2]; [3 4]; nothing of any other text."""
    pieces = [each.strip() for each in split(text, _BETWEEN)]
    found, _ = without_labels(pieces)
    listed = len(pieces) > 1 and len(found) == len(pieces) and all(enclosed(each) for each in found)
    return found if listed else []


def items_of(node: Node, texts: TextReader) -> Sequence[Node]:
    """Return the items of a list; of a diagonal matrix perhaps what stands on its diagonal."""
    if not isinstance(node, SequenceNode):
        return (node,)
    if counted := _counted(node):
        return texts.choices.choose("counted", (counted, node.items))
    diagonal = diagonal_of(node)
    return texts.choices.choose("diagonal", (diagonal, node.items)) if diagonal else node.items


def _counted(node: SequenceNode) -> Sequence[Node]:
    """Values that stand in pairs with their multiplicity, [(-1, 1), (-2, 2)], as often as they count; else nothing."""
    pairs = [each.items for each in node.items if isinstance(each, SequenceNode) and len(each.items) == 2]
    if not pairs or len(pairs) != len(node.items):
        return ()
    counts = [count.text.strip() for _, count in pairs if isinstance(count, ScalarNode)]
    if len(counts) != len(pairs) or not all(each in _COUNTS for each in counts):
        return ()
    return [value for (value, _), count in zip(pairs, counts, strict=True) for _ in range(int(count))]


def words_of(node: ScalarNode) -> Node:
    """Return the words of a list, positive definite, indefinite, one by one; one word as it is."""
    pieces = [each.strip() for each in split(node.text.strip().strip("[]{}"), _BETWEEN) if each.strip()]
    if len(pieces) < 2:
        return node
    return SequenceNode(node.place, tuple(ScalarNode(node.place, each, "quoted") for each in pieces))


def without_dots(node: Node) -> Node:
    """Return the first terms of a sequence, 0, 1, 3, …, without what says that it goes on."""
    if isinstance(node, ScalarNode) and (bare := _DOTS.sub(r"\1", node.text)) != node.text:
        return ScalarNode(node.place, bare, "quoted")
    if isinstance(node, SequenceNode) and isinstance(last := (node.items or (None,))[-1], ScalarNode):
        items = node.items[:-1] if _DOTS.fullmatch(f", {last.text}") else node.items
        return SequenceNode(node.place, items)
    return node


def as_differences(node: Node) -> Node:
    """Return expressions that are zero with left − right in place of an equation left = right, without its number."""
    if isinstance(node, SequenceNode):
        ends = [item for item in node.items if isinstance(item, ScalarNode) and _AT_END.match(item.text)]
        node = SequenceNode(node.place, tuple(item for item in node.items if item not in ends))
        numbered = [_NUMBERED.match(item.text) if isinstance(item, ScalarNode) else None for item in node.items]
        if len(numbered) > 1 and [each and (each[1] or each[2]) for each in numbered] in _numberings(len(numbered)):
            bare = [typed(item)[each.end() :] for item, each in zip(node.items, numbered, strict=True) if each]
            node = SequenceNode(node.place, tuple(ScalarNode(node.place, each, "quoted") for each in bare))
        return SequenceNode(node.place, tuple(map(as_differences, node.items)))
    text = node.text.replace("==", "=") if isinstance(node, ScalarNode) else ""
    if (chain := _CHAIN.fullmatch(text)) and {*_WORDS.findall(chain[2])} - {*_WORDS.findall(chain[1] + chain[3])}:
        text = f"{chain[1]} = {chain[3]}"  # -P' = Q - P B R^-1 B P = 1 - P^2
    if text.count("=") != 1 or not isinstance(node, ScalarNode):
        return node
    left, right = text.split("=")
    return ScalarNode(node.place, f"({left.strip()}) - ({right.strip()})", "quoted")


def _numberings(count: int) -> list[list[str]]:
    """The numbers that equations may have before them, from the first on."""
    return [list(signs[:count]) for signs in (_COUNTS, ("I", "II", "III", "IV"), ("i", "ii", "iii", "iv"), "abcdefgh")]


def unlabelled(items: Sequence[Node], texts: TextReader) -> Sequence[Node]:
    """Return items such as λ_1 = -1 without what names them, as often as they count; nothing where none says such."""
    scalars = [item for item in items if isinstance(item, ScalarNode)]
    if len(scalars) != len(items):
        return []
    written = [each for item in scalars for each in _repeated(item.text, texts)]
    if name := twice_named(written):
        raise scalars[0].fault(f"{name} stands for two values")
    found, labelled = without_labels(written)
    if not labelled and len(written) == len(scalars):
        return []
    texts.respelt = True
    places = [item.place for item in scalars] if len(found) == len(scalars) else [scalars[0].place] * len(found)
    return [ScalarNode(place, text, "quoted") for place, text in zip(places, found, strict=True)]


def _repeated(item: str, texts: TextReader) -> list[str]:
    """An item as often as it says by a sign, 3 x 2."""
    several = times_over(item)
    return texts.choices.choose(("times", item), several) if several else [item]


def placed(node: SequenceNode, texts: TextReader) -> SequenceNode | None:
    """Return a list of entries with their names, p11 = 2 or k_1 = 3; None where they have none."""
    items = flat(node.items)
    written = [item.text for item in items if isinstance(item, ScalarNode)]
    if written and len(written) == len(items) and (lines := _by_places(written)):
        texts.respelt = True
        rows = [tuple(ScalarNode(node.place, text, "quoted") for text in line) for line in lines]
        return SequenceNode(node.place, tuple(SequenceNode(node.place, row) for row in rows))
    named = unlabelled(items, texts)
    return SequenceNode(node.place, tuple(named)) if named else None


def _by_places(items: Sequence[str]) -> list[list[str]] | None:
    """Return the rows of a matrix whose entries are named, p11 = 2, p12 = p21 = 0; None where some are missing.

    Of a square matrix what is missing on one side of the diagonal is as on the other.
    """
    found: dict[tuple[int, int], str] = {}
    for item in items:
        places, value = [], item.translate(SUBSCRIPTS)
        while match := _PLACE.match(value):
            places.append((int(match[1]), int(match[2])))
            value = value[match.end() :]
        if not places or any(0 in place for place in places):  # x_10 is x_1(0)
            return None
        found |= dict.fromkeys(places, value.strip())
    height, width = (range(1, 1 + max((place[of] for place in found), default=0)) for of in (0, 1))
    if height == width and not all((i, j) in found for i in height for j in width):
        found = {(j, i): value for (i, j), value in found.items()} | found
    whole = all((i, j) in found for i in height for j in width)
    return [[found[i, j] for j in width] for i in height] if whole else None
