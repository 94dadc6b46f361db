"""Lemma: the loop that a controller closes, its poles, and its step response beside that without the controller."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.derivation.figures import Motion, Signals
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.tasks.design.frames import linear_factors

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    Fraction = tuple[Expr, Expr]

LARGEST = 10
"""Loops of higher order are not drawn."""


def number_first(left: Expr, right: Expr) -> Any:
    """State a product of two polynomials, a number before the other."""
    return product(right, left) if right.is_number else product(left, right)


@lemma("compensated_loop")
def loop_closed_by(
    controller: Fraction, plant: Fraction, s: Symbol, caption: str, before: Fraction | None = None
) -> Derivation[exact.ClosedLoop]:
    """T = C G/(1 + C G) with its poles, and y after a step; `before` is another C G, stable in a loop too."""
    found = exact.closed_by(controller, plant, s)
    claims = {
        "denominator": Claim(
            total(product(controller[1], plant[1]), number_first(controller[0], plant[0])),
            found.denominator,
            "the denominator of the closed loop",
        )
    }
    if found.poles:
        lead = sp.Poly(found.denominator, s).LC()
        factors = product(lead, linear_factors(s, found.poles))
        claims["poles"] = Claim(factors, found.denominator, "the poles of the closed loop")
    yield Step(
        "closed_loop",
        claims=claims,
        s=s,
        T_numerator=found.numerator,
        poles=found.poles,
        stable=found.stable,
        has_zeros=sp.degree(found.numerator, s) > 0,
        figures=step_responses(found, s, caption, before) if found.stable else (),
    )
    return found


def step_responses(
    found: exact.ClosedLoop, s: Symbol, caption: str, before: Fraction | None = None
) -> tuple[Motion, ...]:
    """Return y after a step of the reference, beside that of the loop `before`, which is stable too."""
    loops = [(r"y", found.numerator, found.denominator)]
    if before is not None:
        other = exact.closed_by((sp.Integer(1), sp.Integer(1)), before, s)
        loops.append((r"y_{\text{before}}", other.numerator, other.denominator))
    parts = [exact.descending_form(sp.N(top), sp.N(bottom), s) for _, top, bottom in loops]
    A = sp.ImmutableMatrix(sp.diag(*(part[0] for part in parts)))
    if A.rows > LARGEST:
        return ()
    drive = _stacked(*(part[1] for part in parts))
    rows = sp.ImmutableMatrix(sp.diag(*(part[2] for part in parts)))
    offset = _stacked(*(part[3] for part in parts))
    panel = Signals("y", tuple(name for name, _, _ in loops), rows, offset, ("r", sp.Integer(1)))
    return (Motion(caption, A, sp.ImmutableMatrix(sp.zeros(A.rows, 1)), (panel,), drive=drive),)


def _stacked(*columns: ImmutableMatrix) -> Any:
    return sp.ImmutableMatrix(sp.Matrix.vstack(*map(sp.Matrix, columns)))
