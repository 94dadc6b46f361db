"""When a question has several right answers: what `AnswerName(..., free=...)` asks of what is given.

A decimal of an answer that is not free is judged by its digits; that of a free one by what rounding does to the
property that defines it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Given, Options
from solver.lazy import numeric
from solver.numeric.judges import structure as judges

if TYPE_CHECKING:
    from solver.systems import StateSpace
    from solver.tasks.design.pole_options import PoleOptions
    from solver.tasks.design.pole_placement import PolePlacementOptions
    from solver.tasks.design.reduced_observer import ReducedObserverOptions
    from solver.tasks.time_response.matrix_function import MatrixFunctionOptions


def gain_is_free(given: Given[StateSpace, Options]) -> bool:
    """Several inputs, or modes that no input moves: many gains place the same poles."""
    plant = given.system
    return plant.B is not None and (plant.B.cols > 1 or _deficient(plant.A, plant.B))


def loop_is_free(given: Given[StateSpace, PolePlacementOptions]) -> bool:
    """Eigenvectors that are asked for decide the closed loop; without them it is as free as the gain."""
    return given.options.eigenvectors is None and gain_is_free(given)


def placed_gain_is_free(given: Given[StateSpace, PolePlacementOptions]) -> bool:
    """As the closed loop; inputs that do the same as others can share their work in any way."""
    B = given.system.B
    return loop_is_free(given) or (B is not None and bool(numeric.rank(B) < B.cols))


def observer_gain_is_free(given: Given[StateSpace, Options]) -> bool:
    """Several outputs, or modes that no output shows."""
    plant = given.system
    return plant.C is not None and (plant.C.rows > 1 or _deficient(plant.A.T, plant.C.T))


def current_gain_is_free(given: Given[StateSpace, Options]) -> bool:
    """Several outputs, or modes that no output shows one step later."""
    plant = given.system
    return plant.C is not None and (plant.C.rows > 1 or _deficient(plant.A.T, (plant.C * plant.A).T))


def one_of_the_gains_is_free(given: Given[StateSpace, Options]) -> bool:
    """The feedback, or the observer's."""
    return gain_is_free(given) or observer_gain_is_free(given)


def several_inputs(given: Given[StateSpace, Options]) -> bool:
    """More than one input."""
    return given.system.B is not None and bool(given.system.B.cols > 1)


def more_inputs_than_outputs(given: Given[StateSpace, Options]) -> bool:
    """Inputs left over when every output follows its reference."""
    plant = given.system
    return plant.B is not None and plant.C is not None and bool(plant.B.cols > plant.C.rows)


def reference_gain_is_free(given: Given[StateSpace, PoleOptions]) -> bool:
    """With poles the feedback may be free already."""
    return more_inputs_than_outputs(given) or (bool(given.options.poles) and several_inputs(given))


def measured_by_combinations(given: Given[StateSpace, ReducedObserverOptions]) -> bool:
    """The outputs are no states, so that the coordinates (η₁, η₂) are free."""
    C = given.system.C
    return (
        not given.options.measured
        and C is not None
        and any(sum(entry != 0 for entry in C.row(i)) != 1 for i in range(C.rows))
    )


def reduced_gain_is_free(given: Given[StateSpace, ReducedObserverOptions]) -> bool:
    """Free coordinates, or several outputs, or modes that they do not show."""
    return measured_by_combinations(given) or len(given.options.measured or ()) > 1 or observer_gain_is_free(given)


def a_root_is_asked_for(given: Given[StateSpace, MatrixFunctionOptions]) -> bool:
    """A matrix has several square roots."""
    return "sqrt" in str(given.options.function) or "/" in str(given.options.function)


def _deficient(A: Any, B: Any) -> bool:
    return bool(numeric.rank(judges.krylov_matrix(A, B)) < A.rows)
