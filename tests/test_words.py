"""Values within messages: spelled as the pages spell them."""

import pytest
import sympy as sp

from solver.words import formula

k = sp.Symbol("k")


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (-1 + 2 * sp.I, "-1 + 2 j"),
        (sp.Float("-1.32471795724474602596090885447809", 30), "-1.3247"),
        (sp.Rational(1, 3) * k, r"\frac{k}{3}"),
        (sp.ImmutableMatrix([[1, k]]), r"\begin{bmatrix}1 & k\end{bmatrix}"),
        (sp.log(k), r"\ln{\left(k \right)}"),
        (sp.Symbol("x1_dot") + sp.Symbol("y_d4"), r"\dot{x_{1}} + {y}^{(4)}"),
    ],
    ids=str,
)
def test_a_value_in_a_message_is_spelled_as_on_a_page(value, shown):
    assert formula(value) == shown
