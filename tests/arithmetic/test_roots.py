"""Roots found by trial and divided out, even polynomials, and what is left: the roots are numpy's, every line holds."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.arithmetic.factors import one_after_the_other
from solver.arithmetic.roots import factored, roots_found, values_at
from solver.numeric import check_steps
from solver.render.wording import Wording

TUTOR = Wording(detail="tutor")
s, K = sp.symbols("s K")


def displayed(steps):
    assert [check for check in check_steps(steps) if check.status != "passed"] == []
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


def found(p):
    return factored(sp.expand(p), sp.factor(p), s)


def test_a_root_is_put_in_and_divided_out_from_the_highest_power_down():
    shown = displayed(found(s**3 + 3 * s**2 + 4 * s + 2))
    assert r"(-1)^{3} + 3(-1)^{2} + 4(-1) + 2 = 0" in shown
    assert "= s^{2}(s + 1) + 2s(s + 1) + 2(s + 1) = (s + 1)(s^{2} + 2s + 2)" in shown


def test_an_even_polynomial_is_a_quadratic_in_the_square():
    shown = displayed(found((s**2 - 4) * (s**2 - 1)))
    assert "$4$ and $1$ have the sum $5$ and the product $4$" in shown
    assert "s^{4} - 5s^{2} + 4 = (s^{2} - 4)(s^{2} - 1)" in shown


def test_or_the_difference_of_two_squares():
    assert "s^{4} + 4 = (s^{2} + 2)^{2} - (2s)^{2} = (s^{2} + 2s + 2)(s^{2} - 2s + 2)" in displayed(found(s**4 + 4))


def test_a_quadratic_of_small_whole_numbers_needs_only_a_look():
    assert found((s + 1) * (s + 2)) == ()
    assert r"\frac{625}{4} - 150" in displayed(found((s + 10) * (s + 15)))


def test_nothing_is_shown_of_parameters_and_of_what_has_no_factors():
    assert found((s + K) * (s**2 + s + 1)) == ()
    assert found(s**3 + s + 1) == ()


@given(st.lists(st.fractions(-5, 5, max_denominator=3), min_size=3, max_size=4), st.integers(1, 9))
def test_the_roots_are_numpys(real, c):
    p = sp.expand(sp.Mul(*(s - sp.Rational(root) for root in real)) * (s**2 + s + c))
    steps = found(p)
    displayed(steps)
    shown = [float(step.values["root"]) for step in steps if step.kind == "root"]
    roots = np.roots([float(a) for a in sp.Poly(p, s).all_coeffs()])
    assert all(min(abs(roots - root)) < 1e-2 for root in shown)
    assert len(shown) == sum(root != 0 for root in real)


@pytest.mark.parametrize("p", [s**2 + 5 * s + 7, s**2 + sp.sqrt(2) * s + 1, s**3 + 2 * s**2 + 3 * s + 2])
def test_a_pair_that_is_left_is_found_by_the_formula(p):
    roots = [root for root, m in sp.roots(p, s).items() for _ in range(m)]
    assert r"\frac{b^{2}}{4} - c" in displayed(roots_found(p, roots, s))


def test_values_and_products():
    assert r"1^{3} - 1.2 \cdot 1^{2} + 0.1 = -0.1" in displayed(
        values_at(s**3 - sp.Float("1.2", 30) * s**2 + sp.Float("0.1", 30), s, [sp.S.One])
    )
    assert one_after_the_other(s, [[1, 1], [1, 2]]) == ()
    shown = displayed(one_after_the_other(s, [[sp.S(1), sp.S(1)], [sp.S(1), sp.S(2), sp.S(5)]]))
    assert "(s + 1)(s^{2} + 2s + 5) = s^{3} + 2s^{2} + 5s + s^{2} + 2s + 5" in shown
