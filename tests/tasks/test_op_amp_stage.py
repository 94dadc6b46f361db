"""Stages of operational amplifiers: textbook formulas, random cascades against nodal analysis, marking, bad files."""

from __future__ import annotations

import json

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Answers, CheckStatus, Status
from solver.engine import given_of, refusals_of, solve_problem
from solver.messages import Messages
from solver.numeric.judges import analog as judges
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.marked import verdict

s, t = sp.symbols("s t")
R1, R2, C1, C2, Rf, Cf, a, b, c = sp.symbols("R1 R2 C1 C2 R_f C_f a b c", real=True)
v1, v2 = sp.symbols("v1 v2", real=True)
V1, V2 = sp.symbols("V1 V2")
TAU = sp.Symbol("tau")


def text_of(stages, option=""):
    return f"system: {{op_amp: {json.dumps(stages)}}}\nfind: {{a: {{task: op_amp_stage{option}}}}}\n"


def read(stages, option=""):
    return read_problem(Source("file.yaml", text_of(stages, option)), catalogue())


def solved(stages, option=""):
    return solve_problem(read(stages, option)).parts[0]


def accepted(stages, option="", **answers):
    """Whether the verification passes the answers."""
    task, part = catalogue()["op_amp_stage"], read(stages, option).parts[0]
    checks = list(task.verify(given_of(part, part.methods[0], {}), Answers(**answers)))
    return bool(checks) and all(check.status is CheckStatus.PASSED for check in checks)


def integral(name, *limits):
    return sp.Integral(sp.Function(name)(TAU), *(limits or [(TAU, 0, t)]))


def derivative(name, order=1):
    return sp.Derivative(sp.Function(name)(t), (t, order))


SUMMER = {"inputs": {"v1": "R1", "v2": "R2"}, "feedback": "R_f"}
INTEGRATOR = {"inputs": {"v1": "R1", "v2": "R2"}, "feedback": "C_f", "initial_output": "a"}
DIFFERENTIATOR = {"inputs": {"v1": "C1", "v2": "C2"}, "feedback": "R_f"}
MIXED = {"inputs": {"v1": "R1", "v2": "C2"}, "feedback": "C_f", "initial_output": "a"}
TWICE = [
    {"inputs": {"v1": "R1"}, "feedback": "C1", "initial_output": "a"},
    {"inputs": {"v_o1": "R2"}, "feedback": "C2", "initial_output": "b"},
]
LINES = [
    (SUMMER, -Rf / R1 * v1 - Rf / R2 * v2, -Rf / R1 * V1 - Rf / R2 * V2),
    (
        INTEGRATOR,
        a - integral("v1") / (R1 * Cf) - integral("v2") / (R2 * Cf),
        a / s - V1 / (s * R1 * Cf) - V2 / (s * R2 * Cf),
    ),
    (
        DIFFERENTIATOR,
        -Rf * C1 * derivative("v1") - Rf * C2 * derivative("v2"),
        -Rf * C1 * s * V1 - Rf * C2 * s * V2,
    ),
    (MIXED, a - integral("v1") / (R1 * Cf) - C2 / Cf * v2, a / s - V1 / (s * R1 * Cf) - C2 / Cf * V2),
    (
        TWICE,
        b
        - a * t / (R2 * C2)
        + integral("v1", (TAU, 0, sp.Symbol("tau_1")), (sp.Symbol("tau_1"), 0, t)) / (R1 * C1 * R2 * C2),
        b / s - a / (s**2 * R2 * C2) + V1 / (s**2 * R1 * C1 * R2 * C2),
    ),
]


@pytest.mark.parametrize(("stages", "in_time", "transformed"), LINES)
def test_the_textbook_has_the_same(stages, in_time, transformed):
    result = solved(stages)
    assert result.status is Status.VERIFIED
    assert sp.expand(result.answers["v_o"] - in_time) == 0
    assert sp.expand(result.answers["V_o"] - transformed) == 0


def test_the_steps_are_those_of_a_lecture():
    kinds = [step.kind for step in solved(INTEGRATOR).steps]
    assert kinds == ["virtual_ground", "currents", "balance", "integrated", "solved", "transformed"]
    numbers = {"inputs": {"v1": {"R": 5000}}, "feedback": {"C": 1e-6}}
    assert [step.kind for step in solved(numbers).steps][-3:] == ["numbers", "solved", "transformed"]
    kinds = [step.kind for step in solved(TWICE).steps]
    assert kinds[-4:] == ["transformed", "transformed", "cascade", "output"]


def test_numbers_with_units_make_a_factor_in_seconds():
    result = solved({"inputs": {"v1": {"R": 5000}}, "feedback": {"C": 1e-6}})
    assert result.answers["v_o"] == -200 * integral("v1")
    step = next(step for step in result.steps if step.kind == "numbers")
    assert step.values["units"] == ["per_second"]
    result = solved({"inputs": {"v1": {"C": 2e-6}, "v2": {"R": 500}}, "feedback": {"R": 1000}})
    assert result.answers["v_o"] == -derivative("v1") / 500 - 2 * v2
    step = next(step for step in result.steps if step.kind == "numbers")
    assert step.values["units"] == ["second", ""]


@pytest.mark.parametrize(
    ("stages", "v_o", "V_o"),
    [
        (SUMMER, [Rf / R1 * v1 + Rf / R2 * v2, -R1 / Rf * v1 - R2 / Rf * v2, -Rf / R2 * v1 - Rf / R1 * v2, -v1 - v2],
         [Rf / R1 * V1 + Rf / R2 * V2, -Rf / R1 * V1, s * (-Rf / R1 * V1 - Rf / R2 * V2)]),
        (INTEGRATOR, [-a - integral("v1") / (R1 * Cf) - integral("v2") / (R2 * Cf), -integral("v1") - integral("v2"),
                      -integral("v1") / (R1 * Cf) - integral("v2") / (R2 * Cf),
                      a + integral("v1") / (R1 * Cf) + integral("v2") / (R2 * Cf),
                      a - v1 / (R1 * Cf) - v2 / (R2 * Cf)],
         [a - V1 / (s * R1 * Cf) - V2 / (s * R2 * Cf), a / s - V1 / (R1 * Cf) - V2 / (R2 * Cf)]),
        (DIFFERENTIATOR, [-Rf * C1 * v1 - Rf * C2 * v2, -Rf * C1 * derivative("v1"), -Rf * C1 * integral("v1")],
         [-Rf * C1 * V1 - Rf * C2 * V2]),
        (TWICE, [b + a * t / (R2 * C2) + integral("v1") / (R1 * C1 * R2 * C2), b - a * t / (R2 * C2)],
         [b / s - a / (s * R2 * C2) + V1 / (s**2 * R1 * C1 * R2 * C2)]),
    ],
)  # fmt: skip
def test_what_is_wrong_is_rejected(stages, v_o, V_o):
    for value in v_o:
        assert not accepted(stages, v_o=value), value
    for value in V_o:
        assert not accepted(stages, V_o=value), value


def test_small_values_are_judged_by_their_size():
    tiny = {"inputs": {"v1": {"R": 1e9}}, "feedback": {"R": "1e-3"}}
    gain = sp.Rational(1, 10**12)
    assert accepted(tiny, v_o=-gain * v1, V_o=-gain * V1)
    assert not accepted(tiny, v_o=gain * v1)
    assert not accepted(tiny, V_o=-2 * gain * V1)


def test_other_forms_of_the_same_are_accepted():
    tau_1 = sp.Symbol("tau_1")
    kernel = sp.Integral((t - TAU) * sp.Function("v1")(TAU), (TAU, 0, t)) / (R1 * C1 * R2 * C2)
    nested = sp.Integral(sp.Integral(sp.Function("v1")(TAU), (TAU, 0, tau_1)), (tau_1, 0, t)) / (R1 * C1 * R2 * C2)
    for found in (kernel, nested):
        assert accepted(TWICE, v_o=b - a * t / (R2 * C2) + found)
    since = sp.Function("v2")(t) - sp.Function("v2")(0)  # the signal is zero before
    assert accepted(MIXED, v_o=a - integral("v1") / (R1 * Cf) - C2 / Cf * since)


LETTERS = st.sampled_from("RC")


@st.composite
def cascades(draw):
    """Up to three stages of numbers; a capacitor meets no jump, for no initial output comes before it."""
    stages, name = [], "v1"
    for i in range(draw(st.integers(1, 3))):
        own = {name: {draw(LETTERS): draw(st.integers(1, 9))}}
        if draw(st.booleans()):
            own[draw(st.sampled_from(["v1", f"w{i}"]))] = {draw(LETTERS): draw(st.integers(1, 9))}
        stages.append({"inputs": own, "feedback": {draw(LETTERS): draw(st.integers(1, 9))}})
        name = f"x{i}"
    last = stages[-1]
    if "C" in last["feedback"]:
        last["initial_output"] = draw(st.integers(-5, 5))
    return stages


def nodal(stages, at):
    """The output by the inputs from the nodal equations of the whole, without the virtual ground: a large gain."""
    gain, names = 1e13, [f"x{i}" for i in range(len(stages))]
    inputs = list(dict.fromkeys(n for each in stages for n in each["inputs"] if n not in names))
    size = 2 * len(stages)
    M, N = np.zeros((size, size), complex), np.zeros((size, len(inputs)), complex)
    for i, stage in enumerate(stages):
        joined = [*stage["inputs"].items(), (names[i], stage["feedback"])]
        for name, part in joined:
            ((letter, value),) = part.items()
            Y = 1 / value if letter == "R" else at * value
            M[i, i] += Y
            if name in names:
                M[i, len(stages) + names.index(name)] -= Y
            else:
                N[i, inputs.index(name)] += Y
        M[len(stages) + i, [i, len(stages) + i]] = gain, 1
    return inputs, np.linalg.solve(M, N)[-1]


@settings(max_examples=6, deadline=None)
@given(cascades())
def test_random_cascades_are_those_of_nodal_analysis(stages):
    result = solved(stages)
    assert result.status is Status.VERIFIED
    at = 0.7 + 0.9j
    inputs, wanted = nodal(stages, at)
    for name, value in zip(inputs, wanted, strict=True):
        found = complex(result.answers["V_o"].coeff(sp.Symbol(name.capitalize())).subs(s, at).evalf())
        assert abs(found - value) < 1e-6 * max(1, abs(value))
    assert not accepted(stages, v_o=-result.answers["v_o"] + 1)


def test_an_initial_output_may_stand_beside_the_system_and_in_the_question():
    stage = {"inputs": {"v1": "R1"}, "feedback": "C_f"}
    inside = solved({**stage, "initial_output": 3}).answers
    beside = f"system: {{op_amp: {json.dumps(stage)}, initial_output: 3}}\nfind: {{a: op_amp_stage}}\n"
    assert solve_problem(read_problem(Source("f", beside), catalogue())).parts[0].answers == inside
    assert solved(stage, ", initial_output: 3").answers == inside


def test_a_jump_before_a_capacitor_is_an_impulse():
    ramp = [
        {"inputs": {"v1": "R1"}, "feedback": "C1", "initial_output": 2},
        {"inputs": {"v_o1": "R2"}, "feedback": "C2"},
        {"inputs": {"v_o2": "C2"}, "feedback": "R2"},
    ]
    assert solved(ramp).status is Status.VERIFIED
    again = [*ramp, {"inputs": {"v_o3": "C1"}, "feedback": "R1"}]
    result = solved(again)
    assert result.status is Status.UNSOLVED
    assert result.reason.kind == "op_amp_stage/impulse"


def test_a_capacitor_behind_an_integrator_is_charged_to_its_initial_output():
    stages = [
        {"inputs": {"v1": "R1"}, "feedback": "C1", "initial_output": "a"},
        {"inputs": {"v_o1": "C2"}, "feedback": "R_f"},
    ]
    result = solved(stages)
    assert result.status is Status.VERIFIED
    assert sp.expand(result.answers["v_o"] - Rf * C2 / (R1 * C1) * v1) == 0
    assert sp.expand(result.answers["V_o"] - Rf * C2 / (R1 * C1) * V1) == 0


def test_other_tasks_take_the_stages_as_a_circuit():
    text = text_of([{"inputs": {"v1": "R1"}, "feedback": "C1"}, {"inputs": {"v2": "R2"}, "feedback": "R_f"}])
    for task, name, value in (
        ("transfer_function", "G", Rf / (R1 * C1 * R2 * s)),
        ("state_space_model", "A", sp.ImmutableMatrix([[0]])),
    ):
        found = solve_problem(read_problem(Source("f", text.replace("op_amp_stage", task)), catalogue())).parts[0]
        assert found.status is Status.VERIFIED
        assert found.answers[name] == value or sp.cancel(found.answers[name] - value) == 0
    held = text_of(INTEGRATOR).replace("{task: op_amp_stage}", "state_space_model")
    assert solve_problem(read_problem(Source("f", held), catalogue())).parts[0].status is Status.VERIFIED


@pytest.mark.parametrize(
    ("stages", "underlined", "says", "suggestion"),
    [
        ({"inputs": {"v1": "r1"}, "feedback": "R"}, '"r1"', "an element is a resistor or a capacitor", "R1"),
        ({"inputs": {"v1": "L1"}, "feedback": "R"}, '"L1"', "an element is a resistor or a capacitor", ""),
        ({"inputs": {"v1": "R1"}, "feedback": 5000}, "5000", "a number does not say what it is", ""),
        ({"inputs": {"v1": {"R": "5k"}}, "feedback": "R"}, '"5k"', "numbers in ohms and farads", ""),
        ({"inputs": {"v1": {"R": 0}}, "feedback": "R"}, "0", "a resistance is positive", ""),
        ({"inputs": {"v1": {"R": 1, "C": 2}}, "feedback": "R"}, '{"R": 1, "C": 2}', "one value is expected", ""),
        ({"inputs": {"V1": "R1"}, "feedback": "R"}, '"V1"', "the capital letter is that of the transform", "v1"),
        ({"inputs": {"v_o": "R1"}, "feedback": "R"}, '"v_o"', "v_o is the output", ""),
        ({"inputs": {"t": "R1"}, "feedback": "R"}, '"t"', "it is a variable", ""),
        ({"inputs": {"g": {"R": "2 g"}}, "feedback": "R"}, '"g"', "g is an input and a value", ""),
        ({"inputs": {"v1": "R1"}, "feedback": "R", "initial_output": 1}, "1", "only a capacitor in the feedback", ""),
        ({"inputs": {"v1": "R1"}, "feedbak": "R"}, '"feedbak"', "unknown key 'feedbak'", "feedback"),
        ({"inputs": {}, "feedback": "R"}, "{}", "a stage needs an input", ""),
        ("R1", '"R1"', "a mapping {inputs: .., feedback: ..}, or a list of such mappings", ""),
    ],
)
def test_what_is_wrong_in_a_file_is_told_at_its_place(stages, underlined, says, suggestion):
    with pytest.raises(InputError) as caught:
        read(stages)
    line = caught.value.source.line(1)
    found = [
        (line[each.column - 1 : each.column - 1 + each.length], each.message, each.suggestion)
        for each in caught.value.diagnostics
    ]
    assert any(where == underlined and says in message and hint == suggestion for where, message, hint in found), found


def test_an_initial_output_that_nothing_holds_is_refused():
    for stages in (SUMMER, INTEGRATOR):
        problem = read(stages, ", initial_output: 7")
        (refusal,) = refusals_of(problem.parts[0], Messages())
        assert "initial_output" in str(refusal)


MARKED = [
    (SUMMER, "v_o", "v_o(t) = -R_f (v1(t)/R1 + v2(t)/R2)", "correct", ""),
    (SUMMER, "v_o", "R_f/R1 v1 + R_f/R2 v2", "wrong", "the sign is reversed"),
    (SUMMER, "v_o", "-R1/R_f v1 - R2/R_f v2", "wrong", "upside down"),
    (SUMMER, "v_o", "-R_f/R2 v1 - R_f/R1 v2", "wrong", "two inputs are exchanged"),
    (SUMMER, "V_o", "V_o(s) = -R_f/R1 V1(s) - R_f/R2 V_2(s)", "correct", ""),
    (INTEGRATOR, "v_o", "v_o(0) - 1/(R1 C_f) ∫ v1 dt - 1/(R2 C_f) ∫_0^t v2(τ) dτ", "correct", ""),
    (INTEGRATOR, "v_o", "a - 1/C_f int(v1/R1 + v2/R2, t, 0, t)", "correct", ""),
    (INTEGRATOR, "v_o", r"a - \\frac{1}{C_f}\\int_0^t \\frac{v_1(\\tau)}{R_1} + \\frac{v_2(\\tau)}{R_2}\\,d\\tau",
     "correct", ""),
    (INTEGRATOR, "v_o", "a - Integral(v1(tau), (tau, 0, t))/(C_f*R1) - Integral(v2(tau), (tau, 0, t))/(C_f*R2)",
     "correct", ""),
    (INTEGRATOR, "v_o", "a + 1/(R1 C_f) ∫ v1 dt + 1/(R2 C_f) ∫ v2 dt", "wrong", "inversion"),
    (INTEGRATOR, "v_o", "-a - 1/(R1 C_f) ∫ v1 dt - 1/(R2 C_f) ∫ v2 dt", "wrong", "initial output has the wrong sign"),
    (INTEGRATOR, "v_o", "-1/(R1 C_f) ∫ v1 dt - 1/(R2 C_f) ∫ v2 dt", "wrong", ""),
    (INTEGRATOR, "v_o", "a - ∫ v1 dt - ∫ v2 dt", "wrong", "RC"),
    (INTEGRATOR, "V_o", "v_o(0)/s - V1/(s R1 C_f) - V2/(s R2 C_f)", "correct", ""),
    (DIFFERENTIATOR, "v_o", "-R_f (C1 dv1/dt + C2 dv2/dt)", "correct", ""),
    (DIFFERENTIATOR, "v_o", "-R_f C1 v1' - R_f C2 v2'(t)", "correct", ""),
    (DIFFERENTIATOR, "v_o", r"-R_f C_1 \\dot{v}_1 - R_f C_2 \\frac{d v_2}{dt}", "correct", ""),
    (DIFFERENTIATOR, "v_o", "-R_f*C1*Derivative(v1(t), t) - R_f*C2*diff(v2, t)", "correct", ""),
    (DIFFERENTIATOR, "v_o", "R_f C1 v1_dot + R_f C2 v2_dot", "wrong", "the sign is reversed"),
    (TWICE, "v_o", "b - 1/(R2 C2) ∫_0^t (a - 1/(R1 C1) ∫_0^τ v1(σ) dσ) dτ", "correct", ""),
    (TWICE, "v_o", "b - a t/(R2 C2) + 1/(R1 C1 R2 C2) ∫∫ v1 dt dt", "correct", ""),
    (TWICE, "v_o", "b - a t/(R2 C2) + 1/(R1 C1 R2 C2) ∫_0^t (t - τ) v1(τ) dτ", "correct", ""),
    (TWICE, "v_o", "b - a t/(R2 C2) - 1/(R1 C1 R2 C2) ∫∫ v1 dt dt", "wrong", "inversion"),
]  # fmt: skip


@pytest.mark.parametrize(("stages", "name", "written", "says", "why"), MARKED)
def test_answers_are_read_as_students_write_them(stages, name, written, says, why):
    found = verdict(text_of(stages), "a", name, f'"{written}"')
    assert found.verdict.value == says, found
    assert why in str(found.reason)


def test_decimals_count_to_the_digits_written():
    numbers = text_of({"inputs": {"v1": {"R": 3000}}, "feedback": {"C": 1e-6}})
    for written, says in (("-333.3 ∫ v1 dt", "correct"), ("-3.3e2 int(v1)", "correct"), ("-330.5 int(v1)", "wrong")):
        assert verdict(numbers, "a", "v_o", f'"{written}"').verdict.value == says, written


def test_the_judges_know_no_shortcut():
    system = read(TWICE).parts[0].system
    assert judges.transform_residual(system, LINES[-1][2]) < 1e-12
    assert judges.output_residual(system, LINES[-1][1]) < 1e-12
    assert judges.output_residual(system, LINES[-1][1] + b / 1000) > 1e-5
