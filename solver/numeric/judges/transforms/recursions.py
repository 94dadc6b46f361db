"""Linear difference equations run through numerically, the equations solved for their latest samples at each step."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath
import sympy as sp

from solver.numeric.evaluation.points import admissible, free_symbols
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.time_response.response import sampled

Jet = tuple[str, int]
DIGITS = 30


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


def recursion_residual(problem: Recursion, sequences: Mapping[str, Any], k: Any, count: int) -> float:
    """Return the largest relative difference between sequences and the recursion at k = 0 … `count` − 1.

    A sequence is an expression in k or the list of its first values. Raises NotEvaluable where no latest sample comes
    from the equations.
    """
    known = [each for each in sequences.values() for each in (each if isinstance(each, Sequence) else [each])]
    symbols = free_symbols([*problem.equations, *problem.inputs.values(), *problem.initial.values(), *known])
    own = {symbol for symbol in symbols if symbol not in problem.jets and str(symbol) != str(k)}
    worst = 0.0
    for point in admissible(frozenset(own), 2) if own else [{}]:
        values = {symbol: sp.Float(complex(value).real, DIGITS) for symbol, value in point.items()}
        found = _run(problem, values, k, count)
        for name, sequence in sequences.items():
            for step in range(min(count, len(sequence)) if isinstance(sequence, Sequence) else count):
                told = sequence[step] if isinstance(sequence, Sequence) else sampled(sequence, k).subs(k, step)
                wanted = found.get((name, step), mpmath.mpf(0))
                difference = abs(_number(told, values) - wanted)
                worst = max(worst, float(difference / (1 + abs(wanted))))
    return worst


def _number(value: Any, point: Mapping[Any, Any]) -> Any:
    number = sp.N(value.xreplace(point) if isinstance(value, sp.Basic) else value, DIGITS)
    if number.free_symbols or number.has(sp.nan, sp.zoo, sp.oo):
        raise NotEvaluable("a value of the sequence is no number")
    return mpmath.mpmathify(complex(number)) if number.has(sp.I) else mpmath.mpf(str(number))


@dataclass(frozen=True)
class _Row:
    """The weights of the latest samples and of the others in an equation at a point, and the rest in k."""

    latest: Mapping[str, Any]
    others: Sequence[tuple[Jet, Any]]
    rest: Any


def _rows(problem: Recursion, point: Mapping[Any, Any], tops: Mapping[str, int]) -> list[_Row]:
    rows = []
    for equation in problem.equations:
        latest, others = dict.fromkeys(tops, mpmath.mpf(0)), []
        for symbol, (x, q) in problem.jets.items():
            if not equation.has(symbol):
                continue
            weight = _number(sp.diff(equation, symbol), point)
            if tops.get(x) == q:
                latest[x] += weight
            else:
                others.append(((x, q), weight))
        rows.append(_Row(latest, others, equation.xreplace(dict.fromkeys(problem.jets, sp.S.Zero))))
    return rows


def _run(problem: Recursion, point: Mapping[Any, Any], k: Any, count: int) -> dict[Jet, Any]:
    """The values by name and sample."""
    with mpmath.workdps(DIGITS):
        unknowns = sorted({x for x, _ in problem.jets.values() if x not in problem.inputs})
        tops = {x: max(q for y, q in problem.jets.values() if y == x) for x in unknowns}
        values = {jet: _number(value, point) for jet, value in problem.initial.items()}
        rows = _rows(problem, point, tops)
        matrix = mpmath.matrix([[row.latest[x] for x in unknowns] for row in rows])
        for step in range(problem.first, count - min(tops.values())):
            right = []
            for row in rows:
                whole = sum(
                    (w * _known(problem, (x, step + q), values, point, k) for (x, q), w in row.others), mpmath.mpf(0)
                )
                if not (problem.at_rest and step < 0):
                    here = {each: sp.Integer(step) for each in row.rest.free_symbols if str(each) == str(k)}
                    whole += _number(row.rest.xreplace(here), point)
                right.append(-whole)
            try:
                found = mpmath.lu_solve(matrix, mpmath.matrix(right))
            except ZeroDivisionError:
                raise NotEvaluable("the equations do not give the latest samples") from None
            values |= {(x, step + tops[x]): found[j] for j, x in enumerate(unknowns)}
        return values


def _known(problem: Recursion, jet: Jet, values: Mapping[Jet, Any], point: Mapping[Any, Any], k: Any) -> Any:
    """The value of an input or of an earlier sample."""
    name, at = jet
    if name not in problem.inputs:
        return values.get(jet, mpmath.mpf(0))
    return mpmath.mpf(0) if at < 0 else _number(sampled(problem.inputs[name], k).subs(k, at), point)
