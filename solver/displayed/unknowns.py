"""Equations between unknowns: they are checked when it is displayed what was found for them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from solver.displayed.names import Names
from solver.displayed.statements import spelled
from solver.formula import latex
from solver.lazy import numeric
from solver.matrices import entries
from solver.render.symbols import named
from solver.stated.calculus import value_at


@dataclass
class Unknowns:
    """Names that stand for unknowns (the entries of an ansatz), the symbols of these, and equations with them."""

    given: frozenset[Any]
    answered: frozenset[Any]
    of_system: frozenset[Any] = frozenset()
    ansatz: dict[str, Any] = field(default_factory=dict)
    sought: frozenset[Any] = frozenset()
    equations: list[tuple[Any, ...]] = field(default_factory=list)

    def may_hold(self, names: Names, name: str, value: Any) -> bool:
        """Let a name stand for unknowns if that is what a value holds; return whether it is."""
        known = self.of_system if names.fixed.get(name) else self.given
        if not isinstance(value, sp.MatrixBase) or numeric.free_symbols(value) <= known:
            return False
        names.found[name] = self.ansatz[name] = value
        self.sought |= numeric.free_symbols(value) - known
        return True

    def forget(self, names: Names) -> None:
        """A step ends: names stand for unknowns no more."""
        for name in self.ansatz:
            if numeric.free_symbols(names.found.get(name)) & self.sought:
                del names.found[name]

    def among(self, *formulas: Any) -> frozenset[Any]:
        """Return the symbols of formulas that stand for what is to be found."""
        return self.those_in(frozenset().union(*map(numeric.free_symbols, formulas)))

    def those_in(self, symbols: frozenset[Any]) -> frozenset[Any]:
        """Return those of some symbols that stand for what is to be found."""
        return (symbols & self.sought) | (symbols - self.given - self.answered)

    def solved(self, names: Names) -> Iterator[tuple[Any, ...]]:
        """Yield the equations with what was found for the unknowns in their place, those of which all was found.

        Decimals that were found are too short for that, and left out.
        """
        solution: dict[Any, Any] = {}
        for name, ansatz in self.ansatz.items():
            value = names.value(name)
            if getattr(value, "shape", None) == ansatz.shape:
                solution.update(_found(zip(entries(ansatz), entries(value), strict=True)))
        for left, right, *rest in self.equations:
            unknown = self.among(left, right)
            by_name = {each: names.value(spelled(latex(named(each.name)))) for each in unknown}
            values = {**{each: value for each, value in by_name.items() if isinstance(value, sp.Expr)}, **solution}
            if unknown <= values.keys() and not any(values[each].has(sp.Float) for each in unknown):
                yield (_with(left, values), _with(right, values), *rest)


def _found(pairs: Iterable[tuple[Any, Any]]) -> Iterator[tuple[Any, Any]]:
    """Return what unknowns were found to be, from the entries c·x of a matrix of unknowns and their values."""
    for entry, value in pairs:
        factor, unknown = entry.as_coeff_Mul()
        if unknown.is_Symbol:
            yield unknown, value / factor


def _with(formula: Any, values: Mapping[Any, Any]) -> Any:
    """Return a formula with values in place of unknowns."""
    for unknown in numeric.free_symbols(formula) & values.keys():
        if values[unknown] != unknown:
            formula = value_at(formula, unknown, values[unknown])
    return formula
