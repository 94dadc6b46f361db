"""Arithmetic explains a solution and must not cost it: it is worked out where it is shown, and where it can be."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import ParamSpec

from solver.derivation import Step
from solver.derivation.levels import carries_out, carrying_out
from solver.lazy import exact

P = ParamSpec("P")


def where_exact(substeps: Callable[P, tuple[Step, ...]]) -> Callable[P, tuple[Step, ...]]:
    """Return no substeps where none are carried out, and where the numbers have no exact form."""

    @wraps(substeps)
    def found(*args: P.args, **kwargs: P.kwargs) -> tuple[Step, ...]:
        if not carries_out():
            return ()
        try:
            return substeps(*args, **kwargs)
        except exact.NotExact:
            return ()

    return found


def at_full(substeps: Callable[P, tuple[Step, ...]], /, *args: P.args, **kwargs: P.kwargs) -> tuple[Step, ...]:
    """Return substeps that are shown at the level `full` already."""
    with carrying_out(True):
        found = substeps(*args, **kwargs)
    for step in found:
        step.detail = "full"
    return found
