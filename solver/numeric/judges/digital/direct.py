"""Direct design judged by numbers: the plant sampled by scipy, the target by its definition, the loop simulated."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.numeric.judges.digital.sampled import MANY, Sampling, stated_pulse

SAMPLES = 60
NEAR = 1e-6
EDGE = 1e-9
"""Roots of the characteristic polynomial must be so far inside the unit circle."""
FAR = (10**15, 10**16)


@dataclass(frozen=True)
class DirectQuestion:
    """G as numerator and denominator in z, or A, B, C, D of a plant held for `T`; the target, or poles and zeros."""

    plant: tuple[Any, ...]
    T: Any
    target: Any
    poles: tuple[Any, ...]
    zeros: tuple[Any, ...]

    @property
    def sampled(self) -> bool:
        """Whether the plant is continuous."""
        return len(self.plant) > 2


def direct_plant(question: DirectQuestion, z: Any) -> Any:
    """Return G(z) as a matrix of one entry: as given, or by the matrix exponential of a held plant."""
    if question.sampled:
        return stated_pulse(Sampling(question.plant, question.T), z)
    return sp.ImmutableMatrix([[question.plant[0] / question.plant[1]]])


def wanted_loop(question: DirectQuestion, z: Any) -> Any:
    """Return T(z): as given, or K Π(z − zero)/(Π(z − pole) zᵐ) with T(1) = 1, no earlier than the plant."""
    if question.target is not None:
        return question.target
    m = max(0, len(question.zeros) + _lag(question, z) - len(question.poles))
    above, below = (sp.Mul(*(z - each for each in roots)) for roots in (question.zeros, question.poles))
    gain = (below / above).xreplace({z: sp.Integer(1)})
    return gain * above / (below * z**m)


def _lag(question: DirectQuestion, z: Any) -> int:
    """By how many steps the plant is late: how fast G falls at large z."""
    G = direct_plant(question, z)
    (point,) = admissible(free_symbols(G) - {z}, 1)
    near, far = (complex(value_of(G, Environment.at([{**point, z: MANY.number(x)}], MANY)).value[0][0, 0]) for x in FAR)
    return round(float(np.log10(abs(near / far))))


def loop_fault(question: DirectQuestion, controller: Any, z: Any) -> str:
    """Return what is wrong with a controller (numbers all): it is not causal, a mode does not decay, y is not T's.

    The loop is followed from sample to sample after a step of the reference.
    """
    D = _fraction(sp.fraction(sp.cancel(controller)), z)
    G = _held(question) if question.sampled else _fraction(question.plant, z)
    if len(D[0]) > len(D[1]):
        return "the controller is not causal"
    characteristic = np.polyadd(np.polymul(D[0], G[0]), np.polymul(D[1], G[1]))
    if np.any(np.abs(np.roots(characteristic)) > 1 - EDGE):
        return "a mode of the loop does not decay"
    wanted = _follow([_fraction(sp.fraction(sp.cancel(wanted_loop(question, z))), z)], closed=False)
    found = _follow([D, G], closed=True)
    return "" if np.allclose(found, wanted, rtol=NEAR, atol=NEAR) else "the output is not that of the target"


def _fraction(sides: tuple[Any, ...], z: Any) -> tuple[Array, Array]:
    above, below = (_numbers(side, z) for side in sides)
    return above, below


def _numbers(polynomial: Any, z: Any) -> Array:
    return np.array([float(sp.N(c, 30)) for c in sp.Poly(sp.expand(polynomial), z).all_coeffs()])


def _held(question: DirectQuestion) -> tuple[Array, Array]:
    """Numerator and denominator of the held plant, by scipy."""
    from scipy.signal import cont2discrete, ss2tf  # noqa: PLC0415 - 300 ms that most checks do not need

    matrices: Any = tuple(np.array(M.evalf(30).tolist(), dtype=float) for M in question.plant)
    A, B, C, D = cont2discrete(matrices, float(sp.N(question.T)), method="zoh")[:4]
    above, below = ss2tf(A, B, C, D)
    above = np.ravel(above)
    first = next(i for i, c in enumerate(above) if abs(c) > 1e-12 * np.max(np.abs(above)))
    return above[first:], below


def _follow(blocks: list[tuple[Array, Array]], *, closed: bool) -> Array:
    """The last signal of blocks in series, driven by a step, or by what a step leaves of that signal."""
    signals = [np.zeros(SAMPLES) for _ in range(len(blocks) + 1)]
    weights = [(np.concatenate([np.zeros(len(b) - len(a)), a]) / b[0], b / b[0]) for a, b in blocks]
    through = float(np.prod([a[0] for a, _ in weights]))
    for k in range(SAMPLES):
        drifts = [
            _before(a, x, k) - _before(b, y, k) for (a, b), x, y in zip(weights, signals, signals[1:], strict=False)
        ]
        free = 0.0
        for (a, _), drift in zip(weights, drifts, strict=True):
            free = a[0] * free + drift
        signals[0][k] = (1 - free) / (1 + through) if closed else 1.0
        for j, ((a, _), drift) in enumerate(zip(weights, drifts, strict=True)):
            signals[j + 1][k] = a[0] * signals[j][k] + drift
    return signals[-1]


def _before(weights: Array, signal: Array, k: int) -> float:
    """What values before k add to one at k."""
    return float(sum(weights[i] * signal[k - i] for i in range(1, min(k + 1, len(weights)))))
