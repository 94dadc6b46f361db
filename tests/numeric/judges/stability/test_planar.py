"""Phase portraits with parameters, against the plane of trace and determinant of the textbooks."""

import pytest
import sympy as sp

from solver.numeric import NotEvaluable
from solver.numeric.judges.stability import kinds_and_exceptions

a, b = sp.symbols("a b", real=True)
FOCI, NODES = {"stable focus", "unstable focus"}, {"stable node", "unstable node"}
DEGENERATE = {"stable degenerate node", "unstable degenerate node"}


@pytest.mark.parametrize(
    ("rows", "kinds"),
    [
        # χ = λ² + 2λ + a: determinant a, discriminant 4 − 4a
        (
            [[0, 1], [-a, -2]],
            {"saddle", "line of equilibria", "stable node", "stable degenerate node", "stable focus"},
        ),
        # χ = λ² + aλ + 1: trace −a, discriminant a² − 4
        ([[0, 1], [-1, -a]], {"center", *FOCI, *NODES, *DEGENERATE}),
        # χ = λ² + (2a + 1)λ + 2: the discriminant 4a² + 4a − 7 has irrational zeros
        ([[0, 1], [-2, -2 * a - 1]], {"center", *FOCI, *NODES, *DEGENERATE}),
        # χ = λ² + a: no trace
        ([[0, 1], [-a, 0]], {"center", "saddle", "shear"}),
        # a double eigenvalue: a chain unless a = 3
        ([[-1, a - 3], [0, -1]], {"stable degenerate node", "stable star"}),
        ([[2, 0], [2 * a - 1, 2]], {"unstable degenerate node", "unstable star"}),
        ([[0, 0], [5 * a, 0]], {"shear", "all points are equilibria"}),
        # trace 1/a, discriminant 1/a² − 4, nothing at a = 0
        ([[1 / a, 1], [-1, 0]], {*FOCI, *NODES, *DEGENERATE}),
        # eigenvalues 1/a − 2 ± j: the trace is zero at a = 1/2
        ([[1 / a - 2, 1], [-1, 1 / a - 2]], {"center", *FOCI}),
        # trace a + b, determinant ab + 1, discriminant (a − b)² − 4
        ([[a, -1], [1, b]], {"center", "saddle", "line of equilibria", *FOCI, *NODES, *DEGENERATE}),
        # diagonal: trace a + b, determinant ab, discriminant (a − b)²
        ([[a, 0], [0, b]], {"saddle", "line of equilibria", *NODES, "stable star", "unstable star"}),
    ],
)
def test_all_kinds_are_found_and_no_others(rows, kinds):
    assert kinds_and_exceptions(sp.ImmutableMatrix(rows)) == (kinds, set())


@pytest.mark.parametrize(
    ("rows", "exceptions", "general", "special"),
    [
        (
            [[0, 1], [-a, -2]],
            [a <= 0, sp.Eq(a, 1)],
            {"stable node", "stable focus"},
            {"saddle", "line of equilibria", "stable degenerate node"},
        ),
        ([[-1, a], [0, -1]], [sp.Eq(a, 0)], {"stable degenerate node"}, {"stable star"}),
        # the discriminant a² − 4/a is zero at the cube root of four, here given in decimals
        (
            [[0, 1], [-1 / a, -a]],
            [a <= 0, a >= sp.N(sp.cbrt(4), 30)],
            {"stable focus"},
            {"saddle", "stable node"},
        ),
        ([[a, -1], [1, a]], [sp.Not(a < 0)], {"stable focus"}, {"unstable focus", "center"}),
        ([[-1, 0], [0, -2]], [sp.true], set(), {"stable node"}),
        ([[-1, 0], [0, -2]], [sp.false], {"stable node"}, set()),
        ([[-1, 0], [0, -2]], [False], {"stable node"}, set()),
    ],
)
def test_the_kinds_where_an_exception_holds_are_told_apart(rows, exceptions, general, special):
    assert kinds_and_exceptions(sp.ImmutableMatrix(rows), exceptions) == (general, special)


def test_where_nothing_is_defined_there_is_no_kind():
    with pytest.raises(NotEvaluable, match="no values of the parameters"):
        kinds_and_exceptions(sp.ImmutableMatrix([[a / (a - b).subs(b, a), 0], [0, 1]]))
