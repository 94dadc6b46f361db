"""Tasks of representation and analysis: right answers in unusual forms, and the wrong ones that students write."""

import pytest

from tests.helpers.marked import marked, verdict

pytestmark = pytest.mark.xdist_group("analysis")  # its problem is solved once

QUESTIONS = """
title: Analysis
system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}
find:
  polynomial: characteristic_polynomial
  controllable: controllability
  observable: observability
  hidden: {task: controllability, system: {A: [[-1, 0], [0, -2]], B: [1, 0]}}
  stabilizable: {task: stabilizability, system: {A: [[1, 0], [0, -2]], B: [1, 0]}}
  detectable: {task: detectability, system: {A: [[1, 0], [0, -2]], C: [0, 1]}}
  eigen: eigenstructure
  spaces: {task: fundamental_subspaces, matrix: [[1, 0, 1], [0, 1, 1]]}
  kalman: {task: kalman_decomposition, system: {A: [[-2, -2, -2], [1, 0, 0], [1, 1, -1]], B: [1, 0, 0], C: [1, 1, 0]}}
  root: {task: matrix_function, function: "sqrt(A)", system: {matrix: [[5, 4], [4, 5]]}}
  minimal: {task: minimal_realization, system: {transfer_function: "(s + 2)/(s^2 + 5s + 6)"}}
  lost: {task: parameter_condition, system: {A: [[2, alpha - 1], [0, 2]], B: [1, alpha], C: [1, 0]}}
  always: {task: parameter_condition, system: {A: [[alpha, 0], [0, alpha]], B: [1, 1]}}
  portrait: {task: phase_portrait, system: {matrix: [[0, 1], [-5, -2]]}}
  realized: {task: realization, convention: last_row, system: {transfer_function: "(s+5)/(s^2+3s+2)"}}
  modes: {task: realization, form: diagonal, system: {transfer_function: "(s+5)/(s^2+3s+2)"}}
  response: {task: response, kind: zero_state, input: 1}
  pulse: {task: response, input: "step(t) - step(t - 2)", system: {A: [[-1]], B: [1], C: [1]}}
  samples: {task: response, kind: zero_state, input: 1, system: {time: discrete, A: [["1/2"]], B: [1], C: [1]}}
  similar: {task: similarity_transformation, T: [[1, 1], [-1, -2]]}
  stable: {task: stability, method: lyapunov}
  routh: {task: stability, method: routh}
  range: {task: stability_range, system: {matrix: [[0, 1, 0], [0, 0, 1], [-K, -2, -3]]}}
  Phi: state_transition_matrix
  steps: {task: state_transition_matrix, system: {time: discrete, A: [[0, 1], [0, "1/2"]]}}
  G: transfer_function
"""

RIGHT = [
    ("polynomial", "polynomial", "(λ + 1)(λ + 2)"),
    ("controllable", "determinant", "-1.0"),
    ("controllable", "controllability_matrix", "[[0, 1], [1, -3]]"),
    ("observable", "observability_matrix", "[[1, 0], [0, 1]]"),
    ("hidden", "uncontrollable_modes", "[-2]"),
    ("hidden", "uncontrollable_modes", "-2"),
    ("stabilizable", "stabilizable", "yes"),
    ("stabilizable", "hidden_modes", "[-2.0]"),
    ("detectable", "detectable", "false"),
    ("eigen", "right_eigenvectors", "[[1, 0.5], [-1, -1]]"),
    ("eigen", "right_eigenvectors", "[[1, 3j], [-2, -3j]]"),
    ("eigen", "left_eigenvectors", "[[4, 2], [1, 1]]"),
    ("eigen", "jordan_form", "[[-2, 0], [0, -1]]"),
    ("spaces", "null_space", "[[2], [2], [-2]]"),
    ("spaces", "null_space", "[0.577, 0.577, -0.577]"),
    ("spaces", "column_space", "[[1, 1], [1, -1]]"),
    ("spaces", "row_space", "[[1, 1], [0, 1], [1, 2]]"),
    ("spaces", "left_null_space", "[]"),
    ("kalman", "orders", "[2, 1]"),
    ("kalman", "T", "[[1, 0, 0], [0, 1, 0], [0, 1, 1]]"),
    ("kalman", "hidden_modes", "[-1]"),
    ("root", "F", "[[2, 1], [1, 2]]"),
    ("minimal", "A", "-3"),
    ("minimal", "cancelled", "[-2]"),
    ("lost", "values", "[1, 0]"),
    ("always", "values", "all"),
    ("portrait", "kind", "Stable_Focus"),
    ("portrait", "eigenvalues", "-1 ± 2i"),
    ("realized", "A", "[[0, 1], [-2, -3]]"),
    ("realized", "C", "[5, 1]"),
    ("modes", "A", "[[-2, 0], [0, -1]]"),
    ("response", "y", "1/2 - e^(-t) + e^(-2t)/2"),
    ("response", "y", "(1 - e^(-t))^2/2"),
    ("response", "y", "0.5(1 - e^(-t))^2"),
    ("response", "x", "[(1 - e^(-t))^2/2, e^(-t) - e^(-2t)]"),
    ("response", "y_final", "0.5"),
    ("pulse", "y", "(1 - exp(-t)) - (1 - exp(2 - t)) step(t - 2)"),
    ("samples", "y", "2 - 2^(1 - k)"),
    ("similar", "A", "[[-1.0, 0], [0, -2]]"),
    ("stable", "P", "[[1.25, 0.25], [0.25, 0.25]]"),
    ("stable", "verdict", "Asymptotically Stable"),
    ("stable", "verdict", "asymptotically-stable"),
    ("stable", "verdict", "asymptotically_stable"),
    ("routh", "array", "[[1, 2], [3, 0], [2, 0]]"),
    ("range", "condition", "0 < K < 6"),
    ("range", "condition", "K > 0 and 6 - K > 0"),
    ("range", "condition", "(K < 6) & (0 < K)"),
    ("Phi", "Phi", "[[2e^(-t) - e^(-2t), e^(-t) - e^(-2t)], [2e^(-2t) - 2e^(-t), 2e^(-2t) - e^(-t)]]"),
    ("steps", "Phi", "[[delta(k), 2(1/2)^k - 2delta(k)], [0, 0.5^k]]"),
    ("G", "G", "1/((s+1)(s+2))"),
    ("G", "G", "1/(s+1) - 1/(s+2)"),
    ("G", "zeros", "[]"),
]

WRONG = [
    ("polynomial", "polynomial", "λ^2 - 3λ + 2"),
    ("controllable", "determinant", "1"),
    ("controllable", "controllability_matrix", "[[0, 1], [1, 3]]"),
    ("observable", "observability_matrix", "[[1, 0], [1, 0]]"),
    ("hidden", "uncontrollable_modes", "[-1]"),
    ("hidden", "uncontrollable_modes", "[]"),
    ("stabilizable", "stabilizable", "no"),
    ("detectable", "hidden_modes", "[-2]"),
    ("eigen", "right_eigenvectors", "[[0, 1], [0, -2]]"),
    ("eigen", "right_eigenvectors", "[[1, 2], [-1, -2]]"),
    ("eigen", "jordan_form", "[[-2, 1], [0, -1]]"),
    ("spaces", "null_space", "[1, 1, 1]"),
    ("spaces", "column_space", "[[1, 2], [1, 2]]"),
    ("kalman", "orders", "[1, 2]"),
    ("kalman", "T", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]"),
    ("kalman", "hidden_modes", "[-1, -1]"),
    ("root", "F", "[[sqrt(5), 2], [2, sqrt(5)]]"),
    ("minimal", "A", "-2"),
    ("lost", "values", "[1]"),
    ("lost", "values", "all"),
    ("always", "values", "[0]"),
    ("portrait", "kind", "stable node"),
    ("realized", "C", "[1, 5]"),
    ("modes", "A", "[[2, 0], [0, 1]]"),
    ("response", "y", "1/2 - e^(-t)"),
    ("response", "y", "1/2 + e^(-t) + e^(-2t)/2"),
    ("pulse", "y", "1 - exp(-t)"),
    ("pulse", "y", "1.0 - exp(-t)"),
    ("samples", "y", "2 - 2^(-k)"),
    ("similar", "A", "[[-2, 0], [0, -1]]"),
    ("stable", "P", "[[5/4, 1/4], [-1/4, 1/4]]"),
    ("stable", "verdict", "marginally stable"),
    ("routh", "array", "[[1, 2], [3, 0], [-2, 0]]"),
    ("range", "condition", "0 < K"),
    ("range", "condition", "0 < K < 5"),
    ("range", "condition", "K < 0 or K > 6"),
    ("range", "condition", "never"),
    ("Phi", "Phi", "[[e^(-t), 0], [0, e^(-2t)]]"),
    ("steps", "Phi", "[[0, 2(1/2)^k], [0, 0.5^k]]"),
    ("G", "G", "s/((s+1)(s+2))"),
    ("G", "poles", "[1, 2]"),
]


def _yaml(value):
    return value if value.startswith("[") and not value.endswith(")") else f'"{value}"'


@pytest.mark.parametrize(("part", "name", "value"), RIGHT)
def test_a_right_answer_is_right_in_any_form(part, name, value):
    found = verdict(QUESTIONS, part, name, _yaml(value))
    assert found.verdict == "correct", found.reason


@pytest.mark.parametrize(("part", "name", "value"), WRONG)
def test_a_wrong_answer_is_wrong(part, name, value):
    assert verdict(QUESTIONS, part, name, _yaml(value)).verdict == "wrong"


@pytest.mark.parametrize("answers", [
    "{A: [[-2, 0], [0, -1]], B: [1, 1], C: [-3, 4]}", "{A: [[-1, 0], [0, -2]], B: [2, 3], C: [2, -1]}",
    "{A: [[-1, 0], [0, -2]], B: [4, -3], C: [1, 1]}",
])  # fmt: skip
def test_any_realization_of_the_form_is_right(answers):
    found = marked(QUESTIONS, f"answers: {{modes: {answers}}}")["modes"].answers
    assert {str(each.verdict) for each in found.values()} == {"correct"}


def test_a_realization_that_does_not_fit_together_is_wrong():
    found = marked(QUESTIONS, "answers: {modes: {A: [[-1, 0], [0, -2]], B: [1, 1], C: [-3, 4]}}")["modes"].answers
    assert "wrong" in {str(each.verdict) for each in found.values()}
