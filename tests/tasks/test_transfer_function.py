"""Transfer functions: the course's values, python-control or numpy, poles and zeros, corruptions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.signal import ss2tf

from solver.derivation import CheckStatus, Status
from tests.helpers.asking import ask, rejected, system
from tests.helpers.fractions_of_polynomials import plant, s, z
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

METHODS = ("adjugate", "faddeev_leverrier")
M = sp.Matrix
COURSE = system([[1, 0, -1], [-2, 2, -5], [0, 1, -1]], B=[[0], [1], [0]], C=[[0, 1, 1]], D=[[2]])
TWO_BY_TWO = system([[-1, 0, 0], [0, -2, 0], [0, 0, -3]], B=[[1, 0], [0, 1], [1, 1]], C=[[1, 0, 1], [0, 1, 0]])


@pytest.mark.parametrize("method", METHODS)
def test_the_course_example(method):
    result = ask("transfer_function", COURSE, method)
    assert result.status is Status.VERIFIED, result.reason
    expected = (s**2 + s - 2) / (s**3 - 2 * s**2 + 4 * s - 5) + 2
    assert sp.cancel(result.answers["G"] - expected) == 0


def test_the_adjugate_of_the_course_example_is_shown():
    steps = {step.kind: step for step in ask("transfer_function", COURSE, "adjugate").steps}
    expected = M([[s**2 - s + 3, -1, 2 - s], [-2 * s - 2, s**2 - 1, 7 - 5 * s], [-2, s - 1, s**2 - 3 * s + 2]])
    assert (steps["adjugate"].claims["adjugate"].right - expected).expand() == sp.zeros(3)
    assert sp.expand(steps["numerator"].claims["product"].right - (s**2 + s - 2)) == 0
    assert [*steps][-5:] == ["numerator", "through", "quotient", "cancel", "poles_zeros"]


def test_both_methods_give_the_same_expression():
    first, second = (ask("transfer_function", TWO_BY_TWO, method).answers for method in METHODS)
    assert first == second


def test_a_cancelled_mode_is_named():
    answers = ask("transfer_function", system([[0, 1], [-2, -3]], B=[[0], [1]], C=[[1, 1]])).answers
    assert (answers["G"], answers["poles"], answers["zeros"], answers["cancelled"]) == (1 / (s + 2), [-2], [], [-1])


def test_transmission_zeros_are_not_zeros_of_entries():
    answers = ask("transfer_function", TWO_BY_TWO).answers
    assert sorted(answers["poles"]) == [-3, -2, -1]
    assert answers["zeros"] == [-2]


def test_multiple_poles_of_a_transfer_matrix_count_by_its_minors():
    answers = ask("transfer_function", system(-sp.eye(2), B=sp.eye(2), C=sp.eye(2))).answers
    assert answers["poles"] == [-1, -1]
    answers = ask("transfer_function", system(-sp.eye(2), B=[[1, 0], [1, 0]], C=[[1, 0], [1, 0]])).answers
    assert (answers["poles"], answers["cancelled"]) == ([-1], [-1])


def test_one_channel_of_several():
    result = ask("transfer_function", TWO_BY_TWO, input=1, output=0)
    assert result.answers["G"] == 1 / (s + 3)
    assert sorted(result.answers["cancelled"]) == [-2, -1]


def test_a_fraction_is_brought_to_lowest_terms():
    result = ask("transfer_function", plant(2 * s + 4, 2 * s**2 + 10 * s + 12))
    assert (result.answers["G"], result.answers["cancelled"]) == (1 / (s + 3), [-2])
    assert result.status is Status.VERIFIED


def test_a_factor_with_a_root_in_it_cancels():
    result = ask("transfer_function", plant(s + sp.sqrt(2), s**2 - 2))
    assert sp.cancel(result.answers["G"] - 1 / (s - sp.sqrt(2))) == 0
    assert (result.answers["poles"], result.answers["cancelled"]) == ([sp.sqrt(2)], [-sp.sqrt(2)])
    reduced = ask("minimal_realization", plant(s + sp.sqrt(2), s**2 - 2))
    assert (reduced.status, reduced.answers["A"]) == (Status.VERIFIED, M([[sp.sqrt(2)]]))


def test_discrete_systems_use_z():
    result = ask("transfer_function", system([[0, 1], [-6, -5]], B=[[0], [1]], C=[[2, 1]], discrete=True))
    assert result.answers["G"] == 1 / (z + 3)
    assert result.status is Status.VERIFIED


def test_parameters_have_no_fractions_within_fractions():
    m, d, k = sp.symbols("m d k")
    result = ask("transfer_function", system([[0, 1], [-k / m, -d / m]], B=[[0], [1 / m]], C=[[1, 0]]))
    assert result.answers["G"] == 1 / (m * s**2 + d * s + k)


def test_poles_without_a_formula_are_left_out():
    a, b = sp.symbols("a b")
    result = ask("transfer_function", system([[0, 1, 0], [0, 0, 1], [-a, -b, -1]], B=[[0], [0], [1]], C=[[1, 0, 0]]))
    assert result.status is Status.VERIFIED, result.reason
    assert "poles" not in result.answers
    assert result.answers["G"] == 1 / (s**3 + s**2 + b * s + a)


def test_a_path_without_states_in_it_is_zero():
    result = ask("transfer_function", system([[-1, 0], [0, -2]], B=[[1], [0]], C=[[0, 1]]))
    assert (result.answers["G"], result.answers["poles"]) == (0, [])
    assert result.status is Status.VERIFIED, result.reason


@tried(12)
@given(systems(4), st.data())
def test_scipy_finds_the_same_coefficients(A, data):
    n = A.rows
    small = st.integers(-2, 2)
    B = M(n, 1, lambda i, j: data.draw(small))
    C = M(1, n, lambda i, j: data.draw(small))
    D = M([[data.draw(small)]])
    for method in METHODS:
        result = ask("transfer_function", system(A, B=B, C=C, D=D), method)
        assert result.status is Status.VERIFIED, result.reason
        assert {check.status for check in result.checks} == {CheckStatus.PASSED}
        top, bottom = ss2tf(*(np.array(X, dtype=float) for X in (A, B, C, D)))
        for point in (0.7 + 1.3j, -3.1 + 0.4j):
            expected = np.polyval(top[0], point) / np.polyval(bottom, point)
            assert np.isclose(complex(result.answers["G"].subs(s, point)), expected, rtol=1e-7, atol=1e-7)
        assert len(result.answers["poles"]) + len(result.answers["cancelled"]) == n


@tried(8)
@given(systems(3), st.data())
def test_transfer_matrices_of_random_plants(A, data):
    n, small = A.rows, st.integers(-2, 2)
    B = M(n, 2, lambda i, j: data.draw(small))
    C = M(2, n, lambda i, j: data.draw(small))
    result = ask("transfer_function", system(A, B=B, C=C))
    assert result.status is Status.VERIFIED, result.reason
    expected = C * (s * sp.eye(n) - A).inv() * B
    assert (result.answers["G"] - expected).applyfunc(sp.cancel) == sp.zeros(2)


WRONG = [
    ("G", lambda G: -G),
    ("G", lambda G: G * sp.Rational(1001, 1000)),
    ("G", lambda G: G.subs(s, -s)),
    ("poles", lambda poles: poles[:-1]),
    ("poles", lambda poles: [-pole for pole in poles]),
    ("poles", lambda poles: [*poles, -7]),
    ("zeros", lambda zeros: []),
    ("zeros", lambda zeros: [zero + sp.Rational(1, 1000) for zero in zeros]),
    ("zeros", lambda zeros: [*zeros, zeros[0]]),
    ("cancelled", lambda cancelled: [*cancelled, -1]),
    ("cancelled", lambda cancelled: [each + sp.Rational(1, 3) for each in cancelled] or [0]),
]


@pytest.mark.parametrize(("name", "corrupt"), WRONG)
@pytest.mark.parametrize(
    "given_plant",
    [
        system([[0, 1, 0], [0, 0, 1], [-6, -11, -6]], B=[[0], [0], [1]], C=[[4, 5, 1]]),
        system([[-1, 0, 0], [0, -2, 0], [0, 0, -3]], B=[[1, 0], [0, 1], [1, 1]], C=[[1, 0, 1], [0, 1, 0]]),
        plant((s + 3) * (s + 5), (s + 1) * (s + 2) * (s + 3)),
    ],
)
def test_corrupted_answers_are_rejected_each_alone(given_plant, name, corrupt):
    right = ask("transfer_function", given_plant).answers[name]
    assert not rejected("transfer_function", given_plant, {name: right})
    assert rejected("transfer_function", given_plant, {name: corrupt(right)})


def test_zeros_of_a_plant_that_is_not_square():
    tall = system([[0, 1], [-2, -3]], B=[[0], [1]], C=[[3, 1], [6, 2]])  # both entries vanish at s = −3
    assert ask("transfer_function", tall).answers["zeros"] == [-3]
    assert rejected("transfer_function", tall, {"zeros": []})
    generic = system([[0, 1], [-2, -3]], B=[[0], [1]], C=[[3, 1], [5, 1]])
    assert ask("transfer_function", generic).answers["zeros"] == []
    assert rejected("transfer_function", generic, {"zeros": [-3]})


def test_an_equivalent_form_of_the_fraction_is_right():
    right = sp.apart(ask("transfer_function", COURSE).answers["G"], s)
    assert not rejected("transfer_function", COURSE, {"G": right})
    assert not rejected("transfer_function", COURSE, {"G": M([[right]])})


@pytest.mark.parametrize("method", ["adjugate", "faddeev_leverrier"])
def test_what_several_fractions_share_is_no_common_factor(method):
    """Of one fraction the factor that cancels is named; of a matrix of fractions there is no such thing."""
    for G, named in ((plant(s + 1, (s + 1) * (s + 2)), True), (plant([[1, s]], [[s + 1, s + 2]]), False)):
        result = ask("transfer_function", G, method)
        (step,) = [each for top in result.steps for each in top.walk() if each.kind.endswith("cancel")]
        assert (step.values["common"] is not None) is named
