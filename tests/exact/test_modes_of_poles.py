"""Modes by their decay, natural frequency and damping, reductions: exact cases and what is refused."""

import pytest
import sympy as sp

from solver import exact


def test_modes_are_pairs_and_multiple_poles():
    found = exact.decay([sp.Integer(-3), sp.Integer(-3), -1 + 2 * sp.I, -1 - 2 * sp.I, sp.Integer(1)])
    assert [(mode.count, mode.rate, mode.sign) for mode in found.modes] == [(1, -1, -1), (2, 1, 1), (2, 3, 1)]
    a, b = sp.symbols("a b", positive=True)
    assert not exact.decay([-a, -b]).in_order
    assert exact.decay([-3 * a, -a]).modes[0].time_constant == 1 / a


def test_the_damping_of_a_polynomial():
    m, d, k = sp.symbols("m d k", positive=True)
    found = exact.damping_of((m, d, k))
    assert sp.cancel(found.zeta**2 - d**2 / (4 * k * m)) == 0
    cases = exact.damping_cases(found)
    assert cases.critical == 2 * sp.sqrt(k) * sp.sqrt(m)
    assert set(cases.where) == {"underdamped", "critically_damped", "overdamped"}
    with pytest.raises(exact.NoFrequency):
        exact.damping_of((sp.Integer(1), sp.Integer(2), sp.Integer(-3)))


@pytest.mark.parametrize("order", [1, 2, 3])
def test_a_reduction_keeps_the_value_at_zero(order):
    s = sp.Symbol("s")
    top, bottom = (s + 4) * 6, (s + 1) * (s + 2) * (s + 9) * (s + 20)
    G = exact.transfer_matrix_of_fractions([[sp.expand(top)]], [[sp.expand(bottom)]], s).reduced
    found = exact.reduction(exact.pole_zero_factors(G), order)
    assert found.function.subs(s, 0) == (top / bottom).subs(s, 0)
    assert found.poles_kept == [-1, -2, -9][:order]
    with pytest.raises(exact.NotReduced):
        exact.reduction(exact.pole_zero_factors(G), 4)
