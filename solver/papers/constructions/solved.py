"""Draws whose names are solved for: others are drawn, numbers of the answer chosen, and linear equations do the rest.

Gains first: K is chosen in whole numbers; of the Riccati equation and R K = BᵀP, linear in P and in the weights then,
follow Q and P. Or K and most of A are chosen, and the coefficients of det(sI − A + BK) give the rest of A. Equations
that are required are solved alike.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, TypeVar

from sympy import QQ
from sympy.polys.matrices import DomainMatrix

from solver.papers.constructions.relations import Linear, Matrix, Name, Relations, Terms, linear_loop
from solver.papers.generator import below, stream
from solver.papers.niceness import LARGEST_DENOMINATOR
from solver.problem.family import Family

SOLVED = 2
"""Tells the numbers that are used here from those of other constructions."""

OUTER, INNER = 8, 40
"""So often are other names drawn for one draw, and so often is an answer chosen for these."""

SIZES = (2, 4, 8, 16, 32)
"""Bounds of the numbers chosen for an answer, one of them each time."""

TRIED = 6
"""Where so many draws in a row, the first, find nothing, no more are made."""

Values = dict[Name, Fraction]

Number = TypeVar("Number", int, Fraction)


class Solved:
    """Draws of a family in which some names follow from an answer."""

    def __init__(self, family: Family, relations: Relations, equations: Linear, seed: int) -> None:
        self.family = family
        self.relations = relations
        self.equations = equations
        self.seed = seed
        names = {each.name: each for each in family.varied}
        self.places = {
            name: {_fraction(value): place for place, value in enumerate(each.values) if value.is_Rational}
            for name, each in names.items()
        }
        self.kinds = dict((*relations.chosen, *relations.unknown))
        self.wanted = {name: self.kinds[name] for name in equations.solved if self.kinds.get(name)}
        self.drawn = [name for name in equations.given if name in names]
        self.chosen = [name for name, _ in relations.chosen if name not in equations.solved]
        self.halves = any(kind == "rationals" for _, kind in relations.chosen)
        self.moving = bool(equations.in_rows & set(self.chosen))
        self.loops = [
            (loop, found)
            for loop in relations.loops
            if set(loop.numbers) <= set(self.chosen) and (found := linear_loop(loop)) is not None
        ]

    def at(self, number: int) -> list[int] | None:
        """Return the places of the values of a draw by its number, None where none was found."""
        if number >= TRIED and self._hopeless:
            return None
        return self._at(number)

    @cached_property
    def _hopeless(self) -> bool:
        return all(self._at(number) is None for number in range(TRIED))

    def _at(self, number: int) -> list[int] | None:
        bits = stream(self.seed, SOLVED, number)
        if not all(self.places[name] for name in self.drawn):
            return None  # no value of one of them is rational
        for _ in range(OUTER):
            values = {name: _one_of(list(self.places[name]), bits) for name in self.drawn}
            elimination = None if self.moving else Elimination.of(self.equations, values)
            for _ in range(INNER):
                if (chosen := self._chosen(values, bits)) is None:
                    continue
                values |= chosen
                found = (elimination or Elimination.of(self.equations, values)).solution(values, self._free(bits))
                if found is not None and self._fits(found, values):
                    return self._places(values | found, bits)
        return None

    def _chosen(self, values: Values, bits: Iterator[int]) -> Values | None:
        """Choose the numbers of an answer; None where those of a loop are not what they must be."""
        size = _one_of(SIZES, bits)
        parts = below(3, bits) + 1 if self.halves else 1
        found = {name: Fraction(below(2 * size + 1, bits) - size, parts) for name in self.chosen}
        for matrix in self.relations.definite:
            if set(matrix[0]) <= set(self.chosen):
                found |= definite_entries(matrix, bits)
        for loop, equations in self.loops:
            coefficients = stable_coefficients(len(loop.coefficients), bits, whole=loop.whole)
            known = values | dict(zip(loop.coefficients, coefficients, strict=True))
            gain = Elimination.of(equations, known).solution(known, self._free(bits))
            if gain is None or not all(_is(value, self.kinds[name] or "integers") for name, value in gain.items()):
                return None
            found |= gain
        return found

    def _free(self, bits: Iterator[int]) -> Iterator[Fraction]:
        """Yield numbers for what may have any."""
        while True:
            size = _one_of(SIZES, bits)
            yield Fraction(below(2 * size + 1, bits) - size)

    def _fits(self, found: Values, known: Values) -> bool:
        """Whether what was solved for is among the values that the file gives, or what it must be."""
        return (
            all(value in self.places[name] for name, value in found.items() if name in self.places)
            and all(_is(found[name], kind) for name, kind in self.wanted.items())
            and all(_is_definite(matrix, known | found, strictly=True) for matrix in self.relations.definite)
            and all(_is_definite(matrix, known | found, strictly=False) for matrix in self.relations.semidefinite)
        )

    def _places(self, values: Values, bits: Iterator[int]) -> list[int]:
        """Return the places of all names; those in no equation are drawn."""
        return [
            self.places[each.name][values[each.name]] if each.name in values else below(len(each.values), bits)
            for each in self.family.varied
        ]


def stable_coefficients(order: int, bits: Iterator[int], *, whole: bool) -> list[Fraction]:
    """Return the coefficients of a polynomial with whole coefficients and stable roots, the constant one first.

    Its leading 1 is left out; with `whole` its roots are whole numbers.
    """
    found, left = [1], order
    while left:
        if left > 1 and not whole and below(2, bits):
            half, square = below(3, bits) + 1, below(4, bits)  # s² + 2σs + σ² + q
            factor = [half * half + square, 2 * half, 1]
        else:
            factor = [below(6, bits) + 1, 1]
        left -= len(factor) - 1
        product = [0] * (len(found) + len(factor) - 1)
        for i, a in enumerate(found):
            for j, b in enumerate(factor):
                product[i + j] += a * b
        found = product
    return [Fraction(each) for each in found[:-1]]


def definite_entries(matrix: Matrix, bits: Iterator[int]) -> Values:
    """Return the entries of a positive definite matrix L D Lᵀ of whole numbers; L has −1, 0 and 1 below its ones."""
    order = range(len(matrix))
    lower = [[below(3, bits) - 1 if j < i else int(i == j) for j in order] for i in order]
    middle = [below(6, bits) + 1 for _ in order]
    return {
        matrix[i][j]: Fraction(sum(lower[i][k] * middle[k] * lower[j][k] for k in order)) for i in order for j in order
    }


def _fraction(value: Any) -> Fraction:
    return Fraction(int(value.p), int(value.q))


def _one_of(items: Sequence[Number], bits: Iterator[int]) -> Number:
    return items[below(len(items), bits)]


def _is(value: Fraction, kind: str) -> bool:
    return kind == "exact" or value.denominator <= (LARGEST_DENOMINATOR if kind == "rationals" else 1)


def _is_definite(matrix: Matrix, values: Mapping[Name, Fraction], *, strictly: bool) -> bool:
    """Whether a symmetric matrix is positive definite or semidefinite, by the pivots of its elimination."""
    rows = [[values[name] for name in row] for row in matrix]
    for i, row in enumerate(rows):
        if row[i] < 0 or (row[i] == 0 and (strictly or any(row[i:]))):
            return False
        if row[i] == 0:
            continue
        for lower in rows[i + 1 :]:
            factor = lower[i] / row[i]
            for j in range(i, len(rows)):
                lower[j] -= factor * row[j]
    return True


@dataclass(frozen=True, slots=True)
class Elimination:
    """The coefficients M of linear equations M x = b as E M, reduced, with ones in the columns of `pivots`, and E."""

    equations: Linear
    factors: list[list[Fraction]]
    reduced: list[list[Fraction]]
    pivots: tuple[int, ...]

    @staticmethod
    def of(equations: Linear, values: Values) -> Elimination:
        """Reduce the coefficients at some values."""
        count, width = len(equations.rows), len(equations.solved)
        rows = [
            [_value(terms, values) for terms in row] + [Fraction(i == j) for j in range(count)]
            for i, row in enumerate(equations.rows)
        ]
        entries = [[QQ(x.numerator, x.denominator) for x in row] for row in rows]
        matrix = DomainMatrix(entries, (count, width + count), QQ)
        reduced, pivots = matrix.rref()
        numbers = [[Fraction(int(x.numerator), int(x.denominator)) for x in row] for row in reduced.to_list()]
        columns = tuple(pivot for pivot in pivots if pivot < width)
        return Elimination(equations, [row[width:] for row in numbers], [row[:width] for row in numbers], columns)

    def solution(self, values: Values, free: Iterator[Fraction]) -> Values | None:
        """Return what is solved for, with numbers of `free` where any would do; None where nothing solves all."""
        right = [-_value(terms, values) for terms in self.equations.rests]
        found = [sum((a * b for a, b in zip(row, right, strict=True) if a and b), Fraction()) for row in self.factors]
        rank = len(self.pivots)
        if any(found[rank:]):
            return None
        names = self.equations.solved
        answer = {name: next(free) for place, name in enumerate(names) if place not in self.pivots}
        for place, row, value in zip(self.pivots, self.reduced, found, strict=False):
            rest = sum((row[j] * answer[name] for j, name in enumerate(names) if j not in self.pivots), Fraction())
            answer[names[place]] = value - rest
        return answer


def _value(terms: Terms, values: Values) -> Fraction:
    """Return the value of a polynomial."""
    total = Fraction()
    for factor, powers in terms:
        product = factor
        for name, power in powers:
            product *= values[name] ** power
        total += product
    return total
