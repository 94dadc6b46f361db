"""Division of polynomials in z by falling powers, as on paper: the quotient Σ f(k) z⁻ᵏ holds the sequence."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.fields import domain_matrix, in_powers
from solver.exact.transforms.images import RationalImage


@dataclass(frozen=True)
class DivisionRow:
    """f(k) z⁻ᵏ of the quotient, what it takes away, and what is left, the latter two by their powers of z."""

    step: int
    coefficient: sp.Expr
    taken: dict[int, sp.Expr]
    rest: dict[int, sp.Expr]


@dataclass(frozen=True)
class LongDivision:
    """N divided by D: `dividend` and `divisor` by their powers of z, the rows, and `values` from k = 0 on."""

    dividend: dict[int, sp.Expr]
    divisor: dict[int, sp.Expr]
    rows: tuple[DivisionRow, ...]
    values: tuple[sp.Expr, ...]


def long_division(image: RationalImage, z: sp.Symbol, terms: int) -> LongDivision:
    """The first `terms` values f(0), f(1), … of F = N/D with a monic D; a row for each that is not zero."""
    rows = [sp.Poly(side, z).all_coeffs() for side in (image.numerator, image.denominator)]
    both = domain_matrix(sp.ImmutableMatrix([[*rows[0], *rows[1]]]))
    K, listed = both.domain, both.to_list_flat()
    N, D = listed[: len(rows[0])], listed[len(rows[0]) :]
    n, first = len(D) - 1, len(D) - len(N)
    rest = N + [K.zero] * max(0, terms - first + n)
    values: dict[int, Any] = {}
    found = []
    for k in range(first, terms):
        at = k - first
        c = rest[at]
        values[k] = c
        if not c:
            continue
        taken = [c * d for d in D]
        for j, each in enumerate(taken):
            rest[at + j] -= each
        top = n - k
        # What stands behind the last power of the divisor has not been reached yet.
        left = rest[at + 1 : max(at + n + 1, len(N))]
        found.append(DivisionRow(k, _written(c, K), _by_powers(taken, top, K), _by_powers(left, top - 1, K)))
    return LongDivision(
        _by_powers(N, len(N) - 1, K), _by_powers(D, n, K), tuple(found),
        tuple(_written(values.get(k, K.zero), K) for k in range(terms)),
    )  # fmt: skip


def _written(c: Any, K: Any) -> sp.Expr:
    found: sp.Expr = in_powers([c], K, sp.Symbol("z"))
    return tidy(found)


def _by_powers(coefficients: list[Any], top: int, K: Any) -> dict[int, sp.Expr]:
    return {top - i: _written(c, K) for i, c in enumerate(coefficients) if c}
