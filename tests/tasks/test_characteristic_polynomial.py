"""The characteristic polynomial by both methods: numpy's coefficients, intermediate steps, corruptions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given

from solver import solve
from solver.derivation import Status
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

x = sp.Symbol("lamda")
METHODS = ("determinant", "faddeev_leverrier")


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        ([[0, 1], [-2, -3]], x**2 + 3 * x + 2),
        ([[5]], x - 5),
        ([[1, 0, -1], [-2, 2, -5], [0, 1, -1]], x**3 - 2 * x**2 + 4 * x - 5),
        ([[1, 2, 3], [0, 4, 5], [0, 0, 6]], sp.expand((x - 1) * (x - 4) * (x - 6))),
    ],
)
def test_textbook_polynomials(rows, expected, method):
    result = ask("characteristic_polynomial", system(rows), method)
    assert result.status is Status.VERIFIED, result.reason
    assert sp.expand(result.answers["polynomial"] - expected) == 0


@tried(25)
@given(systems(6))
def test_coefficients_are_numpys_and_the_methods_agree(A):
    polynomials = {ask("characteristic_polynomial", system(A), method).answers["polynomial"] for method in METHODS}
    assert len(polynomials) == 1
    ours = [float(c) for c in sp.Poly(polynomials.pop(), x).all_coeffs()]
    theirs = np.poly(np.array(A, dtype=float))
    assert np.allclose(ours, theirs, rtol=1e-6, atol=1e-6 * np.abs(theirs).max())


def test_the_recursion_of_faddeev_and_leverrier_ends_with_zero():
    result = ask("characteristic_polynomial", system([[0, 1], [-2, -3]]), "faddeev_leverrier")
    recursion = [step for step in result.steps if step.kind == "recursion"]
    assert [step.claims["coefficient"].right for step in recursion] == [3, 2]
    assert recursion[0].claims["next"].right == sp.Matrix([[3, 1], [-2, 0]])
    assert recursion[-1].claims["next"].right == sp.zeros(2)


def test_the_expansion_uses_the_row_with_most_zeros():
    result = ask("characteristic_polynomial", system([[1, 0, -1], [-2, 2, -5], [0, 1, -1]]), "determinant")
    expansion = next(step for step in result.steps if step.kind == "expansion")
    assert expansion.values["row"] == 0
    assert list(expansion.claims) == ["stated", "minors", "value"]


@pytest.mark.parametrize(
    "corrupt", [lambda p: -p, lambda p: p + 1, lambda p: p.subs(x, -x), lambda p: 2 * p, lambda p: p * x]
)
def test_corrupted_answers_are_rejected(corrupt):
    plant = system([[0, 1], [-2, -3]])
    polynomial = ask("characteristic_polynomial", plant).answers["polynomial"]
    assert not rejected("characteristic_polynomial", plant, {"polynomial": polynomial})
    assert rejected("characteristic_polynomial", plant, {"polynomial": sp.expand(corrupt(polynomial))})


def lines_of(find, A, detail="tutor"):
    return solve(f"title: t\nsystem: {{A: {A}, B: [0, 0, 1], C: [1, 0, 0]}}\nfind: {{a: {find}}}\n").markdown(
        detail=detail
    )


@pytest.mark.parametrize(
    ("A", "factors"),
    [
        ([[1, 0, 0], [1, -1, 1], [0, 0, -2]], r"(\lambda - 1)(\lambda + 1)(\lambda + 2)"),
        ([[1, 0, 0], [1, 0, 1], [0, -4, -2]], r"(\lambda - 1)(\lambda^{2} + 2\lambda + 4)"),
    ],
)
def test_factors_that_the_expansion_shows_are_not_multiplied_out_to_be_factored(A, factors):
    page = lines_of("eigenstructure", A)
    assert page.count(f"= {factors}") >= 1
    assert "Factor the polynomial" not in page
    assert r"\lambda^{3}" not in page


def test_a_factor_that_falls_apart_is_factored():
    assert "Factor the polynomial" in lines_of("eigenstructure", [[1, 0, 0], [1, 0, 1], [0, 2, -1]])


def test_the_polynomial_of_a_loop_in_companion_form_is_read_off():
    page = lines_of("{task: pole_placement, poles: [-1, -2, -3]}", [[0, 1, 0], [0, 0, 1], [-5, -10, -5]])
    assert "its last row holds the coefficients" in page
    assert "each with one of them only" in page
    assert "The minors" not in page
