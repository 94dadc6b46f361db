"""Families of points: one normal form for whole numbers, families put together, points that lie in others, the order.

Coordinates that are angles have the form a + π (q₁ n + q₂ m + …); the columns of the q generate a lattice.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from math import lcm
from typing import Any

import mpmath
import sympy as sp

from solver.exact.modelling.branches import Point
from solver.exact.modelling.evaluation import DIGITS, evaluator, random_values, vanishes

Lattice = tuple[tuple[sp.Rational, ...], ...]
"""Columns: multiples of π, a row for each unknown."""


@dataclass(frozen=True)
class Family:
    """A point with its `needs`; of one whose whole numbers make a lattice, `offset` is where they are zero."""

    unknowns: tuple[sp.Symbol, ...]
    values: tuple[sp.Expr, ...]
    needs: tuple[Any, ...] = ()
    lattice: Lattice | None = None
    integers: tuple[sp.Symbol, ...] = ()

    @property
    def free(self) -> tuple[sp.Symbol, ...]:
        """Unknowns that stand for themselves."""
        return tuple(x for x, v in zip(self.unknowns, self.values, strict=True) if v == x)

    @property
    def offset(self) -> tuple[sp.Expr, ...]:
        """The values where all whole numbers are zero."""
        zero = dict.fromkeys(self.integers, sp.S.Zero)
        return tuple(v.xreplace(zero) for v in self.values)


def family(point: Point, unknowns: Sequence[sp.Symbol], needs: Sequence[Any], names: Sequence[sp.Symbol]) -> Family:
    """Return the point in normal form."""
    values = tuple(sp.expand(point.get(x, x)) if _has_integer(point.get(x, x)) else point.get(x, x) for x in unknowns)
    integers = tuple(dict.fromkeys(s for v in values for s in sorted(v.free_symbols, key=str)
                                   if s.is_integer and s not in unknowns))  # fmt: skip
    plain = Family(tuple(unknowns), values, tuple(dict.fromkeys(needs)), None, integers)
    columns = _columns(values, integers)
    if columns is None:
        put = dict(zip(integers, names, strict=False))
        return replace(plain, values=tuple(v.xreplace(put) for v in values),
                       integers=tuple(names[: len(integers)]))  # fmt: skip
    return written(replace(plain, lattice=reduced(columns)), plain.offset, names)


def _has_integer(value: Any) -> bool:
    return any(s.is_integer for s in value.free_symbols)


def _columns(values: Sequence[Any], integers: Sequence[sp.Symbol]) -> Lattice | None:
    """The multiples of π that each whole number adds to the values; None where they are no such."""
    columns = []
    for n in integers:
        column = [sp.diff(v, n) / sp.pi for v in values]
        if not all(c.is_Rational for c in column):
            return None
        columns.append(tuple(column))
    return tuple(columns)


def reduced(columns: Lattice) -> Lattice:
    """Return a basis of the lattice in echelon form: each unknown's least step first (Hermite's normal form)."""
    if not columns:
        return ()
    scale = lcm(*(int(c.q) for column in columns for c in column))
    rows = [[int(c * scale) for c in column] for column in columns]
    basis: list[list[int]] = []
    for i in range(len(columns[0])):
        while len(left := [row for row in rows if row[i]]) > 1:
            least = min(left, key=lambda row: abs(row[i]))
            for row in left:
                if row is not least:
                    times = row[i] // least[i]
                    row[:] = [a - times * b for a, b in zip(row, least, strict=True)]
        if left:
            pivot = [a if left[0][i] > 0 else -a for a in left[0]]
            rows.remove(left[0])
            for row in basis:
                times = row[i] // pivot[i]
                row[:] = [a - times * b for a, b in zip(row, pivot, strict=True)]
            basis.append(pivot)
    return tuple(tuple(sp.Rational(a, scale) for a in row) for row in basis)


def holds(lattice: Lattice, vector: Sequence[Any]) -> bool:
    """Whether a vector of multiples of π lies in the lattice."""
    rest = list(vector)
    for column in lattice:
        i = next(k for k, c in enumerate(column) if c)
        times = rest[i] / column[i]
        if not times.is_Integer:
            return False
        rest = [a - times * b for a, b in zip(rest, column, strict=True)]
    return not any(rest)


def written(of: Family, offset: Sequence[Any], names: Sequence[sp.Symbol]) -> Family:
    """The family with its values as offset and lattice say, each angle's offset the nearest to zero."""
    lattice = of.lattice or ()
    near = list(offset)
    for column in lattice:
        i = next(k for k, c in enumerate(column) if c)
        times = _times(near[i], column[i] * sp.pi)
        near = [sp.expand(v - times * c * sp.pi) if times and c else v for v, c in zip(near, column, strict=True)]
    integers = tuple(names[: len(lattice)])
    values = tuple(
        v + sp.Add(*(column[i] * sp.pi * n for column, n in zip(lattice, integers, strict=True)))
        for i, v in enumerate(near)
    )
    return replace(of, values=values, integers=integers)


def _times(value: Any, step: Any) -> Any:
    """How often the step is taken off the value so that it lies in (−step/2, step/2]; 0 where it has symbols."""
    if value.free_symbols:
        constant, _ = value.as_independent(*value.free_symbols, as_Add=True)
        turns = constant / step
        return sp.ceiling(turns - sp.Rational(1, 2)) if turns.is_Rational else sp.S.Zero
    return sp.ceiling(value / step - sp.Rational(1, 2))


def put_together(families: Sequence[Family], names: Sequence[sp.Symbol]) -> list[Family]:
    """Families without those that lie in others; two that make one with half the step are one."""
    left = list(families)
    while True:
        left = [f for i, f in enumerate(left) if not any(_is_told(f, g, j > i) for j, g in enumerate(left) if i != j)]
        pair = next(((f, g, joint) for f, g in combinations(left, 2) if (joint := _joined(f, g, names))), None)
        if pair is None:
            return left
        left[left.index(pair[0])] = pair[2]
        left.remove(pair[1])


def _difference(f: Family, g: Family) -> list[Any] | None:
    """Multiples of π by which the offsets differ; None where they differ by anything else."""
    put = dict(zip(g.unknowns, f.offset, strict=True))
    found = []
    for x, a, b in zip(f.unknowns, f.offset, g.offset, strict=True):
        other = b.xreplace({s: put[s] for s in g.free if s in b.free_symbols} | {x: put[x]} if x in g.free else
                           {s: put[s] for s in g.free if s in b.free_symbols})  # fmt: skip
        by = sp.expand((a - other) / sp.pi)
        if not by.is_Rational:
            if not vanishes(a - other):
                return None
            by = sp.S.Zero
        found.append(by)
    return found


def lies_in(f: Family, g: Family) -> bool:
    """Whether every point of f is one of g."""
    if f.values == g.values and set(g.needs) <= set(f.needs):
        return True
    if f.lattice is None or g.lattice is None:
        return not g.integers and not f.integers and _difference(f, g) is not None and not any(_difference(f, g) or [])
    by = _difference(f, g)
    free = {i for i, x in enumerate(g.unknowns) if x in g.free}
    columns = [tuple(sp.S.Zero if i in free else c for i, c in enumerate(column)) for column in f.lattice]
    return by is not None and holds(g.lattice, by) and all(holds(g.lattice, column) for column in columns)


def _is_told(f: Family, g: Family, later: bool) -> bool:
    """Whether f need not be told beside g; of two that are the same the later one."""
    return lies_in(f, g) and not (later and lies_in(g, f))


def _joined(f: Family, g: Family, names: Sequence[sp.Symbol]) -> Family | None:
    """One family of two with the same lattice, where the step between them is half one of it."""
    if not f.lattice or f.lattice != g.lattice or f.needs != g.needs or f.free != g.free:
        return None
    by = _difference(f, g)
    if by is None or not any(by) or not holds(f.lattice, [2 * b for b in by]):
        return None
    if any(b and not any(column[i] for column in f.lattice) for i, b in enumerate(by)):
        return None
    joint = reduced((*f.lattice, tuple(by)))
    return written(replace(f, lattice=joint), f.offset, names) if len(joint) == len(f.lattice) else None


def in_order(families: Sequence[Family]) -> list[Family]:
    """Families in the order of their values, isolated points first."""

    def key(f: Family) -> tuple[Any, ...]:
        return (bool(f.free or f.integers), [_height(v) for v in f.offset])

    return sorted(families, key=key)


def _height(value: Any) -> Any:
    symbols = sorted(value.free_symbols, key=str)
    with mpmath.workdps(DIGITS):
        found = evaluator(value, symbols)(mpmath.mp, random_values(symbols, 0))
        finite = mpmath.isfinite(found)
        return (
            tuple(mpmath.nint(part * 10**30) for part in (mpmath.re(found), mpmath.im(found)))
            if finite
            else (mpmath.inf,)
        )
