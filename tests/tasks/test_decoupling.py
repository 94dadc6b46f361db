"""Decoupling: textbook values, numpy's loop, hidden zeros, infeasible plants, corruptions, marking, bad input."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.linalg
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import StateSpace
from solver.tasks import catalogue
from tests.helpers.asking import ask, at, rejected, system
from tests.helpers.marked import marked, verdict

s = sp.Symbol("s")

FALB_WOLOVICH = system(
    [[0, 1, 0], [2, 3, 0], [1, 1, 1]], B=[[0, 0], [1, 0], [0, 1]], C=[[1, 1, 0], [0, 0, 1]], D=sp.zeros(2)
)
"""The example of their paper: B* = I, A* = [2 4 0; 1 1 1]."""

UNSTABLE_ZERO = system(
    [[-1, 0, 0], [0, -3, 0], [0, 0, -1]], B=[[1, 0], [0, 1], [0, 1]], C=[[1, 2, 0], [1, 0, 1]], D=sp.zeros(2)
)
"""Realizes [1/(s+1), 2/(s+3); 1/(s+1), 1/(s+1)], with a zero at 1."""


def poles(*channels):
    return tuple(tuple(map(sp.sympify, each)) for each in channels)


def closed_loop_at(plant, answers, point):
    """(C − D K)(sI − A + B K)⁻¹ B F + D F by numpy."""
    A, B, C, D, K, F = (at(M) for M in (plant.A, plant.B, plant.C, plant.D, answers["K"], answers["F"]))
    return (C - D @ K) @ np.linalg.solve(point * np.eye(len(A)) - A + B @ K, B @ F) + D @ F


def zeros_of(plant):
    """The finite generalized eigenvalues of the system matrix, by scipy."""
    n, m = plant.B.shape
    M = np.block([[at(plant.A), at(plant.B)], [at(plant.C), at(plant.D)]])
    N = np.zeros((n + m, n + m))
    N[:n, :n] = np.eye(n)
    found = scipy.linalg.eigvals(M, N)
    return found[np.isfinite(found) & (abs(found) < 1e6)]


def test_the_example_of_the_paper():
    result = ask("decoupling", FALB_WOLOVICH, poles=None)
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == [
        "differentiated", "differentiated", "matrix", "rows", "law", "loop", "hidden", "decay",
    ]  # fmt: skip
    assert result.answers["relative_degrees"] == [1, 1]
    assert result.answers["F"] == sp.eye(2)
    assert result.answers["K"] == sp.Matrix([[2, 4, 0], [1, 1, 1]])
    assert result.answers["G"] == sp.diag(1 / s, 1 / s)
    hidden = result.steps[-2].values
    assert hidden["H"] == sp.Matrix([[-1]])  # the zero of (s + 1)/(s² − 3s − 2)


@pytest.mark.parametrize("asked", [poles([-2], [-3]), (sp.Integer(-2), sp.Integer(-3))])
def test_a_zero_in_the_right_half_plane_is_warned_of(asked):
    result = ask("decoupling", UNSTABLE_ZERO, poles=asked)
    assert result.status is Status.VERIFIED
    assert result.answers["G"] == sp.diag(1 / (s + 2), 1 / (s + 3))
    assert result.answers["K"] == sp.Matrix([[3, 2, 4], [-1, -2, -2]])
    assert result.steps[-1].kind == "decay"
    assert result.steps[-1].values["unstable"]
    loop = at(UNSTABLE_ZERO.A - UNSTABLE_ZERO.B * result.answers["K"])
    assert np.allclose(np.sort(np.linalg.eigvals(loop).real), [-3, -2, 1])
    assert np.allclose(zeros_of(UNSTABLE_ZERO), [1])


entries = st.integers(-3, 3)


@settings(max_examples=25, deadline=None)
@given(st.integers(2, 4), st.integers(1, 3), st.booleans(), st.booleans(), st.data())
def test_generated_plants_are_decoupled_by_numpys_measure(n, m, direct, discrete, data):
    draw = lambda rows, columns: data.draw(  # noqa: E731 - short
        st.lists(st.lists(entries, min_size=columns, max_size=columns), min_size=rows, max_size=rows)
    )
    D = sp.zeros(m)
    if direct:
        D[0, :] = sp.Matrix(draw(1, m))
    plant = system(draw(n, n), B=draw(n, m), C=draw(m, n), D=D, discrete=discrete)
    result = ask("decoupling", plant, poles=None)
    assert result.status is Status.VERIFIED, result.reason
    degrees = result.answers["relative_degrees"]
    assert degrees == [_degree(plant, i) for i in range(m)]
    rows = [_acting(plant, i, r) for i, r in enumerate(degrees)]
    assert result.answers["feasible"] == (np.linalg.matrix_rank(np.array(rows, dtype=float)) == m)
    if not result.answers["feasible"]:
        return
    asked = tuple(tuple(sp.Integer(-i - k - 1) for k in range(r)) for i, r in enumerate(degrees))
    placed = ask("decoupling", plant, poles=asked)
    assert placed.status is Status.VERIFIED, placed.reason
    point = 0.7 + 1.9j
    wanted = np.diag([1 / np.prod([point - complex(p) for p in each]) for each in asked])
    assert np.allclose(closed_loop_at(plant, placed.answers, point), wanted, atol=1e-8)


def _degree(plant, i):
    if not plant.D.row(i).is_zero_matrix:
        return 0
    row = plant.C.row(i)
    for r in range(1, plant.order + 1):
        if not (row * plant.B).is_zero_matrix:
            return r
        row = row * plant.A
    return sp.oo


def _acting(plant, i, r):
    if r is sp.oo:
        return [0] * plant.B.cols
    row = plant.D.row(i) if r == 0 else plant.C.row(i) * plant.A ** (r - 1) * plant.B
    return [int(entry) for entry in row]


@pytest.mark.parametrize("name", ["K", "F", "G"])
def test_corrupted_answers_are_rejected(name):
    answers = ask("decoupling", UNSTABLE_ZERO, poles=poles([-2], [-3])).answers
    right = answers[name]
    asked = {"poles": poles([-2], [-3])}
    assert not rejected("decoupling", UNSTABLE_ZERO, {name: right}, **asked)
    wrong = [-right, right * 2 if name != "G" else right / 2, sp.ImmutableMatrix(right.shape[0], 1, lambda i, _: 1)]
    for i in range(right.rows):
        for j in range(right.cols):
            changed = right.as_mutable()
            changed[i, j] += sp.Rational(1, 1000)
            wrong.append(sp.ImmutableMatrix(changed))
    for value in wrong:
        assert rejected("decoupling", UNSTABLE_ZERO, {name: value}, **asked), value


@pytest.mark.parametrize(
    ("name", "value"),
    [("feasible", False), ("relative_degrees", [1, 2]), ("relative_degrees", [sp.oo, 1]), ("relative_degrees", [1])],
)
def test_corrupted_verdicts_are_rejected(name, value):
    assert rejected("decoupling", UNSTABLE_ZERO, {name: value}, poles=None)


def test_each_answer_is_judged_beside_the_others():
    asked = {"poles": poles([-2], [-3])}
    answers = dict(ask("decoupling", UNSTABLE_ZERO, **asked).answers)
    answers["F"] = sp.ImmutableMatrix(answers["F"] * sp.diag(2, 3))  # steady-state gains of one, as is usual too
    assert not rejected("decoupling", UNSTABLE_ZERO, {"F": answers["F"]}, **asked)
    assert rejected("decoupling", UNSTABLE_ZERO, answers, **asked)
    answers["G"] = sp.diag(2 / (s + 2), 3 / (s + 3)).as_immutable()
    assert not rejected("decoupling", UNSTABLE_ZERO, answers, **asked)


def test_dependent_rows_are_no_decoupling_and_a_row_of_zeros_is_none_at_all():
    late = system(
        [[0, 0, 1], [0, -1, 0], [0, 0, -2]], B=[[1, 0], [1, 0], [0, 1]], C=[[1, 0, 0], [0, 1, 0]], D=sp.zeros(2)
    )
    result = ask("decoupling", late, poles=None)
    assert result.status is Status.VERIFIED
    assert dict(result.answers) == {"feasible": False, "relative_degrees": [1, 1]}
    assert result.steps[-1].values["dynamic"]
    assert rejected("decoupling", late, {"feasible": True}, poles=None)
    assert rejected("decoupling", late, {"K": sp.ImmutableMatrix(sp.zeros(2, 3))}, poles=None)
    same = system([[0, 0], [0, -1]], B=[[1, 2], [1, 2]], C=[[1, 0], [0, 1]], D=sp.zeros(2))
    assert not ask("decoupling", same, poles=None).steps[-1].values["dynamic"]
    never = system([[-1, 1], [0, -2]], B=[[1, 2], [0, 0]], C=[[1, 0], [0, 1]], D=sp.zeros(2))
    assert ask("decoupling", never, poles=None).answers["relative_degrees"] == [1, sp.oo]


def test_parameters_that_make_a_difference_are_named():
    g, c = sp.symbols("g c", real=True)
    plant = system([[-1, 0, 1], [0, -2, 0], [0, 0, -c]], B=[[g, 1], [0, 1], [1, 0]], C=[[1, 0, 0], [0, 1, 0]],
                   D=sp.zeros(2))  # fmt: skip
    result = ask("decoupling", plant, poles=None)
    assert result.status is Status.VERIFIED
    assert result.answers["exceptions"] == [sp.Eq(g, 0)]
    assert rejected("decoupling", plant, {"exceptions": []}, poles=None)
    assert rejected("decoupling", plant, {"exceptions": [sp.Eq(g, 1)]}, poles=None)
    assert result.steps[-1].values["open"]
    tall = system([[0, 1], [0, 0]], B=[[g], [1]], C=[[1, 0]], D=sp.zeros(1))
    result = ask("decoupling", tall, poles=None)
    assert result.answers["exceptions"] == [sp.Eq(g, 0)]  # the relative degree is two there
    assert result.answers["G"] == 1 / s


def test_one_input_places_a_pole_and_hides_the_zero():
    plant = system([[0, 1], [-2, -3]], B=[[0], [1]], C=[[4, 1]], D=sp.zeros(1))
    result = ask("decoupling", plant, poles=poles([-5]))
    assert result.answers["G"] == 1 / (s + 5)
    assert np.allclose(np.sort(np.linalg.eigvals(at(plant.A - plant.B * result.answers["K"])).real), [-5, -4])


def test_poles_with_surds_and_a_transfer_matrix_that_is_realized():
    asked = poles(["-1 + sqrt(2)"], ["-sqrt(3)"])
    result = ask("decoupling", UNSTABLE_ZERO, poles=asked)
    assert result.status is Status.VERIFIED
    text = 'system: {transfer_matrix: [["1/(s+1)", "2/(s+3)"], ["1/(s+1)", "1/(s+1)"]]}\nfind: {a: decoupling}\n'
    found = solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts[0]
    assert found.status is Status.VERIFIED
    assert found.answers["relative_degrees"] == [1, 1]
    assert found.answers["G"] == sp.diag(1 / s, 1 / s)


QUESTION = """
system: {{A: [[0, 1, 0], [-2, -1, 1], [1, 0, -1]], B: [[0, 0], [1, 1], [0, 2]], C: [[1, 0, 0], [0, 0, 1]]}}
find: {{a: {{task: decoupling, poles: {poles}}}}}
"""
"""Relative degrees 2 and 1; K = [5/2 1 0; 1/2 0 1] and F = [1 −1/2; 0 1/2] for −1 ± 2j and −3."""


@pytest.mark.parametrize("listed", ['["-1 ± 2j", -3]', '[["-1 ± 2j"], [-3]]', '["-1 + 2j", "-1 - 2j", -3]'])
def test_poles_are_read_by_channel_or_flat(listed):
    problem = read_problem(Source("file.yaml", QUESTION.format(poles=listed)), catalogue())
    answers = solve_problem(problem).parts[0].answers
    assert answers["K"] == sp.Matrix([["5/2", 1, 0], ["1/2", 0, 1]])
    assert answers["F"] == sp.Matrix([[1, "-1/2"], [0, "1/2"]])


@pytest.mark.parametrize(
    ("listed", "says"),
    [
        ("[-1, -2]", "relative degrees 2, 1, so 3 poles are needed, not 2"),
        ("[-1, -2, -3, -4]", "3 poles are needed, not 4"),
        ("[[-1], [-2, -3]]", "channel 1 has the relative degree 2, so it takes 2 poles, not 1"),
        ('[-3, "-1 ± 2j"]', "a complex pole without its conjugate"),
        ("[[-1, -2, -3]]", "'poles' has 1 lists, but the system has 2 outputs"),
        ("[[-1, -2], -3]", "a list for each channel"),
        ('[["-1 + 2j", -1], [-3]]', "has no conjugate"),
        ("[[-1, -2], [q*]]", ""),
    ],
)
def test_poles_at_fault_are_told_at_their_place(listed, says):
    with pytest.raises(InputError) as caught:
        list(solve_problem(read_problem(Source("file.yaml", QUESTION.format(poles=listed)), catalogue())).parts)
    found = caught.value.diagnostics
    assert any(says in each.message for each in found), [each.message for each in found]
    assert all(each.line == 3 and each.column > 10 for each in found)


def test_a_plant_that_is_not_square_is_refused():
    text = "system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [[1, 0], [0, 1]]}\nfind: {a: decoupling}\n"
    with pytest.raises(InputError) as caught:
        solve_problem(read_problem(Source("file.yaml", text), catalogue()))
    assert "an input for each output; this system has 2 outputs and 1 input" in caught.value.diagnostics[0].message


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("K", "[[5/2, 1, 0], [1/2, 0, 1]]", ""),
        ("K", "[[2.5, 1, 0], [0.5, 0, 1.0]]", ""),
        ("K", "[[-5/2, -1, 0], [-1/2, 0, -1]]", "the feedback is subtracted"),
        ("K", "[[4, 1, 3], [2, 0, 4]]", "is not inverted"),
        ("K", "[[5, 3, -2], [0, 0, 2]]", "one power of $A$ too low"),
        ("K", "[[5/2, -3, 3], [1/2, 0, -2]]", "roots $-p_i$"),
        ("F", "[[1, -1/2], [0, 1/2]]", ""),
        ("F", "[[5, -3/2], [0, 3/2]]", ""),
        ("F", "[[1, 1], [0, 2]]", "is not inverted"),
        ("relative_degrees", "[2, 1]", ""),
        ("relative_degrees", "[1, 0]", "the relative degree is one more"),
        ("relative_degrees", "[1, 2]", None),
        ("feasible", "yes", ""),
        ("feasible", "no", None),
        ("G", "[[1/(s^2 + 2s + 5), 0], [0, 1/(s + 3)]]", ""),
        ("G", "[[1/s^2, 0], [0, 1/s]]", "forgotten"),
    ],
)
def test_right_and_wrong_answers_are_told_apart(name, value, says):
    found = verdict(QUESTION.format(poles='["-1 ± 2j", -3]'), "a", name, value)
    assert (found.verdict == "correct") == (says == ""), found
    if says:
        assert says in str(found.reason), found.reason


def test_what_a_wrong_gain_leaves_coupled_is_told():
    found = verdict(QUESTION.format(poles='["-1 ± 2j", -3]'), "a", "K", "[[2, 1, 0], [1, 0, 1]]")
    assert "still acts on" in str(found.reason)


def test_marks_of_an_infeasible_plant():
    text = """
system: {A: [[0, 0, 1], [0, -1, 0], [0, 0, -2]], B: [[1, 0], [1, 0], [0, 1]], C: [[1, 0, 0], [0, 1, 0]]}
find: {a: {task: decoupling, marks: 4}}
"""
    part = marked(text, "answers: {a: {feasible: no, relative_degrees: [1, 1]}}")["a"]
    assert part.marks == 4


def test_the_judges_know_a_plant_without_d():
    bare = StateSpace(UNSTABLE_ZERO.A, UNSTABLE_ZERO.B, UNSTABLE_ZERO.C)
    assert ask("decoupling", bare, poles=None).status is Status.VERIFIED
