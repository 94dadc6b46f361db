"""A characteristic polynomial by itself, exact."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.lazy import sympy as sp
from solver.systems.kind import Key, Kind, Reader, Value

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@dataclass(frozen=True)
class Polynomial:
    """p(s) (discrete: p(z)) of degree n ≥ 1; `coefficients` are its n + 1 coefficients, the highest power first."""

    coefficients: tuple[Expr, ...]
    variable: Symbol
    discrete: bool = False
    sample_time: Expr | None = None

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return "polynomial"

    @property
    def degree(self) -> int:
        """The degree n."""
        return len(self.coefficients) - 1

    @property
    def expression(self) -> Expr:
        """The polynomial, by falling powers."""
        n, x = self.degree, self.variable
        return sp.Add(*(c * x ** (n - i) for i, c in enumerate(self.coefficients)))

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols of the coefficients, sorted by name."""
        symbols: set[Any] = set().union(*(c.free_symbols for c in self.coefficients))
        return tuple(sorted(symbols, key=str))

    @property
    def provides(self) -> frozenset[str]:
        """A task can ask for the polynomial."""
        return frozenset({"polynomial"})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "the system is given by its characteristic polynomial alone"

    def size(self, of: str) -> int | None:
        """Return the number of states "n"; there are no inputs and outputs."""
        return self.degree if of == "n" else None

    def names(self, of: str) -> tuple[str, ...]:  # noqa: ARG002 - there are none
        """Return no names."""
        return ()


def _read(reader: Reader) -> Polynomial:
    """Return the polynomial, which must have roots."""
    coefficients = reader.polynomial("polynomial")
    if len(coefficients) == 1:
        reader.complain("polynomial", "a polynomial of degree 1 or more is expected here: a constant has no roots")
    reader.conclude()
    variable = sp.Symbol("z" if reader.discrete else "s")
    return Polynomial(tuple(coefficients), variable, reader.discrete, reader.sample_time)


POLYNOMIAL = Kind(
    "polynomial",
    doc="A characteristic polynomial by itself.",
    keys=(Key("polynomial", Value(), "a polynomial in s (discrete: z)", required=True),),
    read=_read,
    example=(("polynomial: {x}^4 + 2{x}^3 + 3{x}^2 + 2{x} + 1", ""),),
)
