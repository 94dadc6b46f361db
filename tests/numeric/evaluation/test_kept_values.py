"""Values that one derivation leaves for the next: the same as those found anew, and not without end."""

import numpy as np
import pytest
import sympy as sp

from solver.numeric.evaluation import environment
from solver.numeric.evaluation.arithmetic import DOUBLE, multiple
from solver.numeric.evaluation.environment import Environments
from solver.numeric.evaluation.expressions import value_of
from solver.stated.algebra import product, total
from solver.stated.matrices import inverse

s = sp.Symbol("s")
POINTS = [{s: 0.7 + 0.4j}, {s: -1.3 + 0.2j}]
M = sp.ImmutableMatrix([[s, 1], [2, s + 3]])


@pytest.mark.parametrize("arithmetic", [DOUBLE, multiple(30)])
def test_the_next_derivation_finds_what_the_one_before_left(arithmetic):
    formula = total(inverse(M), product(s, M))
    first = value_of(formula, Environments().at(POINTS[:1], arithmetic))
    kept = Environments().at(POINTS[:1], arithmetic)
    assert kept.memo[formula].value is first.value
    environment._kept.cache_clear()
    anew = value_of(formula, Environments().at(POINTS[:1], arithmetic))
    assert np.array_equal(anew.value, first.value)
    assert np.array_equal(anew.magnitude, first.magnitude)


def test_a_matrix_that_changes_is_evaluated_again():
    changing = M.as_mutable()
    here = Environments().at(POINTS, DOUBLE)
    before = value_of(inverse(changing), here).value
    changing[0, 0] = 5
    assert not np.allclose(value_of(inverse(changing), here).value, before)


def test_a_float_is_not_taken_for_a_decimal_of_few_digits():
    here = Environments().at(POINTS[:1], multiple(50))
    few = value_of(product(sp.Float("0.5", 15), s), here)
    exact = value_of(product(0.5, s), here)
    assert np.ravel(few.magnitude)[0] > 1e10 * np.ravel(exact.magnitude)[0]


def test_an_environment_that_holds_much_begins_anew():
    environment._kept.cache_clear()
    here = Environments().at(POINTS, DOUBLE)
    value_of([s + i for i in range(1, environment.MOST_KEPT + 2)], here)
    assert len(here.memo) > environment.MOST_KEPT
    assert not Environments().at(POINTS, DOUBLE).memo
