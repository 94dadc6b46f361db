"""L on the boundary of stability: on the imaginary axis, of a discrete loop on the unit circle."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import Refusal, Unsolved
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import frequency as judges
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop, System


def on_boundary(loop: OpenLoop) -> exact.OnAxis:
    """Return L(jω), or L(e^{jωT}). Raises Unsolved for a dead time beside samples."""
    if not loop.discrete:
        return exact.on_axis(loop.numerator, loop.denominator, loop.variable, loop.delay)
    return of_samples(loop, loop.numerator, loop.denominator)


def of_samples(loop: OpenLoop, numerator: Expr, denominator: Expr) -> exact.OnCircle:
    """Return a quotient of polynomials in z on the unit circle; T is 1 where it is not given."""
    if loop.delay != 0:
        raise Unsolved("frequency/delay_beside_samples")
    return exact.on_circle(numerator, denominator, loop.variable, period_of(loop))


def numbers_of(loop: OpenLoop) -> judges.NumericLoop:
    """Return L in numbers, for its judges."""
    return judges.numeric_loop(loop.numerator, loop.denominator, loop.variable, loop.delay, period_of(loop))


def poles_in_numbers(loop: OpenLoop) -> tuple[int, int]:
    """Return how many poles of the closed loop are outside of the region of stability, and on its boundary."""
    return judges.closed_loop_poles(loop.numerator, loop.denominator, loop.variable, loop.delay, period_of(loop))


def period_of(loop: OpenLoop) -> Any:
    """Return the sampling period, 1 where it is not given; None of a continuous loop."""
    if not loop.discrete:
        return None
    return sp.S.One if loop.sample_time is None else loop.sample_time


def needs_a_sampling_period(system: System, options: Any) -> Iterable[Refusal]:  # noqa: ARG001 - of any options
    """Frequencies of a discrete loop are in rad/s, so that its sampling period is needed."""
    if system.discrete and system.sample_time is None:
        yield "", Reason("frequency/no_sample_time")


__all__ = ["needs_a_sampling_period", "numbers_of", "of_samples", "on_boundary", "period_of", "poles_in_numbers"]
