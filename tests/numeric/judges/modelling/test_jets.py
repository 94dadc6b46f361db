"""Equations in numbers: of several solutions the one near what is known."""

from __future__ import annotations

from random import Random

import pytest
import sympy as sp

from solver.numeric.judges.modelling.jets import JetEquations

z = sp.Symbol("z")


def roots(*equations, seed, near=None):
    chance = Random(seed)  # noqa: S311 - nothing secret
    found = JetEquations(equations, {z: ("z", 0)}, ["z"], {}).solved({}, chance, near)
    return None if found is None else found["z", 0]


@pytest.mark.parametrize("near", [-2, 2])
def test_a_solution_is_looked_for_near_known_values_first(near):
    for seed in range(4):
        assert roots(z**2 - 4, seed=seed, near={("z", 0): near + 0.1}) == pytest.approx(near)


def test_without_them_any_solution_is_found_and_none_where_there_is_none():
    assert roots(z**2 - 4, seed=1) ** 2 == pytest.approx(4)
    assert roots(z - 1, z - 2, seed=1) is None
