"""A matrix of polynomials, exact."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.lazy import sympy as sp
from solver.systems.kind import Key, Kind, ListOf, Reader, Value

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@dataclass(frozen=True)
class PolynomialMatrix:
    """M(s) (discrete: M(z)), p×m; its entries are polynomials by falling powers."""

    matrix: ImmutableMatrix
    variable: Symbol
    discrete: bool = False
    sample_time: Expr | None = None

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return "polynomial_matrix"

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols but the variable, sorted by name."""
        return tuple(sorted(self.matrix.free_symbols - {self.variable}, key=str))

    @property
    def provides(self) -> frozenset[str]:
        """A task can ask for the matrix."""
        return frozenset({"polynomial_matrix"})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "there is a matrix of polynomials and no system"

    def size(self, of: str) -> int | None:  # noqa: ARG002 - there are none
        """Return no number of states, inputs or outputs."""
        return None

    def names(self, of: str) -> tuple[str, ...]:  # noqa: ARG002 - there are none
        """Return no names."""
        return ()


def _read(reader: Reader) -> PolynomialMatrix:
    """Return the matrix, its rows of one length."""
    rows = reader.polynomials("polynomial_matrix")
    reader.conclude()
    x = sp.Symbol("z" if reader.discrete else "s")
    entries = [[sp.Add(*(c * x**i for i, c in enumerate(reversed(entry)))) for entry in row] for row in rows]
    return PolynomialMatrix(sp.ImmutableMatrix(entries), x, reader.discrete, reader.sample_time)


POLYNOMIAL_MATRIX = Kind(
    "polynomial_matrix",
    doc="A matrix of polynomials by itself.",
    keys=(Key("polynomial_matrix", ListOf(ListOf(Value())), "rows of polynomials in s (discrete: z)", required=True),),
    read=_read,
    example=(("polynomial_matrix: [[{x}, 1], [{x}^2, {x} + 1]]", ""),),
)
