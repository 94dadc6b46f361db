"""Answers in the form a person would write: what cancels is cancelled, and what has a name is called by it."""

import pytest
import sympy as sp

from solver.exact import power, second_order
from solver.exact.linear_algebra.fields import collected
from solver.exact.linear_algebra.radicals import LARGEST_MULTIPLE, multiple_angles
from tests.helpers.asking import ask, system

w, phi = sp.symbols("w phi", real=True)
k, t = sp.symbols("k t")
rho, m = sp.symbols("rho m", positive=True)
a, d = sp.symbols("a d")


@pytest.mark.parametrize("angle", [w, -w, 2 * w, w + phi, sp.Rational(1, 3) * w])
@pytest.mark.parametrize("radius", [1, rho, 2, 3 * rho])
def test_powers_of_a_rotation_turn_by_a_multiple_of_the_angle(angle, radius):
    c, s = radius * sp.cos(angle), radius * sp.sin(angle)
    found = power(sp.ImmutableMatrix([[c, s], [-s, c]]), k).matrix
    expected = radius**k * sp.Matrix([[sp.cos(k * angle), sp.sin(k * angle)], [-sp.sin(k * angle), sp.cos(k * angle)]])
    assert not found.has(sp.atan2, sp.acos)
    gap = (found - expected).subs({k: 3, w: sp.Rational(7, 10), phi: sp.Rational(2, 5), rho: sp.Rational(13, 10)})
    assert max(map(abs, gap.evalf(20))) < 1e-15


def test_an_oscillation_of_samples_has_sines_of_its_angle_below_the_line():
    found = power(sp.ImmutableMatrix([[0, 1], [-1, 2 * sp.cos(w)]]), k).matrix
    assert found[0, 1] == sp.sin(k * w) / sp.sin(w)


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (sp.sin(w) / (1 - sp.cos(w) ** 2), 1 / sp.sin(w)),
        (sp.cos(w) * sp.sin(w) / (a * sp.cos(w) ** 2 - a), -sp.cos(w) / (a * sp.sin(w))),
        (1 / sp.sin(w), 1 / sp.sin(w)),
        (sp.sin(w) ** 2, 1 - sp.cos(w) ** 2),
    ],
)
def test_sines_are_cancelled(value, expected):
    assert collected(value) == expected


def test_an_input_with_a_phase_has_no_number_on_both_sides_of_a_line():
    plant = system([[-1]], B=[1], C=[[1]])
    y = ask("response", plant, kind="zero_state", input=(sp.sin(w * t + phi),)).answers["y"]
    below = {power.base for power in y.atoms(sp.Pow) if power.exp == -1}
    assert below == {1 + w**2}


@pytest.mark.parametrize("n", [*range(-3, 8), LARGEST_MULTIPLE])
@pytest.mark.parametrize("c", [sp.Rational(3, 5), sp.Rational(-1, 3), sp.sqrt(2) / 3])
def test_multiples_of_an_arccosine_have_values(n, c):
    for wave in (sp.cos, sp.sin):
        found = multiple_angles(wave(n * sp.acos(c), evaluate=False))
        assert not found.has(sp.acos)
        assert abs(sp.N(found - wave(n * sp.acos(c)), 30)) < 1e-25


def test_the_peak_of_samples_is_a_fraction():
    plant = system([[0, 1], [-sp.Rational(81, 100), sp.Rational(27, 25)]], B=[0, 1], C=[[1, 0]], discrete=True)
    answers = ask("response", plant, kind="zero_state", input=(sp.Integer(1),)).answers
    assert (answers["t_peak"], answers["y_peak"]) == (4, sp.Rational(6091, 2500))


def test_a_symbolic_overshoot_leaves_pi_over_the_peak_time():
    M, T = sp.symbols("M T", positive=True)
    found = second_order({"overshoot": M, "peak_time": T})
    assert found.omega_d == sp.pi / T
    assert found.poles == [sp.log(M) / T + sp.I * sp.pi / T, sp.log(M) / T - sp.I * sp.pi / T]


def test_a_reduced_observer_has_the_pole_asked_for():
    plant = system([[0, 1], [0, -d / m]], B=[0, 1 / m], C=[[1, 0]])
    assert ask("reduced_observer", plant, poles=(-a,)).answers["J"] == sp.Matrix([[-a]])
