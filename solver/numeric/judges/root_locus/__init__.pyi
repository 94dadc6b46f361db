"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.root_locus.loci import (
    Locus,
    asymptote_angles_residual,
    centroid_residual,
    locus_of,
    number,
    segments_residual,
)
from solver.numeric.judges.root_locus.places import (
    boundary_points,
    breakaway_residual,
    crossings_residual,
    directions_residual,
    meeting_points,
)

__all__ = [
    "Locus",
    "asymptote_angles_residual",
    "boundary_points",
    "breakaway_residual",
    "centroid_residual",
    "crossings_residual",
    "directions_residual",
    "locus_of",
    "meeting_points",
    "number",
    "segments_residual",
]
