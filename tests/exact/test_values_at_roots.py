"""Roots of x⁴ + bx² + c and polynomials at them, integer roots, elements at conjugate roots: against numbers."""

import mpmath
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.exact import spectrum
from solver.exact.linear_algebra.biquadratic import (
    LARGEST,
    biquadratic_roots,
    multiplied,
    powers_at,
    root_of_product,
    tidied,
)
from solver.exact.linear_algebra.instances import squares_of_roots, value_at
from solver.exact.linear_algebra.integers import small_integer_roots
from solver.exact.linear_algebra.spectrum import roots_of, split_over
from tests.helpers.exact_cases import companion
from tests.helpers.tried import tried

x = sp.Symbol("x")
a, p = sp.Symbol("a", positive=True), sp.Symbol("p", positive=True)
whole = st.integers(-12, 12)


def values_of(found):
    """All roots of the locations, as complex numbers."""
    roots = []
    for each in found:
        shift = each.shift if each.real else sp.I * each.shift
        roots += [each.sigma + shift] if each.real else [each.sigma + shift, each.sigma - shift]
    return roots


def same(found, expected):
    """Whether two lists hold the same complex numbers."""
    left = [complex(each) for each in found]
    for z in map(complex, expected):
        nearest = min(left, key=lambda other: abs(other - z), default=None)
        if nearest is None or abs(nearest - z) > 1e-9 * (1 + abs(z)):
            return False
        left.remove(nearest)
    return not left


@tried(60)
@given(whole, whole.filter(bool))
def test_roots_of_even_quartics_are_roots(b, c):
    if not sp.Poly(x**4 + b * x**2 + c, x).is_irreducible:
        return
    found = biquadratic_roots(sp.Integer(b), sp.Integer(c))
    if found is None:
        return
    assert same(values_of(found), mpmath.polyroots([1, 0, b, 0, c], maxsteps=200, extraprec=100))
    real = [each.shift for each in found if each.real]
    assert real == sorted(real)
    assert all(bool(each.shift > 0) for each in found if not each.real)
    assert all(n.p <= LARGEST for each in values_of(found) for n in each.atoms(sp.Rational))


@pytest.mark.parametrize(
    ("b", "c", "real", "pairs"),
    [(4, 1, 0, 2), (-4, 1, 4, 0), (1, -3, None, None), (0, 1, 0, 2), (0, -2, 2, 1), (-2, 9, 0, 2), (1, 2, None, None)],
)
def test_which_even_quartics_have_short_roots(b, c, real, pairs):
    found = biquadratic_roots(sp.Integer(b), sp.Integer(c))
    if real is None:
        assert found is None
    else:
        assert [sum(each.real for each in found), sum(not each.real for each in found)] == [real, pairs]


@pytest.mark.parametrize(
    ("b", "c"), [(a, a**2), (0, a**4), (-2 * a, 9 * a**2), (0, -(a**4)), (5 * a**2, 4 * a**4 * p**0), (-4 * a, a**2)]
)
def test_roots_with_a_parameter_are_roots_at_its_values(b, c):
    found = biquadratic_roots(sp.sympify(b), sp.sympify(c))
    assert found is not None
    for value in (sp.Rational(1, 3), sp.Integer(2)):
        right = [sp.sympify(each).subs({a: value, p: 1}) for each in (1, 0, b, 0, c)]
        roots = [sp.N(each.subs({a: value, p: 1}), 20) for each in values_of(found)]
        assert same(
            roots, mpmath.polyroots([mpmath.mpf(each.p) / each.q for each in right], maxsteps=200, extraprec=200)
        )


@tried(40)
@given(st.lists(whole, min_size=2, max_size=5), st.sampled_from([(4, 1), (-4, 1), (0, 1), (-2, 9), (0, -2)]))
def test_a_polynomial_at_a_root(listed, even):
    b, c = even
    coefficients = [sp.Integer(each) for each in listed]
    for each in biquadratic_roots(sp.Integer(b), sp.Integer(c)):
        sigma, omega = (each.sigma + each.shift, sp.S.Zero) if each.real else (each.sigma, each.shift)
        real, imaginary = powers_at(coefficients, sigma, omega)
        z = complex(sigma) + 1j * complex(omega)
        expected = sum(n * z**i for i, n in enumerate(listed))
        assert abs(complex(real) + 1j * complex(imaginary) - expected) < 1e-9 * (1 + abs(expected))


@tried(40)
@given(
    st.sampled_from([x**2 + 2 * x + 5, x**2 - 3, x - 7, x**3 + x + 1, x**4 + 4 * x**2 + 1, x**2 + a * x + a**2, x + a]),
    st.lists(whole, min_size=1, max_size=3),
)
def test_an_element_at_every_root_of_its_factor(modulus, listed):
    polynomial = sp.Poly(modulus, x).to_field()
    listed = listed[: polynomial.degree()]
    for root in roots_of(polynomial):
        found = value_at([sp.Integer(each) for each in listed], root)
        expected = sum(n * root.value**i for i, n in enumerate(listed))
        assert abs(sp.N((found - expected).subs(a, sp.Rational(3, 7)), 20)) < 1e-15
        assert abs(sp.N(modulus.subs(x, root.value).subs(a, sp.Rational(3, 7)), 20)) < 1e-15


@pytest.mark.parametrize(("b", "c"), [(4, 1), (-4, 1), (0, 1), (-2, 9), (0, -2)])
def test_the_squares_of_the_roots_of_an_even_quartic(b, c):
    (factor,) = spectrum(companion(x**4 + b * x**2 + c)).factors
    assert same(map(complex, squares_of_roots(factor)), mpmath.polyroots([1, b, c]))


@tried(60)
@given(
    st.lists(st.one_of(st.integers(-5, 5), st.sampled_from([-99, 99, 100, -100])), max_size=4),
    st.sampled_from([[1], [1, 0, 1], [1, 1, 1], [2, 1], [1, 0, -2]]),
)
def test_integer_roots_are_found_with_their_multiplicity(roots, rest):
    polynomial = sp.Poly(sp.Mul(*(x - root for root in roots)) * sp.Poly(rest, x).as_expr(), x)
    found, left = small_integer_roots([sp.QQ(int(each)) for each in polynomial.all_coeffs()])
    assert found == sorted(root for root in roots if abs(root) <= 99)
    product = sp.Poly(sp.Mul(*(x - root for root in found)), x) * sp.Poly(
        [sp.Rational(int(e.numerator), int(e.denominator)) for e in left], x
    )
    assert product == polynomial


@tried(40)
@given(
    st.lists(st.tuples(st.integers(-4, 4), st.sampled_from([1, 2, 3, 5]), st.integers(0, 2)), min_size=1, max_size=4)
)
def test_sums_of_roots_times_a_parameter_keep_their_value(terms):
    value = sp.Add(*(n * sp.sqrt(root) * a**power / (a + 1) for n, root, power in terms))
    other = sp.Add(*(n * sp.sqrt(root) * a**power for n, root, power in terms[:2]))
    at = {a: sp.Rational(5, 7)}
    assert abs(sp.N((tidied(value) - value).subs(at), 20)) < 1e-15
    assert abs(sp.N((multiplied(value, other) - value * other).subs(at), 20)) < 1e-13


@pytest.mark.parametrize("square", [(3 - sp.sqrt(5)) / 2, 2 * a**2, (7 + 4 * sp.sqrt(3)) * a**2 / p, sp.Integer(12), a])
def test_the_root_of_a_product(square):
    found = root_of_product(square)
    assert abs(sp.N((found**2 - square).subs({a: 3, p: 5}), 20)) < 1e-15
    assert sp.N(found.subs({a: 3, p: 5})) > 0


def test_a_factor_splits_over_a_field_that_holds_its_roots():
    (factor,) = spectrum(companion((x**2 - 2) ** 2)).factors
    left, right = split_over(factor, sp.QQ.algebraic_field(sp.sqrt(2)))
    assert [[(root.value, root.multiplicity) for root in each.roots] for each in (left, right)] == [
        [(-sp.sqrt(2), 2)],
        [(sp.sqrt(2), 2)],
    ]
    assert split_over(factor, factor.modulus.domain) == (factor,)
    (whole,) = split_over(factor, sp.QQ.algebraic_field(sp.sqrt(3)))
    assert whole.degree == 2
