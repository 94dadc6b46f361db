"""Rounded values of which many are right: one choice of all decimals must satisfy all conditions together."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.lazy import numeric
from tests.helpers.marked import verdict

EIGEN = "{system: {A: [[2, 1, 0], [1, 3, 1], [0, 1, 5]]}, find: {a: eigenstructure}}"
V = np.linalg.eig(np.array([[2.0, 1, 0], [1, 3, 1], [0, 1, 5]]))[1]
V = (V / V[0])[:, np.argsort(V[1] / V[0])]  # −0.6996 0.1891, 1.2391 −0.7037, 3.4605 7.5146


def written(columns):
    rows = ("[" + ", ".join(f"{x:.2f}" for x in row) + "]" for row in columns[1:])
    return f"[[1, 1, 1], {', '.join(rows)}]"


def test_rounded_vectors_are_right():
    assert verdict(EIGEN, "a", "right_eigenvectors", written(V)).verdict == "correct"


@pytest.mark.parametrize(
    ("i", "j"),
    [(1, 0), (2, 1), *(pytest.param(*each, marks=pytest.mark.slow) for each in [(1, 1), (1, 2), (2, 0), (2, 2)])],
)
def test_a_decimal_off_by_more_than_its_rounding_is_not_excused_by_those_of_the_others(i, j):
    changed = np.round(V, 2)
    changed[i, j] += 0.01 if changed[i, j] > V[i, j] else -0.01
    found = verdict(EIGEN, "a", "right_eigenvectors", written(changed))
    assert found.verdict == "wrong"
    assert [row[j] for row in found.entries] == ["wrong"] * 3
    assert sum(word == "correct" for row in found.entries for word in row) == 6


@pytest.mark.parametrize(
    ("vectors", "right"),
    [
        ("[[2, 2], [2.4, -2.4]]", True),
        ("[[2, 2], [2.5, -2.5]]", False),
        ("[[1, 1], [1.22, -1.22]]", True),
        ("[[1, 1], [1.23, -1.23]]", False),
    ],
)
def test_half_a_unit_is_half_a_unit(vectors, right):
    surds = "{system: {A: [[1, 2], [3, 1]]}, find: {a: eigenstructure}}"  # columns (2, ±√6), √6 = 2.4495
    assert (verdict(surds, "a", "right_eigenvectors", vectors).verdict == "correct") == right


GAIN = """
system: {A: [[0, 1], [0, 0]], B: [[1, 0], [0, 1]]}
find:
  a: {task: pole_placement, method: unity_rank, poles: ["-1 ± 1j"]}
"""
# k11 + k22 = 2 and k11 k22 + k21 (1 − k12) = 2, e.g. [[2/3, 0], [10/9, 4/3]]


@pytest.mark.parametrize(
    ("K", "right"),
    [
        ("[[0.67, 0], [1.11, 1.33]]", True),
        ("[[0.67, 0], [1.11, 1.31]]", False),  # the sum is 1.99 at most
        ("[[0.66, 0], [1.11, 1.34]]", True),  # 0.665, 1.335 and 1.1122
        ("[[0.66, 0], [1.13, 1.34]]", False),  # with the sum 2 k21 is 1.119 at most
        ("[[0.6667, 0], [1.1111, 1.3333]]", True),
        ("[[0.6667, 0], [1.1121, 1.3333]]", False),
    ],
)
def test_a_gain_of_several_inputs_is_right_where_some_choice_places_the_poles(K, right):
    assert (verdict(GAIN, "a", "K", K).verdict == "correct") == right


@settings(max_examples=60, deadline=None)
@given(st.integers(1, 5), st.integers(0, 10**6), st.booleans(), st.booleans())
def test_linear_conditions_vanish_where_their_solution_is_in_the_box(n, seed, inside, joined):
    random = np.random.default_rng(seed)
    A = np.linalg.qr(random.normal(size=(n, n)))[0] * random.uniform(0.5, 2, n)
    u = random.uniform(-0.95, 0.95, n)
    if not inside:
        u[random.integers(n)] = random.choice([-1, 1]) * random.uniform(1.5, 3)

    def sizes(moved):
        left = np.abs(A @ (moved - u))
        return np.array([left.max()]) if joined else left

    assert numeric.can_vanish(sizes, n) == inside
