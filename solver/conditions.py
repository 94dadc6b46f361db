"""Conditions on parameters, carried by the parameters themselves as assumptions are.

A symbol without conditions and one with them are different symbols, so that nothing that was remembered of the one is
taken for the other: every formula, and every result kept for later, has the conditions with it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

import sympy as sp


class Condition(NamedTuple):
    """`difference` > 0, >= 0 or != 0, as `relation` says; in plain symbols."""

    difference: sp.Expr
    relation: str


Conditions = tuple[Condition, ...]

NEAR = 1e-12


def assumed_of(symbol: sp.Symbol) -> dict[str, bool]:
    """Return the assumptions that a symbol was made with."""
    found: Any = symbol
    return dict(found._assumptions_orig)


class Parameter(sp.Symbol):
    """A symbol with assumptions that keeps all conditions of its part, also those on other symbols."""

    __slots__ = ("conditions",)
    conditions: Conditions

    def __new__(cls, name: str, conditions: Conditions = (), **assumptions: bool) -> Parameter:
        """Return the symbol; `assumptions` as of a plain one."""
        made = sp.Symbol.__xnew__(cls, name, **assumptions)
        made.conditions = conditions
        found: Parameter = made
        return found

    def __getnewargs_ex__(self) -> tuple[tuple[str, Conditions], dict[str, bool]]:
        return (self.name, self.conditions), assumed_of(self)

    def _hashable_content(self) -> tuple[Any, ...]:
        plain: Any = super()
        return (*plain._hashable_content(), self.conditions)

    @classmethod
    def class_key(cls) -> tuple[Any, ...]:
        """Return what sorts it among plain symbols."""
        key: tuple[Any, ...] = sp.Symbol.class_key()
        return key

    @property
    def plain(self) -> sp.Symbol:
        """The symbol without its conditions, as it stands in them."""
        return sp.Symbol(self.name, **assumed_of(self))


def symbols_of(*expressions: sp.Basic) -> list[Any]:
    """Return the symbols of expressions by name."""
    found: set[Any] = set().union(*(each.free_symbols for each in expressions))
    return sorted(found, key=str)


def conditions_of(symbols: Iterable[Any]) -> Conditions:
    """Return the conditions that any of the symbols carries, each once."""
    found = dict.fromkeys(each for symbol in symbols if isinstance(symbol, Parameter) for each in symbol.conditions)
    return tuple(sorted(found, key=str)) if found else ()


def without_conditions(value: Any) -> Any:
    """Return an expression or matrix in plain symbols."""
    carrying = [symbol for symbol in value.free_symbols if isinstance(symbol, Parameter)]
    return value.xreplace({symbol: symbol.plain for symbol in carrying}) if carrying else value


def holds_at(symbols: Iterable[Any], point: Mapping[Any, Any]) -> bool:
    """Whether the conditions of the symbols hold at a point; not so near to an edge that rounding may decide.

    Conditions that hold other symbols than those of the point are left out.
    """
    values = {symbol.plain if isinstance(symbol, Parameter) else symbol: value for symbol, value in point.items()}
    for difference, relation in conditions_of(symbols):
        if not difference.free_symbols <= values.keys():
            continue
        value = difference.xreplace({symbol: sp.Integer(0) + values[symbol] for symbol in difference.free_symbols})
        size = sp.N(value, 30)
        if not size.is_real or not {">": size > NEAR, ">=": size >= 0, "!=": abs(size) > NEAR}[relation]:
            return False
    return True
