"""A plant whose input comes late, as a dead time before it makes it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.systems.state_space import StateSpace

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@dataclass(frozen=True)
class LateInput:
    """x' = A x + B u(t − T), y = C x + D u(t − T): states with a dead time before them."""

    plant: StateSpace
    delay: Expr

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
        """The sampling period, where one is given."""
        return self.plant.sample_time

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols, sorted by name."""
        symbols: set[Any] = {*self.plant.parameters, *self.delay.free_symbols}
        return tuple(sorted(symbols, key=str))

    @property
    def provides(self) -> frozenset[str]:
        """How it moves can be asked; questions about A alone would forget the delay."""
        return frozenset({"motion"})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "the input comes late"

    def size(self, of: str) -> int | None:
        """Return the number of states "n", inputs "m" or outputs "p" of the plant."""
        return self.plant.size(of)

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the plant's "state"s, "input"s or "output"s."""
        return self.plant.names(of)
