"""Scaling for an analog computer: the note's examples, maxima by scipy, corruptions, marking, what is refused."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from solver.derivation import CheckStatus, Status
from solver.engine import given_of, solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.marked import verdict

NOTE = "{equations: [\"x'' + 8x' + 25x = 500\"], initial: {x: 40, \"x'\": 150}}"
MAXIMA = 'maximum: {x: 50, "x\'": 250}'
PLANT = "{A: [[0, 1], [-2, -3]], initial_state: [1, 0]}"


def text_of(system, options="", more=""):
    options = f", {options}" if options else ""
    return f"system: {system}\n{more}\nfind: {{a: {{task: amplitude_scaling{options}}}}}\n"


def read(system, options="", more=""):
    return read_problem(Source("file.yaml", text_of(system, options, more)), catalogue())


def solved(system, options="", more=""):
    return solve_problem(read(system, options, more)).parts[0]


def named(mapping):
    return {str(name): value for name, value in mapping.items()}


def accepted(system, options="", more="", **answers):
    asked = given_of(read(system, options, more).parts[0], "amplitude_scaling", {})
    checks = list(catalogue()["amplitude_scaling"].verify(asked, answers))
    return bool(checks) and all(check.status is CheckStatus.PASSED for check in checks)


def simulated(A, b, x0, end=90.0):
    """The largest sizes by a Runge–Kutta method on a fine grid."""
    A, b = np.array(A, dtype=float), np.array(b, dtype=float)
    times = np.linspace(0, end, 9001)
    found = solve_ivp(lambda _, x: A @ x + b, (0, end), x0, t_eval=times, method="DOP853", rtol=1e-8, atol=1e-10)
    return np.max(np.abs(found.y), axis=1)


def test_example_5_of_the_note_as_its_figure_has_it():
    result = solved(NOTE, MAXIMA)
    assert result.status is Status.VERIFIED
    assert named(result.answers["scale_factors"]) == {"x": sp.Rational(1, 5), "x_dot": sp.Rational(1, 25)}
    X1, X2 = sp.symbols("X1 X2", real=True)
    assert named(result.answers["scaled_equations"]) == {"X1_dot": 5 * X2, "X2_dot": -5 * X1 - 8 * X2 + 20}
    assert [step.kind for step in result.steps] == [
        "highest", "states", "machine", "given", "factors", "substitution", "row", "row", "used",
    ]  # fmt: skip
    substitution = next(step for step in result.steps if step.kind == "substitution")
    assert [row[-1] for row in substitution.values["rows"]] == [8, 6]


def test_time_scaling_divides_by_beta_and_leaves_initial_values():
    result = solved(NOTE, f"{MAXIMA}, time_scale: 10")
    X1, X2 = sp.symbols("X1 X2", real=True)
    half = sp.Rational(1, 2)
    assert named(result.answers["scaled_equations"]) == {
        "X1_dot": half * X2, "X2_dot": -half * X1 - sp.Rational(4, 5) * X2 + 2,
    }  # fmt: skip
    substitution = next(step for step in result.steps if step.kind == "substitution")
    assert [row[-1] for row in substitution.values["rows"]] == [8, 6]


def test_a_state_space_uses_the_full_range():
    result = solved(PLANT)
    assert result.status is Status.VERIFIED
    assert named(result.answers["maximum"]) == {"x1": 1, "x2": sp.Rational(1, 2)}
    X1, X2 = sp.symbols("X1 X2", real=True)
    assert named(result.answers["scaled_equations"]) == {"X1_dot": X2 / 2, "X2_dot": -4 * X1 - 3 * X2}
    kinds = [step.values["largest"].kind for step in result.steps if step.kind == "maximum"]
    assert kinds == ["start", "peak"]
    assert next(s for s in result.steps if s.kind == "maximum" and s.values["largest"].kind == "peak").values[
        "largest"
    ].time == sp.log(2)


def test_the_speed_of_the_notes_second_order_equation_has_18_volts_per_unit():
    result = solved("{equations: [\"x'' + x' + x = 0\"], initial: {x: 1}}")
    assert result.answers["maximum"][sp.Symbol("x_dot", real=True)] == sp.exp(-sp.sqrt(3) * sp.pi / 9)
    factor = named(result.answers["scale_factors"])["x_dot"]
    assert abs(float(factor) - 18.305) < 1e-3


@pytest.mark.parametrize(
    ("system", "options", "kinds"),
    [
        ('{equations: ["x\' + 2x = 6"]}', "", ["limit"]),
        ('{equations: ["x\'\' + x = 0"], initial: {x: 1, "x\'": 2}}', "", ["peak", "peak"]),
        ("{equations: [\"x'' + x' + x = u\"], inputs: [u]}", "input: {u: sin(t)}", ["peak", "peak"]),
        ('{equations: ["x\' + 40x = u"], inputs: [u]}', "input: {u: 2cos(t)}", ["swing"]),
        ('{equations: ["x\' + x = u"], inputs: [u]}', "input: {u: step(t) - step(t - 1)}", ["corner"]),
        ("{equations: [\"x'' + 8x' + 25x = 500\"], initial: {x: 20}}", "", ["start", "zero"]),
        ("{equations: [\"x''' + x'' + 2x' + x = 0\"], initial: {x: 1}}", "", ["start", "peak", "peak"]),
        ("{equations: [\"x'' + x' = 0\"], initial: {\"x'\": 1}}", "", ["limit", "start"]),
        ("{equations: [\"y'' + 2y' + 4y = u' + 3u\"], inputs: [u]}", "input: {u: 2}", ["peak", "peak"]),
        ("{transfer_function: 2/(s^2 + 2s + 1)}", "input: {u: 3}", ["limit", "peak"]),
    ],
)
def test_where_the_largest_size_is(system, options, kinds):
    result = solved(system, options)
    assert result.status is Status.VERIFIED
    assert [step.values["largest"].kind for step in result.steps if step.kind == "maximum"] == kinds


def test_the_swing_of_a_driven_lag_is_its_amplitude():
    result = solved('{equations: ["x\' + 40x = u"], inputs: [u]}', "input: {u: 2cos(t)}")
    assert result.answers["maximum"] == {sp.Symbol("x", real=True): 2 * sp.sqrt(1601) / 1601}


@settings(max_examples=5, deadline=None)
@given(
    a=st.integers(1, 6), b=st.integers(1, 9), c=st.integers(-8, 8),
    start=st.tuples(st.integers(-5, 5), st.integers(-9, 9)).filter(any),
)  # fmt: skip
def test_maxima_are_those_of_a_simulation(a, b, c, start):
    system = f"{{equations: [\"x'' + {a}x' + {b}x = {c}\"], initial: {{x: {start[0]}, \"x'\": {start[1]}}}}}"
    result = solved(system)
    assert result.status is Status.VERIFIED
    found = [float(value) for value in result.answers["maximum"].values()]
    wanted = simulated([[0, 1], [-b, -a]], [0, c], start)
    assert np.allclose(found, wanted, rtol=1e-3, atol=1e-6)


def test_symbols_are_scaled_where_the_maxima_are_given():
    system = "{equations: [\"m x'' + d x' + k x = u\"], inputs: [u]}"
    result = solved(system, 'maximum: {x: a, "x\'": b}, time_scale: beta')
    assert result.status is Status.VERIFIED
    m, d, k, u, a, b, beta, X1, X2 = sp.symbols("m d k u a b beta X1 X2", real=True)
    found = named(result.answers["scaled_equations"])
    plain = {s: sp.Symbol(s.name, real=True) for value in found.values() for s in value.free_symbols}
    assert sp.expand(found["X1_dot"].xreplace(plain) - b * X2 / (a * beta)) == 0
    wanted = (10 * u / b - k * a * X1 / b - d * X2) / (m * beta)
    assert sp.expand(found["X2_dot"].xreplace(plain) - wanted) == 0


def test_a_relation_without_derivatives_is_scaled_without_time():
    result = solved("{equations: [y = 100 x], inputs: [x]}", "maximum: {x: 5, y: 500}, time_scale: 7")
    assert named(result.answers["scale_factors"]) == {"x": 2, "y": sp.Rational(1, 50)}
    assert named(result.answers["scaled_equations"]) == {"Y": sp.Symbol("X", real=True)}


@pytest.mark.parametrize(("system", "options"), [(NOTE, f"{MAXIMA}, time_scale: 10"), (PLANT, ""), (NOTE, "")])
def test_corrupted_answers_are_rejected(system, options):
    answers = dict(solved(system, options).answers)
    for name, mapping in answers.items():
        assert accepted(system, options, **{name: mapping})
        for key, value in mapping.items():
            for wrong in (value * sp.Rational(1001, 1000), -value, value + 1):
                if wrong != value:
                    assert not accepted(system, options, **{name: {**mapping, key: wrong}}), (name, key)
        assert not accepted(system, options, **{name: dict(list(mapping.items())[1:])})


@pytest.mark.parametrize(
    ("answer", "written", "slip"),
    [
        ("scale_factors", "{x: 5, x_dot: 25}", "upside down"),
        ("scale_factors", "{x: 1/50, x_dot: 1/250}", "reference voltage is forgotten"),
        ("scaled_equations", "{X1_dot: 50 X2, X2_dot: 200 - 50 X1 - 80 X2}", "multiplied by β"),
        ("scaled_equations", "{X1_dot: 5 X2, X2_dot: 20 - 5 X1 - 8 X2}", "time scale is forgotten"),
        ("scaled_equations", "{X1_dot: X2/50, X2_dot: 1250 - 12.5 X1 - 0.8 X2}", "levels are exchanged"),
        ("scaled_equations", "{X1_dot: X2/10, X2_dot: 50 - 2.5 X1 - 0.8 X2}", "only renamed"),
    ],
)
def test_usual_mistakes_are_named(answer, written, slip):
    found = verdict(text_of(NOTE, f"{MAXIMA}, time_scale: 10"), "a", answer, written)
    assert found.verdict.name == "WRONG"
    assert slip in str(found)


@pytest.mark.parametrize(
    ("answer", "written"),
    [
        ("scale_factors", '{x: 0.2, "x\'": 0.04}'),
        ("scaled_equations", "{X1_dot: 0.5 X2, X2_dot: 2 - 0.5 X1 - 0.8 X2}"),
        ("scaled_equations", "{X1_dot: X2/2, X2_dot: -(X1/2 + 4 X2/5) + 2}"),
    ],
)
def test_right_answers_of_students_are_right(answer, written):
    assert verdict(text_of(NOTE, f"{MAXIMA}, time_scale: 10"), "a", answer, written).verdict.name == "CORRECT"


def test_found_maxima_are_judged_to_the_digits_written():
    assert verdict(text_of(NOTE), "a", "maximum", "{x: 48.33, x_dot: 150}").verdict.name == "CORRECT"
    assert verdict(text_of(NOTE), "a", "maximum", "{x: 48.34, x_dot: 150}").verdict.name == "WRONG"
    rounded_up = verdict(text_of(NOTE), "a", "maximum", "{x: 50, x_dot: 150}")
    assert rounded_up.verdict.name == "WRONG"
    assert "nothing overloads" in str(rounded_up)


@pytest.mark.parametrize(
    ("system", "options", "says"),
    [
        (NOTE, 'maximum: {x: 30, "x\'": 250}', "begins at 40, beyond its maximum 30"),
        (NOTE, "maximum: {x: -50}", "must be positive"),
        (NOTE, "maximum: {z: 5}", "neither an unknown nor an input"),
        (NOTE, "maximum: {\"x''\": 5}", "x'' is no variable of the machine; there are x, x'"),
        (NOTE, "reference: 0", "reference voltage must be positive"),
        (NOTE, "time_scale: -1", "β of the machine time must be positive"),
        (NOTE, "initial: {\"x''\": 5}", "x'' is no state"),
        ('{equations: ["x\' + x = u"], inputs: [u]}', "", "largest size of x depends on the input u"),
        ('{equations: ["x\' + x = u"], inputs: [u]}', "input: {u: delta(t)}", "has an impulse"),
        ("{A: [[0, 1], [-2, -3]], B: [0, 1]}", "input: {v: 1}", "v is no input; the input is u"),
        ("{equations: [y = 2 x + w], inputs: [x]}", "input: {x: 1}", "without derivatives no largest size is found"),
    ],
)
def test_what_does_not_fit_is_told_at_its_place(system, options, says):
    with pytest.raises(InputError) as told:
        solved(system, options)
    assert says in str(told.value)


@pytest.mark.parametrize(
    ("system", "options", "says"),
    [
        ('{equations: ["x\' = x"], initial: {x: 1}}', "", "grows without bound"),
        ("{equations: [\"x'' + x = u\"], inputs: [u]}", "input: {u: sin(t)}", "grows without bound"),
        ('{equations: ["x\' + a x = 0"], initial: {x: 1}}', "", "With symbols in the equations"),
        ('{equations: ["x\' + x y = 0", "y\' + x = 0"], initial: {x: 1}}', "", "multiplier"),
        ('{equations: ["x\' + sin(x) = 0"], initial: {x: 1}}', "", "function generator"),
        ('{equations: ["x\' + 1/x = 0"], initial: {x: 1}}', "", "divider"),
        ("{equations: [a = b + u, b = a - u], inputs: [u]}", "maximum: {a: 1, b: 1, u: 1}", "algebraic loop"),
        ("{equations: [\"x'' + 2x = u\"], inputs: [u]}", "input: {u: sin(t)}", "oscillates so long"),
    ],
)
def test_what_has_no_answer_says_why(system, options, says):
    result = solved(system, options)
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)


def test_a_maximum_that_is_too_small_is_told():
    result = solved(NOTE, 'maximum: {x: 45, "x\'": 250}')
    used = next(step for step in result.steps if step.kind == "used")
    (x, *_), _ = used.values["rows"]
    assert str(x) == "x"
    assert used.values["beyond"]
