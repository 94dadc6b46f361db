"""Signal-flow graphs judged by their linear equations in numbers; their paths and loops counted over sets of nodes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import PointSource, free_symbols
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.representation.minimal import MANY

Branches = Sequence[tuple[str, str, Any]]
POINTS = 3
SEVERAL = 12
"""Of so many points those are taken at which the equations are well conditioned."""
BEST = 1e8
NEAR = 1e-20
"""Two gains nearer than this, relatively, are one."""
NOTHING = 1e-30
"""Parallel branches that leave no more than this of their sizes cancel."""
WRONG = float("inf")


def _nodes(branches: Branches) -> list[str]:
    return list(dict.fromkeys(node for source, target, _ in branches for node in (source, target)))


def _number(value: Any, point: Mapping[Any, complex]) -> Any:
    """A value at a point, in many digits."""
    return MANY.context.mpmathify(np.ravel(value_of(value, Environment.at([dict(point)], MANY)).value)[0])


def _matrices(branches: Branches, others: Sequence[Any]) -> list[tuple[Mapping[Any, complex], Any]]:
    """Return I − A at some points, A[target, source] the gains; raises NotEvaluable where it is singular."""
    names = _nodes(branches)
    symbols = free_symbols([*(gain for *_, gain in branches), *others])
    found: list[tuple[Mapping[Any, complex], Any]] = []
    for point in PointSource(symbols).several(SEVERAL if symbols else 1):
        M = MANY.context.eye(len(names))
        for source, target, gain in branches:
            M[names.index(target), names.index(source)] -= _number(gain, point)
        if np.linalg.cond(np.array(M.tolist(), dtype=complex)) < BEST:
            found.append((point, M))
        if len(found) == POINTS:
            break
    if not found:
        raise NotEvaluable("the equations of the graph are singular")
    return found


def transfer_residual(branches: Branches, start: str, end: str, G: Any) -> float:
    """Return the largest relative difference of G and the signal of the output for the input 1."""
    names, worst = _nodes(branches), 0.0
    for point, M in _matrices(branches, [G]):
        b = MANY.context.matrix([int(name == start) for name in names])
        y = MANY.context.lu_solve(M, b)[names.index(end)]
        worst = worst_of((worst, float(abs(_number(G, point) - y) / max(1e-3, abs(y)))))
    return worst


def determinant_residual(branches: Branches, determinant: Any) -> float:
    """Return the largest relative difference of a value and det(I − A)."""
    worst = 0.0
    for point, M in _matrices(branches, [determinant]):
        wanted = MANY.context.det(M)
        worst = worst_of((worst, float(abs(_number(determinant, point) - wanted) / max(1e-3, abs(wanted)))))
    return worst


def are_paths(branches: Branches, start: str, end: str, gains: Sequence[Any]) -> bool:
    """Whether these are the gains of all ways from a node to another that meet no node twice."""
    return _same(branches, gains, lambda point: _ways(branches, point, start, end))


def are_loops(branches: Branches, gains: Sequence[Any]) -> bool:
    """Whether these are the gains of all ways back to where they begin, each once."""

    def loops(point: Mapping[Any, complex]) -> list[Any]:
        names, found = _nodes(branches), list[Any]()
        for i, first in enumerate(names):  # a loop counts at the first of its nodes
            allowed = [each for each in branches if {each[0], each[1]} <= set(names[i:])]
            found += _ways(allowed, point, first, first)
        return found

    return _same(branches, gains, loops)


def _ways(branches: Branches, point: Mapping[Any, complex], start: str, end: str) -> list[Any]:
    """The gains of all ways, made longer by one branch at a time: (last node, nodes met) by their gains."""
    parallel: dict[tuple[str, str], list[Any]] = {}
    for source, target, gain in branches:
        parallel.setdefault((source, target), []).append(_number(gain, point))
    added = {edge: sum(gains) for edge, gains in parallel.items() if abs(sum(gains)) > NOTHING * sum(map(abs, gains))}
    states: list[tuple[str, frozenset[str], Any]] = [(start, frozenset({start}), 1)]
    found: list[Any] = []
    while states:
        longer = []
        for node, met, product in states:
            for (source, target), gain in added.items():
                if source != node:
                    continue
                if target == end:
                    found.append(product * gain)
                elif target not in met:
                    longer.append((target, met | {target}, product * gain))
        states = longer
    return found


def _same(branches: Branches, gains: Sequence[Any], listed: Any) -> bool:
    """Whether the values agree one by one, in any order, at some points."""
    symbols = free_symbols([*(gain for *_, gain in branches), *gains])
    for point in PointSource(symbols).several(POINTS if symbols else 1):
        left = [_number(gain, point) for gain in gains]
        for wanted in listed(point):
            near = [i for i, each in enumerate(left) if abs(each - wanted) <= NEAR * abs(wanted)]
            if not near:
                return False
            left.pop(near[0])
        if left:
            return False
    return True
