"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.stability.location import (
    externally_stable,
    locations,
    routh_fault,
    spread_points,
)
from solver.numeric.judges.stability.planar import kinds_and_exceptions
from solver.numeric.judges.stability.regions import StablePart, counterexample, is_admissible

__all__ = [
    "StablePart",
    "counterexample",
    "externally_stable",
    "is_admissible",
    "kinds_and_exceptions",
    "locations",
    "routh_fault",
    "spread_points",
]
