"""Responses: closed forms by hand, scipy and recursion on random systems, peaks, refusals, corruptions."""

from functools import cache

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from solver.derivation import CheckStatus, Status
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

t, k = sp.symbols("t k")
e, half = sp.exp, sp.Rational(1, 2)
SCALE = system([[0, 1], [-20, -9]], B=[0, 1], C=[[2, 0]], D=[[0]])
CIRCUIT = system([[-10, -10], [10, 0]], B=[10, 0], C=[[0, 1]], D=[[0]])
OSCILLATOR = system([[0, 1], [-4, 0]], B=[0, 1], C=[[1, 0]], D=[[0]])
LAG = system([[-1]], B=[1], C=[[1]], D=[[0]])
METHODS = ("laplace", "convolution")


def step(argument):
    return sp.Heaviside(argument, evaluate=False)


def respond(plant, method="", *, x0=None, u=None, kind="complete"):
    options = {"kind": kind}
    if u is not None:
        options["input"] = tuple(map(sp.sympify, u if isinstance(u, list) else [u]))
    if x0 is not None:
        options["initial_state"] = sp.ImmutableMatrix(x0)
    return ask("response", plant, method, **options)


def same(a, b):
    left, right = (list(side) if isinstance(side, list | sp.MatrixBase) else [side] for side in (a, b))
    return len(left) == len(right) and all(sp.simplify(x - y) == 0 for x, y in zip(left, right, strict=True))


BY_HAND = [
    (SCALE, {"x0": [1, 0], "kind": "zero_input"}, 10 * e(-4 * t) - 8 * e(-5 * t)),
    (SCALE, {"u": 1, "kind": "zero_state"}, sp.Rational(1, 10) - e(-4 * t) / 2 + 2 * e(-5 * t) / 5),
    (OSCILLATOR, {"u": sp.sin(2 * t)}, sp.sin(2 * t) / 8 - t * sp.cos(2 * t) / 4),
    (LAG, {"u": t * e(-t)}, t**2 * e(-t) / 2),
    (LAG, {"u": t}, t - 1 + e(-t)),
    (LAG, {"u": sp.DiracDelta(t)}, e(-t)),
    (LAG, {"u": sp.sin(t) ** 2}, half - sp.cos(2 * t) / 10 - sp.sin(2 * t) / 5 - 2 * e(-t) / 5),
    (system([[0, 1], [0, 0]], B=[0, 1], C=[[1, 0]], D=[[0]]), {"u": 1, "x0": [1, 2]}, 1 + 2 * t + t**2 / 2),
    (system([[2]], B=[1], C=[[1]], D=[[3]]), {"u": e(2 * t)}, t * e(2 * t) + 3 * e(2 * t)),
]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(("plant", "question", "y"), BY_HAND)
def test_outputs_by_hand(plant, question, y, method):
    result = respond(plant, method, **question)
    assert result.status is Status.VERIFIED, result.reason
    assert same(result.answers["y"], y)


@pytest.mark.parametrize("method", METHODS)
def test_a_pulse_is_two_steps(method):
    result = respond(LAG, method, u=step(t) - step(t - 2))
    assert result.status is Status.VERIFIED, result.reason
    y = result.answers["y"]
    for time in (0.5, 1.9, 2.1, 5.0):
        expected = 1 - np.exp(-time) - (1 - np.exp(2 - time) if time > 2 else 0)
        assert abs(complex(y.subs(t, time).evalf()) - expected) < 1e-12
    assert result.answers["y_final"] == 0


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("x0", [None, [1, 0]])
@pytest.mark.parametrize("delay", [sp.Integer(2), half, sp.Symbol("T", positive=True)])
@pytest.mark.parametrize(
    "begun", [step(t), sp.DiracDelta(t), sp.sin(t) * step(t), step(t) + sp.DiracDelta(t), step(t) - step(t - 1)]
)
def test_an_input_that_begins_later_moves_the_system_later(begun, delay, x0, method):
    plant = system([[0, 1], [-2, -3]], B=[0, 1], C=[[1, 0]], D=[[0]])
    result = respond(plant, method, u=begun.xreplace({t: t - delay}), x0=x0)
    assert result.status is Status.VERIFIED, result.reason
    at_once = respond(plant, method, u=begun).answers["y"]
    free = respond(plant, method, x0=x0, kind="zero_input").answers["y"] if x0 else 0
    for time in (0.3, 2.9, 4.1):
        point = {sp.Symbol("T", positive=True): 1.7}
        since = time - float(delay.subs(point))
        expected = (at_once.subs(t, since) if since > 0 else 0) + (free.subs(t, time) if x0 else 0)
        assert abs(sp.N(result.answers["y"].subs(point).subs(t, time) - expected)) < 1e-12


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("x0", [None, [1]])
def test_an_input_that_is_zero_adds_nothing(x0, method):
    result = respond(LAG, method, u=0, x0=x0)
    assert result.status is Status.VERIFIED, result.reason
    assert same(result.answers["y"], e(-t) if x0 else 0)


def test_pieces_without_a_limit_may_have_one_together():
    pulse_of_ramps = (t - 1) * step(t - 1) - (t - 3) * step(t - 3)
    assert respond(LAG, u=pulse_of_ramps).answers["y_final"] == 2
    assert respond(LAG, u=sp.sin(t) * (step(t) - step(t - sp.pi))).answers["y_final"] == 0
    assert "y_final" not in respond(LAG, u=step(t) + t * step(t - 1)).answers


def test_an_impulse_moves_the_state_at_once_and_passes_through_d():
    result = respond(system([[-1]], B=[3], C=[[1]], D=[[2]]), u=sp.DiracDelta(t), x0=[1])
    assert result.status is Status.VERIFIED, result.reason
    assert same(result.answers["x"], [4 * e(-t)])
    assert result.answers["y"] == 4 * e(-t) + 2 * sp.DiracDelta(t)


def test_a_symbolic_initial_state_and_two_inputs():
    a, b = sp.symbols("x10 x20", real=True)
    plant = system([[0, 1], [-2, -3]], B=[[1, 0], [0, 1]], C=[[1, 0], [0, 1]], D=[[0, 0], [0, 0]])
    result = respond(plant, u=[e(-3 * t), 1], x0=[a, b])
    assert result.status is Status.VERIFIED, result.reason
    x = result.answers["x"]
    assert same(x.subs(t, 0), [a, b])
    forced = plant.A * x + sp.Matrix([e(-3 * t), 1])
    assert same(x.diff(t), forced)
    assert result.answers["y"] == x


def test_parameters_in_plant_and_input():
    a, w = sp.symbols("a omega", positive=True)
    result = respond(system([[-a]], B=[1], C=[[1]], D=[[0]]), u=sp.cos(w * t))
    assert result.status is Status.VERIFIED, result.reason
    expected = (a * sp.cos(w * t) + w * sp.sin(w * t) - a * e(-a * t)) / (a**2 + w**2)
    assert same(result.answers["y"], expected)


def test_the_initial_state_of_the_system_is_taken_unless_the_question_has_one():
    plant = system([[-1]], B=[1], C=[[1]], D=[[0]], x0=[5])
    assert respond(plant, kind="zero_input").answers["y"] == 5 * e(-t)
    assert respond(plant, kind="zero_input", x0=[2]).answers["y"] == 2 * e(-t)
    assert respond(plant, kind="zero_state", u=1).answers["y"] == 1 - e(-t)


def test_the_peak_of_an_underdamped_step_response_is_exact():
    result = respond(CIRCUIT, u=1)
    assert result.answers["y_final"] == 1
    assert sp.simplify(result.answers["t_peak"] - sp.pi / (5 * sp.sqrt(3))) == 0
    assert sp.simplify(result.answers["y_peak"] - 1 - e(-sp.pi / sp.sqrt(3))) == 0


def under_damped(offset=0):
    m, sigma, omega = sp.symbols("m sigma omega", positive=True)
    plant = system([[0, 1], [-(sigma**2) - omega**2, -2 * sigma]], B=[0, 1 / m], C=[[1, 0]], D=[[offset]])
    return plant, m, sigma, omega


@pytest.mark.parametrize(("damping", "seen"), [(4, True), (5, True), (5.2, False), (6.8, False), (8, False)])
def test_what_exceeds_the_limit_by_a_ten_millionth_is_no_peak(damping, seen):
    sigma = sp.Rational(str(damping))
    result = respond(system([[0, 1], [-1 - sigma**2, -2 * sigma]], B=[0, 1], C=[[1, 0]], D=[[0]]), u=1)
    assert result.status is Status.VERIFIED, result.reason
    assert ("y_peak" in result.answers) is seen


def test_the_peak_of_an_underdamped_step_response_with_parameters_is_the_formula_of_the_overshoot():
    plant, m, sigma, omega = under_damped()
    result = respond(plant, u=1, kind="zero_state")
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["t_peak"] == sp.pi / omega
    wanted = (1 + e(-sp.pi * sigma / omega)) / (m * (sigma**2 + omega**2))
    assert sp.simplify(result.answers["y_peak"] - wanted) == 0


def test_no_peak_is_claimed_where_parameters_decide_which_extremum_is_the_largest():
    plant, *_ = under_damped(offset=1)
    assert "y_peak" not in respond(plant, u=1, kind="zero_state").answers
    plant, m, *_ = under_damped()
    assert "y_peak" not in respond(plant, u=1, x0=[m, 0]).answers
    d = sp.Symbol("d", positive=True)
    assert "y_peak" not in respond(system([[0, 1], [-1, -d]], B=[0, 1], C=[[1, 0]], D=[[0]]), u=1).answers


def test_wrong_peaks_with_parameters_are_rejected():
    plant, m, sigma, omega = under_damped()
    options = {"kind": "zero_state", "input": (sp.Integer(1),)}
    assert not rejected("response", plant, {"t_peak": sp.pi / omega}, **options)
    assert rejected("response", plant, {"t_peak": sp.pi / sigma}, **options)
    undershoot = (1 - e(-sp.pi * sigma / omega)) / (m * (sigma**2 + omega**2))
    assert rejected("response", plant, {"y_peak": undershoot}, **options)


def test_denominators_with_parameters_show_their_common_factors():
    plant, *_ = under_damped()
    answers = respond(plant, u=1, kind="zero_state").answers
    assert str(answers["y_final"]) == "1/(m*(omega**2 + sigma**2))"
    assert "m*omega**2" not in str(answers["y"])


def test_what_keeps_a_response_from_a_limit_is_named():
    integrator = system([[0, 1], [0, -2]], B=[0, 1], C=[[1, 0]], D=[[0]])
    last = [step for step in respond(integrator, u=1, kind="zero_state").steps if step.kind == "behaviour"][-1]
    assert last.values["lasting"] == [(0, 2)]
    last = [step for step in respond(LAG, u=sp.sin(2 * t)).steps if step.kind == "behaviour"][-1]
    assert {value for value, _ in last.values["lasting"]} == {2 * sp.I, -2 * sp.I}


def test_the_peak_of_several_modes_is_found_in_decimals():
    result = respond(CIRCUIT, u=e(-2 * t))
    assert result.status is Status.VERIFIED, result.reason
    times = np.linspace(0, 3, 300_001)
    w = 5 * np.sqrt(3)
    y = 25 / 21 * (np.exp(-2 * times) - np.exp(-5 * times) * (np.cos(w * times) + np.sqrt(3) / 5 * np.sin(w * times)))
    assert abs(float(result.answers["y_peak"]) - y.max()) < 1e-9
    assert abs(float(result.answers["t_peak"]) - times[y.argmax()]) < 1e-4


def test_the_time_of_a_peak_is_right_to_all_its_digits():
    answers = respond(CIRCUIT, u=e(-2 * t)).answers
    slope = sp.diff(answers["y"], t)
    with_guard_digits = sp.Float(str(answers["t_peak"]), 60)
    correction = (slope / sp.diff(slope, t)).subs(t, with_guard_digits).evalf(60)
    assert abs(correction) < 1e-28


@pytest.mark.parametrize(
    ("plant", "question"),
    [(SCALE, {"u": 1}), (SCALE, {"x0": [1, 0], "kind": "zero_input"}), (OSCILLATOR, {"u": sp.sin(2 * t)})],
)
def test_no_peak_where_the_size_is_largest_at_the_start_in_the_limit_or_nowhere(plant, question):
    answers = respond(plant, **question).answers
    assert "y_peak" not in answers
    assert "t_peak" not in answers


def test_an_unstable_mode_that_the_output_does_not_see_is_remarked_on():
    plant = system([[1, 0], [0, -1]], B=[0, 1], C=[[0, 1]], D=[[0]])
    result = respond(plant, u=1, x0=[1, 3])
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["y_final"] == 1
    assert result.steps[-1].values["hidden"] == [1]
    step = {"input": (sp.Integer(1),), "initial_state": sp.ImmutableMatrix([1, 3])}
    assert not rejected("response", plant, {"y_final": sp.Integer(1)}, **step)
    assert rejected("response", plant, {"y_final": sp.Integer(3)}, **step)


@pytest.mark.parametrize("A", [[[1, 1], [0, 1]], [[2, 0], [0, -1]]])
def test_what_the_output_sees_directly_has_a_limit_where_no_state_that_it_sees_is_excited(A):
    plant = system(A, B=[1, 0], C=[[0, 1]], D=[[1]])
    result = respond(plant, u=3)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["y_final"] == 3
    assert rejected("response", plant, {"y_final": sp.Integer(2)}, input=(sp.Integer(3),), kind="zero_state")


def test_an_integrator_with_a_fading_input_has_a_limit():
    plant = system([[0, 1], [0, 0]], B=[0, 1], C=[[1, 0]], D=[[0]])
    result = respond(plant, u=e(-t), x0=[1, -1])
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["y_final"] == 0


INPUTS = [sp.Integer(1), t, e(-t), e(t), sp.sin(2 * t), t * e(-t), e(-2 * t) * sp.cos(t), t**2, sp.DiracDelta(t)]


@tried(12)
@given(systems(3), st.sampled_from(INPUTS), st.booleans())
def test_random_systems_agree_with_the_differential_equation_solved_by_scipy(A, u, moving):
    n = A.rows
    plant = system(A, B=[1] + [0] * (n - 1), C=[[0] * (n - 1) + [1]], D=[[1]])
    x0 = [1] * n if moving else None
    results = [respond(plant, method, u=u, x0=x0) for method in METHODS]
    for result in results:
        assert result.status is Status.VERIFIED, result.reason
    assert results[0].answers["x"] == results[1].answers["x"]
    start = np.array(x0 or [0] * n, dtype=float)
    impulse = u == sp.DiracDelta(t)
    start[0] += impulse
    force = sp.lambdify(t, 0 if impulse else u)
    matrix, column = np.array(A, dtype=float), np.eye(n)[0]
    solved = solve_ivp(
        lambda time, x: matrix @ x + column * force(time), (0, 0.8), start, rtol=1e-10, atol=1e-12, method="DOP853"
    )
    found = np.array(results[0].answers["x"].subs(t, sp.Rational(4, 5)).evalf(30).tolist(), dtype=float)[:, 0]
    assert np.abs(found - solved.y[:, -1]).max() <= 1e-7 * max(1.0, np.abs(found).max())


SEQUENCES = [sp.Integer(1), k, half**k, k * half**k, sp.DiracDelta(k), step(k - 2), sp.cos(sp.pi * k / 2), (-1) ** k]


@tried(8)
@given(systems(3), st.sampled_from(SEQUENCES), st.booleans())
def test_random_discrete_systems_follow_the_recursion(A, u, moving):
    n = A.rows
    plant = system(A, B=[1] + [0] * (n - 1), C=[[0] * (n - 1) + [1]], D=[[1]], discrete=True)
    x0 = [1] * n if moving else None
    results = [respond(plant, method, u=u, x0=x0) for method in ("z_transform", "convolution")]
    for result in results:
        assert result.status is Status.VERIFIED, result.reason
    x = sp.Matrix(x0 or [0] * n)
    for i in range(7):
        value = {
            sp.DiracDelta(k): int(i == 0),
            step(k - 2): int(i >= 2),
        }.get(u, u.subs(k, i))
        found = results[0].answers["x"].subs(k, i)
        assert np.abs(np.array((found - x).evalf(30).tolist(), dtype=float)).max() <= 1e-9 * max(
            1, abs(max(x, key=abs))
        )
        x = plant.A * x + plant.B * value


def begun(f, delay):
    """f(k − n) step(k − n)."""
    return f.subs(k, k - delay) * sp.Heaviside(k - delay, 1)


@pytest.mark.parametrize("method", ["z_transform", "convolution"])
def test_a_sequence_that_comes_later_is_the_shifted_response(method):
    plant = system([[half]], B=[1], C=[[1]], D=[[0]], discrete=True)
    result = ask("response", plant, method, kind="zero_state", input=(step(k - 10),))
    assert result.status is Status.VERIFIED, result.reason
    y = 2 - 2 * half**k
    assert sp.expand(result.answers["y"] - begun(y, 10)) == 0
    assert result.answers["y_final"] == 2
    result = ask("response", plant, method, kind="zero_state", input=(3 * step(k) - 2 * step(k - 4),))
    assert sp.expand(result.answers["y"] - 3 * y + 2 * begun(y, 4)) == 0


@pytest.mark.parametrize("method", ["z_transform", "convolution"])
def test_what_begins_at_different_samples_is_added_up(method):
    """A pulse stays a pulse, pulses in a row are one piece, and what D passes on is added."""
    plant = system([[half, 1], [0, half / 2]], B=[0, 1], C=[[1, 0]], D=[[1]], discrete=True)
    u = step(k) - step(5 - k) + sp.DiracDelta(k - 2) + 4 * sp.DiracDelta(k - 3)
    result = ask("response", plant, method, kind="complete", initial_state=sp.ImmutableMatrix([1, 2]), input=(u,))
    assert result.status is Status.VERIFIED, result.reason
    x = sp.Matrix([1, 2])
    for i in range(12):
        now = int(i >= 0) - int(i <= 5) + int(i == 2) + 4 * int(i == 3)
        assert result.answers["y"].subs(k, i) == x[0] + now
        x = plant.A * x + plant.B * now


def test_a_later_peak_in_discrete_time():
    plant = system([[0, 1], [-half, 1]], B=[0, 1], C=[[1, 0]], discrete=True)
    answers = ask("response", plant, kind="zero_state", input=(step(k - 5),)).answers
    assert (answers["t_peak"], answers["y_peak"]) == (9, sp.Rational(5, 2))


def test_the_peak_in_discrete_time_is_a_sample():
    plant = system([[0, 1], [-half, 1]], B=[0, 1], C=[[1, 0]], D=[[0]], discrete=True)
    answers = respond(plant, u=1).answers
    assert (answers["t_peak"], answers["y_peak"], answers["y_final"]) == (4, sp.Rational(5, 2), 2)


@pytest.mark.parametrize(
    ("u", "says"), [(sp.tan(t), "not rational"), (1 / (t + 1), "not rational"), (sp.log(t), "not")]
)
def test_inputs_without_a_rational_transform_are_refused_by_name(u, says):
    result = respond(LAG, u=u)
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)


@pytest.mark.parametrize(
    ("plant", "options", "says"),
    [
        (LAG, {"kind": "zero_input"}, "initial state"),
        (LAG, {"kind": "complete"}, "needs an input"),
        (LAG, {"kind": "complete", "input": (t, t)}, "1 input"),
        (system([[-1]]), {"kind": "zero_state", "input": (t,)}, "matrix B"),
    ],
)
def test_what_the_question_lacks_is_said_from_the_file(plant, options, says):
    messages = [str(message) for _, message in catalogue()["response"].refused(plant, options)]
    assert any(says in message for message in messages), messages


CORRUPTIONS = {
    "sign": lambda x: -x,
    "factor": lambda x: x * sp.Rational(1001, 1000),
    "time": lambda x: x.subs(t, 2 * t),
    "constant": lambda x: x + sp.ones(*x.shape) / 1000 if isinstance(x, sp.MatrixBase) else x + sp.Rational(1, 1000),
    "small mode": lambda x: (
        x + sp.ones(*x.shape) * t * e(-9 * t) if isinstance(x, sp.MatrixBase) else x + t * e(-9 * t)
    ),
}


ANSWERED = [(CIRCUIT, e(-2 * t)), (OSCILLATOR, sp.sin(2 * t)), (LAG, step(t) - step(t - 2)), (LAG, sp.DiracDelta(t))]


@cache
def right_answers(plant, u):
    return ask("response", plant, kind="complete", input=(u,)).answers


@pytest.mark.parametrize("answer", ["x", "y"])
@pytest.mark.parametrize(("plant", "u"), ANSWERED)
def test_a_right_response_is_accepted_by_itself(plant, u, answer):
    assert not rejected("response", plant, {answer: right_answers(plant, u)[answer]}, kind="complete", input=(u,))


@pytest.mark.parametrize("name", CORRUPTIONS)
@pytest.mark.parametrize("answer", ["x", "y"])
@pytest.mark.parametrize(("plant", "u"), ANSWERED)
def test_corrupted_responses_are_rejected_each_for_itself(plant, u, answer, name):
    corrupted = CORRUPTIONS[name](right_answers(plant, u)[answer])
    assert rejected("response", plant, {answer: corrupted}, kind="complete", input=(u,))


@pytest.mark.parametrize("answer", ["y_final", "y_peak", "t_peak"])
def test_corrupted_limits_and_peaks_are_rejected_each_for_itself(answer):
    options = {"kind": "complete", "input": (sp.Integer(1),)}
    right = ask("response", CIRCUIT, **options).answers[answer]
    assert not rejected("response", CIRCUIT, {answer: right}, **options)
    for wrong in (right + sp.Rational(1, 1000), -right, right * 2):
        assert rejected("response", CIRCUIT, {answer: wrong}, **options)


def test_an_impulse_left_out_of_the_output_is_found():
    plant = system([[-1]], B=[1], C=[[1]], D=[[2]])
    options = {"kind": "complete", "input": (sp.DiracDelta(t),)}
    assert rejected("response", plant, {"y": e(-t)}, **options)
    assert rejected("response", plant, {"y": e(-t) + sp.DiracDelta(t)}, **options)
    assert not rejected("response", plant, {"y": e(-t) + 2 * sp.DiracDelta(t)}, **options)


def test_other_forms_of_a_right_answer_are_accepted():
    options = {"kind": "complete", "input": (sp.Integer(1),)}
    for y in (1 - e(-t), 2 * e(-t / 2) * sp.sinh(t / 2), (e(t) - 1) / e(t)):
        assert not rejected("response", LAG, {"y": y}, **options)
    assert not rejected("response", LAG, {"x": sp.ImmutableMatrix([1 - e(-t)])}, **options)


def test_corrupted_discrete_responses_are_rejected():
    plant = system([[half]], B=[1], C=[[1]], D=[[1]], discrete=True)
    options = {"kind": "complete", "input": (half**k,)}
    y = ask("response", plant, **options).answers["y"]
    for wrong in (y + sp.KroneckerDelta(k, 3), -y, y.subs(k, k + 1), y - half**k):
        assert rejected("response", plant, {"y": wrong}, **options)


@pytest.mark.parametrize("method", METHODS)
def test_the_steps_are_those_of_the_method(method):
    kinds = [each.kind for each in respond(SCALE, method, u=sp.sin(2 * t), x0=[1, 0]).steps]
    if method == "laplace":
        wanted = [
            "zero_input_transform",
            "transformed_back",
            "input_transform",
            "zero_state_transform",
            "sum",
            "output",
        ]
    else:
        wanted = ["convolution_formula", "transition", "free_motion", "convolution", "sum", "output"]
    assert [kind for kind in kinds if kind in wanted] == (
        wanted if method == "convolution" else [*wanted[:4], "transformed_back", *wanted[4:]]
    )


@pytest.mark.parametrize("plant", [SCALE, CIRCUIT, OSCILLATOR, LAG])
@pytest.mark.parametrize("method", METHODS)
def test_every_claim_and_check_passes(plant, method):
    result = respond(plant, method, u=1 + t * e(-t))
    assert {check.status for check in result.checks} <= {CheckStatus.PASSED, CheckStatus.SKIPPED}
    assert sum(check.status is CheckStatus.PASSED for check in result.checks) > 8


def test_a_quadratic_denominator_is_completed_to_the_squares_of_the_table():
    steps = {each.kind: each for each in respond(CIRCUIT, "laplace", x0=[1, 0], kind="zero_input").steps}
    (square,) = steps["completed_squares"].claims.values()
    s = sp.Symbol("s")
    assert square.left == s**2 + 10 * s + 100
    assert [each[1:] for each in steps["completed_squares"].values["quadratics"]] == [(-5, 5 * sp.sqrt(3))]
    assert steps["partial_fractions"].values["alone"]
    assert "completed_squares" not in [each.kind for each in respond(SCALE, "laplace", x0=[1, 0]).steps]
    assert "completed_squares" not in [each.kind for each in respond(OSCILLATOR, "laplace", x0=[1, 0]).steps]
