"""Draws made from their answer: they are drawn from what the file gives, by the seed alone, and come out nicely."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import scipy.linalg
import sympy as sp

from solver.papers.constructions.building import constructions_of, relations_of
from solver.papers.constructions.relations import Relations, linear
from solver.papers.constructions.solved import TRIED, stable_coefficients
from solver.papers.draws import Draws
from solver.papers.generator import stream
from solver.papers.judging import Rejection
from solver.papers.search import BEFORE
from solver.papers.telling import shortage
from tests.papers.searching import candidates

REGULATOR = """\
parameters: {a: 0, b: 0, q_1: 1, q_2: 3, q_3: 3, r: 1}
vary:
  a: {from: -3, to: 3}
  b: {from: -3, to: 3}
  q_1: {from: 0, to: 400}
  q_2: {from: 0, to: 200}
  q_3: {from: 0, to: 100}
  r: {from: 1, to: 4}
nice: {f.K: integers, f.P: integers}
system: {A: [[0, 1, 0], [0, 0, 1], [a, b, 0]], B: [0, 0, 1], C: [1, 0, 0]}
find: {f: {task: lqr, Q: [[q_1, 0, 0], [0, q_2, 0], [0, 0, q_3]], R: r}}
"""
FILTER = REGULATOR.replace("f.K", "f.L").replace("lqr", "kalman_filter").replace(
    "A: [[0, 1, 0], [0, 0, 1], [a, b, 0]]", "A: [[0, 0, a], [1, 0, b], [0, 1, 0]]"
).replace("C: [1, 0, 0]", "C: [0, 0, 1]")  # fmt: skip
ONLY_P = REGULATOR.replace("f.K: integers, ", "")
WHOLE_POLES = REGULATOR.replace("f.P", "f.eigenvalues")
FOUR = """\
parameters: {q_1: 1, q_2: 2, q_3: 2, q_4: 1}
vary: {q_1: {from: 0, to: 400}, q_2: {from: 0, to: 400}, q_3: {from: 0, to: 200}, q_4: {from: 0, to: 100}}
nice: {f.K: integers, f.P: integers}
system: {A: [[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [0, 0, 0, 0]], B: [0, 0, 0, 1]}
find: {f: {task: lqr, Q: [[q_1, 0, 0, 0], [0, q_2, 0, 0], [0, 0, q_3, 0], [0, 0, 0, q_4]], R: 1}}
"""
FULL = """\
parameters: {q_1: 4, q_2: 1, q_3: 4, b: 1}
vary: {q_1: {from: 0, to: 900}, q_2: {from: -400, to: 400}, q_3: {from: 0, to: 900}, b: {from: 1, to: 5}}
nice: {f.P: integers, f.K: integers}
system: {A: [[1, b], [-2, 3]], B: [[1, 0], [1, 1]]}
find: {f: {task: lqr, Q: [[q_1, q_2], [q_2, q_3]], R: [[1, 0], [0, 1]]}}
"""
DRAWN = ", ".join(f"{name}: {{from: -30, to: 30}}" for name in "abc")
GAINS = f"""\
parameters: {{a: 1, b: 2, c: 3, p: -2, q: -3, w: 1}}
vary: {{{DRAWN}, p: {{from: -6, to: -1}}, q: {{from: -6, to: -1}}, w: {{choose: [1, 2, 3]}}}}
nice: {{f.K: integers}}
system: {{A: [[a, 7, 0], [b, 1, 5], [c, 0, 2]], B: [0, 3, 4], C: [1, 0, 0]}}
find: {{f: {{task: pole_placement, poles: [p, "q ± w j"]}}}}
"""
OBSERVER = GAINS.replace("f.K", "f.L").replace("pole_placement", "observer").replace(
    "A: [[a, 7, 0], [b, 1, 5], [c, 0, 2]]", "A: [[a, b, c], [7, 1, 0], [0, 5, 2]]"
).replace("C: [1, 0, 0]", "C: [0, 3, 4]")  # fmt: skip


def constructed(search, count=10):
    """Return the values of the first draws that are constructed."""
    (construction,) = constructions_of(search.source, search.family, search.seed, ())
    draws = Draws(search.family, search.seed, [construction])
    return [draws.at(at).values for number in range(count) if (at := construction.at(number)) is not None]


def at(rows, values):
    return np.array(sp.Matrix(rows).subs({sp.Symbol(name): value for name, value in values.items()}), dtype=float)


def whole(matrix):
    return np.allclose(matrix, np.round(matrix), atol=1e-6)


def lqr_of(values, order):
    """P and K of a regulator in a row of integrators, by scipy."""
    A, B = np.diag(np.ones(order - 1), 1), np.eye(order)[:, -1:]
    A[-1, :2] = [float(values.get("a", 0)), float(values.get("b", 0))]
    Q, r = np.diag([float(values[f"q_{i + 1}"]) for i in range(order)]), float(values.get("r", 1))
    P = scipy.linalg.solve_continuous_are(A, B, Q, [[r]])
    return P, B.T @ P / r, A


@pytest.mark.parametrize(("text", "order"), [(REGULATOR, 3), (FILTER, 3), (FOUR, 4)], ids=["lqr", "filter", "four"])
def test_regulators_are_chosen_by_their_gain(search_of, text, order):
    """The filter of the transposed plant has the P of the regulator."""
    found = constructed(search_of(text))
    assert len(found) >= 8
    for values in found:
        P, K, _ = lqr_of(values, order)
        assert whole(P)
        assert whole(K)


def test_the_gain_may_be_what_it_is_where_only_P_must_be_nice(search_of):
    found = constructed(search_of(ONLY_P))
    assert len(found) >= 8
    assert all(whole(lqr_of(values, 3)[0]) for values in found)


def test_the_poles_of_the_loop_may_be_chosen(search_of):
    for values in constructed(search_of(WHOLE_POLES)):
        _, K, A = lqr_of(values, 3)
        assert whole(K)
        poles = np.linalg.eigvals(A - np.eye(3)[:, -1:] @ K)
        assert np.allclose(poles, np.round(poles.real), atol=1e-3)


def test_a_weight_of_letters_takes_any_P(search_of):
    """Two inputs, and a weight with as many letters as P has."""
    found = constructed(search_of(FULL))
    assert len(found) >= 8
    for values in found:
        A, B, R = at([[1, sp.Symbol("b")], [-2, 3]], values), np.array([[1.0, 0], [1, 1]]), np.eye(2)
        q = [float(values[f"q_{i}"]) for i in (1, 2, 3)]
        assert whole(scipy.linalg.solve_continuous_are(A, B, [[q[0], q[1]], [q[1], q[2]]], R))


@pytest.mark.parametrize("text", [GAINS, OBSERVER], ids=["placement", "observer"])
def test_gains_are_chosen_before_the_plant(search_of, text):
    """Observers are placed for the transposed plant."""
    found = constructed(search_of(text))
    assert len(found) >= 5
    for values in found:
        a, b, c, p, q, w = (float(values[name]) for name in "abcpqw")
        A, B = np.array([[a, 7, 0], [b, 1, 5], [c, 0, 2]]), np.array([[0], [3], [4.0]])
        K = scipy.signal.place_poles(A, B, [p, q + w * 1j, q - w * 1j]).gain_matrix
        assert np.allclose(K, np.round(K), atol=1e-4)


@pytest.mark.parametrize(
    ("required", "holds"),
    [
        ("a b = 600", lambda a, b, c: a * b == 600),
        ("a^2 - 4 b c = 1", lambda a, b, c: a * a - 4 * b * c == 1),
        ("2a + b = c = 70", lambda a, b, c: 2 * a + b == c == 70),
    ],
)
def test_equations_are_solved_for_a_name(search_of, required, holds):
    text = (
        "parameters: {a: 20, b: 30, c: 70}\nvary: {a: {from: 1, to: 99}, b: {from: 1, to: 99}, c: {from: 1, to: 99}}\n"
    )
    search = search_of(text + f'system: {{A: [[a, b], [c, 0]]}}\nfind: {{f: stability}}\nrequire: ["{required}"]\n')
    for values in constructed(search):
        assert holds(*(values[name] for name in "abc"))
    found = candidates(search, 6)
    assert len(found) == 6
    assert found[-1].number < 400


def test_a_member_is_drawn_by_its_number_alone(search_of):
    search = search_of(REGULATOR)
    one, two = (constructions_of(search.source, search.family, search.seed, ())[0] for _ in range(2))
    found = [two.at(number) for number in range(10)]
    assert [one.at(number) for number in (9, 3, 5)] == [found[9], found[3], found[5]]


def test_every_other_draw_is_constructed(search_of):
    search = search_of(REGULATOR)
    found = candidates(search, 6)
    assert [each.number for each in found] == [1, 3, 5, 7, 9, 11]
    assert search.rejections[Rejection("f.K: integers")] + search.rejections[Rejection("f.P: integers")] == 5


def test_what_cannot_be_chosen_first_is_given_up(search_of):
    """The two halves of what is required contradict each other."""
    text = "parameters: {a: 20, b: 30}\nvary: {a: {from: 1, to: 999}, b: {from: 1, to: 999}}\n"
    search = search_of(text + "system: {A: [[a, b], [1, 0]]}\nfind: {f: stability}\nrequire: [a = b, a = b + 1]\n")
    (construction,) = constructions_of(search.source, search.family, search.seed, ())
    assert [construction.at(number) for number in range(TRIED + 500)] == [None] * (TRIED + 500)
    search.most = 600  # of which every other one is the one before
    assert candidates(search) == []
    assert search.rejections[BEFORE] == 300
    assert "after 600 draws, and 300 were rejected by 'a = b'" in shortage(search, search.source, 1).render()


def test_a_small_family_is_looked_through(search_of):
    search = search_of(REGULATOR.replace("to: 400", "to: 1").replace("to: 200", "to: 3").replace("to: 100", "to: 3"))
    assert search.family.size == 2 * 4 * 4 * 7 * 7 * 4
    assert constructions_of(search.source, search.family, search.seed, ()) == []


def test_a_draw_that_was_made_before_is_none(search_of):
    search = search_of(FOUR, most=400)
    found = [each.draw.told for each in candidates(search)]
    assert len(set(found)) == len(found) > 20
    assert search.rejections[BEFORE] > 0


def test_there_are_no_relations_of_several_gains_or_of_discrete_time(search_of):
    discrete = REGULATOR.replace("system: {", "system: {time: discrete, ")
    several = GAINS.replace("B: [0, 3, 4]", "B: [[0, 1], [3, 0], [4, 0]]")
    for text in (discrete, several):
        search = search_of(text)
        assert relations_of(search.source, search.family) == []


def test_equations_are_linear_in_what_they_are_solved_for():
    a, b, c, x = sp.symbols("a b c x")
    found = linear(Relations((a * b - 6,), letters=((("a", "b"), 1),)))
    assert (found.solved, found.given) == (("a",), ("b",))
    assert linear(Relations((a**2 - 2,), letters=((("a",), 1),))) is None
    assert linear(Relations((sp.sin(a) - b,), letters=((("a", "b"), 1),))) is None
    assert linear(Relations((a * x - b / c, x + a), unknown=(("x", ""),), letters=((("a", "b"), 2),))).solved == (
        "b",
        "x",
    )


def test_stable_polynomials_are_stable():
    bits = stream(5)
    for order in (1, 2, 3, 4, 5):
        for full in (False, True):
            coefficients = stable_coefficients(order, bits, whole=full)
            assert all(isinstance(each, Fraction) and each.denominator == 1 for each in coefficients)
            roots = np.roots([1.0, *(float(each) for each in reversed(coefficients))])
            assert max(roots.real) < 0
            if full:
                polynomial = sp.Poly([1, *(int(each) for each in reversed(coefficients))], sp.Symbol("s"))
                assert sum(polynomial.ground_roots().values()) == order
