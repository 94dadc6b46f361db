"""A parameter may have the name of anything that a page gives a name to: what is printed is a value, not a name."""

import json

import pytest

import solver

POLES = [-2, -3]
QUESTIONS = {
    "vectors": {"task": "eigenstructure"},
    "modes": {"task": "controllability", "method": "pbh"},
    "modal": {"task": "state_transition_matrix", "method": "modal"},
    "coefficients": {"task": "state_transition_matrix", "method": "cayley_hamilton"},
    "placement": {"task": "pole_placement", "method": "bass_gura", "poles": POLES},
    "observer": {"task": "reduced_observer", "poles": [-3]},
    "transfer": {"task": "transfer_function"},
    "coordinates": {"task": "similarity_transformation", "T": [[1, 1], [0, 1]]},
    "parts": {"task": "kalman_decomposition"},
    "regulator": {"task": "lqr", "Q": [[1, 0], [0, 1]], "R": 1},
    "tracking": {"task": "reference_tracking", "poles": POLES},
    "response": {"task": "response", "method": "convolution", "kind": "zero_state", "input": "1"},
}


def statuses(name, *asked):
    """How the questions end about an oscillator with a parameter of this name."""
    problem = {
        "title": "An oscillator",
        "assume": {name: "positive"},
        "system": {"A": [[0, name], [f"-{name}", -1]], "B": [0, 1], "C": [1, 0]},
        "find": {part: QUESTIONS[part] for part in asked or QUESTIONS},
    }
    return {part.id: part.status for part in solver.solve(json.dumps(problem, indent=1)).parts}


@pytest.mark.parametrize(
    ("name", "asked"), [("w", "vectors"), ("w", "modes"), ("v", "modal"), ("T", "coordinates"), ("K", "tracking")]
)
def test_a_parameter_with_a_name_of_the_page_is_a_value(name, asked):
    assert statuses(name, asked) == {asked: "verified"}


@pytest.mark.slow
@pytest.mark.parametrize("name", "w v T P K x tau".split())
def test_whatever_a_parameter_is_called_the_answers_are_verified(name):
    assert statuses(name) == dict.fromkeys(QUESTIONS, "verified")
