"""Modules that are imported at their first use.

`solve --help`, `solve tasks` and `solve schema` read the declarations of all tasks but compute nothing, so a task
file must be importable without sympy. It says `from solver.lazy import exact, sympy as sp` and uses the names as
it would use the modules.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any


class LazyModule:
    """Stands for a module; the first attribute asked for imports it."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, attribute: str) -> Any:
        value = getattr(import_module(self._name), attribute)
        setattr(self, attribute, value)  # so that the next look-up is an ordinary one
        return value


if TYPE_CHECKING:
    import sympy

    from solver import exact, numeric, systems
else:
    sympy = LazyModule("sympy")
    exact = LazyModule("solver.exact")
    numeric = LazyModule("solver.numeric")
    systems = LazyModule("solver.systems")

__all__ = ["exact", "numeric", "sympy", "systems"]
