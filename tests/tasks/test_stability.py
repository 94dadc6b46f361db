"""Verdicts by all methods: textbook cases, numpy on random systems, special cases, corruptions, refusals."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

import solver
from solver.derivation import Status
from solver.problem.source import InputError
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

STABLE, MARGINAL, UNSTABLE = "asymptotically stable", "marginally stable", "unstable"
METHODS = ("eigenvalues", "lyapunov", "routh")
p, d = sp.symbols("p d", positive=True)
k = sp.Symbol("k", real=True)
half = sp.Rational(1, 2)


def companion(*coefficients):
    """The companion matrix of the monic polynomial with these coefficients after the first."""
    n = len(coefficients)
    return [[int(j == i + 1) for j in range(n)] for i in range(n - 1)] + [[-c for c in reversed(coefficients)]]


CONTINUOUS = {
    "nodes": ([[-1, 0], [0, -2]], STABLE),
    "the course's": ([[3, -2], [1, -1]], UNSTABLE),
    "two integrators apart": ([[0, 0], [0, 0]], MARGINAL),
    "two integrators in a row": ([[0, 1], [0, 0]], UNSTABLE),
    "oscillator": ([[0, 1], [-1, 0]], MARGINAL),
    "coupled equal oscillators": ([[0, 1, 0, 0], [-1, 0, 1, 0], [0, 0, 0, 1], [0, 0, -1, 0]], UNSTABLE),
    "uncoupled equal oscillators": ([[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1], [0, 0, -1, 0]], MARGINAL),
    "surd": ([[0, 1], [2, 0]], UNSTABLE),
    "decimals inside": (companion(1, 2, 1), STABLE),
    "decimals outside": (companion(0, 0, 0, 3), UNSTABLE),
    "irreducible with roots on the axis": (companion(0, 5, 0, 1), MARGINAL),
    "scalar": ([[-3]], STABLE),
    "scalar zero": ([[0]], MARGINAL),
    "surd entries": ([[-sp.sqrt(2), 1], [0, -1]], STABLE),
    "positive parameters": ([[0, 1], [-p, -d]], STABLE),
    "positive parameter without damping": ([[0, 1], [-p, 0]], MARGINAL),
    "just unstable": ([[0, 1], [-1, sp.Rational(1, 10**9)]], UNSTABLE),
}
DISCRETE = {
    "inside": ([[0, 1], [-half, 1]], STABLE),
    "on the circle": ([[0, 1], [-1, 1]], MARGINAL),
    "at one": ([[1, 0], [0, half]], MARGINAL),
    "at one, chained": ([[1, 1], [0, 1]], UNSTABLE),
    "at minus one": ([[-1, 0], [0, 0]], MARGINAL),
    "dead beat": ([[0, 1], [0, 0]], STABLE),
    "outside": ([[2]], UNSTABLE),
    "irreducible cubic": (companion(0, -half, sp.Rational(1, 3)), STABLE),
    "one and its inverse": ([[2, 0], [0, half]], UNSTABLE),
    "only ones": ([[1, 0], [0, 1]], MARGINAL),
}
CASES = [
    pytest.param(rows, verdict, discrete, id=f"{'discrete ' if discrete else ''}{name}")
    for discrete, table in ((False, CONTINUOUS), (True, DISCRETE))
    for name, (rows, verdict) in table.items()
]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(("rows", "verdict", "discrete"), CASES)
def test_verdicts(rows, verdict, discrete, method):
    result = ask("stability", system(rows, discrete=discrete), method)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["verdict"] == verdict


@tried(25)
@given(systems(4), st.sampled_from(METHODS), st.booleans())
def test_numpy_agrees_away_from_the_boundary(A, method, discrete):
    excess = [abs(v) - 1 if discrete else v.real for v in np.linalg.eigvals(np.array(A, dtype=float))]
    result = ask("stability", system(A, discrete=discrete), method)
    assert result.status is Status.VERIFIED, result.reason
    if all(abs(x) > 0.05 for x in excess):
        assert (result.answers["verdict"] == STABLE) == all(x < 0 for x in excess)


def test_the_solution_of_the_course_example():
    result = ask("stability", system([[3, -2], [1, -1]]), "lyapunov", dual=True)
    assert result.answers["P"] == sp.Matrix([[1, sp.Rational(7, 4)], [sp.Rational(7, 4), sp.Rational(9, 4)]])
    minors = next(step for step in result.steps if step.kind == "minors")
    assert [minor for minor, _ in minors.values["minors"]] == [1, sp.Rational(-13, 16)]


@pytest.mark.parametrize("rows", [[[0, 1], [-1, 0]], [[1, 0], [0, -1]]])
def test_a_singular_equation_leaves_the_eigenvalues_to_decide(rows):
    result = ask("stability", system(rows), "lyapunov")
    assert "P" not in result.answers
    assert [step.kind for step in result.steps].index("singular") < len(result.steps) - 1


@pytest.mark.parametrize(
    ("A", "Q", "kinds", "verdict"),
    [
        ([[0, 1], [-2, -3]], [[1, 0], [0, 0]], "minors", STABLE),
        ([[-1, 0], [0, -2]], [[1, 0], [0, 0]], "location", STABLE),
        ([[-1, 0], [0, 2]], [[1, 0], [0, 0]], "location", UNSTABLE),
    ],
)
def test_a_semidefinite_right_side_decides_only_if_it_sees_all(A, Q, kinds, verdict):
    result = ask("stability", system(A), "lyapunov", Q=sp.ImmutableMatrix(Q))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["verdict"] == verdict
    assert kinds in [step.kind for step in result.steps]


@pytest.mark.parametrize(
    ("coefficients", "outside"), [((2, 2, 4, 11, 10), 2), ((7, 6, 42, 8, 56), 0), ((1, 3, 3, 3, 2, 1), 2)]
)
def test_special_rows_of_the_array(coefficients, outside):
    result = ask("stability", system(companion(*coefficients)), "routh")
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["right_half_plane_roots"] == outside


@pytest.mark.parametrize(
    ("matrices", "bibo"),
    [
        ({"B": [[0], [1]], "C": [[1, 1]]}, True),
        ({"B": [[1], [1]], "C": [[1, 1]]}, False),
        ({"B": [[1], [1]], "C": [[0, 1]]}, True),
        ({"B": [[0], [1]]}, True),
        ({"C": [[1, 0]]}, False),
        ({}, False),
        ({"B": [[1, 0], [0, 1]], "C": [[1, 0], [0, 1]], "D": [[1, 0], [0, 0]]}, False),
    ],
)
@pytest.mark.parametrize("discrete", [False, True])
def test_what_cancels_does_not_count_from_input_to_output(matrices, bibo, discrete):
    rows = [[2, 0], [0, half]] if discrete else [[1, 0], [0, -1]]
    matrices = {name: sp.Matrix(M) for name, M in matrices.items()}
    plant = system(rows, discrete=discrete, **matrices)
    result = ask("stability", plant)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["verdict"] == UNSTABLE
    assert result.answers["bibo_stable"] is bibo
    assert rejected("stability", plant, {"bibo_stable": not bibo})


def test_a_hidden_integrator_is_marginal_but_bibo_stable():
    result = ask("stability", system([[0, 0], [0, -1]], B=[0, 1], C=[[1, 1]]))
    assert (result.answers["verdict"], result.answers["bibo_stable"]) == (MARGINAL, True)


@pytest.mark.parametrize("method", METHODS)
def test_a_verdict_that_parameters_decide_is_not_guessed(method):
    result = ask("stability", system([[0, 1], [-k, -1]]), method)
    assert result.status is Status.UNSOLVED
    assert "$k > 0$" in str(result.reason)


def test_routh_decides_with_parameters_where_roots_have_no_form():
    result = ask("stability", system([[0, 1, 0], [0, 0, 1], [-p, -1 - p, -1]]), "routh")
    assert result.answers["verdict"] == STABLE
    assert "eigenvalues" not in result.answers


def corruptions(answers):
    verdict = answers["verdict"]
    yield from ({"verdict": other} for other in (STABLE, MARGINAL, UNSTABLE, "no idea") if other != verdict)
    yield {"bibo_stable": not answers["bibo_stable"]}
    yield {"eigenvalues": [value + sp.Rational(1, 3) for value in answers["eigenvalues"]]}
    yield {"eigenvalues": answers["eigenvalues"][1:]}
    if "P" in answers:
        P = answers["P"]
        yield {"P": -P}
        yield {"P": sp.ImmutableMatrix(2 * P)}
        for i in range(len(P)):
            changed = P.as_mutable()
            changed[i] += sp.Rational(1, 1000)
            yield {"P": sp.ImmutableMatrix(changed)}
    if "array" in answers:
        array = answers["array"]
        yield {"array": -array}
        yield {"array": array[:-1, :]}
        for i in range(len(array)):
            changed = array.as_mutable()
            changed[i] += sp.Rational(1, 1000)
            yield {"array": sp.ImmutableMatrix(changed)}
        yield {"right_half_plane_roots": answers["right_half_plane_roots"] + 1}


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    "plant",
    [
        system([[-1, 2], [0, -3]]),
        system([[3, -2], [1, -1]]),
        system([[0, 0], [0, 0]]),
        system(companion(2, 3, 4, 5)),
        system([[0, 1], [-half, 1]], discrete=True),
        system([[0, 1], [-p, -d]]),
    ],
)
def test_corrupted_answers_are_rejected_each_alone(plant, method):
    answers = dict(ask("stability", plant, method).answers)
    for name, value in answers.items():
        assert not rejected("stability", plant, {name: value}), name
    for corrupted in corruptions(answers):
        assert rejected("stability", plant, corrupted), corrupted


def test_rows_of_an_array_may_be_scaled():
    plant = system(companion(2, 3, 4, 5))
    scaled = sp.ImmutableMatrix([[1, 3, 5], [1, 2, 0], [1, 5, 0], [-3, 0, 0], [5, 0, 0]])  # the second row halved
    assert not rejected("stability", plant, {"array": scaled})


@pytest.mark.parametrize(
    ("Q", "words"),
    [("[[1, 2], [0, 1]]", "symmetric"), ("[[1, 0], [0, -1]]", "positive"), ("[[0, 0], [0, 0]]", "zero")],
)
def test_a_wrong_right_side_is_refused_in_the_file(Q, words):
    part = f"{{task: stability, method: lyapunov, Q: {Q}}}"
    with pytest.raises(InputError) as fault:
        solver.solve(f"title: t\nsystem: {{matrix: [[0, 1], [-1, -1]]}}\nfind:\n  a: {part}\n")
    assert words in fault.value.render()


def test_routh_counts_before_it_factors():
    kinds = [step.kind for step in ask("stability", system([[0, 1], [-2, -3]]), "routh").steps]
    assert kinds.index("verdict") < kinds.index("factors") < kinds.index("confirmation")


def test_a_real_eigenvalue_in_decimals_is_told_once_and_without_re():
    found = solver.solve(
        "display: {decimals: 5}\nsystem: {transfer_function: 942/(s^2 + 12s + 20.002)}\nfind: {a: stability}"
    )
    (placed,) = (step.markdown for step in found.parts[0].steps if step.kind == "location")
    assert r"\lambda_{1} &= -9.9997 < 0" in placed
    assert r"\approx" not in placed
