"""What every task about a plant takes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation import Options, option
from solver.options.loop_element import LoopElement
from solver.options.matrix import MatrixOf
from solver.words import Reason

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
    """What stands around a transfer function: L = C G H, T = C G/(1 + C G H), of matrices C G (I + H C G)⁻¹."""

    controller: Expr | ImmutableMatrix | None = option(
        LoopElement(), "controller C in series with the plant; of matrices the product is C G", loop="loop"
    )
    feedback: Expr | ImmutableMatrix | None = option(
        LoopElement(switched=True),
        "what is in the feedback path, H; the question is then about C G/(1 + C G H), of matrices C G (I + H C G)⁻¹",
        loop="loop",
    )

    def faults(self, system: System) -> Iterable[tuple[str, Reason]]:
        """C has a column for each output of the plant, H a row for each input and a column for each output of C G."""
        p, m, C, H = system.size("p") or None, system.size("m") or None, self.controller, self.feedback
        shape = getattr(C, "shape", None)
        if shape and p is not None and shape[1] != p:
            yield (
                "controller",
                Reason("conversions/controller_size", {"columns": shape[1], "p": p, "fits": shape[0] == p}),
            )
        outputs = shape[0] if shape else None if "controller" in self.later else p
        if H is None or m is None or outputs is None:
            return
        if not hasattr(H, "shape"):
            if outputs != m:
                yield "feedback", Reason("conversions/feedback_not_square", {"rows": outputs, "columns": m})
        elif H.shape != (m, outputs):
            values = {"rows": H.shape[0], "columns": H.shape[1], "m": m, "outputs": outputs}
            yield (
                "feedback",
                Reason("conversions/feedback_size", {**values, "fits": (H.shape[1], H.shape[0]) == (m, outputs)}),
            )
