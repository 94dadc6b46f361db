"""A plant in state space written out, for questions about its equations: one for each state."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.derivation.conversion import Provided, conversion
from solver.jets import jet_symbol
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.systems import Equations, StateSpace
from solver.tasks.modelling.row_equations import signals_of

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol


def _gives(has: Provided) -> Iterable[str]:
    """What a machine integrates; and when a plant that is given so is at rest, as no one asks that of a realization."""
    return ("machine", *(["rest"] if "matrix" in has else [])) if has & {"A", "matrix"} else ()


@conversion(StateSpace, Equations, gives=_gives)
@lemma("written_out")
def written_out(plant: StateSpace) -> Derivation[Equations]:
    """x' = A x + B u row by row, in the names of the states and inputs."""
    states, inputs = signals_of(plant, "state"), signals_of(plant, "input")
    X, U, after = (_column(names, k, plant) for names, k in ((states, 0), (inputs, 0), (states, 1)))
    terms = [product(plant.A, X), *([product(plant.B, U)] if plant.B is not None else [])]
    rates = plant.A * X + (plant.B * U if plant.B is not None else sp.zeros(plant.order, 1))
    rows = sp.ImmutableMatrix(rates.applyfunc(sp.expand))
    yield Step(
        "rows",
        claims={"rows": Claim(total(*terms), rows, "the right sides, row by row")},
        named=states == plant.state_names,
        states=X.flat(),
        inputs=U.flat(),
        after=after,
        discrete=plant.discrete,
    )
    outputs = [X[0]] if plant.C is None else _outputs(plant, plant.C, X, U)
    jets = {jet_symbol((name, k), discrete=plant.discrete): (name, k) for name in states for k in (0, 1)}
    jets |= {jet_symbol((name, 0), discrete=plant.discrete): (name, 0) for name in inputs}
    initial = (
        {} if plant.x0 is None else {(name, 0): value for name, value in zip(states, plant.x0.flat(), strict=True)}
    )
    sides = tuple(zip(after.flat(), rows.flat(), strict=True))
    return Equations(
        sides, states, (), inputs, tuple((name, 0) for name in states), tuple(outputs), initial, jets,
        plant.discrete, plant.sample_time,
    )  # fmt: skip


def _column(names: Sequence[str], k: int, plant: StateSpace) -> ImmutableMatrix:
    symbols: list[Symbol] = [jet_symbol((name, k), discrete=plant.discrete) for name in names]
    return sp.ImmutableMatrix(len(symbols), 1, symbols)


def _outputs(plant: StateSpace, C: Any, X: Any, U: Any) -> list[Any]:
    """C x + D u."""
    through = plant.D * U if plant.D is not None and plant.B is not None else sp.zeros(C.rows, 1)
    outputs: list[Any] = (C * X + through).applyfunc(sp.expand).flat()
    return outputs
