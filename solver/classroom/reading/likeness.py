"""The kind of our own answer, by which a student's is read, and whether what is read has its shape."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from solver.classroom.reading import polynomials
from solver.classroom.reading.names import symbols_of
from solver.symbols import POLYNOMIAL

SIGNALS = ("x", "y", "u", "f")
"""Answers that are functions of time."""


def has_step(ours: Any) -> bool:
    """Whether our own answer says when it begins."""
    values = ours if isinstance(ours, list | tuple) else [ours]
    return any(isinstance(each, sp.Basic) and each.has(sp.Heaviside) for each in values)


def is_of_time(ours: Any, name: str) -> bool:
    """Whether our own answer is a function of time, which may be constant where it is a signal."""
    found = {symbol.name for symbol in symbols_of(ours)}
    return bool(found & {"t", "k"}) or (name in SIGNALS and not found & POLYNOMIAL)


def is_condition(ours: Any) -> bool:
    """Whether our own answer is a condition on parameters."""
    return isinstance(ours, sp.logic.boolalg.Boolean) and not isinstance(ours, sp.Expr)


def is_like(value: Any, ours: Any) -> bool:
    """Whether a value has the shape of ours, where shapes can be told."""
    if isinstance(value, sp.MatrixBase) and isinstance(ours, sp.MatrixBase):
        return bool(value.shape == ours.shape)
    if isinstance(value, Mapping) and isinstance(ours, Mapping):
        return set(value) <= set(ours)
    if isinstance(value, list) and isinstance(ours, list | tuple):
        return len(value) == len(ours)
    variable = polynomials.variable_of(ours)
    if variable is None or not isinstance(value, sp.Expr) or not value.is_polynomial(variable):
        return variable is None
    return bool(sp.degree(value, variable) == sp.degree(ours, variable))
