"""Margins, responses and turns beside python-control's, on generated loops: types 0 to 3, unstable, non-minimum phase.

Where they differ: python-control leaves out crossovers that are multiple roots of its polynomials or lie beside poles
on the axis by rounding, counts a crossover at ω = 0 as we do, and calls a loop L = K/s² without a gain margin, whose
curve lies on the negative real axis; such loops are not generated. Its Nyquist count is taken with its own indentation.
"""

from __future__ import annotations

import random
import warnings

import numpy as np
import pytest
import sympy as sp

from solver import exact

control = pytest.importorskip("control")
s = sp.Symbol("s")


def loops(count, seed):
    rng = random.Random(seed)  # noqa: S311 - the same loops each time
    found = []
    while len(found) < count:
        kind = rng.randint(0, 3)
        poles = [rng.choice([1, 2, 3, 5, 8, -1, -2]) for _ in range(rng.randint(1, 3))]
        zeros = [rng.choice([1, 2, 4, 6, -3]) for _ in range(rng.randint(0, min(2, len(poles) + kind - 1)))]
        if set(poles) & set(zeros):
            continue
        N = sp.expand(rng.randint(1, 40) * sp.prod(s + z for z in zeros))
        D = sp.expand(s**kind * sp.prod(s + p for p in poles))
        if kind % 2 == 0 and not exact.on_axis(N, D, s).parts.imaginary.degree() >= 0:
            continue
        found.append((N, D))
    return found


def transfer(N, D):
    return control.tf(*([float(c) for c in sp.Poly(p, s).all_coeffs()] for p in (N, D)))


@pytest.mark.parametrize(("N", "D"), loops(40, 7))
def test_margins(N, D):
    L = exact.on_axis(N, D, s)
    if L.parts.imaginary.is_zero:
        pytest.skip("real on the whole axis")
    ours = exact.margins_of(L)
    gm, pm, wpc, wgc = control.margin(transfer(N, D))
    if abs(float(ours.gain_margin) - 1) < 1e-6:
        return  # on the edge of stability the rounding of doubles decides
    for mine, theirs in ((ours.gain_margin, gm), (ours.phase_crossover, wpc), (ours.gain_crossover, wgc)):
        known = np.inf if theirs is None or np.isnan(theirs) else theirs
        assert np.isclose(float(mine), known, rtol=1e-5), (ours.gain_margin, gm, wpc, wgc)
    if ours.at_gain is not None:
        assert abs((float(ours.phase_margin) - pm + 180) % 360 - 180) < 1e-4


@pytest.mark.parametrize(("N", "D"), loops(20, 11))
def test_values(N, D):
    L, theirs = exact.on_axis(N, D, s), transfer(N, D)
    for omega in (sp.Rational(1, 3), sp.Integer(2), sp.Integer(17)):
        value = complex(theirs(1j * float(omega)))
        assert np.isclose(float(L.magnitude(omega)), abs(value), rtol=1e-9)
        assert abs((float(L.phase(omega)) - np.angle(value, deg=True) + 180) % 360 - 180) < 1e-7


@pytest.mark.parametrize(("N", "D"), loops(25, 13))
def test_turns(N, D):
    ours = exact.encirclements(N, D, s)
    if ours.through or ours.on_axis:
        return
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = control.nyquist_response(transfer(N, D), indent_radius=1e-3)
    assert ours.closed_loop == int((np.real(control.feedback(transfer(N, D)).poles()) > 1e-9).sum())
    if found.count is not None and sp.degree(N, s) < sp.degree(D, s):
        assert ours.clockwise == found.count
