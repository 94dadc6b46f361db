"""Formulas put together: brackets as high as what stands in them."""

import pytest

from solver.formula import read
from solver.formula.building import parenthesized


@pytest.mark.parametrize(
    ("latex", "tall"),
    [
        ("a + b", False),
        (r"\frac{a}{b} + 1", True),
        (r"\begin{bmatrix}1\end{bmatrix}", True),
        (r"\left( a \right) + 1", True),
        ("(a + b) c", False),
        (r"\sum_{i} a", True),
    ],
)
def test_brackets_are_tall_around_what_is_tall(latex, tall):
    assert parenthesized(read(latex)).tall is tall
