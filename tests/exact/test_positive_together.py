"""Conditions that hold together, in their shortest form: products taken apart, nothing said twice."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.exact.stability.conditions import all_positive
from tests.helpers.tried import tried

K, T = sp.symbols("K T", real=True)
a = sp.Symbol("a", positive=True)
FACTORS = (K, T, 1 - T, T + 2, K - 1, a, a + K, K + T)


@pytest.mark.parametrize(
    ("conditions", "expected"),
    [
        ([-K * (T - 1), K], (K > 0) & (T < 1)),
        ([K * T, -K * (T - 1)], (K > 0) & (T > 0) & (T < 1)),
        ([K * (T + 2), K * (1 - T)], (K > 0) & (T > -2) & (T < 1)),
        ([a * K, K * (1 - T), a], (K > 0) & (T < 1)),
        ([-K * T, K, T], sp.false),
        ([K * T], K * T > 0),
        ([K * T, -T], (K < 0) & (T < 0)),
        ([T, T + 2, K], (K > 0) & (T > 0)),
    ],
)
def test_what_others_imply_is_not_said(conditions, expected):
    assert all_positive(conditions) == expected


@tried(60)
@given(st.lists(st.lists(st.sampled_from(FACTORS), min_size=1, max_size=3), min_size=1, max_size=4), st.data())
def test_the_short_form_holds_where_all_are_positive(listed, data):
    conditions = [sp.Mul(*each) for each in listed]
    found = sp.And(all_positive(conditions))
    for _ in range(12):
        point = {x: sp.Rational(data.draw(st.integers(-37, 37)), 10) + sp.Rational(1, 77) for x in (K, T)}
        point[a] = sp.Rational(data.draw(st.integers(1, 30)), 10) + sp.Rational(1, 91)
        assert bool(found.subs(point)) == all(condition.subs(point) > 0 for condition in conditions)
