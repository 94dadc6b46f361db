"""What a sampled PID controller answers to a pulse of the error, by the sums and differences that define it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from solver.stated import Stated
from solver.stated.transforms import inverse_z

SAMPLES = 6
"""So many tell a controller of second order from any other."""


def pid_samples(gains: Sequence[Any], T: Any, rule: str) -> list[Any]:
    """Return u(0), …, u(5) for e(0) = 1 and e(k) = 0 else: areas of strips are summed, differences divided by T."""
    K_p, K_i, K_d = gains
    e = [sp.Integer(1), *[sp.Integer(0)] * (SAMPLES - 1)]
    found, area = [], sp.Integer(0)
    for k, now in enumerate(e):
        before = e[k - 1] if k else sp.Integer(0)
        height = {"backward": now, "forward": before, "tustin": (now + before) / 2}[rule]
        area = area + height * T
        found.append(K_p * now + K_i * area + K_d * (now - before) / T)
    return found


def controller_samples(controller: Any, z: Any) -> Iterator[Stated]:
    """Yield the samples of the pulse response of a controller in z."""
    for k in range(SAMPLES):
        yield inverse_z(controller, z, sp.Integer(k))


def recursion_samples(coefficients: Sequence[Any]) -> list[Any]:
    """Return u(0), …, u(5) of u(k) = u(k − 1) + q₀ e(k) + q₁ e(k − 1) + … for the same pulse."""
    found, last = [], sp.Integer(0)
    for k in range(SAMPLES):
        last = last + (coefficients[k] if k < len(coefficients) else 0)
        found.append(last)
    return found
