"""A dead time as a factor of a transfer function: what comes in goes out later."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, lemma
from solver.stated.algebra import product

if TYPE_CHECKING:
    from solver.systems import DeadTime


@lemma("dead_time")
def dead_time_apart(G: DeadTime) -> Derivation[None]:
    """G = e^{−Ts} G₀: the output comes later by T."""
    rational = G.rational.uncancelled[0, 0]
    yield Step(
        "split",
        claims={"split": Claim(G.uncancelled, product(G.factor, rational), "dead time and rational factor")},
        factor=G.factor,
        rational=rational,
        delay=G.delay,
        x=G.variable,
    )
