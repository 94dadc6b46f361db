"""The judge of specifications finds the damping ratio and the frequency of the response that shows them."""

import math

import pytest
import sympy as sp

from solver.numeric import NotEvaluable
from solver.numeric.judges.design.second_order import (
    complex_of,
    damping_and_frequency,
    second_order_cases,
    second_order_poles,
    second_order_residual,
)
from tests.exact.test_second_order import OMEGA, PAIRS, SHOWN, ZETA

w, h, x = (sp.Symbol(name, positive=True) for name in "whx")
R = sp.Rational


@pytest.mark.parametrize("pair", PAIRS, ids="-".join)
def test_two_specifications_lead_back_to_the_response_that_shows_them(pair):
    zeta, omega = damping_and_frequency({name: SHOWN[name] for name in pair})
    assert float(zeta) == pytest.approx(float(ZETA), rel=1e-12)
    assert float(omega) == pytest.approx(float(OMEGA), rel=1e-12)
    assert [complex(each) for each in second_order_poles({name: SHOWN[name] for name in pair})] == pytest.approx(
        [-1.5 + 2j, -1.5 - 2j], rel=1e-12
    )


def test_of_more_than_two_the_first_are_met_and_not_both_about_the_damping():
    more = {"damping_ratio": ZETA, "overshoot": R(1, 2), "peak_time": SHOWN["peak_time"], "rise_time": R(7)}
    assert [float(each) for each in damping_and_frequency(more)] == pytest.approx([float(ZETA), float(OMEGA)])


def test_the_band_of_the_settling_time_and_no_overshoot():
    zeta, omega = damping_and_frequency({"damping_ratio": R(1, 2), "settling_time": R(3)}, band=3)
    assert (float(zeta), float(omega)) == (0.5, 2.0)
    zeta, omega = damping_and_frequency({"overshoot": R(0), "settling_time": R(2)})
    assert (float(zeta), float(omega)) == (1.0, 2.0)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"damping_ratio": R(1, 2)}, "natural frequency"),
        ({"damping_ratio": R(1, 2), "overshoot": R(1, 10)}, "natural frequency"),
        ({"natural_frequency": R(3), "peak_time": R(1)}, "no damping ratio"),
        ({"peak_time": R(1), "rise_time": R(1, 3)}, "no damping ratio"),
    ],
)
def test_what_does_not_fix_the_poles_is_refused(given, words):
    with pytest.raises(NotEvaluable, match=words):
        damping_and_frequency(given)
    with pytest.raises(NotEvaluable, match=words):
        second_order_cases(given)


def test_with_parameters_two_values_are_tried_that_can_be_met():
    given = {"natural_frequency": w, "damping_ratio": h}
    found = second_order_cases(given)
    assert len(found) == 2
    for point, zeta, omega in found:
        assert float(zeta) == float(point[h]) < 1
        assert float(omega) == float(point[w])
    with pytest.raises(NotEvaluable, match="no values"):
        second_order_cases({"natural_frequency": w, "damping_ratio": h + 1})


@pytest.mark.parametrize(
    ("given", "omega"),
    [
        ({"damping_ratio": h, "natural_frequency": w}, w),
        ({"damping_ratio": h, "settling_time": w}, 4 / (h * w)),
        ({"damping_ratio": h, "peak_time": w}, sp.pi / (w * sp.sqrt(1 - h**2))),
    ],
)
def test_poles_in_symbols(given, omega):
    at = {h: R(3, 5), w: R(2)}
    right = [complex((omega * (-h + sign * sp.I * sp.sqrt(1 - h**2))).subs(at)) for sign in (1, -1)]
    assert [complex(pole.subs(at)) for pole in second_order_poles(given)] == pytest.approx(right)
    with pytest.raises(NotEvaluable, match="damping ratio is given"):
        second_order_poles({"overshoot": h, "peak_time": w})


def test_an_answer_is_compared_value_by_value():
    given = {"damping_ratio": ZETA, "natural_frequency": OMEGA}

    def formula(zeta, omega):
        return [zeta, omega, zeta * omega]

    right = [ZETA, OMEGA, R(3, 2)]
    assert second_order_residual(given, 4, formula, right) < 1e-20
    for wrong in ([ZETA, OMEGA], [ZETA, OMEGA, R(3, 2), R(1)], [-ZETA, OMEGA, R(3, 2)], [OMEGA, ZETA, R(3, 2)]):
        assert second_order_residual(given, 4, formula, wrong) > 1e-6
    off = second_order_residual(given, 4, formula, [ZETA, OMEGA + R(1, 100), R(3, 2)])
    assert math.isclose(off, 0.01 / 2.5, rel_tol=1e-9)
    with pytest.raises(NotEvaluable, match="symbols"):
        complex_of(x + 1, {w: R(1)})
    assert abs(complex_of(3, {}) - 3) < 1e-30
