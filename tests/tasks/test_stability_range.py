"""Ranges of stability: course and textbook values, several parameters, discrete time, wrong conditions rejected."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

import solver
from solver.derivation import CheckStatus, Status
from solver.problem.source import InputError
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.said import page_of
from tests.helpers.tried import tried

k, a, b = sp.symbols("k a b", real=True)
p, d, m = sp.symbols("p d m", positive=True)
n = sp.Symbol("n", integer=True)
half = sp.Rational(1, 2)
METHODS = ("routh", "eigenvalues")


def companion(*coefficients):
    order = len(coefficients)
    return [[int(j == i + 1) for j in range(order)] for i in range(order - 1)] + [[-c for c in reversed(coefficients)]]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("rows", "options", "discrete", "expected"),
    [
        ([[-1, 1], [sp.sin(k), sp.sin(k) - 3]], {"parameters": ("k",)}, False, sp.true),
        ([[-1, 0], [0, 2 * sp.sin(k) - 1]], {}, False, sp.sin(k) < half),
        ([[-k, 1], [-a, -b]], {"parameters": ("k",)}, False, (k > -b) & (a + b * k > 0)),
        ([[0, 1], [-p / m, -d / m]], {}, False, sp.true),
        ([[0, 1], [a, 0]], {}, False, sp.false),
        ([[0, 1], [2, 1]], {}, False, sp.false),
        ([[k]], {}, False, k < 0),
        ([[0, 1], [-2 * k, k - 3]], {}, False, (k > 0) & (k < 3)),
        ([[0, 1], [p - 2, -1]], {}, False, p < 2),
        ([[0, 1], [-a, half]], {}, True, (a > -half) & (a < 1)),
        ([[k]], {}, True, (k > -1) & (k < 1)),
        ([[0, 1], [-b, -a]], {}, True, (b < 1) & (a > -b - 1) & (a < b + 1)),
        ([[k, 0], [0, 2]], {}, True, sp.false),
        ([[k, 0], [0, 1]], {}, True, sp.false),
    ],
)
def test_both_methods_find_the_condition(rows, options, discrete, expected, method):
    result = ask("stability_range", system(rows, discrete=discrete), method, **options)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["condition"] == expected


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        (companion(2, 1, k), (k > 0) & (k < 2)),
        (companion(4, 6, 4, k), (k > 0) & (k < 5)),
        (companion(a, b, k), (a > 0) & (k > 0) & (a * b - k > 0)),
        (companion(0, k, 1), sp.false),
        (companion(p, 1, k), (k > 0) & (k < p)),
    ],
)
def test_higher_orders(rows, expected, method):
    result = ask("stability_range", system(rows), method)
    assert result.status is Status.VERIFIED, result.reason
    found = result.answers["condition"]
    if expected == sp.false or len(found.free_symbols) == 1:
        assert found == expected
    assert not rejected("stability_range", system(rows), {"condition": expected})


def test_a_bound_that_is_a_root_of_a_cubic_is_a_decimal():
    result = ask("stability_range", system(companion(k, k**2 - 1, 1)), "routh")
    assert result.status is Status.VERIFIED, result.reason
    roots = np.roots([1, 0, -1, -1])
    assert abs(float(result.answers["condition"].rhs) - roots[np.isreal(roots)].real[0]) < 1e-12


def test_a_factor_without_usable_roots_is_left_to_hurwitz():
    rows = sp.diag(sp.Matrix(companion(2, 3, k)), sp.Matrix([[-a]]), sp.Matrix(companion(1, 5, 4, 1)))
    result = ask("stability_range", system(rows), "eigenvalues")
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["condition"] == (k > 0) & (k < 6) & (a > 0)
    kinds = [step.kind for step in result.steps]
    assert (kinds.count("factor"), kinds.count("no_roots"), kinds.count("determinants")) == (2, 1, 1)


def test_in_discrete_time_hurwitz_is_asked_about_the_bilinear_image():
    result = ask("stability_range", system(companion(sp.Rational(1, 3), half, k), discrete=True), "eigenvalues")
    assert result.status is Status.VERIFIED, result.reason
    assert [step.kind for step in result.steps][-4:] == ["no_roots", "bilinear", "determinants", "condition"]
    assert result.answers["condition"] == (k > (1 - sp.sqrt(19)) / 6) & (k < (1 + sp.sqrt(19)) / 6)


def test_roots_of_an_even_factor_with_parameters_are_never_all_inside():
    result = ask("stability_range", system(companion(0, 3 * p, 0, p**2)), "eigenvalues")
    assert (result.status, result.answers["condition"]) == (Status.VERIFIED, sp.false)
    assert "no_roots" in [step.kind for step in result.steps]


def test_a_complex_parameter_is_refused_in_words():
    result = ask("stability_range", system([[0, 1], [sp.Symbol("c", complex=True), -1]]))
    assert result.status is Status.UNSOLVED
    assert "complex" in str(result.reason)


def test_the_closed_loop_is_asked_about_with_gain():
    k1, k2 = sp.symbols("k1 k2", real=True)
    plant = system([[0, 1], [2, -1]], B=[0, 1])
    result = ask("stability_range", plant, gain=sp.ImmutableMatrix([[k1, k2]]))
    assert result.answers["condition"] == (k1 > 2) & (k2 > -1)


GAINS = """
system: {A: [[0, 1], [2, -1]], B: [0, 1]}
find:
  a: {task: stability_range, gain: [k1, k2], parameters: [k1, k2]}
  b: {task: stability_range, parameters: K, controller: K, feedback: unity, system: {transfer_function: 1/(s^2 + s)}}
  c: {task: pole_placement, poles: [-1, -2]}
  d: {task: stability_range, gain: {from: c}, parameters: [q]}
"""


def test_the_symbols_of_what_closes_the_loop_are_parameters():
    found = solver.solve(GAINS)
    assert [part.status for part in found.parts] == ["verified", "verified", "verified", "unsolved"]
    assert [str(found.answers[part]["condition"]) for part in "ab"] == ["(k1 > 2) & (k2 > -1)", "K > 0"]
    assert "$k_1$ and $k_2$" in found.parts[0].question


def test_other_names_are_refused_with_those_there_are():
    with pytest.raises(InputError, match="'k3' is no name in the system") as fault:
        solver.solve(GAINS.replace("[k1, k2]}", "[k1, k3]}"))
    assert "k1, k2" in str(fault.value)


SYSTEMS = {
    "cubic": (companion(2, 1, k), (k > 0) & (k < 2)),
    "surd bounds": (companion(1, k**2 - 2), (k < -sp.sqrt(2)) | (k > sp.sqrt(2))),
    "two parameters": ([[-k, 1], [-a, -b]], (k + b > 0) & (a + b * k > 0)),
    "always": ([[0, 1], [-p, -d]], sp.true),
    "never": ([[0, 1], [-k, 0]], sp.false),
    "a narrow range": (companion(k - 99, 100 - k), (k > 99) & (k < 100)),
    "no parameter": ([[-1]], sp.true),
}


@pytest.mark.parametrize("name", SYSTEMS)
def test_a_right_condition_in_another_form_is_accepted(name):
    rows, condition = SYSTEMS[name]
    assert not rejected("stability_range", system(rows), {"condition": condition})


def test_decimals_are_right_to_the_digits_written():
    plant = system(companion(k, k**2 - 1, 1))  # 1.32471795724...
    for text, wrong in (("1.325", False), ("1.3247", False), ("1.324718", False), ("1.324", True), ("1.3248", True)):
        assert rejected("stability_range", plant, {"condition": k > sp.Rational(text)}) is wrong, text


def wrong_conditions(condition):
    """The opposite, all, none, and every comparison moved, turned round or made to include its edge."""
    yield sp.Not(condition)
    yield from {sp.true, sp.false} - {condition}
    for each in condition.atoms(sp.core.relational.Relational):
        for other in (
            sp.Lt(each.gts, each.lts),
            sp.Ge(each.gts, each.lts),
            sp.Gt(each.gts, each.lts + sp.Rational(1, 999)),
            sp.Gt(each.gts, each.lts - sp.Rational(1, 999)),
            sp.true,
        ):
            changed = condition.subs(each, other)
            if changed != condition:
                yield changed


@pytest.mark.parametrize("name", SYSTEMS)
def test_wrong_conditions_are_rejected(name):
    rows, condition = SYSTEMS[name]
    for wrong in wrong_conditions(condition):
        assert rejected("stability_range", system(rows), {"condition": wrong}), wrong


def test_a_wrong_condition_is_rejected_with_a_counterexample():
    plant = system(companion(2, 1, k))
    task = catalogue()["stability_range"]
    checks = list(task.verify(task.given(plant, {}), {"condition": k > 0}))
    (failed,) = [check for check in checks if check.status is CheckStatus.FAILED]
    assert "the system is not asymptotically stable, but the condition holds" in failed.reason


def test_a_condition_on_something_else_is_rejected():
    assert rejected("stability_range", system(companion(2, 1, k)), {"condition": (a > 0) & (a < 2)})


@tried(20)
@given(st.lists(st.integers(-3, 3), min_size=4, max_size=4), st.lists(st.integers(-2, 2), min_size=4, max_size=4),
       st.booleans())  # fmt: skip
def test_random_pencils_are_verified_and_agree(constant, slope, discrete):
    entries = [c + s * k / 2 for c, s in zip(constant, slope, strict=True)]
    plant = system([entries[:2], entries[2:]], discrete=discrete)
    results = [ask("stability_range", plant, method) for method in METHODS]
    for result in results:
        assert result.status is Status.VERIFIED, result.reason
    assert results[0].answers["condition"] == results[1].answers["condition"]


@pytest.mark.parametrize("method", METHODS)
def test_the_pages_say_what_happens_at_the_ends_of_the_range(method):
    """Course example: s³ + as² + bs + K oscillates with ω = √b at K = ab."""
    x = sp.Symbol("x", positive=True)
    result = ask("stability_range", system(companion(x, 1, k)), method)
    assert result.answers["condition"] == (k > 0) & (k < x)
    ends = {step.values["bound"]: step.values["roots"] for step in result.steps if step.kind == "edge"}
    assert ends == {0: (0,), x: (sp.I,)}


def test_in_discrete_time_the_ends_are_on_the_unit_circle():
    result = ask("stability_range", system([[0, 1], [-k, 1]], discrete=True), "routh")
    assert result.answers["condition"] == (k > 0) & (k < 1)
    ends = {step.values["bound"]: step.values["roots"] for step in result.steps if step.kind == "edge"}
    assert ends[0] == (1,)
    assert abs(complex(ends[1][0])) == pytest.approx(1)
    assert complex(ends[1][0]) == pytest.approx(np.roots([1, -1, 1])[0])


def page(rows, method="routh", **more):
    return page_of("stability_range", method, system(rows, **more))


def test_ends_say_where_their_oscillation_is_and_show_it_in_factors():
    said = page(companion(p, b, k))
    assert "(s + p)" in said.replace("(p + s)", "(s + p)")
    assert r"Where $b > 0$, it has the roots $\pm j\sqrt{b}$" in said
    assert "Where" not in page(companion(2, 3, k))
    assert "At the end of the range: $a = -bk$" in page([[-k, 1], [-a, -b]])


def test_the_polynomial_at_an_end_is_in_the_variable_of_the_method():
    for method, x in (("routh", "s"), ("eigenvalues", r"\lambda")):
        said = page(companion(2, 3, k), method)
        assert rf"\chi({x})" in said
    assert r"\chi(s)" not in page(companion(2, 3, k), "eigenvalues")


@pytest.mark.parametrize("method", METHODS)
def test_what_is_always_positive_says_why(method):
    assert r"since sines and cosines lie between $-1$ and $1$: $4 - \sin(k) > 0$ and" in page(
        [[-1, 1], [sp.sin(k), sp.sin(k) - 3]], method
    )


def test_two_eigenvalues_with_parameters_need_no_formula():
    said = page([[-k, 1], [-a, -b]], "eigenvalues")
    assert "quadratic formula" not in said
    assert "The two eigenvalues have the sum" in said


def test_a_minus_sign_before_a_condition_is_put_into_a_factor():
    said = page(companion(2, 3, k), "eigenvalues")
    assert "k(6 - k)" in said
    assert "-k(k - 6)" not in said


def test_the_only_parameter_is_named_in_the_question():
    asked = solver.solve("system: {A: [[0, 1], [-K, -1]]}\nfind: {a: stability_range}").parts[0].question
    assert "For which values of $K$ is" in asked
