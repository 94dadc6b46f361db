"""Draws sorted out by thousands: the family is solved once with letters, and its formulas are evaluated in decimals.

An answer that is far from a nice number in decimals is none; what is near is looked at exactly, so that no
member depends on what is found here. Where the letters leave no formula for eigenvalues (an irreducible cubic), they
are found in decimals as the roots of the characteristic polynomial.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from solver.conditions import symbols_of
from solver.derivation import PartResult, Unsolved
from solver.engine import found_by, resolved
from solver.lazy import exact
from solver.limits import Exceeded, Limits, call_within
from solver.numeric.judges.modelling.compiled import compiled
from solver.papers.constructed import Pattern
from solver.papers.judging import answers_of
from solver.papers.niceness import Array, leaves, may_be_nice
from solver.problem.family import Family, Nice
from solver.problem.members import root_of, with_letters
from solver.problem.model import Part, Problem
from solver.problem.reader import problem_of
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

LETTERS = Limits(seconds=20.0)
"""What solving with letters may take; without formulas the search is slower, and finds the same."""


@dataclass(frozen=True, slots=True)
class Formula:
    """An answer in letters: its entries or, where it is `roots`, the coefficients of the polynomial that has them.

    Roots that are the eigenvalues of a matrix of names and integers have it as their `pattern`.
    """

    nice: Nice
    entries: tuple[sp.Expr, ...]
    roots: bool = False
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
        found: Sequence[Formula] = ()
        if any(each.kind != "exact" for each in family.nice):
            with suppress(Exceeded):
                found = call_within(LETTERS, formulas_of, source, family)
        return Formulas(family, found)

    def rejected(self, places: Sequence[Sequence[int]]) -> list[str]:
        """Return for each draw, told by the places of its values, what does not come out as it must; "" if all may."""
        found = np.full(len(places), "", dtype=object)
        if self.compiled:
            columns = np.array(places).T
            at = {name: values[column] for name, values, column in zip(self.names, self.values, columns, strict=True)}
            for formula, functions in self.compiled:
                with np.errstate(all="ignore"):
                    values = np.array([np.broadcast_to(function(at), len(places)) for function in functions])
                    values = _roots(values) if formula.roots else values
                found[(found == "") & ~may_be_nice(values, formula.nice.kind).all(axis=0)] = formula.nice.text
        return list(found)


def _function(entry: sp.Expr) -> Any:
    """Return an entry as a function of arrays by name."""
    inner = compiled(entry)
    letters = symbols_of(entry)
    return lambda at: inner({x: at[x.name] for x in letters})


def _roots(coefficients: Array) -> Array:
    """Return the roots of monic polynomials, a column each: of their coefficients, without the first one."""
    degree, count = coefficients.shape
    companion = np.zeros((count, degree, degree), dtype=complex)
    companion[:, 0, :] = -coefficients.T
    companion[:, np.arange(1, degree), np.arange(degree - 1)] = 1.0
    finite = np.isfinite(companion).all(axis=(1, 2))
    found = np.full((count, degree), np.nan, dtype=complex)
    found[finite] = np.linalg.eigvals(companion[finite])
    near = np.round(found.real)  # a multiple root is known to fewer digits
    return np.where(np.abs(found - near) < 1e-3, near + 0j, found).T


def formulas_of(source: Source, family: Family) -> list[Formula]:
    """Return the answers in letters, without those of which there is no formula."""
    letters = with_letters(root_of(source), {each.name for each in family.varied}, _signs(family))
    try:
        problem = problem_of(source, letters, catalogue())
    except InputError:  # letters may stand where numbers must
        return []
    known: dict[str, PartResult] = {}
    names = {each.name for each in family.varied}
    found = (_formula(each, problem, known, names) for each in family.nice if each.kind != "exact")
    return [each for each in found if each is not None]


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
    part = next(part for part in problem.parts if part.id == nice.part)
    try:
        value = answers_of(nice.part, problem, known).get(nice.answer)
    except (Unsolved, exact.NotExact):
        return _of_roots(nice, part, known, names) if nice.answer == "eigenvalues" else None
    entries = tuple(each for each in leaves(value) if _is_formula(each, names))
    return Formula(nice, entries) if entries else None


def _is_formula(entry: sp.Expr, names: Collection[str]) -> bool:
    """Whether an entry is a function of what is drawn alone that can be evaluated."""
    plain = (sp.Add, sp.Mul, sp.Pow)
    inner = (each for each in sp.preorder_traversal(entry) if each.args)
    return {x.name for x in symbols_of(entry)} <= set(names) and all(isinstance(each, plain) for each in inner)


def _of_roots(nice: Nice, part: Part, known: dict[str, PartResult], names: Collection[str]) -> Formula | None:
    """Return the characteristic polynomial of a part's system as the formula of its eigenvalues, if it has one."""
    with suppress(Unsolved, exact.NotExact):
        task = catalogue()["characteristic_polynomial"]
        system = resolved(part, known).system
        asked = Part("", task.name, tuple(task.methods_for(discrete=system.discrete)[:1]), system)
        given, answers = found_by(asked.methods[0], asked, known)
        polynomial = answers["polynomial"]
        variable = [x for x in symbols_of(polynomial) if x.name not in names]
        entries = tuple(sp.Poly(polynomial, *variable).all_coeffs()[1:])
        if all(_is_formula(each, names) for each in entries):
            return Formula(nice, entries, roots=True, pattern=_pattern(given.system.A, names))
    return None


def _pattern(matrix: sp.MatrixBase, names: Collection[str]) -> Pattern:
    """Return a matrix of names, each once, and integers; nothing where it has other entries."""
    letters = [entry for entry in matrix.flat() if entry.is_Symbol]
    plain = all(entry.is_Integer or (entry.is_Symbol and entry.name in names) for entry in matrix.flat())
    if not plain or len(set(letters)) < len(letters):
        return ()
    return tuple(tuple(int(entry) if entry.is_Integer else str(entry.name) for entry in row) for row in matrix.tolist())
