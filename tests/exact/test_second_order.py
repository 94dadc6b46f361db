"""Damping and frequency from two specifications: the step response that follows has what was specified."""

import itertools

import pytest
import sympy as sp

from solver.exact import Inconsistent, second_order

R = sp.Rational
t = sp.Symbol("t", positive=True)
ZETA, OMEGA = R(3, 5), R(5, 2)


def response(zeta, omega_n):
    """The step response of ω²/(s² + 2ζωs + ω²), under-damped."""
    damped = omega_n * sp.sqrt(1 - zeta**2)
    wave = sp.cos(damped * t) + zeta / sp.sqrt(1 - zeta**2) * sp.sin(damped * t)
    return 1 - sp.exp(-zeta * omega_n * t) * wave


def measured():
    """What the response itself shows: its first maximum, its first crossing of one, and the envelope's decay."""
    y = response(ZETA, OMEGA)
    peak = sp.nsolve(sp.diff(y, t), (1.4, 1.8), solver="bisect", prec=30)
    rise = sp.nsolve(y - 1, (0.5, 1.4), solver="bisect", prec=30)
    return {
        "damping_ratio": ZETA,
        "natural_frequency": OMEGA,
        "settling_time": 4 / (ZETA * OMEGA),
        "peak_time": peak,
        "overshoot": y.subs(t, peak) - 1,
        "rise_time": rise,
    }


SHOWN = measured()
PAIRS = [pair for pair in itertools.combinations(SHOWN, 2) if set(pair) != {"damping_ratio", "overshoot"}]


@pytest.mark.parametrize("pair", PAIRS, ids="-".join)
def test_two_specifications_lead_back_to_the_system_that_has_them(pair):
    found = second_order({name: SHOWN[name] for name in pair})
    assert abs(sp.N(found.zeta - ZETA, 25)) < 1e-15
    assert abs(sp.N(found.omega_n - OMEGA, 25)) < 1e-15
    assert abs(sp.N(found.sigma - ZETA * OMEGA, 25)) < 1e-15
    assert set(found.used) == set(pair)
    upper, lower = found.poles
    assert abs(sp.N(upper - (-R(3, 2) + 2 * sp.I), 25)) < 1e-14
    assert abs(sp.N(lower - (-R(3, 2) - 2 * sp.I), 25)) < 1e-14
    assert all(abs(sp.N(a - b, 25)) < 1e-14 for a, b in zip(found.coefficients, (1, 3, R(25, 4)), strict=True))


def test_the_band_of_five_percent():
    found = second_order({"damping_ratio": ZETA, "settling_time": sp.Integer(2)}, band=3)
    assert found.omega_n == R(5, 2)
    assert second_order({"natural_frequency": OMEGA, "settling_time": sp.Integer(2)}, band=3).zeta == R(3, 5)


def test_more_than_two_must_agree_within_a_percent():
    agreeing = {"damping_ratio": ZETA, "natural_frequency": OMEGA, "settling_time": R(8, 3) * R(1009, 1000)}
    assert second_order(agreeing).used == ("damping_ratio", "natural_frequency")
    with pytest.raises(Inconsistent) as refused:
        second_order({**agreeing, "settling_time": R(8, 3) * R(1011, 1000)})
    assert refused.value.reason.kind == "second_order/contradiction"
    assert refused.value.reason.values["name"] == "settling_time"


@pytest.mark.parametrize(
    ("asked", "kind"),
    [
        ({"damping_ratio": ZETA}, "too_few"),
        ({"damping_ratio": ZETA, "overshoot": R(1, 10)}, "only_damping"),
        ({"damping_ratio": ZETA, "peak_time": R(0)}, "not_positive"),
        ({"damping_ratio": -ZETA, "peak_time": R(1)}, "not_positive"),
        ({"overshoot": R(1), "peak_time": R(1)}, "large_overshoot"),
        ({"damping_ratio": R(1), "peak_time": R(1)}, "no_peak"),
        ({"damping_ratio": R(2), "rise_time": R(1)}, "no_peak"),
        ({"natural_frequency": R(3), "peak_time": R(1)}, "early_peak"),
        ({"natural_frequency": R(1), "rise_time": R(3, 2)}, "early_rise"),
        ({"natural_frequency": sp.Symbol("w", positive=True), "rise_time": R(1)}, "no_formula"),
        ({"peak_time": R(1), "rise_time": R(1, 3)}, "no_damping"),
        ({"natural_frequency": R(1), "settling_time": R(2), "overshoot": R(1, 10)}, "overdamped"),
    ],
)
def test_what_cannot_be_met_is_refused_by_kind(asked, kind):
    with pytest.raises(Inconsistent) as refused:
        second_order(asked)
    assert refused.value.reason.kind == f"second_order/{kind}"


@pytest.mark.parametrize(("frequency", "settling", "poles"), [(4, R(4, 5), [-8, -2]), (2, 2, [-2, -2])])
def test_an_overdamped_system_has_two_real_poles(frequency, settling, poles):
    found = second_order({"natural_frequency": R(frequency), "settling_time": R(settling)})
    assert found.overdamped
    assert sorted(found.poles) == poles


def test_parameters_stay_in_the_formulas():
    w, zeta = sp.symbols("w zeta", positive=True)
    found = second_order({"natural_frequency": w, "damping_ratio": zeta})
    assert sp.expand(found.poles[0] + zeta * w - sp.I * w * sp.sqrt(1 - zeta**2)) == 0
    assert not found.overdamped
    at_peak = second_order({"damping_ratio": R(4, 5), "peak_time": w})
    assert sp.expand(at_peak.omega_n - 5 * sp.pi / (3 * w)) == 0
