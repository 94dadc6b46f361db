"""Plants with something around them: not given as such in a file, but made by options of a task."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.lazy import sympy as sp
from solver.systems.surrounded import Surrounded

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems.transfer_function import DeadTime, TransferFunction


class Loop(Surrounded):
    """A plant with something around it that closes a loop."""

    @property
    def provides(self) -> frozenset[str]:
        """Nothing, until the loop is closed."""
        return frozenset()

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return self.plant.described


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

    controller: Expr | ImmutableMatrix
    feedback: Expr | ImmutableMatrix | None

    @property
    def around(self) -> set[Symbol]:
        """The free symbols of C and H, but for the variable."""
        found: set[Any] = self.controller.free_symbols | (
            set() if self.feedback is None else self.feedback.free_symbols
        )
        return {symbol for symbol in found if str(symbol) != ("z" if self.discrete else "s")}


@dataclass(frozen=True)
class MatrixFeedback(OutputFeedback):
    """The same of several inputs or outputs, C G (I + H C G)⁻¹ or C G; an expression C or H is a multiple of I."""

    def size(self, of: str) -> int | None:
        """Return the number of inputs "m" of the plant, of outputs "p" of C G; that of all states is not known yet."""
        if of == "p" and hasattr(self.controller, "shape"):
            return int(self.controller.shape[0])
        return None if of == "n" else self.plant.size(of)


@dataclass(frozen=True)
class LatePath(OutputFeedback):
    """A plant with a dead time behind a controller, no loop round it: C G e^{−Ts}."""

    plant: DeadTime


@dataclass(frozen=True)
class LateLoop(OutputFeedback):
    """A loop round a dead time, C G e^{−Ts}/(1 + C G H e^{−Ts}): no quotient of polynomials."""

    plant: DeadTime

    @property
    def provides(self) -> frozenset[str]:
        """There is a path from the reference to the output."""
        return frozenset({"path"})

    @property
    def rational(self) -> OutputFeedback:
        """The same loop without the dead time."""
        return OutputFeedback(self.plant.rational, self.controller, self.feedback)


@dataclass(frozen=True)
class OpenLoop(Surrounded):
    """L = C G H of one input and one output, what a signal passes on its way round a loop; L = L₀ e^{−T s}.

    `rational` is L₀, its numerator and denominator with nothing cancelled between C, G and H; `delay` is T ≥ 0.
    `C`, `G` (without the dead time) and `H` are its factors; H = 1 where no feedback was named, `closed` is then False.
    """

    rational: TransferFunction
    delay: Expr
    C: Expr
    G: Expr
    H: Expr
    closed: bool = False

    @property
    def variable(self) -> Symbol:
        """The symbol s (discrete: z)."""
        return self.rational.variable

    @property
    def numerator(self) -> Expr:
        """The numerator of L₀, as a polynomial."""
        return self.rational.numerators[0][0]

    @property
    def denominator(self) -> Expr:
        """The denominator of L₀, as a polynomial."""
        return self.rational.denominators[0][0]

    @property
    def factor(self) -> Expr:
        """The factor e^{−Ts}, 1 without a dead time."""
        return sp.exp(-self.delay * self.variable)

    @property
    def around(self) -> set[Symbol]:
        """The free symbols of L, but for the variable."""
        found: set[Any] = {*self.rational.parameters, *self.delay.free_symbols}
        return found

    @property
    def provides(self) -> frozenset[str]:
        """A task can ask for what runs round the loop."""
        return frozenset({"open_loop"})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return self.plant.described
