"""Each of the usual mistakes is found and named; and only where it leads to the very value submitted."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.classroom.mistakes import changed
from solver.engine import found_by
from tests.helpers.marked import marked, solved, verdict
from tests.helpers.students import written

pytestmark = pytest.mark.xdist_group("mistakes")  # its problem is solved once

PLANT = """
title: Mistakes
system: {A: [[1, 2], [3, 1]], B: [0, 1], C: [1, 3], D: [[2]], initial_state: [1, 0]}
find:
  gain: {task: pole_placement, method: ackermann, poles: [-3, -4]}
  observer: {task: observer, poles: [-3, -4]}
  order: {task: similarity_transformation, T: [[1, 1], [1, 2]]}
  eigen: eigenstructure
  defective: {task: state_transition_matrix, system: {A: [[-1, 1], [0, -1]]}}
  oscillator: {task: state_transition_matrix, system: {A: [[0, 1], [-5, -2]]}}
  repeated: {task: eigenstructure, system: {A: [[3, 1, 0], [0, 3, 0], [0, 0, 2]]}}
  lyapunov: {task: stability, method: lyapunov, system: {A: [[0, 1], [-2, -3]]}}
  riccati: {task: lqr, Q: [[1, 0], [0, 1]], R: 1, system: {A: [[0, 1], [0, 1]], B: [0, 1]}}
  specified: {task: desired_poles, overshoot: 0.1, rise_time: 2}
  transfer: transfer_function
  symmetric: {task: transfer_function, system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}}
  polynomial: {task: characteristic_polynomial, system: {matrix: [[1, 2, 0], [0, 1, 1], [1, 0, 3]]}}
  reachable: {task: controllability, system: {A: [[1, 2], [3, 1]], B: [[0, 1], [1, 1]]}}
  visible: {task: observability, system: {A: [[1, 2], [3, 1]], C: [[1, 0], [1, 1]]}}
  realized: {task: realization, convention: last_row, system: {transfer_function: "(s+5)/(s^2+3s+2)"}}
  power: {task: matrix_function, function: "A^3"}
  response: {task: response, kind: complete, input: "1", initial_state: [1, 0],
             system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}}
"""

MISTAKES = [
    ("gain", "K", "[-13, -9]", "it is the gain of $A + BK_f$; the feedback is subtracted, $A - BK_f$"),
    ("gain", "K", "[9, 13]", "the entries stand in reverse order"),
    ("gain", "K", "[6, -5]", "the poles have the wrong sign"),
    ("gain", "K", "[63, -23]", "the poles are squared"),
    ("gain", "closed_loop_A", "[[1, 2], [16, 10]]", "$+$ stands where $-$ belongs: the feedback is subtracted"),
    ("observer", "L", "[[-36/17, 63/17]]", ""),
    ("eigen", "right_eigenvectors", "[[sqrt(6), -sqrt(6)], [2, 2]]", "left and right eigenvectors are exchanged"),
    ("eigen", "eigenvalues", "[1, 1]", "these are the entries on the diagonal of $A$"),
    ("eigen", "eigenvalues", "-1 ± sqrt(6)", "the sign is reversed"),
    ("eigen", "eigenvalues", "[3.44, -1.44]", "the last digit is cut off, not rounded"),
    ("defective", "Phi", "[[exp(-t), exp(-t)], [0, exp(-t)]]",
     "the factor $t$ (or $k$) of a repeated eigenvalue is missing"),
    ("defective", "Phi", "[[exp(-t), exp(t)], [1, exp(-t)]]",
     "the function is taken of each entry; it is a function of the matrix"),
    ("defective", "Phi", "[[exp(-t), -t exp(-t)], [0, exp(-t)]]", "the sign of an entry is reversed"),
    ("oscillator", "Phi", "[[exp(t)(cos(2t) - sin(2t)/2), -exp(t) sin(2t)/2],"
                          " [5 exp(t) sin(2t)/2, exp(t)(cos(2t) + sin(2t)/2)]]",
     "the sign of the exponents is reversed"),
    ("repeated", "eigenvalues", "[2, 3]", "each value counts as often as its multiplicity"),
    ("lyapunov", "P", "[[-5/4, -1/4], [-1/4, -1/4]]", "the sign is reversed"),
    ("lyapunov", "P", "[[5/2, 1/2], [1/2, 1/2]]", "it is twice what it should be: a factor ½ is missing"),
    ("lyapunov", "P", "[[5/8, 1/8], [1/8, 1/8]]", "a factor 2 is missing"),
    ("transfer", "G", "(3s - 1)/(s^2 - 2s - 5)", "$D$ is forgotten"),
    ("symmetric", "G", "s^2 + 3s + 2", "numerator and denominator are exchanged"),
    ("polynomial", "polynomial", "-lambda^3 + 5lambda^2 - 7lambda + 5",
     r"it is $\det(A - \lambda I)$, not $\det(\lambda I - A)$"),
    ("reachable", "controllability_matrix", "[[0, 1], [1, 1], [2, 3], [1, 4]]",
     "$B$, $AB$, … stand beside each other, $C$, $CA$, … one below the other; here it is the reverse"),
    ("visible", "observability_matrix", "[[1, 0, 1, 2], [1, 1, 4, 3]]",
     "$B$, $AB$, … stand beside each other, $C$, $CA$, … one below the other; here it is the reverse"),
    ("realized", "A", "[[0, -2], [1, -3]]", "it is transposed: rows and columns are exchanged"),
    ("realized", "B", "[5, 1]", "it is the observable form"),
    ("realized", "A", "[[-3, -2], [1, 0]]",
     "it follows the other convention: coefficients in the first row (column)"),
    ("power", "F", "[[1, 8], [27, 1]]", "the function is taken of each entry; it is a function of the matrix"),
    ("response", "y", "1/2 - exp(-t) + exp(-2t)/2", "the initial state is forgotten"),
]  # fmt: skip


@pytest.mark.parametrize(("part", "name", "value", "words"), MISTAKES)
def test_a_usual_mistake_is_named(part, name, value, words):
    found = verdict(PLANT, part, name, value if value.startswith("[") else f'"{value}"')
    assert found.verdict == "wrong"
    assert not words or found.reason == words


def test_the_wrong_root_of_the_riccati_equation_is_named():
    for result in solved(PLANT).parts:
        if result.id == "riccati":
            others = [P for P in result.answers["solutions"] if result.answers["P"] != P]
    for other in others:
        found = verdict(PLANT, "riccati", "P", written(other))
        assert found.verdict == "wrong"
        assert found.reason in (
            "it solves the Riccati equation, but it is not the stabilising solution", "the sign is reversed"
        )  # fmt: skip
        found = verdict(PLANT, "riccati", "K", written(other[1:, :]))
        assert found.reason in (
            "it comes from a solution of the Riccati equation that is not the stabilising one", "the sign is reversed"
        )  # fmt: skip


def test_degrees_for_radians_are_named():
    answers = next(result.answers for result in solved(PLANT).parts if result.id == "specified")
    ours = answers["natural_frequency"]
    degrees = ours.replace(sp.acos, lambda z: sp.acos(z) * 180 / sp.pi)
    if ours != degrees:
        found = verdict(PLANT, "specified", "natural_frequency", written(degrees))
        assert found.reason == "an angle is in degrees where radians are meant"


def test_an_unfinished_product_is_named():
    found = verdict(PLANT, "order", "A", "[[3, 5], [4, 5]]")  # A T, not yet multiplied by T⁻¹
    assert found.verdict == "wrong"


@pytest.mark.parametrize(
    ("part", "name", "value"),
    [
        ("gain", "K", "[12, 9.1]"),
        ("reachable", "rank", "1"),
        ("reachable", "controllable", "no"),
        ("polynomial", "polynomial", "lambda^3 - 5lambda^2 + 7lambda + 5"),
    ],
)
def test_nothing_is_said_where_no_mistake_leads_to_the_value(part, name, value):
    found = verdict(PLANT, part, name, value if value.startswith("[") else f'"{value}"')
    assert found.verdict == "wrong"
    assert found.mistake == ""


NAMES = [
    ("gain", "K", "[-13, -9]", "sign"),
    ("gain", "closed_loop_A", "[[1, 2], [16, 10]]", "feedback_sign"),
    ("eigen", "right_eigenvectors", "[[2, sqrt(6)], [2, -sqrt(6)]]", "rows"),
    ("eigen", "left_eigenvectors", "[[sqrt(6), -sqrt(6)], [2, 2]]", "rows"),
    ("inputs", "K", "-K", "sign"),
    ("inputs", "K", "K.T", "transposed"),
    ("matrix", "G", "1/G", "exchanged"),
    ("eigen", "eigenvalues", "[3.44, -1.44]", "rounding"),
    ("eigen", "eigenvalues", "[3.43, -1.44]", ""),
    ("eigen", "eigenvalues", "[3.45, -1.44]", ""),
    ("half", "y_final", "0.34", ""),
    ("flat", "K", "[3, 2]", ""),
]
"""Mistakes by their names, with none where digits are cut off in some places only or a whole unit too far."""

MORE = (
    PLANT
    + """
  inputs: {task: pole_placement, method: unity_rank, poles: [-1, -2],
           system: {A: [[1, 2], [3, 1]], B: [[1, 0], [0, 1]]}}
  matrix: {task: transfer_function, system: {A: [[-1, 0], [0, -2]], B: [[1, 0], [0, 1]], C: [[1, 0], [0, 3]]}}
  half: {task: response, kind: zero_state, input: "0.35", system: {A: [[-1]], B: [1], C: [1]}}
  flat: {task: pole_placement, poles: ["-1 ± j"], system: {A: [[0, 1], [0, 0]], B: [0, 1]}}
"""
)


@pytest.mark.parametrize(("part", "name", "value", "mistake"), NAMES)
def test_a_mistake_has_a_name(part, name, value, mistake):
    ours = next(result.answers[name] for result in solved(MORE).parts if result.id == part)
    changed = {"-K": lambda: -ours, "K.T": lambda: ours.T, "1/G": lambda: ours.applyfunc(lambda g: 1 / g if g else g)}
    found = verdict(MORE, part, name, written(sp.ImmutableMatrix(changed[value]())) if value in changed else value)
    assert (found.verdict, found.mistake) == ("wrong", mistake)


def test_a_changed_question_is_solved_once_for_all_students(monkeypatch):
    solved_ones = []
    monkeypatch.setattr(changed, "found_by", lambda *asked: solved_ones.append(asked) or found_by(*asked))
    problem = PLANT.replace("title: Mistakes", "title: Mistakes of two students")
    counts = []
    for value in ("[12, 8]", "[14, 7]"):
        assert verdict(problem, "gain", "K", value).mistake == ""
        counts.append(len(solved_ones))
    assert counts[0] == counts[1] > 2


POLES = st.lists(st.integers(-5, -1), min_size=2, max_size=3)


@settings(max_examples=8, deadline=None)
@given(POLES, st.sampled_from(["sign", "reversed", "factor", "double", "poles_sign", "transposed"]))
def test_a_mistake_in_any_gain_is_named_and_none_in_ours(poles, mistake):
    """In companion form with zeros the gain is made of the coefficients of the polynomial asked for."""
    n = len(poles)
    rows = [[int(j == i + 1) for j in range(n)] for i in range(n)]
    problem = f"""
title: Companion
system: {{A: {rows}, B: {[0] * (n - 1) + [1]}}}
find: {{a: {{task: pole_placement, poles: {poles}}}}}
"""
    ours = gain_of(poles)
    values = {
        "sign": [-k for k in ours],
        "reversed": ours[::-1],
        "factor": [k / 2 for k in ours],
        "double": [2 * k for k in ours],
        "poles_sign": gain_of([-p for p in poles]),
        "transposed": [ours],
    }
    value = values[mistake]
    found = verdict(problem, "a", "K", str(value).replace("Fraction", ""))
    if value in (ours, [ours]):
        assert (found.verdict, found.mistake) == ("correct", "")
    else:
        alike = {{"double": "factor"}.get(name, name) for name, other in values.items() if other == value}
        assert found.verdict == "wrong"
        assert found.mistake in alike | ({"sign"} if mistake == "poles_sign" and value[-1] == -ours[-1] else set())


def gain_of(poles):
    """The coefficients c₀, c₁, … of Π(s − p), without the leading one."""
    coefficients = [1]
    for p in poles:
        coefficients = [a - p * b for a, b in zip([*coefficients, 0], [0, *coefficients], strict=True)]
    return coefficients[:0:-1]


@pytest.mark.parametrize(
    ("name", "value"), [("right_eigenvectors", "'[2 1; 3 2]'"), ("left_eigenvectors", "'[-2 1; -3 2]'")]
)
def test_vectors_in_another_order_than_the_eigenvalues_have_no_other_mistake(name, value):
    """With the sign reversed they are as right by themselves as they were."""
    text = "title: Order\nsystem: {matrix: [[-6, 2], [-6, 1]]}\nfind: {a: eigenstructure}"
    found = marked(text, f"answers: {{a: {{eigenvalues: '-2, -3', {name}: {value}}}}}")["a"].answers[name]
    assert "in the order of the eigenvalues" in found.reason
    assert found.mistake == ""


ONE_STATE = """
system: {A: [[0, 1], [-6, -5]], B: [0, 1], C: [1, 0]}
find: {a: {task: reduced_observer, poles: [-6]}}
"""


@pytest.mark.parametrize(("name", "value"), [("J", "1"), ("J", "[[1]]"), ("L", "2")])
def test_a_whole_number_in_a_matrix_of_one_entry_may_be_there_by_chance(name, value):
    found = verdict(ONE_STATE, "a", name, value)
    assert found.verdict == "wrong"
    assert not found.mistake


@pytest.mark.parametrize(
    ("language", "words"),
    [("en", "it is the value of another answer, K"), ("de", "es ist der Wert einer anderen Antwort, K")],
)
def test_the_value_of_an_answer_that_is_found_later_is_no_intermediate_result(language, words):
    # P = 2 + √5 and after it K = 2P/(1 + P) = (1 + √5)/2
    text = f"""
language: {language}
find: {{h: {{task: lqr, Q: [[1]], R: 1, system: {{time: discrete, A: [[2]], B: [[1]]}}}}}}
"""
    found = marked(text, "answers: {h: {P: 1.618}}")["h"].answers["P"]
    assert (found.mistake, found.reason) == ("intermediate", words)


def test_an_intermediate_result_that_is_no_answer_is_still_called_one():
    found = marked(PLANT, "answers: {order: {A: [[2, -1], [-1, 1]]}}")["order"].answers["A"]  # the inverse of T
    assert (found.mistake, found.reason) == ("intermediate", "it is an intermediate result: the last step is missing")
