"""Sampled plants by matrix exponentials of a realization, and sampled loops followed from sample to sample."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.stated import Stated
from solver.stated.algebra import difference, exponential, power, product, total
from solver.stated.calculus import integral
from solver.stated.matrices import inverse

MANY = multiple(40)
Quadruple = tuple[Any, Any, Any, Any]
WRONG = float("inf")


@dataclass(frozen=True)
class Sampling:
    """A plant A, B, C, D behind a hold (`held`) or driven by impulses, and late by (l − μ)T; the period is T."""

    plant: Quadruple
    T: Any
    held: bool = True
    late: int = 0
    ahead: Any = 0


def periods(delay: Any, T: Any) -> tuple[int, Any]:
    """Return (l, μ) of a dead time (l − μ)T, l the least whole number with lT not below it, as the numbers tell."""
    ratio = (sp.S.Zero + delay) / T
    (point,) = admissible(free_symbols(ratio), 1)
    late = int(MANY.context.ceil(numbers_of([[ratio]], point)[0][0] - MANY.context.mpf("1e-25")))
    return late, sp.expand(late - ratio)


def stated_pulse(sampling: Sampling, z: Any) -> Stated:
    """z⁻ˡ (C (zI − e^{AT})⁻¹ (Γ₁ + z Γ₀) + D), what of u(k − l) and of u(k − l + 1) has acted until (k + 1)T."""
    A, B, C, D = sampling.plant
    T, mu, n = sampling.T, sampling.ahead, sampling.plant[0].rows
    if n == 0:
        return product(power(z, -sampling.late), D)
    pencil = difference(product(z, sp.ImmutableMatrix(sp.eye(n))), exponential(product(A, T)))
    if sampling.held:
        early = product(_moved(A, mu * T), _integrated(A, B, (1 - mu) * T)) if mu != 0 else _integrated(A, B, T)
        driven = total(early, product(z, _integrated(A, B, mu * T))) if mu != 0 else early
    else:
        driven = product(z, _moved(A, mu * T), B)
    dynamic = product(C, inverse(pencil), driven)
    return product(power(z, -sampling.late), dynamic if D.is_zero_matrix else total(dynamic, D))


def _moved(A: Any, duration: Any) -> Stated:
    return exponential(product(A, duration))


def _integrated(A: Any, B: Any, duration: Any) -> Stated:
    """∫₀ᵈ e^{Aτ} B dτ."""
    tau = sp.Dummy("tau", real=True)
    return integral(product(exponential(product(A, tau)), B), tau, sp.S.Zero, duration)


def loop_residual(answer: Any, forward: Sampling, back: Sampling | None, C: Any, H: Any, z: Any) -> float:
    """Return the largest difference of the samples of an answer (in z) and those of the loop that it is of.

    A unit pulse comes in; `C` and `H` are in z. `back` is the plant with what is in the feedback path, H then the rest
    of it; None: the loop is open. The plants are followed from sample to sample.
    """
    worst = 0.0
    if not all(side.is_polynomial(z) for side in sp.fraction(sp.together(answer))):
        return WRONG
    plants = [each for each in (forward, back) if each is not None]
    stated = [answer, C, H, *(part for each in plants for part in (*each.plant, each.T, each.ahead))]
    symbols = {x for each in stated for x in free_symbols(each)} - {z}
    for point in admissible(symbols, 2):
        count = _count(answer, z)
        through = _convolved(_series(C, z, count, point), _impulses(forward, count, point))
        if back is not None:
            around = _convolved(_series(C * H, z, count, point), _impulses(back, count, point))
            through = _divided(through, [1 + around[0], *around[1:]])
        found = _series(answer, z, count, point)
        size = max(abs(each) for each in (*through, MANY.context.mpf("1e-30")))
        worst = worst_of((worst, float(max(abs(a - b) for a, b in zip(found, through, strict=True)) / size)))
    return with_many_digits(worst, *stated)


def _count(answer: Any, z: Any) -> int:
    """So many samples tell a quotient of its degree apart from others of that degree."""
    above, below = sp.fraction(sp.together(answer))
    return 2 * int(max(sp.degree(above, z), sp.degree(below, z))) + 3


def numbers_of(values: Any, point: Any) -> Any:
    """Return a matrix of expressions as numbers at a point."""
    found = value_of(sp.ImmutableMatrix(values), Environment.at([point], MANY)).value[0]
    return np.asarray(found, dtype=object)


def _impulses(sampling: Sampling, count: int, point: Any) -> list[Any]:
    """The outputs at the samples, from rest, where u(0) = 1 and nothing comes later."""
    A, B, C, D = (numbers_of(M, point) if 0 not in M.shape else np.zeros(M.shape, dtype=object) for M in sampling.plant)
    T, mu = numbers_of([[sampling.T, sampling.ahead]], point)[0]
    early, late = _step(A, B, (1 - mu) * T), _step(A, B, mu * T)
    x, y = np.zeros((A.shape[0], 1), dtype=object), []
    for k in range(count):
        arrived, arriving = (1 if k - sampling.late == 0 else 0), (1 if k + 1 - sampling.late == 0 else 0)
        if sampling.held:
            y.append((C @ x + D * arrived)[0, 0])
            x = late[0] @ (early[0] @ x + early[1] * arrived) + late[1] * arriving
        else:
            x = x + late[0] @ B * arrived if k == 0 else x
            y.append((C @ x)[0, 0])
            x = late[0] @ (early[0] @ x + B * arriving)
    return y


def _step(A: Array, B: Array, duration: Any) -> tuple[Any, Any]:
    """e^{Ad} and ∫₀ᵈ e^{Aτ} dτ B, by the exponential of the augmented matrix."""
    n, m = B.shape
    whole = np.zeros((n + m, n + m), dtype=object) + MANY.context.mpf(0)
    whole[:n, :n], whole[:n, n:] = A * duration, B * duration
    found, _ = MANY.exponential(whole[None])
    return found[0][:n, :n], found[0][:n, n:]


def _series(F: Any, z: Any, count: int, point: Any) -> list[Any]:
    """The first coefficients of a quotient of polynomials in z by powers of z⁻¹; it must be proper."""
    above, below = (sp.Poly(side, z).all_coeffs() for side in sp.fraction(sp.together(F)))
    if len(above) > len(below):
        return [MANY.context.mpf("inf")] * count
    padded = [sp.S.Zero] * (len(below) - len(above)) + above
    p, q = (list(numbers_of([side], point)[0]) for side in (padded, below))
    return _divided([*p, *[0] * count][:count], [*q, *[0] * count][:count])


def _divided(p: Sequence[Any], q: Sequence[Any]) -> list[Any]:
    """The quotient of two power series, to as many terms."""
    found: list[Any] = []
    for i in range(len(p)):
        rest = p[i] - sum((found[j] * q[i - j] for j in range(i)), MANY.context.mpf(0))
        found.append(rest / q[0])
    return found


def _convolved(p: Sequence[Any], q: Sequence[Any]) -> list[Any]:
    """The product of two power series, to as many terms."""
    return [sum((p[j] * q[i - j] for j in range(i + 1)), MANY.context.mpf(0)) for i in range(len(p))]
