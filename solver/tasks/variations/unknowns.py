"""Functions that are asked for with the symbols of their derivatives, and the constants of integration."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import count
from typing import TYPE_CHECKING, Any

from solver.jets import jet_symbol
from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import Expr, Symbol

MOST = 12
"""Derivatives are looked for up to this order."""


@dataclass(frozen=True)
class Unknown:
    """A function asked for; `jets` are the symbols of it and of its derivatives, x, x', x'', …."""

    name: str
    jets: tuple[Symbol, ...]

    @property
    def symbol(self) -> Symbol:
        """The symbol of the function itself."""
        return self.jets[0]

    def order_in(self, equation: Expr) -> int:
        """The order of its highest derivative in an equation; −1 where it does not occur."""
        return exact.highest_jet(equation, self.jets)

    def put(self, function: Expr, t: Symbol) -> dict[Symbol, Expr]:
        """The values of all its derivatives, for a function of t."""
        found, value = {}, function
        for jet in self.jets:
            found[jet] = value
            value = sp.diff(value, t)
        return found


def unknown_of(name: str, equations: Iterable[Expr]) -> Unknown:
    """The function of this name, with the symbols that the equations have for it."""
    inside: dict[str, Any] = {str(symbol): symbol for each in equations for symbol in each.free_symbols}
    usual = [jet_symbol((name, k)) for k in range(MOST + 1)]
    return Unknown(name, tuple(inside.get(str(each), each) for each in usual))


@dataclass
class Constants:
    """The constants of integration so far, those of first integrals first; new ones are numbered on."""

    found: list[Symbol]
    taken: frozenset[str]
    letter: str = "C"
    numbers: Iterator[int] = field(default_factory=lambda: count(1))

    @staticmethod
    def beside(known: Sequence[Symbol], equations: Iterable[Expr], letter: str = "C") -> Constants:
        """Constants that no symbol of the equations is called like."""
        taken = {str(symbol) for each in equations for symbol in each.free_symbols}
        return Constants(list(known), frozenset(taken | {str(each) for each in known}), letter)

    def new(self) -> Symbol:
        """One more constant."""
        name = next(name for i in self.numbers if (name := f"{self.letter}{i}") not in self.taken)
        self.found.append(sp.Symbol(name, real=True))
        return self.found[-1]


@dataclass(frozen=True)
class Family:
    """One branch of the general solution: each function as an expression in t and the constants.

    `restricted` are conditions under which it holds.
    """

    functions: Mapping[str, Expr]
    constants: tuple[Symbol, ...]
    restricted: tuple[Expr, ...] = ()
