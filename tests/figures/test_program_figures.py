"""From a program to its drawing: what is written beside each element."""

from dataclasses import replace

import pytest
from sympy import Integer, Rational, sqrt, symbols

from solver.figures.drawing import drawing_of
from solver.patches import Element, Program
from solver.tasks.analog.patch_figures import MOST, decimal, drawn, voltages
from tests.helpers.programs import ONE, TEN, scaled_oscillator


def test_everything_that_a_course_writes_stands_beside_the_elements():
    (figure,) = drawn("A program", scaled_oscillator())
    written = {each.name: (each.value, each.output) for each in figure.elements}
    assert written == {
        "U_{1}": (r"+10\,\mathrm{V}", ""), "P_{1}": ("0.5", ""), "P_{2}": ("0.5", ""), "P_{3}": ("0.8", ""),
        "P_{4}": ("0.2", ""), "A_{1}": (r"8\,\mathrm{V}", "x/5"), "A_{2}": (r"-6\,\mathrm{V}", r"-\dot{x}/25"),
        "A_{3}": ("", "-x/5"),
    }  # fmt: skip
    integrator = next(each for each in figure.elements if each.name == "A_{2}")
    assert [(figure.elements[fed].name, gain) for fed, gain in integrator.inputs] == [
        ("P_{2}", "10"), ("P_{3}", "10"), ("P_{4}", "10"),
    ]  # fmt: skip
    assert "Potentiometer P₄ at 0.2, fed by +10 V. Integrator A₁, fed by P₁ (gain 10), starts at 8 V" in (
        drawing_of(figure).alt
    )


def test_sources_that_are_names_or_functions_are_written_as_they_are():
    u, tau = symbols("u tau")
    sources = [u, 5 * sqrt(2) * u / (3 + tau) ** 2, Integer(-10), (u + tau) ** 9 + (u - tau) ** 8 + sqrt(u * tau) ** 7]
    elements = [Element(f"U{i}", "source", value=value) for i, value in enumerate(sources)]
    fed = tuple((each.id, ONE) for each in elements)
    (figure,) = drawn("A program", Program(TEN, (*elements, Element("A1", "summer", fed)), {"y": ("A1", ONE)}))
    values = [each.value for each in figure.elements]
    assert values[0] == "u"
    assert r"\sqrt{2}" in values[1]
    assert values[2:] == [r"-10\,\mathrm{V}", "U_{3}", ""]


def test_outputs_follow_from_the_readout_and_from_what_is_said():
    program = scaled_oscillator()
    unread = replace(program, readout={"x": ("A1", Rational(3, 2))})
    X2 = symbols("X2")
    assert voltages(unread, {"A2": -X2})["A2"] == -X2
    assert {each.name: each.output for each in drawn("", unread)[0].elements if each.output} == {
        "A_{1}": "2x/3", "A_{3}": "-2x/3",
    }  # fmt: skip
    coupled = replace(program, readout={"x1_dot": ("A1", Integer(2)), "omega_2_ddot": ("A2", ONE)})
    assert [each.output for each in drawn("", coupled)[0].elements[5:]] == [
        r"\dot{x}_{1}/2", r"\ddot{\omega_{2}}", r"-\dot{x}_{1}/2",
    ]  # fmt: skip
    surd = replace(program, readout={"x": ("A1", sqrt(5)), "x_dot": ("A2", ONE)})
    assert [each.output for each in drawn("", surd)[0].elements[5:]] == ["0.4472x", r"\dot{x}", "-0.4472x"]


@pytest.mark.parametrize(
    ("value", "text"),
    [(Integer(10), "10"), (Rational(7, 20), "0.35"), (Rational(1, 3), "0.3333"), (sqrt(2) / 2, "0.7071"),
     (-Rational(5, 2), "-2.5"), (Rational(1, 80000), r"1.25 \cdot 10^{-5}"), (Integer(0), "0"),
     (Rational(24691, 2000), "12.3455"), (20 * sqrt(2), "28.28"),
     (196 * sqrt(2), "277.2"), (Rational(276999999, 1000003), "277"),
     (Integer(12000), "12000"), (Integer(20), "20")],
)  # fmt: skip
def test_numbers_are_written_as_a_dial_shows_them(value, text):
    assert decimal(value) == text


def test_a_program_of_very_many_amplifiers_is_not_drawn():
    amplifiers = [Element(f"A{i}", "inverter", ((f"A{i - 1}" if i else "U1", ONE),)) for i in range(MOST + 1)]
    source = Element("U1", "source", value=TEN)
    assert drawn("", Program(TEN, (source, *amplifiers), {})) == ()
    assert drawn("", Program(TEN, (source, *amplifiers[:2]), {})) != ()
