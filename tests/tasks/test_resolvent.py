"""The resolvent by both methods: numpy's inverse at points, intermediate steps, corruptions, marking."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given

from solver import solve
from solver.derivation import CheckStatus, Status
from tests.helpers.asking import ask, at, rejected, system
from tests.helpers.marked import solved, verdict
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

s, z = sp.symbols("s z")
a, b = sp.symbols("a b", real=True)
METHODS = ("adjugate", "faddeev_leverrier")
COURSE = [[0, 1], [-2, -3]]
FIVE = [[0] * i + [2, 1, 0, 0, 0][: 5 - i] for i in range(5)]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        (COURSE, sp.Matrix([[s + 3, 1], [-2, s]]) / ((s + 1) * (s + 2))),
        ([[5]], sp.Matrix([[1 / (s - 5)]])),
        ([[2, 0], [0, 2]], sp.eye(2) / (s - 2)),
        ([[a, 1], [0, b]], sp.Matrix([[1 / (s - a), 1 / ((s - a) * (s - b))], [0, 1 / (s - b)]])),
        ([[0, 1], [-1, 0]], sp.Matrix([[s, 1], [-1, s]]) / (s**2 + 1)),
    ],
)
def test_textbook_resolvents(rows, expected, method):
    result = ask("resolvent", system(rows), method)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["resolvent"] == expected, "cancelled, and the denominators in factors"
    assert result.answers["polynomial"] == sp.Poly(sp.prod([s - each for each in _eigenvalues(rows)]), s).as_expr()


def _eigenvalues(rows):
    return [each for each, m in sp.Matrix(rows).eigenvals().items() for _ in range(m)]


@pytest.mark.parametrize("method", METHODS)
def test_in_discrete_time_it_is_a_function_of_z(method):
    result = ask("resolvent", system([[1, 1], [0, a]], discrete=True), method)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["resolvent"] == sp.Matrix([[1 / (z - 1), 1 / ((z - 1) * (z - a))], [0, 1 / (z - a)]])
    assert sp.expand(result.answers["polynomial"] - (z - 1) * (z - a)) == 0


def test_the_steps_are_those_of_the_transform():
    kinds = [step.kind for step in ask("resolvent", system(COURSE)).steps]
    assert kinds == ["pencil", "expansion", "factors", "adjugate", "inverse"]
    assert [step.kind for step in ask("state_transition_matrix", system(COURSE)).steps][: len(kinds)] == kinds
    steps = ask("resolvent", system(COURSE), "faddeev_leverrier").steps
    assert [step.kind for step in steps] == ["start", "recursion", "recursion", "sum", "factors", "inverse"]
    assert steps[3].claims["entries"].right == sp.Matrix([[s + 3, 1], [-2, s]])


@tried(20)
@given(systems(5))
def test_both_methods_give_the_inverse_of_numpy(A):
    found = [ask("resolvent", system(A), method) for method in METHODS]
    assert [each.status for each in found] == [Status.VERIFIED] * 2
    assert found[0].answers == found[1].answers
    point = 1.7 + 2.3j
    theirs = np.linalg.inv(point * np.eye(A.rows) - np.array(A, dtype=complex))
    assert np.allclose(at(found[0].answers["resolvent"], s=point), theirs, atol=1e-9 * np.abs(theirs).max())


@pytest.mark.parametrize("discrete", [False, True])
def test_corrupted_answers_are_rejected(discrete):
    plant, x = system(COURSE, discrete=discrete), z if discrete else s
    answers = ask("resolvent", plant).answers
    R, chi = sp.Matrix(answers["resolvent"]), answers["polynomial"]
    assert not rejected("resolvent", plant, {"resolvent": answers["resolvent"]})
    assert not rejected("resolvent", plant, {"polynomial": chi})
    entry = sp.Matrix([[0, 0], [0, sp.Rational(1, 10**9)]])
    for wrong in (-R, R.T, R.subs(x, -x), R * sp.Rational(1001, 1000), R[:, ::-1], R + entry, R * (x + 1)):
        assert rejected("resolvent", plant, {"resolvent": sp.ImmutableMatrix(wrong)})
    for wrong in (-chi, chi + 1, chi.subs(x, -x), 2 * chi, chi * x):
        assert rejected("resolvent", plant, {"polynomial": sp.expand(wrong)})


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("rows", [[[5]], COURSE, FIVE])
def test_every_display_is_judged(rows, method):
    text = f"title: T\nsystem: {{A: {rows}}}\nfind: {{a: {{task: resolvent, method: {method}}}}}\n"
    part = solve(text).parts[0]
    assert part.status is Status.VERIFIED, part.reason
    skipped = [row for row in part.checks if row.status is not CheckStatus.PASSED]
    assert len(skipped) == (len(rows) == 5 and method == "faddeev_leverrier"), "the ellipsis of the recursion"


PAPER = "title: T\nsystem: {A: [[0, 1, 0], [0, 0, 1], [0, -2, -3]]}\nfind: {a: resolvent}\n"


def test_any_form_of_the_matrix_is_right_and_usual_mistakes_are_named():
    problem = solved(PAPER)
    common = "/(s^3 + 3s^2 + 2s)"
    adjugate = [["s^2+3s+2", "s+3", "1"], ["0", "s(s+3)", "s"], ["0", "-2s", "s^2"]]
    whole = [[f"({entry}){common}" for entry in row] for row in adjugate]
    assert verdict(problem, "a", "resolvent", whole).verdict == "correct"
    assert verdict(problem, "a", "polynomial", "s(s+1)(s+2)").verdict == "correct"
    negative = [[f"-({entry}){common}" for entry in row] for row in adjugate]
    for wrong, reason in ((negative, "inverse of"), (adjugate, "adjugate")):
        found = verdict(problem, "a", "resolvent", wrong)
        assert found.verdict == "wrong"
        assert reason in str(found.reason)
    assert verdict(problem, "a", "polynomial", "-s(s+1)(s+2)").verdict == "wrong"


def test_of_one_state_no_adjugate_is_taken():
    result = ask("resolvent", system([[-2]]), "adjugate")
    assert [step.kind for step in result.steps] == ["pencil", "diagonal"]
    page = solve("title: t\nsystem: {A: [[-2]], B: [3], C: [5]}\nfind: {a: {task: transfer_function}}\n").markdown()
    assert r"\operatorname{adj}" not in page
    assert r"CB = 5 \cdot 3 = 15" in page


def test_a_diagonal_matrix_is_inverted_entry_by_entry():
    result = ask("resolvent", system([[-1, 0], [0, -2]]), "adjugate")
    assert [step.kind for step in result.steps] == ["pencil", "diagonal", "polynomial"]
    assert result.answers["resolvent"] == sp.diag(1 / (s + 1), 1 / (s + 2))


def test_a_factored_determinant_is_not_multiplied_out_on_the_way_to_the_inverse():
    result = ask("resolvent", system([[-1, 1], [0, -2]]), "adjugate")
    assert [step.kind for step in result.steps] == ["pencil", "expansion", "adjugate", "inverse", "polynomial"]
    assert "value" not in result.steps[1].claims
    page = solve(
        "title: t\nsystem: {A: [[-1, 1], [0, -2]], B: [0, 1], C: [1, 0]}\nfind: {a: {task: transfer_function}}\n"
    )
    assert r"G(s) = \frac{1}{(s + 1)(s + 2)}" in page.markdown()
    assert "s^{2} + 3s + 2" not in page.markdown()
