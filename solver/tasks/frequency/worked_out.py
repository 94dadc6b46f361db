"""The value of a transfer function at a frequency as on paper: what is put in, and the sizes of the factors."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.frequencies import size_and_angle
from solver.arithmetic.roots import values_at
from solver.lazy import sympy as sp
from solver.tasks.frequency.crossovers import formula_of

if TYPE_CHECKING:
    from sympy import Expr

    from solver.derivation import Step
    from solver.lazy import exact


@where_exact
def value_worked_out(T: exact.OnAxis, omega: Expr, magnitude: Expr) -> tuple[Step, ...]:
    """The denominator, and a numerator that is no number, at jω; the sizes of the factors multiplied."""
    whole, s, at = formula_of(T), T.variable, T.point(omega)
    if T.late or omega.free_symbols or whole.free_symbols - {s}:
        return ()
    above, below = sp.fraction(sp.together(whole))
    lines: tuple[Step, ...] = ()
    for p in (below, above):
        if omega.is_Rational and not T.discrete and sp.degree(p, s) > 1:
            lines += values_at(sp.expand(p), s, [at])
    return lines + size_and_angle(whole, s, at, magnitude)
