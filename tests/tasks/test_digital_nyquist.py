"""Nyquist's criterion for discrete loops: known counts, numpy's poles on generated loops, corruptions."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from solver import exact
from solver.derivation import Status
from tests.helpers.asking import ask, rejected
from tests.tasks.test_digital_margins import loop_of, plant

z = sp.Symbol("z")
R = sp.Rational


@pytest.mark.parametrize(
    ("loop", "counts", "crossings"),
    [
        ((z + 1, 8 * (z - 1) ** 2), (2, 0, 2), []),  # a double integrator behind a hold
        ((R(3, 2) * z - R(3, 8), z * (z - R(3, 2))), (-1, 1, 0), [-R(3, 4)]),  # made stable by the loop
        ((-1, 4 * (z + 1) * (z - R(1, 2))), (1, 0, 1), [R(1, 6)]),  # a pole at −1: a half turn at infinity
        ((R(3, 2), z**2), (2, 0, 2), [-R(3, 2), R(3, 2)]),  # a delay of two periods
        ((R(1, 4), z - R(1, 2)), (0, 0, 0), [-R(1, 6)]),
    ],
)
def test_turns_and_crossings_known_in_other_ways(loop, counts, crossings):
    result = ask("nyquist", plant(*loop))
    assert result.status is Status.VERIFIED
    answers = result.answers
    names = ("encirclements", "open_loop_unstable_poles", "closed_loop_unstable_poles")
    assert tuple(answers[name] for name in names) == counts
    assert answers["real_axis_crossings"] == crossings
    assert answers["stable"] is (counts[2] == 0)


def test_a_curve_through_minus_one_is_told():
    result = ask("nyquist", plant(1, z**2))
    assert result.status is Status.UNSOLVED
    assert "unit circle" in str(result.reason)


factors = st.sampled_from(
    [z - 1, z + 1, z, z - R(1, 2), z + R(3, 2), z - R(9, 10), z**2 + 1, z**2 - z + 1, z**2 - 2 * z + 2]
)
above = st.sampled_from([sp.Integer(1), z - R(1, 3), z + R(9, 10), z + 2, z**2 + z + 2])
gains = st.sampled_from([R(1, 10), R(7, 20), R(13, 10), R(29, 10), -R(3, 5)])


@settings(max_examples=60, deadline=None)
@given(above, st.lists(factors, min_size=1, max_size=4).map(sp.prod), gains)
def test_the_count_of_crossings_is_that_of_the_poles(numerator, denominator, gain):
    N, D = sp.expand(gain * numerator), sp.expand(denominator)
    assume(sp.degree(N, z) < sp.degree(D, z))
    found = exact.encirclements(N, D, z, sample_time=sp.Integer(1))
    sizes = [np.abs(np.roots([float(c) for c in sp.Poly(p, z).all_coeffs()])) for p in (D, N + D)]
    assume(not any(1e-4 < abs(size - 1) < 2e-3 for each in sizes for size in each))  # doubles do not tell
    if not found.through:
        assert found.open_loop == sum(sizes[0] > 1 + 1e-3)
        assert found.closed_loop == sum(sizes[1] > 1 + 1e-3)
        assert found.clockwise == found.closed_loop - found.open_loop


@settings(max_examples=6, deadline=None)
@given(above, st.lists(factors, min_size=1, max_size=3).map(sp.prod), gains)
def test_generated_curves_are_verified(numerator, denominator, gain):
    assume(sp.degree(numerator, z) < sp.degree(sp.expand(denominator), z))
    assert ask("nyquist", plant(gain * numerator, denominator)).status in (Status.VERIFIED, Status.UNSOLVED)


LOOP = (R(3, 2) * z - R(3, 8), z * (z - R(3, 2)))


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        ("encirclements", sp.Integer(1)),
        ("encirclements", sp.Integer(0)),
        ("open_loop_unstable_poles", sp.Integer(0)),
        ("closed_loop_unstable_poles", sp.Integer(1)),
        ("stable", False),
        ("real_axis_crossings", []),
        ("real_axis_crossings", [-R(3, 4), -R(9, 4)]),  # that of ω = 0 is an end
    ],
)
def test_corrupted_answers_are_rejected(name, wrong):
    assert not rejected("nyquist", loop_of(*LOOP), {name: ask("nyquist", plant(*LOOP)).answers[name]})
    assert rejected("nyquist", loop_of(*LOOP), {name: wrong})
