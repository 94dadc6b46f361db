"""Programs as data: to JSON and back, what their shape shows, and from one process to another."""

import json

import pytest
from sympy import Integer, Rational, Symbol

from solver.limits.codec import decode, encode
from solver.patches import Element, NotAProgram, Program, algebraic_loop, data_of, faults_of, in_order, program_of
from tests.helpers.programs import ONE, TEN, scaled_oscillator


def read(value):
    if isinstance(value, bool) or value is None:
        raise ValueError("no value")
    return Rational(str(value)) if isinstance(value, int | float) else Symbol(value)


def number(value):
    return int(value) if value.is_Integer else float(value)


def test_a_program_is_json_and_back():
    program = scaled_oscillator()
    data = json.loads(json.dumps(data_of(program, number, str)))
    assert data["elements"][-1] == {"id": "A3", "kind": "inverter", "input": "A1"}
    assert data["elements"][6]["inputs"] == [["P2", 10], ["P3", 10], ["P4", 10]]
    assert data["readout"] == {"x": ["A1", 5], "x_dot": ["A2", -25]}
    assert program_of(data, read) == program


def test_a_source_may_be_an_input_or_a_function():
    program = Program(TEN, (Element("U1", "source", value=Symbol("u")),), {})
    assert data_of(program, number, str)["elements"] == [{"id": "U1", "kind": "source", "value": "u"}]


def test_a_program_crosses_the_process():
    program = scaled_oscillator()
    assert decode(encode({"program": program}))["program"] == program


def test_nothing_is_wrong_with_a_good_program():
    assert list(faults_of(scaled_oscillator(), [1, 10])) == []
    ordered, looped = in_order(scaled_oscillator())
    assert len(ordered) == 8
    assert looped == []


@pytest.mark.parametrize(
    ("element", "kind"),
    [
        (Element("P1", "pot", (("A1", ONE),), setting=Rational(6, 5)), "setting"),
        (Element("P1", "pot", (("A1", ONE),), setting=Rational(-1, 5)), "setting"),
        (Element("A1", "integrator", (("P1", Integer(5)),), initial=ONE), "gain"),
        (Element("A1", "integrator", (("P1", TEN),), initial=Integer(11)), "reference"),
        (Element("U1", "source", value=Integer(-12)), "reference"),
    ],
)
def test_what_cannot_be_patched_is_told(element, kind):
    others = [
        Element("P1", "pot", (("A1", ONE),), setting=ONE),
        Element("A1", "integrator", (("P1", TEN),), initial=ONE),
    ]
    elements = (*(each for each in others if each.id != element.id), element)
    assert [each.kind for each in faults_of(Program(TEN, elements, {}), [1, 10])] == [kind]


def test_an_algebraic_loop_is_named_in_the_order_of_the_signal():
    elements = (
        Element("P1", "pot", (("A1", ONE),), setting=ONE),
        Element("A2", "inverter", (("P1", ONE),)),
        Element("A1", "summer", (("A2", TEN),)),
        Element("A3", "summer", (("A1", TEN),)),
    )
    loop = algebraic_loop(Program(TEN, elements, {}))
    assert set(loop) == {"A1", "P1", "A2"}
    assert loop[(loop.index("A1") + 1) % 3] == "P1"


@pytest.mark.parametrize(
    ("data", "message"),
    [
        ([], "a program is a mapping"),
        ({"reference": 10, "elements": []}, "readout is missing"),
        ({"reference": 10, "elements": {}, "readout": {}}, "elements is a list"),
        ({"reference": 10, "elements": [{"id": "A1", "kind": "adder"}], "readout": {}}, "A1 has no kind among"),
        (
            {"reference": 10, "elements": [{"id": "P1", "kind": "pot", "input": "A1"}], "readout": {}},
            "P1 has no setting",
        ),
        ({"reference": 10, "elements": [], "readout": {"x": ["A1", 1]}}, "there is no element A1"),
        ({"reference": 10, "elements": [], "readout": {"x": "A1"}}, "a readout is a pair"),
        (
            {"reference": 10, "elements": [{"id": "A1", "kind": "inverter", "input": "P1"}], "readout": {}},
            "A1 is fed by P1, which is no element",
        ),
        ({"reference": "u", "elements": [], "readout": {}}, "'u' is not a number"),
    ],
)
def test_what_is_no_program_says_why(data, message):
    with pytest.raises(NotAProgram, match=message):
        program_of(data, read)
