"""Where the eigenvalues lie: inside the region of stability, on its boundary or outside. Decided by numbers.

numpy decides, on the matrix as it is or balanced, where rounding could not have moved an eigenvalue across (Bauer and
Fike's bound); else mpmath does, by discs around them; and where one reaches the boundary, with so many digits that a
cluster of computed eigenvalues is one multiple eigenvalue (Kato, Perturbation Theory, II §2.1).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from random import Random
from typing import Any, NamedTuple

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.inside import admits
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols, holds_decimals
from solver.numeric.evaluation.values import SAFETY, NotEvaluable, Undefined, filled
from solver.numeric.judges.stability.discs import ON_THE_BOUNDARY, characteristic_coefficients, excess_of_discs
from solver.words import Phrase

STABLE, MARGINAL, UNSTABLE = "asymptotically stable", "marginally stable", "unstable"
POINTS = 16
Point = Mapping[Any, complex]


class Location(NamedTuple):
    """How many eigenvalues are inside, on the boundary, outside; whether those on it have no chains."""

    inside: int
    on: int
    outside: int
    semisimple: bool

    @property
    def verdict(self) -> str:
        """The verdict on the free motion."""
        if self.outside or not self.semisimple:
            return UNSTABLE
        return MARGINAL if self.on else STABLE


def locations(A: Any, *, discrete: bool) -> list[Location]:
    """Return where the eigenvalues lie at several values of the parameters. Raises NotEvaluable if at none."""
    return [located(A, point, discrete=discrete) for point in spread_points([A])]


def spread_points(formulas: Sequence[Any], count: int = POINTS) -> list[Point]:
    """Return values of all parameters, of many sizes, at which all formulas have values; one if there are none."""
    symbols = free_symbols(list(formulas))
    source, random = PointSource(symbols), Random(SEED)  # noqa: S311 - nothing secret
    found: list[Point] = []
    for _ in range(4 * count if symbols else 1):
        drawn = source.draw()
        spread = {s: v if s.is_integer else v * 10.0 ** random.uniform(-1.5, 1.5) for s, v in drawn.items()}
        point = spread if admits(spread) else drawn
        if all(_is_defined(formula, point) for formula in formulas):
            found.append(point)
        if len(found) == count:
            break
    if not found:
        raise NotEvaluable("no values of the parameters were found at which the system is defined")
    return found


def _is_defined(formula: Any, point: Point) -> bool:
    try:
        value_of(formula, Environment.at([dict(point)]))
    except Undefined:
        return False
    return True


def located(A: Any, point: Point, *, discrete: bool) -> Location:
    """Return where the eigenvalues of A (n×n) lie at a point, with as many digits as it takes."""
    excess = certain_excess(A, point, discrete=discrete)
    if excess is None:
        excess = excess_of_discs(A, point, discrete=discrete)
    if excess is not None:
        outside = int(np.sum(excess > 0))
        return Location(len(excess) - outside, 0, outside, True)
    return _with_many_digits(A, point, discrete=discrete)


def certain_excess(A: Any, point: Point, *, discrete: bool) -> Array | None:
    """Return Re λ (discrete: |λ| − 1) of the eigenvalues if rounding can't have changed a sign, else None."""
    M, sizes = (part[0] for part in filled(value_of(A, Environment.at([dict(point)])), 1))
    if not np.all(np.isfinite(M)):
        return None
    excess = _excess(M, sizes, discrete=discrete)
    if excess is not None:
        return excess
    from scipy.linalg import matrix_balance  # noqa: PLC0415 - 150 ms that most checks do not need

    balanced, (scale, _) = matrix_balance(M, permute=False, separate=True)  # by powers of two, so exactly
    return _excess(balanced, sizes * scale[None, :] / scale[:, None], discrete=discrete)


def _excess(M: Array, sizes: Array, *, discrete: bool) -> Array | None:
    """Return them by Bauer and Fike's bound; `sizes` are the magnitudes of the entries of M."""
    values, vectors = np.linalg.eig(M)
    excess = np.asarray(np.abs(values) - 1.0 if discrete else values.real)
    with np.errstate(all="ignore"):
        rounding = 2.0**-52 * float(1e3 * len(M) * np.linalg.norm(M) + SAFETY * np.linalg.norm(sizes))
        reach = rounding * float(np.linalg.cond(vectors))
    return excess if bool(np.all(np.abs(excess) > reach + 1e-12 * discrete)) else None


def _with_many_digits(A: Any, point: Point, *, discrete: bool) -> Location:
    counts, semisimple = [0, 0, 0], True
    for value, size, nullity, mp in clusters(A, point):
        excess = abs(value) - 1 if discrete else mp.re(value)
        near = abs(excess) <= ON_THE_BOUNDARY * max(1, abs(value))
        counts[1 if near else 0 if excess < 0 else 2] += size
        semisimple = semisimple and not (near and size > 1 and nullity() < size)
    return Location(counts[0], counts[1], counts[2], semisimple)


def clusters(A: Any, point: Point) -> tuple[tuple[Any, int, Any, Any], ...]:
    """Return each eigenvalue (its mean), its multiplicity, a function giving dim ker(A − λI), and the arithmetic."""
    return _clusters(sp.ImmutableMatrix(A), tuple(point.items()))


@lru_cache(maxsize=64)
def _clusters(A: Any, point: tuple[tuple[Any, complex], ...]) -> tuple[tuple[Any, int, Any, Any], ...]:
    """Return them; the checks of one part ask for the same ones."""
    n = A.rows
    arithmetic = multiple(max(100, 40 * n))
    mp = arithmetic.context
    matrix = mp.matrix(value_of(A, Environment.at([dict(point)], arithmetic)).value[0].tolist())
    scale = max(mp.mnorm(matrix), mp.mpf(1))
    values = list(mp.eig(matrix, left=False, right=False)) if n > 1 else [matrix[0, 0]]
    found = []
    while values:
        near = [value for value in values if abs(value - values[0]) <= mp.mpf(10) ** -20 * scale]
        values = [value for value in values if abs(value - values[0]) > mp.mpf(10) ** -20 * scale]
        mean = sum(near) / len(near)

        def nullity(mean: Any = mean) -> int:
            singular = mp.svd_c((matrix - mean * mp.eye(n)) / scale, compute_uv=False)
            return sum(1 for value in singular if value < mp.mpf(10) ** -25)

        found.append((mean, len(near), nullity, mp))
    return tuple(found)


def externally_stable(A: Any, B: Any, C: Any, point: Point, *, discrete: bool) -> bool:
    """Whether C (xI − A)⁻¹ B stays bounded near each eigenvalue that is not inside the region of stability."""
    n = A.rows
    inside = certain_excess(A, point, discrete=discrete)
    if inside is not None and np.all(inside < 0):
        return True
    for value, _, _, mp in clusters(A, point):
        excess = abs(value) - 1 if discrete else mp.re(value)
        if excess < -(mp.mpf(10) ** -30) * max(1, abs(value)):
            continue
        arithmetic = multiple(max(100, 40 * n))
        a, b, c = (
            mp.matrix(value_of(M, Environment.at([dict(point)], arithmetic)).value[0].tolist()) for M in (A, B, C)
        )
        sizes = [mp.mnorm(c * mp.inverse((value + mp.mpf(10) ** -e) * mp.eye(n) - a) * b) for e in (8, 16)]
        if sizes[1] > 1000 * sizes[0] and sizes[1] > mp.mpf(10) ** -15:
            return False
    return True


def routh_fault(A: Any, array: Any, *, discrete: bool, at_minus_one: bool = False) -> str:
    """Return what is wrong with a Routh array of det(sI − A) (discrete: after the bilinear transformation), or "".

    Each row must follow from the two above it, up to a positive factor, which for a row of one entry is the number
    that it is divided by. A symbol that is no parameter is a small ε. The transformation sends z = 1 to infinity, or
    z = −1 (`at_minus_one`).
    """
    for point in spread_points([A], 3):
        mp = multiple(60).context
        coefficients = _polynomial(A, point, discrete=discrete, at_minus_one=at_minus_one)
        n = len(coefficients) - 1
        if array.shape != (n + 1, n // 2 + 1):
            return Phrase("the array must have {rows} rows and {columns} columns", rows=n + 1, columns=n // 2 + 1)
        small = {symbol: mp.mpf(10) ** -12 for symbol in free_symbols(array) - free_symbols(A)}
        near = mp.mpf(10) ** (-6 if small else -9 if holds_decimals([A, array]) else -20)
        rows = value_of(array, Environment.at([{**point, **small}], multiple(60))).value[0].tolist()
        multiplied = rows[0][0] / coefficients[0]
        if mp.re(multiplied) > 0 and not mp.im(multiplied):  # the array of a positive multiple of the polynomial
            coefficients = [multiplied * c for c in coefficients]
        for i, row in enumerate(rows):
            wanted = _expected(rows, i, coefficients, mp)
            if not any(_proportional(row, each, mp, near) for each in wanted):
                return Phrase("row {row} does not follow from the rows above it", row=i + 1)
    return ""


def _polynomial(A: Any, point: Point, *, discrete: bool, at_minus_one: bool = False) -> list[Any]:
    """The coefficients of det(xI − A), highest power first, by traces; discrete: of its image, without roots at ±1."""
    mp, c = multiple(60).context, characteristic_coefficients(A, point, multiple(60))
    if not discrete:
        return c
    x = -1 if at_minus_one else 1
    while len(c) > 1 and abs(sum(a * x**i for i, a in enumerate(c))) < mp.mpf(10) ** -30 * sum(map(abs, c)):
        for i in range(1, len(c)):
            c[i] += x * c[i - 1]
        c.pop()
    return _image(c)[::-1] if at_minus_one else _image(c)


def _image(c: list[Any]) -> list[Any]:
    """The coefficients of (w − 1)ⁿ p((w + 1)/(w − 1)), highest power first."""
    n = len(c) - 1
    total = [0 * c[0]] * (n + 1)
    for i, coefficient in enumerate(c):
        power = np.poly1d([1])
        for _ in range(n - i):
            power = power * np.poly1d([1, 1])
        for _ in range(i):
            power = power * np.poly1d([1, -1])
        for j, whole in enumerate(power.coeffs):
            total[j] += round(float(whole)) * coefficient
    return total


def _expected(rows: list[list[Any]], i: int, coefficients: list[Any], mp: Any) -> list[list[Any]]:
    """The entries that row i may have: from the coefficients, from the rows above, or as a special case."""
    width, r = len(rows[0]), mp.mpf(1)
    if i < 2:
        row = coefficients[i::2]
        row += [mp.mpf(0)] * (width - len(row))
        above = rows[0]
    else:
        (above2, above), r = (rows[i - 2], rows[i - 1]), rows[i - 1][0]
        if r == 0:
            return []
        row = [(r * _at(above2, j + 1) - above2[0] * _at(above, j + 1)) / r for j in range(width)]
    size = max(map(abs, [*row, *above]), default=mp.mpf(1)) or mp.mpf(1)
    negligible = mp.mpf(10) ** -30 * size
    row = [mp.mpf(0) if abs(x) < negligible else x for x in row]
    if not any(row):
        power = len(rows) - i
        return [[(power - 2 * j) * _at(above, j) if power > 2 * j else mp.mpf(0) for j in range(width)]]
    if not row[0]:
        return [[mp.mpf(10) ** -12, *row[1:]]]
    undivided = i > 1 and not mp.im(r) and mp.re(r) > 0  # the row times the positive number that it is divided by
    return [row, [r * x for x in row]] if undivided else [row]


def _at(row: list[Any], j: int) -> Any:
    return row[j] if j < len(row) else 0 * row[0]


def _proportional(row: list[Any], wanted: list[Any], mp: Any, near: Any) -> bool:
    """Whether row = c · wanted with c > 0 (c = 1 if one entry is all), each entry relative to its own size."""
    if not wanted[0]:
        return False
    c = row[0] / wanted[0]
    if not (mp.re(c) > 0 and abs(mp.im(c)) < mp.mpf(10) ** -20 * abs(c)):
        return False
    if not any(wanted[1:]):  # one entry tells no factor from a mistake
        c = mp.mpf(1)
    return all(abs(x - c * y) <= near * max(abs(x), abs(c * y)) for x, y in zip(row, wanted, strict=True))


def planar_kind(A: Any, point: Point) -> str:
    """Return the kind of the phase portrait of x' = A x, n = 2, by the eigenvalues and dim ker(A − λI)."""
    groups = clusters(A, point)
    mp = groups[0][3]
    tiny = mp.mpf(10) ** -30 * max(1, *(abs(value) for value, *_ in groups))
    signs = [0 if abs(mp.re(value)) <= tiny else 1 if mp.re(value) > 0 else -1 for value, *_ in groups]
    speed = "stable" if signs[0] < 0 else "unstable"
    if len(groups) == 1:
        full = groups[0][2]() == 2
        if not signs[0]:
            return "all points are equilibria" if full else "shear"
        return f"{speed} star" if full else f"{speed} degenerate node"
    if abs(mp.im(groups[0][0])) > tiny:
        return f"{speed} focus" if signs[0] else "center"
    if 0 in signs:
        return "line of equilibria"
    return f"{speed} node" if signs[0] == signs[1] else "saddle"
