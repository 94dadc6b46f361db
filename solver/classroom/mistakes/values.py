"""Mistakes as values: our answer transformed (a sign, a transpose), or an intermediate result."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import islice, permutations, product
from typing import Any

import sympy as sp

from solver.classroom.judging.entries import is_scalar
from solver.classroom.judging.question import Question
from solver.classroom.mistakes.changed import steps_taken
from solver.derivation import PartResult, Slip
from solver.derivation import usual_mistakes as usual
from solver.problem.model import Part

MOST_PERMUTATIONS = 24
MOST_TERMS = 8


@dataclass(frozen=True)
class Case:
    """One wrong value: the part, its question, the answer's name, our value and results."""

    part: Part
    question: Question
    name: str
    ours: Any
    results: Sequence[PartResult]
    earlier: Mapping[str, PartResult]


Values = Iterator[Any]


def _negative(case: Case) -> Values:
    if isinstance(case.ours, list):
        yield [-item for item in case.ours]
    elif isinstance(case.ours, sp.MatrixBase | sp.Expr):
        yield -case.ours


def _transposed(case: Case) -> Values:
    if isinstance(case.ours, sp.MatrixBase):
        yield case.ours.T


def _reversed(case: Case) -> Values:
    """The entries of a row or column from the last to the first."""
    M = case.ours
    if isinstance(M, sp.MatrixBase) and 1 in M.shape:
        yield sp.ImmutableMatrix(*M.shape, list(reversed(M.flat())))


def _reordered(case: Case) -> Values:
    """Rows or columns in another order."""
    M = case.ours
    if isinstance(M, sp.MatrixBase) and 1 not in M.shape:
        for order in islice(permutations(range(M.rows)), MOST_PERMUTATIONS):
            yield M.extract(list(order), list(range(M.cols)))
        for order in islice(permutations(range(M.cols)), MOST_PERMUTATIONS):
            yield M.extract(list(range(M.rows)), list(order))


def _half(case: Case) -> Values:
    if isinstance(case.ours, sp.MatrixBase | sp.Expr):
        yield case.ours / 2


def _double(case: Case) -> Values:
    if isinstance(case.ours, sp.MatrixBase | sp.Expr):
        yield case.ours * 2


def _upside_down(case: Case) -> Values:
    """The denominator over the numerator of a transfer function, in each channel that is not zero."""
    if case.ours.free_symbols & {sp.Symbol("s"), sp.Symbol("z")}:
        yield _map(case.ours, lambda entry: 1 / entry if entry != 0 else entry)


def _without_multiplicity(case: Case) -> Values:
    if isinstance(case.ours, list):
        yield list(dict.fromkeys(case.ours))


def _without_factor_t(case: Case) -> Values:
    """The powers of t (or k) before an exponential left out: e^{λt} for t e^{λt}, or the whole term."""
    for x in (sp.Symbol("t"), sp.Symbol("k")):
        if x in case.ours.free_symbols:
            yield _map(case.ours, partial(_drop_powers, x=x, keep=True))
            yield _map(case.ours, partial(_drop_powers, x=x, keep=False))


def _drop_powers(expression: sp.Expr, x: sp.Symbol, *, keep: bool) -> sp.Expr:
    terms = []
    for term in sp.Add.make_args(sp.expand(expression)):
        powers = [factor for factor in sp.Mul.make_args(term) if factor.as_base_exp()[0] == x]
        terms.append(term / sp.Mul(*powers) if keep else (sp.Integer(0) if powers else term))
    return sp.Add(*terms)


def _exponent_reversed(case: Case) -> Values:
    t = sp.Symbol("t")
    if t in case.ours.free_symbols:
        yield _map(case.ours, lambda entry: entry.xreplace({t: -t}))


def _degrees(case: Case) -> Values:
    """Angles in degrees where radians are meant."""
    for angle in (sp.acos, sp.asin, sp.atan):
        if case.ours.has(angle):
            yield case.ours.replace(angle, partial(_in_degrees, angle))


def _in_degrees(angle: Callable[[Any], Any], z: Any) -> Any:
    return angle(z) * 180 / sp.pi


def _without_a_term(case: Case) -> Values:
    """One term of a sum left out: of an expression, or of one entry of a matrix."""
    if not isinstance(case.ours, sp.MatrixBase):
        yield from _shorter(case.ours)
        return
    M = case.ours
    for i, j in product(range(M.rows), range(M.cols)):
        for entry in _shorter(M[i, j]):
            changed = sp.Matrix(M)
            changed[i, j] = entry
            yield sp.ImmutableMatrix(changed)


def _shorter(expression: Any) -> Values:
    """The sums of all terms of a sum but one, as it stands and multiplied out."""
    for each in dict.fromkeys((expression, sp.expand(expression))) if is_scalar(expression) else ():
        terms = sp.Add.make_args(each)
        if 1 < len(terms) <= MOST_TERMS and not each.is_number:
            yield from (each - term for term in terms)


def _intermediate(case: Case) -> Values:
    """A result of one of the steps, of the answer's shape."""
    for result in case.results:
        for step in steps_taken(case.part, result.method, case.earlier):
            for each in step.walk():
                yield from (claim.right for claim in each.claims.values() if _alike(claim.right, case.ours))


def _alike(value: Any, ours: Any) -> bool:
    if isinstance(ours, sp.MatrixBase):  # zeros and ones alone may be there by chance
        return (
            isinstance(value, sp.MatrixBase)
            and value != ours
            and any(entry not in (0, 1, -1) for entry in value.flat())
        )
    return is_scalar(ours) and is_scalar(value) and value != ours and not value.is_number


def _map(value: Any, of: Callable[[Any], Any]) -> Any:
    return sp.ImmutableMatrix(value.applyfunc(of)) if isinstance(value, sp.MatrixBase) else of(value)


TRANSFORMED: tuple[tuple[Slip, Callable[[Case], Iterable[Any]]], ...] = (
    (usual.SIGN, _negative),
    (usual.TRANSPOSED, _transposed),
    (usual.REVERSED, _reversed),
    (usual.MULTIPLICITY, _without_multiplicity),
    (usual.UPSIDE_DOWN, _upside_down),
    (usual.HALF, _half),
    (usual.DOUBLE, _double),
    (usual.WITHOUT_POWER, _without_factor_t),
    (usual.EXPONENTS, _exponent_reversed),
    (usual.DEGREES, _degrees),
    (usual.ROWS_IN_ORDER, _reordered),
    (usual.WITHOUT_A_TERM, _without_a_term),
    (usual.INTERMEDIATE, _intermediate),
)
