"""What the poles of a loop satisfy: 1 + L(s) = 0 of an open loop, or p(s) = 0. No kind of its own in a file."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.systems.loops import OpenLoop
from solver.systems.polynomial import Polynomial
from solver.systems.surrounded import Surrounded

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@dataclass(frozen=True)
class CharacteristicEquation(Surrounded):
    """`given` is an open loop L = P/Q, whose loop has the poles P + Q = 0, or their polynomial itself."""

    given: OpenLoop | Polynomial

    @property
    def variable(self) -> Symbol:
        """The symbol s (discrete: z)."""
        return self.given.variable

    @property
    def loop(self) -> OpenLoop | None:
        """The open loop, where there is one."""
        return self.given if isinstance(self.given, OpenLoop) else None

    @property
    def polynomial(self) -> Expr:
        """The polynomial of the poles: numerator plus denominator of L, nothing cancelled."""
        given = self.given
        return given.numerator + given.denominator if isinstance(given, OpenLoop) else given.expression

    @property
    def delay(self) -> Expr | None:
        """The dead time in the loop; None for a polynomial."""
        return self.given.delay if isinstance(self.given, OpenLoop) else None

    @property
    def around(self) -> set[Symbol]:
        """The free symbols of the equation, but for the variable."""
        found: set[Any] = {*self.given.parameters}
        return found

    @property
    def provides(self) -> frozenset[str]:
        """A task can ask how the poles move."""
        return frozenset({"characteristic_equation"})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return self.plant.described
