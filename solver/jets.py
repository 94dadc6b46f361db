"""Symbols of functions of time and of their derivatives, or of their values at samples."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from solver.lazy import conditions
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import Symbol

DOTS = {0: "", 1: "_dot", 2: "_ddot", 3: "_dddot"}
NOTHING: Mapping[str, Any] = MappingProxyType({})
Jet = tuple[str, int]
"""A function of time and the order of its derivative (discrete: the number of samples ahead)."""


def jet_symbol(jet: Jet, *, discrete: bool = False, assumed: Mapping[str, Symbol] = NOTHING) -> Symbol:
    """Return the symbol of a derivative: x, x_dot, x_ddot, x_dddot, x_d4; discrete: x(k), x(k+1), x(k-1).

    What is `assumed` of a function by its name holds of its value at any time; a derivative is real.
    """
    name, order = jet
    if discrete:
        known = conditions.assumed_of(assumed[name]) if name in assumed else {"real": True}
        return sp.Symbol(f"{name}(k{order:+d})" if order else f"{name}(k)", **known)
    if name in assumed and not order:
        return assumed[name]
    return sp.Symbol(name + DOTS.get(order, f"_d{order}"), real=True)
