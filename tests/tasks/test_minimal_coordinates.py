"""Minimal realizations in small numbers: what a person would write, whichever way led there."""

import random

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from tests.helpers.asking import ask, system
from tests.helpers.fractions_of_polynomials import fraction, plant, s, values
from tests.helpers.tried import tried

M = sp.Matrix
SHAPES = [(1, 2), (2, 1), (2, 2), (2, 2), (2, 3), (3, 2), (3, 3), (3, 3)]
POLES = [-1, -2, -3, -4, -5, 1, 0]


def coordinates(result):
    return tuple(result.answers[name] for name in "ABC")


def test_what_cancels_in_an_entry_leaves_no_trace():
    result = ask("minimal_realization", plant([(2, s + 1)], [(s - 1, s**2 - 1)]))
    assert result.status is Status.VERIFIED, result.reason
    assert coordinates(result) == (M([[-1]]), M([[1]]), M([[2], [1]]))


@pytest.mark.parametrize(
    ("b", "c", "left"),
    [
        ([1, 1, 1, 0], [1, 1, 1, 1], (sp.diag(-1, -2), M([1, 1]), M([[2, 1]]))),
        ([1, 2, 1, 0], [1, 3, 1, 1], (sp.diag(-1, -2), M([1, 1]), M([[7, 1]]))),
        ([1, 0, 1, 1], [1, 1, 1, 0], (sp.diag(-1, -2), M([1, 1]), M([[1, 1]]))),
    ],
)
def test_of_a_diagonal_plant_a_diagonal_part_is_left(b, c, left):
    result = ask("minimal_realization", system(sp.diag(-1, -1, -2, -3), B=M(b), C=M([c])))
    assert result.status is Status.VERIFIED, result.reason
    assert coordinates(result) == left


def test_a_residue_of_rank_one_is_a_column_times_a_row():
    result = ask("minimal_realization", plant([(1, s + 1), (2, s + 1)], [(3, s + 1), (6, s + 1)]))
    assert [step.kind for step in result.steps] == ["as_given", "orders", "parts", "residue", "assembled"]
    assert coordinates(result) == (M([[-1]]), M([[1, 2]]), M([[1], [3]]))


def test_a_pair_of_poles_keeps_its_companion_block():
    rows = [(1, s**2 + 1), (2, s**2 + 1)], [(2 * s, s**2 + 1), (4 * s, s**2 + 1)]
    result = ask("minimal_realization", plant(*(list(row) for row in rows)))
    assert [step.kind for step in result.steps][3:] == ["chains", "reduction", "assembled"]
    assert coordinates(result) == (M([[0, 1], [-1, 0]]), M([[0, 0], [1, 2]]), M([[1, 0], [0, 2]]))


def test_the_shorter_chains_are_taken():
    by_rows = ask("minimal_realization", plant([(1, s + 1), (2, s + 1)], [(1, s + 2), (3, s + 2)]))
    assert coordinates(by_rows) == (sp.diag(-1, -2), M([[1, 2], [1, 3]]), sp.eye(2))


def test_with_parameters_too():
    a, b = sp.symbols("a b")
    result = ask("minimal_realization", plant([(1, s + a), (b, s + a)], [(2, s + a), (2 * b, s + a)]))
    assert result.status is Status.VERIFIED, result.reason
    assert coordinates(result) == (M([[-a]]), M([[1, b]]), M([[1], [2]]))


def test_a_constant_has_no_states():
    result = ask("minimal_realization", plant([(1, 1), (2, 1)], [(3, 1), (4, 1)]))
    assert (result.status, result.answers["A"].shape) == (Status.VERIFIED, (0, 0))


def generated(seed):
    """A transfer matrix of up to 3×3 with poles that entries share, some multiple, some complex."""
    draw = random.Random(seed)  # noqa: S311
    outputs, inputs = draw.choice(SHAPES)
    pool, kind = draw.sample(POLES, draw.choice([2, 3, 3, 4])), seed % 5
    return plant(*([_entry(draw, pool, kind) for _ in range(inputs)] for _ in range(outputs)))


def _entry(draw, pool, kind):
    n = draw.choice([1, 1, 2, 2])
    roots = draw.sample(pool, min(n, len(pool))) if kind < 3 else [draw.choice(pool) for _ in range(n)]
    pair = {3: s**2 + s + 1, 4: s**2 + 2 * s + 5}.get(kind)
    if pair is not None and draw.random() < 0.4:
        n, bottom = 2, pair
    else:
        bottom = sp.prod([s - root for root in roots])
    return sum(draw.randint(-3, 3) * s**i for i in range(n + (draw.random() < 0.15))), bottom


def bits(matrices):
    """The digits (to the base two) of the longest entry, of its numerator and denominator together."""
    numbers = {r for matrix in matrices for entry in matrix for r in entry.atoms(sp.Rational)} | {sp.Integer(0)}
    return max(int(abs(r.p)).bit_length() + (int(r.q).bit_length() if r.q != 1 else 0) for r in numbers)


@tried(50)
@given(st.integers(0, 49))
def test_entries_are_small_and_the_transfer_matrix_is_right(seed):
    """Before, the longest entries of these had up to 96 digits."""
    G = generated(seed)
    result = ask("minimal_realization", G)
    assert result.status is Status.VERIFIED, (G.matrix, result.reason)
    assert bits(coordinates(result)) <= 10, coordinates(result)
    for point in (0.37 + 0.81j, 2.31 - 1.1j):
        assert np.allclose(values(result.answers, point), fraction(G, point), rtol=1e-9, atol=1e-9)
