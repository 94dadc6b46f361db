from __future__ import annotations

import pytest
import sympy as sp

from solver.problem.model import Reference
from solver.problem.refusals import refuse
from solver.problem.source import InputError

M = sp.ImmutableMatrix
t, k, s = sp.symbols("t k s")
a = sp.Symbol("a", real=True)
half = sp.Rational(1, 2)

TWO_BY_TWO = "A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]"
NAMED = TWO_BY_TWO + ", states: [p, v], outputs: [y]"
MIMO = "A: [[0, 1], [-2, -3]], B: [[1, 0], [0, 1]], C: [[1, 0], [0, 1]]"


@pytest.mark.parametrize(
    ("option", "text", "value", "system"),
    [
        ("count", "3", 3, TWO_BY_TWO),
        ("count", "'12'", 12, TWO_BY_TWO),
        ("band", "5%", "5%", TWO_BY_TWO),
        ("dual", "true", True, TWO_BY_TWO),
        ("dual", "false", False, TWO_BY_TWO),
        ("ratio", "14%", sp.Rational(7, 50), TWO_BY_TWO),
        ("ratio", "0.5 %", sp.Rational(1, 200), TWO_BY_TWO),
        ("ratio", "0.14", sp.Rational(7, 50), TWO_BY_TWO),
        ("ratio", "a/2", a / 2, TWO_BY_TWO),
        ("plain", "sqrt(2)", sp.sqrt(2), TWO_BY_TWO),
        ("shape", "exp(-2t) + k", sp.exp(-2 * t) + sp.Symbol("k", real=True), TWO_BY_TWO),
        ("shape", "2^k", 2**k, TWO_BY_TWO + ", time: discrete"),
        ("input", "exp(-2t)", (sp.exp(-2 * t),), TWO_BY_TWO),
        ("input", "[1, t]", (1, t), TWO_BY_TWO),
        ("poles", "['-3 ± 2j']", (-3 + 2 * sp.I, -3 - 2 * sp.I), TWO_BY_TWO),
        ("poles", "-3 ± 2j", (-3 + 2 * sp.I, -3 - 2 * sp.I), TWO_BY_TWO),
        ("poles", "[-1, -2+j, -2-j]", (-1, -2 + sp.I, -2 - sp.I), TWO_BY_TWO),
        ("poles", "[-1, -1, -a]", (-1, -1, -a), TWO_BY_TWO),
        ("poles", "[-1/2 ± j sqrt(3)/2]", (-half + sp.I * sp.sqrt(3) / 2, -half - sp.I * sp.sqrt(3) / 2), TWO_BY_TWO),
        ("poles", "[2(-1+j), -2-2j]", (-2 + 2 * sp.I, -2 - 2 * sp.I), TWO_BY_TWO),
        ("poles", "[(1+j)^2, -2j]", (2 * sp.I, -2 * sp.I), TWO_BY_TWO),
        ("poles", "[-a + j, -a - j]", (-a + sp.I, -a - sp.I), TWO_BY_TWO),
        ("Q", "[[1, 0], [0, 1/2]]", M([[1, 0], [0, half]]), TWO_BY_TWO),
        ("R", "1", M([[1]]), TWO_BY_TWO),
        ("R", "[1]", M([[1]]), TWO_BY_TWO),
        ("R", "[[1, 0], [0, 2]]", M([[1, 0], [0, 2]]), MIMO),
        ("gain", "[13, 8]", M([[13, 8]]), TWO_BY_TWO),
        ("gain", "[[13, 8]]", M([[13, 8]]), TWO_BY_TWO),
        ("gain", "[[1, 2], [3, 4]]", M([[1, 2], [3, 4]]), MIMO),
        ("gain", "[a, 0.5]", M([[a, half]]), TWO_BY_TWO),
        ("L", "[1, 2]", M([1, 2]), TWO_BY_TWO),
        ("L", "[[1], [2]]", M([1, 2]), TWO_BY_TWO),
        ("gain", "5", M([[5]]), "A: 1, B: 2"),
        ("output", "1", 0, TWO_BY_TWO),
        ("output", "2", 1, MIMO),
        ("output", "y", 0, NAMED),
        ("state", "v", 1, NAMED),
        ("state", "2", 1, TWO_BY_TWO),
        ("parameters", "[a, b]", ("a", "b"), "A: [[a, 1], [0, b]]"),
        ("parameters", "a", ("a",), "A: [[a, 1], [0, b]]"),
        ("parameters", "[p, 2]", ("p", "2"), NAMED),
        ("target", "(s+1)/(s+1)^2", 1 / (s + 1), TWO_BY_TWO),
        ("target", "{poles: [-1]}", 1 / (s + 1), TWO_BY_TWO),
        ("target", "{numerator: 1, denominator: [1, 1]}", 1 / (s + 1), TWO_BY_TWO),
    ],
)
def test_every_kind_of_option_is_read(part, option, text, value, system):
    found = part(f"{{task: options, {option}: {text}}}", system).options
    assert found[option] == value
    assert type(found[option]) is type(value) or isinstance(found[option], sp.Basic)


def test_defaults_are_filled_in(part):
    found = part("options").options
    assert found == {"band": "2%", "dual": False, "defaulted": M([[1, sp.Rational(3, 4)]])}


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ("count: 0", "count must be a whole number of at least 1 and at most 12"),
        ("count: 13", "count must be a whole number of at least 1 and at most 12"),
        ("count: 2.5", "count must be a whole number of at least 1 and at most 12, not '2.5'"),
        ("count: 1e9", "count must be a whole number of at least 1 and at most 12, not '1e9'"),
        ("count: " + "9" * 50, "count must be a whole number of at least 1 and at most 12, not '" + "9" * 40 + "'"),
        ("count: [1]", "a number or an expression is expected here, not a list"),
        ("count: ", "a number or an expression is expected here, not nothing"),
        ("band: 3%", "band must be one of 2%, 5%, not '3%'"),
        ("band: [2%]", "band must be one of 2%, 5%, not a list"),
        ("dual: yes", "dual must be true or false, not 'yes'"),
        ("dual: 1", "dual must be true or false, not '1'"),
        ("dual: 'true'", "dual must be true or false, not 'true'"),
        ("plain: 14%", "the character % has no meaning in an expression"),
        ("ratio: '%'", None),
        ("ratio: true", "a number or an expression is expected here, not true or false"),
        ("shape: s + t", "'s' cannot stand here: s is the variable of the Laplace transform"),
        ("shape: {x: 1}", "a number or an expression is expected here, not a mapping"),
        ("input: []", "the list is empty"),
        ("input: [1, [2]]", "a number or an expression is expected here, not a list"),
        ("poles: [-1+j]", "the pole -1+j has no conjugate"),
        ("poles: [j, j, -j]", "the pole j has no conjugate"),
        ("poles: [-1+j, -1-2j]", "the pole -1+j has no conjugate"),
        ("poles: [t]", "'t' cannot stand here: t is the time"),
        ("poles: [inf]", "a finite value is expected here"),
        ("poles: [" + ", ".join(["-1"] * 25) + "]", "there are 25 poles; at most 24 can be read"),
        ("Q: [1, 2]", "Q must have 2 rows for the states, it has 1"),
        ("Q: 1", "Q must have 2 rows for the states, it has 1"),
        ("Q: [[1, 2], [3]]", "Q has 2 rows, row 2 has 1 entry"),
        ("Q: {x: 1}", "a number or an expression is expected here, not a mapping"),
        ("Q: [[[1]]]", "a number or an expression is expected here, not a list"),
        ("Q: []", "Q is empty"),
        ("R: [[1, 0], [0, 1]]", "R must have 1 row for the inputs, it has 2"),
        ("gain: [1, 2, 3]", "gain must have 2 columns for the states, it has 3"),
        ("gain: [[1], [2]]", "gain must have 1 row for the inputs, it has 2"),
        ("L: [1, 2, 3]", "L must have 2 rows for the states, it has 3"),
        ("output: 2", "output: there are 1 of them, so it is not a number of an output"),
        ("output: 0", "output: there are 1 of them, so it is not a number of an output"),
        ("output: w", "output must be an output by its number from 1"),
        ("parameters: [q]", "'q' is no name in the system"),
        ("parameters: []", "the list is empty"),
        ("parameters: [1, 1]", "'1' is given twice"),
        ("parameters: [3]", "'3' is no name in the system"),
        ("target: s", "the transfer function is improper: its numerator has degree 1, its denominator 0"),
        ("target: {numerator: 1}", "'denominator' is missing here"),
        ("target: {polse: 1}", "unknown key 'polse'"),
        ("target: [1]", "a number or an expression is expected here, not a list"),
        ("cuont: 1", "options has no option 'cuont'"),
    ],
)  # fmt: skip
def test_what_is_wrong_with_an_option_is_said(complaints, given, expected):
    found = complaints(f"system: {{{TWO_BY_TWO}}}\nfind:\n  a: {{task: options, {given}}}\n")
    assert len(found) == 2 if "j, -1-2j" in given else len(found) == 1
    assert expected is None or found[0].split(" ", 1)[1] == expected
    assert found[0].startswith("3:")


def test_the_unpaired_pole_is_underlined_and_its_conjugate_named(read):
    with pytest.raises(InputError) as caught:
        read(f"system: {{{TWO_BY_TWO}}}\nfind:\n  a: {{task: options, poles: [-1, -2 + 3j]}}\n")
    assert caught.value.render().split("\n")[2:] == [
        "       |                                  ^^^^^^^",
        "       = complex poles come in pairs: -2 - 3j is missing",
    ]


def test_matrices_whose_size_is_unknown_are_not_checked_for_it(complaints):
    found = complaints("system: {A: [[1, 2], [3]]}\nfind:\n  a: {task: options, Q: [[1]], count: 0}\n")
    assert [line.split(" ")[0] for line in found] == ["1:22-25", "3:39-40"]


def test_an_answer_of_an_earlier_part_is_referred_to(read):
    problem = read(
        f"system: {{{TWO_BY_TWO}}}\nfind:\n"
        "  a: {task: placement, poles: [-1, -2]}\n"
        "  b: {task: stability, gain: {from: a}}\n"
        "  e: desired\n"
        "  c: {task: options, Q: {from: a, answer: closed_loop_A}, poles: {from: e, answer: poles}}\n"
    )
    parts = {each.id: each.options for each in problem.parts}
    assert parts["b"]["gain"] == Reference("a", "K")
    assert parts["c"]["Q"] == Reference("a", "closed_loop_A")
    assert parts["c"]["poles"] == Reference("e", "poles")


def test_a_reference_takes_the_answer_of_the_options_own_name(read):
    problem = read(f"system: {{{TWO_BY_TWO}}}\nfind:\n  a: desired\n  b: {{task: placement, poles: {{from: a}}}}\n")
    assert problem.parts[1].options["poles"] == Reference("a", "poles")


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ("gain: {from: z}", "'z' is not an earlier part"),
        ("gain: {from: b}", "'b' is not an earlier part"),
        ("gain: {from: later}", "'later' is not an earlier part"),
        ("gain: {from: a, answer: k}", "part a (placement) gives no 'k'"),
        ("observer_gain: {from: a}", "part a (placement) gives no 'L'"),
        ("Q: {from: a}", "part a (placement) gives no 'Q'"),
        ("gain: {from: a, answr: K}", "unknown key 'answr' beside 'from'"),
        ("gain: {from: [a]}", "a number or an expression is expected here, not a list"),
        ("gain: {from: }", "a number or an expression is expected here, not nothing"),
        ("count: {from: a}", "'count' cannot be taken from an earlier part"),
        ("band: {from: a}", "'band' cannot be taken from an earlier part"),
    ],
)
def test_what_is_wrong_with_a_reference_is_said(complaints, given, expected):
    text = (
        f"system: {{{TWO_BY_TWO}}}\nfind:\n  a: {{task: placement, poles: [-1, -2]}}\n"
        f"  b: {{task: options, {given}}}\n  later: stability\n"
    )
    (found,) = complaints(text)
    assert found.split(" ", 1)[1] == expected
    assert found.startswith("4:")


def test_an_answer_must_be_given_by_the_first_method_of_the_part(complaints, read):
    text = "system: {A: 1}\nfind:\n  a: {task: transition, method: METHODS}\n"
    text += "  b: {task: options, Q: {from: a, answer: Phi_truncated}}\n"
    assert read(text.replace("METHODS", "[series, laplace]")).parts[1].options["Q"] == Reference("a", "Phi_truncated")
    (found,) = complaints(text.replace("METHODS", "[laplace, series]"))
    assert found.endswith("part a (transition) gives no 'Phi_truncated'")


def test_a_reference_to_a_part_that_is_wrong_itself_adds_no_complaint(complaints):
    found = complaints(
        f"system: {{{TWO_BY_TWO}}}\nfind:\n  a: {{task: placemnt, poles: [-1]}}\n  c: {{task: [x]}}\n"
        "  b: {task: stability, gain: {from: a}}\n  d: {task: stability, gain: {from: c}}\n"
    )
    assert [line.split(":")[0] for line in found] == ["3", "4"]


def test_reading_asks_no_task_what_it_refuses(read):
    assert read(f"system: {{{TWO_BY_TWO}}}\nfind:\n  a: {{task: placement, poles: [-1, -2, -3]}}\n").parts


def test_what_a_task_refuses_is_reported_at_its_option_and_at_the_task_where_there_is_none(read):
    text = f"system: {{{TWO_BY_TWO}}}\nfind:\n  a: {{task: placement, poles: [-1, -2, -3]}}\n  b: stability\n"
    with pytest.raises(InputError) as caught:
        refuse(read(text), {"a": [("poles", "too many"), ("gain", "not given")], "b": [("", "a bad question")]})
    assert [line.split(":", 1)[1] for line in caught.value.render().split("\n") if "error" in line] == [
        "3:13: error: not given",
        "3:31: error: too many",
        "4:6: error: a bad question",
    ]
    assert "^" * len("[-1, -2, -3]") in caught.value.render()


def test_a_problem_without_refusals_is_accepted(read):
    assert refuse(read(f"system: {{{TWO_BY_TWO}}}\nfind: {{a: stability}}\n"), {"a": []}) is None


def test_options_from_an_earlier_part_are_not_refused_yet(read):
    problem = read(
        f"system: {{{TWO_BY_TWO}}}\nfind:\n  a: {{task: desired, overshoot: 5%}}\n"
        "  b: {task: placement, poles: {from: a}}\n"
    )
    assert problem.parts[1].options["poles"] == Reference("a", "poles")
