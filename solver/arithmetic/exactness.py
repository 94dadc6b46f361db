"""Arithmetic explains a solution and must not cost it: where its numbers have no exact form, nothing is worked out."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import ParamSpec

from solver.derivation import Step
from solver.lazy import exact

P = ParamSpec("P")


def where_exact(substeps: Callable[P, tuple[Step, ...]]) -> Callable[P, tuple[Step, ...]]:
    """Return no substeps in place of raising NotExact."""

    @wraps(substeps)
    def found(*args: P.args, **kwargs: P.kwargs) -> tuple[Step, ...]:
        try:
            return substeps(*args, **kwargs)
        except exact.NotExact:
            return ()

    return found
