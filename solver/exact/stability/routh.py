"""The Routh array, with both special cases, exact.

A zero in the first column beside other entries becomes ε > 0, which goes to zero at the end; a row of zeros becomes the
derivative of the auxiliary polynomial, whose coefficients stand in the row above.
Source: F. R. Gantmacher, The Theory of Matrices II, chapter XV §§3–4.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import domain_matrix, expression

EPSILON_NAMES = ("epsilon", "varepsilon", "delta")


@dataclass(frozen=True)
class RouthRow:
    """The row of sᵏ, k = `power`. `special` says how it came about: "", "pivot" (ε) or "zeros" (auxiliary polynomial).

    `computed` are the entries by the rule of the array, `entries` those that take their place.
    `auxiliary` are the coefficients of the auxiliary polynomial, highest power k + 1 first, every other power.
    """

    power: int
    entries: tuple[sp.Expr, ...]
    computed: tuple[sp.Expr, ...]
    special: str = ""
    auxiliary: tuple[sp.Expr, ...] = ()


@dataclass(frozen=True)
class RouthArray:
    """The rows from sⁿ to s⁰; `epsilon` is the symbol put in place of zero pivots, or None."""

    coefficients: tuple[sp.Expr, ...]
    rows: tuple[RouthRow, ...]
    epsilon: sp.Symbol | None
    at_zero: tuple[sp.Expr, ...]
    """The first column for ε → 0, each entry up to a positive factor."""

    @property
    def matrix(self) -> sp.ImmutableMatrix:
        """The array, (n+1) × ⌈(n+1)/2⌉, shorter rows filled up with zeros."""
        width = len(self.rows[0].entries)
        return sp.ImmutableMatrix([[*row.entries, *[0] * (width - len(row.entries))] for row in self.rows])

    @property
    def first_column(self) -> tuple[sp.Expr, ...]:
        """The first entries of all rows."""
        return tuple(row.entries[0] for row in self.rows)


def routh(polynomial: sp.Poly | Sequence[Any]) -> RouthArray:
    """Return the array of a polynomial in s, given as a Poly or by its coefficients, highest power first.

    Raises ValueError for a leading coefficient that is zero, NotExact for coefficients without exact arithmetic.
    """
    listed = polynomial.all_coeffs() if isinstance(polynomial, sp.Poly) else list(polynomial)
    coefficients = tuple(sp.Integer(c) if isinstance(c, int) else c for c in listed)
    if not coefficients or coefficients[0] == 0:
        raise ValueError("the leading coefficient is zero")
    try:
        return _array(coefficients, None)
    except _ZeroPivot:
        return _array(coefficients, _new_symbol(coefficients))


class _ZeroPivot(Exception):  # noqa: N818 - a signal, not an error
    """The array needs ε."""


def _new_symbol(coefficients: Sequence[sp.Expr]) -> sp.Symbol:
    used = {str(symbol) for c in coefficients for symbol in c.free_symbols}
    return next(sp.Symbol(name) for name in EPSILON_NAMES if name not in used)


def _array(coefficients: tuple[sp.Expr, ...], epsilon: sp.Symbol | None) -> RouthArray:
    extra = (epsilon,) if epsilon is not None else ()
    matrix = domain_matrix(sp.Matrix([[*coefficients, *extra]]))
    K, (flat,) = matrix.domain, matrix.to_list()
    values = flat[: len(coefficients)]
    kept: list[list[Any]] = []
    rows: list[RouthRow] = []
    for row, raw, special in _rows(K, values, flat[-1] if extra else None):
        power = len(coefficients) - 1 - len(rows)
        auxiliary = kept[-1] if special == "zeros" else []
        kept.append(row)
        shown, computed, above = (tuple(expression(K, c) for c in each) for each in (row, raw, auxiliary))
        rows.append(RouthRow(power, shown, computed, special, above))
    limits = tuple(_at_zero(row.entries[0], epsilon) for row in rows)
    return RouthArray(coefficients, tuple(rows), epsilon, limits)


def _rows(K: Any, values: list[Any], epsilon: Any) -> Iterator[tuple[list[Any], list[Any], str]]:
    """Yield for each power from n to 0 the entries, the entries by the rule, and the special case."""
    n = len(values) - 1
    above = values[0::2]
    yield above, above, ""
    row = values[1::2]
    for power in range(n - 1, -1, -1):
        raw, special = row, ""
        if not any(raw):  # the derivative of the auxiliary polynomial Σ aboveᵢ s^(power + 1 − 2i)
            row, special = [K(power + 1 - 2 * i) * above[i] for i in range(len(raw))], "zeros"
        elif not raw[0]:
            if epsilon is None:
                raise _ZeroPivot
            row, special = [epsilon, *raw[1:]], "pivot"
        yield row, raw, special
        above, row = row, _next_row(above, row, power // 2 + (power % 2))


def _next_row(above: list[Any], row: list[Any], length: int) -> list[Any]:
    """(r₁ a_{j+1} − a₁ r_{j+1})/r₁ for j = 1, …, `length`; entries beyond a row's end are zero."""
    zero = row[0] - row[0]
    long, short = [*above, *[zero] * 2 * length], [*row, *[zero] * 2 * length]
    return [(row[0] * long[j + 1] - above[0] * short[j + 1]) / row[0] for j in range(length)]


def _at_zero(entry: sp.Expr, epsilon: sp.Symbol | None) -> sp.Expr:
    """The coefficient that decides the sign of a rational function of ε as ε → 0 from above."""
    if epsilon is None or epsilon not in entry.free_symbols:
        return entry
    numerator, denominator = sp.fraction(sp.together(entry))
    lowest = [sp.Poly(part, epsilon).all_coeffs() for part in (numerator, denominator)]
    above, below = (next(c for c in reversed(listed) if c != 0) for listed in lowest)
    return sp.cancel(above / below)


def bilinear(coefficients: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """Return the coefficients of (w − 1)ⁿ p((w + 1)/(w − 1)), highest power first; the first is p(1).

    Roots of p inside the unit circle become roots w in the open left half plane, outside: in the right one.
    """
    n, w = len(coefficients) - 1, sp.Dummy("w")
    total = sp.Poly(0, w, domain=sp.ZZ)
    for i, c in enumerate(coefficients):
        power = sp.Poly((w + 1) ** (n - i) * (w - 1) ** i, w)
        total += power * c if c.is_Rational else sp.Poly(power.as_expr() * c, w)
    listed = [total.coeff_monomial(w**k) for k in range(n, -1, -1)]
    return tuple(sp.expand(c) for c in listed)


def routh_parts(coefficients: Sequence[sp.Expr]) -> list[tuple[tuple[sp.Expr, ...], int]]:
    """Return polynomials with multiplicities, p up to a constant, whose arrays each count their roots rightly.

    ε and a row of zeros in one array do not go together: ε moves the roots that lie symmetrically to the origin.
    Then the factor of these roots, g = gcd of the even and the odd part, is split off, and taken without repetition.
    """
    array = routh(coefficients)
    whole = [(tuple(coefficients), 1)]
    if array.epsilon is None:
        return whole
    K, (flat,) = (matrix := domain_matrix(sp.Matrix([list(coefficients)]))).domain, matrix.to_list()
    s, n = sp.Dummy("s"), len(flat) - 1
    p = sp.Poly(flat, s, domain=K)
    even, odd = (sp.Poly([c if (n - i) % 2 == r else K.zero for i, c in enumerate(flat)], s, domain=K) for r in (0, 1))
    g = even.gcd(odd)
    if g.degree() == 0:
        return whole
    rest = p.quo(g)
    parts = [(rest, 1)] if rest.degree() else []
    parts += g.sqf_list()[1]
    return [(tuple(expression(K, K.convert(c)) for c in part.rep.to_list()), m) for part, m in parts]
