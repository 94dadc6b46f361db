"""Modules that are imported at their first use.

`solve --help`, `solve tasks` and `solve schema` read the declarations of all tasks but compute nothing, so a task
file must be importable without sympy. It says `from solver.lazy import exact, sympy as sp` and uses the names as
it would use the modules.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.startup import LazyModule

if TYPE_CHECKING:
    import sympy

    from solver import exact, numeric, systems
else:
    sympy = LazyModule("sympy")
    exact = LazyModule("solver.exact")
    numeric = LazyModule("solver.numeric")
    systems = LazyModule("solver.systems")

__all__ = ["exact", "numeric", "sympy", "systems"]
