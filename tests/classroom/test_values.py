"""Values as a student writes them: by the kind of our answer, with their decimals, or a fault at its place."""

import pytest
import sympy as sp

from solver.classroom.reading.names import names_for
from solver.classroom.reading.values import Reader
from solver.problem.nodes import MappingNode
from solver.problem.source import Fault, Source
from solver.problem.yaml_tree import parse_yaml

a, b, K = (sp.Symbol(name, real=True) for name in "abK")
t, k = sp.symbols("t k")
M = sp.ImmutableMatrix
CONDITION = sp.Lt(a, b)


def read(text, ours, *, discrete=False):
    root = parse_yaml(Source("a.yaml", f"x: {text}"))
    assert isinstance(root, MappingNode)
    names = names_for({"a": a, "b": b, "K": K}, {"m": sp.Integer(2)}, {"x": ours}, discrete)
    return Reader(names, discrete=discrete).read(root["x"], ours)


@pytest.mark.parametrize(
    ("text", "condition"),
    [
        ("0 < K < 6", sp.And(sp.Lt(0, K), K < 6)),
        ("0 <= K", sp.Le(0, K)),
        ("K > 0 and a != b", sp.And(K > 0, sp.Ne(a, b))),
        ("K < 0 or K > 6 and a > 0", sp.Or(K < 0, sp.And(K > 6, a > 0))),
        ("(K < 0 or K > 6) and a > 0", sp.And(sp.Or(K < 0, K > 6), a > 0)),
        ("a = b", sp.Eq(a, b, evaluate=False)),
        ("a == b", sp.Eq(a, b, evaluate=False)),
        ("Eq(a, b)", sp.Eq(a, b, evaluate=False)),
        ("Ne(a, b)", sp.Ne(a, b)),
        ("a < b = K", sp.And(a < b, sp.Eq(b, K))),
        ("always", sp.true),
        ("never", sp.false),
        ("Yes", sp.true),
        ("((a < b))", a < b),
        ("(a + b)*(a - b) < (1)", (a + b) * (a - b) < 1),
    ],
)
def test_conditions_are_read(text, condition):
    found = read(f"'{text}'", CONDITION)
    assert found.value == found.form == condition


@pytest.mark.parametrize(
    ("text", "ours", "column", "length", "message"),
    [
        ("'a + b'", CONDITION, 5, 5, "a condition such as 0 < K < 6 is expected here"),
        ("'Eq(a, b, K)'", CONDITION, 5, 11, "Eq has two sides"),
        ("'Ne(a)'", CONDITION, 5, 5, "Ne has two sides"),
        ("'j < 1'", CONDITION, 5, 5, "only real quantities can be compared"),
        ("'" + "(" * 14 + "a<b" + ")" * 14 + "'", CONDITION, 5, 5, "the condition is nested too deeply"),
        ("maybe", True, 4, 5, "yes or no is expected here"),
        ("1 ± 2", a, 4, 5, "± stands for two values; one is expected here"),
        ("[1, 2]", a, 4, 6, "a value is expected here, not a list"),
        ("", a, 3, 1, "a value is expected here, not nothing"),
        ("5", {a: b, b: a}, 4, 1, "names with their values are expected here, such as {x: 1, y: 2}"),
        ("a +", a, 5, 2, ""),
    ],
)
def test_what_cannot_be_read_is_a_fault_at_its_place(text, ours, column, length, message):
    with pytest.raises(Fault) as caught:
        read(text, ours)
    (fault,) = caught.value.diagnostics
    assert message in fault.message
    assert not message or (fault.column, fault.length) == (column, length)


def test_nesting_is_read_up_to_a_depth():
    assert read("'" + "(" * 12 + "a<b" + ")" * 12 + "'", CONDITION).value == (a < b)


@pytest.mark.parametrize(
    ("text", "ours", "value"),
    [
        ("yes", True, True),
        ("No", True, False),
        ("Asymptotically-Stable", "stable", "asymptotically stable"),
        ("marginally_stable", "stable", "marginally stable"),
        ("m a + i", a, 2 * a + sp.I),
        ("[[5]]", a, sp.Integer(5)),
        ("[1 ± 2, 5]", [a], [3, -1, 5]),
        ("all", sp.S.Reals, sp.S.Reals),
        ("none", [a], []),
        ("{a: 1, b: K}", {a: b}, {a: 1, b: K}),
        ("1 + K", {a: b}, {a: 1 + K}),
        ("[a < b, K > 0]", [CONDITION], [a < b, K > 0]),
        ("[stable, un-stable]", ["stable"], ["stable", "un stable"]),
        ("[1, 2]", M([[a, b]]), M([[1, 2]])),
        ("[1, 2]", M([a, b]), M([1, 2])),
        ("[1, 2]", M([[a, b], [a, b]]), M([1, 2])),
        ("[1, 2, 3]", M([[a, b], [a, b]]), M([[1, 2, 3]])),
        ("[[1, 2], [], [3, 4]]", M([[a]]), M([[1, 2], [3, 4]])),
        ("[]", M([[a]]), M(1, 0, [])),
        ("7", M([[a]]), M([[7]])),
        ("[[[1], [2]], [[3], [4]]]", [M([a])], [M([1, 2]), M([3, 4])]),
    ],
    ids=str,
)
def test_a_value_is_read_by_the_kind_of_ours(text, ours, value):
    assert read(text, ours).value == value


@pytest.mark.parametrize(
    ("text", "half_unit", "digits"),
    [
        ("0.67", sp.Rational(1, 200), 2),
        ("12.5", sp.Rational(1, 20), 3),
        ("1.5e3", 50, 2),
        ("2.50e-1", sp.Rational(1, 2000), 3),
        ("0.0", sp.Rational(1, 20), 0),
        ("0.050", sp.Rational(1, 2000), 2),
    ],
)
def test_a_decimal_is_known_to_half_a_unit_of_its_last_digit(text, half_unit, digits):
    found = read(f"{text} a", a)
    ((symbol, decimal),) = found.decimals.items()
    assert found.form == symbol * a
    assert found.value == sp.Rational(text) * a
    assert tuple(decimal) == (sp.Rational(text), half_unit, digits)


def test_each_decimal_has_a_symbol_of_its_own_and_whole_numbers_have_none():
    found = read("[0.5 + 2, 0.5 a, 3]", [a])
    assert len(found.decimals) == 2
    assert [value.free_symbols & found.decimals.keys() == set() for value in found.form] == [False, False, True]
    assert found.value == [sp.Rational(5, 2), a / 2, 3]


def test_in_discrete_time_impulse_and_step_are_sequences():
    value = read("delta(k) + step(k - 1)", k, discrete=True).value
    assert [value.subs(k, at) for at in (-1, 0, 1, 2)] == [0, 1, 1, 1]
    assert read("delta(t)", t).value == sp.DiracDelta(t)


def test_names_mean_what_they_mean_in_the_problem():
    names = names_for({"a": a, "k": K}, {"m": sp.Integer(2), "b": sp.Integer(3)}, {"x": [b, M([[a]])]}, False)
    assert names.symbols == {"a": a, "k": K, "b": b}
    assert names.values == {"m": sp.Integer(2)}
    assert "k" not in names.variables
    assert {"s", "t", "z", "i", "I", "E"} <= names.variables.keys()
    assert "k" in names_for({"k": K}, {}, {}, True).variables
    assert "i" not in names_for({"i": a}, {}, {}, False).variables
    assert "I" not in names_for({}, {"I": a}, {}, False).variables
