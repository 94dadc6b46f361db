"""Conditions on parameters, as a problem or a part gives them."""

from __future__ import annotations

import json
import operator
from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import example, given, settings
from hypothesis import strategies as st

from solver.conditions import Condition, Parameter
from solver.derivation import Status
from solver.document.model import Presentation
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.limits import solve_within
from solver.limits.codec import decode, encode
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

PLANT = "system: {A: [[a, b], [c, d]]}\n"
FIND = "find: {p: characteristic_polynomial}\n"


def read(text):
    return read_problem(Source("file.yaml", text), catalogue())


def solved(text):
    return {part.id: part for part in solve_problem(read(text)).parts}


def complaints(text):
    with pytest.raises(InputError) as caught:
        solved(text)
    return [(each.line, each.column, each.message, each.suggestion) for each in caught.value.diagnostics]


def test_symbols_carry_what_is_known_of_them():
    problem = read('conditions: ["0 < a < 1", "b <= -2", "c != 0"]\n' + PLANT + FIND)
    found = problem.symbols
    assert (found["a"].is_positive, found["b"].is_negative, found["c"].is_nonzero) == (True, True, True)
    assert found["d"] == sp.Symbol("d", real=True)
    assert {each.relation for each in found["a"].conditions} == {">"}
    assert [chain.signs for chain in problem.conditions] == [("<", "<"), ("<=",), ("!=",)]


def test_a_chain_says_all_of_its_sides():
    (a,) = (x for x in read('conditions: ["0 < b < a"]\n' + PLANT + FIND).symbols.values() if x.name == "a")
    plain = {x.name: x for each in a.conditions for x in each.difference.free_symbols}
    assert set(a.conditions) == {
        Condition(plain["b"], ">"),
        Condition(plain["a"], ">"),
        Condition(plain["a"] - plain["b"], ">"),
    }


def test_conditions_of_other_symbols_are_not_carried():
    found = read('conditions: ["a > 1", "b > c"]\n' + PLANT + FIND).symbols
    assert len(found["a"].conditions) == 1
    assert found["b"].conditions == found["c"].conditions != found["a"].conditions


@pytest.mark.parametrize(
    ("conditions", "column", "message", "suggestion"),
    [
        ('"a = 1"', 17, "an equation is no condition", ""),
        ('"a =< 1"', 17, "'=<' is no relation", "<="),
        ('"a <> 1"', 17, "'<>' is no relation", "!="),
        ('"a"', 14, "a relation with <, <=, >, >= or != is expected here", ""),
        ('"a > "', 17, "an expression is expected on both sides of the relation", ""),
        ('"a > 1 < b"', 14, "all signs of a chain point the same way", ""),
        ('"a != b != c"', 14, "!= stands between two expressions only", ""),
        ('"1 < 2"', 14, "a condition is about parameters, and there is none here", ""),
        ('"a > 0", "zeto > 0"', 23, "there is no parameter 'zeto': it occurs nowhere but in this condition", "zeta"),
        ('"s > 0"', 15, "'s' cannot stand here: s is the variable of the Laplace transform", ""),
        ('"a > 2 +"', 22, "a number, a name or ( is expected after +", ""),
        ('"x > 0"', 14, "only real quantities can be compared, and x is complex", ""),
        ('"a > j"', 14, "only real quantities can be compared, and one side is complex", ""),
        ('"m > 2"', 14, "this condition never holds", ""),
        ('"1 < a < 0"', 14, "this condition never holds", ""),
        ('"p < 0"', 14, "this condition contradicts 'assume', where p is positive", ""),
        ('"a^2 < 0"', 14, "this condition never holds", ""),
        ('"a^2 >= 0"', 14, "this condition always holds, so it says nothing", ""),
        ('"a > b", "b > c", "c > a"', 32, "this condition contradicts those before it", ""),
    ],
)
def test_what_is_no_condition_is_told_at_its_place(conditions, column, message, suggestion):
    text = (
        "parameters: {m: 1}\nassume: {x: complex, p: positive}\n"
        f"conditions: [{conditions}]\nsystem: {{A: [[a, b, x], [zeta, c, p], [0, m, 1]]}}\n" + FIND
    )
    assert complaints(text) == [(3, column, message, suggestion)]


def test_conditions_that_contradict_each_other_are_told_at_both_places():
    text = 'conditions: ["0 < a < 1", "a > 2"]\n' + PLANT + FIND
    told = "this condition contradicts another"
    assert complaints(text) == [(1, 14, told, ""), (1, 27, told, "")]


def test_a_contradiction_that_needs_algebra_is_found_in_the_child():
    problem = read('conditions: ["a b > 1", "a b < 0"]\n' + PLANT + FIND)
    with pytest.raises(InputError, match="contradicts those before it"):
        solve_within(problem)


def test_too_many_conditions_are_refused():
    listed = ", ".join(f'"a > {i}"' for i in range(21))
    assert complaints(f"conditions: [{listed}]\n" + PLANT + FIND)[0][2].startswith("there are 21 conditions")


def test_a_value_given_to_a_symbol_takes_it_out_of_the_conditions():
    text = (
        'conditions: ["0 < a < 2"]\n' + PLANT + "find:\n  p: {task: characteristic_polynomial, parameters: {a: %s}}\n"
    )
    assert solved(text % "1")["p"].status is Status.VERIFIED
    assert complaints(text % "3")[0][2] == "this condition never holds"


def test_a_part_adds_its_own_conditions_and_nothing_leaks():
    found = solved(
        "system: {A: [[0, 1], [-c, -b]]}\nfind:\n  u: stability\n"
        '  v: {task: stability, conditions: ["b > 0", "c > 0"]}\n  w: stability\n'
        '  x: {task: stability, conditions: ["c < 0"]}\n'
    )
    verdicts = {name: part.answers.get("verdict") for name, part in found.items()}
    assert (verdicts["v"], verdicts["x"]) == ("asymptotically stable", "unstable")
    assert (found["u"].status, found["u"].answers) == (found["w"].status, found["w"].answers)
    assert verdicts["u"] not in (verdicts["v"], verdicts["x"])


def test_an_answer_of_an_earlier_part_is_taken_with_the_symbols_of_the_part():
    found = solved(
        "system: {A: [[0, 1], [-c, -b]], B: [0, 1]}\nfind:\n"
        '  u: {task: pole_placement, poles: ["-p", "-1"], conditions: ["p > 0"]}\n'
        '  v: {task: stability, gain: {from: u}, conditions: ["p > 2", "b > 1"]}\n'
    )
    assert found["v"].status is Status.VERIFIED
    assert found["v"].answers["verdict"] == "asymptotically stable"


@pytest.mark.parametrize("conditions", ["", 'conditions: ["0 < zeta < 1"]\n', 'conditions: ["zeta > 1"]\n'])
def test_a_pair_with_a_root_is_a_pair(conditions):
    found = solved(
        conditions + "system: {A: [[0, 1], [0, -a]], B: [0, b]}\nfind:\n"
        '  p: {task: pole_placement, poles: ["-zeta*w ± j*w*sqrt(1-zeta^2)"]}\n'
        "  q: {task: pole_placement, damping_ratio: zeta, natural_frequency: w}\n"
    )
    assert [part.status for part in found.values()] == [Status.VERIFIED] * 2
    assert found["p"].answers["K"] == found["q"].answers["K"]


def test_parameters_with_conditions_cross_to_another_process():
    a, b = sp.symbols("a b", real=True)
    told = (Condition(a - b, ">"), Condition(a**2 - 1, "!="))
    value = sp.ImmutableMatrix([[Parameter("a", told, real=True) + 1, Parameter("b", told, real=True), a]])
    assert decode(encode(value)) == value


@pytest.mark.parametrize(
    ("language", "given", "own"),
    [
        (
            "en",
            r"with $\zeta, c > 0$, $n$ a whole number, $0 < \zeta < 1$ and $a \ne b$.",
            r"with $c < 0$ and $\zeta \le \frac{1}{2}$.",
        ),
        (
            "de",
            r"mit $\zeta, c > 0$, $n$ eine ganze Zahl, $0 < \zeta < 1$ und $a \ne b$.",
            r"mit $c < 0$ und $\zeta \le \frac{1}{2}$.",
        ),
    ],
)
def test_the_page_says_what_is_given(language, given, own):
    text = (
        "assume: {zeta: positive, n: integer, a: real, c: positive}\n"
        'conditions: ["0 < zeta < 1", "a != b"]\nsystem: {A: [[n, a], [b, zeta]]}\n'
        "find:\n  u: characteristic_polynomial\n  v: {task: pole_placement, system: {A: [[0]], B: [c]}, poles: [-1],\n"
        '    assume: {c: negative}, conditions: ["zeta <= 1/2"]}\n'
    )
    document = document_of(solve_problem(read(text)), Presentation(language=language))
    assert document.given.endswith(given)
    assert document.parts[0].given == ""
    assert document.parts[1].given.endswith(own)


def test_jumps_whose_order_the_conditions_say():
    found = solved(
        'find:\n  u: {task: response, system: {A: [[-1]], B: [1], C: [1]}, input: "step(t-T) - step(t-S)", '
        'kind: zero_state, conditions: ["0 < T < S"]}\n'
    )
    assert found["u"].status is Status.VERIFIED


def test_an_absolute_value_is_resolved_where_the_conditions_say_how():
    found = solved('find:\n  u: {task: stability, system: {A: [["-abs(a - b)"]]}, conditions: ["a < b"]}\n')
    (eigenvalue,) = found["u"].answers["eigenvalues"]
    assert {x.name: eigenvalue.coeff(x) for x in eigenvalue.free_symbols} == {"a": 1, "b": -1}


BOUNDS = st.lists(
    st.tuples(
        st.integers(-3, 3), st.sampled_from(["<", "<=", ">", ">=", "!="]), st.booleans(), st.sampled_from([1, -2])
    ),
    min_size=1,
    max_size=4,
)


@settings(max_examples=60)
@given(BOUNDS)
@example([(-1, "<", True, 1), (3, "<", True, 1)])
@example([(1, ">", True, 1), (-3, ">", True, 1)])
def test_of_several_bounds_the_narrowest_holds_and_none_may_contradict(bounds):
    """Each is written as `factor a < factor·bound`, from the left or from the right; the truth is tried on a grid."""
    turned = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "!=": "!="}
    compare = {"<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge, "!=": operator.ne}
    written = []
    for value, sign, left, factor in bounds:
        said = sign if (factor > 0) == left else turned[sign]
        pair = (f"{factor}*a", str(factor * value)) if left else (str(factor * value), f"{factor}*a")
        written.append(f"{pair[0]} {said} {pair[1]}")
    grid = [Fraction(n, 2) for n in range(-8, 9)]
    left_over = [x for x in grid if all(compare[sign](x, value) for value, sign, _, _ in bounds)]
    text = f"conditions: {json.dumps(written)}\n{PLANT}{FIND}"
    ordered = [(value, sign) for value, sign, _, _ in bounds if sign != "!="]
    if not [x for x in grid if all(compare[sign](x, value) for value, sign in ordered)]:
        assert "contradicts" in complaints(text)[0][2]
        return
    if left_over and set(left_over) != {0}:
        a = read(text).symbols["a"]
        assert a.is_positive is (True if min(left_over) > 0 else None if max(left_over) > 0 else False)


@pytest.mark.parametrize("condition", ["0 < a < 1/2", "0 < a < 1", "0 <= a <= 0"])
def test_numbers_that_are_near_each_other_stand_in_a_condition(condition):
    assert len(read(f'{PLANT}conditions: ["{condition}"]\n{FIND}').conditions) == 1


@pytest.mark.parametrize("condition", ["1/2 < a < 0", "1 < a < 1", "0 <= a <= -1/2"])
def test_a_condition_that_never_holds_is_refused(condition):
    ((*_, message, _),) = complaints(f'{PLANT}conditions: ["{condition}"]\n{FIND}')
    assert message == "this condition never holds"
