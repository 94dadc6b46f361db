"""Plants in either description, for tasks about both: the channel asked for, and what the oracles need."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Derivation, Given, Step, lemma
from solver.lazy import sympy as sp
from solver.lazy import systems
from solver.numeric.judges import representation as judges
from solver.stated import Stated
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import inverse

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol

    from solver.systems import StateSpace, System, TransferFunction
    from solver.tasks.needed import InputOutput
    from solver.tasks.representation.transfer_function import TransferFunctionOptions


def matrices_of(plant: StateSpace) -> tuple[ImmutableMatrix, ImmutableMatrix, ImmutableMatrix, ImmutableMatrix]:
    """A, B, C, D of a plant that has them; D is zero where none is given."""
    if plant.B is None or plant.C is None:
        raise ValueError("the question is about the path from inputs to outputs")
    D = plant.D if plant.D is not None else sp.ImmutableMatrix(sp.zeros(plant.C.rows, plant.B.cols))
    return plant.A, plant.B, plant.C, D


def chosen_channel(given: Given[InputOutput, TransferFunctionOptions]) -> StateSpace | TransferFunction:
    """The system from the input asked for to the output asked for."""
    plant, inputs, outputs = given.system, _picked(given.options.input), _picked(given.options.output)
    if isinstance(plant, systems.TransferFunction):
        numerators, denominators = (
            tuple(row[inputs] for row in rows[outputs]) for rows in (plant.numerators, plant.denominators)
        )
        return replace(
            plant,
            matrix=sp.ImmutableMatrix(plant.matrix[outputs, inputs]),
            numerators=numerators,
            denominators=denominators,
        )
    _, B, C, D = matrices_of(plant)
    B, C, D = (sp.ImmutableMatrix(M) for M in (B[:, inputs], C[outputs, :], D[outputs, inputs]))
    return replace(plant, B=B, C=C, D=D)


@lemma("channel")
def shown_channel(
    given: Given[InputOutput, TransferFunctionOptions],
) -> Derivation[StateSpace | TransferFunction]:
    """The system from the input asked for to the output asked for; what B, C, D mean from there on is shown."""
    plant, options = chosen_channel(given), given.options
    if isinstance(plant, systems.TransferFunction):
        return plant
    whole: Any = given.system
    changed = {name: getattr(plant, name) for name in "BC" if getattr(plant, name) != getattr(whole, name)}
    if changed:
        yield Step(
            "channel",
            unclaimed="a choice of columns and rows",
            input=None if options.input is None else options.input + 1,
            output=None if options.output is None else options.output + 1,
            B=changed.get("B"),
            C=changed.get("C"),
            D=plant.D,
        )
    return plant


def _picked(channel: int | None) -> slice:
    return slice(None) if channel is None else slice(channel, channel + 1)


def variable_of(system: System) -> Symbol:
    """S, or z in discrete time."""
    return sp.Symbol("z" if system.discrete else "s")


def stated_transfer(plant: StateSpace, x: Symbol) -> Stated:
    """C (xI − A)⁻¹ B + D as it stands."""
    pencil = difference(product(x, sp.ImmutableMatrix(sp.eye(plant.order))), plant.A)
    dynamic = product(plant.C, inverse(pencil), plant.B)
    return dynamic if plant.D is None or plant.D.is_zero_matrix else total(dynamic, plant.D)


def numbers_of(plant: StateSpace | TransferFunction) -> Any:
    """The plant as matrices A, B, C, D for the oracles."""
    if isinstance(plant, systems.TransferFunction):
        return judges.realized(plant.numerators, plant.denominators, plant.variable)
    return matrices_of(plant)


def stated_matrix(plant: StateSpace | TransferFunction) -> Any:
    """G as the problem states it: fractions as typed, or C (sI − A)⁻¹ B + D."""
    if not isinstance(plant, systems.TransferFunction):
        return stated_transfer(plant, variable_of(plant))
    pairs = zip(plant.numerators, plant.denominators, strict=True)
    return sp.ImmutableMatrix([[p / q for p, q in zip(*row, strict=True)] for row in pairs])
