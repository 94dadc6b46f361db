"""How claims are judged: entry by entry, at admissible points, and never in silence."""

import itertools
import math

import pytest
import sympy as sp

from solver.derivation import Check, CheckStatus, Claim, Step
from solver.numeric import check_claim, check_residual, check_steps
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.points import PointSource, free_symbols, whole_symbols
from solver.numeric.evaluation.values import NotEvaluable
from solver.stated.algebra import exponential, power, product
from solver.stated.matrices import determinant
from solver.stated.transforms import inverse_laplace, inverse_z

a, b, k, s, t, x = sp.symbols("a b k s t x")
positive = sp.Symbol("m", positive=True)
negative = sp.Symbol("n_", negative=True)
whole = sp.Symbol("n", integer=True)


def status(left, right, **options):
    return check_claim(Claim(left, right), "", **options).status


@pytest.mark.parametrize("small", [sp.Rational(1, 10**6), sp.Rational(1, 10**9)])
@pytest.mark.parametrize("wrong", [sp.Rational(1001, 1000), -1, 2, 0])
def test_a_small_entry_beside_large_ones_is_judged_by_its_own_size(small, wrong):
    M = sp.Matrix([[10**6, small * a], [10**3, 1]])
    other = sp.Matrix([[10**6, small * a * wrong], [10**3, 1]])
    assert status(M, sp.Matrix(M)) is CheckStatus.PASSED
    assert status(product(M, sp.eye(2)), other) is CheckStatus.FAILED


def test_a_zero_that_only_rounding_fills_is_a_zero_and_a_small_number_is_not():
    zero = (a + b) ** 5 - sum(sp.binomial(5, i) * a**i * b ** (5 - i) for i in range(6))
    assert status(zero, 0) is CheckStatus.PASSED
    assert status(10**8 * zero, 0) is CheckStatus.PASSED
    assert status(zero + sp.Rational(1, 10**9), 0) is CheckStatus.FAILED
    assert status(zero + sp.Rational(1, 10**20), sp.Rational(2, 10**20)) is CheckStatus.FAILED
    assert status(10**8 * zero, sp.Rational(1, 10**20)) is CheckStatus.FAILED


@pytest.mark.parametrize("digits", [30, 45])
def test_what_rounding_hides_from_few_digits_is_decided_by_more(digits):
    zero = 10**digits * ((a + b) ** 5 - sum(sp.binomial(5, i) * a**i * b ** (5 - i) for i in range(6)))
    assert status(zero, 0) is CheckStatus.PASSED
    assert status(zero, sp.Rational(1, 10**9)) is CheckStatus.FAILED
    assert status(zero * sp.Float("1.5", 15), sp.Rational(1, 10**9)) is not CheckStatus.PASSED


def test_a_number_without_symbols_is_compared_once_and_exactly_enough():
    assert status(sp.sqrt(2) * sp.sqrt(3), sp.sqrt(6)) is CheckStatus.PASSED
    assert status(sp.sqrt(2), sp.Rational(14142135, 10**7)) is CheckStatus.FAILED


def test_points_respect_what_is_assumed_of_a_symbol():
    assert status(sp.sqrt(positive**2), positive) is CheckStatus.PASSED
    assert status(sp.sqrt(negative**2, evaluate=False), -negative) is CheckStatus.PASSED
    assert status(sp.sqrt(a**2), a) is CheckStatus.FAILED
    assert status(sp.cos(sp.pi * whole, evaluate=False), (-1) ** whole) is CheckStatus.PASSED
    assert status(sp.cos(sp.pi * x, evaluate=False), (-1) ** x) is CheckStatus.FAILED
    assert status(sp.cos(sp.pi * x, evaluate=False), (-1) ** x, integers=frozenset({"x"})) is CheckStatus.PASSED


def test_parameters_are_real_and_transform_variables_are_complex():
    assert status(sp.Abs(a) ** 2, a**2) is CheckStatus.PASSED
    assert status(sp.Abs(s) ** 2, s**2) is CheckStatus.FAILED
    assert all(0.1 <= point[t].real <= 1.5 for point in PointSource([t]).several(20))


def test_points_are_the_same_in_every_run_and_in_any_order_of_symbols():
    assert PointSource([a, b, s]).several(3) == PointSource({s, b, a}).several(3)
    assert PointSource([a]).several(1) == PointSource([a]).several(1)


def test_discrete_time_is_told_from_a_stiffness_by_where_it_stands():
    assert whole_symbols((-2) ** k) == {k}
    assert whole_symbols(a**k * sp.cos(k)) == {k}
    assert whole_symbols(sp.KroneckerDelta(k, 0)) == {k}
    assert whole_symbols(power(sp.eye(2), k)) == {k}
    assert whole_symbols(inverse_z(1 / (s - 1), s, k)) == {k}
    assert whole_symbols(sp.exp(-k * t) + sp.sqrt(k) + k**2) == frozenset()
    assert 0 in [point[k] for point in PointSource([k], {k}).several(5)]


def test_a_wrong_delta_at_zero_is_seen():
    assert status(0**k, sp.KroneckerDelta(k, 0)) is CheckStatus.PASSED
    assert status(2**k - sp.KroneckerDelta(k, 0), 2**k, integers=frozenset({"k"})) is CheckStatus.FAILED


def test_bound_variables_are_not_free():
    assert free_symbols(inverse_laplace(a / s, s, t)) == {a, t}
    assert free_symbols([product(a, sp.Matrix([b])), 1]) == {a, b}


def test_a_point_without_a_value_is_replaced_by_another():
    first = PointSource([a]).draw()[a]
    pole = sp.Rational(first)
    claim = Claim((a**2 - pole**2) / (a - pole), a + pole)
    assert check_claim(claim, "").status is CheckStatus.PASSED
    assert check_claim(Claim(claim.left, a - pole), "").status is CheckStatus.FAILED


def test_values_beyond_every_floating_point_number_are_told_apart():
    assert status(sp.exp(10**4 * t), sp.exp(10**4 * t)) is CheckStatus.PASSED
    assert status(sp.exp(10**4 * t), t) is CheckStatus.FAILED
    assert status(t, 2 * sp.exp(10**4 * t)) is CheckStatus.FAILED
    assert status(sp.exp(10**4 * t), 2 * sp.exp(10**4 * t)) is not CheckStatus.PASSED


def test_a_residual_that_is_no_number_is_the_worst():
    assert worst_of([0.0, 1e-12]) == 1e-12
    assert worst_of([0.0, math.nan, 1e-12]) == math.inf


def test_a_claim_without_a_value_anywhere_is_skipped_with_the_reason():
    check = check_claim(Claim(1 / (a - a * sp.Float(1)), a), "nowhere")
    assert check.status is CheckStatus.SKIPPED
    assert check.reason


def test_decimals_are_judged_by_the_digits_they_carry():
    root = sp.sqrt(2)
    assert status(root.evalf(15), root) is CheckStatus.PASSED
    assert status(a**2 - root.evalf(15) ** 2, a**2 - 2) is CheckStatus.PASSED
    assert status(a**2 * root.evalf(5), a**2 * root) is CheckStatus.PASSED
    assert status(a**2 * sp.Float("1.4150", 5), a**2 * root) is CheckStatus.FAILED
    assert status(root.evalf(15) + sp.Rational(1, 10**8), root) is CheckStatus.FAILED


def test_one_by_one_and_scalar_are_the_same_and_other_shapes_are_not():
    assert status(sp.Matrix([[a]]), a) is CheckStatus.PASSED
    check = check_claim(Claim(sp.Matrix([[a, a]]), a), "")
    assert check.status is CheckStatus.FAILED
    assert "shapes" in check.reason


def test_empty_matrices_agree():
    assert status(sp.Matrix(2, 0, []), sp.Matrix(2, 0, [])) is CheckStatus.PASSED
    assert status(sp.Matrix(2, 0, []), sp.Matrix(0, 2, [])) is CheckStatus.FAILED


def test_the_oracle_is_named():
    oracles = {
        check_claim(claim, "", shown=True).oracle
        for claim in (
            Claim(a + a, 2 * a),
            Claim(determinant(sp.eye(2) * a), a**2),
            Claim(exponential(sp.eye(2) * a), sp.exp(a) * sp.eye(2)),
            Claim(inverse_laplace(1 / s, s, t), 1),
        )
    }
    assert oracles == {"random points", "numpy.linalg.det", "scipy.linalg.expm", "contour integral"}


def test_the_claims_of_steps_and_substeps_are_checked_in_order():
    inner = Step("inner", claims={"c": Claim(a, b, "third")})
    outer = Step("outer", claims={"a": Claim(a, a), "b": Claim(a, a, "second")}, steps=(inner,))
    checks = check_steps([outer, Step("none", unclaimed="nothing to check")])
    assert [check.claim for check in checks] == ["outer: a", "second", "third"]
    assert [check.status.value for check in checks] == ["passed", "passed", "failed"]


def test_a_residual_that_can_not_be_found_gives_a_skipped_check():
    def refuses():
        raise NotEvaluable("no rule")

    assert check_residual("c", "o", refuses).status is CheckStatus.SKIPPED
    assert check_residual("c", "o", lambda: 1e-12).status is CheckStatus.PASSED
    assert check_residual("c", "o", lambda: float("nan")).status is CheckStatus.FAILED


def test_ill_conditioned_claims_of_order_ten_are_decided_with_more_digits():
    n = 10
    H = sp.Matrix(n, n, lambda i, j: sp.Rational(1, i + j + 1))
    exact = H.det()
    assert status(determinant(H), exact) is CheckStatus.PASSED
    assert status(determinant(H), exact * sp.Rational(1001, 1000)) is CheckStatus.FAILED
    assert "50 digits" in check_claim(Claim(determinant(H), exact), "").oracle


@pytest.mark.parametrize(("i", "j"), list(itertools.product(range(3), repeat=2)))
def test_a_change_of_any_single_entry_is_seen(i, j):
    M = sp.Matrix(3, 3, lambda p, q: (a + p) / (b + q + 3))
    other = M.copy()
    other[i, j] *= 1 + sp.Rational(1, 10**7)
    assert status(M, other) is CheckStatus.FAILED


def test_a_difference_as_large_as_allowed_is_no_error():
    assert Check.within("a", "b", 0.0, 0.0).status is CheckStatus.PASSED
    assert Check.within("a", "b", 1e-9, 1e-9).status is CheckStatus.PASSED
    assert Check.within("a", "b", 1.1e-9, 1e-9).status is CheckStatus.FAILED
    assert Check.within("a", "b", float("nan"), 1e-9).status is CheckStatus.FAILED
