"""Tasks of design: right answers in unusual forms, and the wrong ones that students write."""

import pytest

from tests.helpers.marked import verdict

pytestmark = pytest.mark.xdist_group("design")  # its problem is solved once

QUESTIONS = """
title: Design
system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}
find:
  poles: {task: desired_poles, damping_ratio: 1/2, settling_time: 4}
  one: {task: pole_placement, poles: ["-3 ± 2j"]}
  two: {task: pole_placement, method: unity_rank, poles: [-1, -2], system: {A: [[0, 1], [0, 0]], B: [[1, 0], [0, 1]]}}
  track: {task: reference_tracking, poles: ["-2 ± 2j"]}
  servo: {task: servo, poles: [-3, "-2 ± 2j"]}
  match: {task: model_matching, target: "2/((s+1)(s+4))"}
  observer: {task: observer, poles: [-6, -7]}
  both:
    task: observer
    method: unity_rank
    poles: [-1, -2]
    system: {A: [[0, 1], [0, 0]], B: [0, 1], C: [[1, 0], [0, 1]]}
  reduced: {task: reduced_observer, poles: [-6]}
  feedback: {task: observer_feedback, poles: [-4, -5], observer_poles: [-6, -7]}
  lqr: {task: lqr, Q: [[1, 0], [0, 1]], R: 1, initial_state: [1, 1], system: {A: [[0, 1], [0, 1]], B: [0, 1]}}
  kalman: {task: kalman_filter, Q: [[0, 0], [0, 4]], R: 1, system: {A: [[0, 1], [0, 0]], C: [1, 0]}}
  optimal: {task: optimal_tracking, Q: [[4, 0], [0, 1]], R: 1, system: {A: [[0, 1], [0, -2]], B: [0, 1], C: [1, 0]}}
"""

RIGHT = [
    ("poles", "poles", "-1 ± sqrt(3) j"),
    ("poles", "poles", "-1 ± 1.732j"),
    ("poles", "natural_frequency", "2.0"),
    ("poles", "damping_ratio", "0.5"),
    ("poles", "polynomial", "(s+1)^2 + 3"),
    ("one", "K", "[11, 3]"),
    ("one", "K", "[[22/2, 3.00]]"),
    ("one", "polynomial", "(s + 3 - 2j)(s + 3 + 2j)"),
    ("one", "gain_polynomial", "s(s + 3 + k2) + 2 + k1"),
    ("one", "closed_loop_A", "[[0, 1], [-13, -6]]"),
    ("two", "K", "[[1, 1], [0, 2]]"),
    ("two", "K", "[[0, 0], [2, 3]]"),
    ("two", "K", "[[0, 2], [-2, 3]]"),
    ("two", "closed_loop_A", "[[-1, 5], [0, -2]]"),
    ("track", "F", "[1, 0]"),
    ("track", "N", "2"),
    ("track", "K_o", "8.0"),
    ("servo", "K", "[18, 4]"),
    ("servo", "k_I", "24"),
    ("servo", "closed_loop_A", "[[0, 1, 0], [-20, -7, 24], [-1, 0, 0]]"),
    ("match", "feasible", "yes"),
    ("match", "compensator", "2(s+2)/(s+4)"),
    ("observer", "L", "[10, 10]"),
    ("observer", "L", "[[10], [10]]"),
    ("observer", "L", "[[10, 10]]"),
    ("observer", "error_A", "[[-10, 1], [-12, -3]]"),
    ("both", "L", "[[1, 1], [0, 2]]"),
    ("both", "L", "[[2, 1], [0, 1]]"),
    ("reduced", "L", "3"),
    ("reduced", "J", "[[-6]]"),
    ("reduced", "N", "-20"),
    ("reduced", "M", "1"),
    ("feedback", "eigenvalues", "[-7, -6, -5, -4]"),
    ("feedback", "closed_loop_A", "[[0, 1, 0, 0], [-20, -9, 18, 6], [0, 0, -10, 1], [0, 0, -12, -3]]"),
    ("lqr", "P", "[[2, 1], [1, 3]]"),
    ("lqr", "u", "-x1 - 3x2"),
    ("lqr", "eigenvalues", "[-1.000, -1]"),
    ("lqr", "equations", "[p12^2 - 1, p12 p22 - p11 - p12, p22^2 - 2p22 - 2p12 - 1]"),
    ("kalman", "L", "[2, 2]"),
    ("kalman", "eigenvalues", "-1 ± j"),
    ("optimal", "K", "[2, 1]"),
    ("optimal", "K_o", "2"),
]

WRONG = [
    ("poles", "poles", "1 ± sqrt(3) j"),
    ("poles", "poles", "-1 ± 1.73205j + 0.001"),
    ("poles", "polynomial", "s^2 + 2s + 2"),
    ("one", "K", "[-11, -3]"),
    ("one", "K", "[3, 11]"),
    ("one", "K", "[13, 6]"),
    ("one", "gain_polynomial", "s^2 + (3 - k2)s + 2 - k1"),
    ("one", "polynomial", "exp(1000 t)"),
    ("one", "polynomial", "exp(1000 s)"),
    ("two", "K", "[[1, 1], [0, 1]]"),
    ("two", "K", "[[-1, 1], [0, -2]]"),
    ("two", "closed_loop_A", "[[1, 5], [0, 2]]"),
    ("track", "F", "[0, 1]"),
    ("track", "K_o", "6"),
    ("servo", "k_I", "-24"),
    ("servo", "K", "[4, 18]"),
    ("servo", "closed_loop_A", "[[0, 1, 0], [-20, -7, 24], [1, 0, 0]]"),
    ("match", "feasible", "no"),
    ("match", "compensator", "(s+4)/(2(s+2))"),
    ("observer", "L", "[-10, -10]"),
    ("observer", "error_A", "[[10, 1], [8, -3]]"),
    ("both", "L", "[[1, 1], [0, 1]]"),
    ("reduced", "L", "-9"),
    ("reduced", "J", "6"),
    ("reduced", "N", "16"),
    ("feedback", "eigenvalues", "[-4, -5, -6]"),
    ("feedback", "closed_loop_A", "[[0, 1, 0, 0], [-20, -9, -18, -6], [0, 0, -10, 1], [0, 0, -12, -3]]"),
    ("lqr", "P", "[[-2, 1], [1, -1]]"),
    ("lqr", "u", "x1 + 3x2"),
    ("lqr", "K", "[2, 3]"),
    ("lqr", "equations", "[p12^2 + 1, p12 p22 - p11 - p12, p22^2 - 2p22 - 2p12 - 1]"),
    ("kalman", "eigenvalues", "1 ± j"),
    ("optimal", "K_o", "0"),
]


def _yaml(value):
    return value if value.startswith("[") else f'"{value}"'


@pytest.mark.parametrize(("part", "name", "value"), RIGHT)
def test_a_right_answer_is_right_in_any_form(part, name, value):
    found = verdict(QUESTIONS, part, name, _yaml(value))
    assert found.verdict == "correct", found.reason


@pytest.mark.parametrize(("part", "name", "value"), WRONG)
def test_a_wrong_answer_is_wrong(part, name, value):
    assert verdict(QUESTIONS, part, name, _yaml(value)).verdict == "wrong"
