"""Signs, how often they change, Routh arrays, where eigenvalues lie."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Check, CheckStatus, Claim
from solver.lazy import numeric
from solver.postconditions.linear_algebra import of_spectrum, root_claim
from solver.stated.algebra import product, total
from solver.stated.complex_numbers import absolute, real_part

TINY = sp.Rational(1, 10**30)
"""Stands for an ε that goes to zero."""


def of_sign_of(found: int | None, x: Any) -> Iterator[Claim | Check]:
    """x is its sign times its absolute value; nothing is said of a sign that is not known."""
    if found is not None:
        yield from _has_sign(x, found)


def _has_sign(x: Any, sign: int) -> Iterator[Claim | Check]:
    if isinstance(x, sp.Rational):
        yield Check.that("a sign", "compared", bool(sp.sign(x) == sign))
        return
    yield Claim(product(sp.Integer(sign), absolute(x)), x)
    if sign:
        is_zero = numeric.check_claim(Claim(x, sp.Integer(0)), "").status is CheckStatus.PASSED
        yield Check.that("a sign", "random points", abs(sign) == 1 and not is_zero)


def of_root_conditions(found: Sequence[Any], listed: Sequence[Any], *, discrete: bool) -> Iterator[Claim]:
    """Of one or two roots: the coefficients; in discrete time p(1), ±p(−1) and a₀ − a₂."""
    if len(listed) > 3:
        return
    a, b, c = [*listed, sp.Integer(0)][:3]
    wanted = [a + b + c, a - b + c, a - c] if discrete else [b, c]
    if len(listed) == 2:
        wanted = wanted[:-1]
    yield Claim(sp.ImmutableMatrix([wanted]), sp.ImmutableMatrix([list(found)]))


def of_hurwitz_matrix(found: Any, coefficients: Sequence[Any]) -> Iterator[Claim]:
    """The odd coefficients a₁, a₃, … above the even ones a₀, a₂, …, and the same two rows again, moved to the right."""
    n = len(coefficients) - 1
    rows = [[0] * (i // 2) + list(coefficients[1 - i % 2 :: 2]) + [0] * n for i in range(n)]
    yield Claim(sp.ImmutableMatrix([row[:n] for row in rows]), found)


def of_sign_changes(found: int, signs: Sequence[int | None]) -> Iterator[Check]:
    """So many signs differ from the one before."""
    yield Check.that("changes of sign", "counted", sum(a != b for a, b in pairwise(signs)) == found)


def of_routh(found: Any, polynomial: Any) -> Iterator[Claim | Check]:
    """The coefficients in two rows, each further row by its determinants; ε and auxiliary polynomials."""
    given = polynomial.all_coeffs() if isinstance(polynomial, sp.Poly) else list(polynomial)
    rows, n = found.rows, len(given) - 1
    width = n // 2 + 1
    yield Check.that("the rows of a Routh array", "counted", [row.power for row in rows] == list(range(n, -1, -1)))
    yield Claim(sp.ImmutableMatrix([given]), sp.ImmutableMatrix([found.coefficients]))
    yield Claim(sp.ImmutableMatrix([_filled(row.entries, width) for row in rows]), found.matrix)
    yield Claim(sp.ImmutableMatrix([[row.entries[0] for row in rows]]), sp.ImmutableMatrix([found.first_column]))
    computed = [
        _filled(given[i::2], width) if i < 2 else _crossed(rows[i - 2], rows[i - 1], width) for i in range(len(rows))
    ]
    yield Claim(sp.ImmutableMatrix(computed), sp.ImmutableMatrix([_filled(row.computed, width) for row in rows]))
    for i, row in enumerate(rows):
        if row.special:
            yield from _replaced(row, rows[i - 1].entries if i else (), width, found.epsilon)
        else:
            yield Check.that("the rows of a Routh array", "compared", row.entries == row.computed)
    for value, row in zip(found.at_zero, rows, strict=True):
        yield from _limit(value, row.entries[0], found.epsilon)


def _crossed(above: Any, last: Any, width: int) -> list[Any]:
    """(r₁ a_{j+1} − a₁ r_{j+1})/r₁ for the entries a, r of two rows."""
    a, r = (_filled(row.entries, width + 1) for row in (above, last))
    return [(r[0] * a[j + 1] - a[0] * r[j + 1]) / r[0] for j in range(width)]


def _replaced(row: Any, above: Any, width: int, epsilon: Any) -> Iterator[Claim]:
    """ε in place of a zero pivot, a derivative in place of a row of zeros."""
    own, computed = (sp.ImmutableMatrix([_filled(each, width)]) for each in (row.entries, row.computed))
    if row.special == "zeros":
        order, filled = row.power + 1, _filled(above, width)
        yield Claim(sp.ImmutableMatrix([_filled(row.auxiliary, width)]), sp.ImmutableMatrix([filled]))
        slopes = [(order - 2 * i) * c for i, c in enumerate(filled) if order > 2 * i]
        yield Claim(sp.ImmutableMatrix([_filled(slopes, width)]), own)
        yield Claim(computed, sp.ImmutableMatrix(sp.zeros(1, width)))
    else:
        yield Claim(computed[0], sp.Integer(0))
        yield Claim(sp.ImmutableMatrix([[epsilon, *computed[1:]]]), own)


def _limit(value: Any, entry: Any, epsilon: Any) -> Iterator[Claim | Check]:
    """What decides the sign of an entry as ε goes to zero has its sign for a tiny ε."""
    if epsilon is None or epsilon not in entry.free_symbols:
        if entry != value:
            yield Claim(entry, value)
        return
    there = entry.xreplace({epsilon: TINY})
    if not there.free_symbols:
        yield Check.that("signs for small ε", "sympy.N", sp.sign(sp.N(there, 60)) == sp.sign(sp.N(value, 60)))


def _filled(entries: Sequence[Any], width: int) -> list[Any]:
    return [*entries, *[sp.Integer(0)] * (width - len(entries))][:width]


def of_location(found: Any, A: Any, *, discrete: bool) -> Iterator[Claim | Check]:
    """The eigenvalues, Re λ or |λ| of each, and on which side it is."""
    yield from of_spectrum(found.spectrum, A)
    pairs = [(each.root.value, each.root.multiplicity) for each in found.placed]
    yield Claim(
        sp.ImmutableMatrix(pairs), sp.ImmutableMatrix([(r.value, r.multiplicity) for r in found.spectrum.roots])
    )
    for each in found.placed:
        yield root_claim(each.root)
        value = each.root.value
        measure = absolute(value) if discrete else real_part(value)
        if each.measure is not None:
            yield Claim(measure, each.measure)
        if each.position is not None:
            excess = total(measure, sp.Integer(-1)) if discrete else measure
            yield from _has_sign(excess, each.position)


def of_is_stable_polynomial(found: bool | None, coefficients: Sequence[Any], *, discrete: bool) -> Iterator[Check]:
    """All roots inside, where the coefficients are numbers."""
    if found is None or any(getattr(c, "free_symbols", None) for c in coefficients):
        return
    roots = np.roots([float(sp.N(c)) for c in coefficients])
    sizes = abs(roots) - 1 if discrete else roots.real
    says = "all roots inside" if found else "a root that is not inside"
    near = bool(np.any(abs(sizes) < 1e-6))
    yield Check.that(says, "numpy.roots", near or bool(np.all(sizes < 0)) == bool(found))


def of_edges(found: Sequence[tuple[Any, Any]], condition: Any) -> Iterator[Check]:
    """Each is a parameter and a value without it for which both sides of a strict inequality are equal."""
    strict = [each.lhs - each.rhs for each in condition.atoms(sp.StrictLessThan, sp.StrictGreaterThan)]
    equal = (x not in bound.free_symbols and _vanishes(strict, x, bound) for x, bound in found)
    yield Check.that("ends of a range", "compared", all(equal))


def _vanishes(values: Sequence[Any], x: Any, bound: Any) -> bool:
    """Whether one of the values is zero where x has this value."""
    return any(sp.expand(value.xreplace({x: bound})) == 0 for value in values)


WHOLE = (3, 1, 7, 2, 5, 4)
"""Numbers that parameters take, in turns."""
NEAR = 1e-6


def of_boundary_roots(found: Sequence[Any], coefficients: Sequence[Any], *, discrete: bool) -> Iterator[Check]:
    """They are those simple roots on the boundary, of a pair the upper one, that numpy finds for some parameters.

    Where ω² is negative for these, a root lies elsewhere and is not compared; nor are values of parameters for which
    roots meet, unless they do for all.
    """
    listed: list[sp.Expr] = [sp.Integer(0) + c for c in coefficients]
    symbols = sorted(set().union(*(c.free_symbols for c in listed)), key=str)
    points = [
        {x: sp.Integer(WHOLE[(turn + i) % len(WHOLE)]) for i, x in enumerate(symbols)}
        for turn in range(len(WHOLE) if symbols else 1)
    ]
    spectra = [[complex(z) for z in np.roots([complex(c.xreplace(point)) for c in listed])] for point in points]
    apart = [all(_is_simple(z, roots) for z in roots) for roots in spectra]
    for point, roots, is_apart in zip(points, spectra, apart, strict=True):
        if is_apart or not any(apart):
            seen = [z for z in roots if _is_told(z, roots, discrete=discrete)]
            named = [complex(root.xreplace(point)) for root in found]
            compared = [z for z in named if abs(abs(z) - 1 if discrete else z.real) < _near(z)]
            holds = all(_is_among(z, seen) for z in compared) and all(_is_among(z, named) for z in seen)
            yield Check.that("roots on the boundary", "numpy.roots", holds)


def of_off_the_point_one(found: Any, listed: Sequence[Any]) -> Iterator[Claim | Check]:
    """The quotient times the factors z − 1 is the polynomial, and 1 is no root of it any more."""
    z, (rest, count) = sp.Symbol("z"), found
    p, q = (sum((c * z ** (len(each) - 1 - i) for i, c in enumerate(each)), sp.S.Zero) for each in (listed, rest))
    yield Claim(p, product(q, (z - 1) ** count))
    yield Check.that("no root at one is left", "sympy", len(rest) == 1 or sp.expand(sum(rest)) != 0)


def _near(z: complex) -> float:
    """How far off a root of this size may be."""
    return NEAR * max(1.0, abs(z))


def _is_simple(z: complex, roots: Sequence[complex]) -> bool:
    return sum(abs(z - each) < 100 * _near(z) for each in roots) == 1


def _is_among(z: complex, others: Sequence[complex]) -> bool:
    return any(abs(z - each) < _near(z) for each in others)


def _is_told(z: complex, roots: Sequence[complex], *, discrete: bool) -> bool:
    """Whether a root is simple, on the boundary, not below the real axis, and has a square root as formula."""
    simple = _is_simple(z, roots)
    if discrete:
        return simple and abs(abs(z) - 1) < NEAR and (abs(z.imag) < NEAR or (len(roots) == 2 and z.imag > 0))
    square = abs(z) ** 2
    rational = abs(square - float(Fraction(square).limit_denominator(100))) < max(NEAR / 1000, 1e-13 * square)
    return simple and abs(z.real) < _near(z) and z.imag > -_near(z) and rational
