"""Root loci judged by their definition, D(s) + K N(s) = 0 with K ≥ 0, in numbers of many digits.

N and D come from the equation at two gains. Roots are those of its squarefree parts by mpmath; the gain at a point is
−D/N, directions are those of −D/N near a pole, near a zero and far away.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import multiple
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of

DIGITS = 60
FAR = 20
"""Points far away are at 10^FAR, points near a pole at 10^−FAR."""

MP = multiple(DIGITS).context
NEAR = MP.mpf(10) ** -18
"""What is nearer than this is the same, or zero, beside numbers of the size one."""

Placed = tuple[Any, int]
"""A root as mpmath's number, and its multiplicity."""


@dataclass(frozen=True)
class Locus:
    """N and D without common factors, highest power first in many digits; `zeros` and `poles` with multiplicities."""

    numerator: tuple[Any, ...]
    denominator: tuple[Any, ...]
    zeros: tuple[Placed, ...]
    poles: tuple[Placed, ...]
    turning: tuple[Placed, ...]
    discrete: bool = False

    @property
    def excess(self) -> int:
        """How many branches go to infinity."""
        return len(self.denominator) - len(self.numerator)

    def gain(self, s: Any) -> Any:
        """K = −D/N; infinite at a zero."""
        N = MP.polyval(list(self.numerator), s)
        return -MP.polyval(list(self.denominator), s) / N if N else MP.inf

    def gain_by_factors(self, s: Any) -> Any:
        """K = −D/N from the roots: near a multiple one, where the sums of D and N have no correct digit left."""
        D, N = (
            p[0] * MP.fprod((s - root) ** m for root, m in roots)
            for p, roots in ((self.denominator, self.poles), (self.numerator, self.zeros))
        )
        return -D / N


@lru_cache(maxsize=32)
def locus_of(polynomial: Any, s: Any, k: Any, *, discrete: bool = False) -> Locus:
    """Return the locus of p(s, k) = D(s) + k N(s); in discrete time the unit circle bounds what is stable."""
    constant = sp.expand(polynomial.xreplace({k: sp.S.Zero}))
    slope = sp.expand(polynomial.xreplace({k: sp.S.One}) - constant)
    N, D = (sp.Poly(each, s, extension=True) for each in (slope, constant))
    common = N.gcd(D)
    N, D = N.quo(common), D.quo(common)
    turning = N * D.diff() - N.diff() * D
    zeros, poles, meeting = (_roots(p) for p in (N, D, turning))
    return Locus(_numbers(N), _numbers(D), zeros, poles, meeting, discrete)


def _numbers(p: sp.Poly) -> tuple[Any, ...]:
    return tuple(number(c) for c in p.all_coeffs())


def number(value: Any) -> Any:
    """A value of many digits as mpmath's number."""
    found = value_of(value, Environment.at([{}], multiple(DIGITS))).value
    return MP.mpmathify(np.ravel(found)[0])


def _roots(p: sp.Poly) -> tuple[Placed, ...]:
    """The roots of the squarefree parts, each with its multiplicity."""
    if p.is_zero or p.degree() == 0:
        return ()
    return tuple(
        (MP.mpc(root), multiplicity)
        for part, multiplicity in p.sqf_list()[1]
        for root in MP.polyroots(list(_numbers(part)), maxsteps=500, extraprec=500)
    )


def asymptote_angles_residual(locus: Locus, angles: Sequence[Any]) -> float:
    """Return how far the gain is from positive far away in these directions; they must be all that there are."""
    found = [number(each) for each in angles]
    if any(each == 180 for each in found):  # ±180° is one direction
        found = [each for each in found if each != -180]
    if len(found) != max(locus.excess, 0):
        return float("inf")
    if any(apart(a, b) < 1 for i, a in enumerate(found) for b in found[:i]):
        return float("inf")
    far = MP.mpf(10) ** FAR
    gains = (locus.gain(far * MP.expj(MP.radians(each))) for each in found)
    return max((float(abs(MP.arg(gain))) for gain in gains), default=0.0)


def centroid_residual(locus: Locus, centroid: Any) -> float:
    """Return the part of first order by which −D/N differs far away from a power of the distance to the centroid."""
    q, far = locus.excess, MP.mpf(10) ** FAR
    if q < 1:
        return float("inf")
    center = number(centroid)
    ratio = -locus.gain(center + far) * locus.numerator[0] / locus.denominator[0] / far**q
    return float(abs(ratio - 1) * far / q / (abs(center) if abs(center) > NEAR else 1))


def relative(a: Any, b: Any) -> float:
    """How far a is from b, in parts of b where that is not zero."""
    return float(abs(a - b) / (abs(b) if abs(b) > NEAR else 1))


def apart(a: Any, b: Any) -> Any:
    """How many degrees two directions differ by."""
    return abs((a - b + 180) % 360 - 180)


def segments_residual(locus: Locus, segments: Sequence[Any]) -> float:
    """Return how far ends are from the real poles and zeros; infinite where K ≥ 0 does not hold just within."""
    corners = sorted(MP.re(root) for root, _ in (*locus.poles, *locus.zeros) if abs(MP.im(root)) < NEAR)
    far = 1 + max((abs(each) for each in corners), default=MP.mpf(0))
    cuts = [-far, *corners, far]
    wanted = _merged([(a, b) for a, b in pairwise(cuts) if b - a > NEAR and MP.re(locus.gain((a + b) / 2)) > 0])
    ends = [tuple(_end(each, far) for each in (part.start, part.end)) for part in segments]
    if any(a >= b for a, b in ends):
        return float("inf")
    found = _merged(sorted(ends))
    if len(found) != len(wanted):
        return float("inf")
    pairs = [pair for ours, other in zip(wanted, found, strict=True) for pair in zip(ours, other, strict=True)]
    return max((relative(a, b) for a, b in pairs), default=0.0)


def _end(value: Any, far: Any) -> Any:
    return far if value == sp.oo else -far if value == -sp.oo else MP.re(number(value))


def _merged(intervals: Sequence[tuple[Any, Any]]) -> list[tuple[Any, Any]]:
    """Intervals that touch as one."""
    found: list[tuple[Any, Any]] = []
    for low, high in intervals:
        if found and abs(found[-1][1] - low) < NEAR * (1 + abs(low)):
            found[-1] = (found[-1][0], high)
        else:
            found.append((low, high))
    return found
