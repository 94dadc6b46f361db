"""The relative gain array G ∘ (G⁻¹)ᵀ at a point, at poles by its limit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import permutations

import sympy as sp

from solver.exact.linear_algebra.faddeev import faddeev_leverrier
from solver.exact.linear_algebra.fields import collected, domain_matrix, expression


@dataclass(frozen=True)
class RelativeGains:
    """K (n×n) with its determinant, inverse (None: singular) and Λ = K ∘ (K⁻¹)ᵀ."""

    gains: sp.ImmutableMatrix
    determinant: sp.Expr
    inverse: sp.ImmutableMatrix | None
    array: sp.ImmutableMatrix | None


@lru_cache(maxsize=64)
def relative_gains(K: sp.ImmutableMatrix) -> RelativeGains:
    """Λ of a square matrix of numbers, real or complex, and parameters; raises NotExact."""
    stands = {each: sp.Dummy("e") for each in K.atoms(sp.exp)}
    back = {symbol: each for each, symbol in stands.items()}
    D = domain_matrix(sp.ImmutableMatrix(K.xreplace(stands)), real=False)
    F = D.domain
    fl = faddeev_leverrier(sp.ImmutableMatrix(K.xreplace(stands)))
    det = collected(expression(F, F.convert(fl.chi[-1], fl.domain) * (-1) ** K.rows)).xreplace(back)
    if det.equals(0):
        return RelativeGains(K, sp.S.Zero, None, None)
    inverse = D.inv()
    rows, turned = D.to_list(), inverse.transpose().to_list()
    products = [a * b for row, other in zip(rows, turned, strict=True) for a, b in zip(row, other, strict=True)]
    inverted = [_written(expression(F, c)).xreplace(back) for c in inverse.to_list_flat()]
    array = [_written(expression(F, c)).xreplace(back) for c in products]
    return RelativeGains(K, det, sp.ImmutableMatrix(*K.shape, inverted), sp.ImmutableMatrix(*K.shape, array))


def _written(entry: sp.Expr) -> sp.Expr:
    """A number multiplied out; of parameters one fraction in factors, without a minus in front of a single sum."""
    if not entry.free_symbols:
        return sp.expand(entry)
    above, below = sp.fraction(sp.factor(entry))
    if below.could_extract_minus_sign():
        above, below = -above, -below
    sums = [factor for factor in sp.Mul.make_args(above) if factor.is_Add]
    if above.is_Mul and len(sums) == 1 and above.could_extract_minus_sign() and _is_mixed(sums[0]):
        above = -above / sums[0] * -sums[0]  # c (1 − a), not −c (a − 1)
    return -(-above / below) if above.could_extract_minus_sign() else above / below


def _is_mixed(terms: sp.Expr) -> bool:
    """Whether a sum has terms with a minus and others without."""
    return len({bool(term.could_extract_minus_sign()) for term in terms.args}) == 2


@dataclass(frozen=True)
class ScaledGains:
    """`gains` is the limit of diag((x − p)^k₁, …) G at p; `powers` are the k of the rows."""

    gains: sp.ImmutableMatrix
    powers: tuple[int, ...]


def gains_at(
    tops: Sequence[Sequence[sp.Expr]], bottoms: Sequence[Sequence[sp.Expr]], x: sp.Symbol, point: sp.Expr
) -> ScaledGains:
    """The values of quotients of polynomials at a point, each row with its poles there taken out."""
    powers, rows = [], []
    for row in zip(tops, bottoms, strict=True):
        pairs = list(zip(*row, strict=True))
        orders = [0 if top == 0 else _order(bottom, x, point) - _order(top, x, point) for top, bottom in pairs]
        k = max(0, *orders)
        powers.append(k)
        rows.append(
            [_limit(top, bottom, x, point, k, order) for (top, bottom), order in zip(pairs, orders, strict=True)]
        )
    return ScaledGains(sp.ImmutableMatrix(rows), tuple(powers))


def _order(p: sp.Expr, x: sp.Symbol, point: sp.Expr) -> int:
    """How often the point is a root of a polynomial that is not zero."""
    order = 0
    while _is_zero(p.subs(x, point)):
        p, order = sp.diff(p, x), order + 1
    return order


def _is_zero(value: sp.Expr) -> bool:
    found = sp.expand(value)
    return bool(found == 0 or (found.is_number and found.equals(0)))


def _limit(top: sp.Expr, bottom: sp.Expr, x: sp.Symbol, point: sp.Expr, power: int, order: int) -> sp.Expr:
    """The limit of (x − p)^power · top/bottom, whose pole there is of an order."""
    if top == 0 or order < power:
        return sp.S.Zero
    above, below = _order(top, x, point), _order(bottom, x, point)
    p = sp.expand(sp.diff(top, x, above).subs(x, point)) / sp.factorial(above)
    q = sp.expand(sp.diff(bottom, x, below).subs(x, point)) / sp.factorial(below)
    value = p / q
    return sp.expand(sp.radsimp(value)) if not value.free_symbols else _written(sp.cancel(value))


def values_at(M: sp.ImmutableMatrix, x: sp.Symbol, point: sp.Expr) -> sp.ImmutableMatrix | None:
    """The limits of the entries, quotients of polynomials; None where one is infinite."""
    pairs = [[sp.fraction(sp.cancel(entry)) for entry in row] for row in M.tolist()]
    found = gains_at([[p for p, _ in row] for row in pairs], [[q for _, q in row] for row in pairs], x, point)
    return None if any(found.powers) else found.gains


@dataclass(frozen=True)
class Pairing:
    """For each output the input it is paired with (counted from 0), the entries there, and what else they say.

    `negative` are the places of the entries with a negative real part. `distance` is the largest |λ − 1| of the pairs,
    `largest` the largest |λ| of all.
    """

    inputs: tuple[int, ...]
    entries: tuple[sp.Expr, ...]
    negative: tuple[tuple[int, int], ...]
    distance: sp.Expr
    largest: sp.Expr


DIGITS = 20
"""Decimal digits of the entries that are compared."""
MOST = 6
"""So many channels are paired by trying all ways."""


def pairing(array: sp.ImmutableMatrix) -> Pairing | None:
    """The pairing whose entries are closest to one in sum, none of them negative if that can be.

    None with parameters, and beyond `MOST` channels.
    """
    n = array.rows
    if array.free_symbols or n > MOST:
        return None
    parts = {(i, j): sp.N(array[i, j], DIGITS).as_real_imag() for i in range(n) for j in range(n)}
    negative = [place for place, (real, _) in parts.items() if real < 0]
    away = {place: sp.sqrt((real - 1) ** 2 + imaginary**2) for place, (real, imaginary) in parts.items()}

    def effort(inputs: tuple[int, ...]) -> tuple[int, sp.Expr]:
        places = list(enumerate(inputs))
        return sum(place in negative for place in places), sp.Add(*(away[place] for place in places))

    best = min(permutations(range(n)), key=effort)
    entries = tuple(array[i, j] for i, j in enumerate(best))
    largest = max(sp.sqrt(real**2 + imaginary**2) for real, imaginary in parts.values())
    return Pairing(best, entries, tuple(negative), max(away[place] for place in enumerate(best)), largest)
