"""Mistakes of classical control are named, whole numbers among them; what is written otherwise is right."""

import pytest

from solver.classroom.verdicts import Verdict
from tests.helpers.marked import marked, verdict

PROBLEM = """\
title: Classical
find:
  m: {task: stability_margins, system: {transfer_function: 10/(s(s + 1)(s + 5))}}
  b: {task: bode, system: {transfer_function: 200(s + 1)/(s^2(s + 10))}}
  n: {task: nyquist, system: {transfer_function: 10/(s(s + 1)(s + 5))}}
  r: {task: root_locus, system: {transfer_function: 1/(s(s + 4)(s^2 + 4s + 20))}}
  e: {task: steady_state_error, reference: ramp, system: {transfer_function: 10/(s(s + 1)(s + 5))}}
  f: {task: frequency_response, system: {transfer_function: 4/(s^2 + s + 4)}, input: 2cos(4t)}
  z: {task: second_order_parameters, system: {transfer_function: 4/(s^2 + 2s + 4)}}
  o: {task: dc_gain, system: {transfer_function: 10/(2s + 4)}, feedback: unity}
  v: {task: step_specifications, system: {transfer_function: 9/(s^2 + 2s)}, feedback: unity, settling_band: 2%}
  w: {task: step_specifications, system: {transfer_function: 4/(s^2 + s + 1)}, feedback: unity}
"""

NAMED = [
    ("m", "phase_margin", "-154.6", "the phase itself"),
    ("m", "phase_margin", "154.6", "the phase itself"),
    ("m", "phase_margin", "0.44314", "radians"),
    ("m", "gain_margin_db", "4.77", "10 log"),
    ("m", "gain_margin", "4.77 dB", "10 log"),
    ("m", "gain_margin", "4.77", "10 log"),
    ("m", "gain_margin_db", "1.0986", "natural logarithm"),
    ("m", "gain_margin", "9.54", "dB"),
    ("b", "bode_gain", "200", "pole-zero form"),
    ("b", "slopes", "[-2, -1, -2]", "20 dB a decade"),
    ("b", "slopes", "[-40, -60, -40]", "exchanged at the corners"),
    ("n", "open_loop_unstable_poles", "1", "poles on the axis"),
    ("r", "asymptote_angles", "[0.785, 2.356, -0.785, -2.356]", "radians"),
    ("r", "centroid", "2", "other way round"),
    ("r", "breakaway_points", "[-2]", "2 points where branches meet are missing"),
    ("e", "error", "2", "error constant"),
    ("f", "magnitude", "-10", "in dB"),
    ("f", "magnitude", "-5", "10 log"),
    ("f", "magnitude", "-5 dB", "10 log"),
    ("f", "phase", "18.43", "quadrant"),
    ("f", "y_steady_state", "0.632 cos(4t)", "phase is missing"),
    ("f", "y_steady_state", "0.632 cos(4t - 161.6)", "degrees"),
    ("f", "y_steady_state", "0.3162 cos(4t - 2.820)", "amplitude of the input"),
    ("z", "natural_frequency", "4", "root is not taken"),
    ("z", "damping_ratio", "1", "2 is forgotten"),
    ("o", "dc_gain", "5/2", "not closed"),
    ("v", "settling_time", "3", "another band"),
    ("w", "overshoot", "0.163", "not closed"),
]


LATE = """\
title: A loop round a dead time, of which no fraction tells what usual mistakes lead to
system: {transfer_function: exp(-s)/(s + 1)}
find:
  o: {task: dc_gain, controller: 2, feedback: unity}
"""


def test_a_mistake_without_a_meaning_here_is_none():
    assert verdict(LATE, "o", "dc_gain", "7/3").verdict is Verdict.WRONG
    assert verdict(LATE, "o", "dc_gain", "2/3").verdict is Verdict.CORRECT


@pytest.mark.parametrize(("part", "name", "value", "says"), NAMED)
def test_a_mistake_is_named(part, name, value, says):
    found = verdict(PROBLEM, part, name, f'"{value}"' if not value.startswith("[") else value)
    assert found.verdict is Verdict.WRONG
    assert says in str(found.reason)


@pytest.mark.parametrize(
    ("part", "name", "value"),
    [
        ("m", "phase_margin", "385.39°"),
        ("b", "bode_gain", "26.02 dB"),
        ("r", "imaginary_axis_crossings", "[sqrt(10), -sqrt(10)]"),
        ("r", "critical_gains", "[260, 260]"),
        ("r", "departure_angles", "[-90, 90]"),
        ("r", "asymptote_angles", "[45, 135, 225, 315]"),
        ("f", "magnitude", "-10 dB"),
        ("v", "overshoot", "32.9 %"),
    ],
)
def test_what_is_written_otherwise_is_right(part, name, value):
    found = verdict(PROBLEM, part, name, value if value.startswith("[") else f'"{value}"')
    assert found.verdict is Verdict.CORRECT, found.reason


def test_a_frequency_in_decimals_beside_wrong_margins_is_marked():
    own = "answers: {m: {gain_crossover: 1.2271, phase_margin: -154.6, stable: no}}"
    found = marked(PROBLEM, own)["m"].answers
    assert found["gain_crossover"].verdict is Verdict.CORRECT
    assert "the phase itself" in str(found["phase_margin"].reason)
