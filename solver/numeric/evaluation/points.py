"""Random points at which equalities are tried: always the same ones, and admissible for each symbol."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from functools import lru_cache
from random import Random
from typing import Any

import sympy as sp
from sympy.functions.special.tensor_functions import KroneckerDelta
from sympy.matrices.matrixbase import MatrixBase

from solver.conditions import conditions_of
from solver.matrices import entries
from solver.numeric.evaluation.inside import Inside
from solver.stated import Stated, operation_named
from solver.symbols import COMPLEX, CONTINUOUS

SEED = 20_011  # any constant will do
WHOLE_ARGUMENTS = (sp.factorial, sp.binomial, KroneckerDelta)
BINDS_NOTHING = frozenset({sp.Add, sp.Mul, sp.Pow, sp.Tuple, sp.ImmutableDenseMatrix, sp.exp, sp.sin, sp.cos})

_typed: ContextVar[bool] = ContextVar("typed", default=False)
MANY_BITS = 150
"""Decimals of more bits are what an oracle has found with many digits."""


def free_symbols(formula: Any) -> frozenset[Any]:
    """Return the symbols whose values the formula needs."""
    if isinstance(formula, Stated):
        return _symbols_of_stated(formula)
    if isinstance(formula, sp.Basic):
        return _symbols_in(formula)  # an immutable matrix too
    if isinstance(formula, MatrixBase):
        return frozenset().union(*map(_symbols_in, entries(formula)))
    if isinstance(formula, list | tuple):
        return frozenset().union(*map(free_symbols, formula))
    return frozenset()


def _symbols_of_stated(formula: Stated) -> frozenset[Any]:
    """Return the free symbols of the operands; what the operation binds is none where it binds it."""
    binding, operands = operation_named(formula.operation).binding, formula.operands
    if binding is None:
        return frozenset().union(*map(free_symbols, operands))
    bound = operands[binding.variable]
    inside = frozenset().union(*(free_symbols(operands[i]) for i in binding.within))
    others = (each for i, each in enumerate(operands) if i != binding.variable and i not in binding.within)
    return (inside - {bound}).union(*map(free_symbols, others))


def _symbols_in(expression: sp.Basic) -> frozenset[Any]:
    return _made_of(expression)[0]


@lru_cache(maxsize=4096)
def _made_of(expression: sp.Basic) -> tuple[frozenset[Any], bool]:
    """Return the free symbols, and whether there are decimals of fewer bits than an oracle's own."""
    symbols, decimals = set[Any](), False
    left: list[Any] = [expression]
    seen = set[int]()
    while left:
        part = left.pop()
        if id(part) in seen:  # expressions share what they are made of
            continue
        seen.add(id(part))
        if type(part) in BINDS_NOTHING:
            left.extend(part.args)
        elif isinstance(part, sp.Float):
            decimals = decimals or part._prec < MANY_BITS
        elif not part.is_Number:
            symbols |= part.free_symbols
            decimals = decimals or any(each._prec < MANY_BITS for each in part.atoms(sp.Float))
    return frozenset(symbols), decimals


@contextmanager
def typed_decimals(typed: bool) -> Iterator[None]:
    """While this lasts rational numbers may be decimals that someone typed, so that nothing is taken as exact."""
    before = _typed.set(typed)
    try:
        yield
    finally:
        _typed.reset(before)


def holds_decimals(formula: Any) -> bool:
    """Whether a formula or a value holds decimals, or may hold typed ones."""
    return _typed.get() or _has_decimals(formula)


def _has_decimals(formula: Any) -> bool:
    if isinstance(formula, sp.Basic):
        return _made_of(formula)[1]
    parts: Iterable[Any] = ()
    if isinstance(formula, Stated):
        parts = formula.operands
    elif isinstance(formula, MatrixBase):
        parts = entries(formula)
    elif isinstance(formula, dict):
        parts = formula.values()
    elif isinstance(formula, list | tuple):
        parts = formula
    return isinstance(formula, float | complex) or any(map(_has_decimals, parts))


def whole_symbols(*formulas: Any, names: Collection[str] = (), symbols: frozenset[Any] | None = None) -> frozenset[Any]:
    """Return the symbols that take whole numbers: by assumption, by name, or by the place where they stand.

    Such places are the k of an inverse z-transform, the arguments of Kronecker's delta and of factorials, and the
    exponent of a base that is not known to be positive (λᵏ; a parameter k in e^{kt} is none). `symbols` are those of
    the formulas, if they are known already.
    """
    if symbols is None:
        symbols = frozenset().union(*map(free_symbols, formulas))
    found = {symbol for symbol in symbols if symbol.is_integer or symbol.name in names}
    if all(symbol.name in CONTINUOUS for symbol in symbols - found):
        return frozenset(found)
    for formula in formulas:
        for node in nodes(formula):
            found |= _whole_in(node)
    return frozenset(found)


def _whole_in(node: Any) -> set[Any]:
    if isinstance(node, Stated):
        whole = operation_named(node.operation).whole
        if whole:
            return set(free_symbols([node.operands[i] for i in whole]))
        if node.operation == "power" and isinstance(node.operands[0], MatrixBase):
            return set(free_symbols(node.operands[1]))
        return set()
    if isinstance(node, WHOLE_ARGUMENTS):
        return set(node.free_symbols)
    if isinstance(node, sp.Pow) and not node.base.is_positive and isinstance(node.exp, sp.Symbol | sp.Add):
        return {symbol for symbol in free_symbols(node.exp) if symbol.name == "k"}
    return set()


def nodes(formula: Any) -> Iterable[Any]:
    """Return the formula and everything in it: stated formulas, expressions and their arguments."""
    yield formula
    if isinstance(formula, Stated):
        parts: Iterable[Any] = formula.operands
    elif isinstance(formula, MatrixBase):
        parts = entries(formula)
    elif isinstance(formula, sp.Basic):
        parts = formula.args
    else:
        parts = formula if isinstance(formula, list | tuple) else ()
    for part in parts:
        yield from nodes(part)


def taken_as_positive(symbols: Collection[Any]) -> dict[Any, Any]:
    """The symbols of undecided sign of which there is a positive one by the same name (a weight): they are the same."""
    positive = {symbol.name: symbol for symbol in symbols if symbol.is_positive and symbol.is_Symbol}
    return {
        symbol: positive[symbol.name]
        for symbol in symbols
        if symbol.is_positive is None and symbol.name in positive and not symbol.is_Dummy
    }


class PointSource:
    """Draws points: a value for every symbol, respecting what is assumed of it. The same sequence in every run."""

    def __init__(self, symbols: Iterable[Any], whole: Collection[Any] = frozenset()) -> None:
        self.symbols = sorted(symbols, key=lambda symbol: (symbol.name, str(symbol.assumptions0)))
        self.whole = whole
        self.random = Random(SEED)  # noqa: S311 - nothing secret
        self.drawn = 0
        self.inside = Inside(self.symbols, self.random) if conditions_of(self.symbols) else None
        self.taken = taken_as_positive(self.symbols)

    def draw(self) -> dict[Any, complex]:
        """Return the next point; raises NotEvaluable where no values are found that satisfy the conditions."""
        values = self.inside.point(self._value) if self.inside else {}
        point = {symbol: values[symbol] if symbol in values else self._value(symbol) for symbol in self.symbols}
        self.drawn += 1
        return point | {plain: point[positive] for plain, positive in self.taken.items()}

    def several(self, count: int) -> list[dict[Any, complex]]:
        """Return the next points."""
        return [self.draw() for _ in range(count)]

    def _value(self, symbol: Any) -> complex:
        if symbol in self.whole:
            return self._whole_number(symbol)
        if symbol.name == "t" and not symbol.is_negative:
            return self.random.uniform(0.1, 1.5)
        size, sign = self.random.uniform(0.3, 2.5), self.random.choice((-1, 1))
        if symbol.is_nonnegative or symbol.is_nonpositive:
            return size if symbol.is_nonnegative else -size
        if symbol.is_imaginary:
            return 1j * size
        if symbol.is_real is None and (symbol.is_complex or symbol.name in COMPLEX):
            return complex(self.random.uniform(-2.5, 2.5), sign * size)
        return size * sign

    def _whole_number(self, symbol: Any) -> int:
        """0, 1, then any up to 6 (small numbers are where δ(k) and nilpotent blocks show)."""
        if symbol.is_negative:
            return -self.random.randint(1, 6)
        number = self.drawn if self.drawn < 2 else self.random.randint(2, 6)
        return max(number, 1) if symbol.is_positive or symbol.is_zero is False else number


@lru_cache(maxsize=256)
def first_points(symbols: frozenset[Any], whole: frozenset[Any], count: int) -> tuple[dict[Any, complex], ...]:
    """Return the first points of a source for these symbols; they must not be changed."""
    return tuple(PointSource(symbols, whole).several(count))


def admissible(symbols: Iterable[Any], count: int) -> list[Mapping[Any, complex]]:
    """Return some points for parameters of a matrix; one point if there are none."""
    symbols = list(symbols)
    return list(PointSource(symbols).several(count if symbols else 1))
