"""Kalman decomposition: answers, intermediate steps, every right answer accepted and every wrong one rejected."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

import solver
from solver.derivation import Answers, CheckStatus, Status
from solver.numeric.judges import structure as judges
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.tried import tried

TASK = "kalman_decomposition"
COURSE = system([[-2, -2, -2], [1, 0, 0], [1, 1, -1]], B=[1, 0, 0], C=[[1, 1, 0]])
FOUR = system(
    [[3, -3, 3, -1], [0, -2, -2, 1], [0, -2, -2, 2], [0, 2, -2, -3]], B=[2, 3, 1, 3], C=[[1, 1, -1, -1]], D=[[2]]
)
PARTS = {"controllable": "c", "observable": "o", "full": "co"}


def found(plant, part):
    result = ask(TASK, plant, part=part)
    assert result.status is Status.VERIFIED, result.reason
    return result


def steps(result):
    return [step.kind for step in result.steps]


def accepted(plant, answers, part):
    """Whether every check passes, and there is one for each answer."""
    task = catalogue()[TASK]
    checks = list(task.verify(task.given(plant, {"part": part}), Answers(**answers)))
    judged = {name for check in checks for name in check.judges}
    return judged == set(answers) and all(check.status is CheckStatus.PASSED for check in checks)


def test_the_controllable_part_of_the_course():
    result = found(COURSE, "controllable")
    assert steps(result) == ["matrix", "reachable", "bases", "transformed", "blocks", "hidden", "transfer"]
    assert result.answers["T"] == sp.Matrix([[1, -2, 0], [0, 1, -1], [0, 1, 1]])
    assert result.answers["A_c"] == sp.Matrix([[0, -4], [1, -2]])
    assert result.answers["C_c"] == sp.Matrix([[1, -1]])
    assert result.answers["hidden_modes"] == [-1]
    assert result.steps[1].values["chosen"] == [1, 2]
    s = sp.Symbol("s")
    assert sp.cancel(result.steps[-1].values["G"] - (s + 1) / (s**2 + 2 * s + 4)) == 0


def test_all_four_parts():
    result = found(FOUR, "full")
    assert steps(result) == [
        "matrix", "reachable", "matrix", "seen", "intersection", "bases", "transformed", "blocks", "hidden", "transfer",
    ]  # fmt: skip
    assert result.answers["orders"] == [1, 1, 1, 1]
    assert result.answers["hidden_modes"] == [-2, 3, -4]
    assert result.answers["A_co"] == sp.Matrix([[-1]])
    assert result.steps[-2].values["unstable"] == {1: [], 2: [3], 3: []}


@pytest.mark.parametrize(
    ("part", "plant"),
    [
        ("controllable", system([[0, 1], [-2, -3]], B=[0, 1], C=[[1, 0]])),
        ("observable", system([[0, 1], [-2, -3]], B=[0, 0], C=[[1, 0]])),
        ("full", system([[0, 1], [-2, -3]], B=[0, 1], C=[[1, 0]])),
    ],
)
def test_nothing_hidden_is_said_so(part, plant):
    result = found(plant, part)
    assert steps(result)[-1] == "whole"
    assert result.answers["T"] == sp.eye(2)
    assert result.answers["hidden_modes"] == []
    assert result.answers[f"A_{PARTS[part]}"] == plant.A


@pytest.mark.parametrize("part", PARTS)
def test_no_input_and_no_output(part):
    result = found(system([[0, 1], [-2, -3]], B=[0, 0], C=[[0, 0]], D=[[5]]), part)
    assert result.answers["orders"][0] == 0
    assert result.answers[f"A_{PARTS[part]}"].shape == (0, 0)
    assert result.steps[-1].values["G"] == 5


def test_without_an_output_the_controllable_part_is_found():
    result = found(system([[1, 0], [0, 2]], B=[1, 0]), "controllable")
    assert "C" not in result.answers
    assert result.answers["hidden_modes"] == [2]
    assert result.steps[-1].values["unstable"] == {1: [2]}


def test_without_an_input_the_observable_part_is_found():
    result = found(system([[1, 0], [3, 2]], C=[[1, 0]]), "observable")
    assert steps(result) == ["matrix", "seen", "bases", "transformed", "blocks", "hidden"]
    assert not {"B", "B_o"} & set(result.answers)
    assert result.answers["A_o"] == sp.Matrix([[1]])
    assert result.answers["hidden_modes"] == [2]
    assert result.steps[-1].values["unstable"] == {1: [2]}
    assert steps(found(system([[0, 1], [-2, -3]], C=[[1, 0]]), "observable"))[-1] == "whole"


@pytest.mark.parametrize("part", ["controllable", "full"])
def test_what_is_reached_needs_an_input(part):
    plant = system([[1, 0], [0, 2]], C=[[1, 0]])
    assert [option for option, _ in catalogue()[TASK].refused(plant, {"part": part})] == ["part"]
    assert ask(TASK, plant, part=part).status is Status.UNSOLVED


@pytest.mark.parametrize("part", ["observable", "full"])
def test_what_is_seen_needs_an_output(part):
    plant = system([[1, 0], [0, 2]], B=[1, 0])
    assert [option for option, _ in catalogue()[TASK].refused(plant, {"part": part})] == ["part"]
    assert ask(TASK, plant, part=part).status is Status.UNSOLVED


def test_several_inputs_and_outputs_in_discrete_time():
    A = sp.diag(sp.Rational(1, 2), 2, 1)
    plant = system(A, B=[[1, 0], [0, 1], [0, 0]], C=[[1, 0, 1], [1, 0, 0]], discrete=True)
    result = found(plant, "full")
    assert result.answers["orders"] == [1, 1, 1, 0]
    assert result.steps[-2].values["unstable"] == {1: [2], 2: [1]}


def test_a_mode_with_a_parameter_is_left_undecided():
    k = sp.Symbol("k")
    result = found(system([[-1, k], [k, -1]], B=[1, 1], C=[[1, 0]]), "controllable")
    assert result.answers["hidden_modes"] == [-1 - k]
    assert result.steps[5].values["undecided"] == [-1 - k]


def test_a_hidden_complex_pair_and_a_hidden_cubic():
    cubic = sp.Matrix([[0, 1, 0], [0, 0, 1], [-1, -1, 0]])
    A = sp.diag(sp.Matrix([[-1]]), sp.Matrix([[0, 1], [-5, -2]]), cubic)
    result = found(system(A, B=[1, 0, 0, 0, 0, 0], C=[[1, 1, 0, 1, 0, 0]]), "controllable")
    roots = sorted([complex(mode) for mode in result.answers["hidden_modes"]], key=lambda z: (z.real, z.imag))
    assert np.allclose(
        roots, sorted(np.linalg.eigvals(np.array(A[1:, 1:], dtype=float)), key=lambda z: (z.real, z.imag))
    )
    assert len(result.steps[5].values["unstable"][1]) == 2


def another(draw, plant, result, part):
    """The answers in other coordinates of the same decomposition: T S, S invertible with the pattern's zeros."""
    orders = [int(order) for order in result.answers["orders"]]
    owner = [i for i, order in enumerate(orders) for _ in range(order)]
    free = {"controllable": {(0, 0), (0, 1), (1, 1)}, "observable": {(0, 0), (1, 0), (1, 1)}}.get(
        part, {(0, 0), (1, 0), (1, 1), (3, 3), (1, 3), (0, 2), (1, 2), (2, 2), (3, 2)}
    )
    n = plant.order
    S = sp.Matrix(n, n, lambda i, j: draw(st.integers(-2, 2)) if (owner[i], owner[j]) in free else 0) + 5 * sp.eye(n)
    if S.det() == 0:
        S = 5 * sp.eye(n)
    T = sp.ImmutableMatrix(result.answers["T"] * S)
    A, B, C = T.inv() * plant.A * T, T.inv() * plant.B, plant.C * T
    k, suffix = orders[0], PARTS[part]
    return {
        **{"T": T, "A": A, "B": B, "C": C},
        **{f"A_{suffix}": A[:k, :k], f"B_{suffix}": B[:k, :], f"C_{suffix}": C[:, :k]},
    }


@tried(12)
@given(st.data(), st.sampled_from([COURSE, FOUR]), st.sampled_from(sorted(PARTS)))
def test_any_other_right_decomposition_is_accepted_also_answer_by_answer(data, plant, part):
    answers = another(data.draw, plant, found(plant, part), part)
    assert accepted(plant, answers, part)
    for name, value in answers.items():
        block = name.startswith(("B_", "C_"))  # in free coordinates, unless those of A say which
        assert accepted(plant, {name: value, **({f"A{name[1:]}": answers[f"A{name[1:]}"]} if block else {})}, part), (
            name
        )
    without = {name: value for name, value in answers.items() if name != "T"}
    assert accepted(plant, without, part)


@pytest.mark.parametrize("plant", [COURSE, FOUR], ids=["course", "four"])
@pytest.mark.parametrize("part", PARTS)
def test_wrong_answers_are_rejected_alone_and_together(part, plant):
    answers = dict(found(plant, part).answers)
    for name, right in answers.items():
        for wrong in corrupted(name, right, answers, plant, part):
            assert rejected(TASK, plant, {name: wrong}, part=part), (name, wrong)
            assert rejected(TASK, plant, {**answers, name: wrong}, part=part), (name, wrong)


def corrupted(name, right, answers, plant, part):
    """Wrong values of an answer, wrong also when it stands alone."""
    if isinstance(right, list):
        yield [*right, right[-1]]
        yield [right[0] + 1, *right[1:]]
        return
    if name == "T":
        yield sp.ImmutableMatrix(right[:, ::-1])
        yield sp.zeros(*right.shape)
        yield right[:, :-1]
        yield from (sp.ImmutableMatrix(right + unit(right, i, j)) for i, j in breaking(part, answers, right))
    elif name == "A":
        yield sp.ImmutableMatrix(right[::-1, ::-1])
        yield -right
        yield right + sp.eye(right.rows) / 1000
        yield right[:-1, :-1]
    elif name.startswith("A_"):
        yield right + sp.eye(right.rows) / 1000
        yield sp.zeros(right.rows + 1)
    elif name.startswith("B"):
        yield sp.zeros(*right.shape)
        yield right.T if right.shape != (1, 1) else sp.zeros(2, 1)
    else:
        yield sp.zeros(*right.shape)
        yield right.T if right.shape != (1, 1) else sp.zeros(1, 2)


def unit(M, i, j):
    return sp.Matrix(*M.shape, lambda p, q: sp.Rational(1, 100) if (p, q) == (i, j) else 0)


def breaking(part, answers, T):
    """Places where a small change of T moves a column out of its subspace, so that a zero block breaks."""
    orders = [int(order) for order in answers["orders"]]
    owner = [i for i, order in enumerate(orders) for _ in range(order)]
    rows = sp.Matrix(T).inv()
    for i in range(T.rows):
        for j in range(T.cols):
            if any(rows[p, i] != 0 and (owner[p], owner[j]) in FORBIDDEN[part] for p in range(T.rows)):
                yield i, j


FORBIDDEN = {
    "controllable": {(1, 0)},
    "observable": {(0, 1)},
    "full": {(2, 0), (3, 0), (0, 1), (2, 1), (3, 1), (0, 3), (2, 3)},
}


def test_the_transposed_transformation_of_the_course_is_wrong():
    T = sp.ImmutableMatrix([[1, 0, 0], [-2, 1, 1], [0, -1, 1]])
    assert rejected(TASK, COURSE, {"T": T}, part="controllable")


def test_one_wrong_matrix_spoils_no_other():
    answers = dict(found(COURSE, "controllable").answers)
    answers = {**{name: answers[name] for name in ("A", "C")}, "B": 2 * answers["B"]}
    task = catalogue()[TASK]
    checks = task.verify(task.given(COURSE, {"part": "controllable"}), Answers(**answers))
    verdicts = {check.judges: check.status for check in checks}
    assert verdicts[("A",)] is CheckStatus.PASSED
    assert CheckStatus.FAILED in (verdicts[("B",)], verdicts[("C",)])


def test_parameters_are_judged_too():
    k, a = sp.symbols("k a")
    plant = system([[-a, k], [k, -a]], B=[1, 1], C=[[1, 0]])
    assert accepted(plant, {"T": sp.ImmutableMatrix([[k, 1], [k, 0]])}, "controllable")
    assert accepted(plant, {"A": sp.ImmutableMatrix([[k - a, 7], [0, -k - a]])}, "controllable")
    assert rejected(TASK, plant, {"T": sp.ImmutableMatrix([[k, 1], [a, 0]])}, part="controllable")
    assert rejected(TASK, plant, {"A": sp.ImmutableMatrix([[-a - k, 7], [0, k - a]])}, part="controllable")
    assert rejected(TASK, plant, {"hidden_modes": [k - a]}, part="controllable")


def test_the_residual_of_a_rounded_answer_is_small_and_of_a_wrong_one_is_not():
    """So that marking can tell rounding from a mistake."""
    plant = (COURSE.A, COURSE.B, COURSE.C)
    T = sp.Matrix([[1, -2, 0], [0, 1, -1], [0, 1, 1]])
    off = sp.zeros(3)
    off[2, 0] = sp.Rational(1, 1000)
    assert 1e-4 < judges.separation_residual("controllable", sp.ImmutableMatrix(T + off), *plant) < 2e-3
    A = sp.Matrix([[0, -4, -2], [1, -2, -1], [0, 0, -1]])
    assert 1e-6 < judges.coordinates_residual("controllable", plant, {"A": A + off}) < 2e-3
    assert judges.coordinates_residual("controllable", plant, {"A": A}) <= 1e-9
    assert (
        judges.visible_part_residual(
            "controllable", plant, {"A": A[:2, :2], "B": sp.Matrix([1, 0]), "C": sp.Matrix([[1, 5]])}
        )
        > 1e-2
    )


PAGE = """
title: t
system: {A: [[1, 0, 0], [1, -1, 1], [0, 0, -2]], B: [1, 1, 0], C: [1, 0, 0]}
find: {a: {task: controllability, method: rank}, b: {task: kalman_decomposition, part: controllable}}
"""


def test_the_matrix_stands_once_and_what_cancels_is_seen():
    solved = solver.solve(PAGE)
    page = solved.markdown(detail="tutor")
    assert page.count(r"AB = \begin{bmatrix}1 & 0 & 0") == 1  # multiplied out once
    assert r"= \frac{s + 1}{s^{2} - 1} = \frac{1}{s - 1}" in page
    assert r"A_{\bar{c}} = -2" in page
    assert r"NA = \begin{bmatrix}0 & 0 & 1\end{bmatrix}" in page
    assert r"= HN,\qquad H = -2" in page


def test_a_key_shows_the_new_matrices_once():
    key = solver.solve(PAGE).markdown(detail="key")
    assert key.count("T = ") == 1
    assert r"\bar{A}" not in key
    assert r"\dot{\xi} = " in key
