"""Functionals as problems give them: what is read, and what is wrong with them at its place."""

from __future__ import annotations

import pytest
import sympy as sp

from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems.ends import End
from solver.tasks import catalogue

t, x, v, x1, x2, v1, v2, u = (sp.Symbol(name, real=name != "t" or None) for name in
                              ("t", "x", "x_dot", "x1", "x2", "x1_dot", "x2_dot", "u"))  # fmt: skip


def read(functional, find="extremal"):
    text = f"system: {{functional: {{{functional}}}}}\nfind: {{a: {find}}}\n"
    return read_problem(Source("file.yaml", text), catalogue()).parts[0].system


def complaint(functional):
    with pytest.raises(InputError) as caught:
        read(functional)
    return [f"{e.column} {e.message} {e.suggestion} {e.note}".strip() for e in caught.value.diagnostics]


def test_integrands_hold_the_time_functions_and_derivatives():
    system = read('integrand: "t x^2 - x\'^2", from: 0, to: pi/2, ends: {x: [0, 1]}')
    assert system.integrand == t * x**2 - v**2
    assert (system.functions, system.start, system.stop) == (("x",), 0, sp.pi / 2)
    assert system.ends == {("x", 0): (End(sp.Integer(0)), End(sp.Integer(1)))}
    assert system.orders == {"x": 1}


def test_ends_are_values_free_or_on_a_curve():
    system = read(
        'integrand: "x\'\'^2", from: 0, to: free, ends: {x: [a, {on: 2 - t}], "x\'": [0, free]}, terminal_cost: t_f'
    )
    assert system.stop is None
    assert system.ends[("x", 0)] == (End(sp.Symbol("a", real=True)), End(curve=2 - t))
    assert system.ends[("x", 1)][1].free
    assert system.terminal_cost == t
    assert system.orders == {"x": 2}


def test_constraints_are_equations_or_integrals():
    system = read(
        'integrand: u^2/2, functions: [x1, x2, u], from: 0, to: 1, constraints: ["x1\' = x2", "x2\' = u"], '
        "integral_constraints: [{integrand: x1, value: 3}]"
    )
    assert system.constraints == ((v1, x2), (v2, u))
    assert [(each.integrand, each.value) for each in system.integral_constraints] == [(x1, 3)]
    assert system.multipliers == ("lambda1", "lambda2", "lambda3")


def test_what_is_assumed_of_a_function_holds_of_it():
    text = 'assume: {x: positive}\nsystem: {functional: {integrand: "sqrt((1 + x\'^2)/x)", from: 0, to: 1}}\n'
    found = read_problem(Source("file.yaml", text + "find: {a: extremal}\n"), catalogue()).parts[0].system
    (symbol,) = found.symbols()
    assert symbol.is_positive
    assert found.integrand == sp.sqrt(1 + v**2) / sp.sqrt(symbol)


PLAIN = "integrand: x'^2, from: 0, to: 1"


@pytest.mark.parametrize(
    ("functional", "says"),
    [
        ("integrand: x'^2, to: 1", "22 'from' is missing here"),
        ("integrand: x^2, from: 0, to: 1", "34 no function occurs with a derivative"),
        (f"{PLAIN}, functions: [x, y]", "71 'y' occurs nowhere"),
        (f"{PLAIN}, ends: {{x: [0, 1, 2]}}", "66 two ends are expected here"),
        (f"{PLAIN}, ends: {{x: [t, 1]}}", "67 a value at an end is no function of t  a curve is written {on: 2 - t}"),
        (f"{PLAIN}, ends: {{y: [0, 1]}}", "63 'y' is none of the functions"),
        (f"{PLAIN}, ends: {{\"x'\": [0, 1]}}", "63 nothing can be asked of this at an end"),
        (f"{PLAIN}, ends: {{x: [0, {{on: t}}]}}", "70 an end on a curve needs to: free"),
        ("integrand: x'^2, from: 0, to: free, ends: {x: [{on: t}, 0]}", "70 only the last end may lie on a curve"),
        ("integrand: x''^2, from: 0, to: free, ends: {\"x'\": [0, {on: t}]}", "77 a function may end on a curve"),
        (f"{PLAIN}, ends: {{x: [0, {{onn: t}}]}}", "71 unknown key 'onn' on"),
        (f"{PLAIN}, ends: {{x: [0, [1]]}}", "70 a value, free or {on: curve} is expected here"),
        (f"{PLAIN}, terminal_cots: x^2", "56 unknown key 'terminal_cots' terminal_cost"),
        ("integrand: x'^2, from: t, to: 1", "46 this is to be a value, no function of t"),
        ("integrand: x'^2, from: 1, to: 1", "53 the last time is to be after the first one"),
        ("integrand: x'^2, from: free, to: 1", "46 only the end of the time may be free"),
        ("integrand: lambda1 x'^2, functions: x, from: 0, to: 1, constraints: [x' = u]", "'lambda1' is the multiplier"),
        (f"{PLAIN}, integral_constraints: [{{integrand: x}}]", "'value' is missing here"),
        ("integrand: x'^2 + y', functions: [x], from: 0, to: 1", "y is not a function of time"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_at_its_place(functional, says):
    found = complaint(functional)
    assert any(says in message for message in found), found


def test_a_functional_is_no_plant():
    with pytest.raises(InputError) as caught:
        read(PLAIN, "controllability")
    assert "functional" in str(caught.value)


def test_a_functional_is_continuous():
    text = f"system: {{time: discrete, functional: {{{PLAIN}}}}}\nfind: {{a: extremal}}\n"
    with pytest.raises(InputError) as caught:
        read_problem(Source("file.yaml", text), catalogue())
    assert "a functional is an integral over continuous time" in str(caught.value)
