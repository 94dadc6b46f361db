"""Programs of an analog computer as students hand them in: the mapping of the answer, in YAML or in JSON."""

from __future__ import annotations

from typing import Any

from solver.classroom.reading.spelling import typed
from solver.classroom.reading.texts import TextReader
from solver.classroom.submitted import Submitted
from solver.patches import NotAProgram, PatchFault, program_of
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode
from solver.problem.source import Fault, InputError, Source
from solver.problem.yaml_tree import parse_yaml


def program_in(node: Node, texts: TextReader) -> Submitted:
    """Return the program that a node describes; raises Fault at the place of what is wrong."""
    node = _unquoted(node)

    def read(value: Any) -> Any:
        if not isinstance(value, str | int):
            raise ValueError("no value")
        try:
            return texts.expression(ScalarNode(node.place, str(value), "quoted"))[0]
        except Fault as fault:
            raise ValueError(str(fault)) from fault

    try:
        program = program_of(node.plain(), read)
    except NotAProgram as wrong:
        first = wrong.faults[0]
        raise _at(node, first).fault(first.message, note=_others(wrong)) from None
    return Submitted(program, program, typed=typed(node))


def _unquoted(node: Node) -> Node:
    """The mapping within a text, as JSON that stands in quotes."""
    if not isinstance(node, ScalarNode) or not node.text.lstrip().startswith("{"):
        return node
    try:
        return parse_yaml(Source("", node.text))
    except InputError as error:
        raise node.fault(error.diagnostics[0].message) from None


def _at(node: Node, fault: PatchFault) -> Node:
    """The innermost node that the place of a fault leads to."""
    for step in fault.place:
        inner = None
        if isinstance(node, MappingNode):
            inner = node.get(str(step))
        elif isinstance(node, SequenceNode) and isinstance(step, int) and step < len(node.items):
            inner = node.items[step]
        if inner is None:
            break
        node = inner
    return node


def _others(wrong: NotAProgram) -> str:
    count = len(wrong.faults) - 1
    return f"there {'is one more fault' if count == 1 else f'are {count} more faults'} of this kind" if count else ""
