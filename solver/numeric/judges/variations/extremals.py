"""Whether functions are extremals: the equations of Euler and Lagrange, the conditions at the ends, the integral.

Where there are constraints, multipliers are looked for that satisfy everything: functions of time as polynomials of
Chebyshev, constants for constraints by integrals, both by least squares.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from scipy.integrate import quad

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.judges.variations.direct import worst
from solver.numeric.judges.variations.problem import Along, Jet, Problem, is_known, numbers

TIMES = 9
DEGREE = 14
"""Of the polynomials that stand for multipliers."""
TIMES_OF_MULTIPLIERS = 40
LEAST = 1e-9
"""A value that is zero all along is compared as it is."""


def stationary_residual(problem: Problem, x: Mapping[str, Any] | None, t_f: Any = None) -> float:
    """Return how far the equations of Euler and Lagrange, and the natural conditions at free ends, are from holding.

    Relative to the terms in them, at several times; `t_f` is the end where that is free. Infinite where a function is
    missing or is no function of t alone.
    """
    return worst(problem, x, t_f, lambda along: _Conditions(along).residual())


def ends_residual(problem: Problem, x: Mapping[str, Any] | None, t_f: Any = None) -> float:
    """Return how far values and derivatives at the ends are from what is asked of them, on a curve from the curve."""

    def judge(along: Along) -> float:
        apart = 0.0
        for (name, k), pair in problem.ends.items():
            for end, time in zip(pair, (along.start, along.stop), strict=True):
                if end.free or end.kept:
                    continue
                at = np.array([time], dtype=complex)
                wanted = along.at_times(end.value if end.curve is None else end.curve, at)[0]
                found = along.derivatives(along.x[name], at, k)[k][0]
                apart = max(apart, abs(found - wanted) / max(1.0, abs(wanted)))
        return apart

    return worst(problem, x, t_f, judge)


def constraints_residual(problem: Problem, x: Mapping[str, Any] | None, t_f: Any = None) -> float:
    """Return how far constraints, at some times and under integrals, are from holding."""

    def judge(along: Along) -> float:
        times, apart = along.inner(TIMES), 0.0
        for constraint in problem.constraints:
            apart = max(apart, float(np.max(np.abs(along.of(constraint, times)))) / _size(along, times))
        for integrand, value in problem.integrals:
            wanted = numbers(value, along.point, 1)[0]
            apart = max(apart, abs(integral_along(along, integrand) - wanted) / max(1.0, abs(wanted)))
        return apart

    return worst(problem, x, t_f, judge)


def value_residual(
    problem: Problem, x: Mapping[str, Any] | None, value: Any, t_f: Any = None, *, cost: bool = True
) -> float:
    """Return the relative difference of a value and of the integral by quadrature, with the terminal `cost` or not."""

    def judge(along: Along) -> float:
        if not is_known(value, along):
            return np.inf
        total = integral_along(along, problem.integrand)
        typical = along.span * float(np.max(np.abs(along.of(problem.integrand, along.inner(TIMES)))))
        if cost:
            total += along.of(problem.cost, np.array([along.stop], dtype=complex))[0]
        found = numbers(value, along.point, 1)[0]
        return float(abs(found - total) / max(abs(total), 1e-3 * typical, LEAST))

    return worst(problem, x, t_f, judge)


def integral_along(along: Along, integrand: Any) -> complex:
    """Return the integral of an expression along the motion, by quadrature; the derivatives by formulas of numbers."""

    def part(take: Any) -> float:
        return float(quad(lambda time: take(along.of(integrand, np.array([time], dtype=complex))[0]),
                          along.start, along.stop, limit=100, epsabs=1e-11, epsrel=1e-11)[0])  # fmt: skip

    imaginary = along.of(integrand, along.inner(3)).imag
    return complex(part(np.real), part(np.imag) if np.any(np.abs(imaginary) > 1e-9) else 0.0)


def _size(along: Along, times: Array) -> float:
    return max(1.0, *(float(np.max(np.abs(row))) for row in along.jets(times).values()))


@dataclass(frozen=True)
class _Conditions:
    """Rows that must be zero, for the integrand and for what stands beside each multiplier."""

    along: Along

    @property
    def problem(self) -> Problem:
        return self.along.problem

    def residual(self) -> float:
        """The worst row relative to the terms in it, with the best multipliers."""
        rows, sizes = self.rows(self.problem.integrand, self.unit, cost=True)
        columns = [self.rows(f, self.unit)[0] for f, _ in self.problem.integrals]
        for constraint in self.problem.constraints:
            for degree in range(DEGREE + 1):
                columns.append(self.rows(constraint, self.chebyshev(degree))[0])
        if not columns:
            return float(np.max(np.abs(rows) / sizes))
        scale = np.maximum(sizes, max(float(np.max(np.abs(column))) for column in columns))
        M = np.array(columns).T / scale[:, None]
        weights = np.linalg.lstsq(M, -rows / scale, rcond=1e-13)[0]
        return float(np.max(np.abs(M @ weights + rows / scale)))

    @staticmethod
    def unit(times: Array) -> Array:
        """1 at all times."""
        return np.ones_like(times)

    def chebyshev(self, degree: int) -> Any:
        """A polynomial over the whole time."""
        return np.polynomial.chebyshev.Chebyshev.basis(degree, domain=[self.along.start, self.along.stop])

    @cached_property
    def times(self) -> Array:
        """Where the equations are tried."""
        return self.along.inner(TIMES_OF_MULTIPLIERS if self.problem.constraints else TIMES)

    def rows(self, f: Any, weight: Any, *, cost: bool = False) -> tuple[Array, Array]:
        """The rows of w f: the equation of each function at all times, then the ends; and the sizes of their terms."""
        found, sizes = [], []
        for name in self.problem.functions:
            terms = self.equation(f, weight, name)
            found.append(np.sum(terms, axis=0))
            sizes.append(np.full(len(self.times), max(float(np.max(np.sum(np.abs(terms), axis=0))), self.least)))
        for value, size in self.ends(f, weight, cost=cost):
            found.append(np.array([value]))
            sizes.append(np.array([max(size, self.least)]))
        return np.concatenate(found), np.concatenate(sizes)

    @cached_property
    def least(self) -> float:
        """What is small in this problem."""
        return 1e-3 * max(1e-3, float(np.max(np.abs(self.along.of(self.problem.integrand, self.times)))))

    def momentum(self, f: Any, weight: Any, jet: Jet) -> Any:
        """The function of times w ∂f/∂q⁽ᵏ⁾."""
        return lambda times: weight(times) * self.along.partial(f, jet, times)

    def equation(self, f: Any, weight: Any, name: str) -> Array:
        """The terms (−1)ᵏ dᵏ/dtᵏ (w ∂f/∂q⁽ᵏ⁾) at all times."""
        order = self.problem.orders[name]
        return np.array([
            (-1) ** k * self.along.derivatives(self.momentum(f, weight, (name, k)), self.times, k)[k]
            for k in range(order + 1)
        ])  # fmt: skip

    def at_end(self, f: Any, weight: Any, jet: Jet, time: float) -> complex:
        """What stands beside the variation of a derivative at an end: Σ (−1)ⁱ dⁱ/dtⁱ (w ∂f/∂q⁽ᵏ⁺¹⁺ⁱ⁾)."""
        name, k = jet
        at, total = np.array([time], dtype=complex), 0j
        for i in range(self.problem.orders[name] - k):
            total += (-1) ** i * self.along.derivatives(self.momentum(f, weight, (name, k + 1 + i)), at, i)[i][0]
        return total

    def ends(self, f: Any, weight: Any, *, cost: bool) -> Iterator[tuple[complex, float]]:
        """The natural conditions at free ends, and the one of a free time, each with the size of its terms."""
        problem, along = self.problem, self.along
        jets = [(name, k) for name in problem.functions for k in range(problem.orders[name])]
        last = np.array([along.stop], dtype=complex)
        of_cost = {jet: along.partial(problem.cost, jet, last)[0] if cost else 0j for jet in jets}
        for jet in jets:
            between = (along.start + place * along.span for place in (0.3, 0.7))
            typical = max(abs(self.at_end(f, weight, jet, time)) for time in between)
            if problem.end(jet, 0).free:
                yield -self.at_end(f, weight, jet, along.start), typical
            if problem.end(jet, 1).free:
                value = self.at_end(f, weight, jet, along.stop)
                yield value + of_cost[jet], max(typical, abs(value), abs(of_cost[jet]))
        if problem.stop is None:
            terms = list(self.of_time(f, weight, jets, of_cost, cost=cost))
            yield sum(terms), sum(map(abs, terms))

    def of_time(self, f: Any, weight: Any, jets: Sequence[Jet], of_cost: Mapping[Jet, complex], *, cost: bool) -> Any:
        """The terms of f + Σ (c' − q') p + ∂cost/∂t + ∂cost/∂q c': what moves with the end of the time."""
        along = self.along
        last = np.array([along.stop], dtype=complex)
        yield weight(last)[0] * along.of(f, last)[0]
        if cost:
            yield self.explicit(along)
        for jet in jets:
            name, k = jet
            end = self.problem.end(jet, 1)
            p = self.at_end(f, weight, jet, along.stop)
            slope = along.derivatives(along.x[name], last, k + 1)[k + 1][0]
            yield -slope * p
            if end.curve is not None:
                rate = along.derivatives(lambda at, end=end: along.at_times(end.curve, at), last, 1)[1][0]
                yield rate * p
                yield rate * of_cost[jet]

    def explicit(self, along: Along) -> complex:
        """∂cost/∂t, the values at the end kept."""
        last = np.array([along.stop], dtype=complex)
        values = {symbol: value[0] for symbol, value in along.jets(last).items()}
        known = {**along.point, **values}
        return complex(along.derivatives(
            lambda at: numbers(self.problem.cost, {**known, self.problem.t: at}, len(at)), last, 1)[1][0])  # fmt: skip
