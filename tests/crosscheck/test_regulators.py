"""Optimal gains against python-control and scipy's Riccati solver, and by the equations themselves."""

import control
import numpy as np
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.linalg import solve_continuous_are

from solver.derivation import Unsolved
from tests.helpers.comparing import answers_of, arrays, close, floats, numbers, systems_tried
from tests.helpers.strategies import plain_plants, plants


@st.composite
def weights(draw, n, m):
    """Q = H Hᵀ, of any rank, mostly definite, and R positive definite."""
    entries = st.integers(-1, 2)
    H = sp.Matrix(n, n, lambda *_: draw(entries))
    Q = H * H.T + (sp.eye(n) if draw(st.integers(0, 3)) else sp.zeros(n))
    R = sp.diag(*(draw(st.sampled_from([1, 2, sp.Rational(1, 2), 4])) for _ in range(m)))
    return sp.ImmutableMatrix(Q), sp.ImmutableMatrix(R)


def hamiltonian_gap(A, B, Q, R):
    """How far the eigenvalues of the Hamiltonian matrix stay from the axis."""
    H = np.block([[A, -B @ np.linalg.solve(R, B.T)], [-Q, -A.T]])
    return float(np.min(np.abs(np.linalg.eigvals(H).real)))


def stabilizable(A, B):
    unstable = [value for value in np.linalg.eigvals(A) if value.real > -1e-6]
    pencils = [np.hstack([A - value * np.eye(len(A)), B]) for value in unstable]
    return all(np.linalg.svd(P, compute_uv=False)[-1] > 1e-4 for P in pencils)


def check_regulator(plant, Q, R, method):
    A, B, _, _ = arrays(plant)
    Qf, Rf = floats(Q), floats(R)
    solvable = stabilizable(A, B) and hamiltonian_gap(A, B, Qf, Rf) > 1e-4
    try:
        answers = answers_of("lqr", plant, method, Q=Q, R=R)
    except Unsolved as refusal:
        assert not solvable, refusal
        return None
    P, K = floats(answers["P"]), floats(answers["K"])
    residual = A.T @ P + P @ A - P @ B @ np.linalg.solve(Rf, B.T @ P) + Qf
    assert np.max(np.abs(residual)) <= 1e-8 * max(1, np.max(np.abs(P))) ** 2
    assert np.all(np.linalg.eigvals(A - B @ K).real < 1e-6)
    assert close(floats(answers["closed_loop_A"]), A - B @ K, 1e-9)
    if solvable:
        assert close(P, solve_continuous_are(A, B, Qf, Rf), 1e-5)
        assert close(K, control.lqr(A, B, Qf, Rf)[0], 1e-5)
        assert close(np.poly(numbers(answers["eigenvalues"])), np.poly(A - B @ K), 1e-5)
    return answers


@systems_tried(40)
@given(plants(3, inputs=2), st.sampled_from(["riccati", "hamiltonian"]), st.data())
def test_regulators_of_plants_made_of_blocks(made, method, data):
    plant = made.system
    Q, R = data.draw(weights(plant.order, plant.B.cols))
    check_regulator(plant, Q, R, method)


@systems_tried(40)
@given(plain_plants(4), st.sampled_from(["riccati", "hamiltonian"]), st.data())
def test_regulators_of_plants_of_small_integers(plant, method, data):
    if plant.order == 4:
        method = "hamiltonian"
    Q, R = data.draw(weights(plant.order, plant.B.cols))
    check_regulator(plant, Q, R, method)


@systems_tried(20)
@given(plain_plants(2, smallest=2), st.data())
def test_every_solution_listed_solves_the_equation_and_the_list_is_whole(plant, data):
    A, B, _, _ = arrays(plant)
    Q, R = data.draw(weights(2, plant.B.cols))
    try:
        answers = answers_of("lqr", plant, "riccati", Q=Q, R=R)
    except Unsolved:
        return
    if "solutions" not in answers:
        return
    solutions = [floats(P) for P in answers["solutions"]]
    for P in solutions:
        residual = A.T @ P + P @ A - P @ B @ np.linalg.solve(floats(R), B.T @ P) + floats(Q)
        assert np.max(np.abs(residual)) < 1e-7 * max(1, np.max(np.abs(P))) ** 2
    for P, word in zip(solutions, answers["definiteness"], strict=True):
        values = np.linalg.eigvalsh(P)
        if np.min(np.abs(values)) > 1e-8:
            expected = "positive definite" if values[0] > 0 else "negative definite" if values[1] < 0 else "indefinite"
            assert str(word) == expected
    found = invariant_solutions(A, B, floats(Q), floats(R))
    if found is not None:
        assert len(found) == len(solutions)
        assert all(any(close(P, ours, 1e-5) for ours in solutions) for P in found)


def invariant_solutions(A, B, Q, R):
    """All real symmetric solutions from pairs of eigenvectors of the Hamiltonian matrix; None if it is degenerate."""
    H = np.block([[A, -B @ np.linalg.solve(R, B.T)], [-Q, -A.T]])
    values, vectors = np.linalg.eig(H)
    gaps = np.abs(np.subtract.outer(values, values)) + np.eye(4)
    if np.min(gaps) < 1e-3 or np.min(np.abs(values.real)) < 1e-3:
        return None
    found = []
    for i in range(4):
        for j in range(i):
            top, bottom = vectors[:2, [i, j]], vectors[2:, [i, j]]
            size = abs(np.linalg.det(top))
            if abs(values[i] + values[j]) < 1e-6 or size < 1e-9:
                continue
            if size < 1e-5:
                return None
            P = bottom @ np.linalg.inv(top)
            if np.max(np.abs(P.imag)) < 1e-7 * max(1, np.max(np.abs(P))):
                found.append(P.real)
    return found


@systems_tried(30)
@given(plain_plants(3), st.sampled_from(["riccati", "hamiltonian"]), st.data())
def test_filters_are_those_of_control(plant, method, data):
    A, _, C, _ = arrays(plant)
    n, p = plant.order, plant.C.rows
    Q, R = data.draw(weights(n, p))
    solvable = stabilizable(A.T, C.T) and hamiltonian_gap(A.T, C.T, floats(Q), floats(R)) > 1e-4
    try:
        answers = answers_of("kalman_filter", plant, method, Q=Q, R=R)
    except Unsolved as refusal:
        assert not solvable, refusal
        return
    assume(solvable)
    L, P, _ = control.lqe(A, np.eye(n), C, floats(Q), floats(R))
    assert close(floats(answers["L"]), L, 1e-5)
    assert close(floats(answers["P"]), P, 1e-5)
    assert close(floats(answers["error_A"]), A - L @ C, 1e-5)


@systems_tried(30)
@given(plain_plants(3), st.data())
def test_optimal_tracking_reaches_the_reference_with_the_gain_of_the_regulator(plant, data):
    A, B, C, D = arrays(plant)
    n, p = plant.order, plant.C.rows
    Q, R = data.draw(weights(n, plant.B.cols))
    M = np.block([[A, B], [C, D]])
    full = np.linalg.svd(M, compute_uv=False)
    reachable = len(full) >= n + p and full[n + p - 1] > 1e-6
    solvable = stabilizable(A, B) and hamiltonian_gap(A, B, floats(Q), floats(R)) > 1e-4
    try:
        answers = answers_of("optimal_tracking", plant, Q=Q, R=R)
    except Unsolved as refusal:
        assert not (reachable and solvable), refusal
        return
    K, K_o = floats(answers["K"]), floats(answers["K_o"])
    assume(solvable)
    assert close(K, control.lqr(A, B, floats(Q), floats(R))[0], 1e-5)
    closed = control.ss(A - B @ K, B @ K_o, C - D @ K, D @ K_o)
    assert close(np.reshape(control.dcgain(closed), (p, -1)), np.eye(p), 1e-5)
