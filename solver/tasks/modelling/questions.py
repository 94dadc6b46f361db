"""What the judges of models take: the equations as they are given, with the symbols of all that may occur."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.numeric.judges import modelling as judges

if TYPE_CHECKING:
    from solver.systems import Equations, System


def is_driven(system: System) -> bool:
    """Whether there are inputs: then B and D are asked for."""
    return system.size("m") != 0


def question_of(model: Equations) -> judges.Question:
    """What is given, as the judges take it."""
    sides = [left - right for left, right in model.sides]
    orders = [k for _, k in model.jets.values()]
    highest = max(orders, default=0) - min([0, *orders])
    names = (*model.unknowns, *model.inputs)
    below = {model.symbol((name, k)): (name, k) for name in names for k in range(highest + 1)}
    jets = {**below, **model.jets}
    return judges.Question(
        sides, list(model.outputs), jets, model.unknowns, model.inputs, model.states, model.algebraic
    )
