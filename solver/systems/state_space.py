"""Linear time-invariant systems in state space, exact."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import sympy as sp


@dataclass(frozen=True)
class StateSpace:
    """x' = A x + B u, y = C x + D u (discrete: x(k+1) = A x(k) + B u(k)), with exact entries.

    Shapes: A n×n, B n×m, C p×n, D p×m, x0 n×1. B, C, D, x0 are None where the problem gives none;
    a bare matrix is a system with A alone.
    """

    A: sp.ImmutableMatrix
    B: sp.ImmutableMatrix | None = None
    C: sp.ImmutableMatrix | None = None
    D: sp.ImmutableMatrix | None = None
    x0: sp.ImmutableMatrix | None = None
    discrete: bool = False
    sample_time: sp.Expr | None = None
    state_names: tuple[str, ...] = ()
    input_names: tuple[str, ...] = ()
    output_names: tuple[str, ...] = ()
    bare: bool = False

    @property
    def order(self) -> int:
        """The number n of states."""
        return int(self.A.rows)

    @cached_property
    def parameters(self) -> tuple[sp.Symbol, ...]:
        """The free symbols of A, B, C, D, sorted by name."""
        matrices = [M for M in (self.A, self.B, self.C, self.D) if M is not None]
        symbols: set[sp.Symbol] = set().union(*(M.free_symbols for M in matrices))
        return tuple(sorted(symbols, key=lambda symbol: str(symbol.name)))

    def closed_loop(self, K: sp.ImmutableMatrix) -> StateSpace:
        """Return the system under u = −K x (K m×n): A − BK, and C − DK."""
        if self.B is None:
            raise ValueError("state feedback needs B")
        C = None if self.C is None else (self.C - self.D * K if self.D is not None else self.C)
        return replace(self, A=sp.ImmutableMatrix(self.A - self.B * K), C=C)
