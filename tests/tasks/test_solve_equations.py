"""Equations solved for some unknowns: laws of elements, linear systems, curves, angles, complex roots."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Answers, CheckStatus, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue


def read(equations, unknowns, more=""):
    options = f"equations: {equations}, unknowns: {unknowns}{', ' if more else ''}{more}"
    return read_problem(Source("file.yaml", f"find:\n  a: {{task: solve_equations, {options}}}\n"), catalogue())


def solutions(equations, unknowns, more=""):
    result = solve_problem(read(equations, unknowns, more)).parts[0]
    assert result.status is Status.VERIFIED, result.reason
    return [{str(name): value for name, value in point.items()} for point in result.answers["solutions"]]


def rejected(equations, unknowns, found, more=""):
    task, part = catalogue()["solve_equations"], read(equations, unknowns, more).parts[0]
    given_part = task.given(part.system, part.options)
    named = {x.name: x for x in part.options["unknowns"]}
    symbols = [{named[name]: sp.S(value) for name, value in point.items()} for point in found]
    return any(check.status is CheckStatus.FAILED for check in task.verify(given_part, Answers(solutions=symbols)))


def test_laws_of_a_magnetic_circuit_with_all_symbols():
    A, R = sp.symbols("A R", positive=True)
    N, i = sp.symbols("N i", real=True)
    (found,) = solutions('["Phi = B A", "F = N i", "F = R Phi"]', "[B, Phi, F]", "assume: {A: positive, R: positive}")
    assert found == {"B": N * i / (A * R), "Phi": N * i / R, "F": N * i}


def test_what_is_assumed_of_an_unknown_decides_among_roots():
    law, positive = '["B^2 A/(2 mu) = F"]', "B: positive, A: positive, mu: positive, F: positive"
    (found,) = solutions(law, "[B]", f"assume: {{{positive}}}")
    A, mu, F = sp.symbols("A mu F", positive=True)
    assert found["B"].equals(sp.sqrt(2 * mu * F / A))
    assert len(solutions(law, "[B]", f"assume: {{{positive.removeprefix('B: positive, ')}}}")) == 2
    assert rejected(law, "[B]", [{"B": sp.sqrt(2 * mu * F / A)}, {"B": -sp.sqrt(2 * mu * F / A)}],
                    f"assume: {{{positive}}}")  # fmt: skip


def test_gears_and_levers():
    found = solutions('["r1 theta1 = r2 theta2", "tau1/r1 = tau2/r2"]', "[theta2, tau2]")
    r1, r2, theta, tau = sp.symbols("r1 r2 theta1 tau1", real=True)
    assert found == [{"theta2": r1 * theta / r2, "tau2": r2 * tau / r1}]


matrices = st.lists(st.lists(st.integers(-4, 4), min_size=3, max_size=3), min_size=3, max_size=3)


@settings(max_examples=12)
@given(matrices, st.lists(st.integers(-3, 3), min_size=3, max_size=3))
def test_linear_systems_as_numpy_solves_them(A, x):
    if abs(np.linalg.det(A)) < 1e-9:
        return
    b = np.array(A) @ x
    texts = [f"({r[0]})*x1 + ({r[1]})*x2 + ({r[2]})*x3 = {c}" for r, c in zip(A, b, strict=True)]
    if any(text.startswith("(0)*x1 + (0)*x2 + (0)*x3") for text in texts):
        return
    (found,) = solutions(str(texts).replace("'", '"'), "[x1, x2, x3]")
    assert found == {f"x{i}": value for i, value in enumerate(x, 1)}


def test_fewer_equations_leave_an_unknown_free():
    z = sp.Symbol("z", real=True)
    assert solutions('["x - y + z = 1", "x + y = 3"]', "[x, y, z]") == [{"x": 2 - z / 2, "y": 1 + z / 2, "z": z}]


def test_curves_that_meet():
    assert [tuple(p.values()) for p in solutions('["x^2 + y^2 = 25", "x y = 12"]', "[x, y]")] == [
        (-4, -3), (-3, -4), (3, 4), (4, 3)]  # fmt: skip
    assert solutions('["x^2 + y^2 = -1"]', "[x, y]") == []


def test_polynomials_without_roots_in_closed_form_are_in_decimals():
    found = solutions('["x^2 + y^2 = 5", "x^3 + y - x y^2 = 1"]', "[x, y]")
    assert len(found) == 6
    assert {"x": -1, "y": -2} in found
    for point in found:
        a, b = point["x"], point["y"]
        assert abs(a**2 + b**2 - 5) < 1e-12
        assert abs(a**3 + b - a * b**2 - 1) < 1e-12


def test_sine_and_cosine_of_one_angle():
    n = sp.Symbol("n", integer=True)
    pi = sp.pi
    assert solutions('["sin(a) - sqrt(3) cos(a) = 1"]', "[a]") == [
        {"a": 2 * pi * n - 5 * pi / 6}, {"a": 2 * pi * n + pi / 2}]  # fmt: skip
    assert solutions('["sin(a) cos(a) = 0"]', "[a]") == [{"a": pi * n / 2}]
    assert solutions('["sin(a) = 2"]', "[a]") == []


def test_complex_roots_where_they_are_assumed():
    found = solutions('["w^2 + 2w + 5 = 0"]', "[w]", "assume: {w: complex}")
    assert [p["w"] for p in found] == [-1 - 2 * sp.I, -1 + 2 * sp.I]
    assert solutions('["w^2 + 2w + 5 = 0"]', "[w]") == []
    assert rejected('["w^2 + 2w + 5 = 0"]', "[w]", [{"w": -1 - 2 * sp.I}, {"w": -1 + 2 * sp.I}])


def test_a_point_where_a_divisor_vanishes_is_none():
    result = solve_problem(read('["sin(x)/x = 0"]', "[x]")).parts[0]
    assert result.status is Status.VERIFIED
    step = result.steps[-1]
    assert str(step.values["needs"]) == "[(Ne(n, 0),)]"


@pytest.mark.parametrize(
    ("equations", "unknowns", "message"),
    [
        ('["x + y = 3"]', "[x, x]", "given twice"),
        ('["x + y = 3"]', "[]", "the list is empty"),
        ("[]", "[x]", "the list is empty"),
        ('["x = x"]', "[x]", "both sides"),
        ('["x + = 3"]', "[x]", ""),
    ],
)
def test_bad_input_is_refused_at_its_place(equations, unknowns, message):
    with pytest.raises(InputError) as caught:
        read(equations, unknowns)
    assert any(message in each.message and each.line == 2 for each in caught.value.diagnostics)


def test_an_unknown_that_occurs_nowhere_is_refused():
    with pytest.raises(InputError, match="occurs in no equation"):
        solve_problem(read('["x + y = 3"]', "[q]"))
