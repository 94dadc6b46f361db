"""Names told beside a formula: what they stand for is put in their place, and nothing else is."""

from itertools import pairwise

import pytest

from solver.classroom.reading.definitions import own_statement, with_told_names, without_constants
from solver.classroom.reading.labels import Labels
from solver.derivation import AnswerName


def squeezed(text):
    return text.replace(" ", "")


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("A/(s+1) + B/s, A = 2, B = -1", "2/(s+1)+(-1)/s"),
        ("C1 = 5, C2 = a: C1 e^-t + C2", "5e^-t+(a)"),
        ("1/(1 + sT) with T = RC", "1/(1+s(RC))"),
        ("1/(1 + sT) (T = RC)", "1/(1+s(RC))"),
        ("(1-a)/(z-a), a = e^(-2T), T = 1", "(1-(e^(-2(1))))/(z-(e^(-2(1))))"),
        ("u(τ) e^-τ, τ = t - 1", "u(t-1)e^-(t-1)"),
        ("g(t-2), g(t) = t e^-t", "((t-2)e^-(t-2))"),
        ("cos ωt, ω = 3", "cos((3)t)"),
        ("ω²/(s + ω)², ω² = g/l", "(sqrt(g/l))²/(s+(sqrt(g/l)))²"),
        ("C2 = C1 = 1, C1 + C2 t", "1+1t"),
        ("[k1 k2 a], k1 = 8, k2 = -2", "[8-2a]"),
        ("y = K/s, x = 3", ""),
        ("K/s, K = 2", ""),
        ("a/s, a = b, b = a", ""),
        ("A/s, A = 2, A = 3", ""),
        ("B/s, B = 6/3 = 3", ""),
        ("cos ω t, ω = √2", ""),
        ("x1 = t, x2 = x1' = 1", ""),
        ("beta/s, a = 2", ""),
        ("k1 = 2a; k2 = 3k1", ""),
        ("1/s", ""),
        ("", ""),
    ],
)
def test_what_is_told_stands_in_place_of_the_names(text, found):
    assert squeezed(with_told_names(text, ["K", "s", "t", "z"], ["b", "R", "C", "RC", "g", "l"])) == found


def test_an_equation_and_its_roots_tell_nothing_where_numbers_are_asked_for():
    assert with_told_names("λ² - 4 = 0, λ = 2", [], []) == ""
    assert squeezed(with_told_names("x = λ² - 4, λ = 2", [], [])) == "x=(2)²-4"


def test_what_would_grow_without_bounds_is_not_read():
    names = "abcdefgh"
    told = ", ".join(f"{one} = " + " + ".join([other] * 12) for one, other in pairwise(names))
    assert with_told_names(f"a/s, {told}, h = 1", [], []) == ""


def test_constants_that_are_told_beside_a_formula_without_them_are_left_out():
    assert without_constants("A = 2, B = 1: 2/(s+1) + 1/(s+3)") == "2/(s+1) + 1/(s+3)"
    assert without_constants("K = 2: 1/(s+1)") == ""
    assert without_constants("A = 2, B = 1: 1/s, 2/s") == ""


def test_of_several_statements_the_own_one_counts():
    labels = Labels(AnswerName("f", "f", ""))
    assert own_statement("F(s) = 1/s, f(t) = 1", labels) == "f(t) = 1"
    assert own_statement("f = 1, f = 2", labels) == ""
    assert own_statement("F(s) = 1/s, 1", labels) == ""
