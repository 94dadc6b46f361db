"""Variations of functionals: steps, textbook values, corruptions, mistakes, marking."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.classroom.verdicts import Verdict
from solver.derivation import CheckStatus, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.helpers.marked import verdict

TASK = "functional_variation"
NAMES = {name: sp.Symbol(name, real=True) for name in ("x", "x_dot", "x_ddot", "dx", "dx_dot", "dx_ddot", "a")}
NAMES["t"] = sp.Symbol("t")


def text(integrand, more="functions: [x], ends: {x: [0, 1]}"):
    return f'system: {{functional: {{integrand: "{integrand}", from: 0, to: 1, {more}}}}}\nfind: {{a: {TASK}}}\n'


def read(integrand, more="functions: [x], ends: {x: [0, 1]}"):
    return read_problem(Source("file.yaml", text(integrand, more)), catalogue())


def solved(*arguments):
    return solve_problem(read(*arguments)).parts[0]


def expression(written):
    return sp.sympify(written, locals=NAMES)


def rejected(integrand, more="functions: [x]", **answers):
    task, part = catalogue()[TASK], read(integrand, more).parts[0]
    checks = list(task.verify(task.given(part.system, {}), answers))
    return not checks or any(check.status is CheckStatus.FAILED for check in checks)


TEXTBOOK = [
    # Kirk, example 4.1-3; the course, 5.6 examples 1 and 2; Elsgolc, chapter VI; Naidu, example 2.1
    ("x^2 + 2x x'", "2*x*dx + 2*x_dot*dx + 2*x*dx_dot + dx**2 + 2*dx*dx_dot", "2*(x + x_dot)*dx + 2*x*dx_dot"),
    ("2x^2 + 1", "4*x*dx + 2*dx**2", "4*x*dx"),
    ("x'^2 + 12 x t", "2*x_dot*dx_dot + 12*t*dx + dx_dot**2", "2*x_dot*dx_dot + 12*t*dx"),
    ("2x^2 + 3x + 4", "4*x*dx + 3*dx + 2*dx**2", "(4*x + 3)*dx"),
]


@pytest.mark.parametrize(("integrand", "increment", "first"), TEXTBOOK)
def test_textbook_variations(integrand, increment, first):
    result = solved(integrand)
    assert result.status is Status.VERIFIED
    assert sp.expand(result.answers["increment"] - expression(increment)) == 0
    assert sp.expand(result.answers["first_variation"] - expression(first)) == 0


def test_the_steps_are_those_of_a_board():
    kinds = [step.kind for step in solved("t x^3 + x'^2").steps]
    assert kinds == ["increment", "first_variation", "second_variation", "higher", "by_parts"]
    assert [step.kind for step in solved("2x^2 + 1").steps] == ["increment", "first_variation", "second_variation"]


def test_a_second_derivative_is_integrated_by_parts_twice():
    step = solved("x''^2/2 - a x").steps[-1]
    assert step.values["factors"] == [(NAMES["dx"], sp.Symbol("x_d4", real=True) - NAMES["a"])]
    momenta = [(sp.expand(p), d) for p, d in step.values["ends"]]
    assert momenta == [(-sp.Symbol("x_dddot", real=True), NAMES["dx"]), (NAMES["x_ddot"], NAMES["dx_dot"])]


@settings(max_examples=12, deadline=None)
@given(
    st.lists(st.integers(-4, 4), min_size=4, max_size=4), st.sampled_from(["x", "sin(x)", "exp(a x)", "sqrt(1+x^2)"])
)
def test_the_parts_are_those_of_taylor(numbers, function):
    p, q, r, s = numbers
    p = p or 5
    integrand = f"({p}) x'^2 + ({q}) x x' + ({r}) {function} + ({s}) t x'"
    result = solved(integrand)
    assert result.status is Status.VERIFIED
    eps = sp.Symbol("eps")
    plain = function.replace("^", "**").replace("a x", "a*x")
    phi = expression(f"({p})*x_dot**2+({q})*x*x_dot+({r})*{plain}+({s})*t*x_dot")
    changes = {NAMES[q]: NAMES[q] + eps * NAMES[f"d{q}"] for q in ("x", "x_dot")}
    moved = phi.subs(changes, simultaneous=True)
    point = {symbol: sp.Rational(i + 2, 7) for i, symbol in enumerate(NAMES.values())}
    for n, name in ((1, "first_variation"), (2, "second_variation")):
        wanted = (sp.diff(moved, eps, n).subs(eps, 0) / sp.factorial(n)).subs(point)
        assert abs(sp.N(wanted - result.answers[name].subs(point), 30)) < 1e-20


def test_corrupted_variations_are_rejected():
    first, second = expression("2*x_dot*dx_dot + 3*t*x**2*dx"), expression("dx_dot**2 + 3*t*x*dx**2")
    assert not rejected("t x^3 + x'^2", first_variation=first, second_variation=second)
    for wrong in (-first, 2 * first, first + NAMES["dx"], expression("2*x_dot*dx_dot")):
        assert rejected("t x^3 + x'^2", first_variation=wrong)
    for wrong in (2 * second, first + second, expression("dx_dot**2 + 6*t*x*dx**2")):
        assert rejected("t x^3 + x'^2", second_variation=wrong)
    assert rejected("t x^3 + x'^2", increment=first + second)


def test_with_fixed_ends_the_variation_may_be_integrated_by_parts():
    by_parts = expression("(3*t*x**2 - 2*x_ddot)*dx")
    assert not rejected("t x^3 + x'^2", "functions: [x], ends: {x: [0, 1]}", first_variation=by_parts)
    assert rejected("t x^3 + x'^2", "functions: [x], ends: {x: [0, free]}", first_variation=by_parts)


@pytest.mark.parametrize(
    ("answer", "wrote", "slip"),
    [
        ("second_variation", "2dx_dot^2 + 6 t x dx^2", "half"),
        ("first_variation", "3 t x^2 dx", "derivative"),
        ("second_variation", "2 x_dot dx_dot + 3 t x^2 dx + dx_dot^2 + 3 t x dx^2", "first_kept"),
        ("first_variation", "2 x' dx' + 3 t x^2 dx + dx'^2 + 3 t x dx^2 + t dx^3", "whole"),
    ],
)
def test_usual_mistakes_are_named(answer, wrote, slip):
    found = verdict(text("t x^3 + x'^2"), "a", answer, f'"{wrote}"')
    assert found.verdict is Verdict.WRONG
    assert found.mistake == slip


def test_a_student_may_write_primes():
    found = verdict(text("t x^3 + x'^2"), "a", "first_variation", "\"2x'*dx' + 3t x^2 dx\"")
    assert found.verdict is Verdict.CORRECT
