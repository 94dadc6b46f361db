"""Points with whole numbers and free coordinates in them: whether a solution is one of theirs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from solver.numeric.judges.modelling.compiled import compiled

Point = Mapping[Any, Any]
Vectors = Any


class Family:
    """A point at numbers of the parameters: values in terms of whole numbers and of what is free."""

    def __init__(self, point: Point, unknowns: Sequence[Any], numbers: Mapping[Any, Any]) -> None:
        self.unknowns = unknowns
        self.is_complex = any(x.is_real is None for x in unknowns)
        self.values = [point[x].xreplace(dict(numbers)) for x in unknowns]
        inside = {s for v in self.values for s in v.free_symbols}
        self.integers = sorted(inside - set(unknowns), key=str)
        self.functions = [compiled(v) for v in self.values]

    def holds(self, at: Vectors) -> bool:
        """Whether a solution is one of the family."""
        own = dict(zip(self.unknowns, at.tolist(), strict=True))
        zero = self._at({**own, **dict.fromkeys(self.integers, 0.0)})
        if zero is None:
            return False
        if self.integers:
            columns = [self._at({**own, **dict.fromkeys(self.integers, 0.0), n: 2.0}) for n in self.integers]
            if any(column is None for column in columns):
                return False
            steps = np.array([(column - zero).real / 2 for column in columns]).T
            counts = np.linalg.lstsq(steps, at.real - zero.real, rcond=None)[0]
            near = [round(float(c)) for c in counts]
            for more in _around(len(near)):
                whole = {n: float(c + d) for n, c, d in zip(self.integers, near, more, strict=True)}
                if self._is_near(self._at({**own, **whole}), at):
                    return True
            return False
        return self._is_near(zero, at)

    @staticmethod
    def _is_near(value: Any, at: Vectors) -> bool:
        return value is not None and bool(np.all(np.abs(value - at) <= 1e-5 * (1 + np.abs(at))))

    def _at(self, numbers: Mapping[Any, float]) -> Any:
        with np.errstate(all="ignore"):
            try:
                values = np.array([complex(f(numbers)) for f in self.functions])
            except (KeyError, ZeroDivisionError, OverflowError):
                return None
        real = np.isfinite(values).all() and np.all(np.abs(values.imag) < 1e-9 * (1 + np.abs(values)))
        return values.real if real else values if self.is_complex and np.isfinite(values).all() else None


def _around(count: int) -> Iterator[tuple[int, ...]]:
    """Whole numbers by which a rounded guess may be wrong."""
    if count > 2:
        yield (0,) * count
        return
    span = (0, 1, -1, 2, -2)
    yield from ((i,) for i in span) if count == 1 else ((i, j) for i in span for j in span)
