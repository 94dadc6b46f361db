"""Tables of polynomials in z, and where their roots lie."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Check, Claim

FURTHER = 3
"""From so many rows on they may be divided by something."""


def of_jury_table(found: Any, coefficients: Sequence[Any], *, whole: bool = False) -> Iterator[Claim | Check]:
    """The coefficients in rising order; each row times its divisor is the determinants of the row above it."""
    rows = [row.entries for row in found.rows]
    yield Claim(sp.ImmutableMatrix([list(coefficients)[::-1]]), sp.ImmutableMatrix([rows[0]]))
    least = min(len(rows[0]), 1 if whole else 3)
    lengths = [len(row) for row in rows]
    yield Check.that("the rows of a table", "counted", lengths == list(range(len(rows[0]), least - 1, -1)))
    for i, row in enumerate(found.rows[1:], 1):
        r, m = rows[i - 1], len(rows[i - 1]) - 1
        wanted = [r[0] * r[k] - r[m] * r[m - k] for k in range(m)]
        yield Claim(sp.ImmutableMatrix([wanted]), sp.ImmutableMatrix([[row.divisor * each for each in row.entries]]))
        if i < FURTHER:
            yield Claim(row.divisor, sp.Integer(1))
        elif not row.divisor.free_symbols:
            yield Check.that("a positive divisor", "sympy.N", bool(sp.N(row.divisor) > 0))


def of_jury_conditions(found: Any, coefficients: Sequence[Any]) -> Iterator[Claim | Check]:
    """p(1), (−1)ⁿ p(−1); of numbers all are positive exactly where all roots are inside."""
    n = len(coefficients) - 1
    yield Claim(sp.Add(*coefficients), found.at_one)
    yield Claim(sp.Add(*((-1) ** i * c for i, c in enumerate(coefficients))), found.at_minus_one)
    yield from _first_ends(found.ends, list(coefficients)[::-1])
    sizes = _sizes(coefficients)
    if sizes is not None and n and np.all(np.abs(sizes - 1) > _near(n)):
        positive = all(bool(sp.N(each, 30) > 0) for each in found.positive)
        yield Check.that("conditions for roots inside", "numpy.roots", positive == bool(np.all(sizes < 1)))


def _first_ends(ends: Any, a: list[Any]) -> Iterator[Claim]:
    """aₙ ∓ a₀, −b₀ ± bₘ, c₀ ∓ cₘ: of the rows that are divided by nothing."""
    rows = [a]
    while len(rows[-1]) > 1 and len(rows) < FURTHER:
        r, m = rows[-1], len(rows[-1]) - 1
        rows.append([r[0] * r[k] - r[m] * r[m - k] for k in range(m)])
    for i, (pair, row) in enumerate(zip(ends, rows, strict=False)):
        first, last = row[0], row[-1]
        wanted = [(last - first, last + first), (last - first, -first - last), (first - last, first + last)][i]
        yield Claim(sp.ImmutableMatrix([list(pair)]), sp.ImmutableMatrix([list(wanted[: len(pair)])]))


def of_inside_by_jury(found: int | None, table: Any) -> Iterator[Check]:
    """The roots of the first row, read in rising order, that lie inside the unit circle."""
    sizes = _sizes(table.rows[0].entries[::-1])
    if found is not None and sizes is not None and np.all(np.abs(sizes - 1) > _near(len(sizes))):
        yield Check.that("roots inside", "numpy.roots", found == int(np.sum(sizes < 1)))


def of_bilinear_image(found: Sequence[Any], coefficients: Sequence[Any]) -> Iterator[Claim]:
    """(1 − w)ⁿ p((1 + w)/(1 − w)) at n + 1 values of w."""
    n = len(coefficients) - 1
    for w in range(2, n + 3):
        left = sp.Add(*(c * (1 + w) ** (n - i) * (1 - w) ** i for i, c in enumerate(coefficients)))
        yield Claim(left, sp.Add(*(c * w ** (n - i) for i, c in enumerate(found))))


def of_disc_counts(found: Any, coefficients: Sequence[Any]) -> Iterator[Claim | Check]:
    """The image of what is left without roots at −1; how many roots are outside, where numbers tell."""
    z = sp.Symbol("z")
    p, rest = (_polynomial(each, z) for each in (coefficients, found.rest))
    yield Claim(sp.expand((z + 1) ** found.minus_ones * rest), p)
    if len(found.rest) > 1:
        yield from of_bilinear_image(found.image, found.rest)
    sizes = _sizes(found.rest)
    if found.counts is not None and sizes is not None and np.all(np.abs(sizes - 1) > _near(len(sizes))):
        holds = (found.outside, found.on) == (int(np.sum(sizes > 1)), found.minus_ones)
        yield Check.that("roots outside", "numpy.roots", holds)


def _polynomial(coefficients: Sequence[Any], z: Any) -> Any:
    n = len(coefficients) - 1
    return sp.Add(*(c * z ** (n - i) for i, c in enumerate(coefficients)))


def _sizes(coefficients: Sequence[Any]) -> Any:
    """The sizes of the roots; None with parameters."""
    if any(getattr(c, "free_symbols", None) for c in coefficients):
        return None
    values = [float(sp.N(c)) for c in coefficients]
    return np.abs(np.roots(values)) if len(values) > 1 else np.zeros(0)


def _near(n: int) -> float:
    """How near to the circle roots of n-fold multiplicity are not told from it in doubles."""
    return max(1e-6, 10.0 ** (-12 / max(n, 1)))


def of_integral_weights(found: tuple[Any, Any], rule: str, T: Any) -> Iterator[Claim]:
    """The weights are those of a strip of width T, taken as high as at its end, its beginning, or between."""
    share = {"backward": sp.Integer(1), "forward": sp.Integer(0), "tustin": sp.Rational(1, 2)}[rule]
    yield Claim(sp.ImmutableMatrix([list(found)]), sp.ImmutableMatrix([[share * T, (1 - share) * T]]))


def of_discrete_pid(found: Any, gains: Sequence[Any], T: Any, rule: str, z: Any) -> Iterator[Claim]:
    """The controller is the sum of its terms, and by its coefficients; the terms are those of the rule."""
    K_p, K_i, K_d = gains
    yield from of_integral_weights(found.weights, rule, T)
    new, old = found.weights
    yield Claim(found.integral, (new + old / z) / (1 - 1 / z))
    yield Claim(found.derivative, (1 - 1 / z) / T)
    yield Claim(K_p + K_i * found.integral + K_d * found.derivative, found.controller)
    yield Claim(sp.Add(*(q / z**i for i, q in enumerate(found.coefficients))) / (1 - 1 / z), found.controller)
