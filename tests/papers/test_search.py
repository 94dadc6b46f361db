"""The search for members: what holds of each, what was drawn, what rejected the others."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from solver.engine import solve_problem
from solver.executors import Processes
from solver.papers.constructions.eigenvalues import FromEigenvalues, matrix_with_integer_eigenvalues
from solver.papers.draws import Draws
from solver.papers.formulas import Formulas, eigenvalues
from solver.papers.generator import stream
from solver.papers.judging import Rejection
from solver.papers.niceness import is_nice, may_be_nice
from solver.papers.telling import shortage, took
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.papers.conftest import FAMILY
from tests.papers.searching import candidates

LQR = """\
parameters: {q: 1, w: 2}
vary: {q: {from: 1, to: 30}, w: {from: 0, to: 30}}
nice: {a.K: integers}
system: {A: [[0, 1], [0, 0]], B: [0, 1]}
find: {a: {task: lqr, Q: [[q, 0], [0, w]], R: 1}}
"""
DRAWN = ", ".join(f"{name}: {{from: -3, to: 3}}" for name in "abcdfghkl")
EIGENVALUES = f"""\
parameters: {{a: 2, b: 1, c: 0, d: 1, f: 3, g: 1, h: 0, k: 1, l: 2}}
vary: {{{DRAWN}}}
nice: {{a.eigenvalues: integers}}
system: {{matrix: [[a, b, c], [d, f, g], [h, k, l]]}}
find: {{a: eigenstructure}}
"""


def drawn(search):
    return [dict(each.draw.texts) for each in candidates(search)]


def test_an_exhausted_family_has_exactly_the_members_that_hold(search_of):
    """K = [p₁p₂ − a, −p₁ − p₂ + b] is in integers where b is an integer."""
    search = search_of()
    found = {(each["a"], each["b"], each["p"]) for each in drawn(search)}
    assert found == {(a, b, p) for a in "134" for b in ("-2", "-1", "0", "1", "2") for p in ("-4", "-3", "-2")}
    assert search.is_exhausted
    assert (search.draws, search.found, sum(search.rejections.values())) == (108, 45, 63)


def test_a_seed_draws_the_same_however_it_is_looked_at(search_of):
    first = drawn(search_of())[:6]
    with Processes(3) as executor:
        search = search_of(executor=executor)
        assert [dict(each.draw.texts) for each in candidates(search, 6)] == first
    assert [each["a"] + each["b"] + each["p"] for each in first] == FIRST
    assert drawn(search_of(seed=8))[:6] != first


FIRST = ["3-2-2", "4-2-2", "31-3", "40-4", "12-2", "31-4"]


def test_what_it_took_is_told(search_of):
    search = search_of()
    candidates(search)
    assert took(search) == "108 draws of 108 choices; rejected 48 by f.K: integers; 15 by a != 2"
    told = shortage(search, search.source, 60).render()
    assert "family.yaml:8:8: error: found 45 of 60 members: all 108 choices were drawn" in told
    assert "and 48 were rejected by 'f.K: integers', more than by anything else" in told
    search = search_of(most=5)
    candidates(search)
    assert "after 5 draws" in shortage(search, search.source, 60).render()
    assert "--draws N" in shortage(search, search.source, 60).render()
    search.rejections[Rejection.by_limits("time limit of 1 s")] = 2
    assert "2 draws met a limit; --time-limit" in shortage(search, search.source, 60).render()


def test_members_that_ask_the_same_are_one(search_of):
    text = FAMILY.replace("[p, -1]", "[p, q]").replace("p: -3}", "p: -3, q: -1}")
    text = text.replace("p: {choose: [-4, -3, -2]}", "p: {choose: [-4, -3]}\n  q: {choose: [-4, -3]}")
    text = text.replace("b: {from: -2, to: 2, step: 1/2}", "b: {choose: [1, 2]}")
    search = search_of(text)
    found = [frozenset({each["p"], each["q"]}) | {each["a"] + each["b"]} for each in drawn(search)]
    assert len(set(found)) == len(found)
    assert search.rejections[Rejection("it asks the same as another member", own=True)] > 0


def test_a_question_that_cannot_be_asked_is_no_member(search_of):
    text = "parameters: {a: 2}\nvary: {a: {from: -1, to: 2}}\nsystem: {A: [[0, 1], [0, 0]], B: [0, 1]}\n"
    text += "find: {f: {task: lqr, Q: [[1, 0], [0, 1]], R: a}}\n"
    search = search_of(text)
    assert sorted(each["a"] for each in drawn(search)) == ["1", "2"]
    assert {each.own for each in search.rejections} == {True}


@pytest.mark.parametrize(
    ("word", "holds"),
    [
        ("stable", {"-1"}),
        ("unstable", {"1"}),
        ("controllable", {"-1", "1"}),
        ("observable", {"0"}),
        ("minimal", {"-1", "1"}),
    ],
)
def test_words_about_the_system(search_of, word, holds):
    """Poles a and −2; the input reaches both where a ≠ 0, the output shows both where a = 0."""
    text = f"parameters: {{a: 2}}\nvary: {{a: {{from: -1, to: 1}}}}\nrequire: [{word}]\n"
    text += "system: {A: [[a, 0], [1, -2]], B: [a, 1], C: [1 - a^2, a]}\nfind: {f: stability}\n"
    if word == "observable":
        text = text.replace("C: [1 - a^2, a]", "C: [0, 1 - a^2]")
    if word == "controllable":
        text = text.replace("B: [a, 1]", "B: [a, 0]")
    assert {each["a"] for each in drawn(search_of(text))} == holds


@pytest.mark.parametrize(
    ("asked", "why"),
    [
        ("require: [observable]\nfind: {f: stability}",
         "it cannot be told whether it is observable: The question needs C; the system has only A and B"),
        ("nice: {f.fixed_poles: integers}\nfind: {f: {task: pole_placement, poles: [-1, -2]}}",
         "part f has no fixed_poles"),
    ],
)  # fmt: skip
def test_what_cannot_be_told_of_a_draw_is_no_word_that_is_wrong(search_of, asked, why):
    search = search_of("parameters: {a: 2}\nvary: {a: {from: 1, to: 2}}\n"
                       f"system: {{A: [[0, 1], [a, 0]], B: [0, 1]}}\n{asked}\n")  # fmt: skip
    assert drawn(search) == []
    assert search.rejections == {Rejection(why, own=True): 2}
    assert f"all 2 choices were drawn, and 2 were rejected: {why}" in shortage(search, search.source, 1).render()


@pytest.mark.parametrize(
    ("written", "members"),
    [
        ("a b = 6", {(2, 3), (3, 2)}),
        ("a^2 = 4b", {(2, 1), (4, 4)}),
        ("1 < a < b", {(2, 3), (2, 4), (3, 4)}),
        ("sqrt(a) = b", {(1, 1), (4, 2)}),
    ],
)
def test_equations_and_chains_hold_of_each_member(search_of, written, members):
    text = "parameters: {a: 2, b: 3}\nvary: {a: {from: 1, to: 4}, b: {from: 1, to: 4}}\nsystem: {A: [[0, 1], [a, b]]}\n"
    search = search_of(text + f'find: {{f: stability}}\nrequire: ["{written}"]\n')
    assert {(int(each["a"]), int(each["b"])) for each in drawn(search)} == members


def test_formulas_in_letters_leave_all_that_is_nice_and_little_else(search_of):
    search = search_of(LQR)
    formulas = Formulas.of(search.source, search.family)
    assert len(formulas.compiled) == 1
    draws = Draws(search.family, 7)
    places = [draws.places(number) for number in range(search.family.size)]
    left = [draws.at(at).values for at, why in zip(places, formulas.rejected(places), strict=True) if not why]
    squares = {(q, w) for q in range(1, 31) for w in range(31) if _square(q) and _square(w + 2 * sp.sqrt(q))}
    assert {(each["q"], each["w"]) for each in left} == squares
    assert {(int(each["q"]), int(each["w"])) for each in drawn(search)} == squares


def _square(number):
    return sp.sqrt(number).is_Integer


def test_eigenvalues_need_no_formula(search_of):
    search = search_of(EIGENVALUES)
    (formula,) = [each for each, _ in Formulas.of(search.source, search.family).compiled]
    assert formula.numbers is eigenvalues
    assert [len(row) for row in formula.pattern] == [3, 3, 3]
    for each in candidates(search, 3):
        (result,) = solve_problem(read_problem(Source("member.yaml", each.text), catalogue())).parts
        assert all(value.is_Integer for value in result.answers["eigenvalues"])


def test_the_eigenvalues_of_a_loop_are_not_those_of_the_matrix(search_of):
    text = """\
parameters: {a: 2, b: 1}
vary: {a: {from: -1, to: 1}, b: {from: 0, to: 2}}
nice: {f.eigenvalues: integers}
system: {A: [[0, 1], [2, a]], B: [0, 1]}
find: {f: {task: stability, gain: [1, b]}}
"""
    search = search_of(text)
    assert not any(each.numbers is eigenvalues for each, _ in Formulas.of(search.source, search.family).compiled)
    assert {(each["a"], each["b"]) for each in drawn(search)} == {(a, a) for a in "01"}


def test_matrices_of_integer_eigenvalues_are_constructed():
    bits = stream(3)
    for order in (2, 3, 4, 5):
        for _ in range(10):
            matrix = sp.Matrix(matrix_with_integer_eigenvalues(order, bits))
            assert all(entry.is_Integer for entry in matrix)
            assert sum(sp.roots(matrix.charpoly().as_expr()).values()) == order
            assert all(value.is_Integer for value in sp.roots(matrix.charpoly().as_expr()))


def test_constructed_draws_fit_the_values_and_the_fixed_entries(search_of):
    family = search_of(EIGENVALUES).family
    pattern = (("a", "b", "c"), ("d", "f", "g"), (0, "k", "l"))
    constructed, draws = FromEigenvalues(family, pattern, 7), Draws(family, 7)
    made = [constructed.at(number) for number in range(5)]
    assert made == [constructed.at(number) for number in range(5)]
    for places in made:
        values = draws.at(places).values
        matrix = np.array([[values.get(entry, entry) for entry in row] for row in pattern], dtype=float)
        eigenvalues = np.linalg.eigvals(matrix)
        assert np.allclose(eigenvalues, np.round(eigenvalues.real), atol=1e-4)


@pytest.mark.parametrize(
    ("value", "kinds"),
    [
        (sp.Integer(3), "integers rationals exact"),
        (sp.Rational(5, 12), "rationals exact"),
        (sp.Rational(5, 13), "exact"),
        (sp.sqrt(2), "exact"),
        (1 + sp.I, "exact"),
        (sp.Float("0.5"), ""),
        (sp.Matrix([[1, 2], [sp.Rational(1, 2), 0]]), "rationals exact"),
        ([sp.Integer(1), sp.Symbol("s") ** 2 + 3], "integers rationals exact"),
        (sp.Symbol("s") / 2, "rationals exact"),
        ({"a": sp.Integer(2), "b": True}, "integers rationals exact"),
        (sp.pi, "exact"),
    ],
)
def test_what_is_nice(value, kinds):
    assert [kind for kind in ("integers", "rationals", "exact") if is_nice(value, kind)] == kinds.split()


def test_what_may_be_nice():
    values = np.array([3.0, 3 + 1e-9, 0.5, 1 / 3, 0.3, 2 + 1j, np.nan, np.inf, 5 / 13], dtype=complex)
    assert may_be_nice(values, "integers").tolist() == [True, True, False, False, False, False, True, True, False]
    assert may_be_nice(values, "rationals").tolist() == [True, True, True, True, True, False, True, True, False]
