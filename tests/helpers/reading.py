"""Values read as a student writes them, without a problem around them."""

import sympy as sp

from solver.classroom.reading.names import names_for
from solver.classroom.reading.values import Reader
from solver.problem.nodes import MappingNode
from solver.problem.source import Source
from solver.problem.yaml_tree import parse_yaml

a, b, K = (sp.Symbol(name, real=True) for name in "abK")


def read(text, ours, expected=None, *, discrete=False, comma=False):
    """What is read of a value in an answer file, for an answer of the kind of `ours`."""
    root = parse_yaml(Source("a.yaml", f"x: {text}"), colonless=True)
    assert isinstance(root, MappingNode)
    names = names_for({"a": a, "b": b, "K": K}, {"m": sp.Integer(2)}, {"x": ours}, discrete)
    return Reader(names, discrete=discrete, decimal_comma=comma).read(root["x"], ours, expected)
