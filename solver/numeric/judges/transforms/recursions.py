"""Linear difference equations run through exactly, the equations solved for their latest samples at each step."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.time_response.response import sampled
from solver.stated import Stated
from solver.stated.calculus import value_at
from solver.stated.matrices import matrix_of

Jet = tuple[str, int]


@dataclass(frozen=True)
class Recursion:
    """Expressions that are zero in symbols of samples (`jets`: name and shift), for each k ≥ `first`.

    `inputs` are sequences in k, zero before 0; `initial` the values known (others are zero). What has no unknown and no
    input in an equation is zero before 0 where it starts `at_rest`.
    """

    equations: Sequence[Any]
    jets: Mapping[Any, Jet]
    inputs: Mapping[str, Any]
    initial: Mapping[Jet, Any]
    first: int
    at_rest: bool


@dataclass(frozen=True)
class _Row:
    """The weights of the latest samples and of the others in an equation, and the rest in k."""

    latest: Mapping[str, Any]
    others: Sequence[tuple[Jet, Any]]
    rest: Any


def values_of_recursion(problem: Recursion, k: Any, count: int) -> dict[str, list[Any]]:
    """Return the values at k = 0 … `count` − 1 by unknown. Raises NotEvaluable where no latest sample is given."""
    unknowns = sorted({x for x, _ in problem.jets.values() if x not in problem.inputs})
    tops = {x: max(q for y, q in problem.jets.values() if y == x) for x in unknowns}
    values = dict(problem.initial)
    rows = [_row(equation, problem, tops) for equation in problem.equations]
    matrix = sp.Matrix([[row.latest[x] for x in unknowns] for row in rows])
    if sp.expand(matrix.det()) == 0:
        raise NotEvaluable("the equations do not give the latest samples")
    inverse = matrix.inv()
    for step in range(problem.first, count - min(tops.values())):
        right = sp.Matrix([-_known_part(row, problem, values, k, step) for row in rows])
        found = (inverse * right).applyfunc(sp.expand)
        values |= {(x, step + tops[x]): found[j] for j, x in enumerate(unknowns)}
    return {x: [values.get((x, step), sp.S.Zero) for step in range(count)] for x in unknowns}


def _row(equation: Any, problem: Recursion, tops: Mapping[str, int]) -> _Row:
    latest, others = dict.fromkeys(tops, sp.S.Zero), []
    for symbol, (x, q) in problem.jets.items():
        weight = sp.diff(equation, symbol)
        if tops.get(x) == q:
            latest[x] += weight
        elif weight != 0:
            others.append(((x, q), weight))
    return _Row(latest, others, equation.xreplace(dict.fromkeys(problem.jets, sp.S.Zero)))


def _known_part(row: _Row, problem: Recursion, values: Mapping[Jet, Any], k: Any, step: int) -> Any:
    """What an equation has beside its latest samples."""
    whole = sp.Add(*(w * _known(problem, (x, step + q), values, k) for (x, q), w in row.others))
    if problem.at_rest and step < 0:
        return whole
    return whole + row.rest.xreplace({each: sp.Integer(step) for each in row.rest.free_symbols if str(each) == str(k)})


def _known(problem: Recursion, jet: Jet, values: Mapping[Jet, Any], k: Any) -> Any:
    """The value of an input or of an earlier sample."""
    name, at = jet
    if name not in problem.inputs:
        return values.get(jet, sp.S.Zero)
    return sp.S.Zero if at < 0 else sampled(problem.inputs[name], k).subs(k, at)


def first_values(f: Any, k: Any, count: int) -> Stated:
    """Return the column of f(0), f(1), …, stated, steps being one at their start."""
    whole = sampled(f, k)
    return matrix_of([[value_at(whole, k, sp.Integer(step))] for step in range(count)])
