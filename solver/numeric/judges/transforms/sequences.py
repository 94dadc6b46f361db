"""Sequences and their z-transforms: the defining series at a large |z|, and contour integrals for single values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from solver.numeric.judges.time_response.response import sampled
from solver.stated import Stated
from solver.stated.calculus import value_at
from solver.stated.transforms import inverse_laplace, inverse_z, z_transform


def series_of(f: Any, k: Any, z: Any) -> Stated:
    """Return Σ f(k) z⁻ᵏ, steps being one at their start and impulses unit pulses."""
    return z_transform(sampled(f, k), k, z)


def samples_of_image(F: Any, z: Any, f: Any, k: Any, first: int, count: int) -> Iterator[tuple[Stated, Stated, int]]:
    """Yield f(k) and the contour integral of F z^{k−1}, `count` of them from k = `first` on, with k."""
    whole = sampled(f, k)
    for step in range(first, first + count):
        yield value_at(whole, k, sp.Integer(step)), inverse_z(F, z, sp.Integer(step)), step


def values_of_image(F: Any, z: Any, count: int) -> Iterator[Stated]:
    """Yield the contour integrals of F z^{k−1}, k = 0, 1, …."""
    for step in range(count):
        yield inverse_z(F, z, sp.Integer(step))


def sampled_values(terms: Any, s: Any, T: Any, F: Any, z: Any, count: int) -> Iterator[tuple[Stated, Any, int]]:
    """Yield f(kT) by contour integrals of F(z) z^{k−1}, and by those of the terms (delay, G) of the image in s."""
    for step in range(count):
        begun = [
            inverse_laplace(G, s, sp.expand(step * T - delay))
            for delay, G in terms
            if (sp.expand(step * T - delay)).is_nonnegative
        ]
        yield inverse_z(F, z, sp.Integer(step)), begun, step


def telling_samples(F: Any, z: Any) -> tuple[int, int]:
    """Return how many samples beyond the first tell a rational F from others like it, and the first sample.

    That is below zero where the numerator of F is of a higher degree than the denominator.
    """
    above, below = (sp.Poly(sp.expand(side), z) for side in sp.fraction(sp.together(F)))
    last = below.degree() + 2
    return max(last, 4), min(0, below.degree() - above.degree())
