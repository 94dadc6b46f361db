"""Z-transforms of sampled functions, against their own first samples."""

from itertools import product

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver import exact

t, z = sp.symbols("t z")
T = sp.Symbol("T", positive=True)
PERIODS = (T, sp.Rational(1, 2), sp.pi, sp.pi / 2, 5 * sp.pi / 4)
FUNCTIONS = (
    sp.Integer(1),
    t**3 * sp.exp(-t),
    1 - sp.exp(-2 * t),
    t * sp.exp(-t) * sp.sin(2 * t) + 3 * sp.exp(-t) * sp.cos(2 * t) - sp.exp(t) * t**2,
    t**2 * sp.cos(3 * t) + sp.sin(-t),
    sp.cosh(2 * t) * t + sp.sinh(2 * t),
)


def number(value):
    return sp.N(value.subs(T, sp.Rational(3, 10)), 40)


def samples(image, count=10):
    """The first samples by long division of z N(z)/D(z)."""
    below = [sp.S.One]
    for base, m in image.factors:
        for _ in range(m):
            row = [number(c) for c in base.coefficients]
            below = [
                sum((below[i - j] * c for j, c in enumerate(row) if 0 <= i - j < len(below)), sp.S.Zero)
                for i in range(len(below) + len(row) - 1)
            ]
    above = [*map(number, image.numerator), sp.S.Zero]
    rest, found = [sp.S.Zero] * (len(below) - len(above)) + above, []
    for _ in range(count):
        found.append(rest[0])
        rest = [*[a - found[-1] * b for a, b in zip(rest, below, strict=True)][1:], sp.S.Zero]
    return found


def is_sampled(f, period, ahead):
    found = samples(exact.sampled_image(f, t, period, ahead))
    wanted = [number(f.subs(t, (k + ahead) * period)) for k in range(len(found))]
    return all(abs(a - b) < 1e-15 * (1 + abs(b)) for a, b in zip(found, wanted, strict=True))


@pytest.mark.parametrize("f", FUNCTIONS)
def test_the_transform_has_the_samples(f):
    assert all(is_sampled(f, period, ahead) for period, ahead in product(PERIODS, (sp.S.Zero, sp.Rational(1, 3))))


@settings(max_examples=8, deadline=None)
@given(st.lists(st.tuples(*[st.integers(-3, 3)] * 2, st.integers(0, 2), st.integers(0, 3)), min_size=1, max_size=3))
def test_the_transform_of_any_sum_of_modes_has_the_samples(terms):
    f = sum((c * t**n * sp.exp(sigma * t) * sp.cos(omega * t + 0) for c, sigma, n, omega in terms), sp.S.Zero)
    assert f == 0 or is_sampled(f, sp.Rational(1, 4), sp.S.Zero)


def test_a_damped_ramp_is_that_of_the_table():
    (fraction,) = exact.sampled_image(t * sp.exp(-t), t, T).terms(z)
    assert sp.cancel(fraction - T * sp.exp(-T) * z / (z - sp.exp(-T)) ** 2) == 0


def test_a_wave_that_is_sampled_at_its_nodes_is_not_seen():
    assert exact.sampled_image(sp.sin(t), t, sp.pi).samples == ()
    (fraction,) = exact.sampled_image(sp.cos(t) + sp.sin(t), t, sp.pi).terms(z)
    assert sp.cancel(fraction - z / (z + 1)) == 0
    both = exact.sampled_image(sp.cos(t) - sp.cos(3 * t), t, sp.pi)
    assert both.samples == ()


def test_another_function_is_refused():
    with pytest.raises(exact.NotExact):
        exact.sampled_image(1 / (t + 1), t, T)
