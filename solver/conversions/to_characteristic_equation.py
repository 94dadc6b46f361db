"""The equation of the poles of a loop: of what runs round it, where that is known, else of a polynomial by itself."""

from __future__ import annotations

from solver.derivation import Derivation
from solver.derivation.conversion import conversion, converted_to
from solver.systems import (
    CharacteristicEquation,
    DeadTime,
    LateLoop,
    LatePath,
    OpenLoop,
    OutputFeedback,
    Polynomial,
    StateSpace,
    System,
    TransferFunction,
)

PROVIDED = ("characteristic_equation",)


@conversion(Polynomial, CharacteristicEquation, gives=lambda _: PROVIDED)
def equation_of_polynomial(p: Polynomial) -> Derivation[CharacteristicEquation]:
    """p(s) = 0."""
    yield from ()
    return CharacteristicEquation(p, p)


@conversion(OutputFeedback, CharacteristicEquation, gives=lambda _: PROVIDED)
def equation_of_loop(loop: OutputFeedback) -> Derivation[CharacteristicEquation]:
    """1 + L(s) = 0 with L = C G H."""
    return (yield from _around(loop))


@conversion(LateLoop, CharacteristicEquation, gives=lambda _: PROVIDED)
def equation_of_late_loop(loop: LateLoop) -> Derivation[CharacteristicEquation]:
    """1 + L(s) = 0, its dead time kept apart."""
    return (yield from _around(loop))


@conversion(LatePath, CharacteristicEquation, gives=lambda _: PROVIDED)
def equation_of_late_path(path: LatePath) -> Derivation[CharacteristicEquation]:
    """1 + L(s) = 0 with L = C G, its dead time kept apart."""
    return (yield from _around(path))


@conversion(TransferFunction, CharacteristicEquation, gives=lambda has: PROVIDED if "transfer_function" in has else ())
def equation_of_transfer_function(G: TransferFunction) -> Derivation[CharacteristicEquation]:
    """1 + L(s) = 0 with L = G."""
    return (yield from _around(G))


@conversion(DeadTime, CharacteristicEquation, gives=lambda _: PROVIDED)
def equation_with_dead_time(G: DeadTime) -> Derivation[CharacteristicEquation]:
    """1 + L(s) = 0 with L = G, its dead time kept apart."""
    return (yield from _around(G))


@conversion(StateSpace, CharacteristicEquation, gives=lambda has: PROVIDED if "A" in has else ())
def equation_of_state_space(plant: StateSpace) -> Derivation[CharacteristicEquation]:
    """1 + L(s) = 0 with L the transfer function; without input or output det(sI − A) = 0."""
    if plant.B is None or plant.C is None:
        p = yield from converted_to(plant, Polynomial)
        return CharacteristicEquation(plant, p)
    return (yield from _around(plant))


def _around(plant: System) -> Derivation[CharacteristicEquation]:
    loop = yield from converted_to(plant, OpenLoop)
    return CharacteristicEquation(loop.plant, loop)
