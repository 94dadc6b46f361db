"""Functions of a matrix: both methods against scipy, values by hand, refusals, corruptions."""

import numpy as np
import pytest
import scipy.linalg
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from solver.problem.expressions import ExpressionError, Names, parse_expression
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

A, t, k = sp.symbols("A t k")
IDENTITY = sp.Symbol("I")
FUNCTIONS = {
    "inv": (1 / A, np.linalg.inv),
    "exp": (sp.exp(A), scipy.linalg.expm),
    "sin": (sp.sin(A), scipy.linalg.sinm),
    "cosh": (sp.cosh(A), scipy.linalg.coshm),
    "polynomial": (A**3 - 2 * A + IDENTITY, lambda M: M @ M @ M - 2 * M + np.eye(len(M))),
    "power": (A**10, lambda M: np.linalg.matrix_power(M, 10)),
}
MATRICES = {
    "distinct": [[0, 1], [-2, -3]],
    "defective": [[4, 1], [0, 4]],
    "three equal": [[2, 1, 0], [0, 2, 1], [0, 0, 2]],
    "complex": [[1, 2], [-2, 1]],
    "surd": [[3, 1], [5, 4]],
    "cubic": [[0, 1, 0], [0, 0, 1], [1, 1, 0]],
    "scalar": [[5]],
}


def numbers(F):
    return np.array(F.evalf(30).tolist(), dtype=complex)


def asked(rows, f, method="cayley_hamilton"):
    return ask("matrix_function", system(rows), method, function=f)


@pytest.mark.parametrize("matrix", MATRICES)
@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("method", ["cayley_hamilton", "modal"])
def test_functions_agree_with_scipy(matrix, function, method):
    rows = MATRICES[matrix]
    f, theirs = FUNCTIONS[function]
    result = asked(rows, f, method)
    assert result.status is Status.VERIFIED, result.reason
    expected = theirs(np.array(rows, dtype=float))
    assert np.abs(numbers(result.answers["F"]) - expected).max() <= 1e-9 * max(1, np.abs(expected).max())


def test_the_function_of_a_block_has_derivatives_beside_its_diagonal():
    rows = MATRICES["three equal"]
    for f, row in (
        (sp.sqrt(A), (sp.sqrt(2), sp.sqrt(2) / 4, -sp.sqrt(2) / 32)),
        (sp.sin(A * t), (sp.sin(2 * t), t * sp.cos(2 * t), -(t**2) * sp.sin(2 * t) / 2)),
        (A**k, (2**k, k * 2 ** (k - 1), k * (k - 1) * 2 ** (k - 3))),
        (1 / A, (sp.Rational(1, 2), -sp.Rational(1, 4), sp.Rational(1, 8))),
    ):
        result = asked(rows, f, "modal")
        assert result.status is Status.VERIFIED, result.reason
        modes = next(step for step in result.steps if step.kind == "modes").values["modes"]
        expected = sp.Matrix(3, 3, lambda i, j, row=row: row[j - i] if j >= i else 0)
        assert (modes - expected).expand() == sp.zeros(3)
        assert result.answers["F"] == asked(rows, f).answers["F"]


def test_a_power_of_a_nilpotent_block_ends():
    F = asked([[0, 1], [0, 0]], A**k, "modal").answers["F"]
    assert [F.subs(k, i) for i in range(3)] == [sp.eye(2), sp.Matrix([[0, 1], [0, 0]]), sp.zeros(2)]


def test_the_root_by_derivative_condition():
    result = asked([[4, 1], [0, 4]], sp.sqrt(A))
    assert result.answers["F"] == sp.Matrix([[2, sp.Rational(1, 4)], [0, 2]])
    conditions = next(step for step in result.steps if step.kind == "conditions").values["equations"]
    assert [right for right, _ in conditions] == [2, sp.Rational(1, 4)]


@pytest.mark.parametrize("rows", [[[5, 4], [4, 5]], [[2, 1], [1, 2]], [[1, 2], [-2, 1]], [[0, 1], [-1, 0]]])
def test_the_principal_root_squares_to_the_matrix(rows):
    F = asked(rows, sp.sqrt(A)).answers["F"]
    assert (F * F - sp.Matrix(rows)).applyfunc(lambda entry: sp.simplify(sp.expand(entry))) == sp.zeros(2)
    assert min(np.linalg.eigvals(numbers(F)).real) > 0


def test_a_power_with_a_symbol_and_an_exponential_of_time():
    F = asked([[0, 1], [-2, -3]], A**k).answers["F"]
    for i in range(5):
        assert F.subs(k, i) == sp.Matrix([[0, 1], [-2, -3]]) ** i
    F = asked([[0, 1], [-1, 0]], sp.exp(A * t)).answers["F"]
    assert sp.Matrix([[sp.cos(t), sp.sin(t)], [-sp.sin(t), sp.cos(t)]]) == F


def test_rational_functions_stay_exact_for_irreducible_factors():
    F = asked([[0, 1, 0], [0, 0, 1], [1, 1, 0]], 1 / (A + IDENTITY)).answers["F"]
    assert sp.Matrix([[1, 1, 0], [0, 1, 1], [1, 1, 1]]).inv() == F


def test_high_powers_are_exact_and_held_to_the_last_digit():
    plant = system([[1, 1], [1, 0]])
    for exponent in (100, -100, 1476, 10_000):
        result = ask("matrix_function", plant, function=A**exponent)
        F = result.answers["F"]
        assert result.status is Status.VERIFIED, result.reason
        assert F[0, 1] == sp.fibonacci(exponent)
        wrong = sp.ImmutableMatrix(F + sp.Matrix([[0, 1], [0, 0]]))
        assert rejected("matrix_function", plant, {"F": wrong}, function=A**exponent)
    assert "digits" in str(asked([[1, 2], [3, 4]], A**10_000).reason)


@pytest.mark.parametrize(
    ("rows", "exponent", "kinds"),
    [
        ([[0, 1], [-1, -2]], 100, {"conditions", "coefficients"}),
        ([[0, 1], [-1, -2]], -100, {"conditions", "coefficients"}),
        ([[2, 1], [0, 1]], 20, {"conditions", "coefficients"}),
        ([[2, 1], [0, 1]], 100, {"remainder"}),
        ([[1, 1], [1, 0]], 20, {"remainder"}),
    ],
)
def test_a_high_power_goes_by_the_eigenvalues_where_its_values_there_are_short(rows, exponent, kinds):
    result = asked(rows, A**exponent)
    assert {step.kind for step in result.steps} & {"conditions", "coefficients", "remainder"} == kinds
    assert result.answers["F"] == sp.Matrix(rows) ** exponent


NAMED = sp.Matrix(3, 3, sp.symbols("a b c d g h p q r", real=True))


@pytest.mark.parametrize("f", [A**2, A**3, 1 / A, A**2 - 3 * A + 2 * IDENTITY, (A - IDENTITY) / (A + IDENTITY)])
@pytest.mark.parametrize("rows", [NAMED, NAMED[:2, :2]])
def test_rational_functions_of_any_matrix_need_no_eigenvalues(rows, f):
    result = ask("matrix_function", system(rows), function=f)
    assert result.status is Status.VERIFIED, result.reason
    point = {symbol: sp.Rational(2 + 3 * i * i, 7 - i) for i, symbol in enumerate(NAMED[:6])}
    point |= {symbol: sp.Rational(1, 3 + i) for i, symbol in enumerate(NAMED[6:])}
    M, one = rows.subs(point), sp.eye(rows.rows)
    wanted = {
        A**2: M * M,
        A**3: M**3,
        1 / A: M.inv(),
        A**2 - 3 * A + 2 * IDENTITY: M * M - 3 * M + 2 * one,
        (A - IDENTITY) / (A + IDENTITY): (M - one) * (M + one).inv(),
    }
    assert result.answers["F"].subs(point) == wanted[f]


def test_a_high_power_of_many_parameters_is_refused():
    assert "too many terms" in str(ask("matrix_function", system(NAMED), function=A**20).reason)


@pytest.mark.parametrize(("text", "accepted"), [("A^10000", True), ("A^100 + 2A^65", True), ("A^(-10000)", True)])
def test_whole_exponents_of_the_matrix_go_to_ten_thousand(text, accepted):
    names = Names({}, {name: sp.Symbol(name) for name in "AItk"})
    assert (parse_expression(text, names) is not None) is accepted


@pytest.mark.parametrize("text", ["A^10001", "(A + I)^65", "(A^100)^100", "A^10000 A^10000", "t^65"])
def test_other_exponents_stay_small(text):
    with pytest.raises(ExpressionError):
        parse_expression(text, Names({}, {name: sp.Symbol(name) for name in "AItk"}))


def test_a_root_of_a_zero_that_has_all_its_eigenvectors_exists():
    result = asked([[0, 0], [0, 0]], sp.sqrt(A))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["F"] == sp.zeros(2)


@pytest.mark.parametrize(
    ("rows", "f", "says"),
    [
        ([[1, 2], [2, 4]], 1 / A, "divides by zero"),
        ([[0, 1], [0, 0]], sp.sqrt(A), "not differentiable"),
        ([[-1, 0], [0, 4]], sp.sqrt(A), "negative real axis"),
        ([[0, 1], [0, 1]], sp.log(A), "logarithm"),
        ([[0, 1], [-2, -3]], 1 / (A + IDENTITY), "zero"),
    ],
)
def test_functions_that_do_not_exist_are_refused_in_words(rows, f, says):
    result = asked(rows, f)
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason) or "not defined" in str(result.reason), result.reason


@tried(15)
@given(
    systems(4),
    st.sampled_from([sp.exp(A), sp.sin(A), A**5, A**2 - 3 * IDENTITY]),
    st.sampled_from(["cayley_hamilton", "modal"]),
)
def test_random_matrices_are_solved_by_both_methods(M, f, method):
    result = ask("matrix_function", system(M), method, function=f)
    assert result.status is Status.VERIFIED, result.reason


@pytest.mark.parametrize("f", [A**3, sp.exp(A), sp.sqrt(A), 1 / A, sp.exp(A * t), A**k])
def test_corrupted_functions_are_rejected(f):
    rows = [[2, 1], [1, 3]]
    F = sp.Matrix(asked(rows, f).answers["F"])
    assert not rejected("matrix_function", system(rows), {"F": sp.ImmutableMatrix(F)}, function=f)
    for wrong in (-F, F * sp.Rational(1001, 1000), F + sp.Matrix([[0, 0], [sp.Rational(1, 10**4), 0]]), F[:, ::-1]):
        assert rejected("matrix_function", system(rows), {"F": sp.ImmutableMatrix(wrong)}, function=f)


@pytest.mark.parametrize(("text", "f"), [("inv(A)", 1 / A), ("inv(A + I)^2", (A + IDENTITY) ** -2), ("1/A", 1 / A)])
def test_the_inverse_may_be_written_as_a_function(text, f):
    assert parse_expression(text, Names({}, {name: sp.Symbol(name) for name in "AItk"})) == f


def test_the_inverse_of_zero_has_no_value():
    with pytest.raises(ExpressionError, match="division by zero"):
        parse_expression("inv(0)", Names())
