"""Fields of entries with roots, exponentials, sines and cosines of parameters: ranks against those of numbers."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

import solver
from solver.exact.linear_algebra.fields import NotExact, domain_matrix, matrix_of, side_by_side

a, b = sp.symbols("a b", positive=True)
k, theta = sp.symbols("k theta", real=True)
UNITS = [sp.Integer(1), sp.sqrt(2), a, b, k, sp.sqrt(a), 1 / sp.sqrt(b), sp.exp(-k), sp.exp(k / 2), sp.sin(theta),
         sp.cos(theta), sp.sin(2 * theta), a * sp.sqrt(a)]  # fmt: skip
AT = {a: 0.7312, b: 1.3717, k: -0.4129, theta: 0.9137}
ENTRIES = st.lists(st.tuples(st.integers(-2, 2), st.sampled_from(UNITS), st.sampled_from(UNITS)), max_size=2)


def numbers(M):
    return np.array(M.xreplace(AT).evalf(20).tolist(), dtype=float)


@settings(max_examples=15, deadline=None)
@given(st.lists(ENTRIES, min_size=2, max_size=2), st.lists(ENTRIES, min_size=2, max_size=2))
def test_the_rank_of_a_product_is_that_of_its_numbers(left, right):
    """A column times a row: of rank one at most, as its determinant in the field must say."""
    L, R = (sp.Matrix(*size, [sum((c * x * y for c, x, y in e), sp.S.Zero) for e in entries])
            for size, entries in (((2, 1), left), ((1, 2), right)))  # fmt: skip
    M = L * R
    field = domain_matrix(M)
    assert field.rank() == np.linalg.matrix_rank(numbers(M), tol=1e-9)
    assert np.allclose(numbers(matrix_of(field)), numbers(M))


@pytest.mark.parametrize(
    "M",
    [
        [[sp.sqrt(2 * a), a], [2, sp.sqrt(2 * a)]],
        [[k * sp.exp(-k), 1], [k, sp.exp(k)]],
        [[sp.sin(2 * theta), sp.sin(theta)], [2 * sp.cos(theta), 1]],
        [[sp.cos(theta), sp.sin(theta / 2) ** 2], [1, (1 - sp.cos(theta)) / (2 * sp.cos(theta))]],
    ],
)
def test_what_is_singular_is_not_taken_for_regular(M):
    assert domain_matrix(sp.Matrix(M)).rank() == 1


def test_a_root_beside_its_square_in_another_matrix():
    x, y = side_by_side(sp.Matrix([[sp.sqrt(a)]]), sp.Matrix([[a]]))
    assert (x * x - y).is_zero_matrix


def test_a_plant_with_roots_beside_parameters_and_numbers():
    text = """assume: {h: positive, g: positive, a: positive, S: positive}
system: {A: [["-a sqrt(2g)/(2S sqrt(h))", 0], ["a sqrt(2g)/(2S sqrt(h))", "-exp(-g) g"]], B: ["1/S", h], C: [0, 1]}
find: {a: transfer_function, b: controllability}
"""
    assert [part.status for part in solver.solve(text).parts] == ["verified"] * 2


@pytest.mark.parametrize("functions", [(sp.exp,), (sp.sin, sp.cos), (sp.exp, sp.sin)])
def test_functions_of_decimals_have_no_field(functions):
    rates = (sp.Float("0.341"), sp.Float("-0.682"))
    entries = [f(rate * k) * rate for f in functions for rate in rates]
    for M in (sp.Matrix([entries]), sp.Matrix([[*entries, sp.sqrt(2)]])):
        with pytest.raises(NotExact):
            domain_matrix(M)


def test_a_number_with_powers_of_e_below_a_line_is_one_fraction():
    e = sp.exp(-2)
    M = sp.ImmutableMatrix([[(1 + e) / 4, sp.Rational(1, 2) - e / 4 + e**2 / 4], [(1 - e) / 2, (e - e**2) / 2]])
    inverse = matrix_of(domain_matrix(M).inv())
    for entry, exactly in zip(inverse.flat(), M.evalf(40).inv().flat(), strict=True):
        assert entry.is_Mul
        assert not any(
            power.base.is_Add and power.exp.is_negative for term in sp.fraction(entry) for power in term.atoms(sp.Pow)
        )
        assert abs(entry.evalf(30) - exactly) < sp.Float("1e-25")
    assert matrix_of(domain_matrix(M)) == M
