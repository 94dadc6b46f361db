"""Draws sorted out by thousands: the family is solved once with letters, and its formulas are evaluated in decimals.

An answer that is far from a nice number in decimals is none; what is near is looked at exactly, so that no
member depends on what is found here, or on how fast. Eigenvalues need no formula: they are those of the matrix.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from math import isqrt
from typing import Any

import numpy as np
import sympy as sp

from solver.conditions import symbols_of
from solver.derivation import PartResult, Unsolved
from solver.engine import given_of
from solver.lazy import exact
from solver.limits import Exceeded, Limits, call_within
from solver.numeric.judges.modelling.compiled import compiled
from solver.papers.constructions.eigenvalues import Pattern
from solver.papers.judging import answers_of
from solver.papers.niceness import Array, Numbers, leaves, may_be_nice
from solver.papers.regulators import GAINS, numbers_of, weighed
from solver.problem.family import Family, Nice
from solver.problem.members import root_of, with_letters
from solver.problem.model import Problem
from solver.problem.reader import problem_of
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

LETTERS = Limits(seconds=20.0)
"""What solving with letters may take; without formulas the search is slower, and finds the same."""


OF_THE_SYSTEM = ("eigenstructure", "stability", "phase_portrait")
"""The tasks whose answer `eigenvalues` are those of A; others speak of a closed loop."""


@dataclass(frozen=True, slots=True)
class Formula:
    """An answer in letters: its entries or, with `numbers`, those of the matrices from which it is found in decimals.

    A matrix of names and integers whose eigenvalues are asked for is a `pattern` too.
    """

    nice: Nice
    entries: tuple[sp.Expr, ...]
    numbers: Numbers | None = None
    pattern: Pattern = ()


class Formulas:
    """The answers that must come out nicely, as functions of what is drawn, as far as there are any."""

    def __init__(self, family: Family, formulas: Sequence[Formula]) -> None:
        self.names = [each.name for each in family.varied]
        self.values = [np.array([complex(value) for value in each.values]) for each in family.varied]
        self.pattern = next((each.pattern for each in formulas if each.pattern), ())
        self.compiled = [(each, [_function(entry) for entry in each.entries]) for each in formulas]

    @staticmethod
    def of(source: Source, family: Family) -> Formulas:
        """Solve the family with letters, within limits."""
        nice = [each for each in family.nice if each.kind != "exact"]
        problem = lettered(source, family) if nice else None
        if problem is None:
            return Formulas(family, ())
        names = {each.name for each in family.varied}
        found = [formula for each in nice if (formula := _of_eigenvalues(each, problem, names)) is not None]
        left = [each for each in nice if each not in [formula.nice for formula in found]]
        with suppress(Exceeded):
            found += call_within(LETTERS, formulas_of, source, family, left) if left else []
        return Formulas(family, found)

    def rejected(self, places: Sequence[Sequence[int]]) -> list[str]:
        """Return for each draw, told by the places of its values, what does not come out as it must; "" if all may."""
        found = np.full(len(places), "", dtype=object)
        if self.compiled:
            columns = np.array(places).T
            drawn = {
                name: values[column] for name, values, column in zip(self.names, self.values, columns, strict=True)
            }
            for formula, functions in self.compiled:
                left = np.flatnonzero(found == "")
                if not left.size:
                    break
                at = {name: values[left] for name, values in drawn.items()}
                with np.errstate(all="ignore"):
                    values = np.array([np.broadcast_to(function(at), len(left)) for function in functions])
                    values = formula.numbers(values) if formula.numbers else values
                found[left[~may_be_nice(values, formula.nice.kind).all(axis=0)]] = formula.nice.text
        return list(found)


def _function(entry: sp.Expr) -> Any:
    """Return an entry as a function of arrays by name."""
    inner = compiled(entry)
    letters = symbols_of(entry)
    return lambda at: inner({x: at[x.name] for x in letters})


def eigenvalues(entries: Array) -> Array:
    """Return the eigenvalues of matrices, in columns: of their entries, row by row."""
    count, order = entries.shape[1], isqrt(entries.shape[0])
    matrices = entries.T.reshape(count, order, order)
    finite = np.isfinite(matrices).all(axis=(1, 2))
    found = np.full((count, order), np.nan, dtype=complex)
    found[finite] = np.linalg.eigvals(matrices[finite])
    near = np.round(found.real)  # a multiple one is known to fewer digits
    return np.where(np.abs(found - near) < 1e-3, near + 0j, found).T


def formulas_of(source: Source, family: Family, nice: Sequence[Nice]) -> list[Formula]:
    """Return the answers in letters, without those of which there is no formula."""
    problem = lettered(source, family)
    known: dict[str, PartResult] = {}
    names = {each.name for each in family.varied}
    found = [_formula(each, problem, known, names) for each in nice] if problem is not None else []
    return [each for each in found if each is not None]


def lettered(source: Source, family: Family) -> Problem | None:
    """Return the family with letters for what is drawn, None where numbers must stand there."""
    root = with_letters(root_of(source), {each.name for each in family.varied}, _signs(family))
    with suppress(InputError):
        return problem_of(source, root, catalogue())
    return None


def _signs(family: Family) -> Mapping[str, str]:
    """Return what can be assumed of the names that are drawn: the sign that all values of one have."""
    found: dict[str, str] = {}
    for each in family.varied:
        if all(value.is_positive for value in each.values):
            found[each.name] = "positive"
        elif all(value.is_negative for value in each.values):
            found[each.name] = "negative"
    return found


def _formula(nice: Nice, problem: Problem, known: dict[str, PartResult], names: Collection[str]) -> Formula | None:
    """Return the formula of an answer, None where there is none."""
    with suppress(Unsolved, exact.NotExact):
        value = answers_of(nice.part, problem, known).get(nice.answer)
        if entries := tuple(each for each in leaves(value) if _is_formula(each, names)):
            return Formula(nice, entries)
    return _of_regulator(nice, problem, known, names)


def _of_regulator(nice: Nice, problem: Problem, known: dict[str, PartResult], names: Collection[str]) -> Formula | None:
    """Return the matrices of a regulator or a filter; nothing is solved but the parts before it."""
    part = next(part for part in problem.parts if part.id == nice.part)
    if part.task not in GAINS:
        return None
    with suppress(Unsolved, exact.NotExact):
        for source in part.sources:
            answers_of(source, problem, known)
        found = weighed(part.task, given_of(part, part.methods[0], known))
        entries = tuple(entry for matrix in found.matrices for entry in matrix.flat())
        numbers = numbers_of(part.task, nice.answer, found)
        if numbers is not None and all(_is_formula(each, names) for each in entries):
            return Formula(nice, entries, numbers)
    return None


def _is_formula(entry: sp.Expr, names: Collection[str]) -> bool:
    """Whether an entry is a function of what is drawn alone that can be evaluated."""
    plain = (sp.Add, sp.Mul, sp.Pow)
    inner = (each for each in sp.preorder_traversal(entry) if each.args)
    return {x.name for x in symbols_of(entry)} <= set(names) and all(isinstance(each, plain) for each in inner)


def _of_eigenvalues(nice: Nice, problem: Problem, names: Collection[str]) -> Formula | None:
    """Return the matrix whose eigenvalues are asked for, if it is given by its entries; nothing is solved."""
    part = next(part for part in problem.parts if part.id == nice.part)
    matrix = getattr(part.system, "A", None)
    if nice.answer != "eigenvalues" or matrix is None or part.task not in OF_THE_SYSTEM:
        return None
    if any(option.loop for name, option in catalogue()[part.task].options.items() if name in part.written):
        return None  # they are those of a loop
    entries = tuple(matrix.flat())
    if not all(_is_formula(each, names) for each in entries):
        return None
    return Formula(nice, entries, eigenvalues, pattern=_pattern(matrix, names))


def _pattern(matrix: sp.MatrixBase, names: Collection[str]) -> Pattern:
    """Return a matrix of names, each once, and integers; nothing where it has other entries."""
    letters = [entry for entry in matrix.flat() if entry.is_Symbol]
    plain = all(entry.is_Integer or (entry.is_Symbol and entry.name in names) for entry in matrix.flat())
    if not plain or len(set(letters)) < len(letters):
        return ()
    return tuple(tuple(int(entry) if entry.is_Integer else str(entry.name) for entry in row) for row in matrix.tolist())
