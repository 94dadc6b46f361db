"""Lines in arrays."""

import pytest

from solver.formula import MathProblem, read


@pytest.mark.parametrize(
    "formula",
    [
        r"\hline",
        r"\begin{bmatrix}\hline 1 & 2\end{bmatrix}",
        r"\begin{array}{cc}1 & \hline 2\end{array}",
        r"\begin{array}{cc}1 & 2 \hline 3 & 4\end{array}",
    ],
)
def test_a_line_stands_only_at_the_start_of_a_row_of_an_array(formula):
    with pytest.raises(MathProblem, match="hline"):
        read(formula)
