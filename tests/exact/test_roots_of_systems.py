"""All real solutions: families in one form, double roots, radicals, what is excluded, what is refused."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.modelling.roots_of_systems import real_solutions

x, y, z, a, k = sp.symbols("x y z a k", real=True)
n, m = sp.symbols("n m", integer=True)
pi = sp.pi
THIRD = 2 * pi / 3

CASES = [
    ([sp.sin(2 * x) - sp.sin(x)], [x], [{x: 2 * pi * n - pi / 3}, {x: pi * n}, {x: 2 * pi * n + pi / 3}]),
    ([sp.cos(2 * x) - sp.cos(x)], [x], [{x: 2 * pi * n - THIRD}, {x: 2 * pi * n}, {x: 2 * pi * n + THIRD}]),
    ([sp.sin(x + y), sp.cos(x - y)], [x, y], [{x: pi * n / 2 + pi / 4, y: pi * m + pi * n / 2 - pi / 4}]),
    ([sp.sin(x) ** 2 + sp.sin(x) * sp.cos(x) - 1], [x], [{x: pi * n + pi / 4}, {x: pi * n + pi / 2}]),
    ([sp.sqrt(x) - x + 2], [x], [{x: 4}]),
    ([sp.sqrt(x) + 1], [x], []),
    ([sp.exp(x) + 1], [x], []),
    ([(x - 1) ** 2 * (x + 2)], [x], [{x: -2}, {x: 1}]),
    ([sp.exp(x) - 1 - x], [x], [{x: 0}]),
    ([sp.Abs(x) - 2], [x], [{x: -2}, {x: 2}]),
    ([x**2 - 2, y**2 - x], [x, y], [{x: sp.sqrt(2), y: s * 2 ** sp.Rational(1, 4)} for s in (-1, 1)]),
    ([x * y - x, x * y - y, z * x], [x, y, z], [{x: 1, y: 1, z: 0}, {x: 0, y: 0, z: z}]),
    ([10 * (y - x), 28 * x - y - x * z, x * y - sp.Rational(8, 3) * z], [x, y, z],
     [{x: s * 6 * sp.sqrt(2), y: s * 6 * sp.sqrt(2), z: 27 * abs(s)} for s in (-1, 0, 1)]),
    ([x - a, a - k], [x], []),
]  # fmt: skip


@pytest.mark.parametrize(("equations", "unknowns", "points"), CASES)
def test_all_solutions_in_their_order(equations, unknowns, points):
    assert list(real_solutions(equations, unknowns).points) == points


def test_roots_are_searched_by_intervals_and_none_is_lost():
    found = real_solutions([sp.sin(x) - x / 10], [x], {x: (sp.Integer(-20), sp.Integer(20))})
    assert found.certain
    assert len(found.points) == 7
    assert found.searched == ({x: (-20, 20)},)


def test_what_must_hold_of_parameters_is_told():
    found = real_solutions([x * y - 1, x + y - k], [x, y])
    assert found.needs == (((k - 2) * (k + 2) >= 0,),) * 2
    positive = sp.Symbol("p", positive=True)
    assert real_solutions([x**2 - positive], [x]).needs == ((), ())


@pytest.mark.parametrize(
    ("equations", "unknowns", "kind"),
    [
        ([x**3 - x - k], [x], "solutions/needs_numbers"),
        ([sp.exp(x) * sp.sin(x * y) - y], [x, y], "solutions/curve"),
    ],
)
def test_what_cannot_be_solved_says_why(equations, unknowns, kind):
    with pytest.raises(NotExact) as caught:
        real_solutions(equations, unknowns)
    assert caught.value.reason.kind == kind


numbers = st.integers(-5, 5)


@settings(max_examples=25)
@given(st.dictionaries(numbers, numbers, min_size=1, max_size=3), numbers)
def test_a_system_with_known_roots_has_them(roots, c):
    """Π (x − pᵢ) and y less the polynomial through all (pᵢ, qᵢ), mixed."""
    first = sp.Mul(*(x - p for p in roots))
    others = {p: [r for r in roots if r != p] for p in roots}
    second = y - sum(q * sp.Mul(*((x - r) / sp.Integer(p - r) for r in others[p])) for p, q in roots.items())
    found = real_solutions([sp.expand(first + c * second), sp.expand(second)], [x, y])
    assert {(point[x], point[y]) for point in found.points} == set(roots.items())
