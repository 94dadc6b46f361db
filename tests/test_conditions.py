"""Parameters that carry what is known of them."""

import pickle

import pytest
import sympy as sp

from solver.conditions import Condition, Parameter, conditions_of, holds_at, symbols_of, without_conditions

x, y = sp.Symbol("x", real=True), sp.Symbol("y", real=True)
BELOW_TWO = Condition(2 - x, ">")
a = Parameter("x", (BELOW_TWO,), real=True)
b = Parameter("y", (Condition(y, ">="), Condition(y - x, "!=")), real=True)


def test_a_parameter_is_a_symbol_of_its_own_that_crosses_to_another_process():
    assert a != x
    assert a == Parameter("x", (BELOW_TWO,), real=True)
    assert a != Parameter("x", (), real=True)
    again = pickle.loads(pickle.dumps(a))  # noqa: S301 - our own
    assert (again, again.conditions, again.is_real) == (a, a.conditions, True)
    assert a.plain == x
    assert sorted([b, a, sp.Symbol("w")], key=sp.default_sort_key) == [sp.Symbol("w"), a, b]


def test_symbols_and_conditions_are_found_once_and_sorted():
    assert symbols_of(b * a, a + sp.Symbol("w")) == [sp.Symbol("w"), a, b]
    assert conditions_of([a, b, a, x]) == tuple(sorted({*a.conditions, *b.conditions}, key=str))
    assert conditions_of([x, y]) == ()
    assert without_conditions(a + 2 * b + sp.Symbol("w")) == x + 2 * y + sp.Symbol("w")
    assert without_conditions(sp.Matrix([[a, y]])) == sp.Matrix([[x, y]])


@pytest.mark.parametrize(
    ("point", "holds"),
    [
        ({a: 1, b: 3}, True),
        ({a: 2, b: 3}, False),
        ({a: 3, b: 4}, False),
        ({a: 1, b: 0}, True),
        ({a: 1, b: -1}, False),
        ({a: 1, b: 1}, False),
        ({a: sp.Rational(19999999999, 10**10), b: 3}, True),
        ({b: 3}, True),
        ({b: -3}, False),
        ({a: sp.I, b: 3}, False),
    ],
    ids=str,
)
def test_conditions_hold_at_a_point_or_do_not_and_those_of_other_symbols_are_left_out(point, holds):
    assert holds_at(point.keys(), point) is holds
