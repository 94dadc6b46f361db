"""Special values of parameters: found, solved anew, told on the page, and left out where the general solution holds."""

import json

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

import solver
from solver.derivation import Status
from solver.exact import divisors, special_values

a, b, K = sp.symbols("a b K", real=True)
p = sp.Symbol("p", positive=True)
TEXT = "title: T\nsystem: {{A: {A}, B: {B}, C: [1, 0]}}\nfind: {{a: {find}}}\n"


def solved(find, A="[[0, 1], [-2, -3]]", B="[0, 1]", **more):
    return solver.solve(TEXT.format(A=A, B=B, find=find), **more)


def cases(solution):
    return {part.case: part for part in solution.parts if part.case}


@pytest.mark.parametrize(
    ("f", "found"),
    [
        (a - 3, [(a, 3)]),
        (a**2 - 2, [(a, sp.sqrt(2)), (a, -sp.sqrt(2))]),
        (a**2 + 2, []),
        (p + 1, []),
        (p**2 - 4, [(p, 2)]),
        (K - a * b, [(K, a * b)]),
        (a**3 - 2, []),
        (sp.sin(a), []),
        (a * b - 1, []),  # neither is known to differ from zero
    ],
)
def test_values_for_which_an_expression_is_zero(f, found):
    assert list(special_values(f)) == found


@given(st.integers(-9, 9), st.integers(-9, 9))
def test_the_roots_of_a_quadratic_expression(u, v):
    found = special_values(sp.expand((a - u) * (a - v)))
    assert {value for _, value in found} == {u, v}


def test_what_a_value_is_divided_by():
    s = sp.Symbol("s")
    value = sp.ImmutableMatrix([[1 / (a - 3), 1 / (s - a)], [1 / (p + 1), b / (a - 3)]])
    assert list(divisors(value, [a, b, p])) == [a - 3, a - 3]
    assert list(divisors([1 / b, 2], [b])) == [b]


def test_an_inverse_gain_names_the_value_it_divides_by_and_follows_the_case():
    solution = solved("{task: pole_placement, poles: [-3, -4], method: ackermann}", B="[0, a]")
    (name, case), *others = cases(solution).items()
    assert (name, others) == ("a = 0", [])
    assert case.status is Status.UNSOLVED
    assert "does not act on the state" in case.reason
    assert solution.status is Status.VERIFIED  # that there is no gain for a = 0 is part of the answer
    general = solution.parts[0]
    assert r"$a \ne 0$" in general.steps[-1].markdown
    assert not general.case


@pytest.mark.parametrize("value", [(), ((a, sp.Integer(1)),)])
def test_special_values_that_are_wrong_or_left_out_fail_the_part(monkeypatch, value):
    monkeypatch.setattr("solver.exact.special_values", lambda _: value)
    solution = solved("{task: pole_placement, poles: [-3, -4], method: ackermann}", B="[0, a]")
    assert solution.status is Status.FAILED
    assert not cases(solution)


def test_each_case_has_its_own_question_steps_answers_and_checks():
    solution = solved("controllability", A="[[2, a - 3], [0, 2]]", B="[[1, 1], [0, a^2 - 2]]")
    assert list(cases(solution)) == ["a = sqrt(2)", "a = -sqrt(2)"]
    case = cases(solution)["a = sqrt(2)"]
    assert case.status is Status.VERIFIED
    assert case.title == "Controllability: the case a = √2"
    shown = {answer.name: answer.equation for answer in case.answers}
    assert shown["rank"].endswith("1")
    assert r"\lambda_{\text{uncontrollable}} = 2" in shown["uncontrollable_modes"]
    assert r"\sqrt{2}" in case.given


def test_the_case_is_solved_as_the_same_question_with_the_value_typed():
    general = solved("eigenstructure", A="[[a, 1], [0, b]]")
    case = cases(general)["a = b"]
    typed = solved("eigenstructure", A="[[b, 1], [0, b]]").parts[0]
    assert [step.markdown for step in case.steps] == [step.markdown for step in typed.steps]


@pytest.mark.parametrize(
    ("find", "A", "B"),
    [
        ("characteristic_polynomial", "[[0, 1], [-a, -b]]", "[0, 1]"),
        ("{task: stability_range, method: routh}", "[[0, 1], [-a, -b]]", "[0, 1]"),
        ("controllability", "[[0, 1], [-a, -b]]", "[0, 1]"),
        ("controllability", "[[0, 1/a], [-1, -b]]", "[0, 1]"),  # there is no plant with a = 0
    ],
)
def test_where_the_solution_holds_for_all_values_there_are_no_cases(find, A, B):
    assert cases(solved(find, A=A, B=B)) == {}


def test_what_is_assumed_leaves_cases_out():
    text = "title: T\nassume: {a: positive}\n" + TEXT.format(
        A="[[0, 1], [-2, -3]]", B="[0, a]", find="controllability"
    ).removeprefix("title: T\n")
    assert cases(solver.solve(text)) == {}


def test_json_tells_cases_within_their_part():
    data = json.loads(solved("controllability", B="[0, a]").json())
    assert [part["id"] for part in data["parts"]] == ["a"]
    (case,) = data["parts"][0]["cases"]
    assert case["case"] == "a = 0"
    assert case["answers"]["controllable"]["value"] == "False"


@pytest.mark.parametrize("detail", ["question", "key", "brief"])
def test_levels_without_reasons_follow_no_cases(detail):
    assert cases(solved("controllability", B="[0, a]", detail=detail)) == {}


def test_the_variable_of_a_transfer_function_is_no_parameter():
    find = "{a: transfer_function, b: {task: response, input: 1}}"
    text = f"title: T\nsystem: {{transfer_function: 1/((s + a)*(s + b))}}\nfind: {find}\n"
    solution = solver.solve(text)
    assert {case.rpartition(" = ")[0] for case in cases(solution)} <= {"a", "b"}
    assert not [case for case in cases(solution) if "s" in case.split()]
    assert solution.status is Status.VERIFIED


def test_a_value_that_is_not_special_fails(monkeypatch):
    """The case a = 1/1000 of a question whose exception is a = 0."""
    monkeypatch.setattr("solver.special_cases._special_values", lambda *_: [(a, a, sp.Rational(1, 1000))])
    monkeypatch.setattr("solver.special_cases._is_the_same", lambda *_: False)
    solution = solved("controllability", B="[0, a]")
    assert {each.status for each in cases(solution).values()} == {Status.FAILED}
    assert solution.parts[0].status is Status.FAILED
