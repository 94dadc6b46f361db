"""Matrices as programs print them, told by the rows that they have."""

import pytest

from solver.classroom.reading.printed import in_rows

TWO = "[0, 1; -2, -3]"


@pytest.mark.parametrize(
    "text",
    [
        "⎡0   1 ⎤\n⎢      ⎥\n⎣-2  -3⎦",
        "⎡0   1 ⎤ ⎣-2  -3⎦",
        "│ 0 1 │\n│ -2 -3 │",
        "| 0 1 |\n| -2 -3 |",
        "| 0 | 1 |\n|---|---|\n| -2 | -3 |",
        "|0 1; -2 -3|",
        "     [,1] [,2]\n[1,]    0    1\n[2,]   -2   -3",
        "[,1] [,2] [1,] 0 1 [2,] -2 -3",
        "2×2 Matrix{Float64}:\n 0 1\n -2 -3",
        "2x2 Array{Float64,2}: 0 1 -2 -3",
        "row 1: 0 1\nrow 2: -2 -3",
        "Zeile 1: (0, 1), Zeile 2: (-2, -3)",
        "1st row: 0, 1; 2nd row: -2, -3",
        "0;1\n-2;-3",
        "0 1 -2 -3",
        "0, 1, -2, -3",
        "(0 1 | -2 -3)",
        "julia> A\n2×2 Matrix{Int64}:\n 0 1\n -2 -3",
    ],
)
def test_rows_of_a_matrix(text):
    assert in_rows(text, (2, 2)) == TWO


@pytest.mark.parametrize(
    ("text", "shape", "rows"),
    [
        ("[1] 14 4", (1, 2), "[14, 4]"),
        ("2-element Vector{Float64}:\n 14.0\n 4.0", (1, 2), "[14.0; 4.0]"),
        ("⎡-3⎤\n⎣ 2⎦", (2, 1), "[-3; 2]"),
        ("⎡- 2  1⎤\n⎣0    3⎦", (2, 2), "[- 2, 1; 0, 3]"),
        ("column 1: [0; -2], column 2: [1; -3]", (2, 2), "[0, -2; 1, -3]'"),
        ("K = ⎡14  4⎤", (1, 2), "K = [14, 4]"),
        (">> K", (1, 2), "K"),
    ],
)
def test_other_shapes(text, shape, rows):
    assert in_rows(text, shape) == rows if rows != "K" else in_rows(text, shape).strip() == "K"


@pytest.mark.parametrize(
    ("text", "shape"),
    [
        ("0 1 -2", (2, 2)),
        ("[0 1 -2 -3]", (2, 2)),
        ("2×3 Matrix{Float64}: 0 1 -2 -3 4 5", (2, 2)),
        ("⎡-2⋅t   ⎤\n⎢ℯ     0⎥\n⎣0     1⎦", (2, 2)),
        ("row 1: 0 1, column 2: 3 4", (2, 2)),
        ("|K - 3|", (1, 2)),
        ("A = 3", (2, 2)),
    ],
)
def test_what_has_no_such_rows_is_left(text, shape):
    assert in_rows(text, shape) == ""
