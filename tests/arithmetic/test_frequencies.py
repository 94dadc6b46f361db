"""A fraction at a frequency, factor by factor: size and angle are those of Python's complex numbers."""

import cmath

import pytest
import sympy as sp

from solver.arithmetic.frequencies import size_and_angle, slope_of
from solver.arithmetic.quadratics import both_roots
from solver.numeric import check_steps
from solver.render.wording import Wording

TUTOR = Wording(detail="tutor")
s, w, K = sp.symbols("s w K")


def displayed(steps):
    assert [check for check in check_steps(steps) if check.status != "passed"] == []
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


@pytest.mark.parametrize(
    ("fraction", "at"),
    [
        (20 / (s * (s + 1) * (s + 2)), 1.41j),
        (-3 * (s - 1) / (s**2 * (s**2 + s + 4) ** 2), 2j),
        ((s + 1) / (s * (s + 5)), -2 + 3j),
    ],
)
def test_size_and_angle_are_those_of_complex_numbers(fraction, at):
    value = complex(fraction.subs(s, at))
    number = sp.nsimplify(at) if isinstance(at, complex) else at
    size, angle = sp.Float(abs(value), 15), sp.Float(cmath.phase(value) * 180 / cmath.pi, 15)
    (step,) = size_and_angle(fraction, s, number, size, angle)
    assert {"size", "angle"} <= set(step.claims)
    assert "Factor by factor" in displayed([step])


def test_nothing_is_shown_of_one_factor_of_parameters_and_of_dead_times():
    assert size_and_angle(1 / (s + 1), s, sp.I, sp.S.One) == ()
    assert size_and_angle(K / (s**2 + s), s, sp.I, sp.S.One) == ()
    assert size_and_angle(sp.exp(-s) / (s**2 + s), s, sp.I, sp.S.One) == ()


def test_the_slope_of_a_quotient():
    assert "2w - 16" in displayed(slope_of(sp.S(100), w**2 - 16 * w + 100, w))
    assert "N'D - ND'" in displayed(slope_of(w + 1, w**2 + 4, w))


def test_both_roots_of_a_quadratic():
    assert r"8 \pm \sqrt{164} = 20.806,\; -4.8062" in displayed(both_roots(w, w**2 - 16 * w - 100))
    assert both_roots(w, w**2 + w + 1) == ()
    assert both_roots(w, w - 8) == ()
