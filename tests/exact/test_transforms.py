"""Partial fractions sum up to the resolvent; transform pairs are right by sympy and by series."""

import pytest
import sympy as sp

from solver import exact
from solver.stated import Stated
from tests.helpers.exact_cases import DECIMAL, EXACT, NUMERIC, RATIONAL, companion, each, x

s, t, z, k = sp.symbols("s t z k")
PLACES = [sp.Rational(7, 3), sp.Rational(11, 5), -sp.Rational(13, 2)]


def value(stated, at):
    """A product of a fraction and a matrix, carried out at a number."""
    if isinstance(stated, Stated):
        parts = [value(each_part, at) for each_part in stated.operands]
        if stated.operation == "quotient":
            return parts[0] / parts[1]
        assert stated.operation == "product"
        return parts[0] * parts[1]
    return stated.subs(s, at)


@pytest.mark.parametrize("A", **each(NUMERIC))
def test_the_partial_fractions_sum_up_to_the_inverse(A):
    terms = exact.partial_fractions(A, s)
    for at in PLACES:
        total = sum((value(term, at) for term in terms), sp.zeros(A.rows))
        expected = (at * sp.eye(A.rows) - A).inv()
        assert max(abs(sp.N(entry, 30)) for entry in total - expected) < 1e-24


@pytest.mark.parametrize("A", **each(NUMERIC))
def test_no_partial_fraction_is_zero(A):
    assert all(any(term.operands[1]) for term in exact.partial_fractions(A, s))


def by_sympy(function, at):
    """The Laplace transform of a sum of t^m e^{σt} cos, sin as its integral, at a number right of all poles."""
    return sp.laplace_transform(function, t, s, noconds=True).subs(s, at)


@pytest.mark.parametrize("A", **each(EXACT))
def test_laplace_pairs_are_those_of_sympy(A):
    for image, function in exact.transform_pairs(A, s, t, discrete=False):
        for at in (sp.Rational(31, 2), sp.Integer(9)):
            assert abs(sp.N(by_sympy(function, at) - image.subs(s, at), 20)) < 1e-15


@pytest.mark.parametrize("A", **each(EXACT | DECIMAL))
def test_z_pairs_are_right_by_their_series(A):
    """F(z) = Σ f(k) z⁻ᵏ: the coefficients of F(1/w) in powers of w."""
    w = sp.Symbol("w")
    for image, function in exact.transform_pairs(A, z, k, discrete=True):
        numerator, denominator = (sp.Poly(part, w) for part in sp.fraction(sp.together(image.subs(z, 1 / w))))
        for index, coefficient in enumerate(series(numerator, denominator, 6)):
            assert abs(sp.N(function.subs(k, index) - coefficient, 20)) < 1e-12


def series(numerator, denominator, count):
    """The first coefficients of a quotient of polynomials, by long division."""
    above, below = numerator.all_coeffs()[::-1], denominator.all_coeffs()[::-1]
    shift = next(i for i, c in enumerate(below) if c != 0)
    assert all(c == 0 for c in above[:shift])
    above, below = above[shift:] + [0] * count, below[shift:] + [0] * count
    found = []
    for i in range(count):
        found.append((above[i] - sum(below[i - l] * found[l] for l in range(i))) / below[0])
    return found


def test_pairs_of_a_damped_oscillation():
    pairs = exact.transform_pairs(companion(x**2 + 2 * x + 5), s, t, discrete=False)
    p = s**2 + 2 * s + 5
    expected = [((s + 1) / p, sp.exp(-t) * sp.cos(2 * t)), (2 / p, sp.exp(-t) * sp.sin(2 * t))]
    assert pairs == expected


def test_pairs_of_a_double_root():
    pairs = exact.transform_pairs(RATIONAL["triangular and defective"], s, t, discrete=False)
    assert pairs[:2] == [(1 / (s - 1), sp.exp(t)), (1 / (s - 1) ** 2, t * sp.exp(t))]


def test_only_pairs_that_occur_are_listed():
    pairs = exact.transform_pairs(RATIONAL["a multiple of the identity"], s, t, discrete=False)
    assert pairs == [(1 / (s - 5), sp.exp(5 * t))]


@pytest.mark.parametrize("A", **each(EXACT))
def test_what_is_put_together_is_what_sympy_would_make_of_it(A):
    """An expression in another order, or with terms not joined, would not be equal to the same one elsewhere."""
    for M in (exact.resolvent(A, s), exact.exponential(A, t).matrix):
        for entry in M.flat():
            for node in sp.preorder_traversal(entry):
                if isinstance(node, sp.Add | sp.Mul):
                    assert node.func(*node.args).args == node.args
