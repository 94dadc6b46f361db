"""Exact values as texts and numbers: what JSON shows of answers, of steps and of the system that is asked about."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from solver.derivation import PartResult, Step
from solver.patches import Program, data_of
from solver.render.plain import sympy_text
from solver.render.wording import WordedStep
from solver.stated import Stated
from solver.symbols import RESERVED
from solver.systems import DeadTime, System, TransferFunction

DIGITS = 17
"""Significant digits that a double can tell apart."""

SPELLED = {"x0": "initial_state"}
"""Names of systems where problem files have another one."""


def values_of(step: Step) -> dict[str, Any]:
    """Return the values of a step that are data, and what its claims found, by name."""
    found = {name: claim.right for name, claim in step.claims.items()}
    return {name: value for name, value in {**step.values, **found}.items() if _is_data(value)}


def _is_data(value: Any) -> bool:
    """Whether a value is mathematics (or a list of it) and not an object of the program."""
    if isinstance(value, list | tuple):
        return all(map(_is_data, value))
    return isinstance(value, sp.Basic | sp.MatrixBase | Stated | str | int | float)


def texts_of(system: System) -> dict[str, str]:
    """Return the matrices or expressions of a system by name, as sympy reads them back."""
    if isinstance(system, TransferFunction | DeadTime):
        G = system.matrix
        given = {"G": G[0, 0] if G.shape == (1, 1) else G, "sample_time": system.sample_time}
    else:
        given = {SPELLED.get(each.name, each.name): getattr(system, each.name) for each in fields(system)}  # type: ignore[arg-type]  # every kind is a dataclass
    return {name: sympy_text(value) for name, value in given.items() if isinstance(value, sp.Basic | sp.MatrixBase)}


def as_written(value: Any) -> Any:
    """Return an answer as sympy reads it; a program as data."""
    return data_of(value, _number, sympy_text) if isinstance(value, Program) else sympy_text(value)


def numbers_of(value: Any) -> Any:
    """Return an answer without symbols as nested lists (or mappings) of numbers, a complex one as [re, im]; else None.

    Truth values, words and what is not finite are no numbers.
    """
    if isinstance(value, sp.MatrixBase):
        return _all([_all([numbers_of(entry) for entry in row]) for row in value.tolist()]) if value.rows else None
    if isinstance(value, list | tuple):
        return _all([numbers_of(each) for each in value]) if value else None
    if isinstance(value, Mapping):
        found = {str(name): numbers_of(each) for name, each in value.items()}
        return found if found and None not in found.values() else None
    return _number(value) if isinstance(value, sp.Expr) and not value.free_symbols and value.is_finite else None


def _number(value: sp.Expr) -> Any:
    """Return a number of Python, or [re, im]; None where it is not one."""
    if value.is_Integer:
        return int(value)
    found = value.evalf(DIGITS)
    if not found.is_number:
        return None
    re, im = (float(part) + 0.0 for part in found.as_real_imag())
    return [re, im] if im else re


def _all(items: list[Any]) -> list[Any] | None:
    return None if any(item is None for item in items) else items


def symbols_of(result: PartResult, steps: Iterable[WordedStep]) -> list[str]:
    """Return every free name of the answers and steps but those whose meaning is fixed, sorted."""
    names = set(_names(result.answers.values()))
    for step in steps:
        for each in step.walk():
            names.update(_names(values_of(each.step).values()))
    return sorted(names - RESERVED)


def functions_of(result: PartResult) -> list[str]:
    """Return the names of the functions of time in the answers, v of v(t), sorted."""
    values = [each for each in result.answers.values() if isinstance(each, sp.Basic)]
    return sorted({str(each.func) for value in values for each in value.atoms(AppliedUndef)})


def _names(values: Iterable[Any]) -> Iterator[str]:
    """Yield the names of all free symbols."""
    for value in values:
        if isinstance(value, list | tuple):
            yield from _names(value)
        elif isinstance(value, Mapping):
            yield from _names([*value, *value.values()])
        elif isinstance(value, Stated):
            yield from _names(value.operands)
        elif isinstance(value, sp.Basic | sp.MatrixBase):
            yield from (str(symbol) for symbol in value.free_symbols)
