"""Laplace transforms by rules: steps, answers against mpmath and sympy, corruptions, refusals, marking."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Answers, CheckStatus, Status
from solver.displayed import judged
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.render.wording import Wording
from solver.tasks import catalogue
from tests.helpers.marked import verdict

S, T = sp.symbols("s t")


def text(f, more=""):
    return f'find:\n  a: {{task: laplace_transform, f: "{f}"{more}}}\n'


def asked(f, more=""):
    return solve_problem(read_problem(Source("file.yaml", text(f, more)), catalogue())).parts[0]


def transform(f, more=""):
    result = asked(f, more)
    assert result.status is Status.VERIFIED, result.reason
    assert not [check for check in result.checks if check.status is CheckStatus.SKIPPED]
    return result.answers["F"]


def rejected(f, F):
    task = catalogue()["laplace_transform"]
    part = read_problem(Source("file.yaml", text(f)), catalogue()).parts[0]
    checks = list(task.verify(task.given(part.system, part.options), Answers(F=F)))
    return any(check.status is CheckStatus.FAILED for check in checks)


TEXTBOOK = {
    "5": 5 / S,
    "t^4": 24 / S**5,
    "3exp(-2t) + 2cos(3t)": 3 / (S + 2) + 2 * S / (S**2 + 9),
    "exp(-t) sin(2t)": 2 / ((S + 1) ** 2 + 4),
    "t exp(-2t)": 1 / (S + 2) ** 2,
    "t sin(3t)": 6 * S / (S**2 + 9) ** 2,
    "t^2 cos(t)": 2 * S * (S**2 - 3) / (S**2 + 1) ** 3,
    "sinh(2t)": 2 / (S**2 - 4),
    "exp(-t) cosh(2t)": (S + 1) / ((S + 1) ** 2 - 4),
    "sin(2t + pi/3)": (2 * sp.Rational(1, 2) + sp.sqrt(3) / 2 * S) / (S**2 + 4),
    "step(t - 3)": sp.exp(-3 * S) / S,
    "(t - 1) step(t - 1)": sp.exp(-S) / S**2,
    "t step(t - 1)": sp.exp(-S) * (1 / S**2 + 1 / S),
    "sin(t) step(t - pi)": -sp.exp(-sp.pi * S) / (S**2 + 1),
    "delta(t - 2)": sp.exp(-2 * S),
    "t^2 delta(t - 3)": 9 * sp.exp(-3 * S),
    "1 - step(t - 2)": (1 - sp.exp(-2 * S)) / S,
    "sin(t) cos(t)": 1 / (S**2 + 4),
    "sin(t)^2": sp.Rational(1, 2) / S - S / (2 * (S**2 + 4)),
}


@pytest.mark.parametrize("f", TEXTBOOK)
def test_transforms_of_the_textbooks(f):
    found = transform(f)
    for point in (sp.Rational(7, 5), 2 + sp.I):
        assert abs(sp.N((found - TEXTBOOK[f]).subs(S, point), 30)) < 1e-25


def test_each_rule_is_a_line():
    (step, *_rest) = asked("t exp(-2t) sin(3t)").steps
    assert step.kind == "by_rules"
    found = [claim.right for name, claim in step.claims.items() if name != "slope"]
    wanted = [3 / (S**2 + 9), 6 * S / (S**2 + 9) ** 2, 6 * (S + 2) / ((S + 2) ** 2 + 9) ** 2]
    assert [sp.expand(a - b) for a, b in zip(found, wanted, strict=True)] == [0, 0, 0]


def test_the_table_has_exactly_the_rules_used():
    rules = asked("3t exp(-2t) sin(3t) step(t)").steps[-1]
    assert rules.kind == "rules"
    assert rules.values["used"] == ["linearity", "sin", "damping", "derivative"]
    assert asked("t").steps[-1].values["used"] == ["power"]
    assert asked("delta(t - 1)").steps[-1].values["used"] == ["impulse"]


def test_a_function_behind_a_step_is_written_in_the_time_since():
    moved = next(step for step in asked("t^2 step(t - 1)").steps if step.kind == "moved")
    tau = sp.Symbol("tau")
    assert moved.claims["f"].right == tau**2 + 2 * tau + 1


def test_each_delay_has_its_own_time_since():
    """τ is t − 1 in one step and t − 2 in another; what one page says of both holds in each."""
    source = Source("file.yaml", text("(2 - t)(step(t - 1) - step(t - 2))"))
    problem, wording = read_problem(source, catalogue()), Wording(detail="tutor")
    result = solve_problem(problem).parts[0]
    worded = [wording.word(step) for step in result.steps]
    assert "".join(step.markdown for step in worded).count("what stands behind the step") == 2
    said = judged(result, problem.parts[0], worded, wording)
    assert said.status is Status.VERIFIED
    assert {check.status for check in said.checks} == {CheckStatus.PASSED}


def test_parameters_and_what_is_assumed():
    a, omega = sp.symbols("a omega", real=True)
    assert transform("exp(-a t) cos(omega t)") == (S + a) / ((S + a) ** 2 + omega**2)
    late = sp.Symbol("T", positive=True)
    assert transform("step(t - T)", ", assume: {T: positive}") == sp.exp(-late * S) / S


waves = st.sampled_from(["", "sin", "cos", "sinh"])
terms = st.tuples(
    st.integers(-4, 4), st.integers(0, 3), st.integers(-3, 1), waves, st.integers(1, 3), st.integers(0, 2)
)


@settings(max_examples=12, deadline=None)
@given(st.lists(terms, min_size=1, max_size=3))
def test_generated_functions_against_quadrature(drawn):
    parts = []
    for c, n, growth, wave, angle, late in drawn:
        shape = f"{wave}({angle}t)" if wave else "1"
        parts.append(f"({c})*t^{n}*exp({growth}t)*{shape}*step(t - {late})")
    found = transform(" + ".join(parts))
    point = mpmath.mpc(6, 1.3)

    def f(t):
        total = mpmath.mpf(0)
        for c, n, growth, wave, angle, late in drawn:
            if t >= late:
                shape = getattr(mpmath, wave)(angle * t) if wave else 1
                total += c * t**n * mpmath.exp(growth * t) * shape
        return total

    wanted = mpmath.quad(lambda t: f(t) * mpmath.exp(-point * t), [0, 1, 2, 3, 5, 8, 14, 25])
    assert abs(complex(sp.N(found.subs(S, sp.Float(6) + sp.Float("1.3") * sp.I))) - complex(wanted)) < 1e-9


@pytest.mark.parametrize(
    ("f", "wrong"),
    [
        ("t exp(-2t)", 1 / (S - 2) ** 2),
        ("t^3", 1 / S**4),
        ("sin(2t)", S / (S**2 + 4)),
        ("sin(2t)", 1 / (S**2 + 4)),
        ("step(t - 1)", 1 / S),
        ("step(t - 1)", sp.exp(S) / S),
        ("t step(t - 1)", sp.exp(-S) / S**2),
        ("delta(t - 1) + exp(-t)", 1 / (S + 1)),
        ("1", sp.Rational(1001, 1000) / S),
    ],
)
def test_corrupted_transforms_are_rejected(f, wrong):
    assert rejected(f, wrong)
    assert not rejected(f, transform(f))


@pytest.mark.parametrize(
    ("f", "says"),
    [
        ("exp(t^2)", "not rational"),
        ("1/t", "not rational"),
        ("delta(t)*delta(t-1)", "product of impulses"),
        ("step(t - b)", "under `assume`"),
        ("exp(j t)", "real"),
    ],
)
def test_other_functions_are_refused_at_their_place(f, says):
    with pytest.raises(InputError) as raised:
        asked(f)
    assert says in str(raised.value)
    assert "file.yaml:2:35" in str(raised.value)


def test_a_name_that_is_no_function_is_an_error_with_its_place():
    with pytest.raises(InputError) as raised:
        read_problem(Source("file.yaml", text("sinn(2t)")), catalogue())
    assert "sinn" in str(raised.value)


@pytest.mark.parametrize("form", ["(s + 4)/((s + 1)(s + 2))", "3/(s + 1) - 2/(s + 2)", "(s+4)/(s^2 + 3s + 2)"])
def test_equivalent_forms_are_right(form):
    assert verdict(text("3exp(-t) - 2exp(-2t)"), "a", "F", f'"{form}"').verdict == "correct"


@pytest.mark.parametrize(
    ("f", "wrong", "says"),
    [
        ("t exp(-2t)", "1/(s - 2)^2", "shift"),
        ("t^3", "1/s^4", "factorial"),
        ("exp(-t) sin(2t)", "(s + 1)/((s + 1)^2 + 4)", "sine and cosine"),
        ("sin(2t)", "1/(s^2 + 4)", "omega"),
        ("step(t - 1)", "1/s", "delay"),
        ("t step(t - 1)", "exp(-s)/s^2", "behind a step"),
    ],
)
def test_usual_mistakes_are_named(f, wrong, says):
    found = verdict(text(f), "a", "F", f'"{wrong}"')
    assert found.verdict == "wrong"
    assert says in str(found.reason)
