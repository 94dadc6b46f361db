"""Circuits against textbooks and chain matrices: state equations, transfer functions, what is refused."""

from __future__ import annotations

import json
from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver import figures
from solver.derivation import CheckStatus, Status
from solver.engine import given_of, refusals_of, solve_problem
from solver.exact.modelling.circuits import circuit_model
from solver.exact.modelling.nodal import nodal_model
from solver.figures.circuit_layout import layout_of
from solver.figures.drawing import drawing_of
from solver.messages import Messages
from solver.numeric.judges import modelling as judges
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from solver.tasks.modelling.circuit_figures import schematic_of
from tests.helpers.marked import verdict

s = sp.Symbol("s")


def read(lines, find="state_space_model", **more):
    keys = {"circuit": lines, **more}
    system = ", ".join(f"{key}: {json.dumps(value)}" for key, value in keys.items())
    return read_problem(Source("file.yaml", f"system: {{{system}}}\nfind: {{a: {find}}}\n"), catalogue())


def solved(lines, find="state_space_model", **more):
    return solve_problem(read(lines, find, **more)).parts[0]


def complaints(lines, **more):
    """What is underlined, the message and the suggestion, of each fault."""
    with pytest.raises(InputError) as caught:
        read(lines, **more)
    line = caught.value.source.line(1)
    return [
        (line[each.column - 1 : each.column - 1 + each.length], each.message, each.suggestion)
        for each in caught.value.diagnostics
    ]


R, L, C, R1, R2, C1, C2, b, g, mu, r = sp.symbols("R L C R1 R2 C1 C2 b g mu r", real=True)
SERIES = ["V1 1 0 v_s", "R 1 2", "L 2 3", "C 3 0"]
SALLEN_KEY = ["V1 1 0 v_s", "R1 1 2", "R2 2 3", "C1 2 4", "C2 3 0", "O1 4 0 3 4"]
INVERTING = ["V1 1 0 v_s", "R1 1 2", "R2 2 3", "C 2 3", "O1 3 0 0 2"]


def test_a_series_circuit_has_the_equations_of_the_textbook():
    result = solved(SERIES, outputs=["v_C"])
    assert result.status is Status.VERIFIED
    assert result.method == "kirchhoff"
    assert result.answers["A"] == sp.ImmutableMatrix([[-R / L, -1 / L], [1 / C, 0]])
    assert result.answers["B"] == sp.ImmutableMatrix([1 / L, 0])
    assert (result.answers["C"], result.answers["D"]) == (sp.ImmutableMatrix([[0, 1]]), sp.ImmutableMatrix([[0]]))
    kinds = [step.kind for step in result.steps]
    assert kinds == ["tree", "laws", "loops", "cuts", "turns", "rates", "highest", "states", "matrices"]


def test_states_are_in_the_order_asked():
    result = solved(SERIES, outputs=["v_C"], states=["v_C", "i_L"])
    assert result.answers["A"] == sp.ImmutableMatrix([[0, 1 / C], [-1 / L, -R / L]])


@pytest.mark.parametrize("method", ["adjugate", "faddeev_leverrier", "impedance"])
@pytest.mark.parametrize(
    ("lines", "output", "G"),
    [
        (SERIES, "v_C", 1 / (L * C * s**2 + R * C * s + 1)),
        (SERIES, "v_R", R * C * s / (L * C * s**2 + R * C * s + 1)),
        (SERIES, "i_V1", -C * s / (L * C * s**2 + R * C * s + 1)),
        (SALLEN_KEY, "v_4", 1 / (R1 * R2 * C1 * C2 * s**2 + C2 * (R1 + R2) * s + 1)),
        (INVERTING, "v_3", -R2 / (R1 * (R2 * C * s + 1))),
        (["V1 1 0 v_s", "R 1 2", "C 2 3", "O1 3 0 0 2"], "v_3", -1 / (R * C * s)),
        (["I1 0 1 i_s", "R 1 0", "L 1 0", "C 1 0"], "v_1", L * s / (L * C * s**2 + L * s / R + 1)),
        (["V1 1 0 v_s", "R1 1 2", "C 2 0", "E1 3 0 2 0 mu", "R2 3 0"], "v_3", mu / (R1 * C * s + 1)),
        (["V1 1 0 v_s", "R1 1 2", "C 2 0", "G1 3 0 2 0 g", "R2 3 0"], "v_3", -g * R2 / (R1 * C * s + 1)),
        (["V1 1 0 v_s", "R1 1 2", "L 2 0", "F1 0 3 L b", "R2 3 0"], "v_3", b * R2 / (L * s + R1)),
        (["V1 1 0 v_s", "R1 1 2", "L 2 0", "H1 3 0 L r", "R2 3 0"], "v_3", r / (L * s + R1)),
    ],
)  # fmt: skip
def test_transfer_functions_of_the_textbooks(lines, output, G, method):
    result = solved(lines, f"{{task: transfer_function, method: {method}}}", outputs=[output])
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["G"] - G) == 0


def test_two_sources_and_two_outputs():
    lines = ["V1 1 0 v_1", "R1 1 2", "C 2 0", "R2 2 3", "V2 3 0 v_3"]
    for method in ("impedance", "adjugate"):
        result = solved(lines, f"{{task: transfer_function, method: {method}}}", outputs=["v_C", "i_R1"])
        assert result.status is Status.VERIFIED
        over = R1 + R2 + R1 * R2 * C * s
        wanted = [[R2 / over, R1 / over], [(1 + R2 * C * s) / over, -1 / over]]
        assert sp.cancel(result.answers["G"] - sp.Matrix(wanted)).is_zero_matrix


def test_an_antoniou_gyrator_is_an_inductor():
    """The impedance R1 R3 R5/(R2 · 1/(sC)) of a generalized impedance converter."""
    lines = ["I1 0 1 i_s", "R1 1 2", "R2 2 3", "R3 3 4", "C 4 5", "R5 5 0", "O1 4 0 1 3", "O2 2 0 5 3", "R6 1 0"]
    result = solved(lines, "{task: transfer_function, method: [impedance]}", outputs=["v_1"])
    assert result.status is Status.VERIFIED
    R3, R5, R6 = sp.symbols("R3 R5 R6", real=True)
    Z = s * C * R1 * R3 * R5 / R2
    assert sp.cancel(result.answers["G"] - Z * R6 / (Z + R6)) == 0


def test_values_are_expressions_and_numbers_and_parameters_are_put_in():
    result = solved(
        ["V1 1 0 v_s", "R 1 2 2R_0", "C 2 0 0.5"], "{task: state_space_model, parameters: {R_0: 3}}", outputs=["v_C"]
    )
    assert result.answers["A"] == sp.ImmutableMatrix([[sp.Rational(-1, 3)]])


def test_a_constant_source_leaves_functions_and_no_matrices():
    lines = ["V1 1 0 5", "R 1 2", "C 2 0"]
    result = solved(lines, outputs=["v_C"])
    assert result.status is Status.VERIFIED
    v = sp.Symbol("v_C", real=True)
    assert sp.cancel(result.answers["f"][0] - (5 - v) / (R * C)) == 0
    (part,) = read(lines, "stability", outputs=["v_C"]).parts
    assert "constant source" in str(refusals_of(part, Messages()))


def test_initial_values_are_the_initial_state():
    find = "{task: response, kind: zero_input, parameters: {R: 3, L: 1, C: 1/2}}"
    result = solved(SERIES, find, outputs=["v_C"], initial={"v_C": 2})
    assert result.status is Status.VERIFIED
    assert result.answers["y"].subs(sp.Symbol("t"), 0) == 2


def test_every_task_about_a_plant_takes_a_circuit():
    find = "{task: pole_placement, poles: [-4, -5], parameters: {R: 3, L: 1, C: 1/2}}"
    assert solved(SERIES, find).status is Status.VERIFIED
    loop = "{task: stability, method: routh, controller: K, feedback: unity, parameters: {R: 3, L: 1, C: 1/2}}"
    assert catalogue()["routh_hurwitz"] is not None
    found = solved(SERIES, "{task: routh_hurwitz, controller: K, feedback: unity}", outputs=["v_C"])
    assert found.status is Status.VERIFIED, loop


@pytest.mark.parametrize(
    ("lines", "says"),
    [
        (["V1 1 0 u", "C1 1 2", "C2 2 0", "R 2 0"], ("loop", "C1", "C2", "V1")),
        (["V1 1 0 u", "R 1 2", "C1 2 0", "C2 2 0"], ("loop", "C1", "C2")),
        (["I1 0 1 i_s", "L 1 2", "R 2 0"], ("current", "L", "I1")),
        (["V1 1 0 u", "R1 1 2", "L1 2 3", "L2 2 4", "L3 2 5", "R2 3 0", "R3 4 0", "R4 5 0", "L4 1 0"], ()),
        (["V1 1 0 u", "L1 1 2", "L2 2 3", "R 3 0"], ("L1", "L2")),
        (["V1 1 0 v_s", "C 1 2", "R 2 3", "O1 3 0 0 2"], ("chosen freely",)),
        (["V1 1 0 v_s", "R 1 2", "C 2 0", "O1 3 0 2 0", "R2 3 0"], ("chosen freely", "v_{C} = 0")),
        (["I1 0 1 i_s", "C 1 0", "R 2 1", "R2 2 0", "E1 3 0 3 0 1", "L 3 0"], ("controls itself",)),
        (["V1 1 0 v_s", "R1 1 2", "R2 2 0"], ("no state",)),
    ],
)  # fmt: skip
def test_what_ties_states_together_is_named(lines, says):
    result = solved(lines)
    if not says:
        assert result.status is Status.VERIFIED
        return
    assert result.status is Status.UNSOLVED
    assert all(word in str(result.reason) for word in says), str(result.reason)


def test_impedances_need_no_states():
    lines = ["V1 1 0 u", "C1 1 2", "C2 2 0", "R 2 0"]
    result = solved(lines, "{task: transfer_function, method: impedance}", outputs=["v_2"])
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["G"] - C1 * R * s / ((C1 + C2) * R * s + 1)) == 0
    divider = solved(["V1 1 0 u", "R1 1 2", "R2 2 0"], "{task: transfer_function, method: impedance}", outputs=["v_2"])
    assert sp.cancel(divider.answers["G"] - R2 / (R1 + R2)) == 0
    improper = solved(["V1 1 0 u", "C 1 0"], "{task: transfer_function, method: impedance}", outputs=["i_C"])
    assert improper.status is Status.UNSOLVED


def test_a_hidden_mode_is_named():
    lines = ["V1 1 0 v_s", "R1 1 2", "C1 2 0", "R2 1 3", "C2 3 0"]
    find = "{task: transfer_function, method: impedance, parameters: {R1: 1, C1: 1, R2: 1, C2: 2}}"
    result = solved(lines, find, outputs=["v_C1"])
    assert result.answers["cancelled"] == [sp.Rational(-1, 2)]


@pytest.mark.parametrize(
    ("lines", "more", "at", "says", "suggestion"),
    [
        (["X1 1 0"], {}, "X1", "X1 is no element", ""),
        (["V1 1 0 e", "R1 1 0"], {}, "e", "e is a number here; give the input another name", "e_s"),
        (["I1 1 0 j", "R1 1 0"], {}, "j", "j is a number here; give the input another name", "j_s"),
        (["r1 1 0"], {}, "r1", "r1 is no element", "R1"),
        (["V1 1"], {}, "1", "V1 needs 2 words after its name: V1 NODE NODE VALUE", ""),
        (["E1 1 0 2"], {}, "2", "E1 needs 4 words", ""),
        (["O1 1 0 2 3 5"], {}, "5", "has no value", ""),
        (["V1 1 0 u", "R 1 0", "R 1 0"], {}, "R", "there is an element R above already", ""),
        (["V1 1 0 u", "R 1 1"], {}, "1", "both ends of R are at the node 1", ""),
        (["V1 1 0 u", "R 1 0 10k"], {}, "10k", "would be the product 10·k", "10e3"),
        (["V1 1 0 u", "R 1 0 2 +"], {}, '"', "is expected after +", ""),
        (["V1 1 0 u", "R 1 0 0"], {}, "0", "R is zero", ""),
        (["V1 1 0 2u", "R 1 0"], {}, "2u", "would be the product 2·u", "2e-6"),
        (["V1 1 0 2w", "R 1 0"], {}, "2w", "names an input or is a number", ""),
        (["V1 1 0 u", "F1 1 0 Rlod", "Rload 1 0"], {}, "Rlod", "there is no element Rlod", "Rload"),
        (["V1 1 2 u", "R 1 2"], {}, '"V1 1 2 u"', "no element is at the node 0", ""),
        (["V1 1 0 u", "R 1 0", "L 3 4", "C 3 4"], {}, '"L 3 4"', "leads from the nodes 3, 4", ""),
        (["V1 1 0 u", "R 1 2"], {}, '"R 1 2"', "the node 2 is floating: R alone ends there", ""),
        (["V1 1 0 u", "R 1 0", "O1 2 0 5 2", "R2 2 0"], {}, '"O1 2 0 5 2"', "the node 5 is floating", ""),
        (["V1 1 0 u", "V2 1 0 w", "R 1 0"], {}, '"V2 1 0 w"', "V1 and V2 form a loop of voltage sources", ""),
        (["I1 0 1 u", "I2 1 0 w"], {}, '"I1 0 1 u"', "current sources alone", ""),
        (["V1 1 0 i_R", "R 1 0"], {}, '"V1 1 0 i_R"', "i_R is a voltage or a current of the circuit", ""),
        (["V1 1 0 u", "R 1 0 v_1"], {}, '"R 1 0 v_1"', "v_1 is a voltage or a current", ""),
        (["V1 C 0 u", "C C 0"], {}, '"V1 C 0 u"', "a node and an element are named C", ""),
        (SERIES, {"states": ["i_L", "i_R"]}, "i_R", "i_R is no state: the states are i_L, v_C", "i_L"),
        (SERIES, {"states": ["i_L"]}, '["i_L"]', "v_C is a state too", ""),
        (SERIES, {"outputs": ["v_9"]}, "v_9", "v_9 is no voltage and no current", "v_s"),
        (SERIES, {"outputs": ["R"]}, '"R"', "no voltage and no current occurs", ""),
        (SERIES, {"outputs": ["i_L'"]}, '"i_L\'"', "not of their derivatives", ""),
        (SERIES, {"time": "discrete"}, "circuit", "continuous time", ""),
        (["V1 1- 0 u", "R 1 0"], {}, "1-", "a node is a number or a name", ""),
        (["R+ 1 0", "V1 1 0 u"], {}, "R+", "a name is made of letters", ""),
        (["", "V1 1 0 u"], {}, '""', "an element is expected here", ""),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_netlist_is_said_at_its_place(lines, more, at, says, suggestion):
    found = complaints(lines, **more)
    assert any(place == at and says in message and near == suggestion for place, message, near in found), found


def test_an_output_may_be_an_open_node():
    assert solved(["V1 1 0 u", "R 1 2", "C 1 0 ", "R2 1 0"], outputs=["v_2"]).status is Status.UNSOLVED  # C beside V1
    result = solved(["V1 1 0 u", "R 1 2", "C 2 0", "R2 2 3"], outputs=["v_3"])
    assert result.status is Status.VERIFIED
    assert result.answers["C"] == sp.ImmutableMatrix([[1]])


def test_methods_of_circuits_are_for_circuits():
    find = "find: {a: {task: state_space_model, method: kirchhoff}}"
    source = Source("f.yaml", f'system: {{equations: ["x\' = u"], inputs: u}}\n{find}\n')
    with pytest.raises(InputError) as caught:
        read_problem(source, catalogue())
    assert "kirchhoff is for a circuit" in caught.value.diagnostics[0].message


@st.composite
def ladders(draw):
    """Series and shunt branches in turn behind a source, with random values; every L or C has its resistor."""
    lines, node = ["V1 1 0 u"], 1
    for i in range(draw(st.integers(1, 4))):
        kind, value = draw(st.sampled_from(["L", "R", "RL"])), draw(st.integers(1, 9))
        if kind == "RL":
            lines += [f"Ra{i} {node} m{i} {draw(st.integers(1, 9))}", f"La{i} m{i} {node + 1} {value}"]
        else:
            lines.append(f"{kind}s{i} {node} {node + 1} {value}")
        node += 1
        shunt = draw(st.sampled_from(["C", "R", "CR"]))
        if "C" in shunt:
            lines.append(f"Cp{i} {node} 0 {draw(st.integers(1, 9))}")
        if "R" in shunt:
            lines.append(f"Rp{i} {node} 0 {draw(st.integers(1, 9))}")
    return [*lines, f"Rz {node} 0 1", f"Lz {node} 0 2"]


def chain_of(lines, at):
    """The transfer function of a ladder by its chain matrices: V_in = (A V_out) with no load."""
    M, last = np.eye(2, dtype=complex), 1
    Z = {"R": lambda x: x, "L": lambda x: at * x, "C": lambda x: 1 / (at * x)}
    for line in lines[1:]:
        name, first, second, value = line.split()
        z = Z[name[0]](float(value))
        M = M @ (np.array([[1, 0], [1 / z, 1]]) if second == "0" else np.array([[1, z], [0, 1]]))
        last = first if second == "0" else second
    return 1 / M[0, 0], last


@settings(max_examples=15, deadline=None)
@given(ladders())
def test_ladders_are_what_their_chain_matrices_say(lines):
    at = complex(0.7, 1.3)
    wanted, last = chain_of(lines, at)
    result = solved(lines, outputs=[f"v_{last}"])
    if result.status is Status.UNSOLVED:
        assert "states" in str(result.reason)
        return
    assert result.status is Status.VERIFIED
    A, B, C, D = (np.array(result.answers[name].tolist(), dtype=float) for name in "ABCD")
    found = C @ np.linalg.solve(at * np.eye(len(A)) - A, B) + D
    assert np.isclose(found[0, 0], wanted)
    by_nodes = solved(lines, "{task: transfer_function, method: impedance}", outputs=[f"v_{last}"])
    assert by_nodes.status is Status.VERIFIED
    assert np.isclose(complex(by_nodes.answers["G"].subs(s, at)), wanted)


LADDER = ["V1 1 0 v_s", "R1 1 2", "L1 2 3", "C1 3 0", "R2 3 4", "L2 4 5", "C2 5 0", "R3 5 0"]


def test_the_judge_rejects_any_corrupted_entry():
    circuit = read(LADDER, outputs=["v_5", "i_R1"]).system
    model = circuit_model(circuit)
    rates = [(rate.factor, rate.value) for rate in model.rates]
    states = [rate.state for rate in model.rates]
    assert max(judges.state_residuals(circuit, rates, model.outputs, states)) < 1e-9
    u = sp.Symbol("v_s", real=True)
    for i, (factor, value) in enumerate(rates):
        corrupted = [value + x / 10 for x in (*states, u)] + [-value]
        for wrong in corrupted:
            changed = [*rates[:i], (factor, wrong), *rates[i + 1 :]]
            assert max(judges.state_residuals(circuit, changed, model.outputs, states)) > 1e-4
    for i, output in enumerate(model.outputs):
        for wrong in (*(output + x / 10 for x in (*states, u)), -output):
            changed = [*model.outputs[:i], wrong, *model.outputs[i + 1 :]]
            assert max(judges.state_residuals(circuit, rates, changed, states)) > 1e-4
    exchanged = [(rates[1][0], rates[0][1]), (rates[0][0], rates[1][1]), *rates[2:]]
    assert max(judges.state_residuals(circuit, exchanged, model.outputs, states)) > 1e-4


TWO_BRANCHES = ["V1 1 0 v_s", "R1 1 2", "C1 2 0", "R2 1 3", "C2 3 0"]


def test_the_judge_tells_a_wrong_output_from_a_wrong_frequency():
    circuit = read(TWO_BRANCHES, outputs=["v_2"]).system
    model = circuit_model(circuit)
    rates = [(rate.factor, rate.value) for rate in model.rates]
    states = [rate.state for rate in model.rates]
    transfer, free = judges.state_residuals(circuit, rates, [2 * model.outputs[0]], states)
    assert transfer > 1e-2
    assert free < 1e-9
    unseen = [str(state) for state in states].index("v_C2")
    changed = [(factor, 2 * value if i == unseen else value) for i, (factor, value) in enumerate(rates)]
    transfer, free = judges.state_residuals(circuit, changed, model.outputs, states)
    assert transfer < 1e-9
    assert free > 1e-2


def test_the_judge_of_nodal_analysis_rejects_another_transfer_function():
    circuit = read(LADDER, outputs=["v_5", "i_R1"]).system
    model = nodal_model(circuit, s)
    assert judges.transfer_residual(circuit, model.matrix, s) < 1e-9
    assert judges.frequencies_residual(circuit, model.chi, s) < 1e-9
    for i in range(2):
        for wrong in (-model.matrix[i, 0], 2 * model.matrix[i, 0], model.matrix[i, 0].subs(s, 2 * s)):
            changed = model.matrix.as_mutable()
            changed[i, 0] = wrong
            assert judges.transfer_residual(circuit, sp.ImmutableMatrix(changed), s) > 1e-4
    assert judges.frequencies_residual(circuit, model.chi + 1, s) > 1e-4
    assert judges.transfer_residual(circuit, sp.ImmutableMatrix([[1]]), s) == np.inf


def test_corrupted_answers_are_rejected():
    result = solved(LADDER, outputs=["v_5"])
    task, (part,) = catalogue()["state_space_model"], read(LADDER, outputs=["v_5"]).parts
    asked = given_of(part, part.methods[0], {})
    for name in "ABCD":
        M = result.answers[name]
        assert not any(check.status is CheckStatus.FAILED for check in task.verify(asked, {name: M}))
        for i in range(M.rows):
            for j in range(M.cols):
                wrong = M.as_mutable()
                wrong[i, j] += sp.Rational(1, 50)
                checks = task.verify(asked, {name: sp.ImmutableMatrix(wrong)})
                assert any(check.status is CheckStatus.FAILED for check in checks), (name, i, j)


MARKED = """
system: {circuit: ["V1 1 0 v_s", "R1 1 2", "R2 2 3", "L 3 4", "C 4 0"], outputs: [v_C]}
find: {a: state_space_model, b: {task: transfer_function, method: impedance}}
"""
CONTROLLED = """
system: {circuit: ["V1 1 0 v_s", "R1 1 2", "L 2 0", "H1 3 0 L r", "R2 3 0"], outputs: [v_3]}
find: {a: {task: transfer_function, method: impedance}}
"""


@pytest.mark.parametrize(
    ("problem", "part", "name", "value", "says"),
    [
        (MARKED, "a", "A", "[[-(R1 + R2)/C, -1/C], [1/L, 0]]", "inductance and capacitance are exchanged"),
        (MARKED, "a", "A", "[[-(R1 + R2)/L, 1/L], [-1/C, 0]]", "signs of some entries are reversed"),
        (MARKED, "b", "G", "-1/(L*C*s^2 + (R1 + R2)*C*s + 1)", "sign"),
        (MARKED, "b", "G", "1/(L*C*s^2 + (R1*R2/(R1 + R2))*C*s + 1)", "resistors in series are taken as parallel"),
        (CONTROLLED, "a", "G", "-r/(L*s + R1)", "sign"),
    ],
)
def test_usual_mistakes_are_named(problem, part, name, value, says):
    found = verdict(problem, part, name, f'"{value}"' if name == "G" else value)
    assert found.verdict == "wrong"
    assert says in found.reason, found.reason


def test_right_answers_of_other_forms_are_right():
    rows = {"A": "[[-R1/L - R2/L, -1/L], [1/C, 0]]", "B": "[1/L, 0]", "C": "[0, 1]", "D": "0"}
    for name, value in rows.items():
        assert verdict(MARKED, "a", name, value).verdict == "correct"
    assert verdict(MARKED, "b", "G", '"1/(1 + s*C*(R1 + R2 + s*L))"').verdict == "correct"


DRAWN = {
    "series": SERIES,
    "ladder": LADDER,
    "inverting": INVERTING,
    "sallen_key": SALLEN_KEY,
    "not inverting": ["V1 1 0 v_s", "O1 2 0 1 3", "R2 2 3", "R1 3 0", "C 3 0"],
    "controlled": ["V1 1 0 v_s", "R1 1 2", "C 2 0", "E1 3 0 2 0 mu", "R2 3 0"],
    "bridge": ["V1 1 0 v_s", "R1 1 2", "R2 2 0", "R3 1 3", "R4 3 0", "L 2 3"],
    "parallel": ["I1 0 1 i_s", "R 1 0 2", "L 1 0", "C 1 0 1/2"],
}


def drawing(lines):
    (figure,) = schematic_of(read(lines).system)
    return figure


@pytest.mark.parametrize("name", DRAWN)
def test_a_drawing_joins_what_the_netlist_joins(name):
    """Ends that wires join are one node, and every element lies between its own."""
    layout = layout_of(drawing(DRAWN[name]))
    joined = {}

    def root(p):
        while joined.get(p, p) != p:
            p = joined[p]
        return p

    segments = [pair for wire in layout.wires for pair in pairwise(wire)]
    points = {p for pair in segments for p in pair} | {p for each in layout.placed for p in (each.start, each.end)}
    points |= {p for each in layout.amplifiers for p in (each.upper, each.lower, each.output)} | {*layout.grounds}
    for a, b in segments:
        for p in points:
            on = min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])
            if on:
                joined[root(p)] = root(a)
    nodes = {}
    for each in layout.placed:
        for place, node in zip((each.start, each.end), each.component.nodes, strict=True):
            nodes.setdefault(node, set()).add(root(place))
    for each in layout.amplifiers:
        plus, minus = each.component.inputs
        above, below = (minus, plus) if each.minus_above else (plus, minus)
        for place, node in ((each.upper, above), (each.lower, below), (each.output, each.component.nodes[0])):
            nodes.setdefault(node, set()).add(root(place))
    grounds = {root(place) for place in layout.grounds}
    assert nodes.pop("0") <= grounds
    assert all(len(places) == 1 for places in nodes.values()), nodes
    assert len({*nodes[next(iter(nodes))]}) == 1
    assert len(set().union(*nodes.values()) | grounds) == len(nodes) + len(grounds)


@pytest.mark.parametrize("name", DRAWN)
def test_nothing_in_a_drawing_lies_on_anything_else(name):
    layout = layout_of(drawing(DRAWN[name]))
    spans = [(each.start, each.end) for each in layout.placed]
    middles = [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in spans]
    assert len(set(middles)) == len(middles)
    for wire in layout.wires:
        for (x0, y0), (x1, y1) in pairwise(wire):
            assert x0 == x1 or y0 == y1
            low, high = sorted((x0, x1)), sorted((y0, y1))
            assert not any(low[0] - 0.2 < x < low[1] + 0.2 and high[0] - 0.2 < y < high[1] + 0.2 for x, y in middles)


def test_drawings_are_the_same_each_time_and_say_what_is_seen():
    figure = drawing(SALLEN_KEY)
    assert figures.svg(figure) == figures.svg(figure)
    assert "circle" in figures.tikz(drawing(LADDER))
    told = drawing_of(figure).alt
    assert "O1: output 4, inputs 3 (plus) and 4 (minus)" in told
    assert "C1 from node 2 to node 4" in told


def test_what_cannot_be_laid_out_well_is_not_drawn():
    lines = ["I1 0 1 i_s", "R1 1 2", "R2 2 3", "R3 3 4", "C 4 5", "R5 5 0", "O1 4 0 1 3", "O2 2 0 5 3", "R6 1 0"]
    assert schematic_of(read(lines).system) == ()
