"""Responses against integration by scipy and exact recursion; limits, peaks and time constants against samples."""

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from solver import exact
from solver.exact.functions.rational import between
from solver.exact.time_response.long_run import limit, slowest
from tests.helpers.asking import system

t, k = sp.symbols("t k")
M = sp.ImmutableMatrix
u, cos, sin, exp = sp.Heaviside, sp.cos, sp.sin, sp.exp
half = sp.Rational(1, 2)

PAIR = system([[0, 1], [-2, -3]], B=[[0, 1], [1, 1]], C=[[1, 0], [1, 1]], D=[[0, 2], [1, 0]])
OSCILLATOR = system([[0, 1], [-4, 0]], B=[0, 1], C=[[1, 2]], D=[[3]])
CONTINUOUS = [
    (PAIR, [1, -1], [sp.Integer(0), sp.Integer(0)]),
    (PAIR, None, [sp.Integer(1), exp(-t)]),
    (PAIR, [2, 1], [t**2 * exp(-2 * t), cos(3 * t) - t]),
    (PAIR, None, [u(t - 1) * (t - 1), u(t - 2) - u(t - 3)]),
    (OSCILLATOR, [1, 0], [sin(2 * t)]),
    (OSCILLATOR, None, [t * cos(2 * t) + 5]),
    (OSCILLATOR, [0, 2], [u(2 - t) * t]),
]


@pytest.mark.parametrize(("plant", "x0", "inputs"), CONTINUOUS)
def test_scipy_integrates_to_the_same(plant, x0, inputs):
    found = exact.response(plant, M(x0) if x0 else None, inputs, t)
    A, B, C, D = (np.array(N, dtype=float) for N in (plant.A, plant.B, plant.C, plant.D))
    drive = sp.lambdify(t, inputs, "numpy")
    times = np.array([0.3, 1.4, 2.6, 3.7])
    start = np.array(x0 or [0, 0], dtype=float)
    x = solve_ivp(
        lambda now, x: A @ x + B @ np.array(drive(now), dtype=float),
        (0, 4),
        start,
        t_eval=times,
        rtol=1e-9,
        atol=1e-11,
        max_step=0.01,
    ).y
    for i, now in enumerate(times):
        ours = np.array(found.x.subs(t, sp.Rational(str(now))).evalf(), dtype=float).ravel()
        assert np.allclose(ours, x[:, i], rtol=1e-4, atol=1e-4)
        y = np.array(found.y.subs(t, sp.Rational(str(now))).evalf(), dtype=float).ravel()
        assert np.allclose(y, C @ x[:, i] + D @ np.array(drive(now), dtype=float), rtol=1e-4, atol=1e-4)


SAMPLED = system([[0, 1], [-half, 1]], B=[1, 2], C=[[1, -1]], D=[[2]], discrete=True)
SEQUENCES = [
    ([1, 3], [sp.Integer(0)]),
    (None, [sp.Integer(1)]),
    ([0, 1], [k**2 * half**k]),
    (None, [u(k - 2) * k + sp.DiracDelta(k - 1)]),
    ([1, 1], [cos(sp.pi * k / 2) * k]),
    (None, [(-1) ** k + 2 ** (-k)]),
]


@pytest.mark.parametrize(("x0", "inputs"), SEQUENCES)
def test_the_recursion_gives_the_same_samples(x0, inputs):
    found = exact.response(SAMPLED, M(x0) if x0 else None, inputs, k)
    (entry,) = inputs
    step = entry.replace(u, lambda at, _: sp.Piecewise((1, at >= 0), (0, True)))
    step = step.replace(sp.DiracDelta, lambda at: sp.Piecewise((1, sp.Eq(at, 0)), (0, True)))
    x = sp.Matrix(x0 or [0, 0])
    for i in range(7):
        value = sp.Matrix([step.subs(k, i)])
        assert (found.x.subs(k, i) - x).applyfunc(sp.expand_func).evalf(20).norm() < 1e-15
        assert (found.y.subs(k, i) - SAMPLED.C * x - SAMPLED.D * value).evalf(20).norm() < 1e-15
        x = SAMPLED.A * x + SAMPLED.B * value


def test_impulses_start_the_state_and_pass_through():
    found = exact.response(OSCILLATOR, None, [sp.DiracDelta(t) + 2 * sp.DiracDelta(t - 1)], t)
    assert sp.expand(found.impulse[0] - 3 * sp.DiracDelta(t) - 6 * sp.DiracDelta(t - 1)) == 0
    assert found.x.subs(t, half) == M([sin(2 * half) / 2, cos(2 * half)])
    assert abs(sp.N(found.x[1].subs(t, 2) - cos(4) - 2 * cos(2))) < 1e-14


@pytest.mark.parametrize(
    ("entry", "limit_of_y"),
    [
        (u(t - 1), half),
        (u(t) - u(t - 3), 0),
        (u(t - 2) + 3 * sp.DiracDelta(t - 1), half),
        ((t - 1) * u(t - 1), None),
        ((t - 1) * u(t - 1) - (t - 3) * u(t - 3), 1),
        (u(t - 1) * exp(-t), 0),
        (u(t - 1) * sin(t), None),
    ],
)
def test_the_final_value_after_the_last_piece_has_begun(entry, limit_of_y):
    plant = system([[0, 1], [-2, -3]], B=[0, 1], C=[[1, 0]])
    found = exact.response(plant, None, [entry], t)
    assert (found.y_final[0] if found.y_final is not None else None) == limit_of_y


def image(rows, out, start):
    """The transform of out · e^{At} start."""
    return between(M([out]), M(rows), M(start))


DIAGONAL = [[-1, 0], [0, -3]]


@pytest.mark.parametrize(
    ("rows", "out", "start", "discrete", "value", "constant"),
    [
        (DIAGONAL, [1, 1], [1, 1], False, 0, 1),
        (DIAGONAL, [0, 1], [1, 1], False, 0, sp.Rational(1, 3)),
        ([[0, 0], [0, -2]], [3, 1], [1, 1], False, 3, half),
        ([[0, 1], [0, 0]], [1, 0], [1, 1], False, None, None),
        ([[0, 1], [0, 0]], [1, 0], [1, 0], False, 1, None),
        ([[1, 0], [0, -1]], [1, 1], [1, 1], False, None, 1),
        ([[1, 0], [0, -1]], [1, 1], [0, 1], False, 0, 1),
        ([[0, 1], [-4, 0]], [1, 0], [1, 0], False, None, None),
        ([[0, 1], [-5, -2]], [1, 0], [1, 0], False, 0, 1),
        ([[0, 1, 0], [0, 0, 1], [-1, -1, -3]], [1, 0, 0], [1, 0, 0], False, 0, None),
        ([[1, 0], [0, half]], [2, 1], [1, 1], True, 2, 1 / sp.log(2)),
        ([[-1, 0], [0, half]], [2, 1], [1, 1], True, None, 1 / sp.log(2)),
        ([[0, 0], [0, -half]], [2, 1], [1, 1], True, 0, 1 / sp.log(2)),
        ([[0, 1], [-half, 1]], [1, 0], [1, 0], True, 0, 2 / sp.log(2)),
        ([[0, 1], [-2, 1]], [1, 0], [1, 0], True, None, None),
        ([[0, 1], [0, 0]], [1, 0], [1, 1], True, 0, None),
    ],
)
def test_limits_and_the_slowest_time_constant(rows, out, start, discrete, value, constant):
    found = limit(image(rows, out, start), discrete=discrete)
    assert (found[0] if found is not None else None) == value
    if constant is not None:
        assert slowest(image(rows, out, start), discrete=discrete) == pytest.approx(float(constant))
    elif value is None or len(rows) == 2:
        assert slowest(image(rows, out, start), discrete=discrete) is None


def peak_of(rows, out, start, *, discrete=False):
    plant = system(rows, C=[out], discrete=discrete)
    found = exact.response(plant, M(start), [], k if discrete else t)
    return found.y_peak, found.y[0]


@pytest.mark.parametrize(
    ("rows", "out", "start"),
    [
        (DIAGONAL, [1, -1], [1, 1]),
        (DIAGONAL, [-4, 5], [1, 1]),
        ([[-1, 1], [0, -1]], [1, 0], [0, 1]),
        ([[-2, 1], [0, -2]], [1, 0], [-1, 30]),
        ([[0, 1], [-5, -2]], [1, 0], [0, 1]),
        ([[0, 1], [-5, -2]], [1, 0], [1, 2]),
        ([[0, 1], [-5, -2]], [1, 1], [1, -3]),
        ([[0, 1, 0], [-5, -2, 5], [0, 0, 0]], [1, 0, 0], [0, 0, 1]),
        ([[0, 1], [-4, 0]], [1, 0], [1, 2]),
        ([[-1, 1, 0], [0, -2, 1], [0, 0, -3]], [1, 0, 0], [0, 0, 1]),
        ([[-1, 1, 0], [0, -1, 1], [0, 0, -1]], [1, 0, 0], [0, 0, 1]),
        ([[0, 1, 0], [0, 0, 1], [-4, -4, -2]], [1, 0, 0], [0, 1, 0]),
        ([[-1, 1, 0, 0], [0, -1, 0, 0], [0, 0, -2, 0], [0, 0, 0, -5]], [1, 0, 1, 1], [3, 9, -1, 2]),
        ([[-1, 1, 0, 0], [0, -1, 0, 0], [0, 0, -2, 0], [0, 0, 0, -5]], [1, 0, 1, 1], [0, 3, 1, 0]),
    ],
)
def test_a_peak_is_larger_than_every_sample_and_is_attained(rows, out, start):
    found, y = peak_of(rows, out, start)
    samples = np.abs(np.broadcast_to(sp.lambdify(t, y, "numpy")(np.linspace(0, 20, 40001)), 40001))
    assert abs(sp.N(y.subs(t, found.time) - found.value)) < 1e-12
    assert abs(float(found.value)) == pytest.approx(samples.max(), rel=1e-6)
    assert abs(float(found.value)) >= samples.max() * (1 - 1e-12)
    first = np.argmax(samples >= samples.max() * (1 - 1e-6)) * 20 / 40000
    assert float(found.time) == pytest.approx(first, abs=5e-3)


@pytest.mark.parametrize(
    ("rows", "out", "start"),
    [
        (DIAGONAL, [1, 1], [1, 1]),
        ([[-1]], [1], [1]),
        ([[0]], [1], [1]),
        ([[0, 1], [-4, 0]], [1, 0], [1, 0]),
        ([[0, 1, 0], [-2, -3, 2], [0, 0, 0]], [1, 0, 0], [0, 0, 1]),
        ([[1, 0], [0, -1]], [1, 1], [1, 1]),
        (DIAGONAL, [1, -3], [1, 1]),
        ([[-2, 1], [0, -2]], [1, 0], [-1, 3]),
    ],
)
def test_what_is_largest_at_the_start_or_in_the_limit_has_no_peak(rows, out, start):
    assert peak_of(rows, out, start)[0] is None


@pytest.mark.parametrize(
    ("rows", "out", "start"),
    [
        ([[0, 1], [-half, 1]], [1, 0], [0, 1]),
        ([[0, 1], [-half, -1]], [1, 0], [0, 1]),
        ([[half, 1], [0, half]], [1, 0], [0, 1]),
        ([[half, 1], [0, half]], [1, 0], [1, 5]),
        ([[0, 1, 0], [0, 0, 1], [0, 0, 0]], [1, 0, 0], [0, 0, 1]),
    ],
)
def test_the_peak_of_a_sequence_is_the_first_of_the_largest_samples(rows, out, start):
    found, _ = peak_of(rows, out, start, discrete=True)
    A, x, samples = sp.Matrix(rows), sp.Matrix(start), []
    for _ in range(12):
        samples.append((sp.Matrix([out]) * x)[0])
        x = A * x
    largest = max(map(abs, samples))
    assert found.time == [abs(each) for each in samples].index(largest)
    assert found.value == samples[int(found.time)]


def test_the_overshoot_of_a_step_with_parameters():
    zeta, omega = sp.Symbol("zeta", positive=True), sp.Symbol("omega", positive=True)
    sigma = sp.Symbol("sigma", positive=True)
    plant = system([[0, 1], [-(sigma**2 + omega**2), -2 * sigma]], B=[0, sigma**2 + omega**2], C=[[1, 0]])
    found = exact.response(plant, None, [sp.Integer(1)], t).y_peak
    assert sp.expand(found.time - sp.pi / omega) == 0
    assert abs(sp.N((found.value - 1 - exp(-sp.pi * sigma / omega)).subs({sigma: 2, omega: 3}))) < 1e-14
    undecided = system([[0, 1], [-1, -2 * zeta]], B=[0, 1], C=[[1, 0]])
    assert exact.response(undecided, None, [sp.Integer(1)], t).y_peak is None


@pytest.mark.parametrize(
    ("rows", "discrete", "value"),
    [
        (DIAGONAL, False, 6),
        ([[2]], False, sp.Rational(3, 2)),
        ([[0, 1], [-4, 0]], False, sp.Rational(round(100 * 2 * np.pi), 100)),
        ([[0]], False, 5),
        ([[half]], True, 8),
        ([[sp.Rational(4, 5)]], True, 22),
        ([[sp.Rational(99, 100)]], True, 40),
        ([[sp.Symbol("a")]], False, None),
    ],
)
def test_a_plot_shows_some_time_constants_or_turns(rows, discrete, value):
    n = len(rows)
    images = [between(sp.ImmutableMatrix(sp.eye(n)), M(rows), M([1] * n))]
    assert exact.horizon(images, discrete=discrete) == value
