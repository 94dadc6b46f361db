"""Options of a part: read by their kind, or taken from an earlier part."""

from __future__ import annotations

from typing import Any

from solver.derivation import Option, Task
from solver.problem.context import Context, Earlier
from solver.problem.model import Reference
from solver.problem.nodes import MappingNode, Node, scalar
from solver.problem.source import Fault, did_you_mean


def read_option(option: Option, node: Node, context: Context) -> Any:
    """Return the value of an option as its kind reads it, or a `Reference` to an earlier part; raises Fault."""
    if isinstance(node, MappingNode) and "from" in node:
        return _reference(option, node, context)
    return option.kind.read(node, option.name, context)


def _reference(option: Option, node: MappingNode, context: Context) -> Reference:
    """`{from: b, answer: K}`."""
    if not option.kind.referable:
        raise node.fault(f"'{option.name}' cannot be taken from an earlier part")
    return read_reference(node, option.answer or option.name, context.earlier, option.kind.item)


def earlier_part(node: Node, earlier: Earlier) -> tuple[str, Task[Any, Any], str]:
    """Return the name of an earlier part with its task and first method; raises Fault if there is no such part."""
    part = scalar(node).text
    if part not in earlier:
        note = f"earlier parts are: {', '.join(earlier)}" if earlier else "there is no earlier part"
        raise node.fault(f"'{part}' is not an earlier part", suggestion=did_you_mean(part, earlier), note=note)
    source = earlier[part]
    if source is None:
        raise Fault  # the part is wrong itself, and reported
    return (part, *source)


def answers_of(task: Task[Any, Any], method: str) -> tuple[str, ...]:
    """Return the names of the answers that a task gives by a method."""
    return tuple(name for name, each in task.answers.items() if not each.methods or method in each.methods)


def read_reference(node: MappingNode, usual: str, earlier: Earlier, item: str = "") -> Reference:
    """`{from: b, answer: K}`; without `answer` the usual one. Raises Fault where there is no such part or answer.

    `item` is the key that says which one of a list is meant: `{from: b, point: 2}`; the first where it is not there.
    """
    known = ["answer", *([item] if item else [])]
    for entry in node:
        if entry.key.text not in ("from", *known):
            suggestion = did_you_mean(entry.key.text, known)
            raise entry.key.fault(f"unknown key '{entry.key.text}' beside 'from'", suggestion=suggestion)
    part, task, method = earlier_part(node["from"], earlier)
    answer = scalar(node["answer"]).text if "answer" in node else usual
    given = answers_of(task, method)
    if answer not in given:
        message = f"part {part} ({task.name}) gives no '{answer}'"
        note = f"its answers are: {', '.join(given)}" + ("" if "answer" in node else "; name one by 'answer:'")
        at = node.get("answer") or node
        raise at.fault(message, suggestion=did_you_mean(answer, given), note=note)
    return Reference(part, answer, _number(node, item) if item else 0)


def _number(node: MappingNode, item: str) -> int:
    """Which one of a list, from 1."""
    if item not in node:
        return 1
    text = scalar(node[item]).text
    if not (text.isdecimal() and text.isascii() and 0 < len(text) < 4 and int(text)):
        raise node[item].fault(f"'{item}' is a whole number from 1: the place in the list")
    return int(text)
