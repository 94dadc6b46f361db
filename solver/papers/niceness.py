"""Whether what comes out is nice: in integers, in rationals with small denominators, or exact."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np
import sympy as sp

LARGEST_DENOMINATOR = 12
NEAR = 1e-6
"""What lies as near to a nice number, in parts of its size, may be it: an exact look will tell."""

Array = np.ndarray[Any, Any]

Numbers = Callable[[Array], Array]
"""What an answer is, draws in columns, as it follows from what is given, draws in columns."""


def is_nice(value: Any, kind: str) -> bool:
    """Whether all numbers in an answer are of the kind; words and truth values are."""
    return all(_is_nice(each, kind) for each in leaves(value))


def leaves(value: Any) -> Iterator[sp.Expr]:
    """Yield the expressions in an answer: entries of matrices, items of lists, values of mappings."""
    if isinstance(value, Mapping):
        value = list(value.values())
    if isinstance(value, sp.MatrixBase):
        value = value.flat()
    if isinstance(value, list | tuple):
        for each in value:
            yield from leaves(each)
    elif isinstance(value, sp.Expr):
        yield value


def _is_nice(value: sp.Expr, kind: str) -> bool:
    """Whether the numbers in an expression are of the kind: itself where it has no variables."""
    if kind == "exact":
        return not value.has(sp.Float, sp.CRootOf, sp.RootSum)
    if value.has(sp.I) or any(not each.exp.is_Integer and each.base.is_number for each in value.atoms(sp.Pow)):
        return False  # a root, or a complex number
    bound = 1 if kind == "integers" else LARGEST_DENOMINATOR
    numbers = value.atoms(sp.Number, sp.NumberSymbol)
    return all(isinstance(each, sp.Rational) and each.q <= bound for each in numbers)


def may_be_nice(values: Array, kind: str) -> Array:
    """Return where complex numbers lie near to one that is nice; what is not finite may be nice."""
    with np.errstate(all="ignore"):
        near = NEAR * (1 + np.abs(values))
        found = np.zeros(values.shape, dtype=bool)
        for denominator in range(1, 2 if kind == "integers" else LARGEST_DENOMINATOR + 1):
            times = values.real * denominator
            found |= np.abs(times - np.round(times)) <= near * denominator
        return ~np.isfinite(values) | (found & (np.abs(values.imag) <= near))
