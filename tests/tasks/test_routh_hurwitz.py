"""The criterion of Routh and Hurwitz: counts against the roots by numpy, special cases, conditions, corruptions."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.systems import Polynomial, StateSpace, TransferFunction
from tests.helpers.asking import ask, rejected

s, K = sp.Symbol("s"), sp.Symbol("K", real=True)
METHODS = ("array", "hurwitz_determinants")


def polynomial(p):
    return Polynomial(tuple(sp.Poly(p, s).all_coeffs()), s)


factors = st.lists(
    st.one_of(
        st.integers(-3, 3).map(lambda a: s - a),
        st.tuples(st.integers(-2, 2), st.integers(1, 5)).map(lambda pair: sp.expand((s - pair[0]) ** 2 + pair[1])),
    ),
    min_size=1,
    max_size=4,
)


@settings(max_examples=12)
@given(factors, st.sampled_from([1, -2, 3]), st.sampled_from(METHODS))
def test_the_counts_are_those_of_the_factors(listed, lead, method):
    p = polynomial(sp.expand(lead * sp.prod(listed)))
    roots = [root for factor in listed for root in np.roots([float(c) for c in sp.Poly(factor, s).all_coeffs()])]
    right = sum(1 for root in roots if root.real > 1e-9)
    on = sum(1 for root in roots if abs(root.real) <= 1e-9)
    result = ask("routh_hurwitz", p, method)
    assert result.status is Status.VERIFIED
    assert result.answers["right_half_plane_roots"] == right
    assert result.answers["imaginary_axis_roots"] == on
    assert result.answers["stable"] is (right == on == 0)
    (told,) = (step.values for step in result.steps if step.kind == "verdict")
    assert (told["outside"], told["on"], told["inside"]) == (right, on, len(roots) - right - on)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("p", "right", "on"),
    [
        (s**4 + s**3 + 2 * s**2 + 2 * s + 3, 2, 0),  # a zero in the first column
        (s**5 + 2 * s**4 + 24 * s**3 + 48 * s**2 - 25 * s - 50, 1, 2),  # a row of zeros
        (s**4 + 1, 2, 0),
        ((s**2 + 1) ** 2, 0, 4),
        (s**3 + 2 * s, 0, 3),
        (s**6 + s**5 + 5 * s**4 + s**3 + 2 * s**2 - 2 * s - 8, None, None),
        (s, 0, 1),
        (-s - 2, 0, 0),
    ],
)
def test_special_cases(method, p, right, on):
    result = ask("routh_hurwitz", polynomial(p), method)
    assert result.status is Status.VERIFIED
    if right is not None:
        assert (result.answers["right_half_plane_roots"], result.answers["imaginary_axis_roots"]) == (right, on)


def test_the_steps_of_both_methods():
    p = polynomial(s**5 + 2 * s**4 + 24 * s**3 + 48 * s**2 - 25 * s - 50)
    kinds = [step.kind for step in ask("routh_hurwitz", p, "array").steps]
    assert [kind for kind in kinds if kind != "row"] == [
        "first_rows", "zero_row", "array", "sign_changes", "symmetric", "verdict",
    ]  # fmt: skip
    kinds = [step.kind for step in ask("routh_hurwitz", polynomial(-(s**2) - s - K), "hurwitz_determinants").steps]
    assert kinds == ["lead", "matrix", "minors", "condition"]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("p", "condition"),
    [
        (s**4 + 2 * s**3 + 2 * s**2 + s + K, (K > 0) & (sp.Rational(3, 4) > K)),
        (s**3 + 3 * s**2 + K * s + 6, K > 2),
        (K * s**2 + s + 1, K > 0),
        (s**2 + K, sp.false),
        (s**2 + (K**2 + 1) * s + 1, sp.true),
    ],
)
def test_conditions_on_a_parameter(method, p, condition):
    result = ask("routh_hurwitz", polynomial(p), method)
    assert result.status is Status.VERIFIED
    for value in (-2.5, -0.3, 0.2, 0.6, 1.1, 3.7, 8.2):
        at = result.answers["condition"].subs(K, value)
        roots = np.roots([float(c.subs(K, value)) for c in sp.Poly(p, s).all_coeffs()])
        assert bool(at) == bool(condition.subs(K, value)) == bool((roots.real < -1e-12).all())


def test_only_the_parameter_asked_for_is_solved_for():
    a = sp.Symbol("a", positive=True)
    result = ask("routh_hurwitz", polynomial(s**2 + a * s + K), parameter=("K",))
    assert result.answers["condition"] == (K > 0)


def test_assumptions_decide_the_counts():
    a, b = sp.symbols("a b", positive=True)
    result = ask("routh_hurwitz", polynomial(s**2 + a * s + b))
    assert result.answers["stable"]
    assert result.answers["condition"] is sp.true


def test_plants_and_loops_are_asked_by_their_characteristic_polynomial():
    G = TransferFunction(sp.ImmutableMatrix([[1 / (s * (s + 1))]]), ((sp.Integer(1),),), ((s**2 + s,),), s)
    result = ask("routh_hurwitz", G, controller=1 / (s + 2), feedback=sp.Integer(1))
    assert [step.kind for step in result.steps][:3] == ["forward", "closed", "denominator"]
    assert result.answers["array"][:, 0].T.tolist() == [[1, 3, sp.Rational(5, 3), 1]]
    result = ask("routh_hurwitz", StateSpace(sp.ImmutableMatrix([[0, 1], [2, 1]])))
    assert result.answers["right_half_plane_roots"] == 1


def test_a_polynomial_stands_for_a_matrix_in_questions_of_stability():
    result = ask("stability", polynomial(2 * s**2 + 6 * s + 4))
    assert result.steps[0].kind == "companion"
    assert sorted(result.answers["eigenvalues"]) == [-2, -1]
    assert ask("stability_range", polynomial(s**3 + 3 * s**2 + K * s + 6)).answers["condition"] == (K > 2)


def test_corrupted_answers_are_rejected():
    p = polynomial(s**4 + 2 * s**3 + 3 * s**2 + 4 * s + 5)
    array = ask("routh_hurwitz", p, "array").answers["array"]
    determinants = ask("routh_hurwitz", p, "hurwitz_determinants").answers["determinants"]
    wrong = array.as_mutable()
    wrong[3, 0] = 6
    for answers in (
        {"array": sp.ImmutableMatrix(wrong)},
        {"array": sp.ImmutableMatrix(array[:-1, :])},
        {"determinants": [*determinants[:-1], -determinants[-1]]},
        {"determinants": determinants[:-1]},
        {"determinants": [determinants[1], determinants[2], determinants[0], determinants[3]]},
        {"right_half_plane_roots": sp.Integer(1)},
        {"imaginary_axis_roots": sp.Integer(2)},
        {"stable": True},
    ):
        assert rejected("routh_hurwitz", p, answers), answers
    q = polynomial(s**3 + 3 * s**2 + K * s + 6)
    for condition in (K > 3, K >= 2, K > -2, sp.true, (K > 2) & (K < 50)):
        assert rejected("routh_hurwitz", q, {"condition": condition}), condition
    assert not rejected("routh_hurwitz", q, {"condition": K > 2})
    assert not rejected("routh_hurwitz", p, {"array": array, "determinants": determinants, "stable": False})
