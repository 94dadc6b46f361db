"""Chains of own values: within a part, over several parts, through answers that were not submitted, and rounded."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.classroom.following import between
from tests.helpers.marked import marked, solved

WRONG, RIGHT, FOLLOWS = ("wrong", False), ("correct", False), ("correct", True)


def said(problem, answers):
    """(verdict, follows) of each answer: {part: {name: …}}."""
    return {
        id_: {name: (str(each.verdict), each.follows) for name, each in part.answers.items()}
        for id_, part in marked(problem, f"answers: {answers}").items()
    }


REGULATOR = """
system: {A: [[0, 1], [0, 0]], B: [0, 1]}
find:
  a: {task: lqr, method: riccati, Q: [[1, 0], [0, 0]], R: 1, initial_state: [1, 0]}
"""
# right: P = [[√2, 1], [1, √2]], K = [1, √2], cost √2/2


def test_all_that_follows_from_a_wrong_solution_of_riccati_is_right():
    found = said(
        REGULATOR,
        "{a: {P: [[2, 1], [1, 3]], K: [1, 3], u: -x1 - 3x2, closed_loop_A: [[0, 1], [-1, -3]], cost: 1,"
        " eigenvalues: [-2.618, -0.38197]}}",
    )["a"]
    assert found.pop("P") == WRONG
    assert set(found.values()) == {FOLLOWS}


def test_a_slip_in_what_follows_is_wrong_and_followed_in_its_turn():
    found = said(
        REGULATOR,
        "{a: {P: [[2, 1], [1, 3]], K: [1, 4], closed_loop_A: [[0, 1], [-1, -4]], cost: 3,"
        " eigenvalues: [-2 ± sqrt(3)]}}",
    )["a"]
    assert found == {"P": WRONG, "K": WRONG, "closed_loop_A": FOLLOWS, "cost": WRONG, "eigenvalues": FOLLOWS}


def test_what_follows_from_a_value_that_was_not_submitted_follows_from_those_before_it():
    found = marked(REGULATOR, "answers: {a: {P: [[2, 1], [1, 3]], eigenvalues: [-2.618, -0.38197]}}")["a"]
    eigenvalues = found.answers["eigenvalues"]
    assert (eigenvalues.verdict, eigenvalues.note) == ("correct", "right with your own P of part a")


def test_an_own_value_is_known_to_the_digits_written():
    # K from P = [[2, 1], [1, 3.1664]] before P was rounded
    found = said(REGULATOR, "{a: {P: [[2.00, 1.00], [1.00, 3.17]], K: [1, 3.1664]}}")["a"]
    assert found == {"P": WRONG, "K": FOLLOWS}
    assert said(REGULATOR, "{a: {P: [[2.00, 1.00], [1.00, 3.17]], K: [1, 3.15]}}")["a"]["K"] == WRONG


def test_nothing_follows_from_zeros():
    found = said(REGULATOR, "{a: {P: [[0, 0], [0, 0]], K: [0, 0], cost: 0, eigenvalues: [0, 0]}}")["a"]
    assert set(found.values()) == {WRONG}


def test_right_entries_of_what_should_follow_are_told():
    found = marked(REGULATOR, "answers: {a: {P: [[2, 5], [5, 3]], K: [5, 4]}}")["a"].answers["K"]
    assert (found.verdict, found.entries) == ("wrong", [["correct", "wrong"]])
    assert found.note == "compared with what follows from your own P of part a"


def test_words_and_truth_values_lead_to_nothing():
    problem = "{system: {A: [[0, 1], [2, -1]], B: [0, 1], C: [1, 0]}, find: {a: stability}}"
    found = said(problem, "{a: {verdict: asymptotically stable, bibo_stable: yes}}")["a"]
    assert found == {"verdict": WRONG, "bibo_stable": WRONG}


@pytest.mark.parametrize(
    ("asked", "system", "submitted", "verdicts"),
    [
        (  # ζ = 0.5, ω_n = 4 for t_s = 2 and ζ; own ζ = 0.8: ω_n = 2.5
            "task: desired_poles, damping_ratio: 0.5, settling_time: 2",
            "{polynomial: s}",
            "damping_ratio: 0.80, natural_frequency: 2.50, poles: [-2 ± 1.5j], polynomial: s^2 + 4s + 6.25",
            {"damping_ratio": WRONG, "natural_frequency": FOLLOWS, "poles": FOLLOWS, "polynomial": FOLLOWS},
        ),
        (  # L = [10, 10]; own L = [9, 9]
            "task: observer, poles: [-6, -7]",
            "{A: [[0, 1], [-2, -3]], C: [1, 0]}",
            "L: [9, 9], error_A: [[-9, 1], [-11, -3]], polynomial: s^2 + 12s + 38",
            {"L": WRONG, "error_A": FOLLOWS, "polynomial": FOLLOWS},
        ),
        (  # η₁ = x1: L = 3, J = −6, N = −20, M = 1; own L = 4: J = −7, N = −2 − 28
            "task: reduced_observer, poles: [-6]",
            "{A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}",
            "L: [4], J: [[-7]], N: [[-30]], M: [[1]]",
            {"L": WRONG, "J": FOLLOWS, "N": FOLLOWS, "M": RIGHT},
        ),
        (  # Ā = [[0, 1, 0], [-2, -3, 0], [-1, 0, 0]], K = [29, 9], k_I = 60; own K = [28, 9]
            "task: servo, poles: [-3, -4, -5]",
            "{A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}",
            "K: [28, 9], closed_loop_A: [[0, 1, 0], [-30, -12, 60], [-1, 0, 0]]",
            {"K": WRONG, "closed_loop_A": FOLLOWS},
        ),
        (
            "task: transfer_function",
            "{A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 1]}",
            "G: (s+2)/((s+1)(s+3)), poles: [-1, -3], zeros: [-2]",
            {"G": WRONG, "poles": FOLLOWS, "zeros": FOLLOWS},
        ),
        (
            "task: controllability",
            "{A: [[0, 1], [-2, -3]], B: [0, 1]}",
            "controllability_matrix: [[1, -3], [-3, 9]], determinant: 0, rank: 1, controllable: no",
            {"controllability_matrix": WRONG, "determinant": FOLLOWS, "rank": FOLLOWS, "controllable": FOLLOWS},
        ),
        (
            "task: routh_hurwitz",
            "{polynomial: s^3 + 2s^2 + 3s + 4}",
            "array: [[1, 3], [2, 4], [-1, 0], [4, 0]], right_half_plane_roots: 2, stable: no",
            {"array": WRONG, "right_half_plane_roots": FOLLOWS, "stable": FOLLOWS},
        ),
        (
            "task: phase_portrait",
            "{A: [[0, 1], [-2, -3]]}",
            "eigenvalues: [-1 ± 1j], kind: stable focus",
            {"eigenvalues": WRONG, "kind": FOLLOWS},
        ),
        (
            "task: response, kind: zero_input, initial_state: [1, 0]",
            "{A: [[0, 1], [-2, -3]], C: [1, 1]}",
            "x: [2e^(-t) - e^(-2t), -2e^(-t) + e^(-2t)], y: 0",
            {"x": WRONG, "y": FOLLOWS},
        ),
    ],
)  # fmt: skip
def test_answers_of_one_part_follow_from_each_other(asked, system, submitted, verdicts):
    problem = f"system: {system}\nfind:\n  a: {{{asked}}}\n"
    assert said(problem, f"{{a: {{{submitted}}}}}")["a"] == verdicts


MODEL = """
system: {equations: ["x'' + 3 x' + 2 x = u"], inputs: [u], outputs: [x], states: [x, "x'"]}
find:
  a: {task: state_space_model}
  b: {task: pole_placement, system: {from: a}, poles: [-4, -5], method: ackermann}
  c: {task: eigenstructure, system: {from: a, gain: {from: b}}}
  d: {task: transfer_function, system: {from: a, gain: {from: b}}}
"""
# right: A = [[0, 1], [-2, -3]], K = [18, 6]; with A₂₁ = +2 K = [22, 6]


def test_a_wrong_model_is_followed_as_a_system():
    found = marked(MODEL, "answers: {a: {A: [[0, 1], [2, -3]]}, b: {K: [22, 6]}, c: {eigenvalues: [-4, -5]}}")
    assert found["a"].answers["A"].verdict == "wrong"
    assert found["b"].answers["K"].note == "right with your own A of part a"
    assert (found["c"].answers["eigenvalues"].verdict, found["c"].answers["eigenvalues"].follows) == RIGHT


def test_a_chain_goes_on_where_each_step_has_a_slip_of_its_own():
    # K is wrong for the own A too: A − BK = [[0, 1], [-18, -9]], eigenvalues −3, −6
    found = marked(MODEL, "answers: {a: {A: [[0, 1], [2, -3]]}, b: {K: [20, 6]}, c: {eigenvalues: [-3, -6]}}")
    assert found["b"].answers["K"].verdict == "wrong"
    c = found["c"].answers["eigenvalues"]
    assert (c.verdict, c.note) == ("correct", "right with your own K of part b and A of part a")


def test_a_step_between_that_was_not_submitted_is_computed_from_the_own_values():
    # B = [0, 2]: K = [9, 3] was not submitted
    found = said(MODEL, "{a: {B: [0, 2]}, d: {G: 2/(s^2 + 9s + 20)}}")
    assert found == {"a": {"B": WRONG}, "b": {}, "c": {}, "d": {"G": FOLLOWS}}
    found = said(MODEL, "{a: {B: [0, 2]}, d: {G: 3/(s^2 + 9s + 20)}}")
    assert found["d"] == {"G": WRONG}


ROUNDED = """
system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}
find:
  a: {task: lqr, Q: [[4, 0], [0, 1]], R: 1}
  b: {task: eigenstructure, gain: {from: a}}
"""
# right: K = [2√2 − 2, √2 − 1] = [0.828, 0.414], eigenvalues −√2, −2


def test_consequences_of_a_rounded_right_value_are_right():
    own = np.linalg.eigvals([[0, 1], [-2.83, -3.41]])  # −1.4275, −1.9825
    answers = f"{{a: {{K: [0.83, 0.41]}}, b: {{eigenvalues: [{own[0]:.4f}, {own[1]:.4f}]}}}}"
    assert said(ROUNDED, answers) == {"a": {"K": RIGHT}, "b": {"eigenvalues": FOLLOWS}}
    answers = "{a: {K: [0.83, 0.41]}, b: {eigenvalues: [-1.4142, -2]}}"
    assert said(ROUNDED, answers)["b"] == {"eigenvalues": RIGHT}


@pytest.mark.parametrize(
    ("answers", "count"),
    [
        ("{a: {A: [[0, 1], [-2, -3]]}, b: {K: [18, 6]}, c: {eigenvalues: [-4, -6]}}", 0),
        ("{a: {A: [[0, 1], [2, -3]]}, c: {eigenvalues: [-4, -5]}}", 0),
        ("{a: {A: [[0, 1], [2, -3]]}, b: {K: [22, 6]}, c: {eigenvalues: [-4, -5]}}", 1),
        ("{b: {K: [20, 6]}, c: {eigenvalues: [-1, -6]}, d: {poles: [-1, -6]}}", 2),
    ],
)
def test_parts_are_solved_again_only_where_something_is_wrong_and_may_follow(monkeypatch, answers, count):
    solution, calls = solved.__wrapped__(MODEL), []  # what was judged of it is remembered by its identity
    found_by = between.found_by
    monkeypatch.setattr(between, "found_by", lambda *args: calls.append(args) or found_by(*args))
    marked(solution, f"answers: {answers}")
    assert len(calls) == count


GAINS = st.tuples(st.integers(3, 40), st.integers(3, 12))
CHAIN = """
system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}
find:
  a: {task: pole_placement, method: ackermann, poles: [-4, -5]}
  b: {task: characteristic_polynomial, gain: {from: a}}
  c: {task: transfer_function, gain: {from: a}}
  d: {task: reference_tracking, gain: {from: a}}
"""


@settings(max_examples=12, deadline=None)
@given(K=GAINS, slip=st.sampled_from(["polynomial", "poles", "K_o", ""]))
def test_whatever_the_slip_its_consequences_are_right_and_a_slip_in_these_is_not(K, slip):
    if K == (18, 6):
        return
    _, c1, c0 = np.poly(np.array([[0, 1], [-2 - K[0], -3 - K[1]]])) + (
        np.array([0, 0, 1]) if slip == "polynomial" else 0
    )
    poles = np.linalg.eigvals(np.array([[0, 1], [-2 - K[0], -3 - K[1]]])) * (1.2 if slip == "poles" else 1)
    K_o = 2 + K[0] + (0.5 if slip == "K_o" else 0)
    listed = ", ".join(f"'{pole.real:.5f} + ({pole.imag:.5f})j'" for pole in poles.astype(complex))
    found = said(
        CHAIN,
        f"{{a: {{K: [{K[0]}, {K[1]}], closed_loop_A: [[0, 1], [{-2 - K[0]}, {-3 - K[1]}]]}},"
        f" b: {{polynomial: lamda^2 + {c1:.4f} lamda + {c0:.4f}}}, c: {{poles: [{listed}]}}, d: {{K_o: {K_o}}}}}",
    )
    assert found["a"] == {"K": WRONG, "closed_loop_A": FOLLOWS}
    for part, name in (("b", "polynomial"), ("c", "poles"), ("d", "K_o")):
        right = found[part][name]
        assert right[0] == ("wrong" if name == slip else "correct"), (part, name, right)


def test_of_two_readings_the_one_that_follows_counts():
    problem = """
system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}
find:
  a: {task: pole_placement, method: ackermann, poles: [-4, -5]}
  b: {task: response, gain: {from: a}, kind: zero_input, initial_state: [1/2, 0]}
  c: {task: response, kind: zero_input, initial_state: [1/2, 0]}
"""
    found = said(problem, "{a: {K: [16, 6]}, b: {y: e^(-3t) - 1/2 e^(-6t)}}")
    assert found == {"a": {"K": WRONG}, "b": {"y": FOLLOWS}, "c": {}}
    found = said(problem, "{c: {x: [e^(-t) - 1/2 e^(-3t), -e^(-t) + 3/2 e^(-3t)], y: e^(-t) - 1/2 e^(-3t)}}")["c"]
    assert found["y"] != RIGHT


def test_what_only_own_values_can_judge_is_judged_by_them():
    # two outputs: many gains L place the poles, so J, N and M are judged by the one submitted, which is wrong here
    problem = """
system: {A: [[0, 1, 0], [0, 0, 1], [-6, -11, -6]], B: [0, 0, 1], C: [[1, 0, 0], [0, 1, 0]]}
find: {a: {task: reduced_observer, poles: [-8]}}
"""
    # A11 = [[0, 1], [0, 0]], A12 = [0; 1], A21 = [-6, -11], A22 = -6; L = [1, 3]: J = -9, N = A21 - L A11 + J L
    found = said(problem, "{a: {L: [[1, 3]], J: [[-9]], N: [[-15, -39]], M: [[1]]}}")["a"]
    assert found == {"L": WRONG, "J": FOLLOWS, "N": FOLLOWS, "M": RIGHT}
    found = said(problem, "{a: {L: [[1, 3]], J: [[-9]], N: [[-15, -38]], M: [[1]]}}")["a"]
    assert found["N"] != FOLLOWS


REALIZED = """
system: {transfer_function: "(s+4)/((s+1)(s+2))"}
find:
  a: {task: realization, form: diagonal, marks: 4}
  b: {task: minimal_realization, marks: 4}
"""
# G = 3/(s + 1) − 2/(s + 2)


def entries(problem, part, answers):
    found = marked(problem, f"answers: {{{part}: {{{answers}}}}}")[part]
    return found.marks, {name: (str(each.verdict), each.entries) for name, each in found.answers.items()}


C, W = "correct", "wrong"
GOOD = {"A": (C, [[C, C], [C, C]]), "B": (C, [[C], [C]]), "C": (C, [[C, C]]), "D": (C, [[C]])}


@pytest.mark.parametrize("part", ["a", "b"])
@pytest.mark.parametrize(
    ("answers", "marks", "blamed"),
    [
        ("A: [[-1, 0], [0, -2]], B: [1, 1], C: [3, -3], D: 0", 3.5, {"C": (W, [[C, W]])}),
        ("A: [[-1, 0], [0, -2]], B: [2, 1], C: [3, -2], D: 0", 3.5, {"C": (W, [[W, C]])}),
        ("A: [[-1, 0], [0, -2]], B: [0, 1], C: [3, -2], D: 0", 3.5, {"B": (W, [[W], [C]])}),
        ("A: [[-1, 0], [0, -2]], B: [1, 1], C: [3, -2], D: 1", 3, {"D": (W, [[W]])}),
        (
            "A: [[-1, 0], [0, -2]], B: [1, 1], C: [3, -3], D: 1",
            2.5,
            {"C": (W, [[C, W]]), "D": (W, [[W]])},
        ),
    ],
)
def test_one_slip_in_a_realization_is_blamed_alone(part, answers, marks, blamed):
    # B = [2, 1] could be the slip as well: of two that could be blamed alike the later one is
    assert entries(REALIZED, part, answers) == (marks, {**GOOD, **blamed})


ELSEWHERE = """
system: {A: [[-1, 0, 0], [0, -2, 0], [0, 0, -5]], B: [1, 0, 2], C: [1, 3, 1]}
find: {a: {task: minimal_realization, marks: 4}}
"""


@pytest.mark.parametrize(
    "answers", ["A: [[0, 1], [-5, -6]], B: [0, 1], C: [3, 7]", "A: [[0, -5], [1, -6]], B: [3, 7], C: [0, 1]"]
)
def test_the_later_one_is_blamed_in_coordinates_with_zeros_that_ours_have_not(answers):
    # G = (3s + 7)/(s² + 6s + 5) with ours diagonal: C could be [7, 3], and B = [7, 3] or another one alike
    found = entries(ELSEWHERE, "a", answers + ", D: 0")[1]
    assert found == {**GOOD, "C": (W, [[W, W]])}


def test_a_slip_in_the_system_matrix_leaves_the_others_right():
    answers = "A: [[-1, 0], [0, -3]], B: [1, 1], C: [3, -2], D: 0"
    assert entries(REALIZED, "a", answers) == (3.75, {**GOOD, "A": (W, [[C, C], [C, W]])})


def test_what_the_question_determines_is_right_whatever_stands_beside_it():
    # neither B nor C can be completed alone: the second state is neither reached nor seen
    found = entries(REALIZED, "b", "A: [[-1, 0], [0, -2]], B: [1, 0], C: [3, 0], D: 0")[1]
    assert {name: verdict for name, (verdict, _) in found.items()} == {"A": C, "B": W, "C": W, "D": C}
    assert found["D"][1] == [[C]]


def test_two_slips_are_not_put_down_to_one():
    found = entries(REALIZED, "a", "A: [[-1, 0], [0, -3]], B: [1, 1], C: [3, -3], D: 0")[1]
    assert (found["A"][0], found["C"][0], found["D"][0]) == (W, "not judged", C)


def test_a_slip_in_one_channel_is_that_channels():
    problem = """
system: {A: [[0, 1, 0], [0, 0, 1], [-6, -11, -6]], B: [[0, 1], [0, 0], [1, 0]], C: [[1, 0, 0], [0, 1, 0]]}
find: {a: minimal_realization}
"""
    answers = "A: [[0, 1, 0], [0, 0, 1], [-6, -11, -6]], B: [[0, 1], [0, 0], [1, 0]], C: [[1, 0, 0], [0, 1, 1]]"
    found = entries(problem, "a", answers)[1]
    assert {name: verdict for name, (verdict, _) in found.items()} == {"A": C, "B": C, "C": W}
    assert found["C"][1] == [[C, C, C], [C, C, W]]
