"""Transition matrices, functions of matrices and responses against scipy's exponentials and python-control."""

import control
import numpy as np
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.linalg import expm, inv, sqrtm

from solver.derivation import Unsolved
from tests.helpers.comparing import answers_of, arrays, close, floats, numbers, systems_tried
from tests.helpers.strategies import plain_plants, plants

t, k = sp.symbols("t k")
TIMES = (0.2, 0.9, 1.7)
CONTINUOUS = ("laplace", "power_series", "cayley_hamilton", "modal")
DISCRETE = ("z_transform", "cayley_hamilton", "modal")
SIGNALS = {  # each as the output h·w of w' = S w, w(0) = w₀
    sp.S.One: ([[0]], [1], [1]),
    t: ([[0, 1], [0, 0]], [0, 1], [1, 0]),
    sp.exp(-t): ([[-1]], [1], [1]),
    sp.exp(t / 2): ([[sp.S.Half]], [1], [1]),
    t * sp.exp(-2 * t): ([[-2, 1], [0, -2]], [0, 1], [1, 0]),
    sp.sin(2 * t): ([[0, 2], [-2, 0]], [0, 1], [1, 0]),
    sp.cos(t): ([[0, 1], [-1, 0]], [1, 0], [1, 0]),
    sp.exp(-t) * sp.sin(t): ([[-1, 1], [-1, -1]], [0, 1], [1, 0]),
}
SEQUENCES = {
    sp.S.One: lambda i: 1.0,
    k: float,
    sp.Rational(1, 2) ** k: lambda i: 0.5**i,
    (-1) ** k: lambda i: (-1.0) ** i,
    sp.cos(sp.pi * k / 2): lambda i: (1.0, 0.0, -1.0, 0.0)[i % 4],
}


def at(M, variable, value):
    found = np.array(sp.Matrix(M).subs(variable, sp.Float(value, 40)).evalf(30).tolist(), dtype=complex)
    assert np.max(np.abs(found.imag), initial=0) < 1e-12
    return found.real.reshape(M.shape)


@systems_tried(50)
@given(plants(5), st.sampled_from(CONTINUOUS))
def test_transition_matrices_are_matrix_exponentials(made, method):
    A = floats(made.system.A)
    Phi = answers_of("state_transition_matrix", made.system, method)["Phi"]
    for time in TIMES:
        assert close(at(Phi, t, time), expm(A * time), 1e-8)


@systems_tried(15)
@given(plain_plants(4), st.sampled_from(CONTINUOUS))
def test_transition_matrices_where_eigenvalues_are_of_any_degree(plant, method):
    A = floats(plant.A)
    Phi = answers_of("state_transition_matrix", plant, method)["Phi"]
    for time in TIMES:
        assert close(at(Phi, t, time), expm(A * time), 1e-8)


@systems_tried(30)
@given(plants(5, discrete=True), st.sampled_from(DISCRETE))
def test_transition_matrices_in_discrete_time_are_powers(made, method):
    A = floats(made.system.A)
    Phi = answers_of("state_transition_matrix", made.system, method)["Phi"]
    for step in (1, 2, 7):
        exact = sp.Matrix(Phi).subs(k, step)
        assert close(floats(exact), np.linalg.matrix_power(A, step), 1e-8)


@systems_tried(40)
@given(plants(4, stable=True), st.sampled_from(sorted(SIGNALS, key=str)), st.sampled_from(["laplace", "convolution"]))
def test_responses_are_those_of_the_system_joined_with_the_source_of_its_input(made, signal, method):
    plant = made.system
    A, B, C, D = arrays(plant)
    n, m = B.shape
    x0 = np.arange(1, n + 1) % 3 - 1
    S, w0, h = (np.array(part, dtype=float) for part in SIGNALS[signal])
    gain = np.array([(-1.0) ** j for j in range(m)])
    whole = np.block([[A, np.outer(B @ gain, h)], [np.zeros((len(S), n)), S]])
    inputs = tuple(signal * (-1) ** j for j in range(m))
    answers = answers_of("response", plant, method, input=inputs, initial_state=sp.ImmutableMatrix(x0))
    for time in TIMES:
        state = expm(whole * time) @ np.concatenate([x0, w0])
        assert close(at(answers["x"], t, time)[:, 0], state[:n], 1e-7)
        y = answers["y"] if hasattr(answers["y"], "shape") else sp.Matrix([answers["y"]])
        assert close(at(y, t, time)[:, 0], C @ state[:n] + D @ gain * (h @ state[n:]), 1e-7)


@systems_tried(25)
@given(plants(4), st.sampled_from([sp.S.One, t, 2 - 3 * t]), st.sampled_from(["laplace", "convolution"]))
def test_responses_to_ramps_are_those_of_control(made, signal, method):
    """Between samples control draws straight lines, which these inputs are."""
    plant = made.system
    A, B, C, D = arrays(plant)
    answers = answers_of("response", plant, method, kind="zero_state", input=(signal,) * B.shape[1])
    times = np.linspace(0, 2, 11)
    u = np.array([[float(signal.subs(t, time)) for time in times]] * B.shape[1])
    theirs = control.forced_response(control.ss(A, B, C, D), times, u, squeeze=False)
    y = answers["y"] if hasattr(answers["y"], "shape") else sp.Matrix([answers["y"]])
    for index in (3, 10):
        assert close(at(answers["x"], t, times[index])[:, 0], theirs.states[:, index], 1e-6)
        assert close(at(y, t, times[index])[:, 0], theirs.outputs[:, index], 1e-6)


@systems_tried(30)
@given(
    plants(4, discrete=True),
    st.sampled_from(sorted(SEQUENCES, key=str)),
    st.sampled_from(["z_transform", "convolution"]),
)
def test_responses_in_discrete_time_are_recursions(made, signal, method):
    plant = made.system
    A, B, C, D = arrays(plant)
    n, m = B.shape
    x = np.arange(n) % 3 - 1.0
    answers = answers_of(
        "response", plant, method, input=(signal,) * m, initial_state=sp.ImmutableMatrix(x.astype(int))
    )
    y = answers["y"] if hasattr(answers["y"], "shape") else sp.Matrix([answers["y"]])
    for step in range(7):
        u = np.full(m, SEQUENCES[signal](step))
        ours = floats(sp.Matrix(answers["x"]).subs(k, step)), floats(sp.Matrix(y).subs(k, step))
        assert close(ours[0][:, 0], x, 1e-8)
        assert close(ours[1][:, 0], C @ x + D @ u, 1e-8)
        x = A @ x + B @ u


@systems_tried(30)
@given(plants(4, stable=True, inputs=1, outputs=1))
def test_the_final_value_of_a_step_response_is_the_gain_of_control(made):
    answers = answers_of("response", made.system, kind="zero_state", input=(sp.S.One,))
    theirs = np.ravel(control.dcgain(control.ss(*arrays(made.system))))
    assert close(numbers([answers["y_final"]]).real, theirs, 1e-6)


FUNCTIONS = {
    "power": (sp.Symbol("A") ** 9, lambda A: np.linalg.matrix_power(A, 9)),
    "inverse": (1 / sp.Symbol("A"), inv),
    "exponential": (sp.exp(sp.Symbol("A")), expm),
    "sine": (sp.sin(sp.Symbol("A")), lambda A: expm(1j * A).imag),
    "root": (sp.sqrt(sp.Symbol("A")), sqrtm),
    "polynomial": (sp.Symbol("A") ** 3 - 2 * sp.Symbol("A") + 1, lambda A: A @ A @ A - 2 * A + np.eye(len(A))),
}


@systems_tried(50)
@given(plants(4), st.sampled_from(sorted(FUNCTIONS)), st.sampled_from(["cayley_hamilton", "modal"]))
def test_functions_of_matrices_are_those_of_scipy(made, name, method):
    plant = made.system
    function, theirs = FUNCTIONS[name]
    values = np.array([complex(b.sigma, b.omega) for b in made.blocks])
    if name == "inverse":
        assume(np.all(values != 0))
    if name == "root":
        assume(np.all((values.real > 0) | (values.imag != 0)))  # scipy's principal root; ours may be complex
    try:
        F = answers_of("matrix_function", plant, method, function=function)["F"]
    except Unsolved:
        assert name == "root"
        assert any(block.size > 1 for block in made.blocks)
        return
    ours = np.array(sp.Matrix(F).evalf(25).tolist(), dtype=complex)
    assert close(ours, theirs(floats(plant.A)), 1e-6)
