"""Other spellings of values that answers come in: sympy's own, as our results hold them, and those of other notations.

`Matrix([[1, 2]])`, `Heaviside(t - 2)`, `KroneckerDelta(k, 1)`, `Eq(a, 1)`, `2*I` are read as [[1, 2]], `step(t - 2)`,
`delta(k - 1)`, `a = 1`, `2*j`. Only text is changed here; nothing is evaluated.
"""

from __future__ import annotations

import re

from solver.problem.nodes import Entry, MappingNode, Node, ScalarNode, SequenceNode

FUNCTIONS = {"Heaviside": "step", "DiracDelta": "delta", "Abs": "abs", "KroneckerDelta": "delta", "arccos": "acos",
             "arcsin": "asin", "arctan": "atan", "heaviside": "step", "dirac": "delta"}  # fmt: skip
_FUNCTION = re.compile(r"\b(" + "|".join(FUNCTIONS) + r")\s*\(")
_INFINITY = re.compile(r"\boo\b|∞")
_MATRIX = re.compile(r"^\s*(?:Immutable)?(?:Dense)?Matrix\s*\((.*)\)\s*$", re.DOTALL)
_EMPTY = re.compile(r"^\s*\d+\s*,\s*\d+\s*,\s*\[\s*\]\s*$")
OPENING, CLOSING = "([{", ")]}"


def respelled(text: str) -> str:
    """Return the text of an expression with functions named as our notation names them."""
    text = _FUNCTION.sub(lambda found: f"{FUNCTIONS[found[1]]}(", _kronecker(_steps(text)))
    return _INFINITY.sub("inf", text).replace("√(", "sqrt(").replace("–", "-")


def _steps(text: str) -> str:
    """Heaviside(a, 1), which says the value at the jump, as Heaviside(a)."""
    head, at = "Heaviside(", 0
    while (at := text.find(head, at)) >= 0:
        at += len(head)
        end = matching(text, at - 1)
        first, *value = split(text[at:end], ",") or [""]
        if [each.strip() for each in value] == ["1"]:
            text = text[:at] + first + text[end:]
    return text


def _kronecker(text: str) -> str:
    """KroneckerDelta(a, b) as delta((a) - (b))."""
    head = "KroneckerDelta("
    while head in text:
        at = text.index(head)
        end = matching(text, at + len(head) - 1)
        first, *second = split(text[at + len(head) : end], ",") or [""]
        inside = f"({first}) - ({second[0]})" if second and second[0].strip() not in ("0", "") else first
        if second and first.strip() == "0":
            inside = second[0]
        text = f"{text[:at]}delta({inside}){text[end + 1 :]}"
    return text


def matching(text: str, at: int) -> int:
    """Return where the bracket that opens at a place is closed; the end of the text if it never is."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] in OPENING) - (text[i] in CLOSING)
        if depth == 0:
            return i
    return len(text)


def split(text: str, separator: str | re.Pattern[str]) -> list[str]:
    """Return the pieces of a text between separators outside of brackets; none of an empty text."""
    pattern = re.compile(re.escape(separator)) if isinstance(separator, str) else separator
    pieces, start, at = [], 0, 0
    while at < len(text):
        if text[at] in OPENING:
            at = matching(text, at) + 1
        elif found := pattern.match(text, at):
            pieces.append(text[start:at])
            start = at = found.end() if found.end() > at else at + 1
        else:
            at += 1
    return [*pieces, text[start:]] if pieces or text.strip() else []


def typed(node: Node) -> str:
    """Return what stands in the file, lists and mappings on one line."""
    if isinstance(node, ScalarNode):
        return node.text
    if isinstance(node, SequenceNode):
        return f"[{', '.join(map(typed, node.items))}]"
    entries = node if isinstance(node, MappingNode) else ()
    return f"{{{', '.join(f'{entry.key.text}: {typed(entry.value)}' for entry in entries)}}}"


def unfolded(node: Node) -> Node:
    """Return the lists or the mapping that a text holds, "Matrix([[1, 2]])" or "{x: 1}"; other nodes as they are."""
    if not isinstance(node, ScalarNode):
        return node
    text = node.text.strip()
    if found := _MATRIX.match(text):
        text = "[]" if _EMPTY.match(found[1]) else found[1].strip()
    if text.startswith("{") and matching(text, 0) == len(text) - 1:
        return _mapped(node, text[1:-1])
    return _listed(node, text, 0) if text.startswith("[") and text.endswith("]") else node


def _listed(node: ScalarNode, text: str, depth: int) -> Node:
    text = text.strip()
    if depth < 3 and text.startswith("[") and matching(text, 0) == len(text) - 1:
        return SequenceNode(node.place, tuple(_listed(node, item, depth + 1) for item in split(text[1:-1], ",")))
    return unfolded(ScalarNode(node.place, text)) if text.startswith(("Matrix(", "Immutable")) else _leaf(node, text)


def _mapped(node: ScalarNode, text: str) -> Node:
    """The entries "name: value" of a text, as far as they are such; the node where one is not."""
    pairs = [split(item, ":") for item in split(text, ",")]
    if any(len(pair) != 2 for pair in pairs):
        return node
    entries = {name.strip(): _leaf(node, value.strip()) for name, value in pairs}
    named = {name: Entry(ScalarNode(node.place, name), value) for name, value in entries.items()}
    return MappingNode(node.place, named)


def _leaf(node: ScalarNode, text: str) -> ScalarNode:
    """The text of an entry; its quotes, if it has any, are left out."""
    bare = text[1:-1] if len(text) > 1 and text[0] == text[-1] and text[0] in "'\"" else text
    return ScalarNode(node.place, bare, "plain")
