"""Own values that would make trivial what follows from them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sp

NOTHING = sp.Rational(1, 1000)
"""A value that is smaller beside ours changes almost nothing."""


def trivial(own: Any, ours: Any) -> bool:
    """Whether an own value trivialises what follows: zeros that ours has not, almost nothing, a word, another shape."""
    if isinstance(own, bool | str):
        return True
    if isinstance(own, sp.MatrixBase):
        if not isinstance(ours, sp.MatrixBase) or own.shape != ours.shape or _is_nothing(own.flat(), ours.flat()):
            return True
        identity = own.is_square and own == sp.eye(own.rows) and ours != own
        return _zero_rows(own) > _zero_rows(ours) or identity
    if isinstance(own, list | tuple):
        if len(own) != len(ours):
            return True
        return any(map(trivial, own, ours)) if own and isinstance(own[0], sp.MatrixBase) else _is_nothing(own, ours)
    return not isinstance(own, sp.Expr) or _is_nothing([own], [ours])


def _zero_rows(M: Any) -> int:
    return sum(bool(M.row(i).is_zero_matrix) for i in range(M.rows))


def _is_nothing(own: Iterable[Any], ours: Iterable[Any]) -> bool:
    """Whether all is zero while ours is not, or numbers so small beside ours that they could as well be."""
    own, ours = list(own), list(ours)
    if all(entry == 0 for entry in own):
        return any(entry != 0 for entry in ours)
    if any(getattr(entry, "free_symbols", None) for entry in (*own, *ours)):
        return False
    largest, usual = (max((abs(sp.N(entry)) for entry in entries), default=0) for entries in (own, ours))
    return bool(largest < NOTHING * usual)
