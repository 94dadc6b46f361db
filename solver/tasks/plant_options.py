"""What every task about a plant takes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation import Options, option
from solver.options.matrix import MatrixOf

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


@dataclass(frozen=True, kw_only=True)
class PlantOptions(Options):
    """The gain that closes the loop before the question is asked."""

    gain: ImmutableMatrix | None = option(
        MatrixOf("m", "n", flat="row"),
        "state feedback u = −K x; the question is then about A − BK",
        answer="K",
        closes_the_loop=True,
    )
