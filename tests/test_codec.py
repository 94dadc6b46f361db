"""Exact values as plain data: what comes back is what was sent, as it was written."""

import pickle

import pytest
import sympy as sp

from solver.conditions import Condition, Parameter
from solver.limits.codec import NotPlain, decode, encode

t, s = sp.symbols("t s")
a = sp.Symbol("a", positive=True)
x = sp.Dummy("x", real=True)

VALUES = [
    sp.sin(2 * t + sp.pi / 4),
    sp.Mul(2, t + 1, evaluate=False),
    sp.Pow(sp.Integer(4), sp.Rational(1, 2), evaluate=False),
    sp.ImmutableMatrix([[1, sp.Rational(1, 2)], [a, x]]),
    sp.ImmutableMatrix(2, 0, []),
    [sp.Integer(1), (sp.I, -sp.oo), "in words", True, None],
    {"x": sp.Integer(3), sp.Symbol("y"): [sp.E]},
    sp.true,
    sp.Eq(a, 1),
    sp.And(a > 1, t < 2),
    sp.Piecewise((1, t > 0), (0, True)),
    sp.Float("1.25", 40),
    sp.Float(0),
    sp.Function("f")(t).diff(t),
    sp.Heaviside(t - 1, 1),
    sp.Integral(t, (t, 0, 1)),
    sp.FiniteSet(1, 2),
    sp.Interval(0, 1, True),
    sp.EmptySet,
    sp.zoo,
    sp.Poly(t**2 + 1, t),
    sp.CRootOf(t**5 + t + 1, 0),
    Parameter("k", (Condition(sp.Symbol("k", real=True) - 1, ">"), Condition(t, "!=")), real=True),
    sp.Add(sp.sqrt(2), sp.sqrt(2), evaluate=False),
]


@pytest.mark.parametrize("value", VALUES, ids=str)
def test_a_value_comes_back_as_it_was(value):
    back = decode(pickle.loads(pickle.dumps(encode(value))))  # noqa: S301 - our own bytes
    assert (type(back), back, sp.srepr(back)) == (type(value), value, sp.srepr(value))


def test_equal_parts_are_written_once():
    root = sp.sqrt(t + 1)
    assert len(encode([root, root, root])) == len(encode(root)) + 1


def test_a_deep_value_does_not_overflow():
    deep = t
    for _ in range(5000):
        deep = sp.Function("f")(deep)
    nodes = encode(deep)
    assert len(nodes) == 5001
    assert encode(decode(nodes)) == nodes


class NotOfSympy(sp.Function):
    """A class of mathematics that another process may not have."""


@pytest.mark.parametrize("value", [object(), NotOfSympy(t), lambda: None, [sp.Integer(1), object()], {"a": {1, 2}}])
def test_what_is_no_mathematics_is_not_plain(value):
    with pytest.raises(NotPlain):
        encode(value)


def test_nodes_of_other_modules_are_not_plain():
    with pytest.raises(NotPlain, match="system"):
        decode([("sympy", "os", "system", ())])
    with pytest.raises(NotPlain, match="Printer"):
        decode([("sympy", "sympy.printing.printer", "Printer", ())])


@pytest.mark.parametrize("node", [("sympy", "os", "system", ()), ("sympy", "sympy.core.sympify", "sympify", ())])
def test_nodes_cannot_name_anything_but_mathematics(node):
    with pytest.raises((NotPlain, AttributeError)):
        decode([node])
