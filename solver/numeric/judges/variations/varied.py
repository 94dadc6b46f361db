"""What small variations do to a functional: its gradient and second variation on admissible polynomials.

The time from start to end is mapped to 0 … 1, so that a free end time is one parameter more; x + Σ aⱼ Pⱼ with the
polynomials of Legendre has the other ones. Ends, curves and constraints are equations between the parameters, with
multipliers of their own: the second variation is that of the Lagrangian where they do not change to first order.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.polynomial import Legendre
from scipy.linalg import eigh, null_space

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.points import SEED, free_symbols
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.variations.problem import Along, Problem, numbers

NODES = 40
STEP, TURNS = 0.02, 4
GRADIENT_TURNS = 8
DEPENDENT = 1e-9
POINTS, AROUND = 40, 1.0
"""Where convexity is tried."""


@dataclass(frozen=True)
class Varied:
    """The functional as a function of the parameters of a variation."""

    along: Along
    degree: int = 9

    @property
    def problem(self) -> Problem:
        """The problem."""
        return self.along.problem

    @cached_property
    def nodes(self) -> tuple[Array, Array]:
        """Gauss's nodes and weights on 0 … 1."""
        places, weights = np.polynomial.legendre.leggauss(NODES)
        return (places + 1) / 2, weights / 2

    @cached_property
    def size(self) -> int:
        """How many parameters there are."""
        return len(self.problem.functions) * (self.degree + 1) + (self.problem.stop is None)

    def basis(self, places: Array, order: int) -> Array:
        """The derivatives of the polynomials, small with all that occur, at some places (degree × places)."""
        return np.array([p.deriv(order)(places) for p in self.polynomials])

    @cached_property
    def polynomials(self) -> list[Legendre]:
        """The polynomials on 0 … 1."""
        every = [Legendre.basis(d, domain=[0, 1]) for d in range(self.degree + 1)]
        top = max(self.problem.orders.values())
        return [p / max(abs(p.deriv(k)(1.0)) for k in range(top + 1)) for p in every]

    @cached_property
    def _known(self) -> dict[bytes, Any]:
        return {}

    def tables(self, places: Array) -> tuple[dict[Any, Array], dict[int, Array]]:
        """The motion's own derivatives at some places, and those of the polynomials, by order."""
        key = places.tobytes()
        if key not in self._known:
            times = (self.along.start + self.along.span * places).astype(complex)
            highest = max(k for _, k in self.problem.jets.values())
            self._known[key] = self.along.jets(times), {k: self.basis(places, k) for k in range(highest + 1)}
        found: tuple[dict[Any, Array], dict[int, Array]] = self._known[key]
        return found

    def jets(self, a: Array, places: Array) -> tuple[dict[Any, Array], Array, Array]:
        """All derivatives at some places for many parameters (many × places), the times, and how long it takes."""
        own, basis = self.tables(places)
        span = np.full((len(a), 1), self.along.span, dtype=complex)
        if self.problem.stop is None:
            span = span + a[:, -1:]
        stretched = self.along.span / span
        found = {}
        for symbol, (name, k) in self.problem.jets.items():
            added = a[:, self._part(name)] @ basis[k]
            found[symbol] = own[symbol][None, :] * stretched**k + added / span**k
        return found, self.along.start + span * places[None, :], span

    def evaluated(self, f: Any, a: Array, places: Array) -> Array:
        """An expression at some places for many parameters (many × places)."""
        jets, times, _ = self.jets(a, places)
        many = {symbol: value.reshape(-1) for symbol, value in jets.items()}
        values = numbers(f, {**self.along.point, **many, self.problem.t: times.reshape(-1)}, times.size)
        return values.reshape(times.shape)

    def integral(self, f: Any, a: Array) -> Array:
        """The integral of an expression for many parameters."""
        places, weights = self.nodes
        span = self.along.span + (a[:, -1] if self.problem.stop is None else 0.0)
        found: Array = self.evaluated(f, a, places) @ weights * span
        return found

    def functional(self, a: Array) -> Array:
        """The whole functional."""
        last = np.ones(1)
        return self.integral(self.problem.integrand, a) + self.evaluated(self.problem.cost, a, last)[:, 0]

    def equations(self, a: Array) -> Array:
        """What must stay zero (many × equations): ends, curves, integrals, constraints at the nodes."""
        columns = []
        for (name, k), pair in self.problem.ends.items():
            for end, place in zip(pair, (0.0, 1.0), strict=True):
                if end.free:
                    continue
                jets, times, _ = self.jets(a, np.array([place]))
                if end.kept:
                    own = self.tables(np.array([place]))[0][self.problem.symbols[name, k]]
                    columns.append(jets[self.problem.symbols[name, k]][:, 0] - own)
                    continue
                wanted = self.along.at_times(end.value if end.curve is None else end.curve, times[:, 0])
                columns.append(jets[self.problem.symbols[name, k]][:, 0] - wanted)
        for f, value in self.problem.integrals:
            columns.append(self.integral(f, a) - numbers(value, self.along.point, 1)[0])
        for constraint in self.problem.constraints:
            columns += list(self.evaluated(constraint, a, self.nodes[0]).T)
        return np.array(columns).T if columns else np.zeros((len(a), 0), dtype=complex)

    def gradient(self, f: Any) -> Array:
        """The gradient of a function of the parameters at zero (parameters first)."""
        turns = np.exp(2j * np.pi * np.arange(GRADIENT_TURNS) / GRADIENT_TURNS)
        a = np.zeros((self.size, GRADIENT_TURNS, self.size), dtype=complex)
        for i in range(self.size):
            a[i, :, i] = STEP * turns
        values = f(a.reshape(-1, self.size))
        shaped = values.reshape(self.size, GRADIENT_TURNS, *values.shape[1:])
        found: Array = np.real(np.einsum("ij...,j->i...", shaped, 1 / turns)) / GRADIENT_TURNS / STEP
        return found

    def hessian(self, f: Any) -> Array:
        """The matrix of second derivatives of a function of the parameters at zero."""
        turns = np.exp(2j * np.pi * np.arange(TURNS) / TURNS)
        pairs = [(i, j) for i in range(self.size) for j in range(i + 1)]
        a = np.zeros((len(pairs), TURNS, TURNS, self.size), dtype=complex)
        for row, (i, j) in enumerate(pairs):
            a[row, :, :, i] += STEP * turns[:, None]
            a[row, :, :, j] += STEP * turns[None, :]
        values = f(a.reshape(-1, self.size)).reshape(len(pairs), TURNS, TURNS)
        taken = np.real(np.einsum("kij,i,j->k", values, 1 / turns, 1 / turns)) / TURNS**2 / STEP**2
        found = np.zeros((self.size, self.size))
        for (i, j), value in zip(pairs, taken, strict=True):
            found[i, j] = found[j, i] = value
        return found

    def of_lagrangian(self, weights: Array) -> Array:
        """The second derivatives of the functional and of the equations with multipliers."""
        problem, along = self.problem, self.along
        if problem.stop is None:  # the time stretches with the last parameter
            return self.hessian(lambda a: self.functional(a) + self.equations(a) @ weights)
        places, shares = self.nodes
        of_ends = sum(not end.free for pair in problem.ends.values() for end in pair)
        of_integrals = weights[of_ends : of_ends + len(problem.integrals)]
        of_nodes = weights[of_ends + len(problem.integrals) :].reshape(-1, NODES)
        parts = [(problem.integrand, places, shares * along.span), (problem.cost, np.ones(1), np.ones(1))]
        parts += [
            (f, places, w * shares * along.span) for (f, _), w in zip(problem.integrals, of_integrals, strict=True)
        ]
        parts += [(c, places, w) for c, w in zip(problem.constraints, of_nodes, strict=True)]
        found = np.zeros((self.size, self.size))
        for f, where, share in parts:
            found += self._bent(f, where, share)
        return found

    def _bent(self, f: Any, places: Array, shares: Array) -> Array:
        """The second derivatives of a weighted sum of an expression over places."""
        inside = [jet for symbol, jet in self.problem.jets.items() if symbol in free_symbols(f)]
        times = (self.along.start + self.along.span * places).astype(complex)
        found = np.zeros((self.size, self.size))
        for one in inside:
            for other in inside:
                bent = self.along.second_partial(f, one, other, times).real / self.along.span ** (one[1] + other[1])
                block = (self.basis(places, one[1]) * (shares * bent)) @ self.basis(places, other[1]).T
                found[self._part(one[0]), self._part(other[0])] += block
        return found

    def _part(self, name: str) -> slice:
        """Where the parameters of a function stand."""
        at = self.problem.functions.index(name) * (self.degree + 1)
        return slice(at, at + self.degree + 1)

    @cached_property
    def admissible(self) -> Array:
        """Parameters (columns) that keep all equations to first order."""
        slopes = self.gradient(self.equations).T
        if not slopes.size:
            return np.eye(self.size)
        scaled = slopes / np.maximum(np.linalg.norm(slopes, axis=1, keepdims=True), 1e-300)
        return null_space(scaled, rcond=DEPENDENT)

    def first(self) -> float:
        """The slope of the functional along admissible variations, relative to its slope or to what it is near."""
        slope, Z = self.gradient(self.functional), self.admissible
        if not Z.size:
            raise NotEvaluable("no polynomials were found that keep the constraints")
        near = [np.zeros((1, self.size)), np.eye(self.size)]  # both slope and value may be zero, as of a square
        sizes = [float(np.median(np.abs(self.functional(a.astype(complex))))) for a in near]
        typical = max(float(np.linalg.norm(slope)), 1e-3 * max(size for size in sizes if np.isfinite(size)))
        return float(np.linalg.norm(Z.T @ slope) / max(typical, 1e-9))

    def extremes(self) -> tuple[float, float]:
        """The least and the largest eigenvalue of the second variation, relative to the larger size.

        Relative to the norm of the variations with their derivatives.
        """
        Z = self.admissible
        if not Z.size:
            raise NotEvaluable("no polynomials were found that keep the constraints")
        slope, rows = self.gradient(self.functional), self.gradient(self.equations)
        weights = -np.linalg.lstsq(rows, slope, rcond=1e-11)[0] if rows.size else np.zeros(0)
        H = self.of_lagrangian(weights)
        values = eigh(Z.T @ H @ Z, Z.T @ self.gram @ Z, eigvals_only=True)
        scale = max(float(np.max(np.abs(values))), 1e-300)
        return float(values[0]) / scale, float(values[-1]) / scale

    @cached_property
    def gram(self) -> Array:
        """The norm of variations: with the derivatives of each function that the problem has."""
        places, weights = self.nodes
        found = np.eye(self.size)
        for name in self.problem.functions:
            block = sum((self.basis(places, k) * weights) @ self.basis(places, k).T
                        for k in range(self.problem.orders[name] + 1))  # fmt: skip
            found[self._part(name), self._part(name)] = block
        return found

    def curvatures(self) -> tuple[float, float]:
        """The least and the largest eigenvalue of the integrand's second derivatives by the highest derivatives."""
        problem, along = self.problem, self.along
        highest = [(name, problem.orders[name]) for name in problem.functions]
        times = np.concatenate([along.inner(2 * NODES), [along.start, along.stop]])
        return _extremes(along, problem.integrand, highest, times)

    def convexity(self) -> tuple[float, float]:
        """The least and the largest eigenvalue of the second derivatives by all that varies, anywhere around."""
        problem, along = self.problem, self.along
        random = np.random.default_rng(SEED)
        inside = [jet for symbol, jet in problem.jets.items() if symbol in free_symbols(problem.integrand)]
        times = along.start + along.span * random.uniform(0.02, 0.98, POINTS)
        moved = {problem.symbols[jet]: AROUND * random.standard_normal(POINTS) for jet in inside}
        low, high = _extremes(along, problem.integrand, inside, times, moved)
        cost = [jet for symbol, jet in problem.jets.items() if symbol in free_symbols(problem.cost)]
        if cost:
            below, above = _extremes(along, problem.cost, cost, np.array([along.stop]))
            return min(low, below), max(high, above)
        return low, high


def _extremes(
    along: Along, f: Any, jets: list[Any], times: Array, moved: Mapping[Any, Array] | None = None
) -> tuple[float, float]:
    """The least and the largest eigenvalue of a matrix of second derivatives at some times, relative to the size."""
    count = len(times)
    M = np.zeros((count, len(jets), len(jets)))
    for i, one in enumerate(jets):
        for j, other in enumerate(jets[: i + 1]):
            M[:, i, j] = M[:, j, i] = along.second_partial(f, one, other, times.astype(complex), moved).real
    values = np.linalg.eigvalsh(M) if jets else np.zeros((count, 1))
    scale = max(float(np.max(np.abs(values))), 1e-300)
    return float(np.min(values)) / scale, float(np.max(values)) / scale
