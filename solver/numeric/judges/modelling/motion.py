"""Equations of motion, energies and inertias as submitted, against the mechanics of the system."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from random import Random
from typing import Any, NamedTuple

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.points import free_symbols
from solver.numeric.judges.modelling.mechanics import STEP, Mechanics, mechanics_of

NEWTON_STEPS = 60


class Balance(NamedTuple):
    """How far each equation is from being a combination of those of the action, and whether they are independent."""

    residuals: list[float]
    independent: bool


class _Place(NamedTuple):
    """A system with its parameters, the jets of several motions through one position, and values by names."""

    mechanics: Mechanics
    jets: dict[str, Array]

    def value(self, expression: Any) -> Array:
        """Return an expression for each motion; nan where it has names that mean nothing here."""
        m, count = self.mechanics, len(next(iter(self.jets.values())))
        named = {str(symbol): np.full(count, value, dtype=complex) for symbol, value in m.point.items()}
        named |= {str(m.symbols[name, k]): jet[:, k] for name, jet in self.jets.items() for k in range(3)}
        named |= {name.replace("lambda", "lamda"): value for name, value in named.items()}  # as readers spell it
        inside = free_symbols(expression)
        if any(str(symbol) not in named for symbol in inside):
            return np.full(count, np.nan)
        return Mechanics(m.system, {}).value(expression, {each: named[str(each)] for each in inside}, (count,))


def _place(mechanics: Mechanics, random: Random, count: int) -> _Place:
    """Motions through one random position, which satisfies the constraints."""
    names, system = mechanics.names, mechanics.system
    jets = {name: np.array([[random.uniform(-1.5, 1.5) for _ in range(3)] for _ in range(count)]) for name in names}
    position = np.array([random.uniform(0.3, 1.4) * random.choice((-1, 1)) for _ in system.coordinates])
    if system.constraints:
        position = _bound(mechanics, position, jets)
    for i, name in enumerate(system.coordinates):
        jets[name][:, 0] = position[i]
    mechanics.settle(jets)
    return _Place(mechanics, jets)


def _bound(mechanics: Mechanics, position: Array, jets: Mapping[str, Array]) -> Array:
    """A position on the constraints near one, by Newton's method with least squares."""
    n, step = len(position), STEP
    still = {name: np.tile(jet[:1], (n + 1, 1)) for name, jet in jets.items()}

    def at(points: Array) -> Array:
        for i, name in enumerate(mechanics.system.coordinates):
            still[name] = np.stack([points[:, i], 0 * points[:, i], 0 * points[:, i]], axis=1)
        path = mechanics.path(still)
        return np.stack([c[:, 0] for c in mechanics.constraints(path)])

    for _ in range(NEWTON_STEPS):
        values = at(np.vstack([position, position + 1j * step * np.eye(n)]))
        slope, miss = values[:, 1:].imag / step, values[:, 0].real
        if np.max(np.abs(miss)) < 1e-13:
            break
        position = position - np.linalg.lstsq(slope, miss, rcond=None)[0]
    return position


def equation_balance(system: Any, expressions: Sequence[Any]) -> Balance:
    """Compare equations with those of the action on motions through some positions.

    Each must be a sum of multiples of these, which depend on the position only; constraints must hold where the
    system's do, and nowhere near.
    """
    n, r = len(system.coordinates), len(system.constraints)
    moving, bound = _sorted(system, expressions)
    residuals = [0.0] * len(expressions)
    if (len(moving), len(bound)) != (n, r):
        return Balance([np.inf] * len(expressions), independent=False)
    independent = True
    for mechanics, random in mechanics_of(system):
        place = _place(mechanics, random, 2 * (n + r) + 4)
        E = mechanics.equations(place.jets)
        factors = []
        for i in moving:
            values = place.value(expressions[i])
            K = np.linalg.lstsq(E, values, rcond=None)[0] if np.all(np.isfinite(values)) else np.full(n, np.nan)
            residuals[i] = max(residuals[i], _distance(E @ K, values))
            factors.append(K)
        for i in bound:
            residuals[i] = max(residuals[i], float(np.max(np.abs(place.value(expressions[i])))))
        independent &= _is_regular(np.array(factors)) and _bind(mechanics, random, [expressions[i] for i in bound])
    return Balance([value if np.isfinite(value) else np.inf for value in residuals], independent)


def _sorted(system: Any, expressions: Sequence[Any]) -> tuple[list[int], list[int]]:
    """The places of equations of motion, and of constraints: those in coordinates alone, as many as there are."""
    places = {str(system.symbol((name, 0))) for name in system.coordinates} | {str(p) for p in system.parameters}
    alone = [i for i, e in enumerate(expressions) if {str(s) for s in free_symbols(e)} <= places]
    bound = alone if system.constraints else []
    return [i for i in range(len(expressions)) if i not in bound], bound


def _bind(mechanics: Mechanics, random: Random, constraints: Sequence[Any]) -> bool:
    """Whether constraints as submitted are as many at a position as those of the system, and hold nowhere near."""
    if not constraints:
        return True
    place = _place(mechanics, random, 1)
    names = mechanics.system.coordinates
    rows = []
    for name in names:
        moved = {each: jet.astype(complex) for each, jet in place.jets.items()}
        moved[name][:, 0] += 1j * STEP
        rows.append([_Place(mechanics, moved).value(c)[0].imag / STEP for c in constraints])
    singular = np.linalg.svd(np.array(rows), compute_uv=False)
    return len(singular) == len(constraints) and bool(singular[-1] > 1e-9 * max(1.0, singular[0]))


def _is_regular(K: Array) -> bool:
    """Whether a square matrix has an inverse."""
    if not np.all(np.isfinite(K)):
        return False
    sizes = np.abs(K).max(axis=1, keepdims=True)
    if np.any(sizes == 0):
        return False
    singular = np.linalg.svd(K / sizes, compute_uv=False)
    return bool(singular[-1] > 1e-9)


def energy_residual(system: Any, expressions: Sequence[Any]) -> float | None:
    """Return how far d(T + V)/dt is from the power of the forces less that of friction, along motions of the equations.

    None where that is no law of the system: inputs move its bodies, or T is not a sum of squares of velocities.
    """
    n, worst = len(system.coordinates), 0.0
    moving, _ = _sorted(system, expressions)
    if len(moving) != n:
        return None
    for mechanics, random in mechanics_of(system):
        place = _place(mechanics, random, 3)
        if mechanics.moved or not _of_squares(mechanics, place):
            return None
        if not _accelerated(place, [expressions[i] for i in moving]):
            return None
        mechanics.settle(place.jets)
        path = mechanics.path(place.jets)
        rates = [
            mechanics.rate(each)[:, 0].real
            for each in (mechanics.kinetic(path) + mechanics.potential(path), *mechanics.constraints(path))
        ]
        speeds = np.stack([place.jets[name][:, 1] for name in system.coordinates], axis=1)
        power = np.sum(mechanics.forces(place.jets) * speeds, axis=1)
        for name, rate in zip(system.multipliers, rates[1:], strict=True):
            power = power + place.jets[name][:, 0] * rate
        bends = max(float(np.abs(place.jets[name][:, 2]).max()) for name in system.coordinates)
        worst = max(worst, _distance(rates[0], power) / (1 + bends))  # parts of the rate that cancel are as large
    return worst if np.isfinite(worst) else np.inf


def _of_squares(mechanics: Mechanics, place: _Place) -> bool:
    """Whether T is a form of degree two in the velocities."""
    position, speed = (
        np.stack([place.jets[name][:, k] for name in mechanics.system.coordinates], axis=1) for k in (0, 1)
    )
    once, twice = (mechanics.at_speeds(position, c * speed).real for c in (1, 2))
    return bool(np.allclose(twice, 4 * once, rtol=1e-9, atol=1e-9))


def _accelerated(place: _Place, expressions: Sequence[Any]) -> bool:
    """Put the accelerations that the equations give into the jets; whether they give any."""
    names = place.mechanics.system.coordinates
    n, count = len(names), len(next(iter(place.jets.values())))
    columns = []
    for k in range(n + 1):
        for i, name in enumerate(names):
            place.jets[name][:, 2] = 1.0 if i == k else 0.0
        columns.append(np.stack([place.value(each) for each in expressions], axis=1))
    rest = columns[n]
    for p in range(count):
        M = np.stack([columns[k][p] - rest[p] for k in range(n)], axis=1).real
        if not np.all(np.isfinite(M)) or np.linalg.cond(M) > 1e9:
            return False
        found = np.linalg.solve(M, -rest[p].real)
        for i, name in enumerate(names):
            place.jets[name][p, 2] = found[i]
    return True


def energy_of_motion_residual(system: Any, name: str, value: Any) -> float:
    """Return how far a kinetic or potential energy, or their difference, is from the bodies'; V up to a constant."""
    worst = 0.0
    for mechanics, random in mechanics_of(system):
        found, wanted = [], []
        for _ in range(3):
            place = _place(mechanics, random, 2)
            path = mechanics.path(place.jets)
            T, V = mechanics.kinetic(path)[:, 0], mechanics.potential(path)[:, 0]
            wanted.append({"kinetic": T, "potential": V, "lagrangian": T - V}[name])
            found.append(place.value(value))
        ours, theirs = np.concatenate(wanted), np.concatenate(found)
        if name != "kinetic":
            ours, theirs = ours - ours[0], theirs - theirs[0]
        worst = max(worst, _distance(theirs, ours))
    return worst if np.isfinite(worst) else np.inf


def form_residual(system: Any, name: str, value: Any) -> float:
    """Return how far M, C or the gravity vector is from that of the energies at random positions and velocities."""
    worst, n = 0.0, len(system.coordinates)
    for mechanics, random in mechanics_of(system):
        place = _place(mechanics, random, 1)
        position, speed = (np.array([place.jets[each][0, k] for each in system.coordinates]) for k in (0, 1))
        wanted = _form(mechanics, name, position, speed)
        if tuple(value.shape) not in {wanted.shape, *([(1, n)] if name == "gravity" else [])}:
            return np.inf
        found = np.array([place.value(entry)[0] for entry in value]).reshape(wanted.shape)
        worst = max(worst, _distance(found, wanted))
    return worst if np.isfinite(worst) else np.inf


def _form(mechanics: Mechanics, name: str, position: Array, speed: Array) -> Array:
    if name == "M":
        return np.asarray(mechanics.inertia(position[None])[0].real)
    return mechanics.coriolis(position, speed) if name == "C" else mechanics.weight(position)[:, None]


def _distance(found: Array, wanted: Array) -> float:
    size = max(1.0, float(np.max(np.abs(wanted), initial=0.0)))
    distance = float(np.max(np.abs(found - wanted), initial=0.0)) / size
    return distance if np.isfinite(distance) else np.inf
