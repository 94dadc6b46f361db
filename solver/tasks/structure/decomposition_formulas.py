"""How the matrices of a decomposition follow from the transformation."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from solver.derivation import Given, Options
    from solver.systems import StateSpace


def in_coordinates(name: str, given: Given[StateSpace, Options], found: Mapping[str, Any]) -> Any:
    """T⁻¹AT, T⁻¹B or CT."""
    A, B, C, T = given.system.A, given.system.B, given.system.C, found["T"]
    return sp.ImmutableMatrix({"A": lambda: T.inv() * A * T, "B": lambda: T.inv() * B, "C": lambda: C * T}[name]())


def first_block(name: str, given: Given[StateSpace, Options], found: Mapping[str, Any]) -> Any:
    """The block of the first part of what the coordinates lead to."""
    whole, k = in_coordinates(name, given, found), int(found["orders"][0])
    return sp.ImmutableMatrix({"A": whole[:k, :k], "B": whole[:k, :], "C": whole[:, :k]}[name])
