"""How answers about a loop with parameters are judged: at some of their values, conditions beside every edge."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Attempt, Check, Given
from solver.lazy import sympy as sp
from solver.numeric.judges import frequency as judges
from solver.tasks.frequency.boundary import period_of
from solver.tasks.stability.counterexamples import condition_check, counterexample
from solver.tasks.stability.criterion import companion_of
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import OpenLoop
    from solver.tasks.plant_options import LoopOptions


@dataclass(frozen=True)
class LoopAtValues:
    """A loop with values of its parameters put in."""

    N: Expr
    D: Expr
    s: Expr
    delay: Expr
    period: Any

    @property
    def numbers(self) -> judges.NumericLoop:
        """L in numbers, for its judges."""
        return judges.numeric_loop(self.N, self.D, self.s, self.delay, self.period)

    def open_loop_poles(self) -> int:
        """The poles of L outside of the region of stability."""
        outside, _ = judges.roots_outside(sp.Poly(self.D, self.s).all_coeffs(), discrete=self.period is not None)
        return outside

    def closed_loop_poles(self) -> tuple[int, int]:
        """The poles of the closed loop outside of the region of stability, and on its boundary."""
        return judges.closed_loop_poles(self.N, self.D, self.s, self.delay, self.period)


def at_values(loop: OpenLoop, answers: Answers) -> Iterator[tuple[LoopAtValues, dict[str, Any]]]:
    """The loop and the answers at some values of the parameters; as they are without parameters."""
    formulas, period = (loop.numerator, loop.denominator, sp.S.Zero + loop.delay), period_of(loop)
    for values in judges.values_of_parameters(formulas, [loop.variable]):
        N, D, delay = (each.xreplace(values) for each in formulas)
        own = {name: _at(value, values) for name, value in answers.items()}
        yield LoopAtValues(N, D, loop.variable, delay, period), own


def _at(value: Any, values: dict[Any, Any]) -> Any:
    if isinstance(value, list | tuple):
        return [_at(each, values) for each in value]
    return value.xreplace(values) if hasattr(value, "xreplace") else value


def holds_where_the_poles_say(given: Given[OpenLoop, LoopOptions], answers: Answers) -> Iterable[Check]:
    """At points on both sides of every edge, and at random ones, the condition is true if and only if D + N is."""
    says = "the condition holds exactly where all poles of the closed loop lie in the left half plane"
    yield condition_check(_companion(given.system), answers["condition"], says, discrete=False)


def where_it_is_wrong(wrong: Attempt[OpenLoop, LoopOptions]) -> Reason | None:
    """Values of the parameters at which the condition is wrong."""
    return counterexample(_companion(wrong.given.system), wrong.value, discrete=False)


def _companion(loop: OpenLoop) -> ImmutableMatrix:
    """A matrix whose eigenvalues are the poles of the closed loop."""
    return companion_of(sp.Poly(loop.numerator + loop.denominator, loop.variable).all_coeffs())


__all__ = ["LoopAtValues", "at_values", "holds_where_the_poles_say", "where_it_is_wrong"]
