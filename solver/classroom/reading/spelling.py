"""Spellings of sympy, as our results hold them, and of other programs; what was typed, on one line.

`Heaviside(t - 2)`, `KroneckerDelta(k, 1)`, `DiracDelta(t, 1)`, `Abs(a)` are read as `step(t - 2)`, `delta(k - 1)`,
`delta'(t)`, `abs(a)`. Only text is changed here; nothing is evaluated.
"""

from __future__ import annotations

import re

from solver.classroom.reading.brackets import matching, split
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode

FUNCTIONS = {"Heaviside": "step", "DiracDelta": "delta", "Abs": "abs", "KroneckerDelta": "delta", "arccos": "acos",
             "arcsin": "asin", "arctan": "atan", "heaviside": "step", "dirac": "delta",
             "UnitStep": "step", "HeavisideTheta": "step"}  # fmt: skip
_FUNCTION = re.compile(r"\b(" + "|".join(FUNCTIONS) + r")\s*[(\[]")
_QUOTIENTS = {"coth": "(cosh({0})/sinh({0}))", "sech": "(1/cosh({0}))", "csch": "(1/sinh({0}))",
              "cot": "(1/tan({0}))", "sec": "(1/cos({0}))", "csc": "(1/sin({0}))",
              "lg": "(log({0})/log(10))", "log10": "(log({0})/log(10))", "log_10": "(log({0})/log(10))"}  # fmt: skip
_QUOTIENT = re.compile(
    r"(?<![A-Za-z_])(" + "|".join(_QUOTIENTS) + r"|log_?[{(]10[)}]|log₁₀)(?:\s*([(\[])|\s*(\d+(?:\.\d+)?)(?![\w.(]))",
    re.IGNORECASE,
)
_ROOT = re.compile(r"(?<=\w)√\(")
"""A root behind a name, a√(2), which is none of a longer name."""

_INFINITY = re.compile(r"\b(?:oo|infinity|infinite|Infinity|Inf|unendlich(?: groß)?)\b|∞")


def respelled(text: str) -> str:
    """Return the text of an expression with functions named as our notation names them."""
    text = _FUNCTION.sub(lambda found: f"{FUNCTIONS[found[1]]}(", _kronecker(_impulses(_steps(_quotients(text)))))
    return _ROOT.sub(" sqrt(", _INFINITY.sub("inf", text)).replace("√(", "sqrt(").replace("–", "-")


def _quotients(text: str) -> str:
    """coth(a), coth 1, log10(a), lg 3 by the functions that we have."""
    while found := _QUOTIENT.search(text):
        end = matching(text, found.end() - 1) if found[2] else found.end()
        inside = text[found.end() : end] if found[2] else found[3]
        form = _QUOTIENTS.get(found[1].lower(), _QUOTIENTS["lg"])
        text = f"{text[: found.start()]}{form.format(inside)}{text[end + bool(found[2]) :]}"
    return text


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


def _impulses(text: str) -> str:
    """DiracDelta(a, 2), a derivative, as delta''(a)."""
    head, at = "DiracDelta(", 0
    while (at := text.find(head, at)) >= 0:
        end = matching(text, at + len(head) - 1)
        first, *order = split(text[at + len(head) : end], ",") or [""]
        if len(order) == 1 and re.fullmatch(r"\s*\d\s*", order[0]):
            primes = "'" * int(order[0])
            text = f"{text[:at]}delta{primes}({first}){text[end + 1 :]}"
        at += len("delta(")
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


def typed(node: Node) -> str:
    """Return what stands in the file, lists and mappings on one line."""
    if isinstance(node, ScalarNode):
        return node.text
    if isinstance(node, SequenceNode):
        inside = "".join(map(_with_comma, node.items, (*node.items[1:], None)))
        return f"{{{inside}}}" if node.braces else f"[{inside}]"
    entries = node if isinstance(node, MappingNode) else ()
    return f"{{{', '.join(f'{entry.key.text}: {typed(entry.value)}' for entry in entries)}}}"


def _with_comma(item: Node, following: Node | None) -> str:
    """An item with the comma after it, and a space if there is one."""
    if following is None:
        return typed(item)
    end, start = item.place, following.place
    tight = end.end_line == start.line and 0 <= start.column - end.end_column <= 1 and start.line > 0
    return f"{typed(item)}{',' if tight else ', '}"
