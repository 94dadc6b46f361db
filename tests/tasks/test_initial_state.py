"""Initial states against the motions from them: derivatives and samples, several outputs, what has no answer."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import CheckStatus, Status
from solver.engine import refusals_of, solve_problem
from solver.messages import Messages
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

PLANT = "A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0], D: 2"


def read(system, asked):
    text = f"system: {{{system}}}\nfind: {{a: {{task: initial_state, {asked}}}}}\n"
    return read_problem(Source("file.yaml", text), catalogue())


def solved(system, asked):
    return solve_problem(read(system, asked)).parts[0]


def rejected(system, asked, x0):
    task, part = catalogue()["initial_state"], read(system, asked).parts[0]
    checks = task.verify(task.given(part.system, part.options), {"x0": sp.ImmutableMatrix(x0)})
    return any(check.status is CheckStatus.FAILED for check in checks)


def test_output_and_derivative_without_and_with_an_input():
    assert solved(PLANT, "y: [1, 0]").answers["x0"] == sp.Matrix([1, 0])
    asked = "y: [1, 0], u: [1, -1]"
    result = solved(PLANT, asked)
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == ["rows", "stacked", "solution"]
    assert result.answers["x0"] == sp.Matrix([-1, 2])
    assert not rejected(PLANT, asked, [-1, 2])
    for wrong in ([1, 0], [-1, -2], [2, -1], [-1, sp.Rational(201, 100)], [-1, 2, 0]):
        assert rejected(PLANT, asked, wrong)


entries = st.integers(-3, 3)


nine = st.lists(entries, min_size=9, max_size=9)


@settings(max_examples=15, deadline=None)
@given(nine, nine, st.booleans(), st.booleans())
def test_generated_states_are_found_again(of_a, others, discrete, two_outputs):
    A, B, x0 = np.array(of_a).reshape(3, 3), np.array(others[:3]).reshape(3, 1), np.array(others[3:6])
    C = np.array([[1, 0, 0], [0, 1, 1]])[: 2 if two_outputs else 1]
    count = 3
    stacked = np.vstack([C @ np.linalg.matrix_power(A, k) for k in range(count)])
    u, x, y = others[6:9], x0, []
    for k in range(count):
        y += list(map(int, C @ x))
        x = A @ x + B[:, 0] * u[k]
    time = "time: discrete, " if discrete else ""
    system = f"{time}A: {A.tolist()}, B: {B.tolist()}, C: {C.tolist()}"
    result = solved(system, f"y: {y}, u: {u}")
    if np.linalg.matrix_rank(stacked) < 3:
        assert result.status is Status.UNSOLVED
    else:
        assert result.status is Status.VERIFIED
        assert list(result.answers["x0"]) == list(x0)


@pytest.mark.parametrize(
    ("system", "asked", "says"),
    [
        ("A: [[1, 0], [0, 1]], C: [1, 1]", "y: [1, 2]", "initial_state/unobservable"),
        (PLANT, "y: [1]", "initial_state/too_few"),
        (PLANT, "y: [1, 0, 7]", "initial_state/contradiction"),
    ],
)
def test_what_has_no_answer(system, asked, says):
    result = solved(system, asked)
    assert result.status is Status.UNSOLVED
    assert result.reason.kind == says


def test_a_transfer_function_is_realized_and_symbols_stay():
    result = solved('transfer_function: "(s + 3)/(s^2 + 3s + 2)"', "y: [1, y_1], u: [u_0]")
    y, u = sp.symbols("y_1 u_0", real=True)
    assert result.status is Status.VERIFIED
    assert result.answers["x0"] == sp.Matrix([u / 2 - y / 2, 1 - sp.Rational(3, 2) * u + sp.Rational(3, 2) * y])


def test_values_of_several_outputs_come_together():
    (part,) = read("A: [[0, 1], [-2, -3]], C: [[1, 0], [0, 1]]", "y: [1, 2, 3]").parts
    ((option, message),) = refusals_of(part, Messages())
    assert option == "y"
    assert "2 by 2" in message
