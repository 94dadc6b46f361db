"""What stands beside a value: other quantities there, regions of convergence."""

import pytest

from solver.classroom.reading.control_laws import coefficients_of
from solver.classroom.reading.remarks import (
    behind_equation,
    without_region,
    without_remarks,
    without_transformed,
)


@pytest.mark.parametrize(
    ("text", "bare"),
    [
        ("s = -0.42 (K = 0.385)", "s = -0.42"),
        ("±1.41j at K = 6", "±1.41j"),
        ("-1/3 at ω = √5", "-1/3"),
        ("K = 6 at s = 2j", "K = 6"),
        ("2 (3 + x)", "2 (3 + x)"),
        ("-1, -2", "-1, -2"),
    ],
)
def test_values_of_other_names_are_left_out(text, bare):
    assert without_remarks(text, "breakaway_points") == bare


@pytest.mark.parametrize("text", ["1/(s+2), Re s > -2", "1/(s+2) for Re(s) > -2", "1/(s+2) (ROC: Re s > -2)"])
def test_where_a_transform_converges_is_left_out(text):
    assert without_region(text).rstrip() == "1/(s+2)"


def test_what_is_transformed_is_left_out_where_the_transform_is_asked_for():
    assert without_transformed("L{f(t)} = 1/s", "F") == "1/s"
    assert without_transformed("L^-1{F(s)} = 1", "f") == "1"
    assert without_transformed("L^-1{F(s)} = 1", "F") == "L^-1{F(s)} = 1"


def test_an_equation_before_its_roots_is_left_out():
    assert behind_equation("x^2 - 3x - 4 = 0, x = 4, -1") == "x = 4, -1"
    assert behind_equation("x1 = 0, x2 = 1") == "x1 = 0, x2 = 1"


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("u(k) = u(k-1) + 7.1 e(k) - 12 e(k-1) + 5e(k-2)", "[(7.1), -(12), (5)]"),
        ("u_k = u_{k-1} + 7.1e_k - 12e_{k-1} + 5e_{k-2}", "[(7.1), -(12), (5)]"),
        ("u[k] = u[k - 1] + 7.1 e[k] - 12 e[k - 1] + 5 e[k - 2]", "[(7.1), -(12), (5)]"),
        ("Δu(k) = 7.1 e(k) - 12 e(k-1) + 5 e(k-2)", "[(7.1), -(12), (5)]"),
        ("u(k) = 7.1 e(k) - 12 e(k-1) + 5 e(k-2)", ""),
        ("u(k) = -u(k-1) + 7.1 e(k)", ""),
        ("u(k) = u(k-2) + 7.1 e(k)", ""),
        ("u(k) = u(k-1) + 7.1 e(k) + 2 e(k)", ""),
    ],
)
def test_the_coefficients_of_a_law_in_differences(text, found):
    assert coefficients_of(text) == found
