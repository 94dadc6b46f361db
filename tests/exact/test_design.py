"""Set points by their equations and the pseudoinverse, targets by their transfer functions, integrators by blocks."""

import numpy as np
import pytest
import sympy as sp

from solver import exact
from tests.helpers.exact_cases import floats

M = sp.ImmutableMatrix
s, a = sp.Symbol("s"), sp.Symbol("a", real=True)
half = sp.Rational(1, 2)

PLANTS = [
    (M([[0, 1], [-2, -3]]), M([0, 1]), M([[1, 0]]), M([[0]])),
    (M([[0, 1], [-2, -3]]), M([0, 1]), M([[1, 1]]), M([[2]])),
    (M([[half, 1], [0, 2]]), M([[1, 0], [1, 2]]), M([[1, 3], [0, 1]]), M([[0, 1], [0, 0]])),
    (M([[0, 1, 0], [0, 0, 1], [-1, 2, 3]]), M([[1, 0], [0, 1], [1, 1]]), M([[1, 0, 2]]), M([[0, 0]])),
    (M([[0, 1], [0, -1]]), M([[0, 0], [1, 1]]), M([[1, 0]]), M([[0, 0]])),
]


@pytest.mark.parametrize("discrete", [False, True])
@pytest.mark.parametrize("plant", PLANTS)
def test_a_set_point_holds_and_is_the_least_one(plant, discrete):
    A, B, C, D = plant
    found = exact.set_point(A, B, C, D, discrete=discrete)
    n, p = A.rows, C.rows
    assert (found.F if discrete else sp.zeros(n, p)) == A * found.F + B * found.N
    assert sp.eye(p) == C * found.F + D * found.N
    rest = A - sp.eye(n) if discrete else A
    whole = np.vstack([np.hstack([floats(rest), floats(B)]), np.hstack([floats(C), floats(D)])])
    least = np.linalg.pinv(whole) @ np.vstack([np.zeros((n, p)), np.eye(p)])
    assert np.allclose(np.array(found.stacked, dtype=float), least)
    assert np.allclose(np.array(found.matrix, dtype=float), whole)
    assert found.rank == np.linalg.matrix_rank(whole)
    assert found.unique == (found.rank == whole.shape[1])
    assert found.right == M(sp.zeros(n, p).col_join(sp.eye(p)))


def test_a_zero_at_the_origin_holds_no_set_point():
    with pytest.raises(exact.NoSetPoint) as refused:
        exact.set_point(M([[0, 1], [-2, -3]]), M([0, 1]), M([[0, 1]]), M([[0]]))
    assert refused.value.rank == 2


def test_parameters_at_which_there_is_none_are_named():
    A, B = M([[0, 1], [-2, -3]]), M([0, 1])
    assert exact.set_point(A, B, M([[a - 1, 1]]), M([[0]])).exceptions == (sp.Eq(a - 1, 0),)
    assert exact.set_point(A, B, M([[1, a]]), M([[0]])).exceptions == ()


@pytest.mark.parametrize("discrete", [False, True])
def test_a_plant_with_integrators_sums_up_the_error(discrete):
    A, B, C, D = M([[1, 2], [3, 4]]), M([5, 6]), M([[7, 8]]), M([[9]])
    augmented, inputs = exact.with_integrators(A, B, C, D, discrete=discrete)
    assert augmented == M([[1, 2, 0], [3, 4, 0], [-7, -8, int(discrete)]])
    assert inputs == M([5, 6, -9])
    assert exact.at_rest(A, discrete=discrete) == (M([[0, 2], [3, 3]]) if discrete else A)


@pytest.mark.parametrize(
    ("plant", "target", "missing", "hidden", "desired", "degrees"),
    [
        (1 / (s * (s + 1)), 1 / ((s + 1) * (s + 4)), 1, 1, (1, 5, 4), (2, 2)),
        ((s + 2) / (s**3 + 1), 3 / ((s + 1) * (s + 4)), 1, s + 2, (1, 7, 14, 8), (2, 2)),
        (2 * (s + 2) * (s + 3) / (s**3 + 1), (s + 2) / (s**2 + 1), 1, s + 3, (1, 3, 1, 3), (1, 1)),
        ((s + 2) / (s**3 + 1), (s + 5) / (s**3 + 1), s + 5, s + 2, None, (2, 2)),
        ((s + 2) / (s**3 + 1), 1 / (s + 1), 1, s + 2, None, (2, 1)),
    ],
)
def test_a_target_needs_the_zeros_and_relative_degree_of_the_plant(plant, target, missing, hidden, desired, degrees):
    top, bottom = sp.fraction(plant)
    found = exact.matching(top, bottom, target, s)
    assert (found.missing, sp.expand(found.hidden - hidden)) == (missing, 0)
    assert found.desired == desired
    assert found.possible == (desired is not None)
    assert found.relative_degrees == degrees
    assert found.order == sp.degree(bottom, s)
    assert sp.cancel(found.compensator - target / plant) == 0
    assert sp.cancel(found.numerator / found.denominator - plant) == 0
    assert sp.cancel(found.target_numerator / found.target_denominator - target) == 0
    assert list(found.hidden_zeros) == ([-3] if hidden == s + 3 else [-2] if hidden == s + 2 else [])
    if desired:
        closed = found.gain * top / sp.LC(bottom, s) / sp.Poly(desired, s).as_expr()
        assert sp.cancel(closed - target) == 0


@pytest.mark.parametrize("plant", [(2 * s**2 + 3) / (4 * s**2 + 8 * s + 1), (s + a) / (s**3 + a * s), 5 / (s + 2)])
def test_the_descending_form_has_the_transfer_function(plant):
    A, B, C, D = exact.descending_form(*sp.fraction(sp.together(plant)), s)
    n = A.rows
    assert sp.cancel((C * (s * sp.eye(n) - A).inv() * B + D)[0] - plant) == 0
    assert A[1:, :] == sp.eye(n)[: n - 1, :]
    assert sp.Matrix(sp.eye(n)[:, 0]) == B
