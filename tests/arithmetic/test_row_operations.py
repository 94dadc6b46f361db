"""Row operations by pivots, and vectors of a null space with their scale."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver import exact
from solver.arithmetic.row_operations import null_vectors, row_operations
from solver.numeric import check_steps
from solver.render.wording import Wording

TUTOR = Wording(detail="tutor")
X = sp.symbols("x_1:5")


def displayed(steps):
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


def matrix(*rows):
    return sp.ImmutableMatrix(rows)


def lines(M):
    return row_operations(M, exact.row_reduction(M))


@pytest.mark.parametrize(
    ("M", "said"),
    [
        (matrix([0, 1], [3, 4]), "Pivot in row 1, column 1 (rows are exchanged, since the entry there is zero). With"),
        (matrix([3, 4], [1, 5]), "(rows are exchanged for a pivot $1$ or $-1$, which makes no fractions). With"),
        (matrix([1, 4], [2, 5]), r"Pivot in row 1, column 1. With $R_{2} \leftarrow R_{2} - 2R_{1}$:"),
    ],
)
def test_the_pivot_is_named_and_why_rows_are_exchanged(M, said):
    assert said in displayed(lines(M))


@given(st.lists(st.integers(-3, 3), min_size=12, max_size=12).map(lambda e: sp.ImmutableMatrix(3, 4, e)))
def test_what_is_done_for_a_pivot_clears_its_column_and_is_shown_once(M):
    reduction = exact.row_reduction(M)
    shown = [each for step in row_operations(M, reduction) for each in step.values["stages"]]
    assert len(shown) <= len(reduction.pivots)
    for stage in shown:
        column = stage.after[:, stage.column]
        assert list(column) == [int(i == stage.row) for i in range(3)]
    if shown:
        assert shown[-1].after == M.rref()[0]
    operations = [operation for stage in shown for operation in stage.operations]
    assert operations == list(reduction.operations)


def test_a_reduced_matrix_needs_no_operations():
    assert lines(matrix([1, 0, 2], [0, 1, 3])) == ()


def test_the_unknowns_are_told_by_the_free_one_and_the_scale_by_its_reason():
    M = matrix([2, 1, 0], [0, 3, 1])
    steps = null_vectors(exact.row_reduction(M), [matrix([1], [-2], [6])])
    shown = displayed(steps)
    assert r"x_1 &= \frac{1}{6}x_3" in shown
    assert r"With $x_3 = 1$ and all entries times $6$, which clears the fractions, this is" in shown
    assert all(check.status == "passed" for check in check_steps(steps))
    wrong = null_vectors(exact.row_reduction(M), [matrix([1], [2], [6])])
    assert any(check.status == "failed" for check in check_steps(wrong))


def test_several_free_unknowns_are_taken_in_turn():
    M = matrix([1, 2, 3])
    vectors = [matrix([-2], [1], [0]), matrix([3], [0], [-1])]
    shown = displayed(null_vectors(exact.row_reduction(M), vectors))
    assert "With $x_2 = 1$ and the other free unknown zero this is the vector number 1 above." in shown
    assert "times $-1$, which changes all signs" in shown
    assert all(np.allclose(np.array(M, dtype=float) @ np.array(v, dtype=float), 0) for v in vectors)
