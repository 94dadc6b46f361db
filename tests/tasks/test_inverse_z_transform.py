"""Inverse z-transforms by three methods: steps, answers against scipy's filter, corruptions, refusals, marking."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.signal import lfilter

from solver.derivation import Answers, CheckStatus, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.marked import verdict

Z, K = sp.symbols("z k")
delta = sp.KroneckerDelta
METHODS = ("partial_fractions", "residues")


def text(F, method="partial_fractions", more=""):
    return f'find:\n  a: {{task: inverse_z_transform, method: {method}, F: "{F}"{more}}}\n'


def asked(F, method="partial_fractions", more=""):
    return solve_problem(read_problem(Source("file.yaml", text(F, method, more)), catalogue())).parts[0]


def answers(F, method="partial_fractions", more=""):
    result = asked(F, method, more)
    assert result.status is Status.VERIFIED, result.reason
    assert not [check for check in result.checks if check.status is CheckStatus.SKIPPED]
    return result.answers


def rejected(F, **given_answers):
    task = catalogue()["inverse_z_transform"]
    part = read_problem(Source("file.yaml", text(F)), catalogue()).parts[0]
    checks = list(task.verify(task.given(part.system, part.options), Answers(**given_answers)))
    return any(check.status is CheckStatus.FAILED for check in checks)


def step(k):
    return sp.Heaviside(k, 1)


def numbers(f, count=12):
    return [complex(sp.N(f.subs(K, i))) for i in range(count)]


def filtered(F, count=12):
    """The impulse response of the filter F, by scipy's recursion."""
    above, below = (sp.Poly(side, Z) for side in sp.fraction(sp.together(F)))
    a = [float(c) for c in below.all_coeffs()]
    b = [0.0] * (below.degree() - above.degree()) + [float(c) for c in above.all_coeffs()]
    return lfilter(b, a, [1.0] + [0.0] * (count - 1))


half = sp.Rational(1, 2)
TEXTBOOK = {
    "10z/((z - 1)(z - 2))": 10 * (2**K - 1),
    "z^-2/(1 - z^-1)": step(K - 2),
    "1/(z - 3)": 3**K / sp.Integer(3) - delta(K, 0) / 3,
    "z/(z - 1/2)^2": 2 * K * half**K,
    "z(z + 1)/(z - 1)^3": K**2,
    "(z^2 + z + 2)/((z - 1)(z^2 - z + 1))": None,
    "z^2/(z^2 + 1)": sp.cos(sp.pi * K / 2),
    "(1 + 3z^-1)/(1 - z^-1/2)": half**K + 3 * (2 * half**K - 2 * delta(K, 0)),
    "(z - 1)/z^3": delta(K, 2) - delta(K, 3),
    "(1 - z^-4)/(1 - z^-1)": 1 - step(K - 4),
    "z/(z^2 - z - 1)": None,
    "z/(z^2 - 2z + 4)^2": None,
    "(1 - z^-3)*4/(z^2 - 3z + 1)": None,
}


@pytest.mark.parametrize(("F", "method"), [(F, METHODS[i % 2]) for i, F in enumerate(TEXTBOOK)])
def test_sequences_of_the_textbooks(F, method):
    found = answers(F, method)
    image = read_problem(Source("f", text(F)), catalogue()).parts[0].options["F"]
    assert np.allclose(numbers(found["f"]), filtered(image))
    assert np.allclose([complex(value) for value in found["values"]], filtered(image, 6))
    if TEXTBOOK[F] is not None:
        assert np.allclose(numbers(found["f"]), numbers(TEXTBOOK[F]))
    assert sp.cancel(found["partial_fractions"] - image) == 0


def test_the_coefficients_are_those_of_the_image_divided_by_z():
    result = asked("z/((z - 1)(z - 2))")
    kinds = [each.kind for each in result.steps]
    assert kinds == [
        "divide_by_z",
        "form",
        "covered_up",
        "partial_fractions",
        "times_z",
        "pairs",
        "back",
        "first_terms",
    ]
    assert result.steps[0].claims["F"].right.operands[0] == 1 / ((Z - 1) * (Z - 2))
    assert result.answers["f"] == 2**K - 1


def test_a_pole_at_zero_gives_unit_pulses():
    f = answers("(z + 1)/(z (z - 1/2)^2)")["f"]
    assert sp.expand(f - (20 * delta(K, 0) + 4 * delta(K, 1) + (12 * K - 20) * half**K)) == 0
    residues = asked("(z + 1)/(z (z - 1/2)^2)", "residues")
    at_zero = next(each for each in residues.steps if each.kind == "at_zero")
    assert at_zero.values["rows"] == [(0, 2, 20), (1, 1, 4)]


def test_powers_of_one_over_z_are_delays():
    result = asked("(1 - z^-4)/(1 - z^-1) + z^-5/(1 - z^-1/2)")
    assert result.steps[0].kind == "delays"
    assert result.steps[0].values["delays"] == [0, 4, 5]
    assert result.answers["f"].has(sp.Heaviside(K - 4, 1))


def test_an_improper_image_begins_before_zero():
    found = answers("z^2/(z - 1)")
    assert found["f"] == delta(K, -1) + step(K)
    assert asked("z^2/(z - 1)", "residues").status is Status.UNSOLVED
    assert answers("z^2/(z - 1)", "long_division")["values"] == [1] * 6


def test_long_division_as_on_paper():
    result = asked("z/(z^2 - 3z + 2)", "long_division", ", terms: 4")
    assert result.answers["values"] == [0, 1, 3, 7]
    assert set(result.answers) == {"values"}
    scheme = next(each for each in result.steps if each.kind == "scheme")
    assert scheme.values["columns"] == [1, 0, -1, -2, -3]
    assert scheme.values["rows"][1] == ("taken", 1, 1, [1, -3, 2, None, None])
    assert scheme.values["rows"][2] == ("rest", None, None, [None, 3, -2, None, None])


def test_parameters_stay():
    a = sp.Symbol("a", real=True)
    assert answers("z/(z - a)^2")["f"] == K * a ** (K - 1)
    assert answers("z/(z - a)^2", "long_division", ", terms: 5")["values"] == [0, 1, 2 * a, 3 * a**2, 4 * a**3]
    T = sp.Symbol("T", positive=True)
    f = answers("z (1 - exp(-T))/((z - 1)(z - exp(-T)))", more=", assume: {T: positive}")["f"]
    assert sp.expand(f - 1 + sp.exp(-K * T)) == 0


listed = ["z", "(z - 1)", "(z + 1/2)", "(z - 1/3)^2", "(z^2 + 1)", "(z^2 - z + 1/2)", "(z^2 + 1/4)^2", "(2z - 1)"]


@settings(max_examples=10, deadline=None)
@given(
    st.lists(st.sampled_from(listed), min_size=1, max_size=3, unique=True),
    st.lists(st.integers(-4, 4), min_size=1, max_size=3),
    st.sampled_from((*METHODS, "long_division")),
)
def test_generated_images_against_scipys_filter(below, above, method):
    numerator = " + ".join(f"({c})*z^{k}" for k, c in enumerate(above))
    if not any(above):
        return
    F = f"({numerator})/({' '.join(below)})"
    image = read_problem(Source("f", text(F)), catalogue()).parts[0].options["F"]
    top, bottom = sp.fraction(sp.cancel(image))
    if sp.degree(top, Z) > sp.degree(bottom, Z):
        return
    found = answers(F, method)
    assert np.allclose([complex(value) for value in found["values"]], filtered(sp.cancel(image), 6))
    if "f" in found:
        assert np.allclose(numbers(found["f"]), filtered(sp.cancel(image)), atol=1e-7)


@pytest.mark.parametrize(
    ("F", "wrong"),
    [
        ("z/(z - 2)", sp.Integer(3) ** K),
        ("1/(z - 2)", 2**K),
        ("1/(z - 2)", 2 ** (K - 1)),
        ("z^-3/(1 - z^-1)", sp.S.One),
        ("z^-3/(1 - z^-1)", step(K - 2)),
        ("(z + 1)/(z (z - 1/2)^2)", (12 * K - 20) * half**K),
        ("z^2/(z^2 + 1)", sp.sin(sp.pi * K / 2)),
        ("z/(z - 1/2)^2", K * half**K * sp.Rational(2001, 1000)),
    ],
)
def test_corrupted_sequences_are_rejected(F, wrong):
    assert rejected(F, f=wrong)
    assert not rejected(F, f=answers(F)["f"])


@pytest.mark.parametrize(
    ("F", "total", "right"),
    [
        ("z/((z - 1)(z - 2))", Z / (Z - 2) - Z / (Z - 1), True),
        ("z/((z - 1)(z - 2))", 2 / (Z - 2) - 1 / (Z - 1), True),
        ("z/((z - 1)(z - 2))", Z / ((Z - 1) * (Z - 2)), False),
        ("1/(z^3 (z - 1))", Z**-3 / (Z - 1), True),
        ("1/(z^3 (z - 1)(z - 2))", Z**-3 / ((Z - 1) * (Z - 2)), False),
    ],
)
def test_each_term_of_partial_fractions_has_one_pole_or_a_pair(F, total, right):
    assert rejected(F, partial_fractions=total) is not right


def test_corrupted_values_and_fractions_are_rejected():
    F = "z/((z - 1)(z - 2))"
    assert not rejected(F, values=[0, 1, 3, 7, 15, 31], partial_fractions=Z / (Z - 2) - Z / (Z - 1))
    assert rejected(F, values=[0, 1, 3, 7, 15, 30])
    assert rejected(F, values=[0, 1, 3, 7, 15])
    assert rejected(F, partial_fractions=1 / (Z - 2) - 1 / (Z - 1))


@pytest.mark.parametrize(
    ("F", "says"), [("log(z)", "no quotient"), ("sqrt(z)/(z - 1)", "no quotient"), ("0", "is zero")]
)
def test_other_images_are_refused_at_their_place(F, says):
    with pytest.raises(InputError) as raised:
        asked(F)
    assert says in str(raised.value)
    assert "file.yaml:2" in str(raised.value)


@pytest.mark.parametrize(
    ("F", "form"),
    [
        ("z/((z - 1)(z - 2))", "2^k - 1"),
        ("z/((z - 1)(z - 2))", "(2^k - 1) u(k)"),
        ("z/((z - 1)(z - 2))", "f(k) = 2^k - 1, k >= 0"),
        ("z/(z - 1/2)^2", "k (1/2)^(k - 1)"),
        ("z/(z - 1/2)^2", "2k*2^(-k)"),
        ("1/(z - 3)", "3^(k-1) step(k - 1)"),
        ("1/(z - 3)", "3^(k-1) u(k-1)"),
        ("1/(z - 3)", "(3^k - delta(k))/3"),
        ("z^-2/(1 - z^-1)", "step(k - 2)"),
        ("z^2/(z^2 + 1)", "cos(pi k/2)"),
    ],
)
def test_equivalent_sequences_are_right(F, form):
    assert verdict(text(F), "a", "f", f'"{form}"').verdict == "correct"


@pytest.mark.parametrize("form", ["z/(z - 2) - z/(z - 1)", "1/(1 - 2z^-1) - 1/(1 - z^-1)", "F(z) = -z/(z-1) + z/(z-2)"])
def test_fractions_in_z_and_in_its_inverse_are_right(form):
    assert verdict(text("z/((z - 1)(z - 2))"), "a", "partial_fractions", f'"{form}"').verdict == "correct"


@pytest.mark.parametrize(
    ("F", "answer", "wrong", "says"),
    [
        ("1/((z - 1)(z - 2))", "f", "2^k - 1", "expanded and not"),
        ("z/((z - 1)(z - 2))", "f", "2^(k-1) - 1", "one sample late"),
        ("z/((z - 1)(z - 2))", "f", "2*2^k - 1", "one sample early"),
        ("z/(z - 1/2)", "f", "2^k", "base is inverted"),
        ("z/(z - 2)", "f", "exp(2k)", "Laplace"),
        ("(z + 1)/(z (z - 1/2)^2)", "f", "(12k - 20)(1/2)^k", "unit pulses"),
        ("z^-3/(1 - z^-1/2)", "f", "(1/2)^(k - 3)", "step is forgotten"),
        ("z/((z - 1)(z - 2))", "values", "[1, 3, 7, 15, 31, 63]", "early"),
        ("z/((z - 1)(z - 2))", "values", "[0, 0, 1, 3, 7, 15]", "late"),
    ],
)
def test_usual_mistakes_are_named(F, answer, wrong, says):
    found = verdict(text(F), "a", answer, f'"{wrong}"')
    assert found.verdict == "wrong"
    assert says in str(found.reason)
