"""Answers that are lists: wide ones value by value, lists of long items broken behind their commas."""

from __future__ import annotations

import sympy as sp

from solver.formula import latex
from solver.formula.width import LINE, broken, width
from solver.render.latex import formula
from solver.render.listed import equations_that_are_zero, told_behind

a, b, x, y = sp.symbols("a b x y", real=True)
LONG = sp.Add(*(sp.Symbol(f"c_{i}") * a**i for i in range(2, 14)))


def test_a_narrow_list_of_points_stays_on_its_line():
    assert "aligned" not in latex(told_behind("points", [{x: a}, {x: b}], formula))


def test_values_of_unknowns_are_equations_without_a_word_or_braces():
    assert latex(told_behind("solution", {x: a}, formula)) == "x = a"
    assert (
        latex(told_behind("solution", {x: a, y: b}, formula)) == "\\begin{aligned}\nx &= a \\\\\ny &= b\n\\end{aligned}"
    )


def test_a_wide_point_is_told_value_by_value():
    told = latex(told_behind("points", [{x: LONG, y: LONG + 1}], formula))
    assert told.count("&=") == 2
    assert r"\{" not in told


def test_several_wide_points_are_numbered():
    told = latex(told_behind("points", [{x: LONG, y: LONG}, {x: LONG, y: a}], formula))
    assert r"\text{1.}" in told
    assert r"\text{2.}" in told


def test_expressions_that_are_zero_are_equations():
    assert latex(equations_that_are_zero([x - a], formula)) == "x - a = 0"
    assert latex(equations_that_are_zero([x - a, y], formula)).count("&= 0") == 2


def test_a_long_list_breaks_behind_its_commas():
    lines = broken(formula([LONG, b - LONG]))
    assert width(formula([LONG, LONG])) > LINE
    assert sum(latex(line).rstrip().endswith(",") for line in lines) == 1
