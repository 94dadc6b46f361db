"""Linear factors multiplied out as on paper: the polynomial is that of numpy, and every line holds."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.arithmetic.factors import factors_multiplied
from solver.numeric import check_steps
from solver.render.wording import Wording

TUTOR = Wording(detail="tutor")
s, p, q = sp.symbols("s p q")
j = sp.I


def displayed(steps):
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


def failures(steps):
    return [check for check in check_steps(steps) if check.status != "passed"]


def test_conjugate_factors_come_first_and_become_two_squares():
    shown = displayed(factors_multiplied(s, [sp.S(-1), -1 + 2 * j, -1 - 2 * j]))
    assert "(s + 1 - 2j)(s + 1 + 2j) = (s + 1)^{2} + 2^{2} = s^{2} + 2s + 5" in shown
    assert "(s^{2} + 2s + 5)(s + 1) = s^{3} + s^{2} + 2s^{2} + 2s + 5s + 5 = s^{3} + 3s^{2} + 7s + 5" in shown


def test_two_real_factors_need_only_a_look():
    assert factors_multiplied(s, [sp.S(-1), sp.S(-2)]) == ()


@pytest.mark.parametrize(
    "roots",
    [
        [p, q, sp.S(-1)],
        [-p + q * j, -p - q * j],
        [-sp.sqrt(2) + j, -sp.sqrt(2) - j, sp.sqrt(3)],
        [sp.Float("-1.0664", 30) + sp.Float("1.704", 30) * j, sp.Float("-1.0664", 30) - sp.Float("1.704", 30) * j],
        [sp.S(0), sp.S(0), j, -j],
        [1 + j, 2 - j, sp.S(3)],
    ],
)
def test_every_line_holds(roots):
    steps = factors_multiplied(s, roots)
    assert steps
    assert not failures(steps)
    assert displayed(steps)


@given(st.lists(st.integers(-6, 6), min_size=3, max_size=5), st.tuples(st.integers(-4, 4), st.integers(1, 4)))
def test_the_last_line_is_the_polynomial_of_numpy(real, pair):
    sigma, omega = pair
    roots = [*map(sp.Integer, real), sigma + omega * j, sigma - omega * j]
    last = factors_multiplied(s, roots)[-1]
    found = sp.Poly(last.claims[f"collected{last.values['count'] - 1}"].right, s).all_coeffs()
    assert np.allclose(np.array(found, dtype=float), np.poly([complex(root) for root in roots]).real)
