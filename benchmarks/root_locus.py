"""Root loci: all data by the rules, with every step; beside python-control's branches, which are numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

import sympy as sp

from benchmarks.timing import Failure, Row, side_by_side
from solver.engine import found_by
from solver.problem.model import Part
from solver.systems import TransferFunction
from solver.tasks import catalogue

TASK = "root_locus"
s = sp.Symbol("s")
LOOPS = (
    ("root locus, order 4, complex poles", sp.Integer(1), s * (s + 4) * (s**2 + 4 * s + 20)),
    ("root locus, order 4, a zero, decimals", s + 1, s * (s - 1) * (s**2 + 4 * s + 16)),
)


def ours(N: sp.Expr, D: sp.Expr) -> Callable[[], Any]:
    """All answers, with the steps that lead to them."""
    declared = catalogue()[TASK]
    options = {name: each.default for name, each in declared.options.items() if each.default is not None}
    plant = TransferFunction(sp.ImmutableMatrix([[N / D]]), ((sp.expand(N),),), ((sp.expand(D),),), s)
    part = Part("a", TASK, tuple(declared.methods), plant, options)
    return lambda: found_by(part.methods[0], part, {}, [])


def by_control(N: sp.Expr, D: sp.Expr) -> Callable[[], Any]:
    """The branches at gains that python-control chooses."""
    control: Any = import_module("control")  # not a library of ours
    plant = control.tf(*([float(c) for c in sp.Poly(p, s).all_coeffs()] for p in (N, D)))
    return lambda: control.root_locus_map(plant)


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table."""
    for name, N, D in LOOPS:
        mine, theirs = side_by_side(ours(N, D), by_control(N, D))
        yield Row(name, mine, "python-control branches, numbers only", theirs, None, 60)
