"""Kernels of loops on the imaginary axis: exact phases, crossings with dead times, turns, Bode's form."""

import mpmath
import pytest
import sympy as sp

from solver import exact

s, K, w = sp.symbols("s K omega")


def on_axis(N, D, T=0):
    return exact.on_axis(sp.expand(sp.sympify(N)), sp.expand(D), s, sp.sympify(T))


@pytest.mark.parametrize(
    ("N", "D", "omega", "degrees"),
    [
        (1, s + 1, 1, -45),
        (1, s**2 + s + 1, 1, -90),
        (1, (s + 1) ** 3, sp.sqrt(3), 180),
        (-1, s + 1, 1, 135),
        (s - 1, s + 1, 1, 90),
        (1, s + 1, sp.sqrt(3), -60),
        (1, s + 1, 1 + sp.sqrt(2), sp.Rational(-135, 2)),
    ],
)
def test_phases_that_are_rational_numbers_of_degrees(N, D, omega, degrees):
    assert on_axis(N, D).phase(sp.sympify(omega)) == degrees


def test_the_continuous_phase_goes_on_below_minus_180():
    L = on_axis(10, s * (s + 1) * (s + 5))
    assert abs(L.continuous_phase(sp.Integer(3)) + 192.528807709) < 1e-8
    assert abs(L.phase(sp.Integer(3)) - 167.471192290) < 1e-8
    (at,) = exact.phase_crossings(L, sp.Integer(-135))
    assert abs(L.continuous_phase(at) + 135) < 1e-20
    late = on_axis(1, s + 1, 2)
    first, *_ = exact.phase_crossings(late, sp.Integer(-540))
    assert abs(late.continuous_phase(first) + 540) < 1e-20


def test_crossovers_are_exact_up_to_degree_two():
    found = exact.margins_of(on_axis(1, s * (s + 1)))
    assert found.gain_crossover == sp.sqrt(sp.sqrt(5) / 2 - sp.Rational(1, 2))
    surds = exact.margins_of(on_axis(sp.sqrt(2), s * (s + sp.sqrt(3)) * (s + 1)))
    assert surds.phase_crossover == sp.root(3, 4)
    assert exact.in_decibels(sp.Integer(100)) == 40
    assert exact.in_decibels(sp.sqrt(10) / 10) == -10


def test_with_a_dead_time_every_crossing_up_to_the_last_large_one_is_found():
    L = on_axis(3, s + 1, 2)
    found = exact.phase_crossovers(L)
    for each in found.found:
        omega = mpmath.mpf(str(each.omega))
        value = 3 * mpmath.exp(-2j * omega) / (1 + 1j * omega)
        assert abs(value + mpmath.mpf(str(each.magnitude))) < 1e-12
    assert [each.magnitude > 1 for each in found.found] == [True, False]


@pytest.mark.parametrize(
    ("N", "D", "turns"),
    [
        (5, (s**2 + 4) * (s + 1), 2),
        (10 * (s + 2), s**2 * (s + 1) * (s + 20), 2),
        (s + 1, s**2 * (s - 1), 1),
        (1 - 3 * s, s + 2, 1),
        (2, s - 1, -1),
        (5, (s**2 + 4) ** 2, 2),
    ],
)
def test_turns_with_poles_on_the_axis_and_values_at_infinity(N, D, turns):
    found = exact.encirclements(sp.expand(sp.sympify(N)), sp.expand(D), s)
    assert found.clockwise == turns == found.closed_loop - found.open_loop


def test_bodes_form():
    form = exact.bode_form(on_axis(50, (s + 5) * (s**2 + s + 100)))
    assert (form.gain, form.power, form.slopes) == (sp.Rational(1, 10), 0, (0, -20, -60))
    assert [each.damping for each in form.corners] == [None, sp.Rational(1, 20)]


def test_parameters_and_constant_sizes_are_refused():
    with pytest.raises(exact.NotExact, match="K"):
        on_axis(K, s + 1)
    with pytest.raises(exact.NotExact):
        exact.margins_of(on_axis(1 - s, 1 + s))
