"""A small family, and a search in it."""

from __future__ import annotations

import pytest

from solver.limits.child import load_all_algebra
from solver.papers.search import Search
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.papers.searching import Here

FAMILY = """\
title: A family
parameters: {a: 2, b: 3, p: -3}
vary:
  a: {from: 1, to: 4}
  b: {from: -2, to: 2, step: 1/2}
  p: {choose: [-4, -3, -2]}
require: ["a != 2", controllable]
nice: {f.K: integers}
system: {A: [[0, 1], [-a, b]], B: [0, 1]}
find:
  f: {task: pole_placement, poles: [p, -1]}
"""


@pytest.fixture(scope="session")
def loaded():
    """Load the algebra once, and not in each process that judges."""
    load_all_algebra()


@pytest.fixture
def search_of():
    """Return the search of a family that is given as text; its draws are judged in this process."""

    def of(text=FAMILY, seed=7, **facts):
        source = Source("family.yaml", text)
        return Search(source, read_problem(source, catalogue()).family, seed, **{"executor": Here(), **facts})

    return of
