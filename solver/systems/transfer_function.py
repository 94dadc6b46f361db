"""Transfer functions as the problem gives them, exact: one, or a matrix of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.lazy import sympy as sp
from solver.systems.kind import CHANNELS, Fraction, Key, Kind, ListOf, Quotient, Reader

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@dataclass(frozen=True)
class TransferFunction:
    """G(s) (discrete: G(z)) of p outputs and m inputs: a p×m matrix of rational functions, cancelled, exact.

    `numerators` and `denominators` (p×m) are the polynomials as given, multiplied out but not cancelled, the
    denominators not made monic. `written` is what a single one has above and below in the factors that were typed, None
    where there are none.
    """

    matrix: ImmutableMatrix
    numerators: tuple[tuple[Expr, ...], ...]
    denominators: tuple[tuple[Expr, ...], ...]
    variable: Symbol
    discrete: bool = False
    sample_time: Expr | None = None
    input_names: tuple[str, ...] = ()
    output_names: tuple[str, ...] = ()
    written: tuple[Expr, Expr] | None = None

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return "transfer_function"

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols but the variable, sorted by name."""
        rows = (*self.numerators, *self.denominators)
        symbols: set[Any] = set().union(self.matrix.free_symbols, *(p.free_symbols for row in rows for p in row))
        return tuple(sorted(symbols - {self.variable}, key=str))

    @property
    def uncancelled(self) -> ImmutableMatrix:
        """The matrix with the factors that cancel."""
        rows = zip(self.numerators, self.denominators, strict=True)
        return sp.ImmutableMatrix([[p / q for p, q in zip(*row, strict=True)] for row in rows])

    @property
    def provides(self) -> frozenset[str]:
        """A task can ask for the transfer function, a path to the output, and how that moves from rest."""
        return frozenset({"transfer_function", "motion", "path"})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "the system is a transfer function"

    def size(self, of: str) -> int | None:
        """Return the number of inputs "m" or outputs "p"; that of states "n" depends on the realization."""
        return {"m": int(self.matrix.cols), "p": int(self.matrix.rows)}.get(of)

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the "input"s or "output"s, if there are any."""
        return {"input": self.input_names, "output": self.output_names}.get(of, ())


@dataclass(frozen=True)
class DeadTime:
    """`rational` is G₀, one input, one output, in continuous time; `delay` is T > 0, a number or a formula."""

    rational: TransferFunction
    delay: Expr

    discrete = False
    sample_time = None

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return "transfer_function"

    @property
    def variable(self) -> Symbol:
        """The symbol s."""
        return self.rational.variable

    @property
    def factor(self) -> Expr:
        """The factor e^{−T s}."""
        return sp.exp(-self.delay * self.rational.variable)

    @property
    def matrix(self) -> ImmutableMatrix:
        """G (1×1), G₀ cancelled."""
        return sp.ImmutableMatrix(self.rational.matrix * self.factor)

    @property
    def uncancelled(self) -> Expr:
        """G with the factors that cancel."""
        return self.factor * self.rational.uncancelled[0, 0]

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols but the variable, sorted by name."""
        symbols: set[Any] = {*self.rational.parameters, *self.delay.free_symbols}
        return tuple(sorted(symbols, key=str))

    @property
    def provides(self) -> frozenset[str]:
        """A task can ask for the two factors, for the path that they make, and how the output moves from rest."""
        return frozenset({"dead_time", "motion", "path"})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        says = "with its dead time the transfer function is no quotient of polynomials"
        return (
            f"{says}, and no finite number of states has it; put (2 - T s)/(2 + T s) in its place, or ask for margins"
        )

    def size(self, of: str) -> int | None:
        """Return the number of inputs "m" or outputs "p"."""
        return self.rational.size(of)

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the "input" or "output", if there are any."""
        return self.rational.names(of)


@dataclass(frozen=True)
class DelayedMatrix:
    """`rational` is G₀ (p×m) in continuous time, `delays` (p×m) the T of the factors e^{−T s} of its entries."""

    rational: TransferFunction
    delays: ImmutableMatrix

    discrete = False
    sample_time = None

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return "transfer_function"

    @property
    def variable(self) -> Symbol:
        """The symbol s."""
        return self.rational.variable

    @property
    def factors(self) -> ImmutableMatrix:
        """The e^{−T s} (p×m)."""
        return sp.ImmutableMatrix(self.delays.applyfunc(lambda delay: sp.exp(-delay * self.variable)))

    @property
    def matrix(self) -> ImmutableMatrix:
        """G, the entries of G₀ cancelled."""
        return sp.ImmutableMatrix(sp.matrix_multiply_elementwise(self.rational.matrix, self.factors))

    @property
    def uncancelled(self) -> ImmutableMatrix:
        """G with the factors that cancel."""
        return sp.ImmutableMatrix(sp.matrix_multiply_elementwise(self.rational.uncancelled, self.factors))

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols but the variable, sorted by name."""
        symbols: set[Any] = {*self.rational.parameters, *self.delays.free_symbols}
        return tuple(sorted(symbols, key=str))

    @property
    def provides(self) -> frozenset[str]:
        """A task can ask for its values at a frequency only."""
        return frozenset({"gains"})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "with their dead times the entries are no quotients of polynomials"

    def size(self, of: str) -> int | None:
        """Return the number of inputs "m" or outputs "p"."""
        return self.rational.size(of)

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the "input"s or "output"s, if there are any."""
        return self.rational.names(of)


def _read_one(reader: Reader) -> TransferFunction | DeadTime:
    """Return one transfer function; with a dead time beside it where it has one."""
    entry = reader.quotient("transfer_function")
    reader.conclude()
    assert entry is not None  # noqa: S101 - what is wrong with it was concluded above
    rational = _of(reader, [[entry]])
    return rational if entry.delay == 0 else DeadTime(rational, entry.delay)


def _read_matrix(reader: Reader) -> TransferFunction | DelayedMatrix:
    """Return a matrix of transfer functions; with dead times beside it where entries have some."""
    rows = reader.quotients("transfer_matrix", delayed=True)
    reader.conclude()
    delays = sp.ImmutableMatrix([[entry.delay for entry in row] for row in rows])
    rational = _of(reader, rows)
    return rational if delays.is_zero_matrix else DelayedMatrix(rational, delays)


def _of(reader: Reader, rows: Sequence[Sequence[Quotient]]) -> TransferFunction:
    """Return the system of these quotients with the names of its channels."""
    inputs, outputs = reader.names("inputs", len(rows[0])), reader.names("outputs", len(rows))
    reader.conclude()
    return TransferFunction(
        matrix=sp.ImmutableMatrix([[entry.cancelled() for entry in row] for row in rows]),
        numerators=tuple(tuple(entry.numerator.as_expr() for entry in row) for row in rows),
        denominators=tuple(tuple(entry.denominator.as_expr() for entry in row) for row in rows),
        variable=sp.Symbol("z" if reader.discrete else "s"),
        discrete=reader.discrete,
        sample_time=reader.sample_time,
        input_names=inputs,
        output_names=outputs,
        written=rows[0][0].written if len(rows) == len(rows[0]) == 1 else None,
    )


TRANSFER_FUNCTION = Kind(
    "transfer_function",
    doc="G(s), in discrete time G(z).",
    keys=(
        Key(
            "transfer_function",
            Fraction(),
            "an expression in s (discrete: z), {zeros, poles, gain} or {numerator, denominator}",
            required=True,
        ),
        *CHANNELS,
    ),
    read=_read_one,
    example=(("transfer_function: ({x} + 3)/({x}^2 + 3{x} + 2)", ""),),
)

TRANSFER_MATRIX = Kind(
    "transfer_matrix",
    doc="G(s) of several inputs or outputs.",
    keys=(
        Key(
            "transfer_matrix",
            ListOf(ListOf(Fraction())),
            "rows of transfer functions: one row an output, one column an input",
            required=True,
        ),
        *CHANNELS,
    ),
    read=_read_matrix,
    example=(("transfer_matrix: [[1/({x} + 1), 0], [1, 1/{x}]]", ""),),
)
