"""The loop closed by state feedback u = −K x is a plant without that input: x' = (A − BK) x."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.derivation.conversion import composition, conversion, converted
from solver.stated.algebra import difference, product
from solver.systems import StateFeedback, StateSpace, System


@composition("gain", order=1)
def closed(system: System, options: Mapping[str, Any]) -> StateFeedback:
    """With the option `gain`, the question is about the loop."""
    return StateFeedback(system, options["gain"])


@conversion(StateFeedback, StateSpace, gives=lambda _: ("matrix", "A", "B", "C", "D", "transfer_function"))
@lemma("closed_loop")
def closed_loop(loop: StateFeedback) -> Derivation[StateSpace]:
    """A − BK, and C − DK; a plant that is not in state space is brought there first."""
    K = loop.K
    plant: StateSpace = yield from converted(loop.plant, ("A",))
    if plant.B is None or K.shape != (plant.B.cols, plant.order):
        raise Unsolved("conversions/gain_does_not_fit")
    closed = plant.closed_loop(K)
    yield Step(
        "closed_loop",
        claims={"loop": Claim(difference(plant.A, product(plant.B, K)), closed.A, "closed loop $A - BK$")},
        A=plant.A,
        B=plant.B,
        K=K,
        loop=closed.A,
        discrete=plant.discrete,
    )
    return closed
