"""The branches of a root locus as curves: roots of D + K N followed from gain to gain, in steps as short as they need.

Between two gains at which roots meet no two branches touch, so each is followed by itself: the tangent predicts the
next roots, and a step is halved until it is clear which is which. At a meeting the pieces end and begin in the point
itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
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
        for low, high in pairwise([*gains, np.inf]):
            if high - low > 1e-9 * (1 + low):
                found += self._between(low, high, [point for point, gain in meetings if gain in (low, high)])
        return found

    def _between(self, low: float, high: float, ends: list[complex]) -> list[Array]:
        """The pieces of all branches for low < K < high."""
        start, stop = low + TINY * max(low, self._scale), high - TINY * (high if np.isfinite(high) else 0)
        gain, roots = start, self._roots(start)
        path, step = [roots], 1e-3 * max(start, TINY * self._scale)
        for _ in range(MOST):
            if gain >= stop or gain > LARGEST * self._scale or self._all_ended(gain, roots):
                break
            step = min(step, stop - gain)
            following = self._matched(gain, roots, gain + step)
            if following is None and step > LEAST * gain:
                step /= 2
                continue
            if following is None:
                following = self._nearest(roots, self._roots(gain + step))
            gain, roots = gain + step, following
            path.append(roots)
            step *= 1.6
        return [self._ended(np.array(each), low, high, ends) for each in np.array(path).T]

    @property
    def _scale(self) -> float:
        """The size of gains that matter: of the coefficients of D beside those of N."""
        return float(np.max(np.abs(self.denominator)) / np.max(np.abs(self.numerator)))

    def _roots(self, gain: float) -> Array:
        """The roots of D + K N, refined by Newton's method."""
        n = len(self.denominator)
        p = self.denominator.copy()
        p[n - len(self.numerator) :] += gain * self.numerator
        roots = np.roots(p).astype(complex)
        slope = np.polyder(p)
        with np.errstate(all="ignore"):
            refined = roots - np.polyval(p, roots) / np.polyval(slope, roots)
        better = np.isfinite(refined) & (np.abs(np.polyval(p, refined)) < np.abs(np.polyval(p, roots)))
        return np.where(better, refined, roots)

    def _tangent(self, gain: float, roots: Array) -> Array:
        """dr/dK = −N/(D' + K N')."""
        slope = np.polyval(np.polyder(self.denominator), roots)
        slope = slope + gain * np.polyval(np.polyder(self.numerator), roots)
        with np.errstate(all="ignore"):
            return np.asarray(-np.polyval(self.numerator, roots) / slope)

    def _matched(self, gain: float, roots: Array, following: float) -> Array | None:
        """The roots at the next gain in the same order; None where the step is too long to tell."""
        new = self._roots(following)
        if len(new) != len(roots):
            return None
        expected = roots + self._tangent(gain, roots) * (following - gain)
        if not np.all(np.isfinite(expected)):
            return None
        distance = np.abs(expected[:, None] - new[None, :])
        order = np.argmin(distance, axis=1)
        if len(set(order.tolist())) < len(order):
            return None
        new = new[order]
        far = np.maximum(np.abs(roots - self.middle) - self.side, 0)
        longest = STEP * self.side + 0.2 * far
        apart = np.abs(new[:, None] - new[None, :]) + np.where(np.eye(len(new)) > 0, np.inf, 0)
        error = np.abs(expected - new)
        clear = np.all(np.abs(new - roots) < longest) and np.all(error < 0.2 * np.min(apart, axis=1) + TINY * self.side)
        return new if clear else None

    @staticmethod
    def _nearest(roots: Array, new: Array) -> Array:
        """The new roots, each beside the nearest old one that is left."""
        left, found = list(new), []
        for root in roots:
            found.append(left.pop(int(np.argmin(np.abs(np.array(left) - root)))) if left else root)
        return np.array(found)

    def _all_ended(self, gain: float, roots: Array) -> bool:
        """Whether every root is near a zero, or far away and on its way farther."""
        zeros = np.roots(self.numerator) if len(self.numerator) > 1 else np.array([])
        leaving = np.real((roots - self.middle) * np.conj(self._tangent(gain, roots))) > 0
        far = leaving & (np.abs(roots - self.middle) > 1.5 * self.side)
        near = np.array([np.min(np.abs(zeros - root), initial=np.inf) < CLOSE * self.side for root in roots])
        return bool(np.all(far | near))

    def _ended(self, path: Array, low: float, high: float, ends: list[complex]) -> Array:
        """A piece with the point in which it starts, and the one in which it ends, if they are near."""
        first = [*np.roots(self.denominator)] if low == 0 else ends
        last = ends if np.isfinite(high) else [*np.roots(self.numerator)] if len(self.numerator) > 1 else []
        for points, at in ((first, 0), (last, -1)):
            near = min(points, key=lambda point: abs(point - path[at]), default=None)
            if near is not None and abs(near - path[at]) < 10 * CLOSE * self.side:
                path = np.concatenate([[near], path] if at == 0 else [path, [near]])
        return path
