"""Margins, responses and loci of discrete loops beside python-control's, on generated loops.

Where they differ: python-control's roots in doubles miss most gain margins at z = −1, the Nyquist frequency, where the
rounded value of L is not exactly real (that of 1/z² is found), and take a pole at z = 1 for a crossing of margin 0.
"""

from __future__ import annotations

import random

import numpy as np
import pytest
import sympy as sp

from solver import exact

control = pytest.importorskip("control")
z = sp.Symbol("z")
R = sp.Rational


def loops(count, seed):
    rng = random.Random(seed)  # noqa: S311 - the same loops each time
    found = []
    while len(found) < count:
        poles = [rng.choice([1, R(1, 2), R(9, 10), 0, -R(2, 5), R(5, 4), R(3, 4)]) for _ in range(rng.randint(1, 4))]
        zeros = [rng.choice([-R(19, 20), R(1, 3), -2, R(4, 5), 0]) for _ in range(rng.randint(0, len(poles) - 1))]
        if set(poles) & set(zeros):
            continue
        N = sp.expand(R(rng.randint(1, 60), 20) * sp.prod([z - q for q in zeros]))
        found.append((N, sp.expand(sp.prod([z - p for p in poles])), rng.choice([R(1, 10), R(1, 2), sp.Integer(1)])))
    return found


def transfer(N, D, T):
    return control.tf(*([float(c) for c in sp.Poly(p, z).all_coeffs()] for p in (N, D)), float(T))


@pytest.mark.parametrize(("N", "D", "T"), loops(40, 5))
def test_crossovers_and_their_margins(N, D, T):
    ours, system = exact.margins_of(exact.on_circle(N, D, z, T)), transfer(N, D, T)
    gains, phases, _, at_phase, at_gain, _ = control.stability_margins(system, method="poly", returnall=True)
    theirs = [(w, gain) for w, gain in zip(at_phase, gains, strict=True) if gain > 1e-6]
    last = np.pi / float(T)
    mine = [(float(each.omega), float(1 / each.magnitude)) for each in ours.phases.found]
    for pair in theirs:
        assert any(np.allclose(pair, each, rtol=1e-5, atol=1e-7) for each in mine), (mine, theirs)
    for w, gain in mine:
        known = w > last * (1 - 1e-9) and np.isclose(-1 / system(-1).real, gain)
        assert known or any(np.allclose((w, gain), each, rtol=1e-5, atol=1e-7) for each in theirs), (mine, theirs)
    mine = [(float(each.omega), float(exact.phase_margin_of(each.phase))) for each in ours.gains.found]
    assert len(mine) == len(at_gain)
    for (w, margin), omega, known in zip(mine, at_gain, phases, strict=True):
        assert np.isclose(w, omega, rtol=1e-5)
        assert abs((margin - known + 180) % 360 - 180) < 1e-3


@pytest.mark.parametrize(("N", "D", "T"), loops(20, 11))
def test_values(N, D, T):
    L, theirs = exact.on_circle(N, D, z, T), transfer(N, D, T)
    for part in (R(1, 30), R(1, 3), R(5, 7)):
        omega = sp.N(part * sp.pi / T, 30)
        size, angle, _ = control.frequency_response(theirs, [float(omega)])
        assert np.isclose(float(L.magnitude(omega)), np.squeeze(size), rtol=1e-9)
        assert abs((float(L.phase(omega)) - np.degrees(np.squeeze(angle)) + 180) % 360 - 180) < 1e-7


@pytest.mark.parametrize(("N", "D", "T"), loops(25, 17))
def test_critical_gains_are_where_branches_of_python_control_cross(N, D, T):
    equation = exact.locus_equation(N, D, z, discrete=True)
    for each in exact.crossings(equation):
        gain = float(each.gain)
        before, after = (
            np.abs(control.root_locus_map(transfer(N, D, T), gains=[gain * part]).loci[0]) for part in (0.999, 1.001)
        )
        at = control.root_locus_map(transfer(N, D, T), gains=[gain]).loci[0]
        assert np.min(np.abs(at - complex(each.point))) < 1e-5
        assert np.min(np.abs(before - 1)) < 0.1
        assert np.min(np.abs(after - 1)) < 0.1
    for each in exact.stable_gains(equation):
        gain = float(each.low) * 1.0001 + 1e-7 if each.high == sp.oo else float(each.low + each.high) / 2
        roots = np.abs(control.root_locus_map(transfer(N, D, T), gains=[gain]).loci[0])
        assert np.sum(roots > 1) == each.outside
