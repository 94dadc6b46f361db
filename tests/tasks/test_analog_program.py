"""Programs of an analog computer: settings of a course, any system, spoiled programs, marking, what has no program."""

import json
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Integer, Rational, Symbol, log

from solver.derivation import Answers, CheckStatus, Status
from solver.document.model import Presentation
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.patches import Element, data_of
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.render.data import as_data
from solver.tasks import catalogue
from tests.helpers.marked import marked, solved
from tests.helpers.programs import spoiled

COURSE = """
system: {equations: ["x'' + 8 x' + 25 x = 500"], initial: {x: 40, "x'": 150}}
find: {a: {task: analog_program, maximum: {x: 50, "x'": 250}MORE}}
"""
SLOW = COURSE.replace("MORE", ", time_scale: 10")
SCALED = COURSE.replace("MORE", "")
DRIVEN = """
system: {equations: ["x' + 3 x - y = u", "y' + 2 y + x = 0"], inputs: [u], outputs: [x, "x + 2 y"], initial: {x: 1}}
find: {a: {task: analog_program, maximum: {x: 4, y: 2}}}
"""
STATIC = """
system: {equations: ["v_o = 0.35 v1 + 5.24 v2 - 2.6 - 10 v3"]}
find: {a: analog_program}
"""


def read(text):
    return read_problem(Source("file.yaml", text), catalogue())


def result_of(text):
    return solve_problem(read(text)).parts[0]


def program_of(text):
    return solved(text).parts[0].answers["program"]


def fails(text, **answers):
    """Whether a check of these answers fails."""
    task, part = catalogue()["analog_program"], read(text).parts[0]
    checks = list(task.verify(task.given(part.system, part.options), Answers(**answers)))
    assert checks
    return any(check.status is CheckStatus.FAILED for check in checks)


def as_text(program):
    number = lambda value: int(value) if value.is_Integer else float(value)  # noqa: E731
    return json.dumps(data_of(program, number, str))


def verdict(text, program, **more):
    written = program if isinstance(program, str) else as_text(program)
    others = "".join(f", {name}: {value}" for name, value in more.items())
    return marked(text, f"answers: {{a: {{program: {written}{others}}}}}")["a"].answers


def test_the_settings_are_those_of_the_course():
    result = result_of(SCALED)
    assert result.status is Status.VERIFIED
    kinds = [step.kind for step in result.steps]
    assert kinds[-4:] == ["signs", "amplifiers", "settings", "program"]
    found = {str(name): value for name, value in result.answers["potentiometers"].items()}
    assert sorted(found.values()) == sorted(Rational(each) for each in ("1/2", "1/2", "4/5", "1/5"))
    program = result.answers["program"]
    assert {gain for each in program.of_kind("integrator") for _, gain in each.inputs} == {10}
    assert {each.id: each.initial for each in program.of_kind("integrator")} == {"A1": 8, "A2": -6}
    assert [each.kind for each in program.elements if each.is_amplifier] == ["integrator", "integrator", "inverter"]
    assert program.readout == {"x": ("A1", 5), "x_dot": ("A2", -25)}


def test_time_scaling_divides_the_gains_and_leaves_the_start():
    program = program_of(SLOW)
    assert {gain for each in program.of_kind("integrator") for _, gain in each.inputs} <= {1, 10}
    assert {each.id: each.initial for each in program.of_kind("integrator")} == {"A1": 8, "A2": -6}
    assert result_of(SLOW).status is Status.VERIFIED


def test_a_static_relation_takes_the_fewest_summers():
    program = program_of(STATIC)
    assert [each.kind for each in program.elements if each.is_amplifier] == ["summer", "summer"]
    assert sorted(program.potentiometers.values()) == [Rational(26, 100), Rational(35, 100), Rational(524, 1000)]


def test_the_program_is_data_in_json():
    solution = solved(SCALED)
    told = Presentation(data=True)
    answers = as_data(document_of(solution, told))["parts"][0]["answers"]
    value = answers["program"]["value"]
    assert value["reference"] == 10
    assert value["readout"] == {"x": ["A1", 5], "x_dot": ["A2", -25]}
    assert value["elements"][-1] == {"id": "A3", "kind": "inverter", "input": "A1"}
    assert answers["potentiometers"]["numeric"] == {"P1": 0.5, "P2": 0.5, "P3": 0.8, "P4": 0.2}
    assert json.loads(json.dumps(value)) == value


@pytest.mark.parametrize("text", [SCALED, SLOW, DRIVEN, STATIC])
def test_every_spoiled_program_is_rejected(text):
    program = program_of(text)
    assert not fails(text, program=program)
    for what, wrong in spoiled(program):
        assert fails(text, program=wrong), what


def test_a_program_in_a_loop_or_without_a_variable_is_rejected():
    program = program_of(SCALED)
    summed = replace(program["A1"], kind="summer", initial=None)
    elements = tuple(summed if each.id == "A1" else each for each in program.elements)
    wrong = tuple(replace(each, kind="summer", initial=None) if each.id == "A2" else each for each in elements)
    assert fails(SCALED, program=replace(program, elements=wrong))
    assert fails(SCALED, program=replace(program, readout={"x_dot": program.readout["x_dot"]}))


def test_settings_by_themselves_are_put_into_the_program():
    own = dict(result_of(SCALED).answers["potentiometers"])
    assert not fails(SCALED, potentiometers=own)
    for name, setting in own.items():
        assert fails(SCALED, potentiometers={**own, name: setting * Rational(49, 50)})


@settings(max_examples=6, deadline=None)
@given(st.lists(st.integers(1, 9), min_size=3, max_size=3), st.lists(st.integers(-3, 3), min_size=3, max_size=3))
def test_programs_of_stable_equations_are_verified(roots, start):
    a, b, c = roots
    equation = f"x''' + {a + b + c} x'' + {a * b + b * c + c * a} x' + {a * b * c} x = 6"
    initial = f'{{x: {start[0]}, "x\'": {start[1]}, "x\'\'": {start[2]}}}'
    system = f'system: {{equations: ["{equation}"], initial: {initial}}}'
    result = result_of(f"{system}\nfind: {{a: {{task: analog_program, time_scale: 4}}}}")
    assert result.status is Status.VERIFIED
    assert "overload_time" not in result.answers


@settings(max_examples=6, deadline=None)
@given(st.lists(st.integers(-4, 4), min_size=9, max_size=9), st.lists(st.integers(-2, 2), min_size=3, max_size=3))
def test_any_state_space_system_has_its_program(numbers, start):
    A, sizes = [numbers[0:3], numbers[3:6], numbers[6:9]], "{x1: 10, x2: 5, x3: 20}"
    system = f"system: {{A: {A}, B: [[1], [0], [-2]], C: [[1, -1, 0]], initial_state: {start}}}"
    result = result_of(f"{system}\nfind: {{a: {{task: analog_program, maximum: {sizes}}}}}")
    assert result.status is Status.VERIFIED
    program = result.answers["program"]
    added = [each for each in program.elements if each.kind in ("inverter", "summer")]
    assert len(added) <= 5  # three inverters, one of the input, the output


def test_overload_is_told_with_its_time():
    text = """
system: {equations: ["x' = x"], initial: {x: 1}}
find: {a: {task: analog_program, maximum: {x: 10}}}
"""
    result = result_of(text)
    assert result.status is Status.VERIFIED
    assert result.answers["overload_time"] == log(10)
    assert not fails(text, overload_time=Rational("2.302585093"))
    assert fails(text, overload_time=Rational("2.31"))
    assert fails(text, overload_time=log(10) / 2)


# Marking


def test_another_program_is_right_too():
    program = program_of(SCALED)
    turned = {"U1": {"value": -10}, "A1": {"initial": Integer(-8)}, "A2": {"initial": Integer(6)}}
    elements = tuple(
        replace(each, **{key: Integer(value) for key, value in turned.get(each.id, {}).items()})
        for each in program.elements
    )
    readout = {name: (of, -factor) for name, (of, factor) in program.readout.items()}
    other = replace(program, elements=elements, readout=readout)
    assert verdict(SCALED, other)["program"].verdict == "correct"


def test_a_program_is_right_within_its_digits():
    text = """
system: {equations: ["3 x' + 2 x = 0"], initial: {x: 5}}
find: {a: {task: analog_program, maximum: {x: 10}}}
"""
    program = as_text(program_of(text))
    assert verdict(text, program)["program"].verdict == "correct"
    for written, right in (("0.667", True), ("0.6667", True), ("0.66", False), ("0.668", False)):
        rounded = program.replace("0.6666666666666666", written)
        assert rounded != program
        assert (verdict(text, rounded)["program"].verdict == "correct") == right, written


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"A2": {"initial": Integer(6)}}, "A2 starts with the wrong sign"),
        ({"A1": {"initial": Integer(-8)}, "A2": {"initial": Integer(6)}}, "initial values have the wrong sign"),
        ({"A1": {"initial": Integer(0)}, "A2": {"initial": Integer(0)}}, "initial values are left out"),
        ({"P3": {"setting": Rational(9, 10)}}, "only the setting of P3 is wrong"),
        ({"A3": {"kind": "pot", "setting": Integer(1)}}, "into A2 has the wrong sign"),
    ],
)
def test_mistakes_have_their_names(change, words):
    program = program_of(SCALED)
    elements = tuple(replace(each, **change.get(each.id, {})) for each in program.elements)
    found = verdict(SCALED, replace(program, elements=elements))["program"]
    assert found.verdict == "wrong"
    assert words in str(found.reason)


def test_scale_factors_upside_down_are_told():
    program = program_of(SCALED)
    readout = {name: (of, 1 / factor) for name, (of, factor) in program.readout.items()}
    found = verdict(SCALED, replace(program, readout=readout))["program"]
    assert "upside down" in str(found.reason)


def test_time_scaling_of_initial_values_is_told():
    program = program_of(SLOW)
    elements = tuple(
        replace(each, initial=each.initial / 10) if each.kind == "integrator" else each for each in program.elements
    )
    found = verdict(SLOW, replace(program, elements=elements))["program"]
    assert "time scale is applied to the initial values" in str(found.reason)
    found = verdict(SLOW, program_of(SCALED))["program"]
    assert "time scale is left out" in str(found.reason)


def test_a_program_that_cannot_be_read_says_where():
    found = verdict(SCALED, as_text(program_of(SCALED)).replace('"input": "A1"', '"input": "A7"'))["program"]
    assert found.verdict == "not judged"
    assert "A3 is fed by A7, which is no element" in str(found.reason)


def test_a_program_may_be_json_in_quotes():
    text = as_text(program_of(SCALED))
    assert verdict(SCALED, f"'{text}'")["program"].verdict == "correct"


# What has no program


@pytest.mark.parametrize(
    ("equation", "more", "words"),
    [
        ("x'' + k x = 0", "", "give values to the parameters"),
        ("x'' + x^2 = 0", "", "a multiplier would be needed"),
        ("x'' + sin(x) = 0", "", "a function generator would be needed"),
        ("x'' + 2500 x = 0", "", "`time_scale: 28` or more"),
        ("x'' + 50 x = 0", ", gains: [1]", "`time_scale: 6` or more"),
    ],
)
def test_the_reason_says_what_to_change(equation, more, words):
    text = f"""
system: {{equations: ["{equation}"], initial: {{x: 1}}}}
find: {{a: {{task: analog_program, maximum: {{x: 3, "x'": 9}}{more}}}}}
"""
    result = result_of(text)
    assert result.status is Status.UNSOLVED
    assert words in str(result.reason)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ("maximum: {x: 0.5}", "begins at 1, beyond its maximum 1/2"),
        ("gains: [0, 1]", "positive number"),
        ("maximum: {z: 1}", "z"),
        ("reference: -10", "must be positive"),
    ],
)
def test_a_wrong_question_is_refused_at_its_place(options, words):
    text = (
        f'system: {{equations: ["x\' + x = 0"], initial: {{x: 1}}}}\nfind: {{a: {{task: analog_program, {options}}}}}\n'
    )
    with pytest.raises(InputError) as error:
        solve_problem(read(text))
    assert words in str(error.value)


def test_symbols_of_potentiometers_are_their_names():
    assert all(isinstance(name, Symbol) for name in result_of(SCALED).answers["potentiometers"])
    assert isinstance(program_of(SCALED)["P1"], Element)
