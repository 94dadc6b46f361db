"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.stability.location import (
    externally_stable,
    locations,
    planar_kinds,
    routh_fault,
    spread_points,
)
from solver.numeric.judges.stability.regions import StablePart, counterexample

__all__ = [
    "StablePart",
    "counterexample",
    "externally_stable",
    "locations",
    "planar_kinds",
    "routh_fault",
    "spread_points",
]
