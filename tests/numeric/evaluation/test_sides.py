"""Entries of an equality by themselves: the same values as in the whole, and judged no less."""

from importlib import import_module
from pkgutil import iter_modules

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm

from solver.derivation import CheckStatus, Claim
from solver.numeric import check_claim
from solver.numeric.evaluation import operations
from solver.numeric.evaluation.arithmetic import DOUBLE, multiple
from solver.numeric.evaluation.sides import Sides
from solver.stated.algebra import difference, power, product, quotient, total
from solver.stated.calculus import derivative, integral, value_at
from solver.stated.matrices import determinant, inverse
from solver.stated.transforms import inverse_laplace, inverse_z

k, s, t, x, z = sp.symbols("k s t x z")
M = sp.ImmutableMatrix([[s, 1 / (s + 1), 2], [s**2, 3 - s, 1 / (s + 2)]])
N = sp.ImmutableMatrix([[1, s, 2], [3, 5, s + 7]])
IMAGES = sp.ImmutableMatrix([[1 / (s + 1), s / (s**2 + 4)], [1 / (s + 3) ** 2, 5 / (s - 1)]])

TAKEN_APART = {
    "total": total(M, N),
    "difference": difference(M, total(N, M)),
    "quotient": quotient(N, s + 4),
    "product": product(2, quotient(1, s + 3), N, s),
    "inverse_laplace": inverse_laplace(IMAGES, s, t),
    "inverse_z": inverse_z(IMAGES.subs(s, z), z, k),
    "derivative": derivative(M, s, 2),
    "integral": integral(N, s, 0, x),
    "value_at": value_at(M, s, x + 1),
}
POINT = {s: 0.7 + 0.4j, t: 0.6, x: 1.3, z: 0.8j, k: 3}


def companion(n):
    """The companion matrix of (x + 1)(x + 2)…(x + n)."""
    low = sp.Poly(sp.prod([x + i for i in range(1, n + 1)]), x).all_coeffs()[:0:-1]
    return sp.Matrix(n, n, lambda i, j: -low[j] if i == n - 1 else int(j == i + 1))


def values(formula, arithmetic):
    return np.asarray(Sides(formula, 0).values([POINT], arithmetic)[0].value, dtype=complex).ravel()


@pytest.mark.parametrize("operation", TAKEN_APART)
@pytest.mark.parametrize("arithmetic", [DOUBLE, multiple(30)])
def test_entries_by_themselves_have_the_values_of_the_whole(operation, arithmetic):
    formula = TAKEN_APART[operation]
    whole = values(formula, arithmetic)
    chosen = [len(whole) - 1, 1]
    some = Sides(formula, formula).of_entries(chosen, len(whole))
    assert np.allclose(values(some.left, arithmetic), whole[chosen], rtol=1e-13, atol=0)
    assert some.left == some.right != formula


def test_every_operation_that_says_it_acts_on_entries_is_tried():
    modules = [import_module(f"{operations.__name__}.{each.name}") for each in iter_modules(operations.__path__)]
    entrywise = {module.__name__.rpartition(".")[2] for module in modules if getattr(module, "ENTRYWISE", False)}
    assert entrywise == set(TAKEN_APART)


def test_a_product_that_is_a_column_needs_some_rows_of_its_first_factor_only():
    formula = total(product(2, N.T, M, sp.Matrix([1, s, s**2])), sp.Matrix([s, 1, 2]))
    some = Sides(formula, sp.Matrix([0, 0, 0])).of_entries([2, 0], 3)
    assert some.left.operands[0].operands[1].shape == (2, 2)
    assert np.allclose(values(some.left, multiple(30)), values(formula, multiple(30))[[2, 0]], rtol=1e-13, atol=0)


@pytest.mark.parametrize(
    "formula",
    [
        product(N, N.T),
        product(total(N, M), sp.Matrix([1, 2, 3])),
        product(determinant(N * N.T), N),
        inverse(sp.Matrix([[s, 1], [2, s]])),
        total(N, sp.Matrix([[1, 2]])),
        power(sp.Matrix([[s, 1], [2, s]]), 3),
        [s, 1, 2],
    ],
)
def test_what_needs_more_than_an_entry_is_left_whole(formula):
    assert Sides(formula, N).of_entries([0, 1], 6) is None
    assert Sides(N, formula).of_entries([0, 1], 6) is None


def test_each_small_entry_beside_large_ones_is_judged_by_many_digits():
    A = companion(6)
    resolvent = (s * sp.eye(6) - A).inv().applyfunc(sp.factor)
    Phi = (sp.eye(6) * 0).as_mutable()
    for root in range(-6, 0):
        Phi += resolvent.applyfunc(lambda entry, at=root: sp.cancel((s - at) * entry).subs(s, at)) * sp.exp(root * t)
    stated = inverse_laplace(sp.ImmutableMatrix(resolvent), s, t)
    assert check_claim(Claim(stated, sp.ImmutableMatrix(Phi)), "", shown=True).status is CheckStatus.PASSED
    assert np.allclose(sp.lambdify(t, Phi)(0.4), expm(0.4 * np.array(A, dtype=float)), rtol=1e-9, atol=0)
    for i, j in [(0, 5), (1, 0), (5, 5)]:
        wrong = Phi.copy()
        wrong[i, j] *= 1 + sp.Rational(1, 10**8)
        assert check_claim(Claim(stated, sp.ImmutableMatrix(wrong)), "", shown=True).status is CheckStatus.FAILED
