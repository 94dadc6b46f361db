"""Machine equations, their scaling, and the largest sizes of their variables."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from solver import exact, numeric
from solver.derivation import Check, CheckStatus
from solver.postconditions.analog import _sizes, of_largest_size

x, v, u, y = sp.symbols("x x_dot u y", real=True)
t, tau, beta = sp.Symbol("t"), sp.Symbol("tau"), sp.Symbol("beta", positive=True)


def driven(value=None, start=(0, 0)):
    """x'' + x' + 4x = u with y = 2x + u."""
    return exact.machine_equations({x: v, v: -4 * x - v + u}, list(map(sp.Integer, start)), {y: 2 * x + u}, {u: value})


def test_functions_of_time_are_terms_of_their_own():
    found = driven(5 - 3 * sp.sin(2 * t))
    assert found.integrated[1].terms == {x: -4, v: -1, sp.S.One: 5, sp.sin(2 * t): -3}
    assert found.summed[0].terms == {x: 2, sp.S.One: 5, sp.sin(2 * t): -3}
    assert found.inputs == ()


def test_what_is_no_linear_combination_is_told():
    with pytest.raises(exact.NotLinearCombination):
        exact.machine_equations({x: x * v, v: -x}, [sp.S.Zero] * 2, {}, {})


def test_each_coefficient_is_scaled_by_its_rule():
    L1, L2, Ly = sp.symbols("L1 L2 Ly", positive=True)
    found = exact.scaled(driven(start=(3, -2)), exact.Scaling({x: L1, v: L2, y: Ly}, beta))
    X1, X2, Y = sp.symbols("X1 X2 Y", real=True)
    assert [each.variable for each in found.integrated] == [X1, X2]
    assert found.integrated[0].terms == {X2: L1 / (L2 * beta)}
    assert found.integrated[1].terms == {X1: -4 * L2 / (L1 * beta), X2: -1 / beta, u: L2 / beta}
    assert [each.initial for each in found.integrated] == [3 * L1, -2 * L2]
    assert found.summed[0].variable == Y
    assert found.summed[0].terms == {X1: 2 * Ly / L1, u: Ly}


def test_steps_and_waves_run_in_the_machine_time():
    found = exact.scaled(
        driven(sp.Heaviside(t) + sp.Heaviside(t - 2) + sp.cos(3 * t)), exact.Scaling({}, sp.Integer(2))
    )
    assert set(found.integrated[1].terms) >= {sp.S.One, sp.Heaviside(tau - 4), sp.cos(3 * tau / 2)}


def test_a_variable_that_stays_zero_has_factor_one():
    assert exact.scale_factors({x: sp.Integer(4), v: sp.S.Zero}, sp.Integer(10)) == {x: sp.Rational(5, 2), v: 1}


@pytest.mark.parametrize(
    ("value", "start", "kind"),
    [
        (sp.Integer(8), (0, 0), "peak"),
        (sp.Integer(8), (2, 0), "start"),
        (sp.sin(2 * t), (0, 0), "swing"),
        (sp.Integer(4) - 4 * sp.Heaviside(t - 1), (0, 0), "peak"),
    ],
)
def test_no_sample_is_larger_than_the_largest_size(value, start, kind):
    equations = driven(value, start)
    found = exact.largest_size(equations, {x: sp.S.One})
    motion = exact.motions_of(equations)[x]
    assert found.kind == kind or kind == "swing"
    samples = np.abs(numeric.values_at(motion, t, np.arange(600) / 50 + 1 / 999))
    assert float(found.value) * (1 - 1e-2) <= max(samples) <= float(found.value) * (1 + 1e-9)


def test_several_frequencies_are_searched_over_their_period():
    equations = exact.machine_equations({x: v, v: -x + u}, [sp.S.Zero] * 2, {}, {u: sp.sin(2 * t)})
    found = exact.largest_size(equations, {v: sp.S.One})
    assert np.isclose(float(found.value), 4 / 3, rtol=1e-12)
    with pytest.raises(exact.Unsearched):
        exact.largest_size(exact.machine_equations({x: v, v: -2 * x + u}, [sp.S.Zero] * 2, {}, {u: sp.sin(t)}), {x: 1})


@pytest.mark.parametrize(("rate", "value"), [(x, None), (-u + u, t), (sp.S.Zero, sp.Integer(1))])
def test_what_grows_has_no_largest_size(rate, value):
    equations = exact.machine_equations({x: rate + (u if value is not None else 0)}, [sp.S.One], {}, {u: value})
    with pytest.raises(exact.Unbounded):
        exact.largest_size(equations, {x: sp.S.One})


def chain(n):
    """A companion plant with the eigenvalues −1 … −n, driven by 1: its motion is a difference of large terms."""
    states = sp.symbols(f"x1:{n + 1}", real=True)
    low = sp.Poly(sp.prod([beta + i for i in range(1, n + 1)]), beta).all_coeffs()[:0:-1]
    last = u - sum(c * each for c, each in zip(low, states, strict=True))
    rates = dict(zip(states, [*states[1:], last], strict=True))
    return states, exact.machine_equations(rates, [sp.S.Zero] * n, {}, {u: sp.S.One})


def test_what_is_sampled_of_a_long_chain_is_no_larger():
    states, equations = chain(9)
    terms = {states[-1]: sp.S.One}
    found = exact.largest_size(equations, terms)
    assert all(each.status is CheckStatus.PASSED for each in postcondition(found, equations, terms))
    smaller = replace(found, value=found.value * sp.Rational(4, 5))
    assert postcondition(smaller, equations, terms)[0].status is CheckStatus.FAILED


def test_samples_are_taken_with_more_digits_where_terms_cancel():
    states, equations = chain(9)
    motion = exact.largest_size(equations, {states[0]: sp.S.One}).motion
    times = np.array([0.01, 0.3, 2.0])
    expected = [abs(float(sp.N(motion.subs(t, sp.Rational(each)), 15))) for each in times]
    assert np.allclose(_sizes(motion, times, 1e-22), expected, rtol=1e-11, atol=0)


def postcondition(found, equations, terms):
    return [each for each in of_largest_size(found, equations, terms) if isinstance(each, Check)]


def test_parameters_leave_the_largest_size_open():
    with pytest.raises(exact.Undecided):
        exact.largest_size(exact.machine_equations({x: -beta * x}, [sp.S.One], {}, {}), {x: sp.S.One})
