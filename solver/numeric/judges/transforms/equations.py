"""Do functions solve linear differential equations? By the transforms of both sides, and by the equations themselves.

The transform of f^(k) is s^k F − s^(k−1) f(0−) − …, whatever f does at zero, where F is the integral from 0−. So the
equality of the transforms says all: the equations, the values at 0−, and what jumps and impulses of inputs bring about.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.numeric.judges.time_response.response import intervals
from solver.numeric.judges.transforms.laplace import derivatives_of_impulses, transform_of
from solver.stated import Stated
from solver.stated.algebra import product, total
from solver.stated.calculus import derivative, value_at

Jet = tuple[str, int]


@dataclass(frozen=True)
class Problem:
    """Expressions that are zero in symbols of functions and their derivatives (`jets`).

    `inputs` are functions of t, `initial` the values at 0− of the others (zero where not given).
    """

    equations: Sequence[Any]
    jets: Mapping[Any, Jet]
    inputs: Mapping[str, Any]
    initial: Mapping[Jet, Any]


def transformed_sides(
    problem: Problem, functions: Mapping[str, Any], t: Any, s: Any
) -> Iterator[tuple[Stated, Stated]]:
    """Yield both sides of each equation transformed: unknowns on the left, inputs and values at 0− on the right."""
    whole = {name: transform_of(f, t, s) for name, f in {**functions, **problem.inputs}.items()}
    for equation in problem.equations:
        left, right, rest = [], [], sp.expand(equation)
        for symbol, (name, k) in problem.jets.items():
            c = sp.diff(equation, symbol)
            rest = sp.expand(rest - c * symbol)
            if c == 0:
                continue
            if name in problem.inputs:
                right.append(product(-c * s**k, whole[name]))
                continue
            left.append(product(c * s**k, whole[name]))
            right += [c * s ** (k - 1 - m) * problem.initial.get((name, m), sp.S.Zero) for m in range(k)]
        yield total(*left), total(*right, -rest / s)


def sides_in_time(problem: Problem, functions: Mapping[str, Any], t: Any) -> Iterator[tuple[Stated, Stated, Any]]:
    """Yield the equations between jumps, unknowns on the left, and the time at which the stretch begins."""
    smooth = {name: derivatives_of_impulses(f, t)[1] for name, f in {**functions, **problem.inputs}.items()}
    for span in intervals(t, *smooth.values()):
        here = {name: span.smooth(f, t) for name, f in smooth.items()}
        time = span.times(t, sp.S.One)[-1]
        for equation in problem.equations:
            left: list[Any] = []
            right: list[Any] = []
            rest = sp.expand(equation)
            for symbol, (name, k) in problem.jets.items():
                c = sp.diff(equation, symbol)
                rest = sp.expand(rest - c * symbol)
                side = right if name in problem.inputs else left
                if c != 0:
                    sign = -1 if name in problem.inputs else 1
                    side.append(product(sign * c, value_at(derivative(here[name], t, k), t, time)))
            yield total(*left), total(*right, -rest), span.start
