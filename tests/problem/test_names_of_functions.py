"""A wrong name of a state or an input is a fault at its place with a suggestion, for every kind of system."""

import pytest

from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

SYSTEMS = {
    "equations": ("""equations: ["m theta'' + sin(theta) = u"], inputs: [u]""", "thet", "theta"),
    "lagrangian": (
        """lagrangian: {coordinates: [theta], kinetic: "m theta'^2/2", potential: "-cos(theta)", forces: {theta: u}},
        inputs: [u]""",
        "thet",
        "theta",
    ),
    "circuit": ("""circuit: ["V1 1 0 v_s", "R 1 2", "L 2 3", "C 3 0"]""", "v_c", "v_C"),
}
ASKED = (
    "{task: linearization, at: {NAME: 0}}",
    "{task: linearization, at: {NAME_dot: 0}}",
    "{task: equilibrium_points, inputs: {NAME: 0}}",
    "{task: equilibrium_points, unknowns: [NAME]}",
    "{task: equilibrium_points, between: {NAME: [0, 1]}}",
)
BESIDE = ("states: [NAME]", "initial: {NAME: 1}", "outputs: [NAME]")


def faults(text):
    with pytest.raises(InputError) as caught:
        read_problem(Source("f.yaml", text), catalogue())
    return caught.value.diagnostics


@pytest.mark.parametrize("kind", SYSTEMS)
@pytest.mark.parametrize("asked", ASKED)
def test_a_wrong_name_in_a_question(kind, asked):
    system, wrong, meant = SYSTEMS[kind]
    line = f"find: {{a: {asked.replace('NAME', wrong)}}}"
    (fault,) = faults(f"{line}\nsystem: {{{system}}}\n")
    assert (fault.line, fault.column) == (1, line.index(wrong) + 1)
    if "inputs" not in asked:
        assert meant in str(fault)


@pytest.mark.parametrize("kind", SYSTEMS)
@pytest.mark.parametrize("beside", BESIDE)
def test_a_wrong_name_beside_the_system(kind, beside):
    system, wrong, meant = SYSTEMS[kind]
    line = f"system: {{{beside.replace('NAME', wrong)}, {system}}}"
    fault, *_ = faults(f"{line}\nfind: {{a: state_space_model}}\n")
    assert (fault.line, fault.column) == (1, line.index(wrong) + 1)
    assert meant in str(fault)


@pytest.mark.parametrize("asked", ["linearization, at: {x: -2, u: 0}", "equilibrium_points, inputs: {u: 0}"])
def test_a_value_that_contradicts_what_is_assumed(asked):
    system = """system: {equations: ["x' = 4 - x^2 + u"], inputs: [u]}"""
    text = f"assume: {{x: positive, u: negative}}\n{system}\nfind: {{a: {{task: {asked}}}}}\n"
    assert all("contradicts what is assumed" in str(each) for each in faults(text))


def test_an_output_that_is_a_number_is_no_mistyped_name():
    text = 'system: {equations: ["x\' = -x"], outputs: [0 x]}\nfind: {a: state_space_model}\n'
    assert read_problem(Source("f.yaml", text), catalogue()).parts
