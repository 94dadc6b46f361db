"""Points are drawn where the conditions hold, and nowhere else."""

from __future__ import annotations

import pytest
import sympy as sp

from solver.conditions import Condition, Parameter, assumed_of
from solver.numeric.evaluation.inside import admits, can_hold
from solver.numeric.evaluation.points import PointSource
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.design.placement import rational_points
from solver.numeric.judges.stability.location import spread_points
from solver.numeric.judges.stability.regions import counterexample

a, b, c = REAL = sp.symbols("a b c", real=True)
n = sp.Symbol("n", integer=True, positive=True)


def with_conditions(listed, symbols=REAL):
    told = tuple(Condition(difference, relation) for difference, relation in listed)
    return [Parameter(x.name, told, **assumed_of(x)) for x in symbols]


@pytest.mark.parametrize(
    "listed",
    [
        [(a, ">"), (1 - a, ">")],
        [(a - 100, ">"), (101 - a, ">")],
        [(a - sp.Rational(1, 100), ">"), (sp.Rational(2, 100) - a, ">")],
        [(a - b, ">"), (b - c, ">"), (c, ">")],
        [(b**2 - 4 * a * c, ">"), (a, ">"), (c, ">")],
        [(4 * a * c - b**2, ">"), (a, ">")],
        [(a - 1000 * b, ">"), (b - 3, ">")],
        [(a**2 + b**2 - 1, ">"), (2 - a**2 - b**2, ">")],
        [(a - b, "!="), (a * b * c, ">")],
    ],
)
def test_points_are_inside(listed):
    symbols = with_conditions(listed)
    for point in PointSource(symbols).several(50):
        values = {x: sp.Rational(str(complex(point[y]).real)) for x, y in zip(REAL, symbols, strict=True)}
        for difference, relation in listed:
            value = difference.xreplace(values)
            assert value > 0 if relation == ">" else value != 0


def test_symbols_that_are_only_compared_with_are_drawn_too_and_left_out():
    first, *_ = with_conditions([(a - b, ">"), (b - 7, ">")])
    assert all(point.keys() == {first} and point[first] > 7 for point in PointSource([first]).several(20))


def test_whole_numbers_stay_whole():
    (m,) = with_conditions([(n - 10, ">=")], [n])
    assert all(point[m] == round(point[m]) and point[m] >= 10 for point in PointSource([m]).several(20))


def test_where_no_point_is_found_that_is_said():
    symbols = with_conditions([(a - b, ">"), (b - c, ">"), (c - a, ">")])
    assert not can_hold(symbols[0].conditions)
    with pytest.raises(NotEvaluable, match="no values of the parameters"):
        PointSource(symbols).draw()


def test_points_of_the_judges_are_inside():
    x, y, _ = with_conditions([(a - sp.Rational(1, 1000), ">"), (sp.Rational(2, 1000) - a, ">"), (b - a, ">")])
    M = sp.ImmutableMatrix([[x, 1], [y, 2]])
    points = [*rational_points(M), *spread_points([M], 10)]
    assert all(
        0.001 < complex(point[x]).real < 0.002 and complex(point[y]).real > complex(point[x]).real for point in points
    )
    assert not admits({x: sp.Rational(1, 2), y: sp.Integer(1)})


def test_a_range_is_judged_inside_the_conditions_only():
    (k,) = with_conditions([(a - 2, ">"), (10 - a, ">")], [a])
    A = sp.ImmutableMatrix([[0, 1, 0], [0, 0, 1], [-k, -3, -2]])
    assert counterexample(A, sp.Lt(k, 6), discrete=False) == ""
    assert counterexample(A, sp.Lt(k, 5), discrete=False)
    assert counterexample(A, sp.Lt(k, 7), discrete=False)
