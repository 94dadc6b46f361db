"""The branches of a root locus as curves: roots of D + K N followed from gain to gain, in steps as short as they need.

Between two gains at which roots meet no two branches touch, so each is followed by itself: the tangent predicts the
next roots, and a step is halved until it is clear which is which. At a meeting the pieces end and begin in the point
itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import pairwise
from typing import Any

import numpy as np

Array = np.ndarray[Any, np.dtype[np.complex128]]

STEP = 0.02
"""The longest step of a root, in parts of the window's side."""

CLOSE = 2e-3
"""A root so near to its end, in the same parts, has reached it."""

LEAST = 1e-13
"""The shortest step of K, in parts of K."""

MOST = 6000
"""Steps of one piece."""

LARGEST = 1e14
TINY = 1e-9


@dataclass(frozen=True)
class Branches:
    """N and D by coefficients, highest power first, D the longer; `side` is the side of the window about `middle`."""

    numerator: Array
    denominator: Array
    middle: complex
    side: float

    def pieces(self, meetings: Sequence[tuple[complex, float]], infinite: float | None) -> list[Array]:
        """Return curves of complex numbers, each in the direction of rising K; at `infinite` a root is at infinity."""
        gains = sorted({0.0, *(gain for _, gain in meetings), *([infinite] if infinite else [])})
        found: list[Array] = []
        with np.errstate(all="ignore"):
            for low, high in pairwise([*gains, np.inf]):
                if high - low > 1e-9 * (1 + low):
                    found += self._between(low, high, [point for point, gain in meetings if gain in (low, high)])
        return found

    def _between(self, low: float, high: float, ends: list[complex]) -> list[Array]:
        """The pieces of all branches for low < K < high."""
        start, stop = low + TINY * max(low, self._scale), high - TINY * (high if np.isfinite(high) else 0)
        gain, roots = start, self._roots(start)
        tangent = self._tangent(gain, roots)
        path, step = [roots], 1e-3 * max(start, TINY * self._scale)
        for _ in range(MOST):
            if gain >= stop or gain > LARGEST * self._scale or self._all_ended(roots, tangent):
                break
            step = min(step, stop - gain)
            following = self._matched(gain, roots, tangent, gain + step)
            if following is None and step > LEAST * gain:
                step /= 2
                continue
            if following is None:
                following = self._nearest(roots, self._roots(gain + step))
            gain, roots = gain + step, following
            tangent = self._tangent(gain, roots)
            path.append(roots)
            step *= 1.6
        return [self._ended(np.array(each), low, high, ends) for each in np.array(path).T]

    @cached_property
    def _scale(self) -> float:
        """The size of gains that matter: of the coefficients of D beside those of N."""
        return float(np.max(np.abs(self.denominator)) / np.max(np.abs(self.numerator)))

    def _roots(self, gain: float) -> Array:
        """The roots of D + K N, refined by Newton's method."""
        n = len(self.denominator)
        p = self.denominator.copy()
        p[n - len(self.numerator) :] += gain * self.numerator
        roots = _roots_of(p)
        there = _values(p, roots)
        refined = roots - there / _values(_slope(p), roots)
        better = np.isfinite(refined) & (np.abs(_values(p, refined)) < np.abs(there))
        return np.where(better, refined, roots)

    def _tangent(self, gain: float, roots: Array) -> Array:
        """dr/dK = −N/(D' + K N')."""
        D, N = self._slopes
        slope = _values(D, roots) + gain * _values(N, roots)
        return np.asarray(-_values(self.numerator, roots) / slope)

    @cached_property
    def _slopes(self) -> tuple[Array, Array]:
        """The derivatives D' and N'."""
        return _slope(self.denominator), _slope(self.numerator)

    @cached_property
    def _zeros(self) -> Array:
        """The roots of N."""
        return np.asarray(np.roots(self.numerator), dtype=complex)

    def _matched(self, gain: float, roots: Array, tangent: Array, following: float) -> Array | None:
        """The roots at the next gain in the same order; None where the step is too long to tell."""
        new = self._roots(following)
        expected = roots + tangent * (following - gain)
        if len(new) != len(roots) or not np.isfinite(expected).all():
            return None
        distance = np.abs(expected[:, None] - new[None, :])
        order = distance.argmin(axis=1)
        if len(set(order.tolist())) < len(order):
            return None
        new = new[order]
        far = np.maximum(np.abs(roots - self.middle) - self.side, 0)
        longest = STEP * self.side + 0.2 * far
        apart = np.abs(new[:, None] - new[None, :]) + _itself(len(new))
        error = np.abs(expected - new)
        near = 0.2 * apart.min(axis=1) + TINY * self.side
        clear = (np.abs(new - roots) < longest).all() and (error < near).all()
        return new if clear else None

    @staticmethod
    def _nearest(roots: Array, new: Array) -> Array:
        """The new roots, each beside the nearest old one that is left."""
        left, found = list(new), []
        for root in roots:
            found.append(left.pop(int(np.argmin(np.abs(np.array(left) - root)))) if left else root)
        return np.array(found)

    def _all_ended(self, roots: Array, tangent: Array) -> bool:
        """Whether every root is near a zero, or far away and on its way farther."""
        away = roots - self.middle
        far = (np.real(away * np.conj(tangent)) > 0) & (np.abs(away) > 1.5 * self.side)
        near = np.abs(self._zeros[None, :] - roots[:, None]).min(axis=1, initial=np.inf) < CLOSE * self.side
        return bool((far | near).all())

    def _ended(self, path: Array, low: float, high: float, ends: list[complex]) -> Array:
        """A piece with the point in which it starts, and the one in which it ends, if they are near."""
        first = [*np.roots(self.denominator)] if low == 0 else ends
        last = ends if np.isfinite(high) else [*np.roots(self.numerator)] if len(self.numerator) > 1 else []
        for points, at in ((first, 0), (last, -1)):
            near = min(points, key=lambda point: abs(point - path[at]), default=None)
            if near is not None and abs(near - path[at]) < 10 * CLOSE * self.side:
                path = np.concatenate([[near], path] if at == 0 else [path, [near]])
        return path


@cache
def _itself(n: int) -> Any:
    """What keeps each of n roots from being compared with itself."""
    return np.where(np.eye(n) > 0, np.inf, 0)


def _values(p: Array, x: Array) -> Array:
    """The values of a polynomial, by Horner's rule as `polyval`, which takes twice as long for as few."""
    found = np.zeros_like(x)
    for coefficient in p:
        found = found * x + coefficient
    return found


def _slope(p: Array) -> Array:
    """The derivative of a polynomial."""
    return p[:-1] * np.arange(len(p) - 1, 0, -1)


def _roots_of(p: Array) -> Array:
    """The roots of a polynomial, as `roots` finds them; it looks for zeros at both ends first."""
    if len(p) < 3 or not p[0] or not p[-1]:
        return np.roots(p).astype(complex)
    companion = np.diag(np.ones(len(p) - 2, p.dtype), -1)
    companion[0, :] = -p[1:] / p[0]
    return np.asarray(np.linalg.eigvals(companion), dtype=complex)
