"""Time domain of transfer functions and loops against python-control: poles, zeros, gains, damping, step_info."""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from tests.helpers.asking import ask
from tests.helpers.comparing import systems_tried
from tests.helpers.fractions_of_polynomials import plant, s

ROOTS = st.one_of(
    st.integers(1, 8).map(lambda a: s + a),
    st.tuples(st.integers(1, 4), st.integers(1, 6)).map(lambda p: (s + p[0]) ** 2 + p[1] ** 2),
)


def coefficients(p):
    return [float(c) for c in sp.Poly(p, s).all_coeffs()]


def fractions(factors, zeros, gain):
    """Numerator and denominator from some factors, not more zeros than poles."""
    bottom = sp.expand(sp.Mul(*factors))
    zeros = zeros[: sp.degree(bottom, s)]
    return sp.expand(gain * sp.Mul(*(s - z for z in zeros))), bottom


@systems_tried(30)
@given(
    st.lists(st.one_of(ROOTS, st.integers(-2, 0).map(lambda a: s + a)), min_size=1, max_size=3),
    st.lists(st.integers(-7, 4).filter(bool), max_size=2),
    st.integers(1, 5),
)
def test_poles_zeros_and_the_gain_at_zero(factors, zeros, gain):
    top, bottom = fractions(factors, zeros, gain)
    other = control.minreal(control.tf(coefficients(top), coefficients(bottom)), verbose=False)
    result = ask("pole_zero_form", plant(top, bottom))
    assert result.status is Status.VERIFIED, result.reason
    for name, theirs in (("poles", other.poles()), ("zeros", other.zeros())):
        ours = [complex(each) for each in result.answers[name]]
        assert np.allclose(np.poly(ours), np.poly(theirs), rtol=1e-4, atol=1e-6)
    found = ask("dc_gain", plant(top, bottom))
    theirs = control.dcgain(other)
    if found.status is Status.VERIFIED and abs(found.answers["dc_gain"]) != sp.oo and np.isfinite(theirs):
        assert float(found.answers["dc_gain"]) == pytest.approx(float(np.real(theirs)), rel=1e-5, abs=1e-8)


@systems_tried(20)
@given(st.integers(1, 9), st.integers(0, 20), st.integers(1, 40))
def test_natural_frequency_and_damping(b2, b1, b0):
    found = ask("second_order_parameters", plant(1, b2 * s**2 + b1 * s + b0))
    assert found.status is Status.VERIFIED, found.reason
    omega, zeta, _ = control.damp(control.tf([1], [b2, b1, b0]), doprint=False)
    pair = b1**2 < 4 * b2 * b0
    assert float(found.answers["natural_frequency"]) == pytest.approx(np.sqrt(np.prod(omega)), rel=1e-6)
    if pair:
        assert float(found.answers["damping_ratio"]) == pytest.approx(zeta[0], abs=1e-6)


@systems_tried(25)
@given(
    st.lists(ROOTS, min_size=1, max_size=3),
    st.lists(st.integers(-9, 5).filter(bool), max_size=2),
    st.sampled_from(["2%", "5%"]),
    st.booleans(),
)
def test_specifications_of_step_responses(factors, zeros, band, closed):
    """Where its samples do not see the first or the last crossing exactly, python-control is off by a sample.

    Its peak is the largest |y|, even where that is a jump away from the final value at the beginning.
    """
    top, bottom = fractions(factors, zeros, 4)
    options = {"settling_band": band, "rise": "10-90", "overshoot_in": "fraction"}
    loop = control.tf(coefficients(top), coefficients(bottom))
    if closed:
        loop = control.feedback(loop, 1)
        if np.max(loop.poles().real) > -0.05 or abs(control.dcgain(loop)) < 1e-6:
            return
        numerator, denominator = top, sp.expand(top + bottom)
        if sp.Poly(denominator, s).degree() != sp.Poly(bottom, s).degree():
            return
    else:
        numerator, denominator = top, bottom
    result = ask("step_specifications", plant(numerator, denominator), "response", **options)
    assert result.status is Status.VERIFIED, result.reason
    ours = {name: float(value) for name, value in result.answers.items()}
    span = max(1.5 * ours["settling_time"], 2 * ours.get("peak_time", 0.0), 0.1)  # a peak may come within the band
    t = np.linspace(0, span, 40001)
    y = control.step_response(loop, t).outputs
    info = control.step_info(
        y,
        t,
        yfinal=ours["final_value"],
        SettlingTimeThreshold=float(band[:-1]) / 100,
        RiseTimeLimits=(0.1, 0.9),
    )
    sample = 3 * span / 40000
    assert info["Overshoot"] / 100 == pytest.approx(ours["overshoot"], abs=1e-4)
    assert info["SettlingTime"] == pytest.approx(ours["settling_time"], abs=sample)
    assert info["RiseTime"] == pytest.approx(ours["rise_time"], abs=sample)
    if ours["overshoot"] > 1e-3 and y[np.argmax(np.abs(y))] * ours["final_value"] > 0:
        assert info["PeakTime"] == pytest.approx(ours["peak_time"], abs=50 * sample)


HARD = {
    "a zero makes the overshoot": (10 * s + 1, s**2 + 3 * s + 2),
    "a zero on the right, undershoot": (2 - 4 * s, (s + 1) * (s + 2)),
    "two zeros on the right": ((s - 1) * (s - 2), (s + 1) ** 3),
    "a slow pole beside a zero, from below": (s + sp.Rational(11, 100), (10 * s + 1) * (s**2 + 2 * s + 4)),
    "a slow pole beside a zero, from above": (s + sp.Rational(9, 100), (10 * s + 1) * (s**2 + 2 * s + 4)),
    "a jump over the final value": (3 * s**2 + s + 1, s**2 + s + 1),
    "a jump the other way": (1 - s, s + 1),
    "hardly damped": (4, s**2 + s / 5 + 4),
    "a negative final value": (-3, s**2 + s + 1),
    "no overshoot, four poles together": (1, (s + 1) ** 4),
    "the second top is the highest": (8, (s + 1) * (s**2 + s + 8)),
    "a loop of type 0": (12, (s + 1) * (s + 2) * (s + 3) + 12),
    "a loop of type 1": (2, s * (s + 1) * (s + 3) + 2),
    "a loop of type 2": (4 * s + 1, s**2 * (s + 4) + 4 * s + 1),
    "a loop of type 3": (9 * (s + sp.Rational(1, 2)) ** 2, s**3 + 9 * (s + sp.Rational(1, 2)) ** 2),
}
"""What samples see easily wrong: where the first course's formulas do not apply."""


@pytest.mark.parametrize(("name", "band"), [(name, ("2%", "5%")[i % 2]) for i, name in enumerate(HARD)])
def test_specifications_where_formulas_do_not_apply(name, band):
    """Final value and time of the samples come from python-control alone, so that ours cannot lead it.

    Without an overshoot it names the largest |y| as its peak, the end of the samples or a jump the other way; we none.
    """
    top, bottom = (sp.expand(each) for each in HARD[name])
    other = control.tf(coefficients(top), coefficients(bottom))
    span = 12 / min(-other.poles().real)
    t = np.linspace(0, span, 20_001)
    y = control.step_response(other, t).outputs
    final = float(np.real(control.dcgain(other)))
    info = control.step_info(
        y, t, yfinal=final, SettlingTimeThreshold=float(band[:-1]) / 100, RiseTimeLimits=(0.1, 0.9)
    )
    result = ask(
        "step_specifications",
        plant(top, bottom),
        "response",
        settling_band=band,
        rise="10-90",
        overshoot_in="fraction",
    )
    assert result.status is Status.VERIFIED, result.reason
    ours = {name: float(value) for name, value in result.answers.items()}
    sample = 3 * span / 20_000
    assert ours["final_value"] == pytest.approx(final, rel=1e-9)
    assert ours["overshoot"] == pytest.approx(info["Overshoot"] / 100, abs=1e-5)
    assert ours["settling_time"] == pytest.approx(info["SettlingTime"], abs=sample)
    assert ours["rise_time"] == pytest.approx(info["RiseTime"], abs=sample)
    assert ("peak_time" in ours) == (info["Overshoot"] > 0.01)
    if "peak_time" in ours:
        assert ours["peak_time"] == pytest.approx(info["PeakTime"], abs=10 * sample)
        assert abs(info["Peak"]) == pytest.approx(abs(final) * (1 + ours["overshoot"]), rel=1e-5)


def test_a_final_value_of_zero_has_no_overshoot_in_parts_of_it():
    """From samples python-control makes it 0, or millions of percent of what rounding leaves of zero."""
    result = ask("step_specifications", plant(s, s**2 + 3 * s + 2), "response", settling_band="2%")
    assert result.status is Status.UNSOLVED
    assert result.reason.kind == "step_specifications/no_final_value"
