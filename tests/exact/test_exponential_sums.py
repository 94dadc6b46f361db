"""Zeros of sums of decaying exponentials: none lost, none twice, touching ones told, against known zeros."""

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.exact.classical.exponential_sums import ExponentialSum, first_zero, settled_sign, zeros
from tests.helpers.tried import tried


def of(*terms):
    """c tᵏ e^{λt}, real ones."""
    return ExponentialSum(tuple((mpmath.mpc(m), k, mpmath.mpc(c)) for m, k, c in terms))


def test_a_damped_oscillation_has_a_zero_each_half_turn():
    """e^{−t} sin 5t."""
    f = of((mpmath.mpc(-1, 5), 0, mpmath.mpc(0, -1)))
    found = [float(zero.time) for zero in zeros(f, 0.0, 4.0)]
    assert np.allclose(found, np.pi / 5 * np.arange(1, 7), rtol=1e-14)
    backwards = [float(zero.time) for zero in zeros(f, 0.0, 4.0, last=True)]
    assert backwards == found[::-1]
    assert float(first_zero(f).time) == pytest.approx(np.pi / 5, rel=1e-14)
    assert settled_sign(f) is None


def test_a_double_zero_touches():
    """e^{−t}(t − 1)² is zero at 1, and does not change its sign."""
    f = of((-1, 2, 1), (-1, 1, -2), (-1, 0, 1))
    (zero,) = zeros(f, 0.0, 5.0)
    assert zero.touching
    assert float(zero.time) == pytest.approx(1, abs=1e-9)


def test_a_zero_at_the_start_does_not_count():
    """t e^{−t}, and e^{−t} − e^{−2t}."""
    assert not list(zeros(of((-1, 1, 1)), 0.0, 30.0))
    assert first_zero(of((-1, 0, 1), (-2, 0, -1))) is None


@tried(40)
@given(st.lists(st.integers(1, 12), min_size=1, max_size=3, unique=True), st.integers(1, 3))
def test_polynomials_in_an_exponential(places, rate):
    """Π(e^{−rt} − e^{−r a}) has its zeros at the places a/4."""
    coefficients = np.poly([mpmath.exp(-mpmath.mpf(rate * a) / 4) for a in places])
    n = len(places)
    with mpmath.workdps(45):
        exact = [mpmath.mpf(1)]
        for a in places:
            root = mpmath.exp(-mpmath.mpf(rate * a) / 4)
            exact = [x - root * y for x, y in zip([*exact, 0], [0, *exact], strict=True)]
        f = of(*((-rate * (n - i), 0, c) for i, c in enumerate(exact)))
    assert len(coefficients) == n + 1
    found = [float(zero.time) for zero in zeros(f, 0.0, 4.0)]
    assert np.allclose(found, np.sort(places) / 4, rtol=1e-12)
