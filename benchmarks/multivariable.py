"""The Smith–McMillan form: ours with every operation as a step, and sympy's smith_normal_form over QQ[s]."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import reduce
from random import Random
from typing import Any

import sympy as sp
from sympy.matrices.normalforms import smith_normal_form

from benchmarks.timing import Failure, Row, side_by_side
from solver import exact
from solver.engine import found_by
from solver.problem.model import Part
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

s = sp.Symbol("s")


def three_by_three() -> sp.Matrix:
    """A 3×3 matrix of proper fractions, numerators and denominators of degree 4."""
    random = Random(4)
    below = (s + 1) * (s + 2) * (s + 3) * (s + 4)
    above = [sum(random.randint(-3, 3) * s**k for k in range(5)) for _ in range(9)]
    return sp.Matrix(3, 3, above) / below


def ours(G: sp.Matrix) -> Callable[[], Any]:
    """The form and the steps that lead to it."""
    rows = ", ".join("[" + ", ".join(f'"{sp.sstr(entry)}"' for entry in row) + "]" for row in G.tolist())
    text = f"system: {{transfer_matrix: [{rows}]}}\nfind: {{a: smith_mcmillan_form}}\n"
    part: Part = read_problem(Source("file.yaml", text), catalogue()).parts[0]
    return lambda: found_by(part.methods[0], part, {})


def form_alone(G: sp.Matrix) -> Callable[[], Any]:
    """The form without its steps, from numerators and denominators."""
    pairs = [[sp.fraction(entry) for entry in row] for row in G.tolist()]
    tops, bottoms = ([[sp.expand(pair[i]) for pair in row] for row in pairs] for i in (0, 1))
    return lambda: exact.smith_mcmillan(exact.transfer_matrix_of_fractions(tops, bottoms, s)).fractions


def by_sympy(G: sp.Matrix) -> Callable[[], Any]:
    """The numerators over the common denominator, sympy's normal form of them, divided and cancelled."""

    def run() -> Any:
        d = reduce(sp.lcm, (sp.denom(sp.together(entry)) for entry in G.flat()))
        N = (G * d).applyfunc(lambda entry: sp.expand(sp.cancel(entry)))
        form = smith_normal_form(N, domain=sp.QQ[s])
        return [sp.cancel(form[i, i] / d) for i in range(min(G.shape))]

    return run


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table."""
    G = three_by_three()
    mine, theirs = side_by_side(form_alone(G), by_sympy(G))
    yield Row("Smith–McMillan form, 3×3, degree 4", mine, "sympy smith_normal_form", theirs, 10)
    mine, _ = side_by_side(ours(G), lambda: None)
    yield Row("Smith–McMillan form, 3×3, with its steps", mine, at_most=150)
