"""Images taken apart, coefficients by hand, products for convolution, operators and values at 0+."""

import pytest
import sympy as sp

from solver import exact
from solver.exact import NotExact

s, t = sp.symbols("s t")
T = sp.Symbol("T", positive=True)


def test_an_improper_image_is_a_polynomial_and_a_proper_rest():
    image = exact.rational_image((s**3 + 5) / (s + 1) ** 2, s)
    assert image.polynomial(s) == s - 2
    assert sp.cancel(image.rest(s) - (3 * s + 7) / (s + 1) ** 2) == 0


def test_dead_times_are_told_apart_and_put_in_order():
    terms = exact.read_image((1 - sp.exp(-s)) ** 2 / s + sp.exp(-T * s) / (s + 1), s)
    assert [each.delay for each in terms] == [0, 1, 2, T]
    assert [each.image.whole for each in terms] == [1 / s, -2 / s, 1 / s, 1 / (s + 1)]


@pytest.mark.parametrize("F", [sp.sqrt(s), sp.exp(s) / s, 1 / (1 + sp.exp(-s)), sp.exp(-s * sp.Symbol("b", real=True))])
def test_other_images_are_refused(F):
    with pytest.raises(NotExact):
        exact.read_image(F, s)


def test_a_quotient_with_parameters_has_no_fraction_in_it():
    K = sp.Symbol("K", real=True)
    assert exact.rational_image(K / (s * (T * s + 1)), s).whole == K / (s * (T * s + 1))


def test_numerators_over_powers_of_a_quadratic_by_division():
    image = exact.rational_image((s**3 + 2 * s + 1) / (s * (s**2 + 1) ** 2), s).proper
    found = exact.divided_again(image, s)
    whole = sum(
        each / found.base**k for k, each in ((2, found.divisions[0].remainder), (1, found.divisions[-1].quotient))
    )
    assert sp.cancel(whole + sum(found.known) - image.expression(s)[0]) == 0


def test_numerators_over_several_quadratics_by_comparison():
    image = exact.rational_image(1 / ((s**2 + 1) ** 2 * (s**2 + 4)), s).proper
    found = exact.compared_at_all(image, s)
    values = dict(zip(found.letters, found.values, strict=True))
    assert all(sp.expand(right.xreplace(values) - left) == 0 for _, left, right in found.equations)
    assert len(found.equations) == 6


def test_factors_for_convolution_multiply_to_the_image():
    for F in (1 / ((s + 1) * (s + 2)), (s + 2) / (s**2 * (s + 1)), s / (s**2 + 4) ** 2, 1 / (s + 1) ** 3):
        factors = exact.factors_for_convolution(exact.rational_image(F, s), s)
        assert len(factors) > 1
        assert sp.cancel(sp.Mul(*factors) - F) == 0
        assert all(sp.degree(sp.fraction(each)[0], s) < sp.degree(sp.fraction(each)[1], s) for each in factors)
    assert exact.factors_for_convolution(exact.rational_image(1 / (s + 1), s), s) == ()


def test_operators_with_the_values_at_the_start():
    x, v, w, u, du = sp.symbols("x x_dot x_ddot u u_dot", real=True)
    jets = {x: ("x", 0), v: ("x", 1), w: ("x", 2), u: ("u", 0), du: ("u", 1)}
    found = exact.operators_of([w + 3 * v + 2 * x - du - u], jets, ["x"], ["u"], s)
    assert found.P[0] == s**2 + 3 * s + 2
    assert found.Q[0] == s + 1
    assert found.initial_part({("x", 0): sp.Integer(1), ("x", 1): sp.Integer(5)})[0] == s + 8
    with pytest.raises(NotExact):
        exact.operators_of([x * v], jets, ["x"], ["u"], s)
    with pytest.raises(NotExact):
        exact.operators_of([x, 2 * x], jets | {sp.Symbol("y", real=True): ("y", 0)}, ["x", "y"], [], s)


def test_values_just_after_the_start():
    assert exact.values_after((s + 3) / (s * (s + 2)), 3, s) == (True, (1, 1, -2))
    regular, _ = exact.values_after(s / (s + 1), 1, s)
    assert not regular
