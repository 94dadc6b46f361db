"""The problems are verified with python-flint, too: the numbers, polynomials and matrices of sympy are then flint's.

CI installs it for this after all other tests. Here a share is in turn, of the examples, which ask every task, a half.
"""

import pytest

import tests.test_problems as problems
from tests.helpers.shares import in_turn
from tests.helpers.solved import EXAMPLES, PROBLEMS, by_problem

pytest.importorskip("flint", reason="python-flint is not installed")

IN_TURN = [path for path in PROBLEMS if in_turn(path.stem, 2 if path in EXAMPLES else 4)]


@pytest.mark.parametrize(**by_problem(IN_TURN))
def test_a_problem_is_verified_with_flint(path):
    problems.test_the_problem_is_verified(path)
