"""Transfer functions as the problem gives them, exact."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp


@dataclass(frozen=True)
class TransferFunction:
    """G(s) (discrete: G(z)) of p outputs and m inputs: a p×m matrix of rational functions, cancelled, exact.

    `numerators` and `denominators` (p×m) are the polynomials as given, multiplied out but not cancelled, the
    denominators not made monic.
    """

    matrix: sp.ImmutableMatrix
    numerators: tuple[tuple[sp.Expr, ...], ...]
    denominators: tuple[tuple[sp.Expr, ...], ...]
    variable: sp.Symbol
    discrete: bool = False
    sample_time: sp.Expr | None = None
    input_names: tuple[str, ...] = ()
    output_names: tuple[str, ...] = ()

    @property
    def parameters(self) -> tuple[sp.Symbol, ...]:
        """The free symbols but the variable, sorted by name."""
        rows = (*self.numerators, *self.denominators)
        symbols: set[Any] = set().union(self.matrix.free_symbols, *(p.free_symbols for row in rows for p in row))
        return tuple(sorted(symbols - {self.variable}, key=str))
