"""Answers in the spelling of sympy and of other notations, as text; brackets are matched, nothing is evaluated."""

import pytest

from solver.classroom.reading.brackets import matching, split
from solver.classroom.reading.choices import Choices
from solver.classroom.reading.matrices import Unfolding
from solver.classroom.reading.spelling import respelled
from solver.problem.nodes import MappingNode, Place, ScalarNode, SequenceNode


@pytest.mark.parametrize(
    ("text", "ours"),
    [
        ("Heaviside(t - 2) + DiracDelta(t)", "step(t - 2) + delta(t)"),
        ("2*Heaviside(k - 3, 1)*k + Heaviside(t, 2)", "2*step(k - 3)*k + step(t, 2)"),
        ("arctan (x)*Abs(y)", "atan(x)*abs(y)"),
        ("KroneckerDelta(k, 0)", "delta(k)"),
        ("KroneckerDelta(k, )", "delta(k)"),
        ("KroneckerDelta(0, k)", "delta( k)"),
        ("KroneckerDelta(0)", "delta(0)"),
        ("2*KroneckerDelta(k, 3) - KroneckerDelta(k, n + 1)", "2*delta((k) - ( 3)) - delta((k) - ( n + 1))"),
        ("KroneckerDelta(f(k, 2), 1)", "delta((f(k, 2)) - ( 1))"),
        ("KroneckerDelta(k", "delta(k)"),
        ("oo - ∞ + foo", "inf - inf + foo"),
        ("√(2) – 1", "sqrt(2) - 1"),
    ],
)
def test_a_text_is_respelled(text, ours):
    assert respelled(text) == ours


@pytest.mark.parametrize(("text", "at", "end"), [("(a)", 0, 2), ("f(a(b)c)d", 1, 7), ("(a", 0, 2), ("([)]", 0, 3)])
def test_where_a_bracket_is_closed(text, at, end):
    assert matching(text, at) == end


@pytest.mark.parametrize(
    ("text", "pieces"),
    [
        ("a,b", ["a", "b"]),
        ("f(a,b),c", ["f(a,b)", "c"]),
        ("", []),
        ("a,", ["a", ""]),
        ("[1,2],[3,4]", ["[1,2]", "[3,4]"]),
    ],
)
def test_a_list_is_split_outside_of_brackets(text, pieces):
    assert split(text, ",") == pieces


def test_a_mapping_in_a_text_is_read_as_one():
    node = Unfolding(Choices()).node(ScalarNode(Place(), "{v: r*w, i: [1, 2]}"))
    assert isinstance(node, MappingNode)
    assert node.plain() == {"v": "r*w", "i": "[1, 2]"}


def test_braces_without_colons_are_a_set():
    node = Unfolding(Choices()).node(ScalarNode(Place(), "{v, 2}"))
    assert isinstance(node, SequenceNode)
    assert (node.braces, node.plain()) == (True, ["v", "2"])


def test_lists_in_a_text_are_read_as_deep_as_a_list_of_matrices_is():
    node = Unfolding(Choices()).node(ScalarNode(None, "[[[[[[1], 2]]]]]"))
    for _ in range(5):
        node = node.items[0]
    assert node.text == "[1]"
