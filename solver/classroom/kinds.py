"""What an answer is to be, in words: a matrix, a list, an expression; told without telling the answer."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from solver.classroom.reading.likeness import is_condition
from solver.classroom.reading.words import truth
from solver.patches import Program
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode


def kind_of(ours: Any) -> str:
    """Return the kind of our own answer, a phrase."""
    if isinstance(ours, bool):
        return "yes or no"
    if isinstance(ours, str):
        return "words"
    if isinstance(ours, sp.MatrixBase):
        return "a matrix"
    if isinstance(ours, Mapping | Program):
        return "a program" if isinstance(ours, Program) else "names with values"
    if isinstance(ours, sp.Set | list | tuple):
        items = {kind_of(each) for each in ours} if isinstance(ours, list | tuple) else set()
        return LISTS.get(min(items, default=""), "a list")
    return "a condition" if is_condition(ours) else "an expression"


LISTS = {"a matrix": "a list of matrices", "a condition": "a list of conditions", "words": "a list of words"}


def like(node: Node) -> Any:
    """Return a value of the kind that something in a file looks like, where we have no answer of our own to go by."""
    if isinstance(node, MappingNode):
        return {}
    if isinstance(node, SequenceNode):
        return sp.ones(1) if any(isinstance(item, SequenceNode) for item in node.items) else []
    return (isinstance(node, ScalarNode) and truth(node.text) is not None) or sp.S.One
