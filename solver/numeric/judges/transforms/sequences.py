"""Sequences and their z-transforms: the defining series at a large |z|, and contour integrals for single values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from solver.numeric.judges.time_response.response import sampled
from solver.numeric.judges.transforms.inverse import terms_of
from solver.stated import Stated
from solver.stated.algebra import total
from solver.stated.calculus import value_at
from solver.stated.transforms import inverse_laplace, inverse_z, z_transform

MOST_SAMPLES = 30


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


def sampled_values(image: Any, s: Any, T: Any, F: Any, z: Any) -> Iterator[tuple[Stated, Stated, int]]:
    """Yield f(kT) by contour integrals of F(z) z^{k−1}, and by those of the image in s, its dead times apart.

    There are so many that two rational functions of the degrees of both which agree are the same.
    """
    terms = terms_of(image, s)
    late = max(int(sp.ceiling(delay / T)) for delay, _ in terms)
    orders = [sp.degree(sp.fraction(sp.together(G))[1], s) for _, G in terms]
    count = int(sum(orders)) + late + telling_samples(F, z)[0]
    for step in range(min(count, MOST_SAMPLES)):
        times = [(sp.expand(step * T - delay), G) for delay, G in terms]
        begun: list[Any] = [inverse_laplace(G, s, time) for time, G in times if time.is_nonnegative]
        yield inverse_z(F, z, sp.Integer(step)), total(*begun) if begun else total(sp.S.Zero), step


def telling_samples(F: Any, z: Any) -> tuple[int, int]:
    """Return how many samples beyond the first tell a rational F from others like it, and the first sample.

    That is below zero where the numerator of F is of a higher degree than the denominator.
    """
    above, below = (sp.Poly(sp.expand(side), z) for side in sp.fraction(sp.together(F)))
    last = below.degree() + 2
    return max(last, 4), min(0, below.degree() - above.degree())
