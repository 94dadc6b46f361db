"""Loops of several inputs and outputs: products in the order of the formula, by numpy; states; sizes at fault."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

import solver
from solver import exact
from solver.derivation import CheckStatus, Status, Unsolved
from solver.derivation.conversion import composed, converted
from solver.engine import solve_problem, yield_into
from solver.lazy import numeric
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import MatrixFeedback, OutputFeedback, StateSpace, TransferFunction
from solver.tasks import catalogue

s = sp.Symbol("s")
POINT = 0.7 + 1.3j
G = 'transfer_matrix: [["1/(s+1)", "2/(s+3)"], ["1/(s+1)", "1/(s+1)"]]'


def solved(find, system=G):
    text = f"system: {{{system}}}\nfind:\n  a: {find}\n"
    return solve_problem(read_problem(Source("loop.yaml", text), catalogue())).parts[0]


def value(M, at=POINT):
    return np.array(sp.Matrix(M).subs(s, at).evalf(30).tolist(), dtype=complex)


def lag(gain, pole):
    return sp.Integer(gain) / (s + pole)


NO_LOOP = {"ill_posed_matrix_loop", "ill_posed_direct_path", "constant_plant", "improper_loop"}

elements = st.builds(lag, st.integers(-3, 3), st.integers(1, 4))


def matrices(rows, columns, entries):
    return st.lists(entries, min_size=rows * columns, max_size=rows * columns).map(
        lambda flat: sp.ImmutableMatrix(rows, columns, flat)
    )


@settings(max_examples=15, deadline=None)
@given(st.data(), st.integers(1, 2), st.integers(1, 2), st.integers(1, 2))
def test_generated_loops_are_numpys_products(data, p, m, q):
    entries = st.one_of(elements, st.integers(-2, 2).map(sp.Integer))
    plant, C, H = (data.draw(matrices(*size, entries)) for size in ((p, m), (q, p), (m, q)))
    system = TransferFunction(plant, *_parts(plant), s)
    loop = MatrixFeedback(system, C, H)
    L = value(C) @ value(plant)
    wanted = L @ np.linalg.inv(np.eye(m) + value(H) @ L)
    steps = []
    try:
        T = yield_into(steps, converted(loop, ("transfer_function",)))
        states = yield_into(steps, converted(loop, ("A",)))
    except Unsolved as refused:
        if refused.reason.kind.split("/")[1] not in NO_LOOP:
            raise
        return
    assert np.allclose(value(T.matrix), wanted)
    A, B, C_, D = (value(M) for M in (states.A, states.B, states.C, states.D))
    assert np.allclose(C_ @ np.linalg.solve(POINT * np.eye(len(A)) - A, B) + D, wanted)
    assert all(check.status is CheckStatus.PASSED for check in numeric.check_steps(steps))


def _parts(M):
    pairs = [[sp.fraction(sp.together(entry)) for entry in row] for row in M.tolist()]
    return [tuple(tuple(pair[i] for pair in row) for row in pairs) for i in (0, 1)]


def test_the_controller_acts_on_the_outputs():
    found = solved('{task: transfer_function, controller: [[1, 2], [0, "1/s"]]}')
    assert found.status is Status.VERIFIED
    plant = np.array([[1 / (POINT + 1), 2 / (POINT + 3)], [1 / (POINT + 1)] * 2])
    assert np.allclose(value(found.answers["G"]), np.array([[1, 2], [0, 1 / POINT]]) @ plant)


def test_steps_of_a_loop():
    found = solved("{task: transfer_function, controller: [[1, 0], [0, 2]], feedback: unity}")
    assert [step.kind for step in found.steps[:3]] == ["forward", "returned", "closed_matrix"]
    det = found.steps[1].claims["determinant"].right
    assert sp.cancel(det - (sp.eye(2) + sp.diag(1, 2) * PLANT).det()) == 0


PLANT = sp.Matrix([[1 / (s + 1), 2 / (s + 3)], [1 / (s + 1), 1 / (s + 1)]])


def test_what_the_controller_cancels_stays_a_mode_of_the_loop():
    system = 'transfer_matrix: [["1/(s-1)", 0], [0, "1/(s+1)"]]'
    found = solved('{task: stability, controller: [["(s-1)/(s+2)", 0], [0, 1]], feedback: unity}', system)
    assert found.status is Status.VERIFIED
    assert found.answers["verdict"] == "unstable"
    assert found.answers["bibo_stable"] is True
    assert sorted(found.answers["eigenvalues"]) == [-3, -2, 1]


def test_the_eigenvalues_are_the_zeros_of_the_determinant():
    found = solved('{task: stability, controller: [[1, 0], [0, "1/s"]], feedback: [[1, 0], [0, "2/(s+4)"]]}')
    L = sp.diag(1, 1 / s) * PLANT
    top = sp.numer(sp.cancel((sp.eye(2) + sp.diag(1, 2 / (s + 4)) * L).det()))
    wanted = np.roots([complex(c) for c in sp.Poly(top, s).all_coeffs()])
    own = np.array([complex(sp.N(each)) for each in found.answers["eigenvalues"]])
    assert np.allclose(np.sort_complex(wanted), np.sort_complex(own))


def test_a_plant_with_states_keeps_them():
    system = "A: [[0, 1], [-2, -3]], B: [[1, 0], [0, 1]], C: [[1, 0], [0, 1]], D: [[1, 0], [0, 0]]"
    found = solved("{task: stability, controller: [[2, 0], [0, 3]], feedback: unity}", system)
    assert found.status is Status.VERIFIED
    A, D, C = np.array([[0, 1], [-2, -3]]), np.diag([1.0, 0]), np.diag([2.0, 3])
    loop = A - np.linalg.inv(np.eye(2) + C @ D) @ C
    own = np.array([complex(sp.N(each)) for each in found.answers["eigenvalues"]])
    assert np.allclose(np.sort_complex(np.linalg.eigvals(loop)), np.sort_complex(own))


def test_an_improper_controller_has_a_transfer_matrix_where_the_loop_is_proper():
    find = "controller: [[s, 0], [0, 1]], feedback: unity"
    assert solved(f"{{task: transfer_function, {find}}}").status is Status.VERIFIED
    assert solved(f"{{task: stability, {find}}}").reason.kind == "conversions/improper_element"


@pytest.mark.parametrize(
    ("find", "says"),
    [
        ("{task: stability, feedback: -1}", "ill-posed"),
        ("{task: transfer_function, feedback: [[-1, 0], [0, 0]]}", "ill-posed"),
        ("{task: transfer_function, controller: [[s, 0], [0, s]]}", "improper"),
    ],
)
def test_a_loop_that_makes_no_sense_is_refused_in_words(find, says):
    found = solved(find, "transfer_matrix: [[1, 0], [0, 1/s]]")
    assert found.status is Status.UNSOLVED
    assert says in str(found.reason)


@pytest.mark.parametrize(
    ("find", "says", "column"),
    [
        ("{task: stability, controller: [[1, 0, 2]]}", "needs a column for each of them", 31),
        ("{task: stability, controller: [[1], [0]]}", "the transpose would fit", 31),
        ("{task: stability, controller: [[1, 2]], feedback: unity}", "as a matrix with 2 rows and 1 column", 51),
        ("{task: stability, controller: [[1, 2]], feedback: [[1, 0]]}", "must be 2×1 (the transpose would fit)", 51),
        ("{task: stability, feedback: [[1, 0], [0]]}", "row 2 has 1 entry", 38),
        ("{task: stability, feedback: [1, 0]}", "must be a list of rows", 29),
        ("{task: stability, controller: [[1, 0], [0, t]]}", "t is the time", 44),
    ],
)
def test_sizes_and_entries_at_fault_are_told_at_their_place(find, says, column):
    with pytest.raises(InputError) as caught:
        solved(find, 'transfer_matrix: [["1/(s+1)", "2/(s+3)"], ["1/(s+1)", "1/(s+1)"]]')
    first = caught.value.diagnostics[0]
    assert says in first.message
    assert (first.line, first.column) == (3, column + 5)


def test_one_column_of_a_plant_with_one_output_fits():
    find = '{task: transfer_function, controller: [[1], ["1/s"]], feedback: [[1, 0]]}'
    found = solved(find, 'transfer_function: "1/(s+2)"')
    assert found.status is Status.VERIFIED
    assert sp.simplify(found.answers["G"] - sp.Matrix([1, 1 / s]) / (s + 3)) == sp.zeros(2, 1)


def test_a_loop_is_one_of_matrices_where_anything_in_it_is():
    single = TransferFunction(sp.ImmutableMatrix([[1 / s]]), ((sp.Integer(1),),), ((s,),), s)
    one = {"controller": sp.Integer(2), "feedback": sp.Integer(1)}
    assert type(composed(single, one)) is OutputFeedback
    assert type(composed(single, {**one, "controller": sp.ImmutableMatrix([[2]])})) is MatrixFeedback
    plant = StateSpace(sp.ImmutableMatrix([[1]]), sp.ImmutableMatrix([[1, 2]]), sp.ImmutableMatrix([[1]]))
    assert type(composed(plant, one)) is MatrixFeedback


def test_states_in_series_and_in_a_loop():
    first = exact.Realization(*map(sp.ImmutableMatrix, ([[-1]], [[1]], [[2]], [[0]])))
    second = exact.Realization(*map(sp.ImmutableMatrix, ([[-3]], [[1]], [[1]], [[4]])))
    both = exact.in_series(first, second)
    assert sp.Matrix([[-1, 0], [2, -3]]) == both.A
    assert sp.Matrix([[8, 1]]) == both.C
    loop = exact.fed_back(first, exact.constant_realization(sp.ImmutableMatrix([[5]])))
    assert sp.Matrix([[-11]]) == loop.A
    minus = exact.constant_realization(sp.ImmutableMatrix([[-1]]))
    assert exact.fed_back(exact.constant_realization(sp.ImmutableMatrix([[1]])), minus) is None


@pytest.mark.parametrize(
    ("system", "loop"),
    [
        ("A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]", 'controller: "1/s", feedback: unity'),
        ("A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0], D: [[1]]", "feedback: unity"),
        ("A: [[-3, 2], [2, -4]], B: [[2, 0], [0, 1]], C: [[1, 0], [0, 1]]", "controller: [[1, 0], [0, 2]]"),
        ("A: [[-3, 2], [2, -4]], B: [[2, 0], [0, 1]], C: [[1, 0], [0, 1]]", "controller: 2, feedback: unity"),
        ("A: [[-3]], B: [[2, 1]], C: [[1], [1]]", "feedback: unity"),
    ],
)
@pytest.mark.parametrize("task", ["transfer_function", "stability"])
def test_what_a_page_displays_of_a_plant_in_state_space_holds(task, system, loop):
    part = solver.solve(f"system: {{{system}}}\nfind:\n  a: {{task: {task}, {loop}}}\n").parts[0]
    assert part.status is Status.VERIFIED, part.reason
    assert not part.unchecked
