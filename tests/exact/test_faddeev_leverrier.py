"""χ and adj against sympy's determinant and adjugate, and the resolvent against its definition."""

import pytest
import sympy as sp

from solver import exact
from tests.helpers.exact_cases import COMPLEX, EXACT, NUMERIC, RATIONAL, SURD, each, x

c, d, m = sp.symbols("c d m", positive=True)
PARAMETERS = {
    "mass, spring, damper": sp.ImmutableMatrix([[0, 1], [-c / m, -d / m]]),
    "three parameters": sp.ImmutableMatrix([[c, 1, 0], [0, d, 1], [m, 0, 1]]),
}


@pytest.mark.parametrize("A", **each(NUMERIC | PARAMETERS))
def test_the_characteristic_polynomial_is_the_determinant(A):
    expected = (x * sp.eye(A.rows) - A).det(method="berkowitz")
    assert sp.expand(exact.faddeev_leverrier(A).characteristic_polynomial(x) - expected) == 0


@pytest.mark.parametrize("A", **each(NUMERIC | PARAMETERS))
def test_the_adjugate_times_the_pencil_is_the_determinant_times_the_identity(A):
    found = exact.faddeev_leverrier(A)
    pencil = x * sp.eye(A.rows) - A
    product = sp.Matrix(found.adjugate(x)) * pencil
    assert (product - found.characteristic_polynomial(x) * sp.eye(A.rows)).expand() == sp.zeros(A.rows)


@pytest.mark.parametrize("A", **each(NUMERIC | PARAMETERS))
def test_the_coefficients_obey_the_recursion(A):
    found = exact.faddeev_leverrier(A)
    N, coefficients = found.adjugate_coefficients, found.coefficients
    assert N[0] == sp.eye(A.rows)
    assert coefficients[0] == 1
    for i in range(A.rows):
        following = A * N[i] + coefficients[i + 1] * sp.eye(A.rows)
        expected = N[i + 1] if i + 1 < A.rows else sp.zeros(A.rows)
        assert sp.expand(coefficients[i + 1] + (A * N[i]).trace() / (i + 1)) == 0
        assert (following - expected).applyfunc(sp.cancel) == sp.zeros(A.rows)


@pytest.mark.parametrize("A", **each(NUMERIC | {"mass, spring, damper": PARAMETERS["mass, spring, damper"]}))
def test_the_resolvent_inverts_the_pencil(A):
    check_resolvent(A)


def test_the_resolvent_needs_no_roots():
    check_resolvent(PARAMETERS["three parameters"])


def check_resolvent(A):
    product = sp.Matrix(exact.resolvent(A, x)) * (x * sp.eye(A.rows) - A)
    residual = (product - sp.eye(A.rows)).applyfunc(lambda e: sp.expand(sp.numer(sp.together(e))))
    assert residual == sp.zeros(A.rows)


@pytest.mark.parametrize("A", **each(RATIONAL | COMPLEX))
def test_entries_of_the_resolvent_are_in_lowest_terms(A):
    for entry in exact.resolvent(A, x):
        numerator, denominator = sp.fraction(entry)
        assert sp.gcd(sp.Poly(numerator, x), sp.Poly(denominator, x)).degree() == 0


def test_denominators_of_the_resolvent_are_factored():
    A = EXACT["companion of a triple root"]
    assert sp.denom(exact.resolvent(A, x)[0, 3]) == (x + 1) ** 3 * (x + 2)


@pytest.mark.parametrize("A", **each(RATIONAL | COMPLEX | SURD))
def test_the_factored_polynomial_multiplies_out_to_the_polynomial(A):
    found = exact.faddeev_leverrier(A).characteristic_polynomial(x)
    assert sp.expand(exact.factored(A, x) - found) == 0


def test_the_factored_polynomial_shows_powers():
    assert exact.factored(EXACT["companion of a triple root"], x) == (x + 1) ** 3 * (x + 2)


@pytest.mark.parametrize("A", **each({name: A for name, A in NUMERIC.items() if A.det() != 0}))
def test_the_inverse_times_the_matrix_is_the_identity(A):
    assert (exact.inverse(A) * A - sp.eye(A.rows)).applyfunc(lambda e: sp.radsimp(sp.expand(e))) == sp.zeros(A.rows)


@pytest.mark.parametrize("name", ["zero", "a nilpotent block", "zero, one by one"])
def test_a_singular_matrix_has_no_inverse(name):
    with pytest.raises(ZeroDivisionError, match="singular"):
        exact.inverse(RATIONAL[name])


@pytest.mark.parametrize("A", **each(EXACT))
def test_determinant_and_adjugate_are_those_of_sympy(A):
    det, adj = exact.determinant_and_adjugate(A)
    assert sp.expand(det - A.det(method="berkowitz")) == 0
    assert (adj - A.adjugate()).expand() == sp.zeros(A.rows)
