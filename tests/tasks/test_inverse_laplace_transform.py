"""Inverse Laplace transforms by three methods: steps, answers against mpmath, corruptions, refusals, marking."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Answers, CheckStatus, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.marked import verdict

S, T = sp.symbols("s t")
A, B = sp.symbols("a b", real=True)
step, delta = sp.Heaviside, sp.DiracDelta
METHODS = ("partial_fractions", "residues", "convolution")


def text(F, method="partial_fractions", more=""):
    return f'find:\n  a: {{task: inverse_laplace_transform, method: {method}, F: "{F}"{more}}}\n'


def asked(F, method="partial_fractions", more=""):
    return solve_problem(read_problem(Source("file.yaml", text(F, method, more)), catalogue())).parts[0]


def function(F, method="partial_fractions", more=""):
    result = asked(F, method, more)
    assert result.status is Status.VERIFIED, result.reason
    assert not [check for check in result.checks if check.status is CheckStatus.SKIPPED]
    return result.answers["f"]


def rejected(F, **answers):
    task = catalogue()["inverse_laplace_transform"]
    part = read_problem(Source("file.yaml", text(F)), catalogue()).parts[0]
    checks = list(task.verify(task.given(part.system, part.options), Answers(**answers)))
    return any(check.status is CheckStatus.FAILED for check in checks)


def same(f, g):
    points = (sp.Rational(3, 10), sp.Rational(17, 10), sp.Rational(5, 2))
    return all(abs(sp.N((f - g).subs(T, point), 30)) < 1e-25 for point in points)


e = sp.exp(-T)
TEXTBOOK = {
    "(s + 3)/((s + 1)(s + 2))": 2 * e - e**2,
    "(2s + 12)/(s^2 + 2s + 5)": 2 * e * sp.cos(2 * T) + 5 * e * sp.sin(2 * T),
    "(s^2 + 2s + 3)/(s + 1)^3": e * (1 + T**2),
    "2/((s + 1)(s + 2)^2)": 2 * e - 2 * T * e**2 - 2 * e**2,
    "3/(s(s^2 + 2s + 5))": sp.Rational(3, 5) - sp.Rational(3, 5) * e * (sp.cos(2 * T) + sp.sin(2 * T) / 2),
    "1/(s^2(s^2 + 1))": T - sp.sin(T),
    "1/(s^2 + 1)^2": (sp.sin(T) - T * sp.cos(T)) / 2,
    "1/(s^4 - 1)": (sp.sinh(T) - sp.sin(T)) / 2,
    "1/(s^2 - 2)": sp.sinh(sp.sqrt(2) * T) / sp.sqrt(2),
    "(1 - exp(-s))/s": 1 - step(T - 1),
    "exp(-2s)/(s + 1)^2": (T - 2) * sp.exp(2 - T) * step(T - 2),
}


@pytest.mark.parametrize("method", METHODS[:2])
@pytest.mark.parametrize("F", TEXTBOOK)
def test_functions_of_the_textbooks(F, method):
    assert same(function(F, method), TEXTBOOK[F])


@pytest.mark.parametrize(
    ("F", "wanted"),
    [
        ("1/((s + 1)(s + 2))", e - e**2),
        ("s/(s^2 + 4)^2", T * sp.sin(2 * T) / 4),
        ("(s + 2)/(s^2(s + 1))", 2 * T - 1 + e),
        ("exp(-s)/(s(s + 1))", (1 - sp.exp(1 - T)) * step(T - 1)),
    ],
)
def test_convolution_carries_the_integral_out(F, wanted):
    assert same(function(F, "convolution"), wanted)


def test_what_is_no_product_is_not_convolved():
    result = asked("(3s + 5)/((s + 1)(s + 3))", "convolution")
    assert result.status is Status.UNSOLVED
    assert "no product" in str(result.reason)


def test_improper_images_hold_impulses():
    found = asked("(s^3 + 5s^2 + 9s + 7)/((s + 1)(s + 2))")
    assert found.answers["f"] == delta(T, 1) + 2 * delta(T) + 2 * e - e**2
    assert found.steps[0].kind == "divided"
    assert function("s^2") == delta(T, 2)


def test_order_six_with_a_repeated_pair():
    F = "10/((s + 1)(s + 3)(s^2 + 2s + 5)^2)"
    by_fractions, by_residues = function(F), function(F, "residues")
    assert sp.expand(by_fractions - by_residues) == 0
    mpmath.mp.dps = 25
    wanted = mpmath.invertlaplace(lambda p: 10 / ((p + 1) * (p + 3) * (p**2 + 2 * p + 5) ** 2), 1.3, method="talbot")
    mpmath.mp.dps = 15
    assert abs(sp.N(by_fractions.subs(T, sp.Float("1.3"))) - wanted) < 1e-10


def test_two_pairs_one_of_them_repeated_are_compared():
    kinds = [each.kind for each in asked("1/((s^2 + 1)^2 (s^2 + 4))").steps]
    assert "compared_at_all" in kinds
    divided = next(each for each in asked("1/((s + 1)(s^2 + 1)^2)").steps if each.kind == "divided_again")
    assert divided.claims["divided1"].right.operands[1] == sp.Rational(1, 2) * (1 - S)


def test_parameters_are_general_and_the_exception_is_named():
    a, b = sp.symbols("a b", real=True)
    found = asked("1/((s + a)(s + b))")
    assert sp.simplify(found.answers["f"] - (sp.exp(-a * T) - sp.exp(-b * T)) / (b - a)) == 0
    named = [each.values["exceptions"] for each in found.steps if each.values.get("exceptions")]
    assert named == [(sp.Eq(b - a, 0),)]


def test_an_irreducible_cubic_has_decimal_roots():
    found = function("1/(s^3 + s + 1)")
    mpmath.mp.dps = 25
    wanted = mpmath.invertlaplace(lambda p: 1 / (p**3 + p + 1), 2, method="talbot")
    mpmath.mp.dps = 15
    assert abs(sp.N(found.subs(T, 2)) - wanted) < 1e-10


listed = ["s", "(s + 1)", "(s + 2)^2", "(s + 3)^3", "(s^2 + 1)", "(s^2 + 2s + 5)", "(s^2 + 4)^2", "(2s + 1)"]


@settings(max_examples=12, deadline=None)
@given(
    st.lists(st.sampled_from(listed), min_size=1, max_size=3, unique=True),
    st.lists(st.integers(-4, 4), min_size=1, max_size=3),
    st.sampled_from(METHODS[:2]),
)
def test_generated_images_against_talbots_contour(below, above, method):
    numerator = " + ".join(f"({c})*s^{k}" for k, c in enumerate(above))
    if not any(above):
        return
    F = f"({numerator})/({' '.join(below)})"
    found = function(F, method).replace(delta, lambda *_: sp.S.Zero)
    image = sp.lambdify(S, read_problem(Source("f", text(F)), catalogue()).parts[0].options["F"], "mpmath")
    mpmath.mp.dps = 30
    wanted = mpmath.invertlaplace(image, mpmath.mpf("1.7"), method="talbot")
    mpmath.mp.dps = 15
    assert abs(sp.N(found.subs(T, sp.Float("1.7", 30))) - wanted) < 1e-8 * (1 + abs(wanted))


@pytest.mark.parametrize(
    ("F", "wrong"),
    [
        ("1/(s + 2)", sp.exp(2 * T)),
        ("1/(s + 2)^3", T**2 * sp.exp(-2 * T)),
        ("3/(s^2 + 9)", sp.cos(3 * T)),
        ("1/(s^2 + 9)", sp.sin(3 * T)),
        ("exp(-s)/s", sp.S.One),
        ("exp(-s)/(s + 1)", sp.exp(-T) * step(T - 1)),
        ("(s + 2)/(s + 1)", sp.exp(-T)),
        ("s", delta(T)),
        ("1/((s^2 + 1)^2)", (sp.sin(T) - T * sp.cos(T)) * sp.Rational(501, 1000)),
    ],
)
def test_corrupted_functions_are_rejected(F, wrong):
    assert rejected(F, f=wrong)
    assert not rejected(F, f=function(F))


def test_corrupted_partial_fractions_are_rejected():
    assert rejected("1/((s + 1)(s + 2))", partial_fractions=1 / (S + 1) + 1 / (S + 2))
    assert not rejected("1/((s + 1)(s + 2))", partial_fractions=1 / (S + 1) - 1 / (S + 2))


@pytest.mark.parametrize(
    ("F", "total", "right"),
    [
        ("1/((s + 1)(s + 2))", 1 / ((S + 1) * (S + 2)), False),
        ("1/((s + 1)(s + 2))", 1 / (S**2 + 3 * S + 2), False),
        ("1/(s (s + 1)(s + 2))", 1 / (2 * S) - S / (2 * (S + 1) * (S + 2)) - 1 / ((S + 1) * (S + 2)) * 3 / 2, False),
        ("s/(s + 1)^2", S / (S + 1) ** 2, False),
        ("s/(s + 1)^2", 1 / (S + 1) - 1 / (S + 1) ** 2, True),
        ("s/(s + 1)", S / (S + 1), False),
        ("s/(s + 1)", 1 - 1 / (S + 1), True),
        ("(s + 3)/(s^2 + 2s + 5)", (S + 3) / (S**2 + 2 * S + 5), True),
        ("1/(s^2 - 3)", 1 / (S**2 - 3), True),
        ("exp(-s)/(s (s + 1))", sp.exp(-S) * (1 / S - 1 / (S + 1)), True),
        ("exp(-s)/(s (s + 1))", sp.exp(-S) / (S * (S + 1)), False),
        ("1/((s + a)(s + b))", (1 / (S + A) - 1 / (S + B)) / (B - A), True),
        ("1/((s + a)(s + b))", 1 / ((S + A) * (S + B)), False),
    ],
)
def test_each_term_has_one_pole_or_a_pair(F, total, right):
    assert rejected(F, partial_fractions=total) is not right


@pytest.mark.parametrize(
    ("F", "says"),
    [("log(s)", "no quotient"), ("1/(1 - exp(-s))", "denominator"), ("exp(s)/s", "before zero"),
     ("exp(-b s)/s", "under `assume`"), ("sqrt(s)", "no quotient")],
)  # fmt: skip
def test_other_images_are_refused_at_their_place(F, says):
    with pytest.raises(InputError) as raised:
        asked(F)
    assert says in str(raised.value)
    assert "file.yaml:2" in str(raised.value)


@pytest.mark.parametrize("form", ["2e^-t - e^(-2t)", "e^(-2t) (2e^t - 1)", "exp(-t)*(2 - exp(-t))"])
def test_equivalent_forms_are_right(form):
    assert verdict(text("(s + 3)/((s + 1)(s + 2))"), "a", "f", f'"{form}"').verdict == "correct"


@pytest.mark.parametrize(
    ("F", "wrong", "says"),
    [
        ("1/(s + 2)", "exp(2t)", "shift"),
        ("1/(s + 2)^3", "t^2 exp(-2t)", "factorial"),
        ("3/(s^2 + 9)", "cos(3t)", "sine and cosine"),
        ("1/(s^2 + 9)", "sin(3t)", "omega"),
        ("exp(-s)/(s + 1)", "exp(-t)", "delay"),
        ("exp(-s)/(s + 1)", "exp(-t) step(t - 1)", "not shifted"),
    ],
)
def test_usual_mistakes_are_named(F, wrong, says):
    found = verdict(text(F), "a", "f", f'"{wrong}"')
    assert found.verdict == "wrong"
    assert says in str(found.reason)


def test_numerators_over_quadratics_are_split_before_the_table_is_read():
    result = asked("3/(s(s^2 + 2s + 5))")
    kinds = [step.kind for step in result.steps]
    assert kinds[0] == "form"
    assert kinds.index("completed_squares") < kinds.index("table_form") < kinds.index("pairs") < kinds.index("back")


def test_pairs_of_fractions_that_are_zero_are_not_told():
    result = asked("(s^2 + 2s + 3)/(s + 1)^3")
    (pairs,) = (step for step in result.steps if step.kind == "pairs")
    assert [claim.right for claim in pairs.claims.values()] == [sp.exp(-T), T**2 * sp.exp(-T) / 2]
