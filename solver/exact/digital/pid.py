"""A PID controller as a sampled one: its integral by a rule of quadrature, its derivative by the difference backward.

Source: K. J. Åström and B. Wittenmark, Computer-Controlled Systems, §8.5.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp


@dataclass(frozen=True)
class DiscretePid:
    """K_p + K_i `integral` + K_d `derivative` = `controller`, in z.

    `weights` are those of e(k) and e(k − 1) in a step of the integral; `coefficients` are q₀, q₁, q₂ of
    u(k) = u(k − 1) + q₀ e(k) + q₁ e(k − 1) + q₂ e(k − 2).
    """

    weights: tuple[sp.Expr, sp.Expr]
    integral: sp.Expr
    derivative: sp.Expr
    controller: sp.Expr
    coefficients: tuple[sp.Expr, sp.Expr, sp.Expr]


def integral_weights(rule: str, T: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return what e(k) and e(k − 1) add to the integral: by "backward", "forward" or "tustin"."""
    zero = sp.Integer(0)
    return {"backward": (T, zero), "forward": (zero, T), "tustin": (T / 2, T / 2)}[rule]


def discrete_pid(gains: Sequence[sp.Expr], T: sp.Expr, rule: str, z: sp.Symbol) -> DiscretePid:
    """Return the sampled controller of K_p + K_i/s + K_d s for the sampling period T."""
    K_p, K_i, K_d = gains
    new, old = weights = integral_weights(rule, T)
    q = tuple(sp.expand(each) for each in (K_p + K_i * new + K_d / T, -K_p + K_i * old - 2 * K_d / T, K_d / T))
    integral = sp.factor(new * z + old) / (z - 1)
    derivative = (z - 1) / (T * z)
    top, bottom = _lowest(q, K_i, K_d, z)
    return DiscretePid(weights, integral, derivative, top / bottom, (q[0], q[1], q[2]))


def _lowest(q: tuple[sp.Expr, ...], K_i: sp.Expr, K_d: sp.Expr, z: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """Numerator and denominator of (q₀ z² + q₁ z + q₂)/(z (z − 1)) without what cancels where a gain is zero."""
    one = sp.Integer(1)
    if K_i == 0:
        return (q[0] * z - q[2], z) if K_d != 0 else (q[0], one)
    if K_d == 0:
        return q[0] * z + q[1], z - 1
    return q[0] * z**2 + q[1] * z + q[2], z * (z - 1)
