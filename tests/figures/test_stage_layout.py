"""Inverting stages as a textbook draws them: inputs at the left, feedback above, what no stage is left to the rest."""

import json
from itertools import pairwise

import pytest

from solver import figures
from solver.figures.circuit_layout import layout_of
from solver.figures.stage_layout import stages_in
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from solver.tasks.analog.stage_figures import schematic_of
from solver.tasks.modelling.circuit_figures import schematic_of as schematic_of_circuit

SUMMER = [{"inputs": {"v1": "R1", "v2": "R2", "v3": {"C": "2e-6"}}, "feedback": {"R": 5000}}]
THREE = [*SUMMER, {"inputs": {"v_a": "R4", "v4": "R5"}, "feedback": "C1"}, {"inputs": {"v_b": "R6"}, "feedback": "R7"}]


def drawn(stages):
    text = f"system: {{op_amp: {json.dumps(stages)}}}\nfind: {{a: op_amp_stage}}\n"
    (figure,) = schematic_of(read_problem(Source("f", text), catalogue()).parts[0].system)
    return figure


def circuit(lines):
    text = f"system: {{circuit: {json.dumps(lines)}}}\nfind: {{a: state_space_model}}\n"
    return schematic_of_circuit(read_problem(Source("f", text), catalogue()).parts[0].system)


@pytest.mark.parametrize("stages", [SUMMER, THREE])
def test_inputs_are_at_the_left_and_the_feedback_is_above(stages):
    layout = layout_of(drawn(stages))
    assert [each.label for each in layout.terminals if each.right] == ["v_{o}"]
    output = next(each for each in layout.terminals if each.right)
    assert all(each.place[0] < output.place[0] for each in layout.terminals if not each.right)
    assert all(a.output[0] < b.upper[0] for a, b in pairwise(layout.amplifiers))
    assert all(each.minus_above for each in layout.amplifiers)
    for amplifier in layout.amplifiers:
        (x, top), (end, _) = amplifier.upper, amplifier.output
        assert any(
            each.start[1] == each.end[1] > top and min(each.start[0], each.end[0]) < end and each.start[0] > x - 2
            for each in layout.placed
        )
    assert len(layout.grounds) == len(layout.amplifiers)
    assert layout.names == []


def test_values_are_labelled_with_units_and_outputs_between_the_stages():
    labels = [each.label for each in drawn(SUMMER).components]
    assert r"C_{3} = 2\,\mu\mathrm{F}" in labels
    assert r"R_{f} = 5\,\mathrm{k}\Omega" in labels
    assert [label for _, label in layout_of(drawn(THREE)).voltages] == ["v_{a}", "v_{b}"]


def test_the_drawing_is_the_same_in_both_formats_each_time():
    figure = drawn(THREE)
    assert figures.svg(figure) == figures.svg(figure)
    written = figures.tikz(figure)
    assert written.count("circle (0.08)") == 5
    assert written.count("to[R]") + written.count("to[C]") == 9


def test_other_circuits_are_laid_out_as_before():
    (sallen_key,) = circuit(["V1 1 0 v_s", "R1 1 2", "R2 2 3", "C1 2 4", "C2 3 0", "O1 4 0 3 4"])
    assert stages_in(sallen_key) is None
    (inverting,) = circuit(["V1 1 0 v_s", "R1 1 2", "R2 2 3", "C 2 3", "O1 3 0 0 2"])
    layout = layout_of(inverting)
    assert [each.label for each in layout.terminals] == ["v_{s}", "v_{3}"]
    assert [name for _, name in layout.names] == ["1", "2", "3"]
    ring = ["V1 1 0 u", "R1 1 2", "C1 2 3", "O1 3 0 0 2", "R2 3 4", "C2 4 5", "O2 5 0 0 4", "R3 5 2"]
    assert all(stages_in(each) is None for each in circuit(ring))
