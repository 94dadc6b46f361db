"""Gains for poles, of state feedback, observers and servos: exact spectra, python-control, simulations."""

import control
import numpy as np
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.linalg import expm

from solver.derivation import Unsolved
from tests.helpers.asking import system
from tests.helpers.comparing import (
    answers_of,
    arrays,
    characteristic,
    close,
    coefficients,
    floats,
    krylov,
    product,
    rank_modulo_a_prime,
    same,
    systems_tried,
)
from tests.helpers.strategies import plain_plants, plants, poles_of

METHODS = ("coefficient_matching", "bass_gura", "canonical_form", "ackermann")


def polynomial_of(roots):
    return [sp.expand(c) for c in coefficients(roots)]


def loop(A, B, K):
    return sp.Matrix(A) - product(B, K)


def hidden(task, plant):
    return tuple(answers_of(task, plant)["hidden_modes"])


def controllable(plant):
    return rank_modulo_a_prime(krylov(plant.A, plant.B)) == plant.order


def observable(plant):
    return rank_modulo_a_prime(krylov(plant.A.T, plant.C.T)) == plant.order


@systems_tried(30)
@given(plants(5, discrete=None, inputs=1, hidden=False), st.data())
def test_all_methods_give_the_only_gain_of_one_input(made, data):
    plant = made.system
    assume(controllable(plant))
    poles = data.draw(poles_of(plant.order, plant.discrete))
    gains = [answers_of("pole_placement", plant, method, poles=poles)["K"] for method in METHODS]
    assert characteristic(loop(plant.A, plant.B, gains[0])) == polynomial_of(poles)
    assert all(same(K, gains[0]) for K in gains)
    if plant.order <= 4:
        theirs = control.acker(floats(plant.A), floats(plant.B), [complex(p) for p in poles])
        assert close(floats(gains[0]), np.atleast_2d(theirs), 1e-4)


@systems_tried(25)
@given(plain_plants(4, inputs=1), st.sampled_from(METHODS), st.data())
def test_gains_where_eigenvalues_are_of_any_degree(plant, method, data):
    assume(controllable(plant))
    poles = data.draw(poles_of(plant.order))
    K = answers_of("pole_placement", plant, method, poles=poles)["K"]
    assert characteristic(loop(plant.A, plant.B, K)) == polynomial_of(poles)


@systems_tried(20)
@given(plants(5, discrete=None), st.data())
def test_several_inputs_and_modes_that_stay(made, data):
    """The poles of what is reached are placed, the others stay; the gain may have free symbols."""
    plant = made.system
    fixed = hidden("stabilizability", plant)
    assume(len(fixed) < plant.order)
    chosen = data.draw(poles_of(plant.order - len(fixed), plant.discrete))
    method = data.draw(st.sampled_from(["unity_rank", *METHODS] if plant.B.cols > 1 else METHODS))
    poles = (*chosen, *fixed) if data.draw(st.booleans()) else chosen
    K = answers_of("pole_placement", plant, method, poles=poles)["K"]
    free = sorted(K.free_symbols, key=str)
    for value in (0, 1):
        assert characteristic(loop(plant.A, plant.B, K.subs(dict.fromkeys(free, value)))) == (
            polynomial_of([*chosen, *fixed])
        )


@systems_tried(20)
@given(plain_plants(4, smallest=2, inputs=2), st.data())
def test_the_spectrum_is_that_of_place_with_several_inputs(plant, data):
    assume(plant.B.cols == 2 and plant.B.rank() == 2 and controllable(plant))
    poles = tuple(map(sp.Integer, data.draw(st.permutations([-1, -2, -3, -4]))[: plant.order]))
    A, B = floats(plant.A), floats(plant.B)
    K = floats(answers_of("pole_placement", plant, "unity_rank", poles=poles)["K"])
    theirs = control.place(A, B, [float(p) for p in poles])
    assert close(np.poly(A - B @ K), np.poly(A - B @ theirs), 1e-6)


@systems_tried(25)
@given(plants(5, discrete=None), st.data())
def test_observers_place_the_error_and_leave_what_is_not_seen(made, data):
    plant = made.system
    fixed = hidden("detectability", plant)
    assume(len(fixed) < plant.order)
    chosen = data.draw(poles_of(plant.order - len(fixed), plant.discrete))
    method = data.draw(st.sampled_from(["unity_rank", *METHODS] if plant.C.rows > 1 else METHODS))
    if not answers_of("detectability", plant)["detectable"]:
        try:
            answers_of("observer", plant, method, poles=(*chosen, *fixed))
        except Unsolved:
            return
        raise AssertionError("the error of this observer does not decay")
    answers = answers_of("observer", plant, method, poles=(*chosen, *fixed))
    L, error = answers["L"], answers["error_A"]
    L, error = (sp.Matrix(M).subs(dict.fromkeys(M.free_symbols, 1)) for M in (L, error))
    assert same(error, sp.Matrix(plant.A) - product(L, plant.C))
    assert characteristic(error) == polynomial_of([*chosen, *fixed])
    if plant.C.rows == 1 and not fixed and plant.order <= 4:
        theirs = control.acker(floats(plant.A).T, floats(plant.C).T, [complex(p) for p in chosen])
        assert close(floats(L).T, np.atleast_2d(theirs), 1e-4)


@systems_tried(50)
@given(plants(5, smallest=2, hidden=False, through=False, outputs=2), st.data())
def test_reduced_observers_follow_any_motion_once_their_error_is_gone(made, data):
    plant = made.system
    p = rank_modulo_a_prime(plant.C)
    assume(p == plant.C.rows < plant.order and observable(plant))
    poles = data.draw(poles_of(plant.order - p))
    answers = answers_of("reduced_observer", plant, poles=poles)
    L, J, N, M, T = (sp.Matrix(answers[name]) for name in "LJNMT")
    assert characteristic(J) == polynomial_of(poles)
    # ω + L y and y give the state once they are right: the error η₂ − ω − L y moves by J alone
    inverse = T.inv()
    lower = inverse[p:, :]
    assert same(product(plant.C, T), sp.Matrix.hstack(sp.eye(p), sp.zeros(p, plant.order - p)))
    E = lower - product(L, plant.C)  # E x − ω is the error: E A = J E + N C, E B = M
    assert same(product(E, plant.A), product(J, E) + product(N, plant.C))
    assert same(product(E, plant.B), M)


@systems_tried(20)
@given(plants(4, discrete=None, inputs=1, outputs=1, hidden=False, smallest=2), st.booleans(), st.data())
def test_feedback_of_estimates_has_both_spectra_and_the_compensator_of_the_loop(made, reduced, data):
    plant = made.system
    assume(controllable(plant) and observable(plant))
    n = plant.order
    poles = data.draw(poles_of(n, plant.discrete))
    observer_poles = data.draw(poles_of(n - 1 if reduced else n, plant.discrete))
    try:
        answers = answers_of("observer_feedback", plant, poles=poles, observer_poles=observer_poles, reduced=reduced)
    except Unsolved as refusal:
        assert "well posed" in str(refusal)
        assert not plant.D.is_zero_matrix
        return
    assert characteristic(answers["closed_loop_A"]) == polynomial_of([*poles, *observer_poles])
    x = sp.Symbol("z" if plant.discrete else "s")
    H, G = answers["compensator"], answers_of("transfer_function", plant)["G"]
    # the loop u = H y has the characteristic polynomial of both, up to what H and the plant cancel
    top = sp.Poly(sp.numer(sp.cancel(1 - H * G)), x)
    whole = sp.Poly(polynomial_of([*poles, *observer_poles]), x)
    assert sp.rem(whole, top).is_zero
    if not reduced:
        K = answers_of("pole_placement", plant, poles=poles)["K"]
        L = answers_of("observer", plant, poles=observer_poles)["L"]
        A, B, C, D = arrays(plant)
        K, L = floats(K), floats(L)
        inner = A - B @ K - L @ C + L @ D @ K
        for point in (0.7 + 1.3j, 3.1 + 0.4j):
            value = -K @ np.linalg.solve(point * np.eye(n) - inner, L)
            assert close([complex(sp.sympify(H).subs(x, point))], value[0], 1e-5)


@systems_tried(40)
@given(plants(3, discrete=None, outputs=2, hidden=False), st.data())
def test_servos_reach_their_reference(made, data):
    plant = made.system
    n, p = plant.order, plant.C.rows
    A, B, C, D = plant.A, plant.B, plant.C, plant.D
    rest = sp.Matrix(A) - sp.eye(n) if plant.discrete else sp.Matrix(A)
    M = sp.Matrix(sp.BlockMatrix([[rest, B], [C, D]]).as_explicit())
    possible = rank_modulo_a_prime(M) == n + p and controllable(plant)
    poles = data.draw(poles_of(n + p, plant.discrete))
    method = data.draw(st.sampled_from(METHODS if plant.B.cols == 1 else ["unity_rank"]))
    try:
        answers = answers_of("servo", plant, method, poles=poles)
    except Unsolved:
        assert not possible
        return
    assert possible
    whole, K, k_I = (sp.Matrix(answers[name]) for name in ("closed_loop_A", "K", "k_I"))
    assert characteristic(whole) == polynomial_of(poles)
    assert same(whole[:n, :], sp.Matrix.hstack(loop(A, B, K), product(B, k_I)))
    reference = np.arange(1.0, p + 1)
    loop_A, drive = floats(whole), np.concatenate([np.zeros(n), reference])
    if plant.discrete:
        state = np.linalg.solve(np.eye(n + p) - loop_A, drive)
    else:  # simulated, from rest, for many time constants
        big = np.block([[loop_A, drive[:, None]], [np.zeros((1, n + p + 1))]])
        state = (expm(big * 80) @ np.append(np.zeros(n + p), 1.0))[:-1]
    output = floats(sp.Matrix.hstack(sp.Matrix(C) - product(D, K), product(D, k_I))) @ state
    assert close(output, reference, 1e-5)


@systems_tried(40)
@given(plants(4, discrete=None, outputs=2, hidden=False), st.data())
def test_a_reference_is_tracked(made, data):
    plant = made.system
    n, p = plant.order, plant.C.rows
    assume(controllable(plant))
    rest = sp.Matrix(plant.A) - sp.eye(n) if plant.discrete else sp.Matrix(plant.A)
    M = sp.Matrix(sp.BlockMatrix([[rest, plant.B], [plant.C, plant.D]]).as_explicit())
    poles = data.draw(poles_of(n, plant.discrete))
    try:
        answers = answers_of("reference_tracking", plant, poles=poles)
    except Unsolved:
        assert rank_modulo_a_prime(M) < n + p
        return
    assert rank_modulo_a_prime(M) == n + p
    K, K_o = (floats(answers[name]) for name in ("K", "K_o"))
    A, B, C, D = arrays(plant)
    closed = control.ss(A - B @ K, B @ K_o, C - D @ K, D @ K_o, *([True] if plant.discrete else []))
    assert close(np.reshape(control.dcgain(closed), (p, p)), np.eye(p), 1e-5)


@systems_tried(30)
@given(plants(4, inputs=1, outputs=1, hidden=False, through=False), st.data())
def test_a_model_is_matched_by_the_closed_loop(made, data):
    plant = made.system
    assume(controllable(plant) and observable(plant))
    s = sp.Symbol("s")
    G = answers_of("transfer_function", plant)["G"]
    top, bottom = (sp.Poly(part, s) for part in sp.fraction(sp.cancel(G)))
    excess = bottom.degree() - top.degree()
    target = 1 / sp.prod([s - pole for pole in data.draw(poles_of(excess))])
    answers = answers_of("model_matching", plant, target=target)
    zeros = np.roots([float(c) for c in top.all_coeffs()])
    assume(np.all(np.abs(zeros.real) > 1e-6))
    assert bool(answers["feasible"]) == bool(np.all(zeros.real < 0))  # the zeros become hidden poles
    if answers["feasible"]:
        A, B, C, K = (sp.Matrix(answers[name]) for name in ("A", "B", "C", "K"))
        resolvent = (s * sp.eye(A.rows) - A + B * K).inv()
        gain = sp.cancel((C * resolvent * B)[0] / target)
        assert not gain.has(s)


@systems_tried(30)
@given(st.integers(1, 19), st.sampled_from([1, 2, 5, sp.Rational(1, 2)]))
def test_specifications_are_met_by_the_step_response(twentieths, natural):
    zeta = sp.Rational(twentieths, 20)
    s = sp.Symbol("s")
    answers = answers_of("desired_poles", system([[0]]), damping_ratio=zeta, natural_frequency=sp.sympify(natural))
    found = sp.Poly(answers["polynomial"], s).all_coeffs()
    assert close([float(c) for c in found], [1, 2 * float(zeta * natural), float(natural) ** 2], 1e-9)
    model = control.tf([float(found[2])], [float(c) for c in found])
    info = control.step_info(model, np.linspace(0, 20 / float(natural), 20001))
    asked = {"overshoot": sp.nsimplify(sp.Float(info["Overshoot"] / 100), rational=True)}
    if info["Overshoot"] > 0.5:
        asked["peak_time"] = sp.nsimplify(info["PeakTime"], rational=True)
        again = answers_of("desired_poles", system([[0]]), **asked)
        assert close([float(again["damping_ratio"])], [float(zeta)], 1e-2)
