"""Options of a part: read by their kind, or taken from an earlier part."""

from __future__ import annotations

from typing import Any

from solver.derivation import Option
from solver.problem.context import Context
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
    for entry in node:
        if entry.key.text not in ("from", "answer"):
            suggestion = did_you_mean(entry.key.text, ["answer"])
            raise entry.key.fault(f"unknown key '{entry.key.text}' beside 'from'", suggestion=suggestion)
    part = scalar(node["from"]).text
    if part not in context.earlier:
        note = f"earlier parts are: {', '.join(context.earlier)}" if context.earlier else "there is no earlier part"
        message = f"'{part}' is not an earlier part"
        raise node["from"].fault(message, suggestion=did_you_mean(part, context.earlier), note=note)
    source = context.earlier[part]
    if source is None:
        raise Fault  # the part is wrong itself, and reported
    task, method = source
    answer = scalar(node["answer"]).text if "answer" in node else option.answer or option.name
    given = [name for name, each in task.answers.items() if not each.methods or method in each.methods]
    if answer not in given:
        message = f"part {part} ({task.name}) gives no '{answer}'"
        note = f"its answers are: {', '.join(given)}" + ("" if "answer" in node else "; name one by 'answer:'")
        at = node.get("answer") or node
        raise at.fault(message, suggestion=did_you_mean(answer, given), note=note)
    return Reference(part, answer)
