"""A regulator over a finite horizon: what is given, with weights and the horizon taken as positive."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.derivation import Given, Refusal, option
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import variations as judges
from solver.options.integer import Integer
from solver.options.matrix import MatrixOf
from solver.options.number import Number
from solver.stated import Stated
from solver.stated.algebra import product, total
from solver.stated.matrices import inverse
from solver.tasks.design.regulator import faulty_weights, given_or_identity, own_weights, unknown_matrix
from solver.tasks.plant_options import PlantOptions
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems import System
    from solver.tasks.needed import WithInput

MOST_STEPS = 100


@dataclass(frozen=True, kw_only=True)
class HorizonOptions(PlantOptions):
    """The weights, the horizon, and where the motion starts."""

    Q: ImmutableMatrix | None = option(
        MatrixOf("n", "n"), "weight of the state, n×n, symmetric and positive semidefinite (default I)"
    )
    R: ImmutableMatrix | None = option(
        MatrixOf("m", "m"), "weight of the input, m×m, symmetric and positive definite (default I)"
    )
    terminal_weight: ImmutableMatrix | None = option(
        MatrixOf("n", "n"), "weight S of the state at the end, n×n, symmetric and positive semidefinite (default 0)"
    )
    final_time: Expr | None = option(Number(), "T, a number or a symbol (continuous time)")
    steps: int | None = option(Integer(minimum=1, maximum=MOST_STEPS), "N, the number of steps (discrete time)")
    initial_state: ImmutableMatrix | None = option(
        MatrixOf("n", 1, flat="column"), "x(0), for the motion and the least cost (numbers or symbols)"
    )
    cost_factor: Expr | None = option(Number(), "factor before the cost, 1/2 (the default) or 1", conventions=("1",))


def faulty_horizon(system: System, options: HorizonOptions) -> Iterable[Refusal]:
    """Weights that are not definite as they must be, no horizon, or one of the other kind of time."""
    yield from faulty_weights(options.Q, options.R)
    yield from faulty_weights(options.terminal_weight, None, "terminal_weight")
    for name in ("final_time", "cost_factor"):
        value = getattr(options, name)
        if value is not None and value.is_positive is False:
            yield name, Reason("regulators/not_positive", {"name": name})
    discrete = bool(getattr(system, "discrete", False))
    wanted, other = ("steps", "final_time") if discrete else ("final_time", "steps")
    if not options.has(wanted):
        yield "", Reason("finite_horizons/no_horizon", {"name": wanted, "discrete": discrete})
    if options.has(other):
        yield other, Reason("finite_horizons/other_time", {"name": wanted, "discrete": discrete})


@dataclass(frozen=True)
class HorizonQuestion:
    """A n×n, B n×m, Q, S n×n, R m×m, the horizon T (None in discrete time), x₀ if it is given, the factor of the cost.

    Symbols that are weights by themselves, and the one of the horizon, are positive; `plain` leads back to those of
    the problem.
    """

    A: ImmutableMatrix
    B: ImmutableMatrix
    Q: ImmutableMatrix
    R: ImmutableMatrix
    S: ImmutableMatrix
    T: Expr | None
    x0: ImmutableMatrix | None
    factor: Expr
    plain: Mapping[Symbol, Symbol]

    @staticmethod
    def of(given: Given[WithInput, HorizonOptions]) -> HorizonQuestion:
        """Return the question of a part."""
        system, options = given.system, given.options
        n, m = system.order, system.B.cols
        none = sp.ImmutableMatrix(sp.zeros(n, n))
        S = none if options.terminal_weight is None else options.terminal_weight
        Q, R, T = given_or_identity(options.Q, n), given_or_identity(options.R, m), options.final_time
        own: set[Any] = own_weights(Q, R, S) | ({T} if T is not None and T.is_Symbol else set())
        positive = {s: sp.Symbol(s.name, positive=True) for s in own if not s.is_positive}
        x0 = options.initial_state if options.initial_state is not None else system.x0
        factor: Any = sp.Rational(1, 2) if options.cost_factor is None else options.cost_factor
        A, B, Q, R, S = (sp.ImmutableMatrix(M.xreplace(positive)) for M in (system.A, system.B, Q, R, S))
        factor = factor.xreplace(positive)
        x0, T = (value if value is None else value.xreplace(positive) for value in (x0, T))
        return HorizonQuestion(A, B, Q, R, S, T, x0, factor, {new: old for old, new in positive.items()})

    def restored(self, value: Any) -> Any:
        """Return a result in the symbols of the problem."""
        if isinstance(value, list):
            return [self.restored(each) for each in value]
        return value.xreplace(self.plain) if self.plain and hasattr(value, "xreplace") else value

    @property
    def order(self) -> int:
        """The number n of states."""
        return int(self.A.rows)

    @property
    def horizon(self) -> Expr:
        """T, in continuous time."""
        if self.T is None:
            raise ValueError("in discrete time the horizon is a number of steps")
        return self.T

    @cached_property
    def unknown(self) -> ImmutableMatrix:
        """The symmetric matrix of p11, p12, …."""
        return unknown_matrix(self.order)

    @cached_property
    def pairs(self) -> list[tuple[Any, Any]]:
        """The symbols of the entries on and above the diagonal and of their derivatives, row by row."""
        n, P = self.order, self.unknown
        entries: list[Any] = [P[i, j] for i in range(n) for j in range(i, n)]
        return [(entry, sp.Symbol(f"{entry.name}_dot")) for entry in entries]

    @property
    def G(self) -> ImmutableMatrix:
        """B R⁻¹ Bᵀ (n×n)."""
        return exact.weighted_input(self.B, self.R)

    @property
    def weight(self) -> list[Any]:
        """R⁻¹ as a factor; nothing where R is the identity."""
        return [] if sp.eye(self.R.rows) == self.R else [inverse(self.R)]

    @property
    def Bt(self) -> ImmutableMatrix:
        """Bᵀ (m×n)."""
        return sp.ImmutableMatrix(self.B.T)

    def linear_part(self, P: Any) -> Stated:
        """AᵀP + PA + Q as stated."""
        return total(product(sp.ImmutableMatrix(self.A.T), P), product(P, self.A), self.Q)

    def quadratic_part(self, P: Any) -> Stated:
        """P B R⁻¹ Bᵀ P as stated."""
        return product(P, self.B, *self.weight, self.Bt, P)

    @property
    def judged(self) -> judges.Horizon:
        """What the judges take, in the symbols of the problem."""
        x0 = sp.ImmutableMatrix(sp.zeros(self.order, 1)) if self.x0 is None else self.x0
        given = (self.A, self.B, self.Q, self.R, self.S, self.T, x0, self.factor)
        return judges.Horizon(*map(self.restored, given))
