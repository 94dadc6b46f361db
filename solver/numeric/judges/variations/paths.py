"""Functionals along random functions: polynomials whose derivatives of any order are known.

Nothing is differentiated by formula: powers of a variation are separated by Cauchy's integral formula, integrals are
found by quadrature.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from random import Random
from typing import Any

import numpy as np
from numpy.polynomial import Polynomial

from solver.jets import jet_symbol
from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols
from solver.numeric.evaluation.values import NotEvaluable

FROM, TO = 0.4, 1.3
"""Times between which the functions are taken: away from 0, where 1/t or log(t) have none."""
NODES = 24
CIRCLE = 16
RADIUS = 0.05
"""A circle of so many points about no variation at all: other powers are found to RADIUS**CIRCLE."""
TRIALS = 3
ORDERS = 9
"""So many derivatives of functions have values."""


@dataclass(frozen=True)
class Path:
    """Functions with variations, and values of the parameters: the symbols at all nodes, and the nodes' weights."""

    functions: Mapping[str, Polynomial]
    changes: Mapping[str, Polynomial]
    point: Mapping[Any, complex]
    nodes: Array
    weights: Array
    symbol: Callable[[Any], Any]

    def symbols(self, scale: Array) -> dict[Any, Array]:
        """Return the values of everything, for each scale of the variation (S,) and node (N,), as arrays (S·N,)."""
        shape = (len(scale), len(self.nodes))
        found: dict[Any, Array] = {each: np.full(shape, value, dtype=complex) for each, value in self.point.items()}
        for symbol in (each for each in self.point if each.name == "t"):
            found[symbol] = np.broadcast_to(self.nodes, shape)
        for name, function in self.functions.items():
            for k in range(ORDERS):
                x, dx = (np.asarray(each.deriv(k)(self.nodes) if k else each(self.nodes), dtype=complex)
                         for each in (function, self.changes[name]))  # fmt: skip
                found[self.symbol((name, k))] = x + scale[:, None] * dx
                found[jet_symbol((f"d{name}", k))] = np.broadcast_to(dx, shape)
        return {symbol: np.asarray(value, dtype=complex).reshape(-1) for symbol, value in found.items()}

    def integral(self, expression: Any, scale: Array) -> Array:
        """Return the integral of an expression for each scale of the variation (S,)."""
        count = len(scale) * len(self.nodes)
        value = value_of(expression, Environment(self.symbols(scale), count)).value
        return np.broadcast_to(value, (count,)).reshape(len(scale), -1) @ self.weights


def paths(system: Any, *, fixed: bool) -> Iterator[Path]:
    """Yield random functions near one, with variations; `fixed` ones vanish at the ends with their derivatives."""
    random = Random(SEED)  # noqa: S311 - nothing secret
    parameters = [each for each in system.parameters if each.name != "t"]
    source = PointSource([*parameters, system.t])
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    at, half = (FROM + TO) / 2, (TO - FROM) / 2
    for _ in range(TRIALS):
        functions = {name: 1 + 0.3 * _cubic(random) for name in system.functions}
        order = max([1, *system.orders.values()]) if fixed else 0
        window = Polynomial([1.0])
        for _ in range(order):
            window = window * Polynomial([-FROM, 1]) * Polynomial([TO, -1]) * 4
        changes = {name: window * _cubic(random) for name in system.functions}
        yield Path(functions, changes, source.draw(), at + half * nodes, half * weights, system.symbol)


def _cubic(random: Random) -> Polynomial:
    return Polynomial([random.uniform(-1, 1) / (1 + k) for k in range(4)])


def variation_residual(system: Any, degree: int, value: Any, *, fixed: bool) -> float:
    """Return how far the integral of `value` is from the part of that degree of the increment; 0: from all of it.

    With `fixed` ends the variations vanish there, so that a variation integrated by parts is right too.
    """
    known: set[Any] = set()
    worst = 0.0
    for path in paths(system, fixed=fixed):
        known = known or set(path.symbols(np.zeros(1)))
        if free_symbols(value) - known:
            return np.inf
        try:
            wanted = _part(path, system.integrand, degree)
            found = complex(path.integral(value, np.zeros(1))[0])
        except NotEvaluable:
            return np.inf
        worst = max(worst, abs(found - wanted) / max(1.0, abs(wanted)))
    return worst if np.isfinite(worst) else np.inf


def _part(path: Path, integrand: Any, degree: int) -> complex:
    """The coefficient of a power of the variation in the functional, or the whole increment (0)."""
    if not degree:
        before, after = path.integral(integrand, np.array([0.0, 1.0]))
        return complex(after - before)
    scale = RADIUS * np.exp(2j * np.pi * np.arange(CIRCLE) / CIRCLE)
    return complex(np.mean(path.integral(integrand, scale) / scale**degree))
