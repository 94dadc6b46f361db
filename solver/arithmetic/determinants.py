"""Determinants expanded as on paper: entries times minors, the minors worked out, the terms multiplied out."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact, unnoted_calls
from solver.lazy import sympy as sp
from solver.matrices import entries
from solver.stated.algebra import product, total
from solver.stated.matrices import determinant
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.stated import Stated

MOST_MINORS = 6
"""Of more minors of order three and above the values alone are shown."""


@where_exact
def expanded(M: ImmutableMatrix, value: Expr, x: Symbol | None = None) -> tuple[Step, ...]:
    """What is between `first_line(M)` and det M = value (in powers of x), which the step shows."""
    return tuple(_between(M, value, x))


@where_exact
def worked_out(name: str, M: ImmutableMatrix, value: Expr, x: Symbol | None = None) -> tuple[Step, ...]:
    """All of det M = value (in powers of x) where the step shows no more; `name` is what it calls the determinant."""
    return tuple(_worked_out(name, M, value, x))


@where_exact
def leading_minors(blocks: Sequence[ImmutableMatrix], values: Sequence[Expr]) -> tuple[Step, ...]:
    """The determinants Δₖ of leading blocks, of order one, two, …."""
    listed = enumerate(zip(blocks, values, strict=True), 1)
    return tuple(step for k, (M, value) in listed for step in worked_out(f"\\Delta_{{{k}}}", M, value))


def first_line(M: ImmutableMatrix) -> Stated:
    """det M as the product of a triangular matrix's diagonal, as ad − bc, or expanded along a row."""
    if is_simple(M):
        return _sum(_products(M))
    return total(*(product(a, determinant(minor)) for a, minor in along_row(M)))


def is_simple(M: ImmutableMatrix) -> bool:
    """Whether det M needs no minors."""
    return M.rows < 3 or is_triangular(M)


def is_triangular(M: ImmutableMatrix) -> bool:
    """Whether all entries on one side of the main diagonal are zero."""
    n = M.rows
    return any(all(M[i, j] == 0 for i in range(n) for j in range(n) if sign * i < sign * j) for sign in (1, -1))


def row_with_most_zeros(M: ImmutableMatrix) -> int:
    """Return the first of the rows with most zeros."""
    zeros = _zeros(M)
    return zeros.index(max(zeros))


def most_zeros_in_a_row(M: ImmutableMatrix) -> int:
    """Return how many zeros a row has at most."""
    return max(_zeros(M))


def _zeros(M: ImmutableMatrix) -> list[int]:
    """Return how many zeros each row has."""
    flat = entries(M)
    return [sum(entry == 0 for entry in flat[i * M.cols : (i + 1) * M.cols]) for i in range(M.rows)]


def along_row(M: ImmutableMatrix) -> list[tuple[Expr, ImmutableMatrix]]:
    """The entries of the row with most zeros with their signs, and their minors; without those of zeros."""
    i = row_with_most_zeros(M)
    return [
        (M[i, j] if (i + j) % 2 == 0 else -M[i, j], sp.ImmutableMatrix(M.minor_submatrix(i, j)))
        for j in range(M.cols)
        if M[i, j] != 0
    ]


def _products(M: ImmutableMatrix, x: Symbol | None = None) -> list[tuple[Any, ...]]:
    """The factors of the terms whose sum is det M, those that are zero left out; minors by their values."""
    if is_triangular(M):
        found: list[tuple[Any, ...]] = [tuple(M[i, i] for i in range(M.rows))]
    elif M.rows == 2:
        a, b, c, d = M.flat()
        found = [(a, d), (sp.S.NegativeOne, b, c)]
    else:
        found = [(a, _value(minor, x)) for a, minor in along_row(M)]
    return [factors for factors in found if 0 not in factors]


@lru_cache(maxsize=1024)
def _value(M: ImmutableMatrix, x: Symbol | None) -> Expr:
    with unnoted_calls():
        return exact.multiplied_out(exact.determinant(M), x)


def _sum(products: list[tuple[Any, ...]]) -> Stated:
    return total(*(product(*factors) for factors in products))


@lemma("arithmetic/determinants")
def _worked_out(name: str, M: ImmutableMatrix, value: Expr, x: Symbol | None) -> Derivation[None]:
    if not _is_work(M):
        return
    line, simple = first_line(M), is_simple(M)
    terms, merged = _terms(M, value, x)
    claims = {"stated": Claim(determinant(M), line, Phrase("the determinant multiplied out"))}
    if simple:
        claims["terms"] = Claim(line, terms if merged else value, Phrase("the terms multiplied out"))
        claims["value"] = Claim(line, value, Phrase("the determinant multiplied out"))
    row = 0 if simple else row_with_most_zeros(M) + 1
    yield Step("expansion", detail="tutor", claims=claims, name=name, row=row, merged=merged)
    if not simple:
        yield from _between(M, value, x)


@lemma("arithmetic/determinants")
def _between(M: ImmutableMatrix, value: Expr, x: Symbol | None) -> Derivation[None]:
    shown = yield from _minors(M, value, x)
    terms, merged = _terms(M, value, x)
    if merged or (_has_products(M) and not (shown or is_simple(M))):
        line = terms if merged else value
        yield Step(
            "terms",
            detail="tutor",
            claims={
                "terms": Claim(_sum(_products(M, x)), line, Phrase("the terms multiplied out")),
                "value": Claim(line, value, Phrase("the determinant multiplied out")),
            },
            merged=merged,
        )


def _terms(M: ImmutableMatrix, value: Expr, x: Symbol | None) -> tuple[Stated, bool]:
    """The terms of det M multiplied out, each for itself; and whether terms of like powers are put together then."""
    terms = [exact.multiplied_out(sp.Mul(*factors), x) for factors in _products(M, x)]
    merged = sum(len(sp.Add.make_args(term)) for term in terms) > len(sp.Add.make_args(value))
    return total(*terms), merged


def _minors(M: ImmutableMatrix, value: Expr, x: Symbol | None) -> Derivation[bool]:
    """Work out the minors, those of order two on one line; return whether there was anything to work out."""
    if is_simple(M):
        return False
    minors = [minor for _, minor in along_row(M)]
    hard = [minor for minor in minors if _is_work(minor)]
    if not hard:
        return False
    if M.rows > 3 and _count(M) <= MOST_MINORS:
        for minor in hard:
            yield from _minor(minor, x)
        return True
    line = _written(M) if M.rows == 3 else first_line(M)
    valued = _sum(_products(M, x))
    claims = {
        "minors": Claim(line, valued, Phrase("minors of the expansion")),
        "value": Claim(valued, value, Phrase("the determinant multiplied out")),
    }
    yield Step("minors", detail="tutor", claims=claims, n=M.rows)
    return True


def _minor(M: ImmutableMatrix, x: Symbol | None) -> Derivation[None]:
    """A minor of order three on one line, a larger one as the determinant that it is."""
    value = _value(M, x)
    line = first_line(M) if is_simple(M) or M.rows > 3 else _written(M)
    claims = {
        "stated": Claim(determinant(M), line, Phrase("a minor expanded")),
        "value": Claim(line, value, Phrase("a minor expanded")),
    }
    yield Step("minor", detail="tutor", claims=claims)
    if M.rows > 3:
        yield from _between(M, value, x)


def _written(M: ImmutableMatrix) -> Stated:
    """A determinant of order three with its minors written out."""
    return total(*(product(a, first_line(minor)) for a, minor in along_row(M) if _products(minor)))


@lru_cache(maxsize=1024)
def _count(M: ImmutableMatrix) -> int:
    """How many minors of order three and above the expansion goes through."""
    if is_simple(M) or M.rows == 3:
        return 0
    return sum(1 + _count(minor) for _, minor in along_row(M) if _is_work(minor))


@lru_cache(maxsize=1024)
def _is_work(M: ImmutableMatrix) -> bool:
    """Whether det M is more than one product that a look tells."""
    minors = [] if is_simple(M) else [minor for _, minor in along_row(M)]
    return len(_products(M)) > 1 or _has_products(M) or any(map(_is_work, minors))


def _has_products(M: ImmutableMatrix) -> bool:
    """Whether a term of det M multiplies two numbers, or a sum."""
    return any(map(_is_product, _products(M)))


def _is_product(factors: tuple[Any, ...]) -> bool:
    counting = [factor for factor in factors if factor not in (1, -1)]
    numbers = [each for each in counting if each.as_coeff_Mul()[0] not in (1, -1)]
    return len(numbers) > 1 or (len(counting) > 1 and any(each.is_Add for each in counting))
