"""What the states and inputs of a plant are called where its state equations are written row by row."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from solver.systems import StateSpace

LETTERS = {"state": ("x", "xi", "q"), "input": ("u", "v", "w")}
"""What states and inputs are called that have no names, the first of which no parameter is called so."""


def signals_of(plant: StateSpace, of: str) -> tuple[str, ...]:
    """The names of the "state"s or "input"s: those given, else x1, x2, … and u, or u1, u2, …."""
    count = plant.order if of == "state" else plant.B.cols if plant.B is not None else 0
    given, parameters = plant.names(of), {str(each) for each in plant.parameters}
    if given and all(name.isidentifier() and name not in parameters and "dot" not in name for name in given):
        return given
    usual: Sequence[tuple[str, ...]] = [
        (letter,) if of == "input" and count == 1 else tuple(f"{letter}{i}" for i in range(1, count + 1))
        for letter in LETTERS[of]
    ]
    return next((names for names in usual if not parameters & set(names)), usual[-1])
