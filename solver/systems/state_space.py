"""Linear time-invariant systems in state space, exact."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

from solver.lazy import sympy as sp
from solver.systems.kind import CHANNELS, Key, Kind, Matrix, Reader, Values

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@dataclass(frozen=True)
class StateSpace:
    """x' = A x + B u, y = C x + D u (discrete: x(k+1) = A x(k) + B u(k)), with exact entries.

    Shapes: A n×n, B n×m, C p×n, D p×m, x0 n×1. B, C, D, x0 are None where the problem gives none;
    a bare matrix is a system with A alone.
    """

    A: ImmutableMatrix
    B: ImmutableMatrix | None = None
    C: ImmutableMatrix | None = None
    D: ImmutableMatrix | None = None
    x0: ImmutableMatrix | None = None
    discrete: bool = False
    sample_time: Expr | None = None
    state_names: tuple[str, ...] = ()
    input_names: tuple[str, ...] = ()
    output_names: tuple[str, ...] = ()
    bare: bool = False

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return "matrix" if self.bare else "state_space"

    @property
    def order(self) -> int:
        """The number n of states."""
        return int(self.A.rows)

    @cached_property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols of A, B, C, D, sorted by name."""
        matrices = [M for M in (self.A, self.B, self.C, self.D) if M is not None]
        symbols: set[Symbol] = set().union(*(M.free_symbols for M in matrices))
        return tuple(sorted(symbols, key=lambda symbol: str(symbol.name)))

    @property
    def provides(self) -> frozenset[str]:
        """The matrices given; "matrix" is A, square or not, and "transfer_function" what A, B and C tell."""
        given = {"B": self.B, "C": self.C, "D": self.D, "initial_state": self.x0, "x0": self.x0}
        names = {name for name, value in given.items() if value is not None}
        if self.A.rows:
            names |= {"matrix", "A"} if self.A.rows == self.A.cols else {"matrix"}
        return frozenset(names | ({"transfer_function"} if {"B", "C"} <= names else set()))

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        given = [name for name in ("A", "B", "C", "D") if name in self.provides]
        if not given:
            return "the matrix is not square" if self.A.rows else "there is no system"
        return "the system has only " + (", ".join(given[:-1]) + " and " + given[-1] if given[1:] else given[0])

    def size(self, of: str) -> int | None:
        """Return the number of states "n", inputs "m" or outputs "p"."""
        B, C = self.B, self.C
        return {"n": self.order, "m": B.cols if B is not None else None, "p": C.rows if C is not None else None}[of]

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the "state"s, "input"s or "output"s, if there are any."""
        return {"input": self.input_names, "output": self.output_names, "state": self.state_names}[of]

    def closed_loop(self, K: ImmutableMatrix) -> StateSpace:
        """Return the system under u = −K x (K m×n): A − BK, and C − DK."""
        if self.B is None:
            raise ValueError("state feedback needs B")
        C = None if self.C is None else (self.C - self.D * K if self.D is not None else self.C)
        return replace(self, A=sp.ImmutableMatrix(self.A - self.B * K), C=C)


def _read(reader: Reader) -> StateSpace:
    """Return A, B, C, D and the initial state, whose shapes fit."""
    A = reader.matrix("A")
    n = A.rows if A is not None else None
    if A is not None and A.rows != A.cols:
        reader.complain("A", f"A must be square, it is {A.rows}×{A.cols}")
        n = None
    B = reader.matrix("B", "column", (n, None), " like A")
    C = reader.matrix("C", "row", (None, n), " like A")
    D = _feedthrough(reader, B, C)
    x0 = reader.matrix("initial_state", "column", (n, 1), " like A")
    states = reader.names("states", n)
    inputs = reader.names("inputs", B.cols if B is not None else None)
    outputs = reader.names("outputs", C.rows if C is not None else None)
    reader.conclude()
    assert A is not None  # noqa: S101 - the shape was checked, and what is wrong with A concluded above
    return StateSpace(A, B, C, D, x0, reader.discrete, reader.sample_time, states, inputs, outputs)


def _feedthrough(reader: Reader, B: ImmutableMatrix | None, C: ImmutableMatrix | None) -> ImmutableMatrix | None:
    """Return D: as given, zero if absent, None without B and C; a single 0 is a zero matrix of any shape."""
    if reader.gives("D") and not (reader.gives("B") and reader.gives("C")):
        reader.complain("D", "D needs both B and C", at_key=True)
    if B is None or C is None:
        return None
    if reader.gives("D") and not reader.is_zero("D"):
        return reader.matrix("D", "row" if C.rows == 1 else "column", (C.rows, B.cols), " (outputs × inputs)")
    return sp.ImmutableMatrix(sp.zeros(C.rows, B.cols))


STATE_SPACE = Kind(
    "state_space",
    doc="x' = A x + B u, y = C x + D u.",
    keys=(
        Key("A", Matrix(), "system matrix, n×n", required=True),
        Key("B", Matrix(), "input matrix, n×m; a flat list is a column"),
        Key("C", Matrix(), "output matrix, p×n; a flat list is a row"),
        Key("D", Matrix(), "feedthrough, p×m; zero if absent"),
        Key("initial_state", Matrix(), "x(0), n values"),
        Key("states", Values(), "names of the states"),
        *CHANNELS,
    ),
    read=_read,
    example=(  # of order two: controllable, observable, eigenvalues −1 and −2
        ("A: [[0, 1], [-2, -3]]", "a matrix, row by row; entries are exact: 0.75, 3/4, sqrt(2), k/m"),
        ("B: [0, 1]", "a flat list is a column"),
        ("C: [1, 0]", "a flat list is a row; D is zero unless it is given"),
        ("initial_state: [1, 0]", "x(0)"),
    ),
)
