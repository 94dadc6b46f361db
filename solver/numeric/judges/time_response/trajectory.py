"""Trajectories of linear systems by steps: x(t + h) = e^{Ah} x(t) + ∫ e^{A(h − σ)} B u(t + σ) dσ.

They judge what a closed form says about the limit and the peak of the output.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import DOUBLE, Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.numeric.evaluation.values import SAFETY, NotEvaluable
from solver.numeric.judges.time_response.response import impulses, intervals, sampled

NODES = 10
MOST_STEPS = 60_000
EARLY = 1e-3
"""The part of the first step after which an output is seen to rise."""
FLOOR = 1e-3
"""Numbers smaller than this are compared absolutely."""
SEEN = 1e-10
"""States are seen by the output where a singular value of the observability matrix is not below this, relatively."""
SETTLED = 32.0
"""In units of the slowest time constant."""


@dataclass(frozen=True)
class Simulation:
    """A system in numbers, with its inputs (a column of expressions, or None) in the symbol of time."""

    A: Array
    B: Array
    C: Array
    D: Array
    x0: Array
    inputs: Any
    time: Any
    point: Mapping[Any, complex]
    exact: tuple[Any, ...]
    """A, B, C, D, x0 and the inputs as they are given."""

    def input_at(self, times: Array) -> Array:
        """Return u at some times (N×m)."""
        count = self.B.shape[1]
        if self.inputs is None or count == 0:
            return np.zeros((len(times), count))
        result = value_of(self.inputs, Environment({self.time: times.astype(complex)}, len(times)))
        return np.broadcast_to(result.value, (len(times), count, 1))[:, :, 0].real

    @property
    def rates(self) -> tuple[float, float]:
        """The slowest decay and the fastest change of the system and its inputs (slowest 0: nothing decays)."""
        eigenvalues = np.linalg.eigvals(self.A)
        speeds = [*np.abs(eigenvalues), *_speeds(self.inputs, self.time)]
        decays = [-value.real for value in eigenvalues if value.real < -1e-9 * (1 + abs(value))]
        return (float(min(decays)) if decays else 0.0), float(max([*speeds, 1e-3]))


def _speeds(inputs: Any, t: Any) -> list[float]:
    """The sizes of the factors of t in exponentials and sines."""
    if inputs is None:
        return []
    found = [sp.expand(f.args[0]).coeff(t, 1) for f in inputs.atoms(sp.exp, sp.sin, sp.cos, sp.sinh, sp.cosh)]
    return [abs(complex(c)) for c in found if c.is_number]


def simulations(
    system: Any, x0: Any, inputs: Any, t: Any, *, late: bool = False
) -> list[tuple[Mapping[Any, complex], Simulation]]:
    """Return values of the parameters, and the system in numbers there; impulses at the start go into x0.

    With `late` only the end matters, so the inputs are those after all jumps. Raises NotEvaluable otherwise if the
    inputs jump later than at the start.
    """
    m = system.B.cols if system.B is not None else 0
    B = system.B if system.B is not None else sp.zeros(system.order, 0)
    D = system.D if system.D is not None else sp.zeros(system.C.rows, m)
    start, smooth = x0, inputs
    if inputs is not None and system.discrete:
        smooth = sampled(inputs, t)
    elif inputs is not None:
        spans = intervals(t, inputs)
        if len(spans) > 1 and not late:
            raise NotEvaluable("the input jumps later than at the start")
        start = x0 + sum((B * weights for _, weights in impulses(inputs, t)), sp.zeros(system.order, 1))
        smooth = spans[-1].smooth(inputs, t)
    symbols = free_symbols([system.A, B, system.C, D, start, *([smooth] if smooth is not None else [])]) - {t}
    return [
        (point, _in_numbers(point, (system.A, B, system.C, D, start), smooth, t)) for point in admissible(symbols, 2)
    ]


def _in_numbers(point: Mapping[Any, complex], matrices: Sequence[Any], inputs: Any, t: Any) -> Simulation:
    here = Environment.at([dict(point)])
    A, B, C, D, x0 = (value_of(M, here).value[0] if 0 not in M.shape else np.zeros(M.shape) for M in matrices)
    known = {symbol: sp.Float(complex(value).real) for symbol, value in point.items()}
    own = inputs.xreplace(known) if inputs is not None else None
    return Simulation(A, B, C, D, x0, own, t, point, (*matrices, inputs))


def final_output(simulation: Simulation, *, discrete: bool) -> Array:
    """Return lim y (p×1): the equilibrium of a stable system for the limit of its input, else what y settles to.

    States that the output does not see are left out: they may grow without end. Raises NotEvaluable.
    """
    simulation = _seen(simulation)
    eigenvalues = np.linalg.eigvals(simulation.A)  # none, where nothing that is seen is excited
    margin = -np.max(np.abs(eigenvalues) - 1 if discrete else eigenvalues.real, initial=-np.inf)
    if margin < 1e-9:
        return _settled(simulation, discrete=discrete)
    if simulation.inputs is not None:
        late = np.array([400.0, 500.0]) if not discrete else np.array([4000.0, 4001.0])
        u = simulation.input_at(late)
        if np.max(np.abs(u[0] - u[1]), initial=0.0) > 1e-12 * (1 + np.max(np.abs(u), initial=0.0)):
            return _settled(simulation, discrete=discrete)
        constant = u[1][:, None]
    else:
        constant = np.zeros((simulation.B.shape[1], 1))
    n = len(simulation.A)
    x = np.linalg.solve((np.eye(n) if discrete else np.zeros((n, n))) - simulation.A, simulation.B @ constant)
    return np.asarray(simulation.C @ x + simulation.D @ constant)


def _seen(simulation: Simulation) -> Simulation:
    """Return the system that has the same output without states that nothing excites or no output sees."""
    moved = simulation.x0.reshape(len(simulation.A), -1)
    if simulation.inputs is not None:
        moved = np.hstack([moved, simulation.B])
    excited = _restricted(simulation, _invariant(simulation.A, moved))
    return _restricted(excited, _invariant(excited.A.T, excited.C.T))


def _restricted(simulation: Simulation, basis: Array) -> Simulation:
    """Return the system in coordinates along the columns of an orthonormal basis (n×r); as it is where r = n."""
    if basis.shape[0] == basis.shape[1]:
        return simulation  # turned round, a multiple eigenvalue would be blurred
    V = basis.T
    A, B, C = V @ simulation.A @ basis, V @ simulation.B, simulation.C @ basis
    return replace(simulation, A=A, B=B, C=C, x0=V @ simulation.x0)


def _invariant(A: Array, start: Array) -> Array:
    """Return an orthonormal basis of the least subspace that A leaves in itself and that holds the columns of `start`.

    The whole space where rounding leaves the least one undecided; no column where `start` is zero.
    """
    n = len(A)
    if not np.any(start):
        return np.zeros((n, 0))
    scale = max(float(np.max(np.abs(A), initial=0.0)), 1.0)
    columns = [start]
    for _ in range(n - 1):
        columns.append(A @ columns[-1] / scale)
    basis, sizes, _ = np.linalg.svd(np.hstack(columns))
    V = basis[:, : int(np.sum(sizes > SEEN * np.max(sizes, initial=0.0)))]
    decided = V.shape[1] > 0 and float(np.max(np.abs(A @ V - V @ (V.T @ A @ V)))) <= SEEN * scale
    return np.asarray(V if decided else np.eye(n))


def _settled(simulation: Simulation, *, discrete: bool) -> Array:
    """Return y at a late time, if it has stopped changing by then."""
    if discrete:
        late = samples_of_output(simulation, 2000)[[1500, 1999]]
    else:
        slow, fast = simulation.rates
        last = 2 * SETTLED / (slow or fast / 10)
        steps = int(np.ceil(4.0 * last * fast)) + 1
        if steps > MOST_STEPS:
            raise NotEvaluable("the modes are too far apart for a simulation")
        if last * float(np.max(np.linalg.eigvals(simulation.A).real)) > 12.0:
            raise NotEvaluable("rounding grows with an unstable mode before the output has settled")
        x = _steps(simulation, simulation.x0, 0.0, last / steps, steps)
        ends = [steps * 3 // 4, steps]
        u = simulation.input_at(np.array([last / steps * end for end in ends]))
        late = np.array(
            [
                (simulation.C @ x[end] + simulation.D @ each[:, None])[:, 0].real
                for end, each in zip(ends, u, strict=True)
            ]
        )
    if not np.all(np.isfinite(late)) or np.max(np.abs(late[0] - late[1])) > 1e-8 * (1 + np.max(np.abs(late))):
        raise NotEvaluable("the simulated output does not settle")
    return np.asarray(late[1][:, None])


def samples_of_output(simulation: Simulation, count: int) -> Array:
    """Return y(0) … y(count − 1) of a discrete system (count×p)."""
    u = simulation.input_at(np.arange(count).astype(float))
    x, found = simulation.x0, []
    with np.errstate(all="ignore"):  # an unstable mode may overflow
        for k in range(count):
            found.append((simulation.C @ x + simulation.D @ u[k][:, None])[:, 0])
            x = simulation.A @ x + simulation.B @ u[k][:, None]
    return np.array(found).real


def largest_output(simulation: Simulation) -> tuple[float, float]:
    """Return (t, y) of the first largest |y| of a scalar output in continuous time. Raises NotEvaluable."""
    slow, fast = simulation.rates
    last = SETTLED / slow if slow else 30.0 / fast
    steps = int(np.ceil(4.0 * last * fast)) + 1
    if steps > MOST_STEPS:
        raise NotEvaluable("the modes are too far apart for a simulation")
    h = last / steps
    x = _steps(simulation, simulation.x0, 0.0, h, steps)
    times = h * np.arange(steps + 1)
    y = np.array([float((simulation.C @ x[j])[0, 0].real) for j in range(steps + 1)])
    y = y + (simulation.input_at(times) @ simulation.D.T).real[:, 0]
    tops = [j for j in range(1, steps) if abs(y[j]) >= abs(y[j - 1]) and abs(y[j]) >= abs(y[j + 1])]
    spans = [(abs(y[j]), j - 1, 2 * h) for j in tops]
    if abs(_output(simulation, simulation.x0, 0.0, h * EARLY)) > abs(y[0]) >= abs(y[1]):
        spans.append((abs(y[0]), 0, h))  # it rises at first and falls within the first step
    if not spans:
        raise NotEvaluable("the simulated output has no peak")
    highest = max(size for size, _, _ in spans)
    refined = [_refined(simulation, x[j], times[j], span) for size, j, span in spans if size > 0.99 * highest]
    largest = max(abs(value) for _, value in refined)
    return next((time, value) for time, value in refined if abs(value) > largest * (1 - 1e-10))


def _steps(simulation: Simulation, x0: Array, start: float, h: float, count: int) -> list[Array]:
    """Return x at start + j h, j = 0 … count."""
    from scipy.linalg import expm  # noqa: PLC0415

    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    inside, weights = h * (nodes + 1) / 2, h * weights / 2
    E = expm(simulation.A * h)
    pulls = [w * expm(simulation.A * (h - s)) @ simulation.B for s, w in zip(inside, weights, strict=True)]
    times = (start + h * np.arange(count))[:, None] + inside[None, :]
    u = simulation.input_at(times.reshape(-1)).reshape(count, NODES, -1)
    x = [x0]
    for j in range(count):
        forced = sum((pull @ u[j, q][:, None] for q, pull in enumerate(pulls)), np.zeros_like(x0))
        x.append(E @ x[-1] + forced)
    return x


def _refined(simulation: Simulation, x: Array, start: float, span: float) -> tuple[float, float]:
    """Return (t, y) of the largest |y| in a span, by the polynomial through y at Chebyshev's nodes."""

    def output(times: Array) -> Array:
        return np.array([_output(simulation, x, start, float(time)) for time in np.atleast_1d(times)])

    curve = np.polynomial.Chebyshev.interpolate(output, 16, domain=[start, start + span])
    roots = [complex(root) for root in np.asarray(curve.deriv().roots())]
    stationary = [root.real for root in roots if abs(root.imag) < 1e-6 * span and start < root.real < start + span]
    if not stationary:
        raise NotEvaluable("the peak was not found between the steps")
    best = max(stationary, key=lambda time: abs(float(curve(time))))
    return best, float(output(np.array([best]))[0])


def _output(simulation: Simulation, x: Array, start: float, time: float) -> float:
    """y at a time, from the state x at the start."""
    here = _steps(simulation, x, start, max(time - start, 1e-300), 1)[1]
    through = simulation.D @ simulation.input_at(np.array([time]))[0][:, None]
    return float((simulation.C @ here + through)[0, 0].real)


def difference(wanted: Any, found: Any, point: Mapping[Any, complex]) -> float:
    """Return the largest difference of numbers and a matrix at a point, relative to the largest of the numbers."""
    here = value_of(found, Environment.at([dict(point)]))
    value, magnitude = here.value[0], np.broadcast_to(here.magnitude, here.value.shape)[0]
    numbers = np.asarray(wanted).reshape(value.shape) if np.size(wanted) == value.size else np.full(value.shape, np.inf)
    gap = np.maximum(np.abs(value - numbers) - SAFETY * DOUBLE.eps * magnitude, 0.0)
    return float(np.max(gap) / max(FLOOR, float(np.max(np.abs(numbers)))))
