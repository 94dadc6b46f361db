"""Relative gains: textbook values, numpy, poles by the limit, dead times, complex values, corruptions, marking."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import TransferFunction
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.marked import verdict

TASK = "relative_gain_array"
s = sp.Symbol("s")

WOOD_BERRY = """
system:
  transfer_matrix:
    - ["12.8exp(-s)/(16.7s + 1)", "-18.9exp(-3s)/(21s + 1)"]
    - ["6.6exp(-7s)/(10.9s + 1)", "-19.4exp(-3s)/(14.4s + 1)"]
"""


def solved(text):
    return solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts[0]


def asked(rows, more=""):
    """The result for a transfer matrix of texts."""
    listed = ", ".join("[" + ", ".join(f'"{entry}"' for entry in row) + "]" for row in rows)
    return solved(f"system: {{transfer_matrix: [{listed}]}}\nfind: {{a: {{task: {TASK}{more}}}}}\n")


def by_numpy(K):
    K = np.array(K, dtype=complex)
    return K * np.linalg.inv(K).T


def values(M):
    return np.array(M.evalf(20).tolist(), dtype=complex)


def test_the_column_of_wood_and_berry():
    """λ₁₁ = 2.0094 in Wood and Berry, Chem. Eng. Sci. 28 (1973), and in every textbook since."""
    result = solved(f"{WOOD_BERRY}find: {{a: {TASK}}}\n")
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == ["gains", "inverse", "array", "sums", "pairing"]
    array = result.answers["Lambda"]
    assert array == sp.ImmutableMatrix([[12416, -6237], [-6237, 12416]]) / 6179
    pairing = result.steps[-1].values
    assert [entry for _, _, entry in pairing["pairs"]] == [array[0, 0], array[1, 1]]
    assert [(str(y), str(u)) for y, u, _ in pairing["negative"]] == [("y1", "u2"), ("y2", "u1")]


def test_dead_times_turn_the_gains_at_a_frequency():
    result = solved(f"{WOOD_BERRY}find: {{a: {{task: {TASK}, frequency: 0.1}}}}\n")
    assert result.status is Status.VERIFIED
    w = 0.1j
    K = [
        [12.8 * np.exp(-w) / (16.7 * w + 1), -18.9 * np.exp(-3 * w) / (21 * w + 1)],
        [6.6 * np.exp(-7 * w) / (10.9 * w + 1), -19.4 * np.exp(-3 * w) / (14.4 * w + 1)],
    ]
    assert np.allclose(values(result.answers["Lambda"]), by_numpy(K))


def test_four_tanks():
    g1, g2 = sp.symbols("g1 g2", real=True)
    result = asked([["g1/(s + 1)", "(1 - g2)/((s + 1)(3s + 1))"], ["(1 - g1)/((2s + 1)(4s + 1))", "g2/(2s + 1)"]])
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["Lambda"][0, 0] - g1 * g2 / (g1 + g2 - 1)) == 0
    assert [sp.expand(each) for each in result.steps[-1].values["exceptions"]] == [g1 + g2 - 1]


def test_three_channels_of_skogestad_and_postlethwaite():
    """Multivariable Feedback Control (2005), example 3.11: a stationary 3×3 plant."""
    K = [[16.8, 30.5, 4.30], [-16.7, 31.0, -1.41], [1.27, 54.1, 5.40]]
    result = asked([[f"{entry}/(s + 1)" for entry in row] for row in K])
    assert result.status is Status.VERIFIED
    array = values(result.answers["Lambda"])
    assert np.allclose(array, by_numpy(K))
    assert np.allclose(array.real, [[1.50, 0.99, -1.48], [-0.41, 0.97, 0.45], [-0.08, -0.95, 2.03]], atol=0.012)


@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        ([["1/s", "2/(s(s + 2))"], ["3/(s + 3)", "2/(s + 1)"]], [[2, -1], [-1, 2]]),
        ([["1/s^2", "1/(s + 1)"], ["2", "3/s"]], [[1, 0], [0, 1]]),
        ([["1/s", "1/s"], ["1/s", "2/s"]], [[2, -1], [-1, 2]]),
        # the rows without their poles are dependent, the limit is found from Λ(s)
        ([["1/s", "1/s"], ["1/s", "1/s + 1"]], None),
        ([["1/s", "1/(s + 1)"], ["1/s", "3/(s + 1)"]], [["3/2", "-1/2"], ["-1/2", "3/2"]]),
    ],
)
def test_at_a_pole_the_limit_is_taken(rows, expected):
    result = asked(rows)
    if expected is None:
        assert result.status is Status.UNSOLVED
        assert "without bound" in str(result.reason)
    else:
        assert result.status is Status.VERIFIED
        assert result.answers["Lambda"] == sp.ImmutableMatrix(expected).applyfunc(sp.sympify)


def test_a_pole_on_the_imaginary_axis():
    result = asked([["1/(s^2 + 4)", "1/(s + 2)"], ["1/(s + 1)", "s/(s^2 + 4)"]], ", frequency: 2")
    assert result.status is Status.VERIFIED
    assert result.answers["Lambda"] == sp.ImmutableMatrix(sp.eye(2))


@pytest.mark.parametrize(
    ("rows", "says"),
    [
        ([["1/(s + 1)", "2/(s + 1)"], ["2/(s + 2)", "4/(s + 2)"]], "is singular"),
        ([["1/s", "2/s"], ["2/s", "4/s"]], "singular everywhere"),
        ([["exp(-s)/s", "1/s"], ["1/s", "1/s"]], "dead times"),
    ],
)
def test_without_an_inverse_there_are_no_relative_gains(rows, says):
    result = asked(rows)
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)


def test_a_frequency_may_be_a_parameter():
    result = asked([["1/(s + 1)", "2/(s + 2)"], ["3/(s + 3)", "1/(s + 1)"]], ", frequency: omega")
    assert result.status is Status.VERIFIED


def test_discrete_time():
    text = "system: {time: discrete, sample_time: 1, A: [[1/2, 0], [0, 1/4]], B: [[1, 1], [0, 1]], C: [[1, 0], [1, 1]]}"
    result = solved(f"{text}\nfind: {{a: {TASK}}}\n")
    assert result.status is Status.VERIFIED
    A, B, C = np.diag([0.5, 0.25]), np.array([[1, 1], [0, 1]]), np.array([[1, 0], [1, 1]])
    assert np.allclose(values(result.answers["Lambda"]), by_numpy(C @ np.linalg.inv(np.eye(2) - A) @ B))


@settings(max_examples=25)
@given(st.integers(2, 4), st.data())
def test_random_plants_have_the_array_of_numpy(n, data):
    entries = data.draw(st.lists(st.integers(-3, 3), min_size=n * n, max_size=n * n))
    K = sp.ImmutableMatrix(n, n, entries)
    one = tuple(tuple(s + 1 for _ in range(n)) for _ in range(n))
    plant = TransferFunction(K / (s + 1), tuple(map(tuple, K.tolist())), one, s)
    result = ask(TASK, plant)
    if K.det() == 0:
        assert result.status is Status.UNSOLVED
        return
    assert result.status is Status.VERIFIED
    assert np.allclose(values(result.answers["Lambda"]), by_numpy(K.tolist()))
    pairs = result.steps[-1].values["pairs"]
    assert len({str(u) for _, u, _ in pairs}) == n


def test_corrupted_arrays_are_rejected():
    plant = system([[-1, 0], [0, -2]], B=[[1, 1], [0, 2]], C=[[1, 0], [1, 1]])
    array = ask(TASK, plant).answers["Lambda"]
    assert not rejected(TASK, plant, {"Lambda": array})
    changed = array + sp.ImmutableMatrix([[sp.Rational(1, 1000), 0], [0, 0]])
    for wrong in (changed, array.T * 2, array[:, ::-1], array.row_join(sp.ImmutableMatrix([0, 0]))):
        assert rejected(TASK, plant, {"Lambda": sp.ImmutableMatrix(wrong)})


PROBLEM = """
system: {transfer_matrix: [["2/(s + 1)", "1/(s + 1)"], ["3/(s + 1)", "4/(s + 1)"]]}
find: {a: relative_gain_array}
"""


@pytest.mark.parametrize(
    ("value", "right", "says"),
    [
        ("[[8/5, -3/5], [-3/5, 8/5]]", True, ""),
        ("[[1.6, -0.6], [-0.6, 1.6]]", True, ""),
        ("[[8/5, -1/5], [-9/5, 8/5]]", False, "not transposed"),
        ("[[-3/5, 8/5], [8/5, -3/5]]", False, "exchanged"),
        ("[[2, 1], [3, 4]]", False, "the gains themselves"),
        ("[[7/5, -4/5], [8/5, -1/5]]", False, "as matrices"),
    ],
)
def test_marking(value, right, says):
    found = verdict(PROBLEM, "a", "Lambda", value)
    assert (found.verdict.value == "correct") is right, found.reason
    assert says in str(found.reason)


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("system: {transfer_matrix: [[1/s, 1/s]]}\nfind: {a: relative_gain_array}\n", 2, "as many inputs as outputs"),
        ("system: {A: [[1]]}\nfind: {a: relative_gain_array}\n", 2, "needs a transfer matrix (or A, B and C)"),
        (
            'system: {transfer_matrix: [["exp(s)/(s + 1)", 1], [1, 2]]}\nfind: {a: relative_gain_array}\n',
            1,
            "comes out later",
        ),
        (
            'system: {transfer_matrix: [["exp(-s)/(s + 1)", 1], [1, 2]]}\nfind: {a: transfer_function}\n',
            2,
            "with their dead times the entries are no quotients of polynomials",
        ),
    ],
)
def test_faults_stand_at_their_places(text, line, message):
    with pytest.raises(InputError) as failed:
        solved(text)
    diagnostic = failed.value.diagnostics[0]
    assert message in diagnostic.message
    assert diagnostic.line == line
