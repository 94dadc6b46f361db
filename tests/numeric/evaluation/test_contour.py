"""Inverse transforms with many digits: half of a circle where the other half is its mirror image, else the whole."""

import numpy as np
import pytest
import sympy as sp

from solver.numeric.evaluation.arithmetic import DOUBLE, multiple
from solver.numeric.evaluation.contour import turns
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.poles import poles_of
from solver.stated.algebra import difference, exponential, product, quotient, total
from solver.stated.matrices import inverse
from solver.stated.transforms import inverse_laplace, inverse_z

a, b, k, s, t, z = sp.symbols("a b k s t z")
A = sp.ImmutableMatrix([[0, 1], [-2, a]])
MANY = multiple(30)
REAL = {a: -3.0, t: 0.7, k: 4}


def value(formula, point, arithmetic=MANY):
    found = value_of(formula, Environment.at([point], arithmetic)).value
    return np.asarray(found, dtype=complex).ravel()


def number_of_nodes(image, point, arithmetic=MANY, time=t):
    return len(turns(Environment.at([point], arithmetic), image, time, 64).roots)


@pytest.mark.parametrize(
    ("image", "point"),
    [
        (1 / (s + a), REAL),
        (sp.ImmutableMatrix([[s / (s**2 + a**2), sp.Rational(1, 3) / s]]), REAL),
        (inverse(difference(product(s, sp.eye(2).as_immutable()), A)), REAL),
        (total(quotient(1, s + 1), product(a, 1 / (s + 2))), REAL),
    ],
)
def test_half_of_the_circle_is_enough_where_all_numbers_are_real(image, point):
    assert number_of_nodes(image, point) == 33
    assert number_of_nodes(image, point, DOUBLE) == 64


@pytest.mark.parametrize(
    ("image", "point"),
    [
        (1 / (s + sp.I), REAL),
        (1 / (s + a), {**REAL, a: 1 + 2j}),
        (1 / (s + sp.sqrt(a)), REAL),
        (sp.ImmutableMatrix([[1 / s, 1 / (s + 2 * sp.I)]]), REAL),
        (quotient(sp.I, s + 1), REAL),
        (product(exponential(a), 1 / (s + 1)), REAL),
        (1 / (s + 1), {**REAL, t: 0.3 + 0.1j}),
    ],
)
def test_the_whole_circle_is_gone_round_where_a_number_may_be_complex(image, point):
    assert number_of_nodes(image, point) == 64


def test_transforms_are_those_of_tables():
    of = {
        inverse_laplace(1 / (s + a), s, t): np.exp(3 * 0.7),
        inverse_laplace(1 / (s + sp.I), s, t): np.exp(-0.7j),
        inverse_laplace(2 / (s**2 + 4) + 1 / s**2, s, t): np.sin(1.4) + 0.7,
        inverse_laplace(1 / (s**2 + 2 * s + 5), s, t): np.exp(-0.7) * np.sin(1.4) / 2,
        inverse_z(z / (z - a), z, k): (-3.0) ** 4,
        inverse_z(z / (z - sp.I), z, k): 1,
    }
    for formula, wanted in of.items():
        assert np.allclose(value(formula, REAL), wanted, rtol=1e-13, atol=0)
        assert np.allclose(value(formula, REAL, DOUBLE), wanted, rtol=1e-11, atol=0)
    complex_pole = value(inverse_laplace(1 / (s + a), s, t), {a: 1 + 2j, t: 0.7})
    assert np.allclose(complex_pole, np.exp(-(1 + 2j) * 0.7), rtol=1e-13, atol=0)
    many = Environment.at([{t: 0.5, a: 1.0}, {t: 0.8, a: 2.0}, {t: 0.2, a: 1j}], MANY)
    found = np.asarray(value_of(inverse_laplace(1 / (s + a), s, t), many).value, dtype=complex)
    assert np.allclose(found, np.exp([-0.5, -1.6, -0.2j]), rtol=1e-13, atol=0)


def test_the_poles_come_in_the_order_of_the_formula():
    """Their mean is the centre of a circle, whose last digits must not depend on the order of a set."""
    image = sp.Mul(*(1 / (s + n) ** 2 for n in range(1, 9)), evaluate=False)
    found = [complex(pole) for poles in poles_of(image, s, Environment({}, 1)) for pole in poles]
    assert np.allclose(found, [-n for n in range(1, 9)])
