"""Sums of powers: bounds, the sign they keep, and what samples of step responses show."""

import mpmath
import numpy as np
import pytest
import sympy as sp

from solver import exact
from solver.exact.classical.power_sums import PowerSum
from solver.exact.linear_algebra.fields import NotExact
from solver.systems import StateSpace


def of(*modes):
    with mpmath.workdps(45):
        return PowerSum(tuple((exactly(p), order, mpmath.mpc(c)) for p, order, c in modes))


def exactly(p):
    """A pole with as many digits as poles have there."""
    p = complex(p)
    return mpmath.mpc(mpmath.mpf(str(p.real)), mpmath.mpf(str(p.imag)))


def test_values_bounds_and_the_sample_from_which_they_hold():
    f = of((0.5, 1, 3), (0.9, 2, -1), (0, 2, 7))
    k = np.arange(40)
    wanted = 3 * 0.5**k - k * 0.9 ** (k - 1.0) + 7 * (k == 1)
    assert np.allclose(f.rough(40), wanted)
    assert np.allclose([float(f.value(int(i))) for i in k], wanted)
    assert all(abs(wanted) <= f.bounds(k) + 1e-12)
    within = f.within(0.02)
    assert f.bounds(np.array([within]))[0] < 0.02 <= f.bounds(np.array([within - 1]))[0]
    assert all(np.diff(f.bounds(np.arange(within, within + 50))) < 0)


@pytest.mark.parametrize(
    ("modes", "kept"),
    [
        ([(0.5, 1, -1)], True),
        ([(0.5, 1, 1)], False),
        ([(-0.5, 1, -1)], False),
        ([(0.5, 1, -2), (-0.5, 1, 1)], True),
        ([(0.5, 1, -1), (-0.5, 1, 2)], False),
        ([(0.4 + 0.3j, 1, 1), (0.4 - 0.3j, 1, 1)], False),
        ([(0.5, 1, -3), (0.3 + 0.4j, 1, 1), (0.3 - 0.4j, 1, 1)], True),
        ([(0.9, 1, -1), (0.5, 1, 100)], True),
        ([(0.5, 2, -1), (0.5, 1, 50)], True),
        ([(0, 1, 5)], True),
    ],
)
def test_whether_it_stays_negative(modes, kept):
    f = of(*modes)
    found = f.negative_from()
    assert (found is not None) == kept
    if kept:
        assert all(f.rough(found + 200)[found:] <= 0)


def test_where_the_slowest_modes_cancel_the_others_decide():
    """The roots of z³ = 1/8, all of one size: the values over a period are 0, 0 and −3."""
    with mpmath.workdps(45):
        roots = [mpmath.mpf(1) / 2 * mpmath.expjpi(mpmath.mpf(2 * i) / 3) for i in range(3)]
        alone = PowerSum(tuple((p, 1, mpmath.mpc(-1)) for p in roots))
        found = alone.negative_from()
        assert found is not None
        assert all(alone.rough(found + 60)[found:] <= 1e-12)
        with pytest.raises(NotExact):
            PowerSum((*alone.modes, (mpmath.mpf(1) / 4, 1, mpmath.mpc(1)))).negative_from()


def response(A, B, C, D):
    M = [sp.ImmutableMatrix(each) for each in (A, B, C, D)]
    plant = StateSpace(*M, None, discrete=True)
    return exact.response(plant, None, (sp.Integer(1),), sp.Symbol("k"))


def test_events_of_a_response():
    found = exact.sampled_events(response([["1/2"]], [1], [["1/2"]], [[0]]), sp.Rational(1, 50), whole=True)
    assert (found.final, found.peak, found.reached) == (1, None, False)
    assert (found.rise.begins, found.rise.ends, found.settling, found.outside.time) == (1, 4, 6, 5)
    assert found.samples[:4] == (0, sp.Rational(1, 2), sp.Rational(3, 4), sp.Rational(7, 8))


def test_an_edge_that_is_met_exactly_is_inside():
    """Deviations of (1/2)^k: with a band of 1/8 the sample that is exactly there counts as settled."""
    found = exact.sampled_events(response([["1/2"]], [1], [["1/2"]], [[0]]), sp.Rational(1, 8), whole=False)
    assert found.settling == 3


def test_the_largest_difference_is_found_wherever_it_comes():
    late = exact.largest_sampled_error(response([["9/10"]], [1], [["1/10"]], [[0]]))
    assert late.time is sp.oo
    assert float(late.value) == 1
    early = exact.largest_sampled_error(response([["-1/2"]], [1], [[1]], [[0]]))
    assert (early.time, float(early.value)) == (1, 1)
