"""Model matching: the polynomial that turns H = N/D into a target by state feedback, which keeps the zeros."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from solver.exact.design.placement import Coefficients, roots_of
from solver.exact.linear_algebra.affine import tidy


@dataclass(frozen=True)
class Matching:
    """H = N/D with monic D of degree n, and what a target G = κ M/E (M, E monic, coprime) asks of det(sI − A + BK).

    `missing` is the factor of M that N does not have (1 if it has all), `hidden` = N/M (monic) the zeros of the plant
    that the target does not show, `desired` = E · hidden the coefficients of the closed-loop polynomial, None where
    its degree is not n. `gain` is κ over the leading coefficient of N.
    """

    numerator: sp.Expr
    denominator: sp.Expr
    target_numerator: sp.Expr
    target_denominator: sp.Expr
    missing: sp.Expr
    hidden: sp.Expr
    desired: Coefficients | None
    gain: sp.Expr
    compensator: sp.Expr
    hidden_zeros: tuple[sp.Expr, ...]
    relative_degrees: tuple[int, int]
    order: int

    @property
    def possible(self) -> bool:
        """Whether the target has no zeros of its own and the relative degree of the plant."""
        return self.missing == 1 and self.desired is not None


def matching(numerator: sp.Expr, denominator: sp.Expr, target: sp.Expr, x: sp.Symbol) -> Matching:
    """Compare the plant N/D (not cancelled) with the target, a rational function of x."""
    above, below = sp.fraction(sp.cancel(target))
    (N, D, M, E), _ = sp.parallel_poly_from_expr((numerator, denominator, above, below), x, field=True)
    gain = sp.cancel((M.LC() / E.LC()) / (N.LC() / D.LC()))
    M, E = M.monic(), E.monic()
    compensator = sp.factor(sp.cancel(target * denominator / numerator))
    common = M.gcd(N)
    missing = M.quo(common).monic()
    hidden = N.monic().quo(common.monic())
    desired = None
    if missing.degree() == 0 and hidden.degree() + E.degree() == D.degree():
        desired = tuple(tidy(c) for c in (hidden * E).all_coeffs())
    return Matching(
        numerator=sp.factor(N.as_expr() / D.LC()),
        denominator=sp.factor(D.monic().as_expr()),
        target_numerator=sp.factor(above / sp.LC(below, x)),
        target_denominator=sp.factor(E.as_expr()),
        missing=sp.factor(missing.as_expr()),
        hidden=sp.factor(hidden.as_expr()),
        desired=desired,
        gain=gain,
        compensator=compensator,
        hidden_zeros=tuple(roots_of(tuple(hidden.all_coeffs()))),
        relative_degrees=(D.degree() - N.degree(), E.degree() - M.degree()),
        order=int(D.degree()),
    )


def descending_form(
    numerator: sp.Expr, denominator: sp.Expr, x: sp.Symbol
) -> tuple[sp.ImmutableMatrix, sp.ImmutableMatrix, sp.ImmutableMatrix, sp.ImmutableMatrix]:
    """Return A, B, C, D of N/D in controllable canonical form with the coefficients −a₁ … −aₙ in the first row."""
    (N, P), _ = sp.parallel_poly_from_expr((numerator, denominator), x, field=True)
    lead, n = P.LC(), P.degree()
    a = [tidy(c / lead) for c in P.all_coeffs()]
    b = [sp.Integer(0)] * (n - N.degree()) + [tidy(c / lead) for c in N.all_coeffs()]
    A = sp.ImmutableMatrix(n, n, lambda i, j: -a[j + 1] if i == 0 else int(i == j + 1))
    B = sp.ImmutableMatrix(n, 1, lambda i, _: int(i == 0))
    C = sp.ImmutableMatrix(1, n, [tidy(b[i + 1] - b[0] * a[i + 1]) for i in range(n)])
    return A, B, C, sp.ImmutableMatrix([[b[0]]])
