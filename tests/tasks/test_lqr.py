"""The regulator: course examples, both methods, all weights, refusals, corruptions, students' right answers."""

import json

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import solve_continuous_are

from solver import solve
from solver.derivation import Status
from solver.lazy import exact
from solver.tasks.design.regulator import Regulator
from tests.helpers.asking import ask, rejected, system
from tests.helpers.tried import tried

METHODS = ("riccati", "hamiltonian")
I2 = sp.ImmutableMatrix(sp.eye(2))
ONE = sp.ImmutableMatrix([[1]])
UNSTABLE = system([[0, 1], [0, 1]], B=[[0], [1]], C=[[1, 0]])
ASKED = {"Q": I2, "R": ONE, "initial_state": sp.ImmutableMatrix([1, 2])}


def test_the_riccati_equation_is_stated_as_the_books_write_it():
    """AᵀP + PA + Q on one side and P B R⁻¹ Bᵀ P on the other, in this order of terms and factors."""
    A, B, Q, R, P = (
        sp.ImmutableMatrix(rows) for rows in ([[1, 2], [3, 4]], [5, 6], [[7, 0], [0, 8]], [[9]], [[1, 0], [0, 2]])
    )
    problem = Regulator.of(A, B, Q, R)
    first, second, third = problem.linear_part(P).operands
    assert (first.operands, second.operands, third) == ((A.T, P), (P, A), Q)
    factors = problem.quadratic_part(P).operands
    assert (factors[0], factors[1], factors[3], factors[4]) == (P, B, B.T, P)


def floats(M) -> np.ndarray:
    return np.array(sp.Matrix(M).evalf(30).tolist(), dtype=float)


@pytest.mark.parametrize("method", METHODS)
def test_the_exam_with_a_double_pole(method):
    result = ask("lqr", UNSTABLE, method, **ASKED)
    assert result.status is Status.VERIFIED, result.reason
    answers = result.answers
    assert answers["P"] == sp.ImmutableMatrix([[2, 1], [1, 3]])
    assert answers["K"] == sp.ImmutableMatrix([[1, 3]])
    assert answers["u"] == -sp.Symbol("x1") - 3 * sp.Symbol("x2")
    assert answers["eigenvalues"] == [-1, -1]
    assert answers["closed_loop_A"] == sp.ImmutableMatrix([[0, 1], [-1, -2]])
    assert answers["cost"] == sp.Rational(1, 2) * (2 + 2 * 2 + 12)


def test_the_equations_and_all_solutions_of_the_exam():
    answers = ask("lqr", UNSTABLE, **ASKED).answers
    p11, p12, p22 = sp.symbols("p11 p12 p22")
    expected = [1 - p12**2, p11 + p12 - p12 * p22, 1 + 2 * p12 + 2 * p22 - p22**2]
    assert [sp.expand(a - b) for a, b in zip(answers["equations"], expected, strict=True)] == [0, 0, 0]
    assert answers["definiteness"] == ["positive definite", "indefinite", "negative definite"]
    assert [P.tolist() for P in answers["solutions"]] == [[[2, 1], [1, 3]], [[0, -1], [-1, 1]], [[-2, 1], [1, -1]]]


def test_the_course_example_with_a_mode_out_of_reach():
    plant = system([[-1, 0], [0, -2]], B=[[0], [1]], C=[[1, 0]])
    half = sp.ImmutableMatrix([[sp.Rational(1, 2)]])
    result = ask("lqr", plant, output_weight=ONE, R=half)
    assert result.answers["solutions"] == [
        sp.ImmutableMatrix(sp.diag("1/2", 0)),
        sp.ImmutableMatrix(sp.diag("1/2", -2)),
    ]
    assert result.answers["K"] == sp.zeros(1, 2)
    tolerances = sp.ImmutableMatrix([sp.Rational(1, 100), sp.Rational(1, 10)])
    result = ask("lqr", plant, tolerances=tolerances, R=half)
    assert result.answers["Q"] == sp.ImmutableMatrix(sp.diag(10000, 100))
    assert result.status is Status.VERIFIED
    assert abs(float(result.answers["K"][1]) - 12.2829) < 1e-4


def test_without_a_weight_of_the_state_the_unstable_poles_are_mirrored():
    plant = system([[1, 1], [0, 2]], B=[[0], [1]])
    result = ask("lqr", plant, Q=sp.ImmutableMatrix(sp.zeros(2)), R=ONE)
    assert sorted(result.answers["eigenvalues"]) == [-2, -1]
    assert len(result.answers["solutions"]) == 4
    assert any(step.values.get("cheaper") for step in result.steps)


def test_symbolic_weights_in_the_symbols_of_the_problem():
    q, r = sp.Symbol("q"), sp.Symbol("r")
    plant = system([[0, 1], [0, 0]], B=[[0], [1]])
    result = ask("lqr", plant, "hamiltonian", Q=sp.ImmutableMatrix(sp.diag(q, 0)), R=sp.ImmutableMatrix([[r]]))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["K"].free_symbols == {q, r}
    K = result.answers["K"].subs({q: 4, r: 1})
    assert floats(K).tolist() == [[2.0, 2.0]]


def test_an_oscillator_with_parameters_that_are_declared_positive():
    k, m = sp.symbols("k m", positive=True)
    w, r = sp.symbols("w r")
    plant = system([[0, 1], [-k / m, 0]], B=[[0], [1 / m]], C=[[1, 0]])
    result = ask("lqr", plant, output_weight=sp.ImmutableMatrix([[w]]), R=sp.ImmutableMatrix([[r]]))
    assert result.status is Status.VERIFIED, result.reason
    point = {k: 3, m: 2, w: 5, r: sp.Rational(1, 2)}
    A, B = (np.array(M, dtype=float) for M in ([[0, 1], [-1.5, 0]], [[0], [0.5]]))
    P = solve_continuous_are(A, B, np.diag([5.0, 0.0]), np.array([[0.5]]))
    assert np.abs(floats(result.answers["P"].subs(point)) - P).max() < 1e-9


def test_an_undecided_sign_is_asked_for():
    a = sp.Symbol("a")
    plant = system([[a, 1], [0, -1]], B=[[1], [0]])
    result = ask("lqr", plant, Q=sp.ImmutableMatrix(sp.zeros(2)), R=ONE)
    assert result.status is Status.UNSOLVED
    assert "sign of $a$" in str(result.reason)


def test_the_case_split_is_shown_and_leads_to_the_solutions():
    steps = ask("lqr", UNSTABLE, **ASKED).steps
    cases = next(step for step in steps if step.kind == "cases")
    assert sorted(step.values["number"] for step in cases.walk() if step.kind == "end") == [1, 2, 3]


def test_a_continuum_of_solutions_is_described_and_not_listed():
    plant = system([[0, 0], [0, 0]], B=[[1, 0], [0, 1]])
    result = ask("lqr", plant, Q=I2, R=I2)
    assert result.status is Status.VERIFIED
    assert "solutions" not in result.answers
    assert result.answers["P"] == I2
    assert next(step for step in result.steps if step.kind == "endless").values["family"] is not None


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("plant", "Q", "words"),
    [
        (system([[1, 0], [0, -2]], B=[[0], [1]]), I2, "not stabilizable: the mode $\\lambda = 1$"),
        (system([[0, 1], [-1, 0]], B=[[0], [1]]), sp.ImmutableMatrix(sp.zeros(2)), "imaginary axis"),
    ],
)
def test_refusals_say_why(method, plant, Q, words):
    result = ask("lqr", plant, method, Q=Q, R=ONE)
    assert result.status is Status.UNSOLVED
    assert words in str(result.reason)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ("Q: [[1, 0], [0, -1]], R: 1", "positive semidefinite"),
        ("Q: [[1, 2], [0, 1]], R: 1", "symmetric"),
        ("Q: [[1, 0], [0, 1]], R: 0", "R must be positive definite"),
        ("Q: [[1, 0], [0, 1]], R: 1, output_weight: 2", "given twice"),
        ("output_weight: [[1, 0], [0, 1]]", "1×1"),
        ("tolerances: [0, 1]", "must be positive"),
        ("cost_factor: -1, R: 1", "must be positive"),
        ("initial_state: [1, 0]", "say what is weighed"),
        ("Q: [[1]], R: 1", "2 rows"),
        ("Q: [[1, 0], [0, 1]], R: 1, N: [1, 1]", "too large beside .* it is indefinite"),
        ("output_weight: 1, N: [0, 1]", "too large beside"),
        ("Q: [[q, 0], [0, 0.25]], R: 1, N: [1, 0.5]", "too large beside .* it is indefinite"),
        ("R: 1, N: [1, 2, 3]", "2 rows"),
    ],
)
def test_what_the_file_shows_to_be_wrong_is_refused(options, words):
    text = f"system: {{A: [[0, 1], [0, 0]], B: [0, 1], C: [1, 0]}}\nfind:\n  a: {{task: lqr, {options}}}\n"
    with pytest.raises(Exception, match=words):
        solve(text)


@pytest.mark.parametrize(
    ("A", "B", "Q", "expected"),
    [
        ([[1, 1], [0, 2]], [0, 1], [[0, 0], [0, 0]], [[0, 0], [0, 0]]),
        ([[1, 1], [0, 2]], [0, 1], [[0, 0], [0, 1]], [[0, 0], [0, 2 + sp.sqrt(5)]]),
        ([[1, 0], [0, 1]], I2, [[1, 1], [1, 1]], (1 + sp.sqrt(3)) / 2 * sp.ones(2)),  # a continuum of solutions
        ([[-1, 1], [0, -2]], [0, 1], [[0, 0], [0, 0]], None),
        ([[0, 1], [0, 1]], [0, 1], I2, None),
    ],
)
def test_what_the_weight_does_not_see_costs_nothing_where_it_may_be_left_alone(A, B, Q, expected):
    plant, asked = system(A, B=B), {"Q": sp.ImmutableMatrix(Q), "R": sp.ImmutableMatrix(sp.eye(sp.Matrix(B).cols))}
    result = ask("lqr", plant, **asked)
    assert result.status is Status.VERIFIED, result.reason
    found = result.answers.get("minimal_solution")
    assert (found is None) == (expected is None)
    assert found is None or (found - sp.Matrix(expected)).expand().is_zero_matrix
    if found is not None:
        solutions = [*result.answers.get("solutions", ()), result.answers["P"]]
        for other in (each for each in solutions if each != found):
            assert rejected("lqr", plant, {"minimal_solution": other}, **asked)
        assert rejected("lqr", plant, {"minimal_solution": sp.ImmutableMatrix(found + sp.eye(2) / 100)}, **asked)


ROUNDED = [[4.49, 3.36], [3.36, 2.51]]
"""The eigenvalues are −0.0028 and 7.0028."""


@pytest.mark.parametrize(
    ("asked", "answer"), [("task: lqr", "K"), ("task: kalman_filter", "L"), ("task: optimal_tracking", "K")]
)
def test_a_weight_that_is_indefinite_by_its_rounding_is_used_and_said_to_be(asked, answer):
    system_ = "system: {A: [[0, 1], [0, -1]], B: [0, 1], C: [1, 0]}"
    document = solve(f"{system_}\nfind:\n  a: {{{asked}, Q: {ROUNDED}, R: 1}}\n")
    part = json.loads(document.json())["parts"][0]
    assert part["status"] == "verified"
    assert "negative by less than the rounding" in str(part["steps"])
    assert answer in part["answers"]
    rougher = [[4.49, 3.36], [3.36, 2.45]]
    with pytest.raises(Exception, match="positive semidefinite; it is indefinite"):
        solve(f"{system_}\nfind:\n  a: {{{asked}, Q: {rougher}, R: 1}}\n")


@pytest.mark.parametrize(
    "rows",
    [[["1/3", 1], [1, "299/100"]], [[1, 2], [2, 3]], [["1/2", 1], [1, "3/2"]], [["449/100", 0], [0, "-1/100"]]],
)
def test_other_indefinite_weights_are_not_put_down_to_rounding(rows):
    assert exact.negative_by_rounding(sp.Matrix(rows)) is None


CROSS = {"Q": sp.ImmutableMatrix(sp.diag(2, 3)), "R": ONE, "N": sp.ImmutableMatrix([1, 1])}
INTEGRATORS = system([[0, 1], [0, 0]], B=[[0], [1]])


@pytest.mark.parametrize("method", METHODS)
def test_a_cross_weight_is_taken_away_by_completing_the_square(method):
    """By hand: p12² + 2 p12 = 1, K = [p12 + 1, p22 + 1] with (p22 + 1)² = 3 + 2 p12."""
    result = ask("lqr", INTEGRATORS, method, **CROSS)
    assert result.status is Status.VERIFIED, result.reason
    square = next(step for step in result.steps if step.kind == "completed_square").claims
    assert square["A"].right == sp.ImmutableMatrix([[0, 1], [-1, -1]])
    assert square["Q"].right == sp.ImmutableMatrix([[1, -1], [-1, 2]])
    assert result.answers["K"] == sp.ImmutableMatrix([[sp.sqrt(2), sp.sqrt(1 + 2 * sp.sqrt(2))]])
    assert result.answers["Q"] == CROSS["Q"]


def test_a_cross_weight_with_symbols():
    a, n, q, r = sp.symbols("a n q r")
    asked = {"Q": sp.ImmutableMatrix([[q]]), "R": sp.ImmutableMatrix([[r]]), "N": sp.ImmutableMatrix([[n]])}
    result = ask("lqr", system([[a]], B=[1]), **asked)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["K"][0] == a + sp.sqrt(a**2 * r - 2 * a * n + q) / sp.sqrt(r)


@tried(10)
@given(st.integers(1, 3), st.integers(1, 2), st.randoms(use_true_random=False))
def test_cross_weights_agree_with_scipy(n, m, random):
    """[[Q, N], [Nᵀ, R]] = MᵀM + I is positive definite."""
    A, B, M = (
        sp.ImmutableMatrix(rows, columns, lambda *_: random.randint(-2, 2))
        for rows, columns in ((n, n), (n, m), (n + m, n + m))
    )
    W = M.T * M + sp.eye(n + m)
    asked = {name: sp.ImmutableMatrix(each) for name, each in (("Q", W[:n, :n]), ("R", W[n:, n:]), ("N", W[:n, n:]))}
    for method in METHODS:
        result = ask("lqr", system(A, B=B), method, **asked)
        assert result.status is not Status.FAILED, result.reason
        if result.status is Status.VERIFIED:
            Q, R, N = (floats(asked[name]) for name in "QRN")
            P = solve_continuous_are(floats(A), floats(B), Q, R, s=N)
            assert np.abs(floats(result.answers["P"]) - P).max() <= 1e-6 * (1 + np.abs(P).max())
            K = np.linalg.solve(R, floats(B).T @ P + N.T)
            assert np.abs(floats(result.answers["K"]) - K).max() <= 1e-6 * (1 + np.abs(K).max())


@pytest.mark.parametrize("name", ["P", "K", "u", "closed_loop_A", "eigenvalues", "equations", "solutions"])
def test_answers_of_the_problem_without_cross_weight_are_rejected(name):
    without = ask("lqr", INTEGRATORS, **{key: value for key, value in CROSS.items() if key != "N"}).answers
    cross = ask("lqr", INTEGRATORS, **CROSS).answers
    assert not rejected("lqr", INTEGRATORS, {name: cross[name]}, **CROSS)
    assert rejected("lqr", INTEGRATORS, {name: without[name]}, **CROSS)


RIGHT = ask("lqr", UNSTABLE, **ASKED).answers
OTHER = RIGHT["solutions"][1]


def corruptions():
    yield "P", OTHER
    yield "P", -RIGHT["P"]
    yield "P", RIGHT["P"] + sp.Matrix([[0, 1], [0, 0]]) / 1000
    yield "P", sp.ImmutableMatrix([[2]])
    for wrong in (
        -RIGHT["K"],
        2 * RIGHT["K"],
        RIGHT["K"].T,
        sp.ImmutableMatrix([[1, 2]]),
        sp.ImmutableMatrix([[3, 1]]),
    ):
        yield "K", wrong
    yield "u", -RIGHT["u"]
    yield "u", RIGHT["u"] + sp.Symbol("x1")
    yield "Q", 2 * RIGHT["Q"]
    yield "R", 2 * RIGHT["R"]
    yield "closed_loop_A", RIGHT["closed_loop_A"].T
    yield "closed_loop_A", -RIGHT["closed_loop_A"]
    yield "eigenvalues", [1, 1]
    yield "eigenvalues", [-1, 1]
    yield "eigenvalues", [-1]
    yield "eigenvalues", [-1, -2]
    yield "cost", 2 * RIGHT["cost"]
    yield "equations", [RIGHT["equations"][0], RIGHT["equations"][1], RIGHT["equations"][2] + 1]
    yield "equations", RIGHT["equations"][:2]
    yield "solutions", RIGHT["solutions"][:2]
    yield "solutions", [*RIGHT["solutions"], OTHER]
    yield "solutions", [*RIGHT["solutions"][:2], OTHER]
    yield "solutions", [*RIGHT["solutions"][:2], RIGHT["solutions"][2].applyfunc(lambda x: -x)]


@pytest.mark.parametrize(("name", "wrong"), list(corruptions()))
def test_a_corrupted_answer_is_rejected_alone(name, wrong):
    if hasattr(wrong, "shape"):
        wrong = sp.ImmutableMatrix(wrong)
    assert rejected("lqr", UNSTABLE, {name: wrong}, **ASKED)


def test_wrong_words_of_definiteness_are_rejected():
    words = ["indefinite", "positive definite", "negative definite"]
    assert rejected("lqr", UNSTABLE, {"solutions": RIGHT["solutions"], "definiteness": words}, **ASKED)


@pytest.mark.parametrize("name", list(RIGHT))
def test_every_answer_is_accepted_alone(name):
    assert not rejected("lqr", UNSTABLE, {name: RIGHT[name]}, **ASKED)


def test_other_orders_and_scales_are_right():
    solutions, words = RIGHT["solutions"][::-1], RIGHT["definiteness"][::-1]
    assert not rejected("lqr", UNSTABLE, {"solutions": solutions, "definiteness": words}, **ASKED)
    equations = [-2 * RIGHT["equations"][2], RIGHT["equations"][0], RIGHT["equations"][1] / 3]
    assert not rejected("lqr", UNSTABLE, {"equations": equations}, **ASKED)


@st.composite
def plants(draw):
    n, m = draw(st.integers(2, 4)), draw(st.integers(1, 2))
    A = sp.ImmutableMatrix(n, n, lambda i, j: draw(st.integers(-3, 3)))
    B = sp.ImmutableMatrix(n, m, lambda i, j: draw(st.integers(-3, 3)))
    return A, B


@tried(12)
@given(plants())
def test_random_plants_agree_with_scipy_by_both_methods(pair):
    A, B = pair
    plant = system(A, B=B)
    Q, R = sp.ImmutableMatrix(sp.eye(A.rows)), sp.ImmutableMatrix(sp.eye(B.cols))
    results = [ask("lqr", plant, method, Q=Q, R=R) for method in METHODS]
    assert len({result.status for result in results}) == 1
    for result in results:
        assert result.status is not Status.FAILED, result.reason
        if result.status is Status.VERIFIED:
            K = floats(B).T @ solve_continuous_are(*map(floats, (A, B, Q, R)))
            assert np.abs(floats(result.answers["K"]) - K).max() <= 1e-6 * (1 + np.abs(K).max())


def test_decimals_carry_twelve_digits_through_json():
    text = (
        "system: {A: [[1, 2, 0], [1, -1, 1], [2, 0, -2]], B: [1, 1, 0]}\n"
        "find: {a: {task: lqr, method: hamiltonian, Q: [[1, 0, 0], [0, 2, 0], [0, 0, 3]], R: 1}}\n"
    )
    data = json.loads(solve(text).json())
    P = sp.Matrix(sp.sympify(data["parts"][0]["answers"]["P"]["value"]))
    A, B = sp.Matrix([[1, 2, 0], [1, -1, 1], [2, 0, -2]]), sp.Matrix([1, 1, 0])
    residual = A.T * P + P * A - P * B * B.T * P + sp.diag(1, 2, 3)
    assert max(abs(entry) for entry in residual) < 1e-11


def test_of_more_solutions_than_anyone_would_read_the_stabilizing_one_is_given():
    coefficients = (720, 1764, 1624, 735, 175, 21)  # eigenvalues −1, …, −6
    A = sp.Matrix(6, 6, lambda i, j: -coefficients[j] if i == 5 else int(j == i + 1))
    plant = system(A, B=[0, 0, 0, 0, 0, 1], C=[[1, 0, 0, 0, 0, 0]])
    Q = sp.ImmutableMatrix(sp.eye(6))
    result = ask("lqr", plant, "riccati", Q=Q, R=ONE)
    assert result.status is Status.VERIFIED, result.reason
    assert "solutions" not in result.answers
    assert next(step for step in result.steps if step.kind == "many").values["count"] == 32
    expected = solve_continuous_are(floats(A), floats(plant.B), floats(Q), floats(ONE))
    assert np.abs(floats(result.answers["P"]) - expected).max() < 1e-6 * np.abs(expected).max()


@pytest.mark.parametrize(
    ("pole", "definiteness"),
    [("a", ["positive definite", "positive semidefinite"]), ("-a", ["positive semidefinite", "negative definite"])],
)
def test_without_a_weight_the_solutions_are_definite_as_their_signs_say(pole, definiteness):
    a = sp.Symbol("a", positive=True)
    result = ask(
        "lqr", system([[a if pole == "a" else -a]], B=[1]), Q=sp.zeros(1).as_immutable(), R=sp.eye(1).as_immutable()
    )
    assert (result.status, result.answers["definiteness"]) == (Status.VERIFIED, definiteness)


def test_a_double_root_among_the_cases_is_no_error():
    plant = system([[0, 1], [0, -1]], B=[0, 1])
    result = ask("lqr", plant, Q=sp.eye(2).as_immutable(), R=sp.eye(1).as_immutable())
    assert result.status is Status.VERIFIED
    assert result.answers["P"] == sp.Matrix([[2, 1], [1, 1]])


def test_singular_solutions_are_judged_by_eigenvalues_that_are_shown():
    result = ask("lqr", system([[-1, 0], [0, -2]], B=[0, 1], C=[[1, 1]]), Q=I2 * 0 + sp.diag(1, 0), R=ONE)
    assert result.status is Status.VERIFIED
    (judged,) = (step for step in result.steps if step.kind == "definiteness")
    assert not judged.values["minors"]
    for P, values in zip(result.answers["solutions"], judged.values["eigenvalues"], strict=True):
        found = np.linalg.eigvalsh(np.array(P, dtype=float))
        assert np.allclose(sorted(float(value) for value in values), found)


def test_a_parameter_that_decides_the_signs_of_the_minors_is_kept_in_them():
    mu = sp.Symbol("mu", positive=True)
    plant = system([[0, 1], [0, 0]], B=[0, 1])
    result = ask("lqr", plant, Q=sp.diag(1, mu).as_immutable(), R=ONE)
    assert result.status is Status.VERIFIED
    (judged,) = (step for step in result.steps if step.kind == "definiteness")
    assert judged.values["minors"] == [
        [(sp.sqrt(mu + 2), 1), (mu + 1, 1)],
        [(-sp.sqrt(mu + 2), -1), (mu + 1, 1)],
    ]
    (others,) = (step for step in result.steps if step.kind == "conditional")
    assert others.values["first"] == 3


@pytest.mark.parametrize(("method", "kind"), [("riccati", "splitting"), ("hamiltonian", "hamiltonian")])
def test_the_polynomial_of_a_small_hamiltonian_matrix_is_expanded_row_by_row(method, kind):
    """As on paper at `tutor`: the entries of a row times their minors, each minor worked out; verified as claims."""
    part = ask("lqr", UNSTABLE, method, **ASKED)
    (step,) = [each for each in part.steps if each.kind == kind]
    assert [each.kind for each in step.steps] == ["expansion", "minor", "squares"]
    assert {each.detail for each in step.steps} == {"tutor"}
    s = sp.Symbol("s")
    assert sp.expand(step.claims["chi"].right - (s**4 - 2 * s**2 + 1)) == 0
    assert part.status is Status.VERIFIED


@pytest.mark.parametrize(
    ("last", "weights", "gain"),
    [((0, 0, 0), (36, 49, 14), [6, 11, 6]), ((-3, -1, 0), (315, 152, 24), [15, 20, 8])],
    ids=["cases within cases", "a factor twice"],
)
def test_products_of_three_states_hold_where_they_are_shown(last, weights, gain):
    """In a case that P does not belong to, an equation is no equality; a factor may stand in one several times."""
    rows = [[0, 1, 0], [0, 0, 1], list(last)]
    Q = [[weights[i] if i == j else 0 for j in range(3)] for i in range(3)]
    solution = solve(f"system: {{A: {rows}, B: [0, 0, 1]}}\nfind: {{a: {{task: lqr, Q: {Q}, R: 1}}}}\n")
    assert solution.status == "verified"
    assert solution.answers["a"]["K"].tolist() == [gain]
