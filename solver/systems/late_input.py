"""A plant whose input comes late, as a dead time before it makes it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.systems.state_space import StateSpace
from solver.systems.surrounded import Surrounded

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@dataclass(frozen=True)
class LateInput(Surrounded):
    """x' = A x + B u(t − T), y = C x + D u(t − T): states with a dead time before them."""

    plant: StateSpace
    delay: Expr

    @property
    def around(self) -> set[Symbol]:
        """The free symbols of the dead time."""
        found: set[Any] = self.delay.free_symbols
        return found

    @property
    def provides(self) -> frozenset[str]:
        """How it moves can be asked; questions about A alone would forget the delay."""
        return frozenset({"motion", "states"})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "the input comes late"
