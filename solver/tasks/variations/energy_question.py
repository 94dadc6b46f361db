"""A transfer between two states with least energy: what is given, and the names in which its equations are written."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.derivation import Given, Refusal, Unsolved, option
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import variations as judges
from solver.options.matrix import MatrixOf
from solver.options.number import Number
from solver.stated import Stated
from solver.stated.algebra import power, product
from solver.stated.matrices import transpose
from solver.tasks.design.regulator import faulty_weights, given_or_identity
from solver.tasks.plant_options import PlantOptions
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems import System
    from solver.tasks.needed import WithInput


@dataclass(frozen=True, kw_only=True)
class EnergyOptions(PlantOptions):
    """Where the motion begins and ends, how long it takes, and what the input costs."""

    initial_state: ImmutableMatrix | None = option(
        MatrixOf("n", 1, flat="column"), "x(0), numbers or symbols; else that of the system, or 0"
    )
    final_state: ImmutableMatrix | None = option(
        MatrixOf("n", 1, flat="column"), "x(T), numbers or symbols (default 0)"
    )
    final_time: Expr = option(Number(), "T, a number or a symbol", required=True)
    R: ImmutableMatrix | None = option(
        MatrixOf("m", "m"), "weight of the input, m×m, symmetric and positive definite (default I)"
    )
    cost_factor: Expr | None = option(
        Number(), "factor before the integral of the cost, 1/2 (the default) or 1", conventions=("1",)
    )


def faulty_transfer(system: System, options: EnergyOptions) -> Iterable[Refusal]:
    """A weight that is not positive definite, no time, no ends."""
    yield from faulty_weights(None, options.R)
    for name in ("final_time", "cost_factor"):
        value = getattr(options, name)
        if value is not None and value.is_positive is False:
            yield name, Reason("regulators/not_positive", {"name": name})
    if not (options.has("initial_state") or options.has("final_state") or "initial_state" in system.provides):
        yield "", Reason("finite_horizons/no_ends")


@dataclass(frozen=True)
class Transfer:
    """A n×n, B n×m, R m×m, the ends n×1, the time T and the factor c before the integral."""

    A: ImmutableMatrix
    B: ImmutableMatrix
    R: ImmutableMatrix
    x0: ImmutableMatrix
    xf: ImmutableMatrix
    T: Expr
    factor: Expr
    state_names: tuple[str, ...]
    input_names: tuple[str, ...]

    @staticmethod
    def of(given: Given[WithInput, EnergyOptions]) -> Transfer:
        """Return the question of a part."""
        system, options = given.system, given.options
        n, m = system.order, system.B.cols
        rest = sp.ImmutableMatrix(sp.zeros(n, 1))
        x0 = options.initial_state if options.initial_state is not None else system.x0
        states = system.state_names or tuple(f"x{i + 1}" for i in range(n))
        inputs = system.input_names or (("u",) if m == 1 else tuple(f"u{j + 1}" for j in range(m)))
        return Transfer(
            system.A,
            system.B,
            given_or_identity(options.R, m),
            rest if x0 is None else x0,
            rest if options.final_state is None else options.final_state,
            options.final_time,
            sp.Rational(1, 2) if options.cost_factor is None else options.cost_factor,
            states,
            inputs,
        )

    @property
    def judged(self) -> judges.Transfer:
        """What the judges take."""
        return judges.Transfer(self.A, self.B, self.R, self.x0, self.xf, self.T, self.factor)

    @cached_property
    def x(self) -> ImmutableMatrix:
        """The symbols of the states (n×1)."""
        return sp.ImmutableMatrix([sp.Symbol(name) for name in self.state_names])

    @cached_property
    def u(self) -> ImmutableMatrix:
        """The symbols of the inputs (m×1)."""
        return sp.ImmutableMatrix([sp.Symbol(name) for name in self.input_names])

    @cached_property
    def costates(self) -> ImmutableMatrix:
        """λ₁, …, λₙ (n×1)."""
        return sp.ImmutableMatrix([sp.Symbol(f"lambda{i + 1}") for i in range(self.A.rows)])

    @cached_property
    def rates(self) -> tuple[ImmutableMatrix, ImmutableMatrix]:
        """The symbols of λ' and of x' (n×1)."""
        columns = ([f"lambda{i + 1}" for i in range(self.A.rows)], self.state_names)
        first, second = (sp.ImmutableMatrix([sp.Symbol(f"{name}_dot") for name in names]) for names in columns)
        return first, second

    @cached_property
    def constants(self) -> list[Symbol]:
        """The constants of the costates, λ(0) = c, by a letter that the question does not use."""
        given = (self.A, self.B, self.R, self.x0, self.xf, self.T, self.factor)
        used = {str(symbol) for value in given for symbol in value.free_symbols}
        letter = next(each for each in "cdghq" if all(f"{each}{i + 1}" not in used for i in range(self.A.rows)))
        return [sp.Symbol(f"{letter}{i + 1}") for i in range(self.A.rows)]

    @property
    def law(self) -> ImmutableMatrix:
        """−R⁻¹ Bᵀ/(2c), which makes u of λ (m×n)."""
        return sp.ImmutableMatrix((-exact.weighted_transpose(self.B, self.R) / (2 * self.factor)).applyfunc(exact.tidy))

    def integrand(self, u: Any) -> Stated:
        """C uᵀ R u as stated, c the factor."""
        if u.rows == 1:
            return product(self.factor, self.R[0, 0], power(u[0, 0], 2))
        return product(self.factor, transpose(u), self.R, u)

    def solved(self) -> exact.MinimumEnergy:
        """Return the optimum; raises Unsolved where the final state is not reached."""
        try:
            return exact.minimum_energy(self.A, self.B, self.R, (self.x0, self.xf), self.T)
        except exact.NotReachable as finding:
            lines = [(sp.ImmutableMatrix(finding.rows[i, :]), value) for i, value in enumerate(finding.values)]
            undecided = any(value.free_symbols - self.T.free_symbols for value in finding.values)
            raise Unsolved(
                "finite_horizons/not_reachable", lines=lines, undecided=undecided, x0=self.x0, xf=self.xf
            ) from finding


def scalar_or_column(column: ImmutableMatrix) -> Any:
    """Return the one entry of a column, or the column."""
    return column[0, 0] if column.rows == 1 else column
