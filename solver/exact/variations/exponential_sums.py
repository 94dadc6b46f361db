"""Sums of c tᵏ e^{X} cos Y and c tᵏ e^{X} sin Y, with X and Y linear in the times: a ring in which zero is seen.

Products of cosines and sines are written as sums, so that the functions of a sum are independent and a sum is zero
exactly when all its coefficients are. cosh and sinh are read as exponentials.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache, reduce
from typing import Any, NamedTuple

import sympy as sp

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.fields import NotExact

DIGITS = 50
"""Digits with which a number of nested roots is tried, and below which it is zero."""


class Mode(NamedTuple):
    """monomial · e^{exponent} · cos(angle), with the sine instead where `odd`."""

    monomial: sp.Expr
    exponent: sp.Expr
    angle: sp.Expr
    odd: bool

    @property
    def expression(self) -> sp.Expr:
        """The function itself."""
        wave = sp.sin(self.angle) if self.odd else sp.cos(self.angle)
        return sp.Mul(self.monomial, sp.exp(self.exponent), wave)


ONE = Mode(sp.S.One, sp.S.Zero, sp.S.Zero, False)


@dataclass(frozen=True)
class ExponentialSum:
    """Modes with their coefficients, which are not zero."""

    terms: tuple[tuple[Mode, sp.Expr], ...]

    @staticmethod
    def of(terms: Iterable[tuple[Mode, sp.Expr]]) -> ExponentialSum:
        """Return the sum of the terms, each as it is multiplied out."""
        found: dict[Mode, list[sp.Expr]] = {}
        for mode, c in terms:
            found.setdefault(mode, []).append(c)
        summed = ((mode, tidied(sp.Add(*parts))) for mode, parts in found.items())
        return ExponentialSum(tuple((mode, c) for mode, c in summed if c != 0))

    @staticmethod
    def constant(value: sp.Expr) -> ExponentialSum:
        """Return a number, or an expression without times."""
        return ExponentialSum(((ONE, value),) if value != 0 else ())

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __add__(self, other: ExponentialSum) -> ExponentialSum:
        if not self or not other:
            return self or other
        return ExponentialSum.of((*self.terms, *other.terms))

    def __sub__(self, other: ExponentialSum) -> ExponentialSum:
        return self + other.times(sp.S.NegativeOne)

    def __mul__(self, other: ExponentialSum) -> ExponentialSum:
        if not self or not other:
            return NOTHING
        pairs = ((a, b) for a in self.terms for b in other.terms)
        return ExponentialSum.of(term for (m, c), (n, d) in pairs for term in _multiplied(m, n, c * d))

    def times(self, factor: sp.Expr) -> ExponentialSum:
        """Return the multiple by a number, or by an expression without times."""
        if factor == 1:
            return self
        return ExponentialSum.of((mode, c * factor) for mode, c in self.terms)

    def shifted(self, exponent: sp.Expr) -> ExponentialSum:
        """Return e^{exponent} times the sum."""
        moved = ((mode._replace(exponent=sp.expand(mode.exponent + exponent)), c) for mode, c in self.terms)
        return ExponentialSum(tuple(moved))

    @property
    def expression(self) -> sp.Expr:
        """The sum with its exponentials."""
        return sp.Add(*(c * mode.expression for mode, c in self.terms))


NOTHING = ExponentialSum(())


def read(value: sp.Expr, times: Iterable[sp.Symbol]) -> ExponentialSum:
    """Return an expression as such a sum, powers of the times as monomials; raises NotExact for anything else."""
    known = frozenset(times)
    written = value.expand(power_base=False, power_exp=False, log=False, basic=False)
    return ExponentialSum.of(term for part in sp.Add.make_args(written) for term in _read(part, known))


def read_matrix(M: sp.MatrixBase, times: Iterable[sp.Symbol]) -> list[list[ExponentialSum]]:
    """Return the rows of a matrix of such expressions."""
    return [[read(M[i, j], times) for j in range(M.cols)] for i in range(M.rows)]


def _read(part: sp.Expr, times: frozenset[sp.Symbol]) -> Iterator[tuple[Mode, sp.Expr]]:
    """A product as modes with their coefficients."""
    constant, monomial, sums = sp.S.One, sp.S.One, [ExponentialSum(((ONE, sp.S.One),))]
    parts: tuple[Any, ...] = sp.Mul.make_args(part)
    for factor in parts:
        base, count = factor, 1
        if factor.is_Pow and factor.exp.is_Integer and factor.exp > 0 and not isinstance(factor, sp.exp):
            base, count = factor.base, int(factor.exp)
        if base in times:
            monomial *= factor
        elif (found := _function(base)) is not None:
            sums += [found] * count
        elif base.has(*times) if times else False:
            raise NotExact("functions/form_of_the_power")
        else:
            constant *= factor
    for mode, c in reduce(lambda a, b: a * b, sums).terms:
        yield mode._replace(monomial=mode.monomial * monomial), c * constant


def _function(base: Any) -> ExponentialSum | None:
    """An exponential, a wave or a hyperbolic function; None for anything else."""
    if isinstance(base, sp.exp):
        return ExponentialSum(((ONE._replace(exponent=sp.expand(base.args[0])), sp.S.One),))
    if base is sp.E:
        return ExponentialSum(((ONE._replace(exponent=sp.S.One), sp.S.One),))
    if isinstance(base, sp.sin | sp.cos):
        return ExponentialSum.of([_wave(sp.expand(base.args[0]), odd=isinstance(base, sp.sin))])
    if isinstance(base, sp.cosh | sp.sinh):
        x, sign = sp.expand(base.args[0]), 1 if isinstance(base, sp.cosh) else -1
        half = sp.Rational(1, 2)
        return ExponentialSum.of([(ONE._replace(exponent=x), half), (ONE._replace(exponent=-x), sign * half)])
    return None


def _wave(angle: sp.Expr, *, odd: bool) -> tuple[Mode, sp.Expr]:
    """cos or sin of an angle, which is written without a minus before it."""
    if angle == 0:
        return ONE, sp.S.Zero if odd else sp.S.One
    turned = angle.could_extract_minus_sign()
    return ONE._replace(angle=-angle if turned else angle, odd=odd), sp.Integer(-1 if turned and odd else 1)


def _multiplied(a: Mode, b: Mode, c: sp.Expr) -> Iterator[tuple[Mode, sp.Expr]]:
    """c times the product of two modes, by the addition theorems."""
    monomial, exponent = a.monomial * b.monomial, _added(a.exponent, b.exponent)
    if a.angle == 0 or b.angle == 0:
        wave = a if b.angle == 0 else b
        yield Mode(monomial, exponent, wave.angle, wave.odd), c
        return
    plus, minus = _added(a.angle, b.angle), _added(a.angle, -b.angle)
    both, mixed = a.odd and b.odd, a.odd != b.odd
    half = c / 2
    for angle, weight in ((plus, -half if both else half), (minus, -half if b.odd and mixed else half)):
        mode, sign = _wave(angle, odd=mixed)
        if sign:
            yield mode._replace(monomial=monomial, exponent=exponent), weight * sign


@lru_cache(maxsize=4096)
def _added(a: sp.Expr, b: sp.Expr) -> sp.Expr:
    return sp.expand(a + b)


def tidied(c: sp.Expr) -> sp.Expr:
    """A coefficient multiplied out, zero where it is."""
    if c.is_Rational:
        return c
    c = tidy(c)
    if c.free_symbols or c.is_Rational:
        return c
    nested = any(power.base.has(sp.Pow) for power in c.atoms(sp.Pow))
    small = sp.Float(10) ** (-25 if c.has(sp.Float) else 5 - DIGITS)
    return sp.S.Zero if (nested or c.has(sp.Float)) and abs(c.evalf(DIGITS)) < small else c


Rows = list[list[ExponentialSum]]


def multiplied(left: Rows, right: Rows) -> Rows:
    """The product of two matrices of sums."""
    return [
        [
            reduce(lambda a, b: a + b, (left[i][k] * right[k][j] for k in range(len(right))))
            for j in range(len(right[0]))
        ]
        for i in range(len(left))
    ]


def determinant_and_adjugate(M: Rows) -> tuple[ExponentialSum, Rows]:
    """det M and adj M of a square matrix of sums, by minors, each computed once."""
    n = len(M)
    minor = _Minors(M)
    everything = tuple(range(n))
    adjugate = [
        [
            minor(tuple(r for r in everything if r != j), tuple(c for c in everything if c != i)).times(
                sp.Integer((-1) ** (i + j))
            )
            for j in range(n)
        ]
        for i in range(n)
    ]
    return minor(everything, everything), adjugate


class _Minors:
    """The minors of a matrix of sums by their rows and columns, expanded along the first row."""

    def __init__(self, M: Rows) -> None:
        self.M = M
        self.known: dict[tuple[tuple[int, ...], tuple[int, ...]], ExponentialSum] = {}

    def __call__(self, rows: tuple[int, ...], columns: tuple[int, ...]) -> ExponentialSum:
        if not rows:
            return ExponentialSum.constant(sp.S.One)
        if (rows, columns) not in self.known:
            found = NOTHING
            for at, j in enumerate(columns):
                entry = self.M[rows[0]][j]
                if entry:
                    rest = self(rows[1:], columns[:at] + columns[at + 1 :])
                    found = found + (entry * rest).times(sp.Integer((-1) ** at))
            self.known[rows, columns] = found
        return self.known[rows, columns]
