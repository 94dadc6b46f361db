"""Inputs as sums of terms: put together again they are what was read, at many times, by sympy's own evaluation."""

import pytest
import sympy as sp

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.time_response.signals import read_signal, written

t, k = sp.Symbol("t"), sp.Symbol("k")
a, b = sp.Symbol("a", positive=True), sp.Symbol("b", positive=True)
u, impulse = sp.Heaviside, sp.DiracDelta
cos, sin, exp = sp.cos, sp.sin, sp.exp

CONTINUOUS = [
    3,
    t**3 - 2 * t + 5,
    (t + 1) ** 4,
    2 * exp(-3 * t + 1),
    sp.Integer(2) ** (3 * t - 1),
    sin(2 * t + sp.pi / 3),
    cos(sp.pi / 6 - 3 * t),
    sin(1 - t),
    sin(3 * t) * cos(2 * t),
    cos(2 * t) * sin(3 * t),
    sin(3 * t) * sin(2 * t),
    cos(3 * t) * cos(2 * t),
    cos(2 * t) * cos(3 * t),
    sin(2 * t) * sin(3 * t),
    sin(t) ** 3,
    t**2 * exp(-t) * sin(t) * cos(t),
    sp.sinh(2 * t) + sp.cosh(t - 1),
    (1 + t) * (2 - exp(-t)),
    u(t - 2),
    u(2 - t),
    u(2 * t - 3) * (t - sp.Rational(3, 2)),
    u(t + 1),
    u(-1 - t) + 4,
    u(1 - 2 * t) * exp(-t),
    u(t - 1) * u(t - 3) + u(t - 2) * u(3 - t),
    u(t) - u(t - 1),
]


def put_together(signal, x, at, *, discrete):
    begun = [(delay, c * written(term, x, discrete=discrete)) for (delay, term), c in signal.terms.items()]
    steps = sum((value.subs(x, at) for delay, value in begun if at >= delay), sp.Integer(0))
    return steps + (sum(w for delay, w in signal.impulses.items() if delay == at) if discrete else 0)


@pytest.mark.parametrize("expression", CONTINUOUS, ids=str)
def test_a_function_of_time_is_what_was_read(expression):
    expression = sp.sympify(expression)
    signal = read_signal(expression, t, discrete=False)
    for at in map(sp.Rational, ("1/7", "3/4", "8/5", "17/7", "23/5")):
        assert abs(sp.N(expression.subs(t, at) - put_together(signal, t, at, discrete=False), 30)) < 1e-25


DISCRETE = [
    4,
    k**2 - 3,
    sp.Rational(1, 2) ** k * k,
    sp.Integer(2) ** (1 - 2 * k),
    exp(-k / 2),
    cos(sp.pi * k),
    cos(2 * sp.pi * k) + sin(sp.pi * k),
    sin(5 * sp.pi * k / 3),
    cos(5 * sp.pi * k / 3 + 1),
    sin(k) * cos(sp.pi * k),
    cos(sp.pi * k / 2) ** 2,
    u(k - 3) * k,
    u(3 - k),
    u(2 * k - 4) * u(5 - k),
    u(k + 2),
]


@pytest.mark.parametrize("expression", DISCRETE, ids=str)
def test_a_sequence_is_what_was_read(expression):
    """A step is one where its argument is zero: the sample belongs to it."""
    expression = sp.sympify(expression)
    signal = read_signal(expression, k, discrete=True)
    for at in map(sp.Integer, range(8)):
        value = expression.replace(u, lambda argument, _: sp.Piecewise((1, argument >= 0), (0, True))).subs(k, at)
        assert abs(sp.N(value - put_together(signal, k, at, discrete=True), 30)) < 1e-25, at


@pytest.mark.parametrize(
    ("expression", "impulses"),
    [
        (impulse(t), {0: 1}),
        (impulse(2 * t - 4), {2: sp.Rational(1, 2)}),
        (impulse(4 - 2 * t), {2: sp.Rational(1, 2)}),
        (t**2 * impulse(t - 3), {3: 9}),
        (impulse(t - 3) * exp(-t), {3: exp(-3)}),
        (u(t - 1) * impulse(t - 3), {3: 1}),
        (u(t - 4) * impulse(t - 3), {}),
        (impulse(t + 1), {}),
        (impulse(t - a), {a: 1}),
    ],
)
def test_an_impulse_weighs_what_it_integrates_to(expression, impulses):
    assert dict(read_signal(expression, t, discrete=False).impulses) == impulses


def test_a_sample_is_weighed_by_the_value_there():
    signal = read_signal((k + 1) * impulse(k - 3) + impulse(k), k, discrete=True)
    assert dict(signal.impulses) == {3: 4, 0: 1}
    assert signal.delays == [3, 0] or signal.delays == [0, 3]


@pytest.mark.parametrize(
    ("expression", "kind"),
    [
        (sp.log(t), "no_rational_transform"),
        (1 / t, "no_rational_transform"),
        (sp.sqrt(t), "no_rational_transform"),
        (exp(t**2), "no_rational_transform"),
        (sin(t**2), "no_rational_transform"),
        (t**13, "no_rational_transform"),
        (t**12 * t, "no_rational_transform"),
        (t**7 * (t + 1) ** 6, "high_power"),
        (sp.I * t, "not_real"),
        (exp(sp.I * t), "not_real"),
        (u(sp.Symbol("c") * t - 1), "direction_of_time"),
        (u(t - sp.Symbol("c")), "before_or_after_the_start"),
        (u(t - a) * u(t - b), "later_of_two_steps"),
        (impulse(t - 1) * impulse(t - 2), "product_of_impulses"),
        (u(t - 1) * impulse(t - 1), "impulse_at_a_step"),
        (u(t - a) * impulse(t - b), "step_or_impulse_first"),
    ],
)
def test_what_has_no_such_sum_is_refused_by_kind(expression, kind):
    with pytest.raises(NotExact) as refused:
        read_signal(expression, t, discrete=False)
    assert refused.value.reason.kind == f"signals/{kind}"


def test_a_step_between_samples_is_refused():
    with pytest.raises(NotExact) as refused:
        read_signal(u(2 * k - 3), k, discrete=True)
    assert refused.value.reason.kind == "signals/between_samples"
    assert refused.value.reason.values["delay"] == sp.Rational(3, 2)


def test_later_of_steps_with_parameters():
    signal = read_signal(u(t - a) * u(t - a - b), t, discrete=False)
    assert signal.delays == [a + b]
    assert read_signal(u(t - a - b) * u(t - a), t, discrete=False).delays == [a + b]
