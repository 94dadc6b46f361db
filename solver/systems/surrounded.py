"""A plant with something around it or before it: what it has from the plant."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.systems.kind import System

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@dataclass(frozen=True)
class Surrounded:
    """A plant with something around it or before it."""

    plant: System

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
        """The free symbols of the plant and of what is around it, sorted by name."""
        return tuple(sorted({*self.plant.parameters, *self.around}, key=str))

    @property
    def around(self) -> set[Symbol]:
        """The free symbols of what stands around the plant."""
        raise NotImplementedError

    def size(self, of: str) -> int | None:
        """Return the number of states "n", inputs "m" or outputs "p" of the plant."""
        return self.plant.size(of)

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the plant's "state"s, "input"s or "output"s."""
        return self.plant.names(of)
