"""Equations of motion against the action: of a closed path sampled in time, differentiated by every sample.

Positions of bodies are differentiated along the path as trigonometric polynomials, the action by a complex step: no
formula of a derivative is formed. On paths through any position, velocity and acceleration this gives what is zero
along a motion; the energies, inertias and Christoffel symbols are found from the same samples.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from random import Random
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols

NODES = 64
STEP = 1e-8
"""A complex step is wrong by its square, and nothing is subtracted; far smaller ones are taken for rounding."""
RESOLVED = 1e-11
TRIALS = 3
TIMES = 2 * np.pi * np.arange(NODES) / NODES

Jets = Mapping[str, Array]
"""Of each function of time its value, first and second derivative (P, 3) at the beginning of P paths."""


def _differentiation() -> Array:
    """The matrix that differentiates samples of a trigonometric polynomial."""
    i, j = np.indices((NODES, NODES))
    apart = np.where(i == j, np.pi, TIMES[i] - TIMES[j])
    return np.where(i == j, 0.0, 0.5 * (-1.0) ** (i - j) / np.tan(apart / 2))


D = _differentiation()


class Mechanics:
    """What a system given by its energies does, at one point of its parameters."""

    def __init__(self, system: Any, point: Mapping[Any, complex]) -> None:
        self.system = system
        self.point = dict(point)
        self.least = self.speed = 4.0  # of the paths: in less time less of the system is seen
        self.names = (*system.coordinates, *system.inputs, *system.multipliers)
        self.symbols = {(name, k): system.symbol((name, k)) for name in self.names for k in range(4)}

    @cached_property
    def moved(self) -> bool:
        """Whether inputs move bodies or stand in energies, so that energy is not kept by the forces alone."""
        inputs = {self.symbols[name, k] for name in self.system.inputs for k in range(4)}
        s = self.system
        of_bodies = [e for b in s.bodies for e in (b.mass, *b.position, b.angle)]
        of_springs = [e for each in s.springs for e in (each.stiffness, each.length, each.rest)]
        given = (s.kinetic, s.potential, *of_bodies, *of_springs, *s.constraints)
        return bool(inputs & free_symbols([each for each in given if each is not None]))

    def value(self, expression: Any, values: Mapping[Any, Array], shape: tuple[int, ...]) -> Array:
        """Return an expression at the values of the functions of time, arrays of one shape."""
        count = int(np.prod(shape))
        full = {symbol: np.full(count, value, dtype=complex) for symbol, value in self.point.items()}
        full |= {symbol: np.asarray(value, dtype=complex).reshape(-1) for symbol, value in values.items()}
        found = value_of(expression, Environment(full, count)).value
        return np.broadcast_to(found, (count,)).reshape(shape)

    def path(self, jets: Jets) -> dict[Any, Array]:
        """Return the functions of time and their velocities on closed paths (P, nodes) that start with these jets."""
        bends = [float(np.abs(jet[:, 2:]).max(initial=0.0)) for jet in jets.values()]
        self.speed = w = self.least * max(1.0, *np.sqrt(bends))
        sin, cos = np.sin(TIMES) / w, np.cos(TIMES) / w**2
        found: dict[Any, Array] = {}
        for name, jet in jets.items():
            at, speed, bend = (jet[:, k : k + 1] for k in range(3))
            found[self.symbols[name, 0]] = at + speed * sin + bend * (1 / w**2 - cos)
        return self._with_velocities(found)

    def _with_velocities(self, found: dict[Any, Array]) -> dict[Any, Array]:
        order = {0: found}
        for k in (1, 2):
            order[k] = {
                self.symbols[name, k]: self.rate(order[k - 1][self.symbols[name, k - 1]])
                for name in (*self.system.coordinates, *self.system.inputs)
                if self.symbols[name, k - 1] in order[k - 1]
            }
        return {**order[0], **order[1], **order[2]}

    def settle(self, jets: Jets) -> None:
        """Let the paths be short enough for their samples: the energies are trigonometric polynomials on them."""
        for _ in range(8):
            path = self.path(jets)
            spectrum = np.abs(np.fft.fft(np.concatenate([self.kinetic(path), self.potential(path)]), axis=1))
            if np.all(spectrum[:, NODES // 4 : -NODES // 4] <= RESOLVED * (1 + spectrum.max())):
                return
            self.least *= 2

    def kinetic(self, path: Mapping[Any, Array]) -> Array:
        """T along the paths: of bodies by their positions, differentiated as functions of time."""
        shape = next(iter(path.values())).shape
        total = np.zeros(shape, dtype=complex)
        if self.system.kinetic is not None:
            total = total + self.value(self.system.kinetic, path, shape)
        for body in self.system.bodies:
            for inertia, moved in [*((body.mass, x) for x in body.position), (body.inertia, body.angle)]:
                if moved is not None:
                    rate = self.rate(self.value(moved, path, shape))
                    total = total + self.value(inertia, path, shape) * rate**2 / 2
        return total

    def rate(self, samples: Array) -> Array:
        """The derivative along the paths; real and imaginary parts apart, so that a complex step stays clean."""
        rates = samples.real @ D.T
        return self.speed * (rates + 1j * (samples.imag @ D.T) if np.iscomplexobj(samples) else rates)

    def potential(self, path: Mapping[Any, Array]) -> Array:
        """V along the paths."""
        shape = next(iter(path.values())).shape
        s = self.system
        terms = [] if s.potential is None else [self.value(s.potential, path, shape)]
        if s.gravity is not None:
            g = self.value(s.gravity, path, shape)
            terms += [
                self.value(b.mass, path, shape) * g * self.value(b.position[1], path, shape)
                for b in s.bodies if b.position
            ]  # fmt: skip
        for spring in s.springs:
            k, length, rest = (self.value(e, path, shape) for e in (spring.stiffness, spring.length, spring.rest))
            terms.append(k * (length - rest) ** 2 / 2)
        return sum(terms, np.zeros(shape, dtype=complex))

    def constraints(self, path: Mapping[Any, Array]) -> list[Array]:
        """The constraints along the paths."""
        shape = next(iter(path.values())).shape
        return [self.value(each, path, shape) for each in self.system.constraints]

    def equations(self, jets: Jets) -> Array:
        """Return what is zero along a motion (P, n), with any jets: −∂S/∂q + ∂D/∂q' − Q."""
        return -self.pull(jets) - self.forces(jets)

    def pull(self, jets: Jets) -> Array:
        """The derivatives (P, n) of the action T − V + λ c by the position at the start of each path."""
        n, P = len(self.system.coordinates), len(next(iter(jets.values())))
        repeated = {name: np.repeat(jet, n, axis=0) for name, jet in jets.items()}
        base = {symbol: value for symbol, value in self.path(repeated).items() if symbol in self._positions}
        for i, name in enumerate(self.system.coordinates):
            moved = base[self.symbols[name, 0]].astype(complex)
            moved[i::n, 0] += 1j * STEP
            base[self.symbols[name, 0]] = moved
        path = self._with_velocities(base)
        L = self.kinetic(path) - self.potential(path)
        for multiplier, c in zip(self.system.multipliers, self.constraints(path), strict=True):
            L = L + path[self.symbols[multiplier, 0]] * c
        return (L.imag.sum(axis=1) / STEP).reshape(P, n)

    @cached_property
    def _positions(self) -> set[Any]:
        return {self.symbols[name, 0] for name in self.names}

    def forces(self, jets: Jets) -> Array:
        """The generalized forces (P, n), friction among them."""
        P = len(next(iter(jets.values())))
        now = {self.symbols[name, k]: jet[:, k] for name, jet in jets.items() for k in range(3)}
        columns = []
        for name in self.system.coordinates:
            force = np.zeros(P, dtype=complex)
            if name in self.system.forces:
                force = force + self.value(self.system.forces[name], now, (P,))
            if self.system.dissipation is not None:
                speed = self.symbols[name, 1]
                stepped = {**now, speed: now[speed] + 1j * STEP}
                force = force - self.value(self.system.dissipation, stepped, (P,)).imag / STEP
            columns.append(force.real)
        return np.stack(columns, axis=1)

    # Inertias

    def at_speeds(self, position: Array, speeds: Array) -> Array:
        """T (P,) at positions (P, n) with velocities (P, n)."""
        path = self.path(self._jets(position, speeds))
        return self.kinetic(path)[:, 0]

    def _jets(self, position: Array, speeds: Array) -> dict[str, Array]:
        still = np.zeros(len(position))
        return {
            name: np.stack([position[:, i], speeds[:, i], still], axis=1)
            for i, name in enumerate(self.system.coordinates)
        }

    def inertia(self, position: Array) -> Array:
        """M (P, n, n) at positions (P, n): T of sums of unit velocities less that of each."""
        n, P = position.shape[1], len(position)
        unit, still = np.eye(n), np.zeros(n)
        single = self._energies(position, [*unit, still])
        pairs = self._energies(position, [unit[i] + unit[j] for i in range(n) for j in range(n)])
        sums = single[:, :n, None] + single[:, None, :n] - single[:, n, None, None]
        return pairs.reshape(P, n, n) - sums

    def linear(self, position: Array) -> Array:
        """The coefficients (P, n) of the terms of T that are linear in the velocities."""
        unit = np.eye(position.shape[1])
        both = self._energies(position, [*unit, *-unit])
        n = len(unit)
        return (both[:, :n] - both[:, n:]) / 2

    def _energies(self, position: Array, speeds: Sequence[Array]) -> Array:
        P, k = len(position), len(speeds)
        every = np.tile(np.array(speeds), (P, 1))
        return self.at_speeds(np.repeat(position, k, axis=0), every).reshape(P, k)

    def coriolis(self, position: Array, speed: Array) -> Array:
        """C (n, n) by Christoffel symbols at a position (n,) and velocity (n,)."""
        n = len(position)
        stepped = position + 1j * STEP * np.eye(n)
        by = self.inertia(stepped).imag / STEP  # by[k, i, j] = ∂M_ij/∂q_k
        turning = self.linear(stepped).imag / STEP  # turning[j, i] = ∂a_i/∂q_j
        symbols = (np.einsum("kij->ijk", by) + np.einsum("jik->ijk", by) - np.einsum("ijk->ijk", by)) / 2
        return symbols @ speed + turning.T - turning

    def weight(self, position: Array) -> Array:
        """∂(V − T₀)/∂q (n,), T₀ the energy without velocities."""
        stepped = position + 1j * STEP * np.eye(len(position))
        still = self._jets(stepped, np.zeros(stepped.shape))
        path = self.path(still)
        return (self.potential(path) - self.kinetic(path))[:, 0].imag / STEP


def mechanics_of(system: Any) -> Iterator[tuple[Mechanics, Random]]:
    """Yield the system at some points of its parameters, with a source of random numbers."""
    symbols = [each for each in system.parameters if each not in system.jets]
    source, random = PointSource(symbols), Random(SEED)  # noqa: S311 - nothing secret
    for _ in range(TRIALS if symbols else 2):
        yield Mechanics(system, source.draw()), random
