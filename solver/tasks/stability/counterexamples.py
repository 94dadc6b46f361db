"""A value of the parameters at which a wrong condition of stability is wrong: a short one, off every boundary."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import islice, product
from typing import TYPE_CHECKING, Any

from solver.derivation import Check
from solver.lazy import sympy as sp
from solver.numeric.judges import linear_algebra
from solver.numeric.judges import stability as judges
from solver.tasks.told import Told, told
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

MARGIN = 1e-3
"""Eigenvalues nearer to the boundary would give the right condition away."""

MOST_POINTS = 400
MOST_SYMBOLS = 3
WHOLE = (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 20, 30, 50, 100, 1000)


def counterexample(A: ImmutableMatrix, condition: Any, *, discrete: bool) -> Reason | None:
    """Return where a condition holds though A has an eigenvalue outside, or fails though all are inside."""
    symbols = sorted(A.free_symbols, key=str)
    if not 0 < len(symbols) <= MOST_SYMBOLS or condition.free_symbols - A.free_symbols:
        return None
    for point in _points(condition, symbols):
        holds = condition.xreplace(point)
        if holds not in (sp.true, sp.false) or not judges.is_admissible(point):
            continue
        eigenvalues = told(linear_algebra.decimal_eigenvalues(A.xreplace(point)))
        beyond = max(_beyond(each, discrete=discrete) for each in eigenvalues)
        if abs(beyond) > MARGIN and (beyond < 0) != bool(holds):
            outside = [each for each in eigenvalues if _beyond(each, discrete=discrete) > 0]
            values = {"point": point, "holds": bool(holds), "eigenvalues": outside or eigenvalues}
            return Reason("meanings/counterexample", {**values, "discrete": discrete})
    return None


def condition_check(A: ImmutableMatrix, condition: Any, claim: str, *, discrete: bool) -> Check:
    """Return the check that a condition holds if and only if all eigenvalues of A lie inside, as the claim says.

    At points on both sides of every edge of the condition, and at random ones.
    """
    fault = judges.counterexample(A, condition, discrete=discrete)
    check = Check.that(
        Phrase("{claim} ({fault})", claim=claim, fault=fault) if fault else claim,
        "numpy.linalg.eigvals, beside the edges mpmath.eig",
        not fault,
    )
    return replace(check, reason=fault)


def _beyond(each: Told, *, discrete: bool) -> float:
    """How far an eigenvalue lies outside of the region of stability; negative inside."""
    z = complex(each.at) + 1j * float(each.beside or 0)
    return abs(z) - 1 if discrete else z.real


def _points(condition: Any, symbols: Sequence[Any]) -> Iterator[dict[Any, Any]]:
    """Values of the symbols: whole numbers, then halves, then those about the bounds that the condition names."""
    whole = [sp.Integer(sign * each) for each in WHOLE for sign in (1, -1)] + [sp.Integer(0)]
    halves = [sp.Rational(sign * each, 2) for each in (1, 3, 5, 7, 9, 11, 13, 15, 17, 19) for sign in (1, -1)]
    tenths = [sp.Rational(sign * each, 10) for each in (1, 2, 3, 4, 6, 7, 8, 9) for sign in (1, -1)]
    bounds = [bound + step for bound in _bounds(condition) for step in (sp.Rational(1, 10), -sp.Rational(1, 10))]
    for values in (whole, halves, [*tenths, *bounds]):
        yield from (_named(symbols, each) for each in islice(product(values, repeat=len(symbols)), MOST_POINTS))


def _named(symbols: Sequence[Any], values: Iterable[Any]) -> dict[Any, Any]:
    return dict(zip(symbols, values, strict=True))


def _bounds(condition: Any) -> list[Any]:
    return sorted(condition.atoms(sp.Rational), key=float)
