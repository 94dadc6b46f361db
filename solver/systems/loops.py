"""Plants with something around them: not given as such in a file, but made by options of a task."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.systems.kind import System

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@dataclass(frozen=True)
class StateFeedback:
    """A plant under u = −K x (K m×n)."""

    plant: System
    K: ImmutableMatrix

    @property
    def kind(self) -> str:
        """The plant is what is given."""
        return self.plant.kind

    @property
    def discrete(self) -> bool:
        """Whether time is discrete."""
        return self.plant.discrete

    @property
    def sample_time(self) -> Expr | None:
        """The sampling period of the plant."""
        return self.plant.sample_time

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols of plant and gain, sorted by name."""
        return tuple(sorted({*self.plant.parameters, *self.K.free_symbols}, key=str))

    @property
    def provides(self) -> frozenset[str]:
        """Nothing, until the loop is closed."""
        return frozenset()

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return self.plant.described

    def size(self, of: str) -> int | None:
        """Return the number of states "n", inputs "m" or outputs "p" of the plant."""
        return self.plant.size(of)

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the plant's "state"s, "input"s or "output"s."""
        return self.plant.names(of)
