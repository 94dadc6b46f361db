"""How many roots of a polynomial lie outside of the region of stability and on its boundary, without finding them.

Of the left half plane: to the right and on the axis. Of the unit disc they are those of the bilinear image.
Roots that lie symmetrically to the origin are those of g = gcd of the even and the odd part; of g as many lie to the
right as to the left, the others on the axis. Source: F. R. Gantmacher, The Theory of Matrices II, XV §§4, 6.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import domain_matrix, expression
from solver.exact.stability.inequalities import sign_of
from solver.exact.stability.routh import bilinear, routh


@dataclass(frozen=True)
class RootCounts:
    """p = `rest` · `symmetric` by coefficients; roots of p `outside` and `on` the axis, of g `outside_symmetric`.

    In discrete time `rest` and `symmetric` are those of the bilinear image, where z = 1 is no root any more.
    """

    symmetric: tuple[sp.Expr, ...]
    rest: tuple[sp.Expr, ...]
    outside: int
    on: int
    outside_symmetric: int


def sign_changes(signs: Sequence[int | None]) -> int:
    """Return how often a sign differs from the one before it."""
    return sum(1 for first, second in pairwise(signs) if first != second)


def root_counts(coefficients: Sequence[sp.Expr], *, discrete: bool = False) -> RootCounts | None:
    """Return where the roots lie, in discrete time beside the unit circle; None where a sign depends on parameters."""
    if discrete:
        image = list(bilinear(coefficients))
        kept = next(i for i, c in enumerate(image) if not _is_zero(c))
        found = root_counts(image[kept:])
        return None if found is None else replace(found, on=found.on + kept)
    K, (flat,) = (matrix := domain_matrix(sp.Matrix([list(coefficients)]))).domain, matrix.to_list()
    s, n = sp.Dummy("s"), len(flat) - 1
    p = sp.Poly(flat, s, domain=K)
    even, odd = (sp.Poly([c if (n - i) % 2 == r else K.zero for i, c in enumerate(flat)], s, domain=K) for r in (0, 1))
    g = even.gcd(odd)
    rest = p.quo(g)
    counts = [(_outside(_listed(part, K)), m) for part, m in (g.sqf_list()[1] if g.degree() else ())]
    to_the_right = _outside(_listed(rest, K)) if rest.degree() else 0
    if to_the_right is None or any(count is None for count, _ in counts):
        return None
    symmetric = sum(count * m for count, m in counts if count)
    on = int(g.degree()) - 2 * symmetric
    return RootCounts(_listed(g, K), _listed(rest, K), to_the_right + symmetric, on, symmetric)


def _is_zero(c: sp.Expr) -> bool:
    """Whether a coefficient is zero, roots multiplied out."""
    return bool(c == 0 or (not c.is_Rational and sp.radsimp(c) == 0))


def _listed(p: sp.Poly, K: Any) -> tuple[sp.Expr, ...]:
    return tuple(expression(K, K.convert(c)) for c in p.rep.to_list())


def _outside(coefficients: Sequence[sp.Expr]) -> int | None:
    """The roots to the right of a polynomial whose array counts rightly; None where a sign is not decided."""
    signs = [sign_of(entry) for entry in routh(coefficients).at_zero]
    return None if None in signs else sign_changes(signs)


def hurwitz_matrix(coefficients: Sequence[sp.Expr]) -> sp.ImmutableMatrix:
    """Return the n×n matrix whose entry in row i, column j is a_{2j − i}, with a₀ the leading coefficient."""
    n = len(coefficients) - 1
    entries = [
        [coefficients[2 * j - i] if 0 <= 2 * j - i <= n else sp.Integer(0) for j in range(1, n + 1)]
        for i in range(1, n + 1)
    ]
    return sp.ImmutableMatrix(entries)
