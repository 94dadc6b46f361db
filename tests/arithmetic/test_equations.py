"""Elimination as on paper: the values are those of numpy, and every line holds."""

import numpy as np
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from solver.arithmetic.equations import eliminated, system_solved
from solver.numeric import check_steps
from solver.render.wording import Wording

TUTOR = Wording(detail="tutor")
x, y, z = sp.symbols("x y z")
a, b = sp.symbols("a b")


def displayed(steps):
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


def failures(steps):
    return [check for check in check_steps(steps) if check.status != "passed"]


def test_the_lines_are_those_of_a_student():
    equations = [(x + z - 6, sp.S(3)), (11 - 6 * x + 2 * y - z, sp.S(7)), (6 * x - 3 * y - 6, sp.S(5))]
    values = [sp.Rational(-37, 3), sp.Rational(-85, 3), sp.Rational(64, 3)]
    shown = displayed(eliminated(equations, (x, y, z), values))
    for line in (
        r"(1):\quad z &= 9 - x",
        r"(2):\quad 11 - 6x + 2y - (9 - x) &= 7\; \Rightarrow\; 2y - 5x = 5",
        r"(3):\quad 6\left(\frac{2}{5}y - 1\right) - 3y - 6 &= 5\; \Rightarrow\; -\frac{3}{5}y = 17",
        r"z &= 9 - \left(-\frac{37}{3}\right) = \frac{64}{3}",
    ):
        assert line in shown


def test_equations_of_one_unknown_each_need_no_elimination():
    assert eliminated([(2 * x - 5, sp.S(1)), (y + 1, sp.S(3))], (x, y), [sp.S(3), sp.S(2)]) == ()


def test_an_unknown_that_is_read_off_is_not_told_twice():
    shown = displayed(eliminated([(x, sp.S(2)), (x + y, sp.S(5))], (x, y), [sp.S(2), sp.S(3)]))
    assert shown.count("y = 3") == 1
    assert "Equation (2) gives" not in shown


def test_a_divisor_with_symbols_must_not_be_zero():
    values = [(b**2 + 1) / (a * b + 1), (b - a) / (a * b + 1)]
    steps = eliminated([(a * x + y, b), (x - b * y, sp.S(1))], (x, y), values)
    assert r"Equation (2) gives $x$, where $ab + 1 \ne 0$:" in displayed(steps)
    assert not failures(steps)


def test_a_free_unknown_is_left_and_what_follows_is_zero():
    equations = [(x + y + z, sp.S(2)), (x - y, sp.S(1)), (2 * x + z, sp.S(3))]
    values = [sp.Rational(3, 2) - z / 2, sp.Rational(1, 2) - z / 2, z]
    steps = eliminated(equations, (x, y, z), values)
    assert not failures(steps)
    assert r"\Rightarrow\; 0 = 0" in displayed(steps)


def test_unknowns_on_both_sides_are_taken_to_one():
    steps = eliminated([(x + y, sp.S(3)), (2 * x, y)], (x, y), [sp.S(1), sp.S(2)])
    assert not failures(steps)
    assert r"(2):\quad 2(3 - y) - y &= 0\; \Rightarrow\; -3y = -6" in displayed(steps)


@given(
    st.lists(st.integers(-5, 5), min_size=16, max_size=16),
    st.lists(st.integers(-9, 9), min_size=4, max_size=4),
)
def test_every_line_holds_for_the_values_of_numpy_and_fails_for_others(entries, right):
    M = np.array(entries).reshape(4, 4)
    assume(abs(np.linalg.det(M)) > 0.5)
    unknowns = sp.symbols("v1:5")
    left = (sp.Matrix(4, 4, entries) * sp.Matrix(unknowns)).flat()
    equations = list(zip(left, map(sp.Integer, right), strict=True))
    values = [sp.Rational(float(value)).limit_denominator(20000) for value in np.linalg.solve(M, right)]
    steps = eliminated(equations, unknowns, values)
    assert not failures(steps)
    if steps and steps[0].values["back"]:
        last = steps[0].values["back"][-1][0]
        assert failures(
            eliminated(equations, unknowns, [v + int(u == last) for u, v in zip(unknowns, values, strict=True)])
        )


def test_a_matrix_equation_is_written_entry_by_entry_first():
    M, right = sp.Matrix([[1, 0], [2, 5]]), (3, 11)
    equations = list(zip((M * sp.Matrix([x, y])).flat(), map(sp.Integer, right), strict=True))
    steps = system_solved(equations, (x, y), [sp.S(3), sp.S(1)])
    assert [step.kind for step in steps] == ["system", "elimination"]
    assert r"2x + 5y &= 11" in displayed(steps)
    assert not failures(steps)
    assert failures(system_solved(equations, (x, y), [sp.S(3), sp.S(2)])[:1])
