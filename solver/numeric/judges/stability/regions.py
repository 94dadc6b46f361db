"""Is a condition on parameters exactly that of asymptotic stability? Tried at points, near the boundaries above all."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from random import Random
from typing import Any

import numpy as np
import sympy as sp

from solver.conditions import conditions_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.inside import admits
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols
from solver.numeric.evaluation.values import NotEvaluable, Undefined
from solver.numeric.judges.stability.edges import beside_edges, comparisons_of, on_edges
from solver.numeric.judges.stability.location import STABLE, located
from solver.words import Phrase

WORDS = (STABLE, "not asymptotically stable")
RANDOM_POINTS = 40
PAIRS = 2
EDGES = 10
MOST_ENDS = 12
"""The highest degree of a comparison whose ends are looked for."""
ROUNDED, DECIMALS = 3, 16
"""Bounds with so many decimals (at least, less than) are taken as rounded."""
STEPS = (sp.Rational(1, 10**3), sp.Rational(1, 10**7), sp.Rational(1, 10**13))
Rational = dict[Any, Any]


@dataclass(frozen=True)
class StablePart:
    """A part of the system that is stable where a condition says so: as a function of the point, with its parameters.

    Points where there is no part do not count; `words` say of the system that the part is stable, and that it is not.
    """

    words: tuple[str, str]
    parameters: frozenset[Any]
    at: Callable[[Rational], Any]


def counterexample(A: Any, condition: Any, *, discrete: bool, part: StablePart | None = None) -> str:
    """Return where the condition and the eigenvalues of A disagree, in words, or "" where no such point was found.

    `condition` is a sympy condition or a truth value; parameters take values that their assumptions allow. It may be
    about a part alone, whose eigenvalues are some of A's.
    """
    if isinstance(condition, bool):
        condition = sp.true if condition else sp.false
    asked = part or StablePart(WORDS, frozenset(free_symbols(A)), lambda point: A.xreplace(point) if point else A)
    symbols = sorted(asked.parameters, key=str)
    strange = sorted(map(str, free_symbols(condition) - set(symbols)))
    if strange:
        listed = ", ".join(strange)
        return Phrase("the condition has {strange} in it, which is no parameter of the system", strange=listed)
    tried = _Trial(asked, condition, discrete)
    if not symbols:
        return tried.disagreement({})
    points = [point for point in _points(A, condition, symbols, discrete) if is_admissible(point)]
    points += _inside(symbols)
    for point in points:
        if fault := tried.disagreement(point):
            return fault
    for point in [*_boundary_points(tried, points), *_beside_edges(tried, points, symbols)]:
        if is_admissible(point) and (fault := tried.disagreement(point)):
            return fault
    if not tried.decided:
        raise NotEvaluable("no values of the parameters were found at which the system is defined")
    return ""


def _beside_edges(tried: _Trial, points: Sequence[Rational], symbols: Sequence[Any]) -> Iterable[Rational]:
    """Points beside the edges of a region of several parameters."""
    inside = [point for point in points if len(symbols) > 1 and tried.claimed(point) and tried.stable(point)]
    return beside_edges(lambda point: is_admissible(point) and tried.claimed(point), inside, tried.vague)


class _Trial:
    """The condition and the eigenvalues at points; remembers the truths found."""

    def __init__(self, asked: StablePart, condition: Any, discrete: bool) -> None:
        self.asked, self.condition, self.discrete = asked, condition, discrete
        self.decided = False
        self.vague = list(_rounded_bounds(condition))
        self.known: dict[tuple[Any, ...], bool | None] = {}

    def stable(self, point: Rational) -> bool | None:
        """Whether it is stable at a point; None where it is not defined or does not count."""
        key = tuple(point.values())
        if key not in self.known:
            try:
                self.known[key] = self._located(self.asked.at(point))
            except (Undefined, NotEvaluable):
                self.known[key] = None
            self.decided = self.decided or self.known[key] is not None
        return self.known[key]

    def _located(self, part: Any) -> bool | None:
        if part is None:
            return None
        return part.rows == 0 or located(part, {}, discrete=self.discrete).verdict == STABLE

    def claimed(self, point: Rational) -> bool | None:
        """Whether the condition holds at a point."""
        try:
            truth = self.condition.xreplace(point) if point else self.condition
        except TypeError:  # one of its sides is not defined there
            return self._claimed_by_one(point)
        truth = truth.doit() if hasattr(truth, "doit") else truth
        if truth not in (sp.true, sp.false):
            return None
        return bool(truth)

    def _claimed_by_one(self, point: Rational) -> bool | None:
        """Whether one of several comparisons denies the condition at a point where another has no value."""
        for each in self.condition.args if isinstance(self.condition, sp.And) else ():
            try:
                if each.xreplace(point) == sp.false:
                    return False
            except TypeError:
                continue
        return None

    def disagreement(self, point: Rational) -> str:
        """In words, if the condition is wrong at the point (not where rounded bounds leave it open)."""
        if any(abs(point[k] - bound) <= half for k, bound, half in self.vague if k in point):
            return ""
        stable = self.stable(point)
        claimed = self.claimed(point)
        if stable is None or stable == claimed:
            return ""
        where = ", ".join(f"{symbol} = {sp.N(value, 6)}" for symbol, value in point.items())
        found = self.asked.words[0 if stable else 1]
        says = "has no truth value" if claimed is None else "holds" if claimed else "does not hold"
        return (
            Phrase("for {where} the system is {found}, but the condition {says}", where=where, found=found, says=says)
            if where
            else Phrase("the system is {found}", found=found)
        )


def is_admissible(point: Rational) -> bool:
    """Whether the values are such as the symbols' assumptions allow."""
    for symbol, value in point.items():
        wrong = (
            (symbol.is_positive and value <= 0)
            or (symbol.is_negative and value >= 0)
            or (symbol.is_nonnegative and value < 0)
            or (symbol.is_nonpositive and value > 0)
            or (symbol.is_nonzero and value == 0)
            or (symbol.is_integer and not value.is_Integer)
        )
        if wrong:
            return False
    return admits(point)


def _inside(symbols: Sequence[Any]) -> list[Rational]:
    """Points at which the conditions on the parameters hold, where there are such conditions."""
    if not conditions_of(symbols):
        return []
    drawn = PointSource(symbols).several(RANDOM_POINTS)
    rational = [{symbol: sp.Rational(str(complex(value).real)) for symbol, value in each.items()} for each in drawn]
    return [point for point in rational if is_admissible(point)]


def _points(A: Any, condition: Any, symbols: Sequence[Any], discrete: bool) -> Iterable[Rational]:
    """Values at and beside what the condition names and where eigenvalues cross, then random ones."""
    random = Random(SEED)  # noqa: S311 - nothing secret
    named = _boundaries_named(condition)
    if len(symbols) == 1:
        (k,) = symbols
        exact, rounded = named.get(k, ([], []))
        values = sorted({*exact, *rounded, *_ends(condition, k), *_crossings(A, k, discrete=discrete)})
        for value in values:
            if value not in rounded:
                yield {k: value}
            for step in STEPS:
                yield from ({k: value + sign * step * (1 + abs(value))} for sign in (1, -1))
        yield from ({k: (low + high) / 2} for low, high in pairwise(values))
    for _ in range(RANDOM_POINTS):
        yield {symbol: random_value(symbol, random) for symbol in symbols}
    for rest in [{symbol: random_value(symbol, random) for symbol in symbols} for _ in range(EDGES)]:
        yield from on_edges(condition, rest)


def random_value(symbol: Any, random: Random) -> Any:
    """Return a rational value that the assumptions of a symbol allow, of any size."""
    sign = -1 if symbol.is_negative or (not symbol.is_positive and random.random() < 0.5) else 1
    size = 10 ** random.uniform(-2, 2)
    return (
        sp.Integer(sign * max(1, round(size)))
        if symbol.is_integer
        else sign * sp.Rational(round(1000 * size) or 1, 1000)
    )


def _boundaries_named(condition: Any) -> dict[Any, tuple[list[Any], list[Any]]]:
    """The numbers that symbols are compared with: exact ones, and decimals as rationals."""
    found: dict[Any, tuple[list[Any], list[Any]]] = {}
    for each in comparisons_of(condition):
        for left, right in ((each.lhs, each.rhs), (each.rhs, each.lhs)):
            if left.is_Symbol and not right.free_symbols and right.is_finite:
                exact, rounded = found.setdefault(left, ([], []))
                (rounded if right.has(sp.Float) else exact).append(
                    sp.Rational(str(sp.N(right, 30))) if right.has(sp.Float) else right
                )
    return found


def _ends(condition: Any, k: Any) -> Iterable[Any]:
    """Where comparisons of more than k itself end, as K² ≥ 4 and |K| ≥ 2 do at 2 and -2."""
    for each in comparisons_of(condition):
        if not (each.lhs.is_Symbol or each.rhs.is_Symbol):
            yield from _zeros(each.lhs - each.rhs, k)


def _zeros(difference: Any, k: Any) -> Iterable[Any]:
    """The real roots of the linear and quadratic factors of a polynomial, where |x| may be x and -x."""
    if absolute := next(iter(difference.atoms(sp.Abs)), None):
        for sign in (1, -1):
            yield from _zeros(difference.xreplace({absolute: sign * absolute.args[0]}), k)
    elif difference.free_symbols == {k} and difference.is_polynomial(k) and sp.degree(difference, k) <= MOST_ENDS:
        polynomial = sp.Poly(difference, k)
        factors = polynomial.factor_list()[1] if polynomial.domain in (sp.ZZ, sp.QQ) else [(polynomial, 1)]
        for factor, _ in factors:
            if factor.degree() <= 2:
                yield from (root for root in sp.roots(factor) if root.is_real)


def _rounded_bounds(condition: Any) -> Iterable[tuple[Any, Any, Any]]:
    """The symbols compared with decimals of three digits or more behind the point, and half of their last digit."""
    for symbol, (exact, _) in _boundaries_named(condition).items():
        for bound in exact:
            places = next((d for d in range(DECIMALS) if bound.is_Rational and (bound * 10**d).is_Integer), 0)
            if places >= ROUNDED:
                yield symbol, bound, sp.Rational(51, 10 ** (places + 2))


def _crossings(A: Any, k: Any, *, discrete: bool) -> list[Any]:
    """Values of k where two eigenvalues may add up to zero (discrete: multiply to one), for A = A₀ + k A₁.

    A polynomial eigenvalue problem with Kronecker's sum (product) of A with itself, solved by scipy.
    """
    from scipy.linalg import eig  # noqa: PLC0415 - 150 ms that most checks do not need

    try:
        at = [np.real(value_of(A, Environment.at([{k: x}])).value[0]) for x in (0.0, 1.0, 3.0)]
    except Undefined:
        return []
    A0, A1 = at[0], at[1] - at[0]
    if not np.allclose(at[2], A0 + 3 * A1):
        return []
    one, n2 = np.eye(len(A0)), len(A0) ** 2
    if discrete:
        M = np.kron(A0, A0) - np.eye(n2), np.kron(A0, A1) + np.kron(A1, A0), np.kron(A1, A1)
    else:
        M = np.kron(A0, one) + np.kron(one, A0), np.kron(A1, one) + np.kron(one, A1), np.zeros((n2, n2))
    zero, identity = np.zeros((n2, n2)), np.eye(n2)
    left, right = np.block([[zero, identity], [-M[0], -M[1]]]), np.block([[identity, zero], [zero, M[2]]])
    with np.errstate(all="ignore"):
        values = eig(left, right, right=False)
    real = [v.real for v in values if np.isfinite(v) and abs(v.imag) < 1e-6 * (1 + abs(v)) and abs(v) < 1e6]
    return sorted({sp.Rational(round(value * 10**7), 10**7) for value in real})


def _boundary_points(tried: _Trial, points: Sequence[Rational]) -> Iterable[Rational]:
    """Points close to each other on both sides of edges: of the condition, and of what is found by eigenvalues."""
    for truth in (tried.claimed, tried.stable):
        values = [(point, truth(point)) for point in points[-RANDOM_POINTS:]]
        yes, no = ([point for point, value in values if value is wanted] for wanted in (True, False))
        for inside, outside in list(zip(yes, no, strict=False))[:PAIRS]:
            yield from _bisected(truth, inside, outside)


def _bisected(truth: Any, inside: Rational, outside: Rational) -> Iterable[Rational]:
    for _ in range(20):
        middle = {symbol: (inside[symbol] + outside[symbol]) / 2 for symbol in inside}
        found = truth(middle)
        if found is None:
            return
        inside, outside = (middle, outside) if found else (inside, middle)
    yield inside
    yield outside
