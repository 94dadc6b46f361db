"""Numbers that are said twice, exactly and as a decimal."""

import pytest
import sympy as sp

from solver.problem.source import Fault
from tests.helpers.reading import read


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("pi/3 ≈ 1.047", sp.pi / 3),
        ("t_p = pi/3 = 1.0472", sp.pi / 3),
        ("2.0944/2 = 1.0472", sp.Rational("1.0472")),
        ("1*2 - 3 = -1", sp.Integer(-1)),
    ],
)
def test_the_first_of_equal_numbers_is_the_value(text, value):
    found = read(text, sp.pi)
    assert (found.value, found.respelt) == (value, True)


@pytest.mark.parametrize("text", ["pi/3 = 1.57", "pi/2 ≈ 1.047", "1.5 ≈ pi/2", "pi/3 = 1.05 = 1.2"])
def test_numbers_that_are_not_equal_are_refused(text):
    with pytest.raises(Fault):
        read(text, sp.pi)


def test_the_entries_of_a_row_may_be_said_twice():
    assert read("k1 = 3, k2 = √6 ≈ 2.449", sp.Matrix([[1, 2]])).value == sp.Matrix([[3, sp.sqrt(6)]])


def test_a_name_with_two_values_is_refused():
    with pytest.raises(Fault, match="k1 stands for two values"):
        read("k1 = 3, k1 = 4", sp.Matrix([[1, 2]]))
