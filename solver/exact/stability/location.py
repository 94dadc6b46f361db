"""Where eigenvalues lie, decided exactly: inside the region of stability, on its boundary, outside.

The region is the open left half plane, in discrete time the open unit disc.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.eigen import Eigenspace, eigenstructure
from solver.exact.linear_algebra.faddeev import faddeev_leverrier
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.spectrum import Factor, Root, Spectrum, spectrum
from solver.exact.stability.conditions import all_positive
from solver.exact.stability.inequalities import sign_of
from solver.exact.stability.routh import bilinear, routh

STABLE, MARGINAL, UNSTABLE = "asymptotically stable", "marginally stable", "unstable"
NEAR = sp.Float(10) ** -18
"""Decimal roots (30 digits) nearer than this to the boundary are on it, if their factor's symmetry allows."""


@dataclass(frozen=True)
class Placed:
    """A root, its multiplicity in `root`, and where it is: −1 inside, 0 on the boundary, 1 outside, None undecided.

    `measure` is Re λ (in discrete time |λ|) where it can be written down.
    """

    root: Root
    position: int | None
    measure: sp.Expr | None


@dataclass(frozen=True)
class Location:
    """All eigenvalues with their places; `critical` are the eigenspaces of those on the boundary."""

    spectrum: Spectrum
    placed: tuple[Placed, ...]
    critical: tuple[Eigenspace, ...]

    @property
    def verdict(self) -> str | None:
        """The verdict on the free motion; None where it depends on parameters."""
        positions = [each.position for each in self.placed]
        if 1 in positions:
            return UNSTABLE
        if None in positions:
            return None
        if any(space.geometric < space.algebraic for space in self.critical):
            return UNSTABLE
        return MARGINAL if 0 in positions else STABLE


def location(A: sp.ImmutableMatrix, *, discrete: bool) -> Location:
    """Place the eigenvalues of A (n×n); raises NotExact for a factor of degree ≥ 3 with parameters."""
    found = spectrum(A)
    placed = tuple(each for factor in found.factors for each in _placed(factor, discrete=discrete))
    on = {each.root.value for each in placed if each.position == 0}
    spaces = eigenstructure(A).eigenspaces if on else ()
    return Location(found, placed, tuple(space for space in spaces if space.root.value in on))


def _placed(factor: Factor, *, discrete: bool) -> list[Placed]:
    places = (_in_disc if discrete else _in_half_plane)(factor)
    measures = [_measure(root, factor, discrete=discrete) for root in factor.roots]
    return [Placed(root, place, x) for root, place, x in zip(factor.roots, places, measures, strict=True)]


def _measure(root: Root, factor: Factor, *, discrete: bool) -> sp.Expr | None:
    """Re λ or |λ|; None where it is not known whether the root is real."""
    if root.kind == "symbolic" and factor.degree == 2:
        return None
    if not discrete:
        return root.sigma if root.value.has(sp.I) else root.value
    if not root.value.has(sp.I):
        return sp.Abs(root.value)
    if root.kind == "decimal" or factor.degree > 2:
        return sp.sqrt(sp.expand(root.sigma**2 + root.shift**2))
    return sp.sqrt(sp.expand(factor.coefficients[-1]))


def _in_half_plane(factor: Factor) -> list[int | None]:
    roots = factor.roots
    if factor.degree == 1:
        return [sign_of(roots[0].value)]
    if factor.degree == 2 and roots[0].kind != "complex":
        _, b, c = factor.coefficients
        if not (b.free_symbols or c.free_symbols):
            return [sign_of(root.value) for root in roots]
        of_b, of_c = sign_of(b), sign_of(c)
        if of_c == 1:  # a pair, or two real roots of one sign
            return [None if of_b is None else -of_b] * 2
        return [-1, 1] if of_c == -1 else [1 if of_b == -1 else None, None]
    if factor.degree == 2 or roots[0].kind != "decimal":
        return [sign_of(root.value if root.kind == "surd" else root.sigma) for root in roots]
    even = all(c == 0 for c in factor.coefficients[1::2])
    return [_near_boundary(root.sigma, even, root) for root in roots]


def _near_boundary(excess: sp.Expr, symmetric: bool, root: Root) -> int:
    """The side of a decimal root; on the boundary only roots of a factor that has the mirror images of its roots."""
    if abs(excess) > NEAR * (1 + abs(root.value)):
        return 1 if excess > 0 else -1
    if symmetric:
        return 0
    raise NotExact("stability/too_close_to_the_boundary")


def _in_disc(factor: Factor) -> list[int | None]:
    roots, c = factor.roots, factor.coefficients
    if factor.degree == 1:
        return [_sign_of_square(roots[0].value ** 2 - 1)]
    if factor.degree == 2 and roots[0].kind == "complex":
        return [_sign_of_square(c[2] - 1)] * 2
    if factor.degree == 2:
        if not any(x.free_symbols for x in c):
            return [sign_of(sp.expand(root.value**2) - 1) for root in roots]
        jury = [sign_of(x) for x in (1 + c[1] + c[2], 1 - c[1] + c[2], 1 - c[2])]
        return [-1, -1] if jury == [1, 1, 1] else [1 if -1 in jury else None, None]
    if roots[0].kind != "decimal":
        squares = [root.sigma**2 + root.shift**2 for root in roots]
        return [_sign_of_square(square - 1) for square in squares]
    reciprocal = list(c) in ([x / c[-1] for x in reversed(c)],)
    return [_near_boundary(sp.sqrt(root.sigma**2 + root.shift**2) - 1, reciprocal, root) for root in roots]


def _sign_of_square(x: sp.Expr) -> int | None:
    return sign_of(sp.factor(sp.expand(x)))


def coefficients(A: sp.ImmutableMatrix) -> tuple[sp.Expr, ...]:
    """1, a₁, …, aₙ of χ = det(sI − A)."""
    return faddeev_leverrier(A).coefficients


def off_the_point_one(listed: Sequence[sp.Expr]) -> tuple[tuple[sp.Expr, ...], int]:
    """Divide a polynomial in z by (z − 1) as often as that goes; return the quotient's coefficients and how often."""
    c, count = list(listed), 0
    while len(c) > 1 and sp.expand(sum(c)) == 0:
        for i in range(1, len(c)):
            c[i] = sp.expand(c[i] + c[i - 1])
        c.pop()
        count += 1
    return tuple(c), count


def stability_conditions(A: sp.ImmutableMatrix, *, discrete: bool) -> list[sp.Expr]:
    """Return what must be positive for asymptotic stability: the first column of the Routh array.

    In discrete time of the array of the bilinear image. A condition that can't hold is −1.
    """
    return polynomial_conditions(coefficients(A), discrete=discrete)


def polynomial_conditions(listed: Sequence[sp.Expr], *, discrete: bool) -> list[sp.Expr]:
    """Return what must be positive for all roots of a monic polynomial (highest power first) to be inside."""
    c = bilinear(listed) if discrete else tuple(listed)
    if c[0] == 0:
        return [sp.Integer(-1)]
    array = routh(c)
    return [sp.Integer(-1)] if any(row.special for row in array.rows) else list(array.first_column)


def root_conditions(listed: Sequence[sp.Expr], *, discrete: bool) -> list[sp.Expr]:
    """Return what must be positive for all roots of a polynomial to be inside, as it is known for low degrees.

    The leading coefficient must be positive; from three roots on it must be one.
    """
    c = listed
    if not discrete and len(c) <= 3:
        return list(c[1:])
    if discrete and len(c) == 2:
        return [c[0] + c[1], c[0] - c[1]]
    if discrete and len(c) == 3:
        return [c[0] + c[1] + c[2], c[0] - c[1] + c[2], c[0] - c[2]]
    return polynomial_conditions(c, discrete=discrete)


def stable_where(A: sp.ImmutableMatrix, *, discrete: bool, wanted: Sequence[sp.Symbol] = ()) -> sp.Basic:
    """The condition on parameters under which A is asymptotically stable; true or false where it does not depend."""
    return all_positive(stability_conditions(A, discrete=discrete), wanted)


def definiteness(M: sp.ImmutableMatrix) -> str | None:
    """Say whether a symmetric M is "positive definite", "positive semidefinite", "negative ..." or "indefinite".

    By the signs of the coefficients of det(λI − M), all of whose roots are real; None where parameters decide.
    """
    c = coefficients(M)
    for word, signs in (("positive", [(-1) ** i * x for i, x in enumerate(c)]), ("negative", c)):
        known = [sign_of(sp.expand(x)) for x in signs]
        if all(sign == 1 for sign in known):
            return f"{word} definite"
        if all(sign is not None and sign >= 0 for sign in known):
            return f"{word} semidefinite"
        if -1 not in known:
            return None
    return "indefinite"


def is_stable_polynomial(listed: Sequence[sp.Expr], *, discrete: bool) -> bool | None:
    """Whether all roots of a polynomial (highest power first) are inside; None where parameters decide."""
    c = tuple(listed)
    if discrete:
        c = bilinear(c)
        if c[0] == 0:
            return False
    if sign_of(c[0]) == -1:
        c = tuple(-x for x in c)
    array = routh(c)
    signs = [sign_of(x) for x in array.first_column]
    if any(row.special for row in array.rows) or any(sign is not None and sign < 1 for sign in signs):
        return False
    return None if None in signs else True
