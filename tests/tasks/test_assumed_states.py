"""What is assumed of states and inputs holds in every question about the equations, however they are given."""

import json

import pytest
import sympy as sp

import solver
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

ONE = """system: {equations: ["x' = 4 - x^2 + u"], inputs: [u]}"""
TANKS = """assume: {h1: positive, h2: positive, a: positive, g: positive, S: positive, q: positive}
system:
  equations: ["S h1' = q - a sqrt(2 g h1)", "S h2' = a sqrt(2 g h1) - a sqrt(2 g h2)"]
  inputs: [q]
find: {a: equilibrium_points, b: {task: linearization, at: {from: a}}}
"""
MAGNET = """assume: {m: positive, g: positive, c: positive, y: positive, i: positive}
system:
  lagrangian: {coordinates: [y], kinetic: "m y'^2/2", potential: "-m g y", forces: {y: "-c i^2/y^2"}}
  inputs: [i]
find: {a: equilibrium_points, b: {task: linearization, at: {from: a}}, c: state_space_model}
"""


def answers(text, part="a"):
    """The answers of a part as the result has them, once all parts are verified."""
    data = json.loads(solver.solve(text).json())
    assert {each["id"]: each["status"] for each in data["parts"]} == {each["id"]: "verified" for each in data["parts"]}
    found = next(each for each in data["parts"] if each["id"] == part)
    return {name: each["value"] for name, each in found["answers"].items()}


@pytest.mark.parametrize(
    ("assume", "inputs", "points"),
    [
        ("x: positive", ", inputs: {u: 0}", "[{x: 2}]"),
        ("x: negative", ", inputs: {u: 0}", "[{x: -2}]"),
        ("x: positive", "", "[{x: sqrt(4 + u)}]"),
        ("x: real", ", inputs: {u: 0}", "[{x: -2}, {x: 2}]"),
        ("x: nonzero", ", inputs: {u: -4}", "[]"),
    ],
)
def test_points_are_those_that_are_assumed(assume, inputs, points):
    found = answers(f"assume: {{{assume}}}\n{ONE}\nfind: {{a: {{task: equilibrium_points{inputs}}}}}\n")
    assert found["points"] == points


def test_samples_are_what_is_assumed_of_their_function():
    system = 'time: discrete, equations: ["x(k+1) = x(k) + 4 - x(k)^2"]'
    found = answers(f"assume: {{x: negative}}\nsystem: {{{system}}}\nfind: {{a: equilibrium_points}}\n")
    assert found["points"] == "[{x(k): -2}]"


def test_roots_of_positive_levels_and_flows_need_no_absolute_values():
    found = answers(TANKS, "b")
    assert "conditions" not in found
    assert found["A"] == "Matrix([[-g*a**2/(S*q), 0], [g*a**2/(S*q), -g*a**2/(S*q)]])"


def test_equations_made_of_energies_keep_what_is_assumed():
    found = answers(MAGNET, "b")
    g, m, c, i = sp.symbols("g m c i", positive=True)
    names = {"g": g, "m": m, "c": c, "i": i}
    assert sp.sympify(found["A"], locals=names)[1, 0] == 2 * g * sp.sqrt(m * g / c) / i


def test_a_root_of_a_square_has_the_sign_that_is_assumed():
    system = """system: {equations: ["x' = sqrt(x^2) - 3 + u"], inputs: [u]}"""
    found = answers(f"assume: {{x: negative}}\n{system}\nfind: {{a: state_space_model}}\n")
    assert found["f"] == "Matrix([[-3 + u - x]])"


@pytest.mark.parametrize("word", ["complex", "integer"])
def test_a_function_of_time_is_real(word):
    with pytest.raises(InputError) as caught:
        read_problem(Source("f.yaml", f"assume: {{x: {word}}}\n{ONE}\nfind: {{a: equilibrium_points}}\n"), catalogue())
    assert [(each.line, each.column) for each in caught.value.diagnostics] == [(1, 13)]
