"""Plants with something around them: not given as such in a file, but made by options of a task."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.systems.kind import System

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@dataclass(frozen=True)
class Loop:
    """A plant with something around it."""

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


@dataclass(frozen=True)
class StateFeedback(Loop):
    """A plant under u = −K x (K m×n)."""

    K: ImmutableMatrix

    @property
    def around(self) -> set[Symbol]:
        """The free symbols of the gain."""
        return set(self.K.free_symbols)


@dataclass(frozen=True)
class OutputFeedback(Loop):
    """A plant G behind a controller C, with H in the feedback path: C G/(1 + C G H), or C G where H is None."""

    controller: Expr
    feedback: Expr | None

    @property
    def around(self) -> set[Symbol]:
        """The free symbols of C and H, but for the variable."""
        found: set[Any] = self.controller.free_symbols | (
            set() if self.feedback is None else self.feedback.free_symbols
        )
        return {symbol for symbol in found if str(symbol) != ("z" if self.discrete else "s")}
