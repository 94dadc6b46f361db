"""What every task about a plant takes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation import Options, option
from solver.options.loop_element import LoopElement
from solver.options.matrix import MatrixOf

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import System


@dataclass(frozen=True, kw_only=True)
class PlantOptions(Options):
    """The gain that closes the loop before the question is asked."""

    gain: ImmutableMatrix | None = option(
        MatrixOf("m", "n", flat="row"),
        "state feedback u = −K x; the question is then about A − BK",
        answer="K",
        loop="closed_loop",
    )

    def parameters_with(self, system: System) -> set[str]:
        """Return the names of the parameters in a system and in what these options put around it."""
        found = {symbol for value in self.values for symbol in getattr(value, "free_symbols", ())}
        return {symbol.name for symbol in {*system.parameters, *found}}


@dataclass(frozen=True, kw_only=True)
class LoopOptions(PlantOptions):
    """What stands around a transfer function: L = C G H, T = C G/(1 + C G H)."""

    controller: Expr | None = option(LoopElement(), "controller C in series with the plant", loop="loop")
    feedback: Expr | None = option(
        LoopElement(switched=True),
        "what is in the feedback path, H; the question is then about C G/(1 + C G H)",
        loop="loop",
    )
