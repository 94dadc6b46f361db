"""Natural frequency, damping ratio and the cases of damping judged by the roots of the polynomial in numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import sympy as sp

from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.representation.minimal import MANY, numbers_at

CASES = ("undamped", "underdamped", "critically_damped", "overdamped")
TRIED = 12
WRONG = float("inf")
ZERO = 1e-25
NEAR = tuple(1 + sign * sp.Rational(1, 10**n) for n in (3, 12) for sign in (-1, 1))


def natural_frequency_residual(coefficients: Sequence[Any], answer: Any, period: Any = None) -> float:
    """Return the relative difference of an answer and √(p₁p₂) of the roots of b₂s² + b₁s + b₀.

    With a sampling period T the roots z are those of a discrete system, and p = (ln z)/T.
    """
    return _residual(coefficients, answer, lambda p, q: MANY.context.sqrt(p * q), period)


def damping_ratio_residual(coefficients: Sequence[Any], answer: Any, period: Any = None) -> float:
    """Return the relative difference of an answer and −(p₁ + p₂)/(2√(p₁p₂)), p as for the natural frequency."""
    return _residual(coefficients, answer, lambda p, q: -(p + q) / (2 * MANY.context.sqrt(p * q)), period)


def _residual(coefficients: Sequence[Any], answer: Any, formula: Any, period: Any) -> float:
    worst, tried = 0.0, 0
    for point in _points([*coefficients, answer, *([] if period is None else [period])]):
        roots = _roots(_numbers(coefficients, point))
        if period is not None:
            T = _numbers([period], point)[0]
            roots = MANY.context.ln(roots[0]) / T, MANY.context.ln(roots[1]) / T
        right = formula(*roots)
        value = _numbers([answer], point)[0]
        worst = worst_of((worst, float(abs(right - value) / max(abs(right), abs(value), MANY.context.mpf("1e-30")))))
        tried += 1
    if not tried:
        raise NotEvaluable("no values of the parameters give a natural frequency")
    return with_many_digits(worst, *coefficients, answer)


def _points(formulas: Sequence[Any]) -> Iterator[Any]:
    """Admissible points at which the outer coefficients have the same sign."""
    symbols: frozenset[Any] = frozenset().union(*(free_symbols(formula) for formula in formulas))
    for found in admissible(symbols, TRIED if symbols else 1):
        point = {x: sp.Rational(complex(value).real) for x, value in dict(found).items()}
        if _same_sign(formulas[:3], point):
            yield point


def _numbers(formulas: Sequence[Any], point: Any) -> list[Any]:
    """The values of formulas at a point of exact numbers, with 50 digits."""
    return [MANY.context.mpc(each) for each in numbers_at([formula.xreplace(point) for formula in formulas], {})]


def _roots(numbers: Sequence[Any]) -> tuple[Any, Any]:
    """Both roots of a polynomial of degree two."""
    a, b, c = numbers
    root = MANY.context.sqrt(b * b - 4 * a * c)
    return (-b + root) / (2 * a), (-b - root) / (2 * a)


def damping_words(coefficients: Sequence[Any], *, discrete: bool = False) -> set[str]:
    """Return the cases met among admissible values of the parameters; "" where the damping is negative."""
    case = _case_in_z if discrete else _case
    return {case(coefficients, point) for point in _points(coefficients)}


def _case_in_z(coefficients: Sequence[Any], point: Any) -> str:
    """The case by the roots in z: their distance from the unit circle, and whether they are real."""
    first, second = _roots(_numbers(coefficients, point))
    size = abs(first * second)
    if abs(size - 1) <= ZERO:
        return CASES[0]
    if size > 1:
        return ""
    distance = (first - second) ** 2
    return CASES[2] if abs(distance) <= ZERO else CASES[1] if distance.real < 0 else CASES[3]


def _case(coefficients: Sequence[Any], point: Any) -> str:
    b2, b1, b0 = (number.real for number in _numbers(coefficients, point))
    if b2 < 0:
        b2, b1, b0 = -b2, -b1, -b0
    size = b1 * b1 + 4 * b2 * b0
    if b1 * b1 <= ZERO * size:
        return CASES[0]
    if b1 < 0:
        return ""
    distance = b1 * b1 - 4 * b2 * b0
    return CASES[2] if abs(distance) <= ZERO * size else CASES[1] if distance < 0 else CASES[3]


def cases_fault(coefficients: Sequence[Any], cases: Mapping[str, Any]) -> str:
    """Return the first case whose condition is wrong, in words, or ""."""
    if set(map(str, cases)) - set(CASES):
        return "a case is named otherwise"
    named = {str(name): condition for name, condition in cases.items()}
    strange = set().union(*(free_symbols(each) for each in named.values())) - set().union(
        *map(free_symbols, coefficients)
    )
    if strange:
        return "it depends on something else"
    seen: set[str] = set()
    for point in _tried(coefficients, named):
        case = _case(coefficients, point)
        seen.add(case)
        for name in CASES:
            holds = _holds(named[name], point) if name in named else False
            if holds is not None and holds != (name == case):
                return name
    if {CASES[1], CASES[3]} <= seen and CASES[2] not in named:
        return CASES[2]
    if "" in seen and CASES[0] not in named and seen - {""}:
        return CASES[0] if _vanishes(coefficients) else ""
    return ""


def _vanishes(coefficients: Sequence[Any]) -> bool:
    """Whether b₁ is zero with b₂b₀ > 0 where it changes its sign: tried for b₁ linear in a symbol."""
    b2, b1, b0 = coefficients
    for p in sorted(b1.free_symbols, key=str):
        if b1.is_polynomial(p) and sp.degree(b1, p) == 1:
            slope, rest = sp.Poly(b1, p).all_coeffs()
            at = [each.subs(p, -rest / slope) for each in (b2, b1, b0)]
            return any(True for _ in _points(at))
    return False


def _tried(coefficients: Sequence[Any], named: Mapping[str, Any]) -> Iterator[Any]:
    """Points, and beside each of them those on and near the edges that equations of cases name."""
    edges = [each for condition in named.values() for each in _equations(condition)]
    for point in _points([*coefficients, *named.values()]):
        yield point
        for edge in edges:
            where = edge.rhs.xreplace(point)
            for factor in (1, *NEAR):
                moved = {**point, edge.lhs: where * factor if where != 0 else sp.Integer(factor - 1)}
                if _allowed(edge.lhs, moved[edge.lhs]) and _same_sign(coefficients, moved):
                    yield moved


def _equations(condition: Any) -> list[Any]:
    """The equations p = … that a condition is, or is made of."""
    parts = condition.args if isinstance(condition, sp.Or) else [condition]
    return [each for each in parts if isinstance(each, sp.Eq) and each.lhs.is_Symbol]


def _allowed(x: Any, value: Any) -> bool:
    """Whether the assumptions on a symbol allow a value."""
    number = sp.re(sp.N(value, 30))
    return not ((x.is_positive and number <= 0) or (x.is_negative and number >= 0) or (x.is_nonzero and number == 0))


def _same_sign(coefficients: Sequence[Any], point: Any) -> bool:
    b2, _, b0 = (number.real for number in _numbers(coefficients, point))
    return bool(b2 * b0 > 0)


def _holds(condition: Any, point: Any) -> bool | None:
    """Whether a condition holds at a point; an equation to 25 digits, None for what cannot be decided."""
    if condition in (True, False, sp.true, sp.false):
        return bool(condition)
    if isinstance(condition, sp.And | sp.Or):
        parts = [_holds(each, point) for each in condition.args]
        if None in parts:
            return None
        return all(parts) if isinstance(condition, sp.And) else any(parts)
    if not isinstance(condition, sp.core.relational.Relational):
        return None
    left, right = (number.real for number in _numbers([condition.lhs, condition.rhs], point))
    equal = abs(left - right) <= ZERO * (1 + abs(left) + abs(right))
    if isinstance(condition, sp.Eq | sp.Ne):
        return bool(equal == isinstance(condition, sp.Eq))
    strict = left > right if isinstance(condition, sp.Gt | sp.Ge) else left < right
    return bool(strict and not equal) if isinstance(condition, sp.Gt | sp.Lt) else bool(strict or equal)


def critical_residual(coefficients: Sequence[Any], parameter: Any, answer: Any) -> float:
    """Return how far the discriminant is from zero where the parameter has this value, with positive damping."""
    at = [each.subs(parameter, answer) for each in coefficients]
    worst, tried = 0.0, 0
    for point in _points([*at, answer]):
        if not _allowed(parameter, answer.xreplace(point)):
            return WRONG
        b2, b1, b0 = (number.real for number in _numbers(at, point))
        if b1 * b2 <= 0:
            return WRONG
        worst = worst_of((worst, float(abs(b1 * b1 - 4 * b2 * b0) / (b1 * b1 + 4 * abs(b2 * b0)))))
        tried += 1
    return with_many_digits(worst, *coefficients, answer) if tried else WRONG
