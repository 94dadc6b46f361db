"""Step responses at samples judged: by the recursion of the states with 50 digits, until nothing can come any more."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.representation.minimal import MANY, minimal_part, numbers_at, quadruple_at

DIED_OUT = 70.0
"""So many times the slowest time constant later nothing is left to see."""
MOST = 60_000
NOTHING = 1e-35
"""Deviations smaller than that, relative to the largest one, are none."""


@lru_cache(maxsize=8)
def deviations(plant: Any) -> tuple[Any, list[Any]] | None:
    """Return the final value of a unit step's response and y/y_f − 1 at its samples; None where it does not settle."""
    m = MANY.context
    A, B, C, D = quadruple_at(plant, {})
    A, B, C = minimal_part(A, B, C)
    if not len(A):
        final = m.re(D.reshape(-1)[0])
        return (final, [m.mpf(0)]) if final else None
    sizes = np.abs(np.linalg.eigvals(np.array(A.tolist(), dtype=complex)))
    if max(sizes) >= 1 - 1e-12:
        return None
    slowest = -np.log(max(sizes)) if max(sizes) > 1e-8 else DIED_OUT
    count = int(DIED_OUT / slowest) + 4 * len(A) + 4
    if count > MOST:
        raise NotEvaluable("the response settles too slowly for its recursion")
    pencil = m.eye(len(A)) - m.matrix(A.tolist())
    rest = np.array(m.lu_solve(pencil, m.matrix(B.tolist())).tolist(), dtype=object).reshape(-1, 1)
    final = m.re((C @ rest).reshape(-1)[0] + D.reshape(-1)[0])
    return (final, _recursion(A, C / final, -rest, count)) if abs(final) > 1e-30 else None


def _recursion(A: Array, C: Array, z: Array, count: int) -> list[Any]:
    """C Aᵏ z for k = 0, 1, …, what is nothing beside the largest set to zero."""
    m, found = MANY.context, []
    for _ in range(count):
        found.append(m.re((C @ z).reshape(-1)[0]))
        z = A @ z
    largest = max(map(abs, found))
    fading = max(abs(each) for each in z.reshape(-1)) if len(z) else m.mpf(0)
    floor = max(NOTHING * largest, fading) if largest else m.mpf(0)
    return [each if abs(each) > floor else m.mpf(0) for each in found]


def overshoots(plant: Any) -> bool:
    """Whether a sample is beyond the final value."""
    seen = deviations(tuple(M.as_immutable() for M in plant))
    return seen is not None and max(seen[1]) > 0


def samples_fault(plant: Any, samples: Sequence[Any], others: Sequence[Any]) -> float:
    """Return how far samples of y are off, and others with a time and a share, beside the size of the response."""
    seen = deviations(tuple(M.as_immutable() for M in plant))
    if seen is None:
        return float("inf")
    final, e = seen
    y = numbers_at(list(samples), {})
    faults = [abs(value / final - 1 - e[k]) for k, value in enumerate(y)]
    shares = numbers_at([each.share for each in others], {})
    faults += [abs(value - 1 - e[int(each.time)]) for value, each in zip(shares, others, strict=True)]
    return float(max(faults) / max(1, *map(abs, e)))


def is_bounded(plant: Any, bound: Sequence[tuple[Any, Any, int]], within: int, band: Any) -> bool:
    """Whether the sum of c C(k, j−1) p^{k−j+1} bounds all deviations, and falls below the band at a sample for good."""
    m = MANY.context
    seen = deviations(tuple(M.as_immutable() for M in plant))
    if seen is None:
        return False
    terms = [(*numbers_at([c, p], {}), j) for c, p, j in bound]

    def at(k: int) -> Any:
        return m.fsum(m.re(c * m.binomial(k, j - 1) * p ** (k - j + 1)) for c, p, j in terms if k >= j - 1)

    slack = 1 + m.mpf("1e-20")
    later = [at(within + i) for i in range(30)]
    falls = all(b <= a * slack for a, b in pairwise(later))
    return falls and bool(later[0] <= m.re(numbers_at([band], {})[0]) * slack) and all(
        abs(each) <= at(k) * slack + m.mpf("1e-25") for k, each in enumerate(seen[1][: 4 * within + 40])
    )  # fmt: skip


def largest_sample_fault(plant: Any, time: Any, value: Any) -> float:
    """Return how far a value is from that of a unit step's response at a sample, and from its largest size."""
    m = MANY.context
    A, B, C, D = quadruple_at(plant, {})
    z, y = np.zeros((len(A), 1), dtype=object), []
    slowest = max((abs(p) for p in np.linalg.eigvals(np.array(A.tolist(), dtype=complex))), default=0.0)
    for _ in range(min(MOST, int(DIED_OUT / -np.log(min(max(slowest, 1e-8), 1 - 1e-12))) + 4 * len(A) + 4)):
        y.append(m.re((C @ z).reshape(-1)[0] + D.reshape(-1)[0]))
        z = A @ z + B
    claimed = m.re(numbers_at([value], {})[0])
    at = y[-1] if time in (sp.oo, -sp.oo) else y[int(time)]
    size = max(abs(claimed), m.mpf("1e-30"))
    return max(float(abs(at - claimed) / size), 0.0, float(max(map(abs, y)) / size) - 1)


def sampled_specification(plant: Any, name: str, band: Any, *, whole: bool) -> Any:
    """Return a quantity of the response, times in samples; None where there is none."""
    m = MANY.context
    seen = deviations(tuple(M.as_immutable() for M in plant))
    if seen is None:
        return None
    final, e = seen
    if name == "final_value":
        return final
    if name == "settling_time":
        return m.mpf(max((k + 1 for k, each in enumerate(e) if abs(each) > band + m.mpf(NOTHING)), default=0))
    best = max(e)
    if name == "overshoot":
        return max(best, m.mpf(0))
    if name == "peak_time":
        return m.mpf(e.index(next(each for each in e if each >= best * (1 - m.mpf(NOTHING))))) if best > 0 else None
    return m.mpf(_rise(e, whole=whole))


def _rise(e: list[Any], *, whole: bool) -> int:
    """The samples between the first ones at two levels; 10 and 90 % where the final value is not reached."""
    m = MANY.context
    early = len(e) // 2  # later a deviation may be nothing because it has died out
    reached = next((k for k, each in enumerate(e) if each > 0 or (each == 0 and k < early)), None)
    if whole and reached is not None:
        return reached
    begins, ends = (next(k for k, each in enumerate(e) if each >= level - m.mpf(NOTHING)) for level in (
        m.mpf(-9) / 10, m.mpf(-1) / 10))  # fmt: skip
    return ends - begins
