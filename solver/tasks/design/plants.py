"""A plant with all its matrices, as the design of observers needs it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation import Unsolved
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol

    from solver.systems import StateSpace


@dataclass(frozen=True)
class Plant:
    """x' = A x + B u, y = C x + D u (discrete: x(k+1)) with n states, m inputs, p measured outputs."""

    A: ImmutableMatrix
    B: ImmutableMatrix
    C: ImmutableMatrix
    D: ImmutableMatrix
    discrete: bool
    state_names: tuple[str, ...]

    @property
    def n(self) -> int:
        """The number of states."""
        return int(self.A.rows)

    @property
    def p(self) -> int:
        """The number of outputs."""
        return int(self.C.rows)

    @property
    def plain(self) -> bool:
        """Whether the input does not act on the output directly."""
        return bool(self.D.is_zero_matrix)

    @property
    def variable(self) -> Symbol:
        """The variable of polynomials and transfer functions: s, or z in discrete time."""
        return sp.Symbol("z" if self.discrete else "s")


def measuring(system: StateSpace, measured: Sequence[str] | None = None) -> Plant:
    """Return the plant with what is measured as its output: its own y, or the states named (x1 … xn, or numbers).

    Raises Unsolved if there is no such state, or neither C nor a state named.
    """
    A, B, C, D, n = system.A, system.B, system.C, system.D, system.order
    names = system.state_names or tuple(f"x{i}" for i in range(1, n + 1))
    if measured:
        rows = [_number_of(word, names) for word in measured]
        C, D = sp.ImmutableMatrix(len(rows), n, lambda i, j: int(j == rows[i])), None
    if B is None or C is None:
        raise Unsolved("observers/nothing_measured")
    return Plant(A, B, C, D if D is not None else sp.ImmutableMatrix.zeros(C.rows, B.cols), system.discrete, names)


def _number_of(word: str, names: Sequence[str]) -> int:
    """The number (from 0) of a state given by name or by its number from 1."""
    if word in names:
        return names.index(word)
    if not (word.isdigit() and 1 <= int(word) <= len(names)):
        raise Unsolved("observers/unknown_state", word=word, states=names)
    return int(word) - 1
