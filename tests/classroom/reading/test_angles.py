"""Angles where degrees are asked for, told in radians."""

import pytest
import sympy as sp

from solver.classroom.reading.angles import readings_in_degrees, with_one_argument
from solver.problem.expressions import Names, parse_expression
from tests.helpers.marked import verdict

omega, T = sp.symbols("omega T")
IN_DEGREES = 180 / sp.pi

RESPONSE = """
title: t
find:
  a: {task: frequency_response, system: {transfer_function: "4/(s(s + 2))"}}
  b: {task: frequency_response, frequency: 3, system: {transfer_function: "4/(s(s + 2))"}}
  c: {task: root_locus, system: {transfer_function: "K(s + 2)/(s^2 + 2s + 3)"}}
  d: {task: frequency_response, frequency: 3, system: {transfer_function: "4 exp(-s)/(s + 2)"}}
"""


@pytest.mark.parametrize(
    ("value", "found"),
    [
        (-sp.pi / 4, [-45]),
        (-sp.pi / 2 - sp.atan(omega), [-90 - sp.atan(omega) * IN_DEGREES]),
        (-90 - sp.atan(omega), [-90 - sp.atan(omega) * IN_DEGREES]),
        (-90 - sp.atan(omega) * IN_DEGREES, [-90 - sp.atan(omega) * IN_DEGREES]),
        (-sp.Rational(573, 10) * sp.atan(omega), [-sp.Rational(573, 10) * sp.atan(omega)]),
        (sp.Rational(-785, 1000), [sp.Rational(-785, 1000)]),
        (-omega * T, [-omega * T]),
        (
            -omega * T - sp.atan(omega),
            [-omega * T - sp.atan(omega) * IN_DEGREES, (-omega * T - sp.atan(omega)) * IN_DEGREES],
        ),
    ],
)
def test_what_has_pi_or_an_arctangent_is_in_radians(value, found):
    readings = readings_in_degrees(value, {})
    assert all(sp.expand(each - one) == 0 for each, one in zip(readings, found, strict=True))


@pytest.mark.parametrize(("y", "x"), [(-6, -9), (6, -9), (-6, 9), (6, 9), (3, 0)])
def test_an_arctangent_of_two_arguments_is_one_of_one(y, x):
    found = parse_expression(with_one_argument(f"atan2({y}, {x})"), Names())
    assert abs(sp.N(found - sp.atan2(y, x))) < 1e-12


@pytest.mark.parametrize(
    ("part", "name", "text", "said"),
    [
        ("a", "phase", "-90° - arctan(ω/2)", "correct"),
        ("a", "phase", "-90 - 57.3 atan(w/2)", "correct"),
        ("a", "phase", "'atan2(-2ω, -ω²)'", "correct"),
        ("a", "phase", "-arctan(ω/2)", "wrong"),
        ("b", "phase", "-90° - arctan(1.5) = -146.3°", "correct"),
        ("b", "phase", "'atan2(-6, -9)'", "correct"),
        ("b", "phase", "-π/2 - atan(1.5)", "correct"),
        ("b", "phase", "-2.55", "wrong"),
        ("b", "phase", "-146.3 rad", "wrong"),
        ("c", "asymptote_angles", "π", "correct"),
        ("c", "departure_angles", "±144.7°", "correct"),
        ("c", "departure_angles", "90° + arctan(√2)", "correct"),
        ("c", "departure_angles", "±54.7°", "wrong"),
        ("d", "phase", "-3 - arctan(1.5)", "correct"),
        ("d", "phase", "-4 - arctan(1.5)", "not judged"),
        ("b", "phase", "-90 - arctan(1.5)", "correct"),
        ("d", "phase", "-171.9° - arctan(1.5)", "correct"),
    ],
)
def test_phases_in_radians_are_read(part, name, text, said):
    assert str(verdict(RESPONSE, part, name, text).verdict) == said
