"""Questions without an answer: each is refused in words that name the reason, by the file or by the mathematics."""

import pytest
import sympy as sp
import yaml

from solver.derivation import Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.asking import system

INTEGRATORS = {"A": [[0, 1], [0, 0]], "B": [[0], [1]], "C": [[1, 0]]}
STABLE = {"A": [[0, 1], [-2, -3]], "B": [[0], [1]], "C": [[1, 0]]}
UNREACHED = {"A": [[1, 0], [0, -2]], "B": [[0], [1]], "C": [[0, 1]]}
AT_REST = {"A": [[0, 1], [-2, -3]], "B": [[0], [1]], "C": [[0, 1]]}
"""Its transfer function s/(s² + 3s + 2) has a zero at the origin."""
TWO_OUTPUTS = {"A": [[0, 1], [-2, -3]], "B": [[0], [1]], "C": [[1, 0], [0, 1]]}
DEFECTIVE = {"A": [[-1, 1], [0, -1]], "B": [[0], [1]], "C": [[1, 0]]}
WIDE = {"matrix": [[1, 2, 3], [4, 5, 6]]}

FROM_THE_FILE = [
    ("similarity_transformation", STABLE, {"T": [[1, 2], [2, 4]]}, "singular"),
    ("similarity_transformation", STABLE, {"T": [[1, 2, 3], [2, 4, 5]]}, "must have 2 columns"),
    ("characteristic_polynomial", WIDE, {}, "square"),
    ("eigenstructure", WIDE, {}, "square"),
    ("routh_hurwitz", WIDE, {}, "needs a polynomial; the matrix is not square"),
    ("state_space_model", STABLE, {}, "needs equations; the system has only A, B, C and D"),
    ("stability", {"equations": ["x' = x^2"]}, {}, "linearization first"),
    ("controllability", {"equations": ["x' = -x"]}, {}, "needs B; the system is given by its equations, without"),
    ("routh_hurwitz", {"polynomial": "5"}, {}, "a constant has no roots"),
    ("routh_hurwitz", {"polynomial": "1/s"}, {}, "a polynomial is expected here, not a quotient"),
    ("routh_hurwitz", {"polynomial": "s + K"}, {"parameter": "k"}, "'k' is no name in the system"),
    ("routh_hurwitz", {"polynomial": "z + 1", "time": "discrete"}, {}, "in discrete time"),
    ("routh_hurwitz", {"A": [[0, 1], [-2, "k"]]}, {"parameter": "x2"}, "x2 is no parameter of the system"),
    ("stability_range", {"A": [[0, 1], [-2, -3]]}, {"parameters": "x1"}, "x1 is no parameter of the system"),
    ("controllability", {"polynomial": "s + 1"}, {}, "needs B; the system is given by its characteristic polynomial"),
    ("matrix_function", WIDE, {"function": "A^2"}, "square"),
    ("matrix_function", STABLE, {"function": "x^4"}, "a function of the matrix is expected here, in A"),
    ("matrix_function", STABLE, {"function": "2"}, "a function of the matrix is expected here, in A"),
    ("controllability", {"A": [[0, 1], [-2, -3]]}, {}, "needs B"),
    ("observability", {"A": [[0, 1], [-2, -3]], "B": [[0], [1]]}, {}, "needs C"),
    ("lqr", {"A": [[0, 1], [0, 0]]}, {"Q": [[1, 0], [0, 1]], "R": 1}, "needs B"),
    ("observer", {"A": [[0, 1], [0, 0]]}, {"poles": [-1, -2]}, "needs C"),
    ("model_matching", STABLE, {"target": "s"}, "improper"),
    ("realization", {"transfer_function": "s^2/(s + 1)"}, {}, "improper"),
    ("stability", STABLE, {"method": "lyapunov", "Q": [[1, 2], [0, 1]]}, "symmetric"),
    ("stability", STABLE, {"method": "lyapunov", "Q": [[1, 0], [0, -1]]}, "positive definite"),
    ("pole_placement", STABLE, {"poles": [-1]}, "give 2"),
    ("pole_placement", STABLE, {"poles": [-1, "-2 + 1j"]}, "no conjugate"),
    ("pole_placement", STABLE, {}, "say where the poles are to be"),
    ("servo", STABLE, {"poles": [-1, -2]}, "3 poles"),
    ("observer", STABLE, {"poles": [-1, -2, -3]}, "order n = 2"),
    ("reduced_observer", STABLE, {"poles": [-1, -2]}, "order n − p = 2 − 1 = 1"),
    ("observer_feedback", STABLE, {"poles": [-1, -2]}, "needs 'observer_poles'"),
    ("lqr", INTEGRATORS, {"Q": [[1, 2], [0, 1]], "R": 1}, "symmetric"),
    ("lqr", INTEGRATORS, {"Q": [[1, 0], [0, -1]], "R": 1}, "semidefinite"),
    ("lqr", INTEGRATORS, {"Q": [[1, 0], [0, 1]], "R": 0}, "positive definite"),
    ("lqr", INTEGRATORS, {"Q": [[1, 0], [0, 1]], "R": [[1, 0], [0, 1]]}, "must have 1 row"),
    ("lqr", INTEGRATORS, {"Q": [[1, 0], [0, 1]], "output_weight": 1}, "twice"),
    ("kalman_filter", INTEGRATORS, {"Q": [[1, 0], [0, 1]], "R": -1}, "positive definite"),
    ("optimal_tracking", INTEGRATORS, {"Q": [[1, 0], [0, 1]], "gain": [1, 1]}, "twice"),
    ("reference_tracking", INTEGRATORS, {"gain": [1, 1], "poles": [-1, -2]}, "leave out one"),
    ("eigenstructure", {"A": [[1, 2, 3], [4, 5, 6]]}, {}, "square"),
    ("transfer_function", {"A": [[0, 1], [-2, -3]], "B": [[0], [1]]}, {}, "or A, B and C"),
    ("phase_portrait", {"A": [[1, 0, 0], [0, 2, 0], [0, 0, 3]]}, {}, "two states"),
    ("controllability", STABLE, {"method": "gramian", "horizon": -1}, "positive"),
    ("state_transition_matrix", STABLE, {"method": "power_series", "terms": 0}, "at least 1"),
    ("parameter_condition", STABLE, {"property": "uncontrollable", "parameter": "q"}, "'q' is no name"),
    ("minimum_energy_control", {**INTEGRATORS, "time": "discrete"}, {"final_time": 1}, "in discrete time"),
    ("kalman_filter", INTEGRATORS, {}, "give Q"),
    ("reduced_observer", TWO_OUTPUTS, {"poles": []}, "all states are measured"),
    ("model_matching", TWO_OUTPUTS, {"target": "1/(s + 1)"}, "one input and one output"),
    ("response", STABLE, {"kind": "zero_input"}, "initial"),
    ("response", STABLE, {"kind": "zero_state"}, "input"),
    ("desired_poles", STABLE, {"damping_ratio": "1/2"}, "two specifications"),
    ("desired_poles", STABLE, {"settling_time": -1, "overshoot": "10%"}, "positive"),
    ("desired_poles", STABLE, {"damping_ratio": "1/2", "overshoot": "20%"}, "speed is not fixed"),
    ("desired_poles", STABLE, {"overshoot": "120%", "settling_time": 4}, "less than 1"),
]
"""Task, system, options, and words of the message."""

FROM_THE_MATHEMATICS = [
    ("matrix_function", {"matrix": [[1, 2], [2, 4]]}, {"function": "inv(A)"}, "not defined at the eigenvalue"),
    ("realization", DEFECTIVE, {"form": "diagonal"}, "is repeated"),
    ("controllability", UNREACHED, {"method": "gramian"}, "left half plane"),
    ("pole_placement", UNREACHED, {"poles": [-3, -4]}, "uncontrollable: no gain moves it"),
    ("pole_placement", UNREACHED, {"poles": [-3, -4], "method": "ackermann"}, "uncontrollable: no gain moves it"),
    ("pole_placement", UNREACHED, {"poles": [-3, -4], "method": "bass_gura"}, "uncontrollable: no gain moves it"),
    ("pole_placement", UNREACHED, {"poles": [-3, -4], "method": "canonical_form"}, "uncontrollable: no gain moves it"),
    ("observer", UNREACHED, {"poles": [-3, -4]}, "not detectable"),
    ("reduced_observer", UNREACHED, {"poles": [-3]}, "not detectable"),
    ("lqr", UNREACHED, {"Q": [[1, 0], [0, 1]], "R": 1}, "not stabilizable"),
    ("lqr", INTEGRATORS, {"Q": [[0, 0], [0, 0]], "R": 1}, "imaginary axis"),
    ("kalman_filter", UNREACHED, {"Q": [[1, 0], [0, 1]], "R": 1}, "not detectable"),
    ("optimal_tracking", TWO_OUTPUTS, {"Q": [[1, 0], [0, 1]], "R": 1}, "fewer inputs"),
    ("reference_tracking", TWO_OUTPUTS, {"poles": [-1, -2]}, "under-actuated"),
    ("reference_tracking", AT_REST, {"poles": [-1, -2]}, "zero at"),
    ("servo", AT_REST, {"poles": [-1, -2, -3]}, "zero at"),
    ("servo", TWO_OUTPUTS, {"poles": [-1, -2, -3, -4]}, "fewer inputs"),
    ("observer_feedback", UNREACHED, {"gain": [0, 1], "observer_poles": [-3, -4]}, "unobservable"),
    ("pole_placement", STABLE, {"poles": [-1, -3], "structure": ["p", 0]}, "contradict"),
    ("matrix_function", {"matrix": [[0, 1], [0, 0]]}, {"function": "sqrt(A)", "method": "modal"}, "not differentiable"),
    ("matrix_function", {"matrix": [[0, 1], [0, 0]]}, {"function": "sqrt(A)"}, "not differentiable"),
    ("response", STABLE, {"kind": "zero_state", "input": "1/(t + 1)"}, "not rational"),
    ("response", STABLE, {"kind": "zero_state", "input": "tan(t)"}, "not rational"),
]


def outcome(task, plant, options):
    """What a problem file with this question ends with: "refused" or the status, and the words."""
    text = yaml.safe_dump({"system": plant, "find": {"a": {"task": task, **options}}})
    try:
        part = solve_problem(read_problem(Source("question.yaml", text), catalogue())).parts[0]
    except InputError as refusal:
        return "refused", str(refusal)
    return part.status, str(part.reason)


def named(row):
    task, _, options, words = row
    return "-".join([task, *options, *words.split()])


@pytest.mark.parametrize("row", FROM_THE_FILE, ids=named)
def test_what_the_file_shows_is_refused_at_its_place(row):
    *question, words = row
    status, reason = outcome(*question)
    assert status == "refused"
    assert words in reason


@pytest.mark.parametrize(("task", "option"), [("routh_hurwitz", "parameter"), ("stability_range", "parameters")])
def test_a_parameter_may_come_with_the_gain_and_is_not_judged_before_the_gain_is_known(task, option):
    plant, k = system([[0, 1], [-2, -3]], B=[[0], [1]]), sp.Symbol("k")
    gains = {"with": sp.ImmutableMatrix([[k, 1]]), "without": sp.ImmutableMatrix([[1, 1]]), "not known": None}
    faults = {name: list(catalogue()[task].refused(plant, {option: ("k",), "gain": K})) for name, K in gains.items()}
    assert {name for name, found in faults.items() if found} == {"without"}


@pytest.mark.parametrize("row", FROM_THE_MATHEMATICS, ids=named)
def test_what_the_mathematics_shows_leaves_the_part_unsolved_with_the_reason(row):
    *question, words = row
    status, reason = outcome(*question)
    assert status is Status.UNSOLVED
    assert words in reason
    assert reason.endswith(".")
