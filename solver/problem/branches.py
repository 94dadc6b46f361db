"""The branches of a signal-flow graph as a file gives them: [from, to, gain]."""

from __future__ import annotations

import re

import sympy as sp

from solver.problem.lexicon import Lexicon
from solver.problem.nodes import Node, ScalarNode, SequenceNode, scalar
from solver.problem.transfer_functions import read_transfer_function
from solver.symbols import MEANINGS

NODE = r"[A-Za-z0-9_]+"
CALLED = re.compile(r"(?<![A-Za-z0-9_])(?!(?:sqrt|exp|log|sin|cos|tan|abs)\()([A-Za-z][A-Za-z0-9_]*)\(([sz])\)")
"""A block by its name, G_1(s)."""


def read_branch(row: Node, lexicon: Lexicon, discrete: bool) -> tuple[str, str, sp.Expr]:
    """Return the ends of a branch and its gain, a quotient of polynomials; raises Fault.

    A block may be named, G(s): then its name stands for the gain.
    """
    if not isinstance(row, SequenceNode) or len(row.items) not in (2, 3):
        raise row.fault("a branch is [from, to, gain]", note="a gain that is left out is 1")
    source, target = (node_name_of(scalar(item)) for item in row.items[:2])
    if len(row.items) == 2:
        return source, target, sp.Integer(1)
    gain = scalar(row.items[2])
    variable = "z" if discrete else "s"
    text = CALLED.sub(lambda found: found[1] + " " * 3 if found[2] == variable else found[0], gain.text)
    named = ScalarNode(gain.place, text, gain.style)
    value: sp.Expr = read_transfer_function(named, lexicon, discrete, proper=False).cancelled()
    if value == 0:
        raise gain.fault("a branch with the gain 0 adds nothing; leave it out")
    return source, target, value


def node_name_of(node: ScalarNode) -> str:
    """Return the name of a node: letters, digits and _; raises Fault."""
    name = node.text
    if not re.fullmatch(NODE, name):
        raise node.fault("the name of a node is made of letters, digits and _")
    if name in MEANINGS:
        raise node.fault(f"'{name}' cannot be a node: {MEANINGS[name]}")
    return name
